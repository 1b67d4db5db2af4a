//! Lines of scripts for bearings with the properties of a bound.

use super::{Bounds, Factors, Properties};
use std::f64::consts::PI;
use std::fmt::Write as _;

/// Layers of a round rubber bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rubber {
    /// Inner diameter: that of the lead core or of the hole.
    pub inner: f64,
    /// Outer diameter.
    pub outer: f64,
    /// Thickness of a steel shim.
    pub shim: f64,
    /// Thickness of a rubber layer.
    pub layer: f64,
    /// Number of rubber layers.
    pub layers: f64,
    /// Bulk modulus.
    pub bulk: f64,
}

/// Lines for each bound. `ratio` is the elastic stiffness over K_d, `weight` the load on a bearing for friction pendulums.
/// Tags and nodes are variables of the script.
pub fn script_lines(bounds: &Bounds, ratio: f64, weight: Option<f64>, rubber: Option<&Rubber>) -> String {
    let mut out = String::from(
        "# Bearing for each bound of its properties. Set bound to lower, nominal or upper, then tag, i and j (nodes) and the \
         materials\n# axial, torsion and bending before.\nif {![info exists bound]} {set bound nominal}\nswitch -- $bound {\n",
    );
    for (name, p, l) in [
        ("lower", bounds.lower, bounds.lambda_min),
        ("nominal", bounds.nominal, Factors::ONE),
        ("upper", bounds.upper, bounds.lambda_max),
    ] {
        let _ = writeln!(out, "    {name} {{");
        let _ = writeln!(out, "        set Qd {:.8e}; set Kd {:.8e}; set K1 {:.8e}", p.q_d, p.k_d, ratio * p.k_d);
        let _ = writeln!(out, "        set lambdaQ {:.6}; set lambdaK {:.6}", l.q_d, l.k_d);
        if let Some(w) = weight {
            let _ = writeln!(out, "        set mu {:.8}; set Reff {:.8e}", p.q_d / w, w / p.k_d);
        }
        if let Some(r) = rubber {
            let (shear, yield_force) = lead_rubber(p, r);
            let _ = writeln!(out, "        set Gr {shear:.8e}; set Fy {yield_force:.8e}");
        }
        out += "    }\n";
    }
    out += "    default {error \"bound is $bound: expected lower, nominal or upper\"}\n}\n";
    out += "# Any elastomeric bearing (Bouc-Wen with eta 1, beta and gamma 0.5):\n\
            # element elastomericBearingBoucWen $tag $i $j $K1 $Qd [expr {$Kd/$K1}] 0.0 1.0 1.0 0.5 0.5 \
            -P $axial -T $torsion -My $bending -Mz $bending\n";
    if let Some(r) = rubber {
        let _ = writeln!(
            out,
            "# Lead-rubber bearing:\n# element LeadRubberX $tag $i $j $Fy {:.8} $Gr {:.8e} {:.8e} {:.8e} {:.8e} {:.8e} {}",
            1.0 / ratio,
            r.bulk,
            r.inner,
            r.outer,
            r.shim,
            r.layer,
            r.layers
        );
    }
    if weight.is_some() {
        out += "# Friction pendulum:\n# frictionModel Coulomb $friction $mu\n\
                # element singleFPBearing $tag $i $j $friction $Reff $K1 -P $axial -T $torsion -My $bending -Mz $bending\n";
    }
    out += "# Kikuchi bearing with the law of lead-rubber bearings: the factors go into the law of its nominal bearing:\n\
            # uniaxialMaterial KikuchiAikenLRB $law $type $ar $hr $gr $ap $tp $alph $beta -coKQ $lambdaK $lambdaQ\n\
            # Kikuchi bearing with the law of high damping rubber: stiffness, and damping ratio beside it:\n\
            # uniaxialMaterial KikuchiAikenHDR $law $type $ar $hr -coGHU $lambdaK [expr {$lambdaQ/$lambdaK}] \
            [expr {$lambdaQ/$lambdaK}]\n\
            # HDR and HDRB: their parameters are not two; fit them to the record of a bound with \"hysteron calibrate\".\n";
    out
}

/// Shear modulus and F_y of `LeadRubberX`: K_d = G A/T_r on the bonded area. The element's F_y is the largest force of its
/// hysteretic part, which is Q_d.
fn lead_rubber(p: Properties, r: &Rubber) -> (f64, f64) {
    // Without a cover, which the line leaves at zero.
    let area = PI / 4.0 * (r.outer.powi(2) - r.inner.powi(2));
    (p.k_d * r.layers * r.layer / area, p.q_d)
}
