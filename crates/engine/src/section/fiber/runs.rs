//! Points of a fiber section in the order in which their laws are evaluated.

use super::Fiber;
use super::joined::MAX_WORDS;
use super::points::Points;
use crate::material::{
    Material, MaterialResult, ObservedColumns, Shift, Slot, Strain, Strains, Stresses, WatchesColumns,
};
use crate::numeric::lanes::BLOCK;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

/// Maximum number of points of a block; sizes a buffer on the stack.
pub(super) const MAX_BLOCK_LENGTH: usize = 128;
/// A block of no more points is not padded. Of three points on, the copies of a joined evaluation take as long as it saves.
pub(super) const FEW_POINTS: usize = 2;
/// Distance of fibers that is round-off of their coordinates, as a part of the largest one.
const SAME_PLACE: f64 = 1e-14;

#[derive(Clone, Debug)]
pub(super) struct PlacedFiber {
    pub(super) y: f64,
    pub(super) z: f64,
    pub(super) area: f64,
    /// Index of the point.
    pub(super) point: usize,
    /// Index of the run.
    pub(super) run: usize,
}

/// Consecutive points of the same material.
#[derive(Clone, Debug)]
pub(super) struct FiberRun {
    /// The material with the slot of a single fiber.
    pub(super) slot: Slot,
    /// Range of points.
    pub(super) points: Range<usize>,
    /// Index of the block.
    pub(super) block: usize,
}

/// Consecutive runs that are evaluated in one dynamic call: one run, or those of materials that only shift the strains of
/// one law, as initial stresses do.
#[derive(Clone, Debug)]
pub(super) struct RunBlock {
    pub(super) runs: Range<usize>,
    /// Range of points, with the padding.
    pub(super) points: Range<usize>,
    /// Offset of the laws' state variables.
    at: usize,
    /// The law of several runs, and the shift of the strain of each point. `None` of one run, and of runs that have no longer
    /// one law, since a parameter of one of them has changed.
    shared: Option<(Slot, Vec<f64>)>,
}

/// Points of a section with their runs.
#[derive(Debug, Default)]
pub(super) struct Placement {
    pub(super) placed: Vec<PlacedFiber>,
    pub(super) points: Points,
    pub(super) runs: Vec<FiberRun>,
    pub(super) blocks: Vec<RunBlock>,
}

/// Fibers of a material.
struct Group {
    material: Material,
    tag: i32,
    fibers: Vec<usize>,
}

fn address(material: &Material) -> *const () {
    Arc::as_ptr(material.law()).cast()
}

/// The law that a material shifts the strains of.
fn law_inside(material: &Material) -> Option<*const ()> {
    material.roles().shifted.map(|(inner, _)| address(&inner.material))
}

/// Fibers of each material in the order of their first fibers; materials around one law follow each other. Those of a
/// material are in the order of y, then z in a section that is bent about both axes.
fn groups(fibers: &[Fiber], biaxial: bool) -> Vec<Group> {
    let mut groups: Vec<Group> = vec![];
    let mut known = HashMap::new();
    for (i, f) in fibers.iter().enumerate() {
        let (material, tag) = &f.material;
        let group = *known.entry((*tag, address(material))).or_insert_with(|| {
            groups.push(Group { material: material.clone(), tag: *tag, fibers: vec![] });
            groups.len() - 1
        });
        groups[group].fibers.push(i);
    }
    let place = |i: usize| (fibers[i].y, if biaxial { fibers[i].z } else { 0.0 });
    for group in &mut groups {
        group.fibers.sort_by(|a, b| {
            let ((y, z), (other_y, other_z)) = (place(*a), place(*b));
            y.total_cmp(&other_y).then(z.total_cmp(&other_z))
        });
    }
    let mut first = HashMap::new();
    for (i, group) in groups.iter().enumerate() {
        law_inside(&group.material).into_iter().for_each(|law| _ = first.entry(law).or_insert(i));
    }
    let mut ordered: Vec<(usize, Group)> = groups.into_iter().enumerate().collect();
    ordered.sort_by_key(|(i, group)| law_inside(&group.material).map_or(*i, |law| first[&law]));
    ordered.into_iter().map(|(_, group)| group).collect()
}

impl Placement {
    /// Places fibers with coordinates from a centroid. Fibers of one material with the same strain share a point.
    pub(super) fn new(fibers: &[Fiber], centroid: (f64, f64), biaxial: bool) -> Self {
        let placed = fibers.iter().map(|f| PlacedFiber { y: f.y, z: f.z, area: f.area, point: 0, run: 0 });
        let mut all = Self { placed: placed.collect(), ..Self::default() };
        let mut law = None;
        for group in groups(fibers, biaxial) {
            let inside = law_inside(&group.material);
            let joins = inside.is_some() && inside == law;
            law = inside;
            let mut last: Option<&Fiber> = None;
            let largest = group.fibers.iter().map(|i| fibers[*i].y.abs().max(fibers[*i].z.abs())).fold(0.0, f64::max);
            for i in group.fibers {
                let f = &fibers[i];
                let near = |a: f64, b: f64| (a - b).abs() <= SAME_PLACE * largest;
                if last.is_some_and(|l| near(l.y, f.y) && (!biaxial || near(l.z, f.z))) {
                    all.points.enlarge(f.area);
                } else {
                    let same_run = last.is_some();
                    last = Some(f);
                    all.make_room(&group.material, group.tag, same_run, same_run || joins);
                    all.push([-(f.y - centroid.0), f.z - centroid.1], f.area);
                }
                (all.placed[i].point, all.placed[i].run) = (all.points.len() - 1, all.runs.len() - 1);
            }
        }
        all.close();
        all
    }

    /// Sees to it that the last run and the last block are those of the next point: the ones there are, where it may join
    /// them, or new ones.
    fn make_room(&mut self, material: &Material, tag: i32, same_run: bool, same_block: bool) {
        let room = self.blocks.last().is_some_and(|b| b.points.len() < MAX_BLOCK_LENGTH);
        if !(same_block && room) {
            self.close();
            let (run, point) = (self.runs.len(), self.points.len());
            let at = self.blocks.last().map_or(0, |b| b.words(&self.runs).end);
            self.blocks.push(RunBlock { runs: run..run, points: point..point, at, shared: None });
        }
        if !(same_run && room) {
            let (block, point) = (self.blocks.len() - 1, self.points.len());
            self.runs.push(FiberRun { slot: Slot::new(material.clone(), tag, 0), points: point..point, block });
        }
    }

    fn push(&mut self, gradient: [f64; 2], area: f64) {
        let end = self.points.push(gradient, area);
        if let (Some(run), Some(block)) = (self.runs.last_mut(), self.blocks.last_mut()) {
            (run.points.end, block.points.end) = (end, end);
        }
        if let Some(block) = self.blocks.last_mut() {
            block.runs.end = self.runs.len();
        }
    }

    /// Ends the last block: the padding of a law that is evaluated in blocks belongs to it. A few points are not worth it.
    fn close(&mut self) {
        let Some(block) = self.blocks.last_mut() else { return };
        if block.points.len() > FEW_POINTS {
            let lanes = self.runs[block.runs.start].slot.material.block_len().min(BLOCK);
            block.points.end = self.points.pad(block.points.len(), lanes);
        }
        block.renew(&self.runs);
    }
}

impl RunBlock {
    /// Range of the laws' state variables.
    pub(super) fn words(&self, runs: &[FiberRun]) -> Range<usize> {
        self.at..self.at + self.points.len() * runs[self.runs.start].slot.material.state_len()
    }

    /// Returns true for points that leave most of a vector empty: they are worth being evaluated with those of other places.
    pub(super) fn is_few(&self, runs: &[FiberRun]) -> bool {
        let material = &runs[self.runs.start].slot.material;
        self.runs.len() == 1
            && self.points.len() <= FEW_POINTS
            && material.block_len() > 1
            && material.state_len() <= MAX_WORDS
    }

    /// Materials of the points; those of the padding are the last one.
    fn materials<'a>(&'a self, runs: &'a [FiberRun]) -> impl Iterator<Item = &'a Material> {
        let own = &runs[self.runs.clone()];
        let padding = self.points.end - own.last().map_or(self.points.end, |r| r.points.end);
        let counts = own.iter().map(|r| r.points.len()).enumerate();
        counts.flat_map(move |(i, n)| {
            let n = if i + 1 == own.len() { n + padding } else { n };
            std::iter::repeat_n(&own[i].slot.material, n)
        })
    }

    /// Takes over the law and the shifts of the materials.
    pub(super) fn renew(&mut self, runs: &[FiberRun]) {
        self.shared = None;
        if self.runs.len() > 1
            && let Some(shifted) = self.materials(runs).map(|m| m.roles().shifted).collect::<Option<Vec<_>>>()
        {
            let law = address(&shifted[0].0.material);
            let is_one = shifted.iter().all(|(inner, _)| address(&inner.material) == law);
            let shifts = shifted.iter().map(|(_, shift)| *shift).collect();
            self.shared = is_one.then(|| (shifted[0].0.clone(), shifts));
        }
    }

    /// Writes the virgin histories.
    pub(super) fn init(&self, runs: &[FiberRun], words: &mut [f64]) {
        let (n, first) = (self.points.len(), &runs[self.runs.start].slot.material);
        if self.runs.len() == 1 {
            return first.init_all(n, words);
        }
        let mut one = vec![0.0; first.state_len()];
        for (i, material) in self.materials(runs).enumerate() {
            material.init(&mut one);
            material.copy_history((&one, 0, 1), (&mut *words, i, n));
        }
    }

    /// Shows the laws their columns.
    pub(super) fn observe(&self, runs: &[FiberRun], words: &mut [f64], columns: &ObservedColumns<'_>) {
        let (n, own) = (self.points.len(), &runs[self.runs.clone()]);
        if own.iter().all(|run| run.slot.material.limit_curves().is_empty()) {
            return;
        }
        let mut one = vec![0.0; own[0].slot.material.state_len()];
        for (i, material) in self.materials(runs).enumerate() {
            material.copy_history((&*words, i, n), (&mut one, 0, 1));
            material.observe(&mut one, columns);
            material.copy_history((&one, 0, 1), (&mut *words, i, n));
        }
    }

    /// Stresses and tangents of the points.
    ///
    /// # Errors
    /// A law has no response at one of the strains.
    #[inline]
    pub(super) fn update(
        &self,
        runs: &[FiberRun],
        committed: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        let material = &runs[self.runs.start].slot.material;
        if self.runs.len() == 1 {
            return material.update_all(committed, strains, next, stresses);
        }
        match &self.shared {
            Some((law, shifts)) => law.update_all(committed, &Shift::Each(shifts), strains, next, stresses),
            None => self.update_apart(runs, committed, strains, next, stresses),
        }
    }

    /// The same, point by point.
    #[cold]
    fn update_apart(
        &self,
        runs: &[FiberRun],
        committed: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        let n = self.points.len();
        for (i, material) in self.materials(runs).enumerate() {
            let (mut old, mut new) = (vec![0.0; material.state_len()], vec![0.0; material.state_len()]);
            material.copy_history((committed, i, n), (&mut old, 0, 1));
            let strain = Strain { value: strains.value[i], rate: strains.rate[i], dt: strains.dt };
            let s = material.update(&old, strain, &mut new)?;
            material.copy_history((&new, 0, 1), (&mut *next, i, n));
            (stresses.value[i], stresses.tangent[i], stresses.damping[i]) = (s.value, s.tangent, s.damping);
        }
        Ok(())
    }
}
