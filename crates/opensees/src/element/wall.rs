//! `element MVLEM`.

use super::{Ends, Kind, Make};
use crate::args::Args;
use crate::slips;
use crate::{Tcl, ignore_option};
use hysteron_engine::element::{Element, WallFibre, WallLines};
use hysteron_engine::material::Material;
use hysteron_tcl::Exception;
use std::sync::Arc;

pub(super) const MVLEM: Kind = Kind {
    names: &["MVLEM"],
    usage: "element MVLEM $tag $density $i $j $m $c -thick $t1 ... -width $w1 ... -rho $ratio1 ... -matConcrete $mat1 ... \
            -matSteel $mat1 ... -matShear $mat",
    make: Make::AnyNodes(make),
};

/// Laws of the fibres, with their tags.
type Laws = Vec<(Material, i32)>;

const OPTIONS: &[&str] = &["-thick", "-width", "-rho", "-matConcrete", "-matSteel", "-matShear"];

fn make(
    interp: &mut Tcl,
    a: &mut Args<'_>,
) -> Result<(Vec<hysteron_engine::model::NodeId>, Arc<dyn Element>), Exception> {
    let density = a.not_negative("density")?;
    let ends = Ends::take(interp, a)?;
    let nodes = a.last_span();
    if (ends.ndm, ends.ndf) != (2, 3) {
        return Err(ends.wrong(a, "3 degrees of freedom in 2 dimensions"));
    }
    let (below, above) = ends.place;
    let height = above.y - below.y;
    if above.x != below.x || height <= 0.0 {
        return Err(a.refuse_at(
            nodes,
            "MVLEM: node j is not above node i",
            "expected a node with the same x above node i",
        ));
    }
    let count = a.count("number m of fibres")?;
    if count == 0 {
        return Err(a.refuse("MVLEM has no fibres", "expected 1 or more"));
    }
    let centre = a.float("height c of the shear spring as a share of the height")?;
    let last = a.last_span();
    let (mut thickness, mut width, mut ratio): (Vec<f64>, Vec<f64>, Vec<f64>) = (vec![], vec![], vec![]);
    let (mut concrete, mut steel, mut shear): (Laws, Laws, _) = (vec![], vec![], None);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-thick" => thickness = numbers(count, || a.positive("thickness of a fibre"))?,
            "-width" => width = numbers(count, || a.positive("width of a fibre"))?,
            "-rho" => ratio = numbers(count, || a.not_negative("ratio of reinforcement of a fibre"))?,
            "-matConcrete" => concrete = numbers(count, || a.of(&interp.host.builder.definitions.materials))?,
            "-matSteel" => steel = numbers(count, || a.of(&interp.host.builder.definitions.materials))?,
            "-matShear" => shear = Some(a.of(&interp.host.builder.definitions.materials)?),
            _ => ignore_option(interp, a, OPTIONS)?,
        }
    }
    let given =
        [thickness.len(), width.len(), ratio.len(), concrete.len(), steel.len(), count * usize::from(shear.is_some())];
    if let Some(option) = given.iter().position(|n| *n != count).map(|i| OPTIONS[i]) {
        let message = format!("MVLEM: {option} is missing");
        return Err(a.refuse_at(
            last,
            message,
            "expected all of -thick, -width, -rho, -matConcrete, -matSteel, -matShear",
        ));
    }
    let Some(shear) = shear else {
        return Err(a.refuse_at(last, "MVLEM: -matShear is missing", "expected a material"));
    };
    let fibres = concrete.into_iter().zip(steel).zip(thickness.into_iter().zip(width).zip(ratio));
    let fibres = fibres.map(|((concrete, steel), ((thickness, width), ratio))| WallFibre {
        thickness,
        width,
        ratio,
        concrete,
        steel,
    });
    let density = if interp.host.follows(&[slips::WALL_MASS]) { 0.0 } else { density };
    let made = WallLines::new(fibres.collect(), shear, height, centre, density);
    Ok((ends.nodes.to_vec(), Arc::new(made)))
}

/// As many values as there are fibres.
fn numbers<T>(count: usize, mut take: impl FnMut() -> Result<T, Exception>) -> Result<Vec<T>, Exception> {
    (0..count).map(|_| take()).collect()
}
