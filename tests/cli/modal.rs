//! `modalProperties` against OpenSees' report.

use super::Place;
use std::fs;

/// A frame with lumped, consistent and nodal masses, some of them held.
const FRAME: &str = "model BasicBuilder -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 3\nnode 3 4 3\nnode 4 4 0\nfix 1 1 1 1\n\
    fix 4 1 1 1\nmass 2 1 1 0.1\nmass 3 2 2 0\ngeomTransf Linear 1\n\
    element elasticBeamColumn 1 1 2 0.1 2e4 0.01 1 -mass 0.1\n\
    element elasticBeamColumn 2 2 3 0.1 2e4 0.01 1 -mass 0.2 -cMass\n\
    element elasticBeamColumn 3 4 3 0.1 2e4 0.01 1\neigen -fullGenLapack 3\n";

/// Run the frame and a command: what it puts out, and the report if it writes one.
fn run(command: &str) -> (Option<i32>, String, String, String) {
    let place = Place::new();
    place.write("m.tcl", format!("{FRAME}{command}\n"));
    let (code, out, err) = place.run(&["run", "--compat", "opensees", "m.tcl"]);
    (code, out, err, fs::read_to_string(place.0.join("report")).unwrap_or_default())
}

#[test]
fn values() {
    let shown = "set d [modalProperties -return]\nforeach {key values} $d { puts \"$key $values\" }";
    let (code, out, err, _) = run(shown);
    assert_eq!(code, Some(0), "{err}");
    // openseespy 3.7.1, `modalProperties('-return')`; the sign of a shape is anyone's.
    for (key, expected) in [
        ("totalMass", &[4.1, 4.1, 17.46531866840632][..]),
        ("totalFreeMass", &[3.95, 3.95, 15.22930681133213]),
        ("centerOfMass", &[2.4303797468354427, 3.0]),
        ("partiFactorMX", &[1.9842298035548802, 0.05738155071865995, 0.06605739685895948]),
        ("partiFactorRMZ", &[0.16246652932099673, 1.4948773286812682, 3.33981115333721]),
        ("partiMassMY", &[0.0005700150340545004, 3.206228462685369, 0.6504387502336766]),
        ("partiMassesCumuRMZ", &[0.02636887368850893, 2.3648740484458255, 12.788171436041287]),
        ("partiMassRatiosMX", &[99.57506884832783, 0.08723177111288638, 0.1032302840726796]),
        ("partiMassRatiosCumuMY", &[0.014430760355810136, 81.1847715878335, 97.6515753912177]),
    ] {
        let line = out.lines().find_map(|l| l.strip_prefix(key)?.strip_prefix(' ')).unwrap_or_default();
        let values: Vec<f64> = line.split(' ').map(|x| x.parse().unwrap()).collect();
        assert_eq!(values.len(), expected.len(), "{key}: {line}");
        for (x, e) in values.iter().zip(expected) {
            assert!((x.abs() - e).abs() < 1e-9 * e.max(1.0), "{key}: {x} for {e}");
        }
    }
}

#[test]
fn report() {
    let (code, _, err, text) = run("modalProperties -file report -unorm");
    assert_eq!(code, Some(0), "{err}");
    assert!(text.starts_with("# MODAL ANALYSIS REPORT\n\n* 1. DOMAIN SIZE:\n"), "{text}");
    for lines in [
        "#          MODE        LAMBDA         OMEGA     FREQUENCY        PERIOD\n\
         # ------------- ------------- ------------- ------------- -------------\n              \
         1       28.0387       5.29516      0.842751       1.18659\n",
        "\n              2     0.0365443       1.11476      0.952036\n",
        "\n* 10. MODAL PARTICIPATION MASS RATIOS (%) (cumulative):\n",
    ] {
        assert!(text.contains(lines), "{lines}\nis not in\n{text}");
    }
    assert!(text.ends_with("              3       99.7655       97.6516       83.9708\n\n\n"), "{text}");
    let (code, _, err, text) = run("wipeAnalysis\nmodalProperties -print");
    assert_eq!(code, Some(0), "{err}");
    assert!(err.contains("MODAL ANALYSIS REPORT") && text.is_empty(), "{err}");
}

/// openseespy 3.7.1, `responseSpectrumAnalysis` by mode: displacements of node 2 and 3, shear moment of element 1. The sign of
/// a step does not depend on that of the shape.
#[test]
fn steps_of_a_response_spectrum() {
    let command = "for {set m 1} {$m <= 3} {incr m} {\n\
                   responseSpectrumAnalysis 1 -Tn 0.0 0.2 1.0 3.0 -Sa 4.0 10.0 8.0 1.0 -mode $m\n\
                   puts \"[nodeDisp 2 1] [nodeDisp 3 2] [nodeDisp 3 3] [lindex [eleForce 1] 2]\"\n}";
    let (code, out, err, _) = run(command);
    assert_eq!(code, Some(0), "{err}");
    let expected = [
        [0.257156060606758, -0.014202169306880511, -0.06602346634065646, 25.72120308775786],
        [-3.7674769601953704e-05, 0.0012152729081417117, -0.0001176941105372607, 0.04060099382148182],
        [0.0001197786388899198, 0.0002683724338706272, 0.0003528586640702623, 0.0018984514991975312],
    ];
    for (line, expected) in out.lines().zip(expected) {
        let values: Vec<f64> = line.split(' ').map(|x| x.parse().unwrap()).collect();
        for (got, expected) in values.iter().zip(expected) {
            assert!((got - expected).abs() < 1e-6 * expected.abs().max(1e-5), "{line}");
        }
    }
    assert_eq!(out.lines().count(), 3, "{out}");
    let (code, _, err, _) = run("responseSpectrumAnalysis 1 -Tn 1.0 0.5 -Sa 1.0 2.0");
    assert!(code == Some(2) && err.contains("increase"), "{err}");
}

/// `print` shows the mode shapes of a node, a column a mode, and its masses as a matrix.
#[test]
fn printed_nodes_have_mode_shapes() {
    let (code, _, err, text) = run("print -file report -node 2");
    assert_eq!(code, Some(0), "{err}");
    let (before, shapes) = text.split_once("\t Eigenvectors: \n").unwrap_or_default();
    assert!(before.contains("\tMass : \n1 0 0 \n0 1 0 \n0 0 0.1 \n\n\t Rayleigh Factor: alphaM: 0\n"), "{text}");
    let rows: Vec<usize> = shapes.trim().lines().map(|row| row.split_whitespace().count()).collect();
    assert_eq!(rows, [3, 3, 3], "{text}");
}
