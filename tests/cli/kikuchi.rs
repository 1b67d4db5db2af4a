//! Messages of mistakes in `KikuchiBearing` and `multipleNormalSpring`.

use super::run;

const MODEL: &str = "model BasicBuilder -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 0.4\nnode 3 0 0 0\nfix 1 1 1 1 1 1 1\n\
    uniaxialMaterial Elastic 1 2.5e6\nuniaxialMaterial Elastic 2 1.3e9\n";

const KIKUCHI: &str = "-shape round -size 0.8 0.16 -nMSS 8 -matMSS 1 -limDisp 0.05 -nMNS 6 -matMNS 2 -orient 0 1 0";
const NORMAL: &str = "-mat 2 -shape round -size 0.8 -orient 0 1 0";

/// The words after the nodes of a bearing that differ from a good one, and what the message says.
const BEARINGS: &[(&str, &str, &[&str])] = &[
    ("-shape round", "-shape oval", &["unknown shape \"oval\"", "expected round or square"]),
    ("-shape round", "", &["-shape is missing"]),
    ("-size 0.8 0.16", "-size -0.8 0.16", &["diameter or edge of the bearing is -0.8", "greater than 0"]),
    ("-size 0.8 0.16", "-size 0.8 0", &["total thickness of the rubber is 0"]),
    ("-nMSS 8", "-nMSS 0", &["number nMSS of shear springs is 0"]),
    ("-nMNS 6", "-nMNS 100000", &["1 to 1000"]),
    ("-matMSS 1", "-matMSS 7", &["there is no uniaxial material 7", "defined: 1 2"]),
    ("-limDisp 0.05", "-limDisp 0", &["-limDisp is 0", "greater than 0"]),
    ("-limDisp 0.05", "-limDisp -1", &["limDisp", "not less than 0"]),
    ("-orient 0 1 0", "-orient 0 1 0 -totalHeight -1", &["total height of the bearing is -1"]),
    ("-orient 0 1 0", "-orient 0 0 1", &["parallel"]),
    ("-orient 0 1 0", "-orient 0 1 0 -lambda 1e4", &["-lambda is 10000", "0 to 700"]),
    ("-orient 0 1 0", "-mass 0 -orient 0 1 0", &["mass is 0", "greater than 0"]),
    ("-orient 0 1 0", "-adjustPDOutput 0.5 -0.5 -orient 0 1 0", &["share cj at j is -0.5"]),
    ("-orient 0 1 0", "-doBalance 1 1 0 -orient 0 1 0", &["nIter of corrections is 0"]),
    ("-nMSS 8", "-nMSS 8 -nMSS 8", &["-nMSS is given twice"]),
];

#[test]
fn refused() {
    let (status, _, err) = run(&format!("{MODEL}element KikuchiBearing 1 1 2 {KIKUCHI}\n"));
    assert!(status == Some(0) && err.is_empty(), "{err}");
    for (good, bad, words) in BEARINGS {
        let (status, _, err) = run(&format!("{MODEL}element KikuchiBearing 1 1 2 {}\n", KIKUCHI.replace(good, bad)));
        assert!(status == Some(2) && words.iter().all(|w| err.contains(w)), "{bad}: {status:?}\n{err}");
    }
    let together = format!("{MODEL}element KikuchiBearing 1 1 3 {KIKUCHI}\n");
    assert_eq!(run(&together).0, Some(2));
    for (good, bad, words) in [
        ("-mat 2", "-mat 9", "there is no uniaxial material 9"),
        ("-size 0.8", "-size 0", "is 0"),
        ("-mat 2", "", "-mat is missing"),
    ] {
        let line = format!("{MODEL}element multipleNormalSpring 1 1 2 5 {}\n", NORMAL.replace(good, bad));
        let (status, _, err) = run(&line);
        assert!(status == Some(2) && err.contains(words), "{bad}: {status:?}\n{err}");
    }
}

#[test]
fn warned() {
    for (good, bad, words) in [
        ("-limDisp 0.05", "", "4 times as stiff as one"),
        ("-orient 0 1 0", "-noTlt -orient 0 1 0", "did you mean \"-noTilt\"?"),
    ] {
        let (status, _, err) = run(&format!("{MODEL}element KikuchiBearing 1 1 2 {}\n", KIKUCHI.replace(good, bad)));
        assert!(status == Some(0) && err.contains(words), "{bad}: {status:?}\n{err}");
    }
}
