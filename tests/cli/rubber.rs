//! Parameters of rubber bearings and of pounding that cannot be: message, place, admissible range.

use super::run;

/// Two nodes in space, one over the other.
const SPACE: &str = "model BasicBuilder -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 0.3\nuniaxialMaterial Elastic 1 100.\n";

/// The mistake, its column, words of the message.
const REFUSED: &[(&str, usize, &[&str])] = &[
    ("uniaxialMaterial AxialSp 2 0 1 -1", 28, &["stiffness sce in compression is 0", "greater than 0"]),
    ("uniaxialMaterial AxialSp 2 1000 -1 -1", 33, &["stress fty at cavitation is -1", "not less than 0"]),
    ("uniaxialMaterial AxialSp 2 1000 1 1", 35, &["fcy is 1", "not greater than 0"]),
    ("uniaxialMaterial AxialSp 2 1000 1 -30 1.5", 39, &["bte", "is 1.5", "from 0 to 1"]),
    ("uniaxialMaterial AxialSp 2 1000 1 -30 0.5 0.6", 43, &["bty", "is 0.6", "from 0 to 0.5"]),
    ("uniaxialMaterial AxialSp 2 1000 1 -30 0.5 0.1 -1", 47, &["bcy", "is -1", "from 0 to 1"]),
    ("uniaxialMaterial AxialSp 2 1000 1 -30 0.5 0.1 0.1 -40", 51, &["fcr", "is -40", "from -30 to 0"]),
    ("uniaxialMaterial AxialSpHD 2 1000 1 -30 0.5 0.1 0.05", 49, &["bth", "is 0.05", "from 0.1 to 0.5"]),
    ("uniaxialMaterial AxialSpHD 2 1000 1 -30 0.5 0.1 0.5", 49, &["bth is 0.5", "between bty"]),
    ("uniaxialMaterial AxialSpHD 2 1000 1 -30 0.5 0.1 0.2 0.1 0 0.5", 59, &["ath", "is 0.5", "at least 1"]),
    ("uniaxialMaterial KikuchiAikenHDR 2 X0.5 1 1", 36, &["unknown compound \"X0.5\"", "X0.6", "did you mean"]),
    ("uniaxialMaterial KikuchiAikenHDR 2 7 1 1", 36, &["unknown compound \"7\""]),
    ("uniaxialMaterial KikuchiAikenHDR 2 1 -0.5 1", 38, &["area ar of the rubber is -0.5", "greater than 0"]),
    ("uniaxialMaterial KikuchiAikenHDR 2 1 0.5 0", 42, &["thickness hr of the rubber is 0"]),
    ("uniaxialMaterial KikuchiAikenHDR 2 1 0.5 1 -coGH 1 1", 44, &["did you mean \"-coGHU\"?"]),
    ("uniaxialMaterial KikuchiAikenHDR 2 1 0.5 1 -coGHU 1 -1 1", 53, &["factor ch of the damping is -1"]),
    ("uniaxialMaterial KikuchiAikenHDR 2 1 0.5 1 -coMSS 1", 1, &["factor rf of the force is missing"]),
    ("uniaxialMaterial KikuchiAikenLRB 2 2 1 1 1 1 1 1 13", 36, &["type of bearing is 2", "expected 1"]),
    ("uniaxialMaterial KikuchiAikenLRB 2 1 1 1 0 1 1 1 13", 42, &["shear modulus gr of the rubber is 0"]),
    ("uniaxialMaterial KikuchiAikenLRB 2 1 1 1 1 1 1 1 1", 50, &["beta is 1", "greater than 1"]),
    ("uniaxialMaterial ImpactMaterial 2 100 200 -1 -1", 39, &["K2 is 200", "from 0 to K1, 100"]),
    ("uniaxialMaterial HertzDamp 2 100 0.4 -0.1 0.5", 43, &["exponent n is 0.5", "at least 1"]),
    ("uniaxialMaterial JankowskiImpact 2 100 0.4 -3 -0.1", 44, &["effective mass mEff is -3"]),
    ("element multipleShearSpring 1 1 2 0 -mat 1", 35, &["number nSpring of springs is 0", "at least 1"]),
    ("element multipleShearSpring 1 1 2 8", 35, &["-mat is missing"]),
    ("element multipleShearSpring 1 1 2 8 -mat 3", 42, &["there is no uniaxial material 3", "defined: 1"]),
    ("element multipleShearSpring 1 1 2 8 -mat 1 -mat 1", 44, &["given twice"]),
    ("element multipleShearSpring 1 1 2 3 -nMat 1 1 -lim 1", 47, &["tag of a uniaxial material is not a whole number"]),
    ("element multipleShearSpring 1 1 2 8 -mat 1 -limDisp 1", 44, &["unknown option \"-limDisp\""]),
    ("element multipleShearSpring 1 1 2 8 -mat 1 -lim -1", 49, &["-1", "not less than 0"]),
    ("element MSS 1 1 2 8 -mat 1 -orient 0 0 1", 28, &["parallel"]),
    ("element MSS 1 1 2 8 -mat 1 -mass 0", 34, &["mass is 0", "greater than 0"]),
    ("element YamamotoBiaxialHDR 1 1 2 2 0.7 0.02 0.16", 34, &["no compound 2", "expected 1"]),
    ("element elastomericBearingBoucWen 1 1 2 100 1 0.1 0.1 0.5", 55, &["mu is 0.5", "at least 1"]),
    ("element YamamotoBiaxialHDR 1 1 2 1 0.7 0.8 0.16", 40, &["inner diameter is 0.8", "less than dDo, 0.7"]),
    ("element YamamotoBiaxialHDR 1 1 2 1 0.7 0.02 0", 45, &["thickness hr of the rubber is 0"]),
    ("element YamamotoBiaxialHDR 1 1 2 1 0.7 0.02 0.16 -coRS 1 0", 58, &["factor cs of tau_s is 0"]),
    ("element YamamotoBiaxialHDR 1 1 2 1 0.7 0.02 0.16 -coSR 1 1", 50, &["did you mean \"-coRS\"?"]),
];

#[test]
fn refused() {
    let line = SPACE.lines().count() + 1;
    let wrong: Vec<String> = REFUSED
        .iter()
        .filter_map(|(mistake, column, words)| {
            let (status, _, err) = run(&format!("{SPACE}{mistake}\n"));
            let place = format!("m.tcl:{line}:{column}\n");
            let good = status == Some(2) && err.contains(&place) && words.iter().all(|w| err.contains(w));
            (!good).then(|| format!("{mistake}: {status:?}\n{err}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A law that is sheared far beyond the tests that it was fitted to says so, instead of a force without meaning.
#[test]
fn shear_beyond_the_fit() {
    let script = "model BasicBuilder -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1\n\
        uniaxialMaterial KikuchiAikenHDR 1 X0.6 0.5 0.15; element zeroLength 1 1 2 -mat 1 -dir 1\n\
        timeSeries Linear 1; pattern Plain 1 1 { sp 2 1 0.1 }\n\
        constraints Transformation; integrator LoadControl 1.0; algorithm Newton; analysis Static\n\
        analyze 20\n";
    let (status, _, err) = run(script);
    assert_eq!(status, Some(1), "{err}");
    assert!(err.contains("far beyond what the law was fitted to, 4.1"), "{err}");
}
