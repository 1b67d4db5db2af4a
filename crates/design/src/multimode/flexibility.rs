//! Storey drifts under horizontal forces of the floors.

use super::ModalModel;
use crate::isolate::Study;
use hysteron_tcl::Exception;

/// Loads over the weights of the floors: small, so that the structure stays elastic.
const LOAD_SHARE: f64 = 1.0e-3;

/// Displacements of the floors under each of the loads in turn, added one to another: rows of loads, the state without
/// them first. Steps of one iteration: the structure is linear under small loads.
const STATIC: &str = r#"
proc hysteron_floor_displacements {floors loads direction} {
    loadConst -time 0.0
    wipeAnalysis
    constraints Transformation
    numberer RCM
    system BandGeneral
    algorithm Linear
    integrator LoadControl 1.0
    analysis Static
    set rows {}
    set tag [expr {987650000 + 1000*$direction}]
    foreach node [concat {{} {}} $floors] load [concat {0.0 0.0} $loads] {
        incr tag
        timeSeries Linear $tag
        pattern Plain $tag $tag {
            if {$node ne {}} {
                set forces [lrepeat [llength [nodeDisp $node]] 0.0]
                load $node {*}[lreplace $forces [expr {$direction - 1}] [expr {$direction - 1}] $load]
            }
        }
        if {[analyze 1] != 0} { error "the static analysis fails" }
        loadConst -time 0.0
        set row {}
        foreach floor $floors { lappend row [nodeDisp $floor $direction] }
        lappend rows $row
    }
    return [lrange $rows 1 end]
}
"#;

impl ModalModel {
    /// Storey drift ratios of each direction under a unit force at each floor: `[direction][floor of the force][storey]`. The
    /// bearings have the stiffness that they were given.
    ///
    /// # Errors
    /// The loads cannot be applied.
    pub(crate) fn drifts(&mut self, study: &Study) -> Result<Vec<Vec<Vec<f64>>>, String> {
        let list = |words: Vec<String>| words.join(" ");
        let floors = list(study.floors.iter().map(|f| f.node.to_string()).collect());
        let forces: Vec<f64> = study.floors.iter().map(|f| LOAD_SHARE * f.weight).collect();
        let loads = list(forces.iter().map(f64::to_string).collect());
        let mut out = vec![];
        for direction in 1..=self.horizontal() {
            let text = format!("{STATIC}hysteron_floor_displacements {{{floors}}} {{{loads}}} {direction}");
            let failed = "the storey drifts of the lateral forces cannot be found".to_owned();
            let rows = self.run.interp.eval_str("isolation study", &text).map_err(|e| match e {
                Exception::Error(e) => format!("{failed}: {}", e.diagnostic.message),
                _ => failed.clone(),
            })?;
            let numbers = |row: &hysteron_tcl::Value| -> Option<Vec<f64>> {
                row.to_list().ok()?.iter().map(|v| v.to_f64().ok()).collect()
            };
            let rows: Option<Vec<Vec<f64>>> = rows.to_list().ok().and_then(|rows| rows.iter().map(numbers).collect());
            let rows = rows.filter(|r| r.len() == forces.len() + 1).ok_or(failed)?;
            let of_load = |(pair, force): (&[Vec<f64>], &f64)| {
                let moved: Vec<f64> = pair[1].iter().zip(&pair[0]).map(|(a, b)| (a - b) / force).collect();
                moved.windows(2).zip(&study.floors[1..]).map(|(w, f)| (w[1] - w[0]) / f.height).collect()
            };
            out.push(rows.windows(2).zip(&forces).map(of_load).collect());
        }
        Ok(out)
    }
}
