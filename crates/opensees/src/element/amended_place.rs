//! Directions of an element that an amendment acts in.

use crate::Tcl;
use crate::args::Args;
use crate::load::series::series_of;
use hysteron_engine::element::amendment::{Amended, Amendment};
use hysteron_engine::model::ElementId;
use hysteron_engine::series::Series;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

/// Source of the axial force.
enum Compression {
    /// From what the element carries in a direction; a reversed one is in tension at negative deformations.
    Direction { number: usize, reversed: bool },
    /// From a history of the compression.
    History(Series),
}

/// Directions that an amendment acts in.
#[derive(Default)]
pub(super) struct Place {
    directions: Vec<usize>,
    /// Source of the axial force, if it is not the first direction.
    axial: Option<Compression>,
}

impl Place {
    /// Takes the words of an option of the place; false if it is none.
    pub(super) fn takes(&mut self, interp: &mut Tcl, a: &mut Args<'_>, option: &str) -> Result<bool, Exception> {
        match option {
            "-dir" => {
                while a.at_number() {
                    self.directions.push(a.dof("direction", 6)? + 1);
                }
            }
            "-axial" => {
                let (number, reversed) = a.signed_dof("direction of the axial force", 6)?;
                self.axial = Some(Compression::Direction { number: number + 1, reversed });
            }
            "-axialSeries" => self.axial = Some(Compression::History(series_of(interp, a)?)),
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Amends an element by the law for its stiffness in these directions.
    pub(super) fn amend(
        &self,
        interp: &mut Tcl,
        a: &Args<'_>,
        id: ElementId,
        make: &dyn Fn(f64) -> Arc<dyn Amendment>,
    ) -> Result<(), Exception> {
        let inner = interp.host.engine.model().elements[id.0].element.clone();
        let around = |law| {
            let amended = Amended::new(inner.clone(), law, &self.directions);
            let amended = amended.and_then(|amended| match &self.axial {
                Some(Compression::Direction { number, reversed }) => amended.with_axial(*number, *reversed),
                Some(Compression::History(compression)) => Ok(amended.with_axial_history(compression.clone())),
                None => Ok(amended),
            });
            amended.map_err(|e| a.refuse(e.0, ""))
        };
        // The stiffness that a law may need is that of the directions it will act in.
        let stiffness = around(make(1.0))?.initial_stiffness()[0];
        let made = around(make(stiffness))?;
        interp.host.engine.replace_elements([(id, made.shared())]);
        Ok(())
    }
}
