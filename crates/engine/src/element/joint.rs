//! Joint of beams and columns in the plane: `Joint2D`.

use super::springs::Springs;
use super::{
    Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, OpenSeesTraits, Snapshot,
};
use crate::element::roles::Roles;
use crate::material::{Material, Slot};
use crate::probe::Probe;
use nalgebra::Matrix3;

const DOFS: usize = 16;
/// Springs of the four nodes and of the panel.
const SPRINGS: usize = 5;
/// Degrees of freedom of the rotations that each spring joins: the first less the second is its deformation. The centre
/// has the rotations 14 and 15 of the panel's two pairs of edges.
const ROTATIONS: [(usize, usize); SPRINGS] = [(2, 15), (5, 14), (8, 15), (11, 14), (15, 14)];

/// A joint of four nodes at the middles of the edges of a rigid-edged shear panel, around a centre with two
/// displacements and two rotations (Altoontash and Deierlein, 2003). Constraints of the model move the four nodes with
/// the centre; this element has the rotational springs at the nodes and the spring of the panel.
#[derive(Clone, Debug)]
pub struct Joint {
    springs: Springs,
    /// Place of each spring among `springs`; a node without a spring is rigid.
    places: [Option<usize>; SPRINGS],
    /// From node 1 to node 3, and from 2 to 4.
    across: [[f64; 2]; 2],
}

impl Joint {
    /// Makes a joint of the springs of its four nodes, `None` at a rigid node, and of the panel. `across` has
    /// the vectors from the first node to the third and from the second to the fourth.
    pub fn new(springs: [Option<(Material, i32)>; SPRINGS], across: [[f64; 2]; 2]) -> Self {
        let mut made = Self { springs: Springs::new(Matrix3::identity()), places: [None; SPRINGS], across };
        let mut count = 0;
        for ((spring, place), (first, second)) in springs.into_iter().zip(&mut made.places).zip(ROTATIONS) {
            let Some(material) = spring else { continue };
            let mut row = vec![0.0; DOFS];
            (row[first], row[second]) = (1.0, -1.0);
            made.springs.add(material, 6, (row, 0.0), None);
            *place = Some(count);
            count += 1;
        }
        made
    }
}

crate::watches_columns!(Joint => |s| in s.springs.slots());

impl Element for Joint {
    fn class(&self) -> Class {
        Class::new("Joint2D", 82)
    }
    fn dofs(&self) -> usize {
        DOFS
    }
    fn state_len(&self) -> usize {
        self.springs.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        self.springs.init(state);
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits { rayleigh: false, ..self.springs.traits() }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, mut out: ElementOutput<'_>) -> ElementResult {
        self.springs.respond(motion, h, &mut out)
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.springs.initial_tangent(tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles { opensees: OpenSeesTraits { initial_is_current: true, ..OpenSeesTraits::default() }, ..Roles::default() }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let numbered = |stem: &str| (1..=SPRINGS).map(|i| format!("{stem}{i}")).collect::<Vec<_>>();
        Some(match words {
            ["node" | "internalNode", ..] => Probe::new(CENTRE, ["u", "v", "theta", "panel"]),
            ["size" | "jointSize", ..] => Probe::new(SIZE, ["d1", "d2"]),
            ["moment" | "-moment" | "force" | "-force", ..] => Probe::new(MOMENT, numbered("M")),
            ["defo" | "deformation" | "deformations", ..] => Probe::new(DEFORMATION, numbered("theta")),
            ["defoANDforce" | "deformationANDforce" | "deformationsANDforces", ..] => {
                Probe::new(BOTH, numbered("theta").into_iter().chain(numbered("M")))
            }
            ["plasticRotation" | "plasticDeformation", ..] => Probe::new(PLASTIC, numbered("thetap")),
            ["spring" | "-spring" | "material" | "-material", i, rest @ ..] => {
                let place = (*self.places.get(i.parse::<usize>().ok()?.checked_sub(1)?)?)?;
                let number = (place + 1).to_string();
                let words: Vec<&str> = ["material", &number].into_iter().chain(rest.iter().copied()).collect();
                return Some(self.springs.probe(&words, "M", "theta")?.inside(&[SPRING]));
            }
            _ => return None,
        })
    }

    fn probe_names(&self) -> Vec<&'static str> {
        vec!["moment", "deformation", "deformationANDforce", "plasticRotation", "node", "size", "spring"]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let of = |value: &dyn Fn(&Slot) -> f64, out: &mut [f64]| {
            for (place, out) in self.places.iter().zip(out) {
                *out = place.map_or(0.0, |k| value(self.springs.slot(k)));
            }
        };
        let strain = |slot: &Slot| slot.shown_strain(s.state);
        let stress = |slot: &Slot| slot.stress(s.state);
        match path[0] {
            CENTRE => out.copy_from_slice(&s.disp[12..]),
            SIZE => {
                for (((from, to), vector), out) in [(0, 6), (3, 9)].into_iter().zip(self.across).zip(out) {
                    *out = (vector[0] + s.disp[to] - s.disp[from]).hypot(vector[1] + s.disp[to + 1] - s.disp[from + 1]);
                }
            }
            MOMENT => of(&stress, out),
            DEFORMATION => of(&strain, out),
            BOTH => {
                let (first, second) = out.split_at_mut(SPRINGS);
                of(&strain, first);
                of(&stress, second);
            }
            PLASTIC => {
                let plastic = |slot: &Slot| match slot.material.initial_tangent() {
                    0.0 => 0.0,
                    k => strain(slot) - stress(slot) / k,
                };
                of(&plastic, out);
            }
            _ => self.springs.read(&path[1..], s, Slot::shown_strain, out),
        }
    }
}

const CENTRE: u32 = 2;
const SIZE: u32 = 3;
const MOMENT: u32 = 4;
const DEFORMATION: u32 = 5;
const BOTH: u32 = 6;
const PLASTIC: u32 = 7;
const SPRING: u32 = 8;
