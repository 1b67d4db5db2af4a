//! `section`.

use super::args::Args;
use super::model::need_model;
use super::{Command, Outcome, Tcl, finish};
use crate::script::{Call, Value};
use crate::section::ElasticSection;

pub(super) const COMMANDS: &[Command] = &[Command { name: "section", usage: ELASTIC, run: section }];

const ELASTIC: &str = "section Elastic $tag $E $A $Iz <$G $alphaY> (in the plane) or \
                       $E $A $Iz $Iy $G $J <$alphaY $alphaZ> (in space)";

fn section(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, ELASTIC);
    match a.word("kind of section")?.as_ref() {
        "Elastic" | "ElasticSection" | "elastic" => {}
        _ => return Err(a.unknown_name("section", ["Elastic"])),
    }
    let tag = a.int("tag of the section")?;
    let span = a.last_span();
    let (e, area) = (a.positive("elastic modulus E")?, a.positive("cross-sectional area A")?);
    let iz = a.positive("second moment of area Iz")?;
    let mut s = ElasticSection { e, area, iz, iy: 0.0, g: 0.0, j: 0.0, shear: (None, None) };
    if interp.host.ndm == 3 {
        s.iy = a.positive("second moment of area Iy")?;
        s.g = a.positive("shear modulus G")?;
        s.j = a.positive("torsion constant J")?;
        if a.left() > 0 {
            s.shear.0 = Some(area * a.positive("shear factor alphaY")?);
            s.shear.1 = Some(area * a.positive("shear factor alphaZ")?);
        }
    } else if a.left() > 0 {
        s.g = a.positive("shear modulus G")?;
        s.shear.0 = Some(area * a.positive("shear factor alphaY")?);
    }
    finish(interp, &a)?;
    if !interp.host.definitions.sections.add(tag, s) {
        return Err(a.refuse_at(span, format!("there is a section {tag} already"), "expected a new tag"));
    }
    Ok(Value::EMPTY)
}
