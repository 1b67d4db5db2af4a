//! Drifts between nodes.

use super::{Group, Missing, RecordError, Source};
use crate::analysis::Engine;
use crate::model::Tag;

/// Relative displacement of pairs of nodes over their distance in another direction.
#[derive(Debug)]
pub struct Drift {
    pairs: Vec<(Tag, Tag)>,
    /// Local degree of freedom, from 0.
    dof: usize,
    /// Direction of the distance, from 0.
    across: usize,
    /// Degrees of freedom at i and j, and one over the distance.
    found: Vec<(usize, usize, f64)>,
    labels: Vec<String>,
    groups: Vec<Group>,
}

impl Drift {
    /// Of pairs of nodes, in a degree of freedom, over their distance in a direction (both from 0).
    pub fn new(pairs: Vec<(Tag, Tag)>, dof: usize, across: usize) -> Self {
        Self { pairs, dof, across, found: vec![], labels: vec![], groups: vec![] }
    }
}

impl Source for Drift {
    fn find(&mut self, engine: &Engine, missing: &mut Vec<Missing>) -> Result<(), RecordError> {
        let model = engine.model();
        self.found.clear();
        self.labels.clear();
        self.groups.clear();
        for &(i, j) in &self.pairs {
            let node = |tag: Tag| model.node(tag).map(|id| &model.nodes[id.0]);
            let (Some(a), Some(b)) = (node(i), node(j)) else {
                missing.push(Missing::Node(if node(i).is_none() { i } else { j }));
                continue;
            };
            let distance = (b.place()[self.across] - a.place()[self.across]).abs();
            if distance == 0.0 || self.dof >= a.ndf.min(b.ndf) || self.across >= a.ndm() {
                missing.push(Missing::Drift { nodes: (i, j), direction: self.across + 1 });
                continue;
            }
            self.found.push((a.offset + self.dof, b.offset + self.dof, 1.0 / distance));
            self.labels.push(format!("drift {i} {j}"));
            let attributes = vec![
                ("node1", i.to_string()),
                ("node2", j.to_string()),
                ("perpDirn", self.across.to_string()),
                ("lengthPerpDirn", distance.to_string()),
            ];
            let columns = vec!["drift".to_owned()];
            self.groups.push(Group { name: "DriftOutput", attributes, place: None, columns });
        }
        Ok(())
    }

    fn labels(&self) -> Vec<String> {
        self.labels.clone()
    }

    fn groups(&self, _: &Engine) -> Vec<Group> {
        self.groups.clone()
    }

    fn row(&mut self, engine: &mut Engine, row: &mut Vec<f64>) -> Result<(), RecordError> {
        let disp = &engine.state().disp;
        row.extend(self.found.iter().map(|&(i, j, f)| (disp[j] - disp[i]) * f));
        Ok(())
    }
}
