//! A mistake in a line after a good model, where the message points, and what it says.

use super::{MODEL, Place, run};

/// Line, column, words of the message.
const REFUSED: &[(&str, usize, &[&str])] = &[
    ("node", 1, &["the tag of the node is missing", "usage: node"]),
    ("node x 0 0", 6, &["not a whole number: \"x\""]),
    ("node 1 0 0", 6, &["there is a node 1 already", "expected a new tag"]),
    ("node 9 0 nan", 10, &["y coordinate is not a number"]),
    ("node 9 0 inf", 10, &["y coordinate is not finite"]),
    ("node 9 0 0 -mass 1 1 -1", 22, &["mass of degree of freedom 3 is -1"]),
    ("node 9 0 0 -ndf 7", 17, &["1 to 6"]),
    ("mass 77 1 1 1", 6, &["there is no node 77", "the nearest tag is 3"]),
    ("mass 1 -1 1 1", 8, &["not less than 0"]),
    ("fix 2 1 1", 1, &["the flag of degree of freedom 3 is missing"]),
    ("fixY 0", 1, &["the flag of degree of freedom 1 is missing"]),
    ("fixY 0 1 1 1 -tol", 1, &["the tolerance is missing"]),
    ("equalDOF 2 3 4", 14, &["1 to 3"]),
    ("rigidLink beem 2 3", 11, &["did you mean \"beam\"?"]),
    ("uniaxialMaterial Elstic 2 100", 18, &["did you mean \"Elastic\"?"]),
    ("uniaxialMaterial Elastic 1 100", 26, &["there is a uniaxial material 1 already"]),
    ("uniaxialMaterial Elastic 2 1e999", 28, &["not finite"]),
    ("uniaxialMaterial Steel01 2 -5 1 1", 28, &["greater than 0"]),
    ("geomTransf Liner 2", 12, &["did you mean \"Linear\"?"]),
    ("geomTransf Linear 1", 19, &["already"]),
    ("element elasticBeamColum 2 1 2 0.1 2e8 1e-3 1", 9, &["did you mean \"elasticBeamColumn\"?"]),
    ("element elasticBeamColumn 2 2 3 0.1 2e8 1e-3 1", 31, &["no length"]),
    ("element elasticBeamColumn 2 1 3 -0.1 2e8 1e-3 1", 33, &["cross-sectional area A is -0.1"]),
    ("element elasticBeamColumn 2 1 3 0.1 0 1e-3 1", 37, &["elastic modulus E is 0"]),
    ("element elasticBeamColumn 2 1 3 0.1 2e8 1e-3 9", 46, &["no geometric transformation 9", "defined: 1"]),
    ("element truss 2 1 3 0 1", 21, &["greater than 0"]),
    ("element truss 2 1 3 1 5", 23, &["there is no uniaxial material 5", "defined: 1"]),
    ("element zeroLength 2 2 3 -mat 1 -dir 7", 38, &["1 to 6"]),
    ("frictionModel Coulomb 1 -0.1", 25, &["coefficient of friction mu is -0.1", "greater than 0"]),
    ("frictionModel VelDependnt 1 0.1 0.2 1", 15, &["did you mean \"VelDependent\"?"]),
    ("frictionModel VelPressureDep 1 0.03 0.09 0 0.02 1 1", 42, &["nominal contact area A is 0"]),
    ("frictionModel VelNormalFrcDep 1 0.1 0.9 0.2 1.1 1 1 1 2", 45, &["nFast is 1.1", "at most 1"]),
    ("frictionModel VelDepMultiLinear 1 -vel 0 2 3 -frn 0.1 0.1", 55, &["3 speeds and 2 coefficients"]),
    ("element flatSliderBearing 2 1 3 5 100 -P 1 -Mz 1", 33, &["there is no friction model 5"]),
    ("pattern Plain 2 9 {}", 17, &["there is no time series 9", "defined: 1"]),
    ("pattern Plain 1 1 {}", 15, &["there is a load pattern 1 already"]),
    ("pattern Plian 2 1 {}", 9, &["did you mean \"Plain\"?"]),
    ("timeSeries Path 2 -dt 0 -values {1 2}", 23, &["greater than 0"]),
    ("timeSeries Path 2 -dt 0.1 -filePath no.txt", 37, &["cannot read \"no.txt\""]),
    ("integrator Newmrk 0.5 0.25", 12, &["did you mean \"Newmark\"?"]),
    ("test NormDispIncr 1e-6 0", 24, &["at least 1"]),
    ("analysis Statik", 10, &["did you mean \"Static\"?"]),
    ("analysis Static; analyze -1", 26, &["the number of steps is -1"]),
    ("analysis Transient; analyze 1 0", 31, &["greater than 0"]),
    ("recorder Nod -file a.txt -node 1 -dof 1 disp", 10, &["did you mean \"Node\"?"]),
    ("pattern Plain x 1 {}", 0, &["\"x\""]),
    ("pattern UniformExcitation 2 1", 0, &["no motion"]),
    ("pattern UniformExcitation 2 9 -accel 1", 29, &["1 to 3"]),
    ("pattern UniformExcitation 2 1 -accel 9", 38, &["there is no time series 9"]),
    ("pattern Plain 2 1 { load 77 1 0 0 }", 26, &["there is no node 77"]),
    ("pattern Plain 2 1 { load 2 1 0 }", 0, &["missing"]),
    ("pattern Plain 2 1 { eleLoad -ele 77 -type -beamUniform 1 }", 34, &["there is no element 77"]),
    ("pattern Plain 2 1 { eleLoad -ele 1 -type -beamUnifrm 1 }", 0, &["did you mean"]),
    ("pattern Plain 2 1 { sp 2 4 1 }", 0, &["1 to 3"]),
    ("imposedMotion 1 1 1", 0, &["MultipleSupport"]),
    ("timeSeries Linear 1", 0, &["there is a time series 1 already"]),
    ("timeSeries Lineer 2", 12, &["did you mean \"Linear\"?"]),
    ("timeSeries Trig 2 0 10 0", 24, &["greater than 0"]),
    ("timeSeries Path 2 -dt 0.1", 0, &["no values"]),
    ("timeSeries Path 2 -values {1 2}", 0, &["no times"]),
    ("timeSeries Path 2 -time {0 1} -values {1 2 3}", 0, &["2 times but 3 values"]),
    ("recorder Node -file a.txt -node 1 -dof 0 disp", 0, &["no degree of freedom 0"]),
    ("recorder Node -file a.txt -node 1 -dof 1 dsp", 42, &["did you mean \"disp\"?"]),
    ("recorder Node -file a.txt -dT -1 -node 1 -dof 1 disp", 31, &["not less than 0"]),
    ("recorder Node -file a.txt -node 1 -dof 1", 1, &["the response is missing"]),
    ("recorder Node -file a.txt -region 5 -dof 1 disp", 35, &["there is no region 5"]),
    ("recorder Element -file a.txt -ele 1", 1, &["the response is missing"]),
    ("recorder Drift -file a.txt -iNode 1 2 -jNode 3 -dof 1 -perpDirn 2", 0, &["2 nodes i but 1 nodes j"]),
    ("constraints Transformtion", 13, &["did you mean \"Transformation\"?"]),
    ("constraints Penalty 1e9", 0, &["missing"]),
    ("numberer RMC", 10, &["did you mean \"RCM\"?"]),
    ("system BandGenral", 8, &["did you mean \"BandGeneral\"?"]),
    ("test NormDispIncr -1 5", 19, &["not less than 0"]),
    ("test NormDispInc 1e-6 5", 6, &["did you mean \"NormDispIncr\"?"]),
    ("algorithm Nwton", 11, &["did you mean \"Newton\"?"]),
    ("integrator Newmark 0.5", 1, &["beta is missing"]),
    ("integrator Newmark 0.5 -1", 24, &["not less than 0"]),
    ("integrator DisplacementControl 2 5 0.1", 34, &["1 to 3"]),
    ("rayleigh 0.1 0 0", 1, &["missing"]),
    ("rayleigh 1e999 0 0 0", 10, &["not finite"]),
    ("region 1 -rayleigh 0.1", 1, &["missing"]),
    ("modalDamping 0.02", 1, &["no modes to damp", "\"eigen\""]),
    ("eigen 0", 7, &["at least 1"]),
    ("fix 3 1 1 1; mass 2 1 1 0; eigen 5", 34, &["expected no more"]),
    ("nodeEigenvector 2 1", 19, &["there is no mode 1", "\"eigen\""]),
    ("remove node 2", 13, &["belongs to element 1"]),
    ("section Fiber 1 { patch quad 1 2000000000 1 0 0 1 0 1 1 0 1 }", 32, &["2000000000 parts", "at most 1000000"]),
    ("section Fiber 1 { patch rect 1 40000 40000 0 0 1 1 }", 38, &["1600000000 parts", "at most 1000000"]),
    ("section Fiber 1 { layer straight 1 2000000000 0.1 0 0 1 1 }", 36, &["at most 1000000"]),
    ("block2D 100000 100000 10 10 quad {1 PlaneStrain 1} {1 0 0 2 1 0 3 1 1 4 0 1}", 16, &["at most 1000000"]),
    ("algorithm BFGS 2000000000", 16, &["at most 1000"]),
    ("algorithm Broyden -count 1001", 26, &["at most 1000"]),
    ("remove elment 1", 8, &["did you mean \"element\"?"]),
    ("eleResponse 1 forc", 15, &["known: "]),
    ("eleForce 9", 10, &["there is no element 9"]),
    ("getLoadFactor 9", 15, &["there is no load pattern 9"]),
    ("nodeVel 1 9", 11, &["1 to 3", "usage: nodeVel"]),
    ("figure f.svg -title t -x x -y y -line l {0 1} {0}", 0, &["2 horizontal values but 1 vertical"]),
    ("figure f.svg -title t -x x -y y -xrange 1 0 -line l {0 1} {0 1}", 0, &["from 1 to 0"]),
    ("columns missing.txt", 9, &["cannot read"]),
    ("uniaxialMaterial ElasticPP 2 1 0", 32, &["is 0"]),
    ("uniaxialMaterial ENT 2 -1", 24, &["not less than 0"]),
    ("uniaxialMaterial BoucWen 2 0.1 0 1 0.5 0.5 1 0 0 0", 32, &["greater than 0"]),
    ("uniaxialMaterial Viscous 2 -1 1", 28, &["not less than 0"]),
    ("nodeDisp 77", 10, &["there is no node 77"]),
    ("nodeDisp 1 4", 12, &["1 to 3"]),
    ("nodDisp 1", 1, &["did you mean \"nodeDisp\"?"]),
    ("set x [expr {1 + }]", 0, &["expr"]),
    ("puts $nothing", 0, &["nothing"]),
    ("exec ls", 0, &["exec"]),
    ("open \"|ls\"", 0, &[]),
    ("socket localhost 80", 0, &["socket"]),
    ("source missing.tcl", 0, &["missing.tcl"]),
    ("proc f {} { f }; f", 0, &["too many nested evaluations"]),
];

const TWO_RECORDERS: &str =
    "recorder Node -file a.txt -node 1 -dof 1 disp; recorder Node -file a.txt -node 1 -dof 1 disp";
const RULE_WITH_NUMBERS: &str = "section Fiber 1 { fiber 0 0 1 1 }; geomTransf Linear 7; \
     element forceBeamColumn 7 1 2 3 1 7 -integration \"Lobatto 1 5\"";

#[test]
fn refused() {
    let line = MODEL.lines().count() + 1;
    let wrong: Vec<String> = REFUSED
        .iter()
        .filter_map(|(mistake, column, words)| {
            let (status, _, err) = run(&format!("{MODEL}{mistake}\n"));
            let place = if *column > 0 { format!("m.tcl:{line}:{column}\n") } else { format!("m.tcl:{line}:") };
            let good = status == Some(2) && err.contains(&place) && words.iter().all(|w| err.contains(w));
            (!good).then(|| format!("{mistake}: {status:?}\n{err}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Warnings let the script go on, come again in a summary at the end, and are errors under `--strict`.
#[test]
fn warned() {
    for (mistake, words) in [
        ("node 9 0 0 -mas 1 1 1", "did you mean \"-mass\"?"),
        ("mass 1 1 1 1 1", "nothing more was expected"),
        ("element zeroLength 2 1 3 -mat 1 -dir 1", "4.000000 apart"),
        ("uniaxialMaterial Elastic 2 -1", "not less than 0"),
        ("uniaxialMaterial ElasticPP 2 1 -1", "taken for 1"),
        ("uniaxialMaterial ElasticPP 2 1 1 1", "taken for -1"),
        ("uniaxialMaterial Viscous 2 1 -1", "taken for 1"),
        ("timeSeries Path 2 -dt 1 -values {1}", "a single value"),
        ("timeSeries Path 2 -time {0 2 1} -values {1 2 3}", "the times go back"),
        ("analysis Static # of the frame", "a comment after a command begins with"),
        ("nodeDisp 1 0", "all values are given"),
        ("timeSeries Rectangular 2 5 1", "greater than 5"),
        ("rayleigh -0.1 0 0 0", "by mass is negative"),
        ("integrator Newmark 0.25 0.5", "the wrong way round"),
        ("analyze 1", "there is no analysis"),
        ("equalDOF 1 1 1", "a node follows itself: nothing is constrained"),
        ("rigidLink beam 1 1", "a node follows itself: nothing is constrained"),
        ("rigidDiaphragm 2 1 3", "rigidDiaphragm: the x of the node differs by 4"),
        ("fix 3 1 1 1; mass 2 1 1 0; eigen -wrong 1", "\"-wrong\" is not an option and is ignored"),
        ("section Fiber 1 { fiber 0 0 0 1; fiber 0.1 0 1 1 }", "the fiber has no area"),
        ("section Fiber 1 { patch circ 1 8 2 0 0 2 1 360 0 }", "both turned round"),
        ("section Fiber 1 -GJ 0 { fiber 0 0 1 1 }", "no torsional stiffness"),
        ("section Elastic 1 2e8 0.1 1e-3 0 0", "no stiffness in shear"),
        ("remove element 9", "there is no element 9"),
        ("remove loadPattern 9", "there is no load pattern 9"),
        ("remove sp 2 1", "there is no such constraint"),
        ("remove node 9", "there is no node 9"),
        ("remove parameter 4", "there is no parameter 4"),
        (TWO_RECORDERS, "another recorder writes a.txt"),
        (RULE_WITH_NUMBERS, "takes the name Lobatto alone"),
    ] {
        let place = Place::new();
        place.write("m.tcl", format!("{MODEL}{mistake}\nputs end\n"));
        let (status, out, err) = place.run(&["run", "m.tcl"]);
        assert!(status == Some(0) && out == "end\n" && err.contains(words), "{mistake}: {err}");
        assert!(err.contains("1 warning:\n  warning: m.tcl:11:"), "{mistake}: {err}");
        let (status, out, _) = place.run(&["run", "--strict", "m.tcl"]);
        assert!(status == Some(2) && out.is_empty(), "{mistake}");
    }
}

/// The handler `Plain` of OpenSees leaves out constraints: a warning says so, except under `--compat`.
#[test]
fn plain_handler() {
    let script = "rigidLink beam 1 3\nconstraints Plain\nintegrator LoadControl 1\nanalysis Static\nanalyze 1\n";
    let place = Place::new();
    place.write("m.tcl", format!("{MODEL}{script}"));
    let (_, _, err) = place.run(&["run", "m.tcl"]);
    assert!(err.contains("Plain leaves out the constraint of node 3 to node 1"), "{err}");
    let (_, _, err) = place.run(&["run", "--compat", "opensees", "m.tcl"]);
    assert!(!err.contains("leaves out"), "{err}");
}

/// The chain of calls stands under the message.
#[test]
fn calls() {
    let place = Place::new();
    place.write("sub.tcl", "proc storey {n} {\n  node $n 0 x\n}\n");
    place.write("m.tcl", "model basic -ndm 2\nsource sub.tcl\nstorey 5\n");
    let (status, _, err) = place.run(&["run", "m.tcl"]);
    assert_eq!(status, Some(2));
    for words in ["sub.tcl:2:", "in proc \"storey\"", "m.tcl:3:1", "called here"] {
        assert!(err.contains(words), "{words}: {err}");
    }
}

/// A file of a record that begins with a header.
#[test]
fn header_of_a_record() {
    let place = Place::new();
    place.write("gm.txt", "PEER RECORD\n0.1 0.2\n");
    place.write("m.tcl", "timeSeries Path 1 -dt 0.01 -filePath gm.txt\n");
    let (status, _, err) = place.run(&["run", "m.tcl"]);
    assert!(status == Some(2) && err.contains("gm.txt:1:1") && err.contains("remove the header"), "{err}");
}
