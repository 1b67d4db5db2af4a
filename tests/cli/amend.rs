//! `amend`: physics added to the elements of a script.

use super::run;

/// A spring that is pulled to 0.02 and back, with its force put out at both ends of the way.
fn pulled(amendment: &str) -> (Option<i32>, String, String) {
    run(&format!(
        "model basic -ndm 1 -ndf 1\nnode 1 0\nnode 2 0\nfix 1 1\nuniaxialMaterial Elastic 1 1000.\n\
         element zeroLength 1 1 2 -mat 1 -dir 1\ntimeSeries Path 1 -dt 1. -values {{0 0.01 0.02 0.01 0}} -useLast\n\
         pattern Plain 1 1 {{ sp 2 1 1. }}\nrecorder Element -file f.out -ele 1 force\n{amendment}\n\
         constraints Transformation\ntest NormDispIncr 1e-10 20\nalgorithm Newton\nintegrator LoadControl 1.\n\
         analysis Static\nforeach i {{1 2 3}} {{ analyze 1; puts -nonewline \"[format %.6g [eleForce 1 2]] \" }}\n\
         puts [format %.6g [lindex [eleResponse 1 basicForce] 0]]\n"
    ))
}

#[test]
fn the_force_is_amended_and_so_is_what_recorders_show() {
    let (code, out, err) = pulled("amend element 1 yielding -force 15.");
    assert_eq!((code, out.as_str()), (Some(0), "10 15 5 5\n"), "{err}");
    let (code, out, err) = pulled("amend element 1 temperature -softening 0.01 -at 0 -reference 0 -share 500 0");
    assert_eq!((code, out.as_str()), (Some(0), "10 20 10 10\n"), "{err}");
    // What does not yield has no strength to lose.
    let (code, out, err) =
        pulled("amend element 1 temperature -softening 0.01 -at 50 -reference 0 -strengthBeside 500");
    assert_eq!((code, out.as_str()), (Some(0), "10 20 10 10\n"), "{err}");
    for (line, says) in [
        ("mullins -virgin 0.2 -onset 0.01 -strengthBeside 500", "has no -strengthBeside"),
        (
            "temperature -softening 0.01 -at 0 -reference 0 -share 500 0 -strengthBeside 500",
            "-share or -strengthBeside",
        ),
    ] {
        let (code, _, err) = pulled(&format!("amend element 1 {line}"));
        assert!(code == Some(2) && err.contains(says), "{code:?} {err}");
    }
    // What depends on time takes that of the domain.
    let (code, out, err) = pulled("amend element 1 sliding -force 5. -speed 0.0075");
    assert_eq!((code, out.as_str()), (Some(0), "14 24 6 6\n"), "{err}");
    let (code, out, err) = pulled("amend element 1 relaxation -strength 0.5 -time 1.");
    assert_eq!((code, out.as_str()), (Some(0), "13.1606 24.3233 8.42986 8.42986\n"), "{err}");
    let (code, out, err) = pulled("amend element 1 bristles -force 5. -stiffness 1000.");
    assert_eq!((code, out.as_str()), (Some(0), "14.3233 24.9084 6.34096 6.34096\n"), "{err}");
    // The compression as a load cell recorded it.
    let history = "{Path -dt 1. -values {2 1 3 0.5} -useLast}";
    let (code, out, err) = pulled(&format!("amend element 1 pressure -reference 2. -axialSeries {history}"));
    assert_eq!((code, out.as_str()), (Some(0), "5 30 2.5 2.5\n"), "{err}");
    // One around the other: the second sees the force of the first.
    let (code, out, err) = pulled("amend element 1 yielding -force 15.\namend element 1 stiffening -factor 1e4");
    assert_eq!((code, out.as_str()), (Some(0), "11 19 6 6\n"), "{err}");
}

/// Recorders show the whole deformation, with the part that slack or a lost strength takes up.
#[test]
fn the_deformation_is_that_of_the_whole() {
    for amendment in [
        "temperature -softening 0.01 -at 50 -reference 0 -strengthBeside 100",
        "slip -size 0.004 -width 1. -share 100 1",
    ] {
        let (code, out, err) = pulled(&format!(
            "amend element 1 {amendment}\nrename analyze step\n\
             proc analyze n {{ step $n; puts -nonewline \"[format %.6g [eleResponse 1 deformation]]: \" }}"
        ));
        let shown: Vec<&str> = out.split_whitespace().filter_map(|w| w.strip_suffix(':')).collect();
        assert_eq!((code, &shown[..]), (Some(0), &["0.01", "0.02", "0.01"][..]), "{out} {err}");
    }
}

/// A column whose foot yields, drawn from its head: P-Delta, with what recorders show of the hinge.
#[test]
fn the_foot_of_a_column_yields() {
    let (code, out, err) = run("model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 3\nfix 1 1 1 1\n\
         geomTransf PDelta 1\nelement elasticBeamColumn 1 2 1 1. 1e4 0.1 1\n\
         uniaxialMaterial Steel01 3 6. 4e4 0.01\namend element 1 hinges -mat 3 -end j\n\
         timeSeries Linear 1\npattern Plain 1 1 { sp 2 1 0.03 }\nconstraints Transformation\n\
         test NormDispIncr 1e-10 20\nalgorithm Newton\nintegrator LoadControl 1.\nanalysis Static\nanalyze 1\n\
         puts [format %.10g [lindex [eleResponse 1 hingeRotation] 0]]\nputs [format %.10g [lindex [eleResponse 1 force] 5]]\n");
    // Drift 0.01 = m h/(3EI) + theta, m = 6 + 400 (theta - 6/4e4). The rotation of the node against the end of the beam has
    // the sign of m.
    let theta = (0.01 - (6.0 - 400.0 * 6.0 / 4e4) * 3.0 / 3e3) / (1.0 + 400.0 * 3.0 / 3e3);
    let m = 6.0 + 400.0 * (theta - 6.0 / 4e4);
    let expected = format!("{theta:.6} {m:.6}");
    let numbers: Vec<f64> = out.split_whitespace().filter_map(|w| w.parse().ok()).collect();
    let said = numbers.iter().map(|x| format!("{x:.6}")).collect::<Vec<_>>().join(" ");
    assert_eq!((code, said), (Some(0), expected), "{err}");
}

/// A mass moved to another node decays as before.
#[test]
fn a_mass_that_is_moved_keeps_its_damping() {
    let decay = |moved: &str| {
        let (code, out, err) = run(&format!(
            "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 3 -mass 2. 2. 0\nfix 1 1 1 1\n\
             geomTransf Linear 1\nelement elasticBeamColumn 1 1 2 1. 1e4 0.1 1\nrayleigh 0.8 0 0 0\n{moved}\n\
             timeSeries Path 1 -dt 1. -values {{0 1 0}}\npattern Plain 1 1 {{ load 2 9. 0 0 }}\nconstraints Transformation\n\
             system FullGeneral\nalgorithm Linear\nintegrator Newmark 0.5 0.25\nanalysis Transient\nanalyze 500 0.01\n\
             puts [format %.9g [nodeDisp 2 1]]\n"
        ));
        assert_eq!(code, Some(0), "{err}");
        out
    };
    let beside = "node 3 0 3\nmass 3 2. 2. 0\nmass 2 0 0 0\nrigidLink beam 2 3\n";
    assert_eq!(decay(""), decay(&format!("{beside}amend node 3 dampedAs 2")));
    assert_ne!(decay(""), decay(beside));
}

/// An element without end moments gets no hinges. A truss in space has as many degrees of freedom as a plane beam.
#[test]
fn only_beams_get_hinges() {
    for (dimensions, element, message) in [
        ("-ndm 3 -ndf 3", "corotTruss 1 1 2 1. 1", "does not stand between two nodes with rotations"),
        ("-ndm 3 -ndf 6", "corotTruss 1 1 2 1. 1", "carries no moment"),
        ("-ndm 3 -ndf 6", "truss 1 1 2 1. 1", "is amended by direction"),
        ("-ndm 2 -ndf 3", "twoNodeLink 1 1 2 -mat 1 1 -dir 1 2", "is amended by direction"),
    ] {
        let apart = if dimensions.contains("-ndm 3") { "1 2 3" } else { "1 2" };
        let (code, _, err) = run(&format!(
            "model basic {dimensions}\nnode 1 {}\nnode 2 {apart}\n\
             uniaxialMaterial Elastic 1 9.\nelement {element}\namend element 1 hinges -mat 1\n",
            apart.replace(char::is_numeric, "0")
        ));
        assert!(code == Some(2) && err.contains(message), "{element}: {err}");
    }
}

#[test]
fn mistakes_are_reported() {
    for (command, message) in [
        ("amend element 2 yielding -force 1", "there is no element 2"),
        ("amend element 1 yeilding -force 1", "did you mean \"yielding\"?"),
        ("amend element 1 yielding -hardening 0.1", "-force $value is missing"),
        ("amend element 1 yielding -force -1", "yield force is -1"),
        ("amend element 1 yielding -force 1 -hardening 1", "a number from 0 to below 1"),
        ("amend element 1 yielding -forse 1", "did you mean \"-force\"?"),
        ("amend element 1 yielding -force 1 -dir 2", "has no direction 2; it has 1"),
        ("amend section 1 yielding", "unknown thing to amend"),
        ("amend node 1 yielding", "unknown amendment of a node"),
        ("amend node 1 dampedAs 8", "there is no node 8"),
        ("amend element 1 hinges -mat 1", "does not stand between two nodes with rotations"),
        ("amend element 1 hinges", "-mat $mat is missing"),
        ("amend element 1 hinges -mat 1 -end k", "unknown end"),
        ("amend element 1 pressure -reference 1. -axialSeries 9", "there is no time series 9"),
        ("amend element 1 hinges -mat 7", "there is no uniaxial material 7"),
        ("amend element 1 hinges -mta 1", "did you mean \"-mat\"?"),
    ] {
        let (code, _, err) = pulled(command);
        assert!(code == Some(2) && err.contains(message), "{command}: {err}");
    }
    let (code, _, err) = pulled(
        "constraints Transformation\nintegrator LoadControl 1.\nanalysis Static\nanalyze 1\n\
         amend element 1 yielding -force 1.",
    );
    assert!(code == Some(2) && err.contains("amend it before the first analysis"), "{err}");
}
