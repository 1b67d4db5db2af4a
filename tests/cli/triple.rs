//! Mistakes in the words of triple friction pendulums.

use super::run;

const MODEL: &str = "model BasicBuilder -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 0\nuniaxialMaterial Elastic 7 1e6\n";
const FRICTION: &str = "0.01 0.04 0.08";
const SIZE: &str = "0.4 1.25 1.25 0.1 0.2 0.2 0.24 0.36 0.36 0.02 0.02";
const HEAT: &str = "4.44e-6 0.018 20";

/// The command, and words of the message.
#[test]
fn message_names_the_wrong_word() {
    let whole = |way: &str, size: &str, uy: &str, heat: &str, last: &str| {
        format!(
            "element TripleFrictionPendulumX 1 1 2 {way} 7 7 7 7 1 1 1 {FRICTION} {size} 900 {uy} 1 0.1 1e-6 2e4 9e3 9e3 {heat} 20 {last}"
        )
    };
    let cases: Vec<(String, &[&str])> = vec![
        (whole("2 2", SIZE, "0.001", HEAT, "1 2"), &["tagT", "is 2", "0 to 1"]),
        (whole("1 3", SIZE, "0.001", HEAT, "1 2"), &["tagT2", "is 3", "1 to 2"]),
        (whole("1 2", "0.4 0.3", "0.001", HEAT, "1 2"), &["L2", "is 0.3", "greater than L1, 0.4"]),
        (whole("1 2", SIZE, "0.5", HEAT, "1 2"), &["yield displacement uy is 0.5", "less than"]),
        (whole("1 2", SIZE, "0.001", "0 0.018 20", "1 2"), &["thermal diffusivity is 0", "greater than 0"]),
        (whole("1 2", SIZE, "0.001", HEAT, "4 2"), &["kTmodel", "is 4", "1 to 3"]),
        (whole("1 2", SIZE, "0.001", HEAT, "1 9"), &["system of units is 9", "1 to 8"]),
        (whole("1 2", SIZE, "0.001", HEAT, "1"), &["system of units is missing"]),
    ];
    for (command, words) in cases {
        let (status, _, err) = run(&format!("{MODEL}{command}\n"));
        assert_eq!(status, Some(2), "{command}\n{err}");
        for word in words {
            assert!(err.contains(word), "{command}\n{err}");
        }
        assert!(err.contains("m.tcl:5:"), "{command}\n{err}");
    }
    // What cannot be had of OpenSees is said.
    let (status, _, err) = run(&format!("{MODEL}{}\n", whole("0 2", SIZE, "0.001", HEAT, "1 2")));
    assert!(status == Some(0) && err.contains("series of segments (tagT 1)"), "{err}");
}
