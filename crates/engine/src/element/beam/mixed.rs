//! The mixed beam: `mixedBeamColumn`.

use super::basic::Basic;
use super::force_based::{ForceBased, internal_forces};
use super::member::{Formulation, Lacking, Member, Trace};
use super::per_section::PerSection;
use super::point::{Point, Stiffness, read_all};
use crate::element::{Class, ElementError, ElementInput, ElementResult, Histories};
use crate::numeric::{axpy, dot, invert, product};
use crate::section::MAX_ORDER;

/// Internal forces are in equilibrium with natural forces, as in a force-based beam. Section deformations are those of
/// a displacement-based beam in the mean, weighted by the internal forces (Alemdar and White, 2005; Denavit and
/// Hajjar, 2010), without geometric nonlinearity inside the beam.
///
/// With an integration exact for polynomials of degree 2 this is the force-based beam.
#[derive(Clone, Copy, Debug, Default)]
pub struct Mixed {
    /// The force-based beam of the natural forces. With its `compat` the element takes one iteration a call from the
    /// last trial state, as OpenSees does.
    pub natural: ForceBased,
}

/// Integral of the products of moments that are linear along the beam and curvatures of cubic deflections: natural
/// deformations for basic ones.
#[derive(Clone, Copy, Debug)]
struct Projection {
    /// For the two end rotations about one axis.
    bending: [[f64; 2]; 2],
}

impl Projection {
    fn new<const N: usize, const B: usize>(member: &Member<N, B>) -> Self {
        let mut bending = [[0.0; 2]; 2];
        for (x, w) in member.points.0.iter().zip(&member.points.1) {
            for (row, moment) in bending.iter_mut().zip([x - 1.0, *x]) {
                axpy(w * moment, &[6.0 * x - 4.0, 6.0 * x - 2.0], row);
            }
        }
        Self { bending }
    }

    fn transposed(self) -> Self {
        let [[a, b], [c, d]] = self.bending;
        Self { bending: [[a, c], [b, d]] }
    }

    /// The inverse, or the projection itself where it is singular.
    fn inverse(self) -> Self {
        let mut inverse = self;
        if invert(inverse.bending.as_flattened_mut(), 2) { inverse } else { self }
    }

    /// Product with a vector of the basic system.
    fn of<const B: usize>(&self, v: &[f64; B]) -> [f64; B] {
        let mut out = *v;
        for (from, to) in v[1..].chunks_exact(2).zip(out[1..].chunks_exact_mut(2)) {
            to.iter_mut().zip(&self.bending).for_each(|(to, row)| *to = dot(row, from));
        }
        out
    }

    /// Stiffness of the basic system from that of the natural one.
    fn of_stiffness<const B: usize>(&self, k: &[[f64; B]; B]) -> [[f64; B]; B] {
        let transposed = self.transposed();
        let half = k.map(|row| transposed.of(&row));
        let mut out = half;
        for j in 0..B {
            let column: [f64; B] = transposed.of(&std::array::from_fn(|i| half[i][j]));
            out.iter_mut().zip(column).for_each(|(row, x)| row[j] = x);
        }
        out
    }
}

/// Numbers after those of [`Trace`]: natural forces, and what is missing in the natural deformations.
const NATURAL: usize = 2;

impl Mixed {
    /// One iteration from the last trial state.
    fn iterate<const N: usize, const B: usize>(
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> ElementResult<Basic<B>> {
        let (own, length) = (member.own_words(), member.length());
        let projection = Projection::new(member);
        let singular = || ElementError("the sections of the beam have no stiffness".into());
        let last = Trace::<N, B>::read(&h.trial[own..]);
        let mut trace = Trace::<N, B> { v: *v, dv: std::array::from_fn(|i| v[i] - last.v[i]), disp: [0.0; N] };
        trace.disp.copy_from_slice(motion.disp);
        trace.write(&mut h.trial[own..]);
        let natural = own + Trace::<N, B>::LEN;
        let (mut q, mut missing) = ([0.0; B], [0.0; B]);
        q.copy_from_slice(&h.trial[natural..natural + B]);
        missing.copy_from_slice(&h.trial[natural + B..natural + NATURAL * B]);
        axpy(1.0, &projection.of(&trace.dv), &mut missing);
        let (mut f, mut gathered) = ([[0.0; B]; B], [0.0; B]);
        let mut points = PerSection::new();
        for (i, (section, x, weight)) in member.along().enumerate() {
            let internal = internal_forces(motion.load, i);
            let point = Point::<B, MAX_ORDER>::new(section, ((x, length), internal), h.trial, Stiffness::Current)?;
            point.add(weight, &point.e(), &mut f, &mut gathered);
            points.push(point);
        }
        if !invert(f.as_flattened_mut(), B) {
            return Err(singular());
        }
        axpy(1.0, &product(&f, &missing), &mut q);
        (f, gathered) = ([[0.0; B]; B], [0.0; B]);
        let e = (&points).into_iter().map(|point| point.deformations(&q)).collect();
        member.update_sections(h, &e, motion.dt)?;
        read_all(member, &mut points, h.trial, Stiffness::Current)?;
        for ((.., weight), point) in member.along().zip(&points) {
            point.add(weight, &point.deformations(&q), &mut f, &mut gathered);
        }
        if !invert(f.as_flattened_mut(), B) {
            return Err(singular());
        }
        let wanted = projection.of(v);
        missing = std::array::from_fn(|i| wanted[i] - gathered[i]);
        h.trial[natural..natural + B].copy_from_slice(&q);
        h.trial[natural + B..natural + NATURAL * B].copy_from_slice(&missing);
        axpy(1.0, &product(&f, &missing), &mut q);
        Ok(Basic { q: projection.transposed().of(&q), k: projection.of_stiffness(&f) })
    }
}

impl<const N: usize, const B: usize> Formulation<N, B> for Mixed {
    type Loads = ForceBased;
    const CLASS: [Class; 2] = [Class::new("MixedBeamColumn2d", 30766), Class::new("MixedBeamColumn3d", 30765)];
    const LACKING: Lacking = Lacking::Refused;
    const STATE_LEN: usize = Trace::<N, B>::LEN + NATURAL * B;

    fn continues_from_last_trial(&self) -> bool {
        self.natural.compat
    }

    fn respond(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> ElementResult<Basic<B>> {
        if Formulation::<N, B>::continues_from_last_trial(self) {
            return Self::iterate(member, v, motion, h);
        }
        let projection = Projection::new(member);
        let natural = self.natural.respond(member, &projection.of(v), motion, h)?;
        Ok(Basic { q: projection.transposed().of(&natural.q), k: projection.of_stiffness(&natural.k) })
    }

    fn initial_stiffness(member: &Member<N, B>) -> [[f64; B]; B] {
        Projection::new(member).of_stiffness(&ForceBased::initial_stiffness(member))
    }

    fn elastic_deformation(member: &Member<N, B>, q: &[f64; B], load: &[f64]) -> [f64; B] {
        let inverse = Projection::new(member).inverse();
        let natural = ForceBased::elastic_deformation(member, &inverse.transposed().of(q), load);
        inverse.of(&natural)
    }
}
