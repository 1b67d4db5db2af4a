//! Elastic beams that are evaluated side by side, and matrices kept for all of them, against ways that take each by itself.

use super::script::run;

/// Two bays by one of two storeys in space with P-Delta columns, loads on beams, masses along the members and damping by the
/// initial stiffness, shaken: displacements and forces at the end.
fn frame(beam: &str, rayleigh: &str) -> Vec<f64> {
    run(&format!(
        "model basic -ndm 3 -ndf 6
        for {{set k 0}} {{$k < 3}} {{incr k}} {{ for {{set i 0}} {{$i < 3}} {{incr i}} {{ for {{set j 0}} {{$j < 2}} {{incr j}} {{
            node [expr 100*$k + 10*$i + $j] [expr 5.*$i] [expr 6.*$j] [expr 3.2*$k] }} }} }}
        fixZ 0. 1 1 1 1 1 1
        section Elastic 1 2.1e8 0.012 1.4e-4 2.5e-4 8e7 3e-6
        geomTransf PDelta 1 1 0 0; geomTransf Linear 2 0 0 1
        beamIntegration Lobatto 1 1 3
        proc member {{tag i j t}} {{ element {beam} }}
        set e 0
        for {{set k 0}} {{$k < 2}} {{incr k}} {{ for {{set i 0}} {{$i < 3}} {{incr i}} {{ for {{set j 0}} {{$j < 2}} {{incr j}} {{
            set n [expr 100*$k + 10*$i + $j]; member [incr e] $n [expr $n + 100] 1 }} }} }}
        set beams {{}}
        for {{set k 1}} {{$k < 3}} {{incr k}} {{
            for {{set i 0}} {{$i < 3}} {{incr i}} {{ set n [expr 100*$k + 10*$i]; member [incr e] $n [expr $n + 1] 2; lappend beams $e }}
            for {{set i 0}} {{$i < 2}} {{incr i}} {{ for {{set j 0}} {{$j < 2}} {{incr j}} {{
                set n [expr 100*$k + 10*$i + $j]; member [incr e] $n [expr $n + 10] 2; lappend beams $e }} }} }}
        timeSeries Linear 1; timeSeries Trig 2 0. 10. 0.7 -factor 4.
        pattern Plain 1 1 {{ eleLoad -ele {{*}}$beams -type -beamUniform 2. -40. 1.; load 211 20. 10. -900. 0. 0. 0. }}
        constraints Transformation; numberer RCM; system UmfPack; test NormDispIncr 1e-12 20; algorithm Newton
        integrator LoadControl 0.5; analysis Static; analyze 2; loadConst -time 0.
        wipeAnalysis; rayleigh {rayleigh}
        pattern UniformExcitation 2 1 -accel 2; pattern UniformExcitation 3 2 -accel 2
        constraints Transformation; numberer RCM; system UmfPack; test NormDispIncr 1e-12 20; algorithm Newton
        integrator Newmark 0.5 0.25; analysis Transient; analyze 60 0.02
        puts \"[nodeDisp 211] [nodeVel 200] [eleResponse 1 force] [eleResponse 15 force] [eleResponse 20 localForce]\""
    ))
    .done()
    .numbers()
}

/// Elastic sections at the points of a force-based beam give the same member, one by one.
#[test]
fn beams_side_by_side_are_those_one_by_one() {
    for rayleigh in ["0.4 0. 0.003 0.", "0.4 0.003 0. 0.", "0.4 0. 0. 0.003"] {
        let together = frame("elasticBeamColumn $tag $i $j 0.012 2.1e8 8e7 3e-6 2.5e-4 1.4e-4 $t -mass 1.5", rayleigh);
        let apart = frame("forceBeamColumn $tag $i $j $t 1 -mass 1.5", rayleigh);
        let peak = apart.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        assert!(together.len() == apart.len() && peak > 100.0, "{together:?}");
        // Displacements are small beside forces.
        let near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-9 * b.abs().max(1e-9 * peak);
        assert!(together.iter().zip(&apart).all(near), "{rayleigh}: {together:?} {apart:?}");
    }
}

/// Cantilevers that do not know of each other: any number of them moves as each does by itself.
#[test]
fn any_number_of_beams_is_as_one() {
    let tips = |space: bool, first: usize, last: usize| {
        let (dims, zero, turns) = if space { ("-ndm 3 -ndf 6", "0.", "1 0 0") } else { ("-ndm 2 -ndf 3", "", "") };
        let (held, mass) = if space { ("1 1 1 1 1 1", "2 2 2 .1 .1 .1") } else { ("1 1 1", "2 2 .1") };
        let load = if space { "20 10 -90 0 0 0" } else { "20 -90 0" };
        let section = if space { "0.012 2.1e8 8e7 3e-6 2.5e-4 1.4e-4" } else { "0.012 2.1e8 2.5e-4" };
        run(&format!(
            "model basic {dims}; geomTransf PDelta 1 {turns}; timeSeries Trig 1 0 10 0.7
            for {{set i {first}}} {{$i <= {last}}} {{incr i}} {{
                node $i $i 0. {zero}; node 10$i $i {zero} [expr {{3 + .1*$i}}]; mass 10$i {mass}; fix $i {held}
                element elasticBeamColumn $i $i 10$i {section} 1 }}
            pattern Plain 1 1 {{ for {{set i {first}}} {{$i <= {last}}} {{incr i}} {{ load 10$i {load} }} }}
            constraints Plain; numberer Plain; system BandGeneral; test NormDispIncr 1e-12 20; algorithm Newton
            integrator Newmark 0.5 0.25; analysis Transient; analyze 30 0.02
            for {{set i {first}}} {{$i <= {last}}} {{incr i}} {{ puts \"[nodeDisp 10$i] [eleForce $i]\" }}"
        ))
        .done()
        .numbers()
    };
    for space in [false, true] {
        let alone: Vec<Vec<f64>> = (1..=11).map(|i| tips(space, i, i)).collect();
        for count in 1..=11 {
            let (all, each) = (tips(space, 1, count), alone[..count].concat());
            assert_eq!(all.len(), each.len());
            for (a, b) in all.iter().zip(&each) {
                assert!((a - b).abs() <= 1e-9 * b.abs().max(1e-6), "{count}: {all:?} {each:?}");
            }
        }
    }
}

/// Cantilevers that do not know of each other, the supports of which get a velocity: they damp as one does by itself, though
/// only the many have a damping matrix of their equations.
#[test]
fn a_velocity_of_supports_damps_many_as_it_does_one() {
    let tip = |columns: usize| {
        run(&format!(
            "model basic -ndm 2 -ndf 3; geomTransf Linear 1
            for {{set i 1}} {{$i <= {columns}}} {{incr i}} {{
                node $i $i 0.; node 10$i $i 3.; fix $i 1 1 1; mass 10$i 5. 5. 0.
                element elasticBeamColumn $i $i 10$i 0.01 2.1e8 1e-4 1 }}
            rayleigh 0. 0. 0.02 0.
            for {{set i 1}} {{$i <= {columns}}} {{incr i}} {{ setNodeVel $i 1 3. -commit; setNodeVel 10$i 1 -1. -commit }}
            constraints Plain; numberer Plain; system UmfPack; test NormDispIncr 1e-12 20; algorithm Newton
            integrator Newmark 0.5 0.25; analysis Transient; analyze 20 0.01
            puts \"[nodeDisp 101] [nodeVel 101]\""
        ))
        .done()
        .numbers()
    };
    let (one, many) = (tip(1), tip(9));
    assert!(one[0].abs() > 1e-3, "{one:?}");
    assert!(one.iter().zip(&many).all(|(a, b)| (a - b).abs() <= 1e-11 * one[0].abs()), "{one:?} {many:?}");
}

/// The clock goes back and the supports get a velocity: what was seen of the motion at that time before no longer holds.
#[test]
fn a_velocity_counts_at_a_time_that_comes_again() {
    let tip = |columns: usize| {
        run(&format!(
            "model basic -ndm 2 -ndf 3; geomTransf Linear 1
            for {{set i 1}} {{$i <= {columns}}} {{incr i}} {{
                node $i $i 0.; node 10$i $i 3.; fix $i 1 1 1; mass 10$i 5. 5. 0.
                element elasticBeamColumn $i $i 10$i 0.01 2.1e8 1e-4 1 }}
            rayleigh 0. 0. 0.02 0.
            constraints Plain; numberer Plain; system UmfPack; test NormDispIncr 1e-12 20; algorithm Newton
            integrator Newmark 0.5 0.25; analysis Transient; analyze 1 0.01; setTime 0.
            for {{set i 1}} {{$i <= {columns}}} {{incr i}} {{ setNodeVel $i 1 3. -commit; setNodeVel 10$i 1 -1. -commit }}
            analyze 1 0.01
            puts \"[nodeDisp 101] [nodeVel 101]\""
        ))
        .done()
        .numbers()
    };
    let (one, many) = (tip(1), tip(9));
    assert!(one[0].abs() > 1e-4, "{one:?}");
    assert!(one.iter().zip(&many).all(|(a, b)| (a - b).abs() <= 1e-11 * one[3].abs()), "{one:?} {many:?}");
}
