//! Recorders of a study, added before the first step of the transient analysis of its script.

use super::study::Study;
use hysteron_opensees::Tcl;
use hysteron_tcl::{Exception, Value};
use std::fmt::Write;
use std::sync::{Arc, Mutex};

/// Elements and nodes that a study records, by their tags.
#[derive(Clone, Debug, Default)]
pub(super) struct Observed {
    bearings: Vec<i64>,
    contacts: Vec<i64>,
    members: Vec<i64>,
    floors: Vec<i64>,
    places: Arc<Mutex<Vec<Place>>>,
}

/// Place of a bearing.
#[derive(Clone, Debug)]
pub(super) struct Place {
    /// Horizontal coordinates of its upper node.
    pub(super) horizontal: Vec<f64>,
    /// Height between its nodes.
    pub(super) height: f64,
}

impl Observed {
    pub(super) fn of(study: &Study) -> Self {
        Self {
            bearings: study.bearings.iter().flat_map(|b| b.tags.iter().copied()).collect(),
            contacts: study.contacts().collect(),
            members: study.members.clone(),
            floors: study.floors.iter().map(|f| f.node).collect(),
            places: Arc::default(),
        }
    }

    /// Add the recorders.
    ///
    /// # Errors
    /// An element or a node is not in the model.
    pub(super) fn add(&self, interp: &mut Tcl) -> Result<(), Exception> {
        let ndm = interp.host.engine.model().nodes.first().map_or(0, |n| n.coords.len());
        let dofs = |n: usize| (1..=n).map(|d| d.to_string()).collect::<Vec<_>>().join(" ");
        let (all, horizontal) = (dofs(ndm), dofs(ndm.saturating_sub(1)));
        let (mut text, mut places) = (String::new(), vec![]);
        for tag in &self.bearings {
            let model = interp.host.engine.model();
            let id = i32::try_from(*tag).ok().and_then(|t| model.element(t));
            let nodes = id.map(|id| &model.elements[id.0].nodes[..]);
            let Some([lower, upper, ..]) = nodes else {
                return Err(Exception::error(format!("there is no bearing {tag} with two nodes")));
            };
            let (below, above) = (&model.nodes[lower.0].coords, &model.nodes[upper.0].coords);
            if let (Some(low), Some((high, horizontal))) = (below.last(), above.split_last()) {
                places.push(Place { horizontal: horizontal.to_vec(), height: high - low });
            }
            for (what, node) in [("lower", lower), ("upper", upper)] {
                let node = model.nodes[node.0].tag;
                let _ =
                    writeln!(text, "recorder Node -file hysteron_isolate/{tag}/{what} -node {node} -dof {all} disp");
            }
            let _ = writeln!(text, "recorder Element -file hysteron_isolate/{tag}/force -ele {tag} globalForce");
        }
        for tag in &self.contacts {
            let _ = writeln!(text, "recorder Element -file hysteron_isolate/contact{tag} -ele {tag} globalForce");
        }
        for tag in &self.members {
            let _ = writeln!(text, "recorder Element -file hysteron_isolate/member{tag} -ele {tag} localForce");
        }
        for node in &self.floors {
            for what in ["disp", "accel"] {
                let file = format!("hysteron_isolate/floor{node}/{what}");
                let _ = writeln!(text, "recorder Node -file {file} -node {node} -dof {horizontal} {what}");
            }
        }
        if let Ok(mut kept) = self.places.lock() {
            *kept = places;
        }
        // What is said about these recorders is not about the script.
        let warnings = interp.warnings.len();
        let made = interp.eval_value(&Value::from(text)).map(|_| ());
        interp.warnings.truncate(warnings);
        made
    }

    /// Places of the bearings; empty before the recorders are there.
    pub(super) fn places(&self) -> Vec<Place> {
        self.places.lock().map(|p| p.clone()).unwrap_or_default()
    }
}
