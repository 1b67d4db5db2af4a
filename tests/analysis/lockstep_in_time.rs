//! Transient analyses of several models side by side against each by itself: the same numbers to the last bit.

use super::lockstep::{check, check_failures};
use hysteron::opensees::lockstep::Execution;

const TEST: &str = "NormUnbalance 1e-9 30";

/// Parts of a plane building of storeys in a row on a bearing.
struct Building {
    storeys: usize,
    /// Rayleigh damping of the storeys: of mass, of the current stiffness, of the initial and of the committed one.
    rayleigh: [f64; 4],
    /// Materials 3 of the storeys and further elements, for a number from 0.
    storey: fn(f64) -> String,
    integrator: &'static str,
    test: &'static str,
}

impl Building {
    fn new(storey: fn(f64) -> String) -> Self {
        Self { storeys: 2, rayleigh: [0.0, 0.0, 0.004, 0.0], storey, integrator: "Newmark 0.5 0.25", test: TEST }
    }

    /// A script with numbers that follow `x`.
    fn script(&self, x: f64) -> String {
        let top = self.storeys + 2;
        let mut nodes = String::new();
        for i in 2..=top {
            let m = 40. + 3. * x;
            nodes += &format!("node {i} 0 {}; fix {i} 0 1 1; mass {i} {m} 1e-9 1e-9\n", 3 * (i - 1));
        }
        for i in 2..top {
            nodes += &format!(
                "element twoNodeLink {i} {i} {} -mat 3 -dir 2 -orient 0 1 0 -1 0 0 -doRayleigh -mass {}\n",
                i + 1,
                2. + x
            );
        }
        let [a, b, c, d] = self.rayleigh;
        let factor = 1. + 0.1 * x;
        format!(
            "model basic -ndm 2 -ndf 3; node 1 0 0; fix 1 1 1 1
            uniaxialMaterial Elastic 1 1e7; uniaxialMaterial Elastic 2 1e3
            {storey}
            {nodes}
            element elastomericBearingBoucWen 1 1 2 {k} {qd} 0.1 0. 2. 1. 0.6 0.4 -P 1 -Mz 2 -orient 0 1 0 -1 0 0
            region 1 -eleRange 2 {top} -rayleigh {a} {b} {c} {d}; region 2 -node {top} -rayleigh {alpha} 0. 0. 0.
            timeSeries Path 1 -dt 0.04 -values {{0. 1. -2. 3. -1. 2.5 -3. 0.7 1. -2. 0.}}
            pattern UniformExcitation 1 1 -accel 1
            timeSeries Constant 2; pattern Plain 2 2 {{ load {top} 5. 0. 0. }}
            recorder Node -file disp.out -time -node 2 {top} -dof 1 disp
            recorder Node -file vel.out -node {top} -dof 1 vel
            recorder Node -file accel.out -time -timeSeries 1 -node 2 {top} -dof 1 accel
            recorder Element -file force.out -time -dT 0.01 -ele 1 2 force
            constraints Plain; numberer Plain; system BandGeneral; test {test}; algorithm Newton
            integrator {integrator}; analysis Transient; analyze 130 0.005",
            storey = (self.storey)(x),
            k = 900. + 90. * x,
            qd = 20. + 2. * x,
            alpha = 0.1 * x,
            a = a * factor,
            b = b * factor,
            c = c * factor,
            d = d * factor,
            test = self.test,
            integrator = self.integrator,
        )
    }

    fn check(&self, expected: Execution) {
        check(&(0..8).map(|i| self.script(f64::from(i))).collect::<Vec<_>>(), 1, expected);
    }
}

fn elastic(x: f64) -> String {
    format!("uniaxialMaterial Elastic 3 {}", 9000. + 500. * x)
}

fn yielding(x: f64) -> String {
    format!("uniaxialMaterial Steel02 3 {} 9000. 0.05 18 0.925 0.15", 60. + 4. * x)
}

fn with_dashpot(x: f64) -> String {
    format!(
        "uniaxialMaterial Elastic 4 9000.; uniaxialMaterial Viscous 5 {} 0.6; uniaxialMaterial Maxwell 6 900. {} 1. 1.
        uniaxialMaterial Parallel 3 4 5 6",
        40. + 6. * x,
        30. + x
    )
}

#[test]
fn buildings_have_the_numbers_that_each_has_alone() {
    for storey in [elastic, yielding, with_dashpot] {
        Building::new(storey).check(Execution::SideBySide);
    }
    let linear = |rayleigh| Building { rayleigh, ..Building::new(elastic) };
    for rayleigh in [[0.2, 0.001, 0.002, 0.003], [0.3, 0.0, 0.0, 0.0], [0.0; 4]] {
        linear(rayleigh).check(Execution::SideBySide);
    }
    for test in ["NormDispIncr 1e-10 30", "EnergyIncr 1e-16 30"] {
        Building { test, ..Building::new(yielding) }.check(Execution::SideBySide);
    }
    Building { integrator: "Newmark 0.6 0.3025", ..Building::new(yielding) }.check(Execution::SideBySide);
}

#[test]
fn high_buildings_are_damped_by_matrices_of_the_equations() {
    for storey in [elastic, yielding] {
        let rayleigh = [0.2, 0.0, 0.002, 0.0];
        Building { storeys: 11, rayleigh, ..Building::new(storey) }.check(Execution::SideBySide);
    }
}

#[test]
fn other_transient_analyses_go_one_by_one() {
    let integrators = ["HHT 0.9", "Newmark 0.5 0.25 -form V", "TRBDF2"];
    for integrator in integrators {
        Building { integrator, ..Building::new(yielding) }.check(Execution::ByItself);
    }
    for rayleigh in [[0.0, 0.001, 0.0, 0.0], [0.0, 0.0, 0.0, 0.001]] {
        Building { rayleigh, ..Building::new(yielding) }.check(Execution::ByItself);
    }
}

#[test]
fn a_rig_that_moves_has_the_numbers_that_each_has_alone() {
    let script = |x: f64| {
        format!(
            "model basic -ndm 2 -ndf 2; node 1 0 0; node 2 0 0; fix 1 1 1; node 3 0 0; fix 3 0 1; fix 2 0 1; mass 3 0.2 0.2
            uniaxialMaterial Steel02 1 {fy} 9000. 0.02 18 0.925 0.15; uniaxialMaterial Viscous 2 {c} 0.5
            uniaxialMaterial Parallel 3 1 2; uniaxialMaterial Elastic 4 {k}
            element zeroLength 1 1 2 -mat 3 -dir 1; element zeroLength 2 2 3 -mat 4 -dir 1
            timeSeries Trig 1 0. 10. 0.7 -factor 0.02
            pattern Plain 1 1 {{ sp 2 1 1. }}
            recorder Node -file disp.out -time -node 2 3 -dof 1 disp; recorder Node -file vel.out -node 2 3 -dof 1 vel
            recorder Element -file force.out -ele 1 2 force
            constraints Transformation; numberer Plain; system BandGeneral; test NormDispIncr 1e-11 20; algorithm Newton
            integrator Newmark 0.5 0.25; analysis Transient; analyze 140 0.01",
            fy = 40. + 3. * x,
            c = 20. + x,
            k = 500. + 90. * x,
        )
    };
    check(&(0..6).map(|i| script(f64::from(i))).collect::<Vec<_>>(), 1, Execution::SideBySide);
}

#[test]
fn bars_with_masses_of_their_own_have_the_numbers_that_each_has_alone() {
    for form in ["0", "1"] {
        let script = |x: f64| {
            format!(
                "model basic -ndm 2 -ndf 2; node 1 0 0; node 2 3 0; node 3 6 1; fix 1 1 1; fix 2 0 1; mass 3 1. 1.
                uniaxialMaterial Steel02 1 {fy} 9000. 0.02 18 0.925 0.15; uniaxialMaterial Elastic 2 {k}
                element truss 1 1 2 1. 1 -rho {rho} -cMass {form} -doRayleigh 1
                element truss 2 2 3 1. 2 -rho {rho} -cMass {form} -doRayleigh 1; element truss 3 1 3 1. 2 -rho 0.1 -cMass {form}
                rayleigh 0.2 0. 0.001 0.
                timeSeries Path 1 -dt 0.04 -values {{0. 1. -2. 3. -1. 2.5 -3. 0.7 1. -2. 0.}} -factor 20.
                pattern UniformExcitation 1 1 -accel 1
                recorder Node -file disp.out -time -node 2 3 -dof 1 2 disp
                recorder Node -file accel.out -node 2 3 -dof 1 2 accel
                constraints Plain; numberer Plain; system BandGeneral; test NormDispIncr 1e-12 20; algorithm Newton
                integrator Newmark 0.5 0.25; analysis Transient; analyze 120 0.005",
                fy = 40. + 3. * x,
                k = 5000. + 90. * x,
                rho = 0.4 + 0.05 * x,
            )
        };
        check(&(0..7).map(|i| script(f64::from(i))).collect::<Vec<_>>(), 1, Execution::SideBySide);
    }
}

#[test]
fn a_mass_on_a_high_damping_bearing_in_space_goes_on_from_its_axial_load() {
    let script = |x: f64| {
        format!(
            "model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 0 0 0.3; fix 1 1 1 1 1 1 1; fix 2 0 0 0 1 1 1
            mass 2 9. 9. 9. 0. 0. 0.
            element HDR 1 1 2 {g} 2.0e6 0.15 0.6 0.003 0.006 28 {a1} -6e3 9.0e4 12. 250. 60. 4. 1.5 0.75 3. \\
                0 0 1 1 0 0 10.0 0.5 1.0 0.5 0.0 0.0
            timeSeries Linear 1; pattern Plain 1 1 {{ load 2 0. 0. -90. 0. 0. 0. }}
            constraints Plain; numberer Plain; system BandGeneral; test NormDispIncr 1e-11 30; algorithm Newton
            integrator LoadControl 0.1; analysis Static; analyze 10; loadConst -time 0.; wipeAnalysis
            timeSeries Path 2 -dt 0.04 -values {{0. 1. -2. 3. -1. 2.5 -3. 0.7 1. -2. 0.}} -factor 9.
            pattern UniformExcitation 2 1 -accel 2; pattern UniformExcitation 3 2 -accel 2 -fact 0.4
            recorder Node -file disp.out -time -node 2 -dof 1 2 3 disp
            recorder Node -file accel.out -time -timeSeries 2 0 0 -node 2 -dof 1 2 3 accel
            recorder Element -file force.out -ele 1 globalForce
            constraints Plain; numberer Plain; system BandGeneral; test NormDispIncr 1e-11 30; algorithm Newton
            integrator Newmark 0.5 0.25; analysis Transient; analyze 100 0.005",
            g = 450. + 9. * x,
            a1 = 450. + 60. * x,
        )
    };
    check(&(0..8).map(|i| script(f64::from(i))).collect::<Vec<_>>(), 2, Execution::SideBySide);
}

#[test]
fn a_building_that_fails_is_left_to_itself_and_changes_no_other() {
    // The third alone yields, for which the test leaves it too few iterations.
    let building = Building { test: "NormUnbalance 1e-8 2", ..Building::new(yielding) };
    let script = |i: usize| {
        let bearing = if i == 2 { "1e8 1." } else { "900 1e9" };
        let script = building.script(i as f64).replace(&format!("Steel02 3 {} ", 60 + 4 * i), "Steel02 3 1e9 ");
        script.replace(&format!(" {} {} 0.1 0. 2.", 900 + 90 * i, 20 + 2 * i), &format!(" {bearing} 0.001 0. 2."))
    };
    check_failures(&(0..5).map(script).collect::<Vec<_>>(), |i| i == 2);
}
