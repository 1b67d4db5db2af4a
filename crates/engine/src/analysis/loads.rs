//! Loads and imposed displacements at a time.

use super::ground_inertia::GroundInertia;
use crate::assembly::{DofMap, Imposed};
use crate::element::ElementLoad;
use crate::model::{Drive, ElementId, Ground, Model, Pattern, PatternKind, Tag};

/// An imposed displacement, found once.
#[derive(Clone, Debug)]
pub(super) struct ImposedDof {
    /// Global degree of freedom.
    pub dof: usize,
    pattern: usize,
    value: f64,
    constant: bool,
    initial: f64,
    ground: Option<Ground>,
    /// Velocity and acceleration are imposed too.
    rates: bool,
    /// Displacement of the ground, and velocity and acceleration that are imposed, at the last time.
    motion: [f64; 3],
}

#[derive(Clone, Debug)]
struct NodalEntry {
    dof: usize,
    pattern: usize,
    value: f64,
    constant: bool,
}

impl ImposedDof {
    /// Take the motion of the ground at a time; where its pattern is held, at the time when it was. Others take velocity and
    /// acceleration of their series.
    #[inline]
    fn follow(&mut self, model: &Model, drives: &[Drive], time: f64) {
        if let Some(g) = &self.ground {
            let held = model.patterns.values().nth(self.pattern).and_then(|p| p.held);
            self.motion = g.motion.at(held.unwrap_or(time));
        } else if self.rates && !self.constant {
            let [vel, accel] = drives[self.pattern].derivatives(time);
            (self.motion[1], self.motion[2]) = (self.value * vel, self.value * accel);
        }
    }

    /// Returns true if velocity and acceleration are imposed.
    pub(super) fn has_rates(&self) -> bool {
        self.rates
    }

    /// Returns true if velocity and acceleration are those of the series of its pattern.
    pub(super) fn follows_series(&self) -> bool {
        self.rates && self.ground.is_none()
    }
}

/// The loads of all patterns, laid out flat.
#[derive(Clone, Debug)]
pub struct Loads {
    tags: Vec<Tag>,
    /// Source of the load factor of each pattern.
    drives: Vec<Drive>,
    /// Load factor (or ground acceleration) of each pattern at the last time.
    factors: Vec<f64>,
    /// Patterns with loads, which are summed anew where their factor changes; others only impose motions.
    loaded: Vec<bool>,
    entries: Vec<NodalEntry>,
    inertia: Vec<GroundInertia>,
    elements: Vec<(ElementId, usize, ElementLoad)>,
    /// Imposed displacements that are out of the equations.
    pub(super) imposed: Vec<ImposedDof>,
    /// Imposed displacements that constraints in the equations hold, where velocities are imposed with them.
    pub(super) linked: Vec<ImposedDof>,
    /// Some of the former come with velocities of the ground.
    pub(super) ground_moves: bool,
    /// Some imposed displacements come with velocities.
    pub(super) moves: bool,
    /// Forces on all degrees of freedom at the last time.
    pub(super) nodal: Vec<f64>,
    /// Factors of the loads on elements that were last summed.
    element_factors: Vec<f64>,
    valid: bool,
}

impl Loads {
    pub(super) fn new(model: &Model, map: &DofMap, compat: bool) -> Self {
        let tags: Vec<Tag> = model.patterns.keys().copied().collect();
        let mut loads = Self {
            drives: model.patterns.values().map(Pattern::drive).collect(),
            factors: vec![0.0; tags.len()],
            loaded: model.patterns.values().map(Pattern::has_loads).collect(),
            entries: vec![],
            inertia: vec![],
            elements: vec![],
            imposed: vec![],
            linked: vec![],
            ground_moves: false,
            moves: false,
            nodal: vec![0.0; model.dofs()],
            element_factors: vec![],
            valid: false,
            tags,
        };
        for (i, p) in model.patterns.values().enumerate() {
            for l in &p.nodal_loads {
                let dofs = model.nodes[l.node.0].dofs();
                loads.entries.extend(dofs.zip(&l.values).filter(|(_, v)| **v != 0.0).map(|(dof, &value)| NodalEntry {
                    dof,
                    pattern: i,
                    value,
                    constant: l.constant,
                }));
            }
            loads.elements.extend(p.element_loads.iter().map(|(e, l)| (*e, i, *l)));
            if let PatternKind::Uniform(e) = &p.kind {
                loads.inertia.push(GroundInertia::new(model, i, e, compat));
            }
        }
        // OpenSees imposes displacements alone.
        let without_rates = compat;
        loads.imposed = map.imposed.iter().filter_map(|i| loads.find(model, i, without_rates)).collect();
        loads.ground_moves = loads.imposed.iter().any(|i| i.ground.is_some() && i.rates);
        if !without_rates {
            let links = map.links.iter().filter_map(|link| link.imposed);
            loads.linked = links.filter_map(|i| loads.find(model, &i, without_rates)).collect();
        }
        loads.moves = loads.imposed.iter().chain(&loads.linked).any(|i| i.rates);
        loads
    }

    fn find(&self, model: &Model, i: &Imposed, without_rates: bool) -> Option<ImposedDof> {
        let m = &model.patterns.get(&i.pattern)?.motions[i.index];
        let pattern = self.tags.binary_search(&i.pattern).ok()?;
        let (ground, motion) = (m.ground.clone(), [0.0; 3]);
        let rates = ground.as_ref().map_or(!without_rates, |g| g.rates);
        Some(ImposedDof {
            dof: i.dof,
            pattern,
            value: m.value,
            constant: m.constant,
            initial: m.initial,
            ground,
            rates,
            motion,
        })
    }

    /// Displacement imposed at the last time.
    #[inline]
    pub(super) fn imposed_value(&self, i: &ImposedDof) -> f64 {
        if i.ground.is_some() {
            return i.motion[0];
        }
        i.initial + i.value * if i.constant { 1.0 } else { self.factors[i.pattern] }
    }

    /// Velocity and acceleration imposed at the last time, where they are. Displacements by a series have none where no
    /// time passes.
    pub(super) fn imposed_rates(i: &ImposedDof, elapses: bool) -> Option<[f64; 2]> {
        let rests = i.ground.is_none() && !elapses;
        i.rates.then(|| if rests { [0.0; 2] } else { [i.motion[1], i.motion[2]] })
    }

    /// Value of a constraint that the handler keeps in the equations.
    pub(super) fn link_value(&self, model: &Model, i: &Imposed, time: f64) -> f64 {
        self.find(model, i, true).map_or(0.0, |mut i| {
            i.follow(model, &self.drives, time);
            self.imposed_value(&i)
        })
    }

    /// Returns true if the series of a pattern moves nodes.
    pub(super) fn is_driven(&self) -> bool {
        let driven =
            |i: &ImposedDof| i.follows_series() && !i.constant && !matches!(self.drives[i.pattern], Drive::Held(_));
        self.imposed.iter().chain(&self.linked).any(driven)
    }

    /// The largest displacement that is imposed, without sign.
    pub(super) fn largest_imposed(&self) -> f64 {
        self.imposed.iter().chain(&self.linked).fold(0.0f64, |m, i| m.max(self.imposed_value(i).abs()))
    }

    /// Returns true if all loads are forces on nodes and displacements that follow the factors of their patterns.
    pub(super) fn acts_on_nodes_only(&self) -> bool {
        self.elements.is_empty() && self.linked.is_empty() && self.imposed.iter().all(|i| i.ground.is_none())
    }

    /// Inertia forces of uniform ground motions.
    pub(super) fn ground_inertia(&self) -> &[GroundInertia] {
        &self.inertia
    }

    /// Returns true if the loads of another model are at the same places, and their patterns have the same factors at all
    /// times.
    pub(super) fn matches(&self, other: &Self) -> bool {
        let drives = self.drives.len() == other.drives.len()
            && self.drives.iter().zip(&other.drives).all(|(own, other)| own.equals(other));
        drives
            && self.loaded == other.loaded
            && self.places().eq(other.places())
            && self.imposed_places().eq(other.imposed_places())
    }

    /// Sources of the load factors, by pattern.
    pub(super) fn drives(&self) -> &[Drive] {
        &self.drives
    }

    /// Patterns with loads.
    pub(super) fn loaded(&self) -> &[bool] {
        &self.loaded
    }

    /// Degree of freedom and pattern of each nodal load; true for one that does not follow the factor.
    pub(super) fn places(&self) -> impl Iterator<Item = (usize, usize, bool)> {
        self.entries.iter().map(|e| (e.dof, e.pattern, e.constant))
    }

    /// Value of a nodal load.
    pub(super) fn value(&self, i: usize) -> f64 {
        self.entries[i].value
    }

    /// The same of each imposed displacement.
    pub(super) fn imposed_places(&self) -> impl Iterator<Item = (usize, usize, bool)> {
        self.imposed.iter().map(|i| (i.dof, i.pattern, i.constant))
    }

    /// Initial displacement and value of an imposed displacement.
    pub(super) fn imposed_numbers(&self, i: usize) -> [f64; 2] {
        [self.imposed[i].initial, self.imposed[i].value]
    }

    /// Forget what has been worked out: the state it went into is gone.
    pub(super) fn invalidate(&mut self) {
        self.valid = false;
    }

    /// The loads on the nodes themselves at the last time, into `out`.
    pub(super) fn of_nodes(&self, out: &mut [f64]) {
        out.copy_from_slice(&self.nodal);
        self.inertia.iter().for_each(|i| i.take_off(&self.factors, true, out));
    }

    /// The loads at the last time that balance the resisting forces, into `out`: all but what OpenSees counts again.
    pub(super) fn of_model(&self, out: &mut [f64]) {
        out.copy_from_slice(&self.nodal);
        self.inertia.iter().for_each(|i| i.take_off(&self.factors, false, out));
    }

    /// Add to the force of an element what OpenSees reports beside it.
    pub(super) fn report(&self, element: ElementId, force: &mut [f64]) {
        self.inertia.iter().for_each(|i| i.report(&self.factors, element, force));
    }

    /// Work out the loads at a time; `words` takes those on elements. Whether the latter may have changed.
    ///
    /// # Errors
    /// Class and tag of an element that does not take its load, and what it says.
    #[inline]
    pub(super) fn apply(&mut self, model: &Model, time: f64, words: &mut [f64]) -> Result<bool, (String, String)> {
        let mut changed = !self.valid;
        let drives = &self.drives;
        self.imposed.iter_mut().chain(&mut self.linked).for_each(|i| i.follow(model, drives, time));
        for ((f, drive), loaded) in self.factors.iter_mut().zip(&self.drives).zip(&self.loaded) {
            let factor = drive.factor(time);
            changed |= *loaded && factor != *f;
            *f = factor;
        }
        if changed { self.sum(model, words) } else { Ok(false) }
    }

    /// Sum the loads by their factors.
    fn sum(&mut self, model: &Model, words: &mut [f64]) -> Result<bool, (String, String)> {
        self.nodal.fill(0.0);
        for e in &self.entries {
            self.nodal[e.dof] += e.value * if e.constant { 1.0 } else { self.factors[e.pattern] };
        }
        self.inertia.iter().for_each(|i| i.add(&self.factors, &mut self.nodal));
        let was_valid = std::mem::replace(&mut self.valid, true);
        let factors = self.elements.iter().map(|(_, pattern, _)| self.factors[*pattern]);
        if was_valid && factors.clone().eq(self.element_factors.iter().copied()) {
            return Ok(false);
        }
        self.element_factors.clear();
        self.element_factors.extend(factors);
        // Loads of a pattern that has been removed are still there.
        let changed = !self.elements.is_empty() || words.iter().any(|w| *w != 0.0);
        if changed {
            words.fill(0.0);
        }
        for (id, pattern, load) in &self.elements {
            let e = &model.elements[id.0];
            e.element
                .add_load(load, self.factors[*pattern], &mut words[e.load.clone()])
                .map_err(|error| (format!("{} {}", e.element.class().name, e.tag), error.0.into()))?;
        }
        Ok(changed)
    }
}
