//! Plates of layers, and the materials of a layer.

use super::{PLATE_ORDER, PlateSection, PlateTangent, SHEAR_FACTOR};
use crate::material::multiaxial::plain_methods::{inner_methods, plain_methods};
use crate::material::{
    CHARACTERISTIC_LENGTH, LAYER, Material, Multiaxial, MultiaxialResult, PLANE, SharedMultiaxial, Slot, Strain,
    Tangent,
};
use crate::parameter::NewValue;
use crate::probe::Probe;
use std::ops::Range;
use std::sync::Arc;

/// Bars in one direction, smeared over a layer.
#[derive(Clone, Debug)]
pub struct PlateRebar {
    bar: Slot,
    /// Derivatives of the strain of the bars by the strains of the layer.
    direction: [f64; LAYER],
}

impl PlateRebar {
    /// Bars of a material with its tag, at an angle to axis 1 in degrees.
    pub fn new(material: Material, tag: i32, degrees: f64) -> Self {
        let (s, c) = match degrees {
            0.0 => (0.0, 1.0),
            90.0 => (1.0, 0.0),
            _ => degrees.to_radians().sin_cos(),
        };
        Self { bar: Slot::new(material, tag, 0), direction: [c * c, s * s, c * s, 0.0, 0.0] }
    }

    fn tangent(&self, slope: f64) -> Tangent<LAYER> {
        self.direction.map(|a| self.direction.map(|b| slope * a * b))
    }
}

crate::watches_columns!(PlateRebar => |s| in [&s.bar]);

#[deny(clippy::missing_trait_methods)]
impl Multiaxial<LAYER> for PlateRebar {
    plain_methods! { LAYER: is_symmetric reinforcement shown_stress }
    fn state_len(&self) -> usize {
        self.bar.len()
    }
    fn init(&self, state: &mut [f64]) {
        self.bar.init(state);
    }
    fn is_linear(&self) -> bool {
        self.bar.material.is_linear()
    }
    fn depends_on_time(&self) -> bool {
        self.bar.material.depends_on_time()
    }
    fn density(&self) -> f64 {
        0.0
    }
    fn of_length(&self, length: f64) -> Option<SharedMultiaxial<LAYER>> {
        let mut new = self.clone();
        new.bar.set_parameter(&[CHARACTERISTIC_LENGTH], NewValue::Is(length)).ok()?;
        Some(Arc::new(new))
    }
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        self.bar.probe(words)
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        self.bar.read(path, state, out);
    }

    fn update(&self, committed: &[f64], e: &[f64; LAYER], dt: f64, next: &mut [f64]) -> MultiaxialResult<LAYER> {
        let value = self.direction.iter().zip(e).map(|(a, e)| a * e).sum();
        let stress = self.bar.update(committed, Strain { value, rate: 0.0, dt }, next)?;
        Ok((self.direction.map(|a| a * stress.value), self.tangent(stress.tangent)))
    }

    fn initial_tangent(&self) -> Tangent<LAYER> {
        self.tangent(self.bar.material.initial_tangent())
    }
}

/// A membrane with an elastic shear rigidity across the plate.
#[derive(Clone, Debug)]
pub struct PlateFromPlaneStress {
    /// Material of the membrane.
    pub membrane: SharedMultiaxial<PLANE>,
    /// Shear modulus across the plate.
    pub shear: f64,
}

impl PlateFromPlaneStress {
    fn with_shear(&self, membrane: &Tangent<PLANE>) -> Tangent<LAYER> {
        let mut tangent = [[0.0; LAYER]; LAYER];
        tangent.iter_mut().zip(membrane).for_each(|(out, row)| out[..PLANE].copy_from_slice(row));
        (tangent[3][3], tangent[4][4]) = (self.shear, self.shear);
        tangent
    }
}

crate::watches_columns!(PlateFromPlaneStress => |s| in [&s.membrane]);

#[deny(clippy::missing_trait_methods)]
impl Multiaxial<LAYER> for PlateFromPlaneStress {
    inner_methods! { membrane: storage is_linear is_symmetric properties responses }
    fn shown_stress(&self, next: &[f64], [s11, s22, s12, s23, s31]: [f64; LAYER]) -> [f64; LAYER] {
        let [s11, s22, s12] = self.membrane.shown_stress(next, [s11, s22, s12]);
        [s11, s22, s12, s23, s31]
    }
    fn of_length(&self, length: f64) -> Option<SharedMultiaxial<LAYER>> {
        Some(Arc::new(Self { membrane: self.membrane.of_length(length)?, shear: self.shear }))
    }

    fn update(&self, committed: &[f64], e: &[f64; LAYER], dt: f64, next: &mut [f64]) -> MultiaxialResult<LAYER> {
        let ([s11, s22, s12], tangent) = self.membrane.update(committed, &[e[0], e[1], e[2]], dt, next)?;
        Ok(([s11, s22, s12, self.shear * e[3], self.shear * e[4]], self.with_shear(&tangent)))
    }

    fn initial_tangent(&self) -> Tangent<LAYER> {
        self.with_shear(&self.membrane.initial_tangent())
    }
}

/// A layer, or a point of integration across the thickness.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Material.
    pub material: SharedMultiaxial<LAYER>,
    /// Height of its centre above the middle of the plate.
    pub z: f64,
    /// Thickness.
    pub thickness: f64,
}

/// A plate of layers in plane stress, each with the strain of its centre.
#[derive(Clone, Debug)]
pub struct LayeredPlate {
    layers: Vec<Layer>,
    /// Square root of the shear factor.
    root: f64,
}

impl LayeredPlate {
    /// Layers from the bottom up by material and thickness. Shear stresses across the plate are uniform.
    pub fn stacked(layers: impl IntoIterator<Item = (SharedMultiaxial<LAYER>, f64)>) -> Self {
        let mut top = 0.0;
        let mut layers: Vec<Layer> = layers
            .into_iter()
            .map(|(material, thickness)| {
                top += thickness;
                Layer { material, z: top - 0.5 * thickness, thickness }
            })
            .collect();
        layers.iter_mut().for_each(|l| l.z -= 0.5 * top);
        Self { layers, root: 1.0 }
    }

    /// One material with five points of Lobatto or of Gauss across the thickness.
    pub fn uniform(material: &SharedMultiaxial<LAYER>, thickness: f64, gauss: bool) -> Self {
        // Abscissae and weights of rules of five points (Abramowitz and Stegun, 1964, tables 25.4 and 25.6).
        let ([x1, x2], [w0, w1, w2]) = if gauss {
            (
                [0.538_469_310_105_683, 0.906_179_845_938_664],
                [0.568_888_888_888_889, 0.478_628_670_499_366, 0.236_926_885_056_189],
            )
        } else {
            ([(3.0f64 / 7.0).sqrt(), 1.0], [32.0 / 45.0, 49.0 / 90.0, 0.1])
        };
        let half = 0.5 * thickness;
        let points = [(-x2, w2), (-x1, w1), (0.0, w0), (x1, w1), (x2, w2)];
        let layers =
            points.map(|(x, w)| Layer { material: Arc::clone(material), z: half * x, thickness: half * w }).to_vec();
        Self { layers, root: SHEAR_FACTOR.sqrt() }
    }

    /// Strains 11, 22, 12, 23, 31 of a layer.
    fn strain(&self, layer: &Layer, e: &[f64; PLATE_ORDER]) -> [f64; LAYER] {
        let (z, root) = (layer.z, self.root);
        [e[0] - z * e[3], e[1] - z * e[4], e[2] - z * e[5], root * e[7], root * e[6]]
    }

    /// Materials of the layers with the ranges of their states.
    fn placed(&self) -> impl Iterator<Item = (Range<usize>, &SharedMultiaxial<LAYER>)> {
        let mut end = 0;
        self.layers.iter().map(move |layer| {
            let start = end;
            end += layer.material.state_len();
            (start..end, &layer.material)
        })
    }

    /// Adds stresses and tangent of a layer to resultants and tangent.
    fn add(
        &self,
        layer: &Layer,
        (stress, tangent): &([f64; LAYER], Tangent<LAYER>),
        (s, k): &mut ([f64; PLATE_ORDER], PlateTangent),
    ) {
        let (z, t, root) = (layer.z, layer.thickness, self.root);
        // Shares of a stress in the resultants, and of a deformation in the strain: 31 is q1, 23 is q2.
        let shares = |i: usize| match i {
            0..3 => [(i, 1.0, 1.0), (i + 3, z, -z)],
            3 => [(7, root, root), (7, 0.0, 0.0)],
            _ => [(6, root, root), (6, 0.0, 0.0)],
        };
        for (i, (stress, row)) in stress.iter().zip(tangent).enumerate() {
            for (to, force, _) in shares(i) {
                s[to] += force * stress * t;
                for (j, slope) in row.iter().enumerate() {
                    for (by, _, strain) in shares(j) {
                        k[to][by] += force * strain * slope * t;
                    }
                }
            }
        }
    }
}

crate::watches_columns!(LayeredPlate => |s| at s.placed());

#[deny(clippy::missing_trait_methods)]
impl PlateSection for LayeredPlate {
    fn state_len(&self) -> usize {
        self.layers.iter().map(|l| l.material.state_len()).sum()
    }
    fn init(&self, state: &mut [f64]) {
        let mut rest = state;
        for layer in &self.layers {
            let (own, next) = rest.split_at_mut(layer.material.state_len());
            layer.material.init(own);
            rest = next;
        }
    }
    fn is_linear(&self) -> bool {
        self.layers.iter().all(|l| l.material.is_linear())
    }
    fn is_symmetric(&self) -> bool {
        self.layers.iter().all(|l| l.material.is_symmetric())
    }
    fn depends_on_time(&self) -> bool {
        self.layers.iter().any(|l| l.material.depends_on_time())
    }
    fn mass(&self) -> f64 {
        self.layers.iter().map(|l| l.material.density() * l.thickness).sum()
    }

    fn update(
        &self,
        committed: &[f64],
        e: &[f64; PLATE_ORDER],
        dt: f64,
        next: &mut [f64],
    ) -> MultiaxialResult<PLATE_ORDER> {
        let mut sum = ([0.0; PLATE_ORDER], [[0.0; PLATE_ORDER]; PLATE_ORDER]);
        let mut at = 0;
        for layer in &self.layers {
            let strain = self.strain(layer, e);
            let own = at..at + layer.material.state_len();
            let answer = layer.material.update(&committed[own.clone()], &strain, dt, &mut next[own.clone()])?;
            self.add(layer, &answer, &mut sum);
            at = own.end;
        }
        Ok(sum)
    }

    fn layers(&self) -> usize {
        self.layers.len()
    }

    /// A step of no length leaves a law where it is, with its stress.
    fn layer(&self, layer: usize, state: &[f64], e: &[f64; PLATE_ORDER]) -> Option<[[f64; LAYER]; 2]> {
        let strain = self.strain(self.layers.get(layer)?, e);
        let (range, material) = self.placed().nth(layer)?;
        let mut next = state[range.clone()].to_vec();
        let (stress, _) = material.update(&state[range], &strain, 0.0, &mut next).ok()?;
        Some([strain, material.shown_stress(&next, stress)])
    }

    fn initial_stiffness(&self) -> PlateTangent {
        let mut sum = ([0.0; PLATE_ORDER], [[0.0; PLATE_ORDER]; PLATE_ORDER]);
        for layer in &self.layers {
            self.add(layer, &([0.0; LAYER], layer.material.initial_tangent()), &mut sum);
        }
        sum.1
    }
}
