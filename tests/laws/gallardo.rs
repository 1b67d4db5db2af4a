//! The shear law of Gallardo et al. (2023): its authors' published example, and what the law is for.

use super::driver::MaterialPoint;
use hysteron::material::{Decay, GallardoShear, Material};

/// Parameters of the published example, tonf and cm.
fn published() -> GallardoShear {
    GallardoShear {
        a: [46.466_957_443_958_74, 59.237_681_514_834_78, 316.895_867_169_438_1],
        softening: [
            Decay { factor: 1.044_628_539_966_660_4, power: 0.380_226_092_884_859_5 },
            Decay { factor: 30.496_706_205_285_425, power: 0.713_087_242_033_225_4 },
            Decay { factor: 3.432_906_366_152_742_4, power: 0.368_258_703_365_696_94 },
        ],
        cycling: Decay { factor: 0.060_110_009_890_125_92, power: 0.566_633_188_083_617 },
        ky: 120.678_872_615_566_35,
        fy: 1.812_399_125_434_320_4,
        beta: 0.9,
        eta: 0.32,
        phi_max: 0.135_540_480_946_633_26,
        phi_rate: 0.017_991_226_534_570_93,
        height: 20.4,
    }
}

/// Steps in which the authors' iteration does not end, and how long the loop takes to forget them.
const UNSOLVED: [usize; 3] = [8866, 15373, 16771];
const FORGOTTEN: usize = 130;

/// The example turns the displacement of a node into the deformation of a vertical link: with the other sign.
#[test]
fn gallardo_published_example() {
    let packed = include_bytes!("../../validation/identification/gallardo/published.csv.gz");
    // The header of a gzip file without a name has ten bytes.
    let text = String::from_utf8(miniz_oxide::inflate::decompress_to_vec(&packed[10..]).unwrap()).unwrap();
    let number = |word: &str| word.parse::<f64>().unwrap();
    let (displacement, force): (Vec<_>, Vec<_>) =
        text.lines().skip(1).map(|l| l.split_once(',').unwrap()).map(|(u, f)| (number(u), number(f))).unzip();
    let peak = force.iter().fold(0.0, |most: f64, f| most.max(f.abs()));
    let mut law = MaterialPoint::new(Material::new(published()));
    let (mut most, mut squares, mut compared) = (0.0f64, 0.0, 0);
    for (i, (u, f)) in displacement.iter().zip(&force).enumerate() {
        let difference = (-law.advance(-u).value - f).abs() / peak;
        if UNSOLVED.iter().all(|step| !(*step..step + FORGOTTEN).contains(&i)) {
            (most, squares, compared) = (most.max(difference), squares + difference * difference, compared + 1);
        }
    }
    let mean = (squares / f64::from(compared)).sqrt();
    assert_eq!((force.len(), compared), (26_047, 25_657));
    // Six printed digits are 1.8e-6 of the peak, and the authors' z has an error of some 1e-6.
    assert!(most < 6e-6 && mean < 1e-6, "{most:.2e} {mean:.2e}");
}

/// Secant stiffness of cycles of equal amplitude: it falls by cycles, and below that of a larger strain before.
#[test]
fn gallardo_softens_by_cycles_and_by_the_largest_strain() {
    let cycle = |law: &mut MaterialPoint, amplitude: f64| {
        let at = |k: i32| amplitude * (f64::from(k) * std::f64::consts::TAU / 400.0).sin();
        let forces: Vec<f64> = (1..=400).map(|k| law.advance(at(k)).value).collect();
        (forces[99] - forces[299]) / (2.0 * amplitude)
    };
    let mut law = MaterialPoint::new(Material::new(published()));
    let small: Vec<f64> = (0..4).map(|_| cycle(&mut law, 5.0)).collect();
    assert!(small.windows(2).all(|w| w[1] < w[0]), "{small:?}");
    let large = cycle(&mut law, 20.0);
    let again = cycle(&mut law, 5.0);
    assert!(again < 0.9 * small[3] && large < small[3], "{small:?} {large} {again}");
}

/// A path of many reversals loses energy.
#[test]
fn gallardo_dissipates() {
    let mut law = MaterialPoint::new(Material::new(published()));
    let (mut work, mut before) = (0.0, (0.0, 0.0));
    for k in 1..=2000 {
        let u = 15.0 * (f64::from(k) * 0.037).sin() * (f64::from(k) * 0.0071).cos();
        let f = law.advance(u).value;
        work += 0.5 * (f + before.1) * (u - before.0);
        before = (u, f);
    }
    assert!(work > 0.0);
}
