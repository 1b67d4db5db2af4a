//! High damping rubber through its commands: strain rate, units, temperature, refusals.

use super::script::{Script, run};

/// A bearing under an imposed strain: HDR3 with options, a path of strain over time, steps of time.
fn test_rig(material: &str, times: &str, strains: &str, analysis: &str, wanted: &str) -> Vec<f64> {
    let text = format!(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
        uniaxialMaterial HDRRheology 1 {material}
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Path 1 -time {{{times}}} -values {{{strains}}} -useLast
        pattern Plain 1 1 {{ sp 2 1 1.0 }}
        constraints Transformation; numberer Plain; system BandGeneral; test NormDispIncr 1e-10 20; algorithm Newton
        {analysis}
        foreach w {{{wanted}}} {{ puts [eleResponse 1 material 1 $w] }}"
    );
    run(&text).numbers()
}

const RAMP: (&str, &str) = ("0 0.3181818181818182 1000", "0 1.75 1.75");
const COLD: &str = "-compound HDR3 -temperature -30";

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * b.abs().max(1e-9), "{a}, expected {b}");
}

#[test]
fn strain_rate_uses_the_analysis_time() {
    let wanted = "stress equilibrium overstress strain";
    let load_control = "integrator LoadControl 0.003181818181818182; analysis Static; analyze 100";
    let a = test_rig(COLD, RAMP.0, RAMP.1, load_control, wanted);
    close(a[2], 3.4769, 1e-4);
    close(a[0], a[1] + a[2], 1e-12);
    close(a[3], 1.75, 1e-12);
    // A transient analysis, and one whose time has been set, are no different.
    let transient = "integrator Newmark 0.5 0.25; analysis Transient; analyze 100 0.003181818181818182";
    let b = test_rig(COLD, RAMP.0, RAMP.1, transient, wanted);
    close(b[0], a[0], 1e-9);
    let late = format!("setTime 100.0; {load_control}; loadConst -time 0.0");
    let c = test_rig(COLD, "0 100 100.31818181818182 1000", "0 0 1.75 1.75", &late, wanted);
    close(c[0], a[0], 1e-6);
    // A hold of half an hour in one step.
    let hold = format!("{load_control}; integrator LoadControl 1800; analyze 1");
    close(test_rig(COLD, RAMP.0, RAMP.1, &hold, "overstress")[0], 0.31683, 1e-4);
}

#[test]
fn force_and_displacement() {
    let load_control = "integrator LoadControl 0.003181818181818182; analysis Static; analyze 100";
    let stress = test_rig(COLD, RAMP.0, RAMP.1, load_control, "stress overstress tangent energy");
    let bearing = format!("{COLD} -area 25600 -height 20");
    let force = test_rig(&bearing, RAMP.0, "0 35.0 35.0", load_control, "stress overstress tangent energy");
    for (f, s, factor) in [(0, 0, 25600.0), (1, 1, 25600.0), (2, 2, 1280.0), (3, 3, 512_000.0)] {
        close(force[f], factor * stress[s], 1e-9);
    }
}

#[test]
fn no_time_passes_where_displacement_is_controlled() {
    let ran = run("model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
        uniaxialMaterial HDRRheology 1 -compound HDR3 -temperature 23
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Linear 1; pattern Plain 1 1 { load 2 1.0 }
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-10 20; algorithm Newton
        integrator DisplacementControl 2 1 0.05; analysis Static; analyze 20; analyze 1
        puts [eleResponse 1 material 1 overstress]");
    // The dashpot stays where it is: 0.652 x 1.05 + 0.711.
    close(ran.numbers()[0], 0.652 * 1.05 + 0.711, 1e-9);
    let told: Vec<_> = ran.warnings().iter().filter(|w| w.message.contains("no time passes")).collect();
    assert_eq!(told.len(), 1, "{:?}", ran.warnings());
}

/// Eleven cycles at 1.75 and 0.5 Hz: temperature of rubber by itself and of rubber and steel together (Eqs 5.2, 5.3).
#[test]
fn sinusoidal_loading_heats_the_rubber() {
    let cycles = |material: &str, wanted: &str| {
        let text = format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
            uniaxialMaterial HDRRheology 1 {material}
            element zeroLength 1 1 2 -mat 1 -dir 1
            timeSeries Trig 1 0 22 2; pattern Plain 1 1 {{ sp 2 1 1.75 }}
            constraints Transformation; numberer Plain; system BandGeneral
            test NormDispIncr 1e-10 20; algorithm Newton
            integrator LoadControl 0.01; analysis Static; analyze 2200
            foreach w {{{wanted}}} {{ puts [eleResponse 1 material 1 $w] }}"
        );
        run(&text).numbers()
    };
    // Heat capacities per volume of rubber: 1150 kg/m3 of 1.732 J/gK, in MJ/m3K; and with five plates of 2.3 mm between six layers
    // of 5 mm, 7850 kg/m3 of 0.432 J/gK.
    let rubber = 1.150 * 1.732;
    let composite = rubber + 7.850 * 0.432 * 11.5 / 30.0;
    for (t, alone, together) in [(-30.0, 53.0, 34.0), (23.0, 46.0, 28.0)] {
        for (capacity, expected) in [(rubber, alone), (composite, together)] {
            let options = format!("-compound HDR3 -ambient {t} -heatCapacity {capacity} -beyond hold");
            let rise = cycles(&options, "temperature")[0] - t;
            assert!((rise - expected).abs() < 0.5, "{t} degC: {rise} K for {expected}");
        }
    }
    let hot = cycles(
        &format!("-compound HDR3 -ambient -30 -heatCapacity {rubber} -beyond hold"),
        "temperature heat heatStored heatLost factor",
    );
    close(hot[0], -30.0 + hot[1] / rubber, 1e-9);
    close(hot[2], hot[1], 1e-9);
    assert!(hot[3].abs() < 1e-9 && hot[4] == 1.0);
    let cooled = cycles(
        &format!("-compound HDR3 -ambient -30 -heatCapacity {rubber} -coolingTime 30 -beyond hold"),
        "temperature",
    );
    assert!(cooled[0] > -30.0 && cooled[0] < hot[0] - 5.0);
}

#[test]
fn rubber_that_makes_no_sense_is_refused() {
    for (words, message) in [
        ("HDRRheology 2", "has no parameters"),
        ("HDRRheology 2 -compound HDR4 -temperature 0", "unknown compound \"HDR4\""),
        ("HDRRheology 2 -compound HDR3", "a compound without a temperature"),
        ("HDRRheology 2 -compound HDR3 -temperature 30", "known from -30 to 23 only"),
        ("HDRRheology 2 -compound HDR3 -temperature -30.1", "known from -30 to 23 only"),
        ("HDRRheology 2 7 0.5 0.01 0.4 5 10 0.6 0.7 1.5", "parameter n is missing"),
        ("HDRRheology 2 7 0.5 0.01 0.4 5 10 0.6 0.7 1.5 1.2", "n is 1.2"),
        ("HDRRheology 2 7 0.5 0.01 0.4 0.5 10 0.6 0.7 1.5 0.2", "m is 0.5"),
        ("HDRRheology 2 7 0.5 0.01 0.4 5 10 0.6 0.7 0 0.2", "a is 0"),
        ("HDRRheology 2 -7 0.5 0.01 0.4 5 10 0.6 0.7 1 0.2", "C1eq is -7"),
        ("HDRRheology 2 7 0.5 0.01 0.4 5 10 0.6 0.7 1 0.2 -compound HDR3", "given already"),
        ("HDRRheology 2 -compound HDR3 -temperature 0 -area -1", "area of the bearing is -1"),
        ("HDRRheology 2 -compound HDR3 -temperature 0 -coolingTime 9", "without self-heating"),
        ("HDRRheology 2 -compound HDR3 -temperature 0 -preload 2", "without softening"),
        ("HDRRheology 2 -compound HDR3 -temperature 0 -mullins 0.3 0.4 -heal 1.5 9", "fraction that heals is 1.5"),
        ("HDRRheology 2 -compound HDR3 -temperature 0 -beyond guess", "unknown way beyond the table \"guess\""),
        ("HDRRheology 2 -compound none.txt -temperature 0", "cannot read the compound none.txt"),
        ("Mullins 2 1 0.3 0", "strain over which the excess goes is 0"),
        ("Mullins 2 9 0.3 0.5", "there is no uniaxial material 9"),
    ] {
        let text = format!("uniaxialMaterial Elastic 1 1.0\nuniaxialMaterial {words}");
        let ran = Script::default().run(&text);
        assert!(ran.error().message.contains(message), "{words}: {}", ran.error().message);
    }
    // A table of the user's own; options that are no options; heat that leaves the table.
    let table = "# mine\n0 7 0.5 0.01 0.4 5 10 0.6 0.7 1.5 0.2\n40 6 0.5 0.01 0.3 5 9 0.6 0.7 1.2 0.2\n";
    let text = "uniaxialMaterial HDRRheology 1 -compound mine.txt -temperature 40
        testUniaxialMaterial 1; setStrain 1e-4; puts [expr {[getStress]/1e-4}]";
    let ran = Script::default().with_file("mine.txt", table).run(text).done();
    close(ran.numbers()[0], 6.0 + 0.5 + 9.0 + 0.6, 1e-9);
    for (words, message) in [
        ("-temprature 3 -temperature 0", "did you mean \"-temperature\""),
        ("-temperature 0 -heatCapacity 1.7", "keeps the parameters of 23"),
        ("-temperature 0 -ambient 10", "begins at the -ambient 10"),
    ] {
        let ran = run(&format!("uniaxialMaterial HDRRheology 1 -compound HDR3 {words}"));
        let told = format!("{:?}", ran.warnings());
        assert!(ran.warnings().len() == 1 && told.replace('\\', "").contains(message), "{told}");
    }
}

/// A bearing in space: the words after its geometry, a path of displacement in x and y over time, steps, the response.
fn bearing(options: &str, x: &str, y: &str, steps: usize, dt: f64, wanted: &str) -> Vec<f64> {
    let text = format!(
        "model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 0 0 0; fix 1 1 1 1 1 1 1; fix 2 0 0 0 1 1 1
        element HDRRheologyBearing 1 1 2 1.2 2000. 0. 300. 2.3 5. 6 {options} -orient 0 0 1 1 0 0
        timeSeries Path 1 -time {{0 0.5 1 10000}} -values {{{x}}}
        timeSeries Path 2 -time {{0 0.5 1 10000}} -values {{{y}}}
        timeSeries Constant 3
        pattern Plain 3 3 {{ load 2 0 0 -4.0e5 0 0 0 }}
        pattern Plain 1 1 {{ sp 2 1 1.0 }}
        pattern Plain 2 2 {{ sp 2 2 1.0 }}
        constraints Transformation; numberer Plain; system BandGeneral; test NormDispIncr 1e-9 20; algorithm Newton
        integrator LoadControl {dt}; analysis Static
        if {{[analyze {steps}] != 0}} {{ error \"no convergence\" }}
        foreach w {{{wanted}}} {{ foreach x [eleResponse 1 $w] {{ puts $x }} }}"
    );
    run(&text).numbers()
}

#[test]
fn a_bearing_in_space_is_the_material_on_a_line() {
    let area = std::f64::consts::PI / 4.0 * 300.0 * 300.0;
    let cold = "-compound HDR3 -temperature -10";
    // To 36 and 48 in x and y, 60 in all: a strain of 2 in half a second, and back to half of it.
    let got = bearing(cold, "0 36 18 18", "0 48 24 24", 200, 0.005, "basicForce overstress temperature");
    let material = format!("-compound HDR3 -temperature -10 -area {area} -height 30");
    let analysis = "integrator LoadControl 0.005; analysis Static; analyze 200";
    let one = test_rig(&material, "0 0.5 1 10000", "0 60 30 30", analysis, "stress overstress");
    close(got[1].hypot(got[2]), one[0].abs(), 2e-3);
    close(got[2] / got[1], 4.0 / 3.0, 1e-6);
    close(got[6].hypot(got[7]), one[1].abs(), 2e-3);
    close(got[8], -10.0, 1e-12);
    // The axial law of layered rubber is softer in shear; a linear one is not.
    let short = |options: &str| bearing(options, "0 36 18 18", "0 48 24 24", 100, 0.005, "basicDeformation")[0];
    assert!(short(cold) < 1.01 * short(&format!("{cold} -axial linear")));
}

/// Heat flow through the layers of a bearing in space is that of the material, and no heat gets lost on the way.
#[test]
fn heat_flows_through_a_bearing_in_space() {
    let area = std::f64::consts::PI / 4.0 * 300.0 * 300.0;
    let flow = "-compound HDR3 -ambient -20 -beyond hold -conduction 6 5.0 2.3 20.0 0.25 1.99 50.0 3.39 0.00001";
    let wanted = "temperature heat heatStored heatLost temperatures";
    let got = bearing(flow, "0 36 -36 -36", "0 0 0 0", 2000, 0.005, wanted);
    assert_eq!(got.len(), 4 + 6 * 4 + 5 + 2 * 2);
    assert!(got[3] > 0.0 && (got[1] - got[2] - got[3]).abs() < 1e-9 * got[1], "{got:?}");
    let analysis = "integrator LoadControl 0.005; analysis Static; analyze 2000";
    let material = format!("{flow} -area {area} -height 30");
    let one = test_rig(&material, "0 0.5 1 10000", "0 36 -36 -36", analysis, wanted);
    for (a, b) in got[4..].iter().zip(&one[4..]) {
        assert!((a - b).abs() < 0.01, "{a} for {b}");
    }
}

#[test]
fn p_delta_moments_can_be_left_out() {
    let moments = |options: &str| bearing(options, "0 36 18 18", "0 0 0 0", 100, 0.005, "force");
    let cold = "-compound HDR3 -temperature -10";
    let (with, without) = (moments(cold), moments(&format!("{cold} -pDelta off")));
    close(with[10].abs(), 0.5 * 4.0e5 * 36.0, 1e-6);
    assert!(without[10].abs() < 1e-6, "{without:?}");
    close(with[6], without[6], 1e-9);
}

#[test]
fn a_mass_on_bearings_of_high_damping_rubber() {
    let ran = run("model basic -ndm 3 -ndf 6
        node 1 0 0 0; node 2 0 0 0; fix 1 1 1 1 1 1 1; fix 2 0 0 0 1 1 1; mass 2 40. 40. 40. 0 0 0
        element HDRRheologyBearing 1 1 2 1.2 2000. 0. 300. 2.3 5. 6 -compound HDR2 -ambient -20 -heatCapacity 3.0 \\
            -coolingTime 2000 -beyond hold -mullins 0.3 0.5 -heal 0.5 86400 -orient 0 0 1 1 0 0
        timeSeries Constant 3; pattern Plain 3 3 { load 2 0 0 -4.0e5 0 0 0 }
        constraints Transformation; numberer Plain; system BandGeneral; test NormUnbalance 1e-2 30; algorithm Newton
        integrator LoadControl 0.1; analysis Static; analyze 10; loadConst -time 0
        timeSeries Trig 1 0 6 0.8 -factor 5000.; timeSeries Trig 2 0 6 0.7 -factor 5000.
        pattern UniformExcitation 1 1 -accel 1; pattern UniformExcitation 2 2 -accel 2
        integrator Newmark 0.5 0.25; analysis Transient
        if {[analyze 200 0.01] != 0} { error {no convergence} }
        puts [eleResponse 1 temperature]; puts [eleResponse 1 heat]; puts [eleResponse 1 stored]; puts [numIter]");
    let got = ran.numbers();
    assert!(got[0] > -15.0 && got[0] < 60.0 && got[1] > 10.0 * got[2], "{got:?}");
}
