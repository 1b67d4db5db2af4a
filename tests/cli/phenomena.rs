//! Table 4 of Flora, Calabrese and Cardone (2023, doi:10.3390/buildings13010065) on recycled rubber bearings: which phenomena its models capture, each shown by a run.
//!
//! The fourth model is the library's own and captures all of them (see `validation/identification/phenomena/`).

use super::Place;

/// Numbers of an experiment by its name.
fn shown(kind: &str) -> impl Fn(&str) -> Vec<f64> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/validation/identification/phenomena/experiments.tcl");
    let (status, out, err) = Place::new().run(&["run", script, kind]);
    assert_eq!(status, Some(0), "{kind}: {err}");
    move |name| {
        let line = out.lines().find(|l| l.split(' ').next() == Some(name)).unwrap_or_else(|| panic!("{name}: {out}"));
        line.split(' ').skip(1).map(|x| x.parse().unwrap()).collect()
    }
}

/// Bound on the match: phenomena that are captured are well above it, the others well below.
const SEEN: f64 = 0.05;

#[test]
fn table_4() {
    let captured = [
        ("bidirectional", [true, true, true, true]),
        ("lateral_by_axial", [false, false, true, true]),
        ("axial_by_lateral", [false, true, true, true]),
        ("degradation", [false, true, false, true]),
        ("mullins", [false, true, false, true]),
        ("critical_load", [false, true, true, true]),
        ("post_buckling", [false, false, true, true]),
    ];
    for (i, kind) in ["boucwen", "hdr", "kikuchi", "rheology"].into_iter().enumerate() {
        let shown = shown(kind);
        for (name, models) in captured {
            assert_eq!(shown(name)[0] > SEEN, models[i], "{kind}: {name} {:?}", shown(name));
        }
        assert!(shown("cavitation")[0] < SEEN, "{kind}: the stiffness after cavitation");
        // The moments of the ends balance the load, with the shear force times the height where there is one.
        let moments = shown("end_moments")[0];
        assert!(kind == "kikuchi" || (moments + 1.0).abs() < 1e-3, "{kind}: {moments}");
    }
}
