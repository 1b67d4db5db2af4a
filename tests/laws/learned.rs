//! Learned laws: energy, words and files, ranges, and what a solver makes of them.

use super::driver::path;
use super::script::{Script, run};
use hysteron::element::amendment::learned::{LawOption, LearnedLaw, OPTIONS};
use hysteron::opensees::{commands, law_of_json, law_to_json, law_to_words};

/// The law of words after `amend element $tag learned`.
pub(super) fn law(words: &str) -> Result<LearnedLaw, String> {
    let mut options: Vec<LawOption> = vec![];
    for w in words.split_whitespace() {
        let is_option = w.starts_with('-') && w.parse::<f64>().is_err();
        match options.last_mut().filter(|_| !is_option) {
            Some(o) => o.words.push(w.into()),
            None => options.push(LawOption { name: w.into(), words: vec![] }),
        }
    }
    LearnedLaw::of_options(&options).map_err(|e| e.message)
}

/// Friction that ages at rest, beside a spring, stops, a Maxwell element and dashpots.
pub(super) const AGING: &str = "-range 0.1 0.5 40 -work 0.05 -hysteresis boucWen 0.004 20 -spring 300 -unequal -4 \
    -stop 0.01 6 -stop 0.05 3 -maxwell 0.3 100 -dashpot 0.5 4 -viscous 0.1 2 -piece 0 0.06 200 -piece 1 0.02 -50 \
    -factor strength rest 0.01 0.4 0.5 0 2 -factor strength rate 0.03 -0.3 0 1 -factor strength pinching 0.3 -0.4 0 1";
/// Softening by deformation, work, heat and time.
pub(super) const SOFTENING: &str = "-range 0.1 0.5 40 -work 0.05 -hysteresis bilinear 0.004 20 -spring 300 \
    -factor elastic largest -0.4 0.001 1 -factor elastic virgin 2 0.3 0 1 -factor hysteretic workSaturating 0.3 -0.5 0 1 \
    -factor whole timeSaturating 10 -0.2 0 1 -factor elastic deformation 2 0.8 0 1 \
    -factor strength recentWorkSoftening 5 0.9 0.1 1 -maxwell 0.5 80 -factor viscous workSaturating 0.2 -0.6 0 1";
/// Slopes of hysteresis that are learned, and recovery from heat.
pub(super) const CURVE: &str = "-range 0.1 0.5 40 -work 0.05 -hysteresis curve 0.01 25 -curve 0.7 1.3 1 0.5 0.1 \
    -spring 200 -moving 60 -factor elastic pinching 0.35 -0.5 0 1 -factor hysteretic largestDecay 0.4 0.6 0 1 \
    -factor elastic recentWork 8 -0.1 0 1 -factor elastic side 0.2 -1 1";
/// A place of the stroke, the side last used, rest of a device that stands still, and a fluid with a resistance by position.
const STROKE: &str = "-range 0.1 0.5 40 -work 0.05 -hysteresis bilinear 0.004 20 -spring 300 -dashpot 1 8 \
    -viscous 0.1 2 -factor strength place -0.25 0.2 -0.5 0 1 -factor strength sideOver 4 0.4 -1 1 \
    -factor strength still 0.01 0.4 0.5 0 2 -factor viscous deformation 2 3 0 1 \
    -factor viscous rate 0.03 -0.4 0 1";

const LAWS: [&str; 4] = [AGING, SOFTENING, CURVE, STROKE];

/// Work done on a law along a closed path, and the sum of its absolute parts.
fn work(law: &LearnedLaw, u: &[f64]) -> (f64, f64) {
    let t: Vec<f64> = (0..u.len()).map(|i| 0.01 * i as f64).collect();
    let (f, _) = law.along(u, &t, &[], &[]);
    let parts = (1..u.len()).map(|i| 0.5 * (f[i] + f[i - 1]) * (u[i] - u[i - 1]));
    parts.fold((0.0, 0.0), |(sum, size), x| (sum + x, size + x.abs()))
}

/// On closed paths from rest to three times the range no law makes energy.
#[test]
fn closed_paths_make_no_energy() {
    for words in LAWS {
        let law = law(words).unwrap();
        for seed in 0..1000 {
            let mut u = path(seed, 300, 0.3 * [0.1, 0.3, 1.0][seed as usize % 3]);
            let last = *u.last().unwrap();
            u.extend((0..=50).map(|i| last * (1.0 - f64::from(i) / 50.0)));
            u.insert(0, 0.0);
            let (made, size) = work(&law, &u);
            assert!(made >= -1e-3 * size, "{words}, path {seed}: {made} of {size}");
        }
    }
}

/// A law that makes energy is refused, with the rule that it breaks.
#[test]
fn laws_that_make_energy_are_refused() {
    let base = "-range 0.1 0.5 40 -hysteresis bilinear 0.004 20 -spring 300";
    for (more, expected) in [
        ("-stop 0.01 -3", "a negative one makes energy"),
        ("-maxwell 0.1 -3", "a negative one makes energy"),
        ("-unequal -21", "strength of the positive side is negative"),
        ("-piece 0 0.05 -301", "tail of negative stiffness"),
        ("-factor hysteretic rate 0.03 0.2 0 1", "within a cycle acts on the strength alone"),
        ("-factor elastic rest 0.01 0.4 0.2 0 1", "within a cycle acts on the strength alone"),
        ("-factor elastic largest 0.2 0 1", "that rises makes energy"),
        ("-factor hysteretic work 0.2 0 1", "that rises makes energy"),
        ("-maxwell 0.3 50 -factor viscous work 0.2 0 1", "that rises makes energy"),
        ("-maxwell 0.3 50 -factor viscous deformation 2 0.2 0 1", "within a cycle acts on the strength alone"),
        ("-factor elastic place 0.5 0.3 0.4 0 1", "within a cycle acts on the strength alone"),
        ("-factor hysteretic sideOver 4 0.2 -1 1", "within a cycle acts on the strength alone"),
        ("-work 0.001 -factor elastic recentWork 1 -0.9 0 1", "recovery makes more energy"),
    ] {
        let message = law(&format!("{base} {more}")).unwrap_err();
        assert!(message.contains(expected), "{more}: {message}");
    }
    for curve in ["-curve 1 1 1 1.2 0", "-curve 1 1 0 0 0", "-curve 1 1 1 1", "-curve 1 1 1 -0.1 0"] {
        assert!(law(&format!("-range 1 1 1 -hysteresis curve 0.1 3 {curve}")).is_err(), "{curve}");
    }
    assert!(law(&format!("{base} -factor strength rate 0.03 2 0 1 -factor elastic largest -0.2 0 1")).is_ok());
    // The refused paths do make energy: a stiffness that rises with the largest deformation stores more than was put in.
    let mut unsafe_law = law(&format!("{base} -factor elastic largest -0.2 0 1")).unwrap();
    unsafe_law.factors[0].coefficient = 3.0;
    unsafe_law.strength = 0.0;
    let u: Vec<f64> = (0..=200).map(|i| 0.1 * (1.0 - (f64::from(i) / 100.0 - 1.0).abs())).collect();
    let (made, size) = work(&unsafe_law, &u);
    assert!(made < -1e-2 * size, "{made} {size}");
}

/// Words and files make the law again to the last bit.
#[test]
fn words_and_files_give_the_law() {
    let channels = "-range 0.1 0.5 40 -hysteresis own 0.004 1 -channel voltage 2 0.3 -channel axial 100 20 \
        -factor hysteretic channelLate voltage 0.4 0.7 -1 1 -force axial 3 -1 1 -beyond continue";
    for words in LAWS.into_iter().chain([channels]) {
        let made = law(words).unwrap();
        assert_eq!(law(&law_to_words(&made)).unwrap(), made);
        assert_eq!(law_of_json(&law_to_json(&made)).unwrap(), made);
    }
    assert!(law_of_json("[1]").is_err() && law_of_json("{\"range\": [1, 1]}").unwrap_err().contains("range"));
    // The usage has each option.
    let usage = commands().find(|c| c.name == "amend").map_or("", |c| c.usage);
    assert!(OPTIONS.iter().all(|(name, ..)| usage.contains(name)), "{usage}");
}

/// A portal frame on a learned spring, which is pushed to and fro.
fn frame(amplitude: f64, law: &str) -> String {
    format!(
        "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 4 0; node 3 0 3; node 4 4 3; node 5 4 3
        fix 1 1 1 1; fix 2 1 1 1; fix 5 1 1 1; mass 3 2. 2. 1e-3; mass 4 2. 2. 1e-3
        geomTransf Linear 1
        element elasticBeamColumn 1 1 3 0.02 2e5 1e-3 1; element elasticBeamColumn 2 2 4 0.02 2e5 1e-3 1
        element elasticBeamColumn 3 3 4 0.02 2e5 1e-3 1
        uniaxialMaterial Elastic 1 300.; element zeroLength 4 5 4 -mat 1 -dir 1
        amend element 4 learned {law}
        timeSeries Path 1 -dt 0.5 -values {{0 {amplitude} -{amplitude} {amplitude} 0 -{amplitude} {amplitude} 0 0 0}}
        pattern Plain 1 1 {{ load 3 1. 0. 0. }}
        constraints Plain; numberer RCM; system BandGeneral; test NormUnbalance 1e-8 20; algorithm Newton
        integrator Newmark 0.5 0.25; analysis Transient\n"
    )
}

/// At one and three times its range a step takes at most four iterations, and the share of steps outside is told.
#[test]
fn a_solver_needs_few_iterations() {
    for (amplitude, is_outside) in [(40.0, false), (180.0, true)] {
        for words in LAWS {
            let ran = run(&format!(
                "{}set n 0; set most 0; for {{set i 0}} {{$i < 400}} {{incr i}} {{ analyze 1 0.01; \
                 set n [expr {{$n + [testIter]}}]; set u [expr {{abs([nodeDisp 4 1])}}]; \
                 if {{$u > $most}} {{ set most $u }} }}; puts [expr {{$n / 400.0}}]; puts $most",
                frame(amplitude, words)
            ));
            let n = ran.numbers();
            assert!(n[0] <= 4.0, "{words}, {amplitude}: {} iterations", n[0]);
            let range = if is_outside { 0.1..0.4 } else { 0.02..0.1 };
            assert!(range.contains(&n[1]), "{words}, {amplitude}: {}", n[1]);
            let told = ran.warnings().iter().any(|w| w.message.contains("outside the range of its learned law"));
            assert_eq!(told, is_outside, "{words}, {amplitude}: {:?}", ran.warnings());
        }
    }
}

/// The law in an analysis gives the forces of the law along the same motion.
#[test]
fn an_analysis_follows_the_law() {
    let values: Vec<f64> = std::iter::once(0.0).chain(path(7, 199, 0.08)).collect();
    let list: Vec<String> = values.iter().map(f64::to_string).collect();
    for words in LAWS {
        let ran = run(&format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
            uniaxialMaterial Elastic 1 300.; element zeroLength 1 1 2 -mat 1 -dir 1; amend element 1 learned {words}
            timeSeries Path 1 -dt 0.01 -values {{{}}} -useLast; pattern Plain 1 1 {{ sp 2 1 1. }}
            constraints Transformation; numberer Plain; system FullGeneral; test NormUnbalance 1e-10 20
            algorithm Newton; integrator LoadControl 0.01; analysis Static
            for {{set i 0}} {{$i < 199}} {{incr i}} {{ analyze 1; puts [basicForce 1] }}",
            list.join(" ")
        ));
        let times: Vec<f64> = (0..200).map(|i| 0.01 * f64::from(i)).collect();
        let (expected, _) = law(words).unwrap().along(&values, &times, &[], &[]);
        for (i, (a, b)) in ran.numbers().iter().zip(&expected[1..]).enumerate() {
            assert!((a - b).abs() < 1e-6 * (1.0 + b.abs()), "{words}, step {i}: {a} {b}");
        }
    }
}

/// A channel is a series of time, or the compression of the element.
#[test]
fn channels_are_series_or_the_axial_force() {
    let law =
        "learned -range 0.1 1 10 -hysteresis bilinear 0.001 10 -channel V 1 1 -factor strength channel V 1.5 -1 1";
    let ran = run(&format!(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
        uniaxialMaterial Elastic 1 300.; element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Linear 7; amend element 1 {law} -series 7
        timeSeries Path 1 -dt 1 -values {{0 0.01 0.02 0.03 0.04}} -useLast; pattern Plain 1 1 {{ sp 2 1 1. }}
        constraints Transformation; numberer Plain; system FullGeneral; test NormUnbalance 1e-10 20
        algorithm Newton; integrator LoadControl 1.; analysis Static
        for {{set i 0}} {{$i < 4}} {{incr i}} {{ analyze 1; puts [basicForce 1] }}"
    ));
    // 1 + 1.5 (t - 1)/3, clamped at x = 1.
    let expected = [10.0, 15.0, 20.0, 25.0];
    assert!(ran.numbers().iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{:?}", ran.numbers());
    let missing = Script::default().run(&format!(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; uniaxialMaterial Elastic 1 300.
        element zeroLength 1 1 2 -mat 1 -dir 1; amend element 1 {law}"
    ));
    assert!(missing.error().message.contains("1 channels and 0 sources"), "{:?}", missing.error());
}

/// A file beside the script gives the same law as words.
#[test]
fn a_file_gives_the_law() {
    let pushed = |words: &str, file: &str| {
        let script = Script::default().with_file("law.json", file);
        let ran = script.run(&format!("{}analyze 30 0.01; puts [nodeDisp 4 1]", frame(60.0, words))).done();
        ran.numbers()[0]
    };
    assert_eq!(pushed("-file law.json", &law_to_json(&law(AGING).unwrap())), pushed(AGING, ""));
    let ran = Script::default().run(&frame(1.0, &format!("{AGING} -stop 0.1 -2")));
    assert!(ran.error().message.contains("-stop: expected a level"), "{:?}", ran.error());
}
