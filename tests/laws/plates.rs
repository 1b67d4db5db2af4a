//! Shells and bricks against closed forms.

use super::script::run;

/// Deflection of a square plate of side `2 a` with held edges under a force in the middle, by a quarter of it.
fn plate(kind: &str, section: &str) -> f64 {
    let n = 8;
    let triangles = kind == "ShellDKGT";
    let mut elements = String::new();
    let mut tag = 0;
    for j in 0..n {
        for i in 0..n {
            let at = |i: usize, j: usize| 1 + i + j * (n + 1);
            let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)].map(|t| t.to_string());
            let parts: Vec<Vec<usize>> =
                if triangles { vec![vec![0, 1, 2], vec![0, 2, 3]] } else { vec![vec![0, 1, 2, 3]] };
            for part in parts {
                tag += 1;
                let nodes: Vec<&str> = part.iter().map(|&c| corners[c].as_str()).collect();
                elements += &format!("element {kind} {tag} {} 1\n", nodes.join(" "));
            }
        }
    }
    run(&format!(
        "model basic -ndm 3 -ndf 6
        for {{set j 0}} {{$j <= {n}}} {{incr j}} {{ for {{set i 0}} {{$i <= {n}}} {{incr i}} {{
            set t [expr {{1 + $i + $j*({n} + 1)}}]
            node $t [expr {{1.0*$i/{n}}}] [expr {{1.0*$j/{n}}}] 0
            set edge [expr {{$i == {n} || $j == {n}}}]
            fix $t 1 1 $edge [expr {{$edge || $j == 0}}] [expr {{$edge || $i == 0}}] 1
        }} }}
        {section}
        {elements}
        timeSeries Linear 1
        pattern Plain 1 1 {{ load 1 0 0 0.25 0 0 0 }}
        constraints Plain; numberer RCM; system BandGeneral; test NormUnbalance 1e-10 5; algorithm Newton
        integrator LoadControl 1.; analysis Static
        analyze 1
        puts [nodeDisp 1 3]"
    ))
    .numbers()[0]
}

/// A clamped square plate with a force in the middle deflects by 0.00560 P L² / D (Timoshenko and Woinowsky-Krieger, 1959,
/// table 37).
#[test]
fn clamped_plate_under_a_force() {
    let (e, nu, h) = (1e6f64, 0.3, 0.02f64);
    let expected = 0.00560 * 4.0 / (e * h.powi(3) / 12.0 / (1.0 - nu * nu));
    let sections = [
        format!("section ElasticMembranePlateSection 1 {e} {nu} {h}"),
        format!("nDMaterial ElasticIsotropic 1 {e} {nu}; section PlateFiber 1 1 {h}"),
    ];
    for kind in ["ShellMITC4", "ShellDKGQ", "ShellDKGT"] {
        for section in &sections {
            let error = plate(kind, section) / expected - 1.0;
            assert!(error.abs() < 0.03, "{kind}, {section}: {error}");
        }
    }
}

/// Bricks in uniform extension: strain and contraction are those of the material.
#[test]
fn bricks_in_uniform_extension() {
    let u = run("model basic -ndm 3 -ndf 3
        nDMaterial ElasticIsotropic 1 200. 0.25 3.
        block3D 2 3 2 1 1 stdBrick {1 0 0 0} {1 0 0 0 2 2 0 0 3 2 3 0 4 0 3 0 5 0 0 1 6 2 0 1 7 2 3 1 8 0 3 1}
        fixX 0. 1 0 0; fixY 0. 0 1 0; fixZ 0. 0 0 1
        timeSeries Linear 1
        pattern Plain 1 1 { for {set t 1} {$t <= 36} {incr t} { if {[nodeCoord $t 1] == 2} {
            set share 1.0
            foreach {d last} {2 3 3 1} { if {[nodeCoord $t $d] == 0 || [nodeCoord $t $d] == $last} { set share [expr {$share/2}] } }
            load $t [expr {6.0*$share*3.0/3*1.0/2}] 0 0
        } } }
        constraints Plain; numberer RCM; system BandGeneral; test NormUnbalance 1e-10 5; algorithm Newton
        integrator LoadControl 1.; analysis Static
        analyze 1
        puts [nodeDisp 36]; puts [lrange [eleResponse 12 stresses] 0 5]")
    .numbers();
    let strain = 6.0 / 200.0;
    let expected = [2.0 * strain, -0.25 * 3.0 * strain, -0.25 * strain, 6.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert!(u.iter().zip(expected).all(|(u, e)| (u - e).abs() < 1e-9), "{u:?}");
}

/// The stresses of the layers times their thickness are the forces of the section, after yield too.
#[test]
fn layers_carry_the_forces_of_the_section() {
    for kind in ["ShellMITC4", "ShellNLDKGQ", "ASDShellQ4"] {
        let ran = run(&format!(
            "model basic -ndm 3 -ndf 6
            node 1 0 0 0\nnode 2 1 0 0\nnode 3 1 1 0\nnode 4 0 1 0
            uniaxialMaterial Steel01 1 2. 200. 0.02
            nDMaterial ElasticIsotropic 2 30. 0.2\nnDMaterial PlateFiber 3 2\nnDMaterial PlateRebar 4 1 0.
            section LayeredShell 1 3 3 0.1 4 0.02 3 0.1
            element {kind} 1 1 2 3 4 1
            foreach n {{1 2 3 4}} {{ fix $n 0 0 1 1 1 1 }}
            fix 1 1 1 0 0 0 0\nfix 4 1 0 0 0 0 0\nfix 2 0 1 0 0 0 0
            timeSeries Linear 1\npattern Plain 1 1 {{ sp 2 1 0.03\nsp 3 1 0.03 }}
            constraints Transformation\ntest NormUnbalance 1e-12 50\nintegrator LoadControl 0.1\nanalysis Static\nanalyze 10
            foreach i {{1 2 3}} {{ puts [lindex [eleResponse 1 Material 1 fiber $i stresses] 0] }}
            puts [lindex [eleResponse 1 Material 1 fiber 2 strains] 0]
            puts [lindex [eleResponse 1 section 1 force] 0]"
        ));
        let n = ran.done().numbers();
        // Its strains are the sum of those of the steps, each by the length at its start.
        let of_steps: f64 = (0..10).map(|i| 0.003 / (1.0 + 0.003 * f64::from(i))).sum();
        let strain = if kind == "ShellNLDKGQ" { of_steps } else { 0.03 };
        assert!((n[3] - strain).abs() < 1e-9, "{kind}: {n:?}");
        let bar = 2.0 + 0.02 * 200.0 * (n[3] - 0.01);
        assert!((n[1] - bar).abs() < 1e-9, "{kind}: {n:?}, {bar}");
        let sum = 0.1 * n[0] + 0.02 * n[1] + 0.1 * n[2];
        assert!((sum - n[4]).abs() < 1e-9 * sum.abs(), "{kind}: {n:?}, {sum}");
    }
}

/// `fiberData2` has the material of each fiber before its stress and strain.
#[test]
fn fibers_name_their_materials() {
    let ran = run("model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 0\nfix 1 1 1 1\nfix 2 0 1 0
        uniaxialMaterial Elastic 7 200.\nuniaxialMaterial Elastic 9 50.
        section Fiber 1 {\nfiber 0.1 0 0.01 7\nfiber -0.1 0 0.02 9\n}
        element zeroLengthSection 1 1 2 1
        timeSeries Linear 1\npattern Plain 1 1 { sp 2 1 0.001\nsp 2 3 0.0 }
        constraints Transformation\nintegrator LoadControl 1.\nanalysis Static\nanalyze 1
        puts [eleResponse 1 section fiberData2]");
    let n = ran.done().numbers();
    assert_eq!((n[0], n[2], n[3]), (0.1, 0.01, 7.0));
    assert_eq!((n[6], n[8], n[9]), (-0.1, 0.02, 9.0));
    assert!((n[4] - 0.2).abs() < 1e-9 && (n[10] - 0.05).abs() < 1e-9 && (n[5] - 0.001).abs() < 1e-12, "{n:?}");
}
