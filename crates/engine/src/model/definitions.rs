//! Named things that elements and patterns are made from: materials, series, transformations.

use super::Tag;
use crate::element::beam::Rule;
use crate::element::damping::ElementDamping;
use crate::element::friction::Friction;
use crate::element::transform::TransformSpec;
use crate::material::{Backbone, LimitCurve, Material, NdMaterial};
use crate::section::SharedSection;
use crate::section::plate::SharedPlateSection;
use crate::series::Series;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Things of one kind by tag.
#[derive(Clone, Debug)]
pub struct Registry<T> {
    /// Name of the objects in messages.
    pub kind: &'static str,
    things: BTreeMap<Tag, T>,
    /// Tags that the next thing may take over.
    reusable: BTreeSet<Tag>,
}

impl<T> Registry<T> {
    /// An empty registry of things called `kind`.
    pub fn new(kind: &'static str) -> Self {
        Self { kind, things: BTreeMap::new(), reusable: BTreeSet::new() }
    }
    /// The thing with a tag.
    pub fn get(&self, tag: Tag) -> Option<&T> {
        self.things.get(&tag)
    }
    /// Add a thing; `false` if the tag is taken (nothing changes then).
    pub fn add(&mut self, tag: Tag, thing: T) -> bool {
        let free = self.reusable.remove(&tag) || !self.things.contains_key(&tag);
        if free {
            self.things.insert(tag, thing);
        }
        free
    }
    /// Let each tag be taken once more. Until then it names the thing of before.
    pub fn reuse_tags(&mut self) {
        self.reusable.extend(self.things.keys());
    }
    /// Remove the thing with a tag.
    pub fn remove(&mut self, tag: Tag) -> Option<T> {
        self.things.remove(&tag)
    }
    /// The registry with the things of some tags alone. Each tag comes with the kind of its thing.
    fn only(&self, taken: &[(&'static str, Tag)]) -> Self
    where
        T: Clone,
    {
        let mine = taken.iter().filter(|(kind, _)| *kind == self.kind);
        let things = mine.filter_map(|(_, tag)| Some((*tag, self.things.get(tag)?.clone()))).collect();
        Self { kind: self.kind, things, reusable: BTreeSet::new() }
    }

    /// Tags, rising.
    pub fn tags(&self) -> impl Iterator<Item = Tag> + '_ {
        self.things.keys().copied()
    }
}

/// A rule of quadrature and the sections of its points, with their tags.
#[derive(Clone, Debug)]
pub struct Integration {
    /// The rule.
    pub rule: Rule,
    /// Sections along the beam.
    pub sections: Vec<(SharedSection, Tag)>,
}

/// Everything that has been defined by tag.
#[derive(Clone, Debug)]
pub struct Definitions {
    /// `uniaxialMaterial`.
    pub materials: Registry<Material>,
    /// `nDMaterial`.
    pub nd_materials: Registry<NdMaterial>,
    /// `frictionModel`.
    pub frictions: Registry<Friction>,
    /// `timeSeries`.
    pub series: Registry<Series>,
    /// `section`.
    pub sections: Registry<SharedSection>,
    /// `section` of plates and shells.
    pub plates: Registry<SharedPlateSection>,
    /// `beamIntegration`.
    pub integrations: Registry<Integration>,
    /// `geomTransf`.
    pub transforms: Registry<TransformSpec>,
    /// `hystereticBackbone`.
    pub backbones: Registry<Arc<Backbone>>,
    /// Limit surfaces of columns.
    pub limit_curves: Registry<LimitCurve>,
    /// `damping`.
    pub dampings: Registry<Arc<ElementDamping>>,
}

impl Definitions {
    /// The definitions of some kinds and tags alone.
    #[must_use]
    pub fn only(&self, taken: &[(&'static str, Tag)]) -> Self {
        Self {
            materials: self.materials.only(taken),
            nd_materials: self.nd_materials.only(taken),
            frictions: self.frictions.only(taken),
            series: self.series.only(taken),
            sections: self.sections.only(taken),
            plates: self.plates.only(taken),
            integrations: self.integrations.only(taken),
            transforms: self.transforms.only(taken),
            backbones: self.backbones.only(taken),
            limit_curves: self.limit_curves.only(taken),
            dampings: self.dampings.only(taken),
        }
    }

    /// Let the tags be taken once more that OpenSees forgets at a further `model`: those of all but materials and sections.
    /// Elements and patterns made of the things of before keep them.
    pub fn reuse_tags(&mut self) {
        self.frictions.reuse_tags();
        self.series.reuse_tags();
        self.integrations.reuse_tags();
        self.transforms.reuse_tags();
        self.backbones.reuse_tags();
        self.dampings.reuse_tags();
    }
}

/// Kinds of things that a registry holds, in the words of messages.
pub mod kinds {
    /// Uniaxial materials.
    pub const MATERIAL: &str = "uniaxial material";
    /// Materials of continua.
    pub const ND_MATERIAL: &str = "material of continua";
    /// Friction models.
    pub const FRICTION: &str = "friction model";
    /// Time series.
    pub const SERIES: &str = "time series";
    /// Sections.
    pub const SECTION: &str = "section";
    /// Sections of plates.
    pub const PLATE: &str = "section of plates";
    /// Beam integrations.
    pub const INTEGRATION: &str = "beam integration";
    /// Geometric transformations.
    pub const TRANSFORM: &str = "geometric transformation";
    /// Backbones.
    pub const BACKBONE: &str = "backbone";
    /// Limit curves.
    pub const LIMIT_CURVE: &str = "limit curve";
    /// Dampings of elements.
    pub const DAMPING: &str = "damping";
}

impl Default for Definitions {
    fn default() -> Self {
        Self {
            materials: Registry::new(kinds::MATERIAL),
            nd_materials: Registry::new(kinds::ND_MATERIAL),
            frictions: Registry::new(kinds::FRICTION),
            series: Registry::new(kinds::SERIES),
            sections: Registry::new(kinds::SECTION),
            plates: Registry::new(kinds::PLATE),
            integrations: Registry::new(kinds::INTEGRATION),
            transforms: Registry::new(kinds::TRANSFORM),
            backbones: Registry::new(kinds::BACKBONE),
            limit_curves: Registry::new(kinds::LIMIT_CURVE),
            dampings: Registry::new(kinds::DAMPING),
        }
    }
}
