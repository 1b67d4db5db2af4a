//! A bearing of a model tested by itself: cycles of shear from its state under gravity.

use hysteron_engine::analysis::Engine;
use hysteron_engine::element::{ElementInput, ElementOutput, Histories, MatrixMask};
use hysteron_engine::model::ElementId;
use hysteron_identify::measure::Loop;
use std::f64::consts::TAU;

/// Steps of a quarter of a cycle.
const QUARTER: usize = 100;
/// Cycles; the last one is measured.
const CYCLES: usize = 3;
/// Share of the yield displacement, and of the amplitude, by which the loop of an abrupt transition may be rounded. The
/// second is what the steps of the test leave open.
const ROUNDED: [f64; 2] = [0.05, 1.0e-3];

/// The bilinear loop with the forces and the energy of a measured one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BilinearLoop {
    /// Characteristic strength Q_d: half of the distance between the forces at zero displacement.
    pub(super) q_d: f64,
    /// Post-elastic stiffness K_d = K_eff - Q_d/D.
    pub(super) k_d: f64,
    /// Yield displacement D_y = D - EDC/(4 Q_d), at least 0; 0 without strength.
    pub(super) yield_displacement: f64,
    /// Amplitude D.
    pub(super) amplitude: f64,
    /// True if the loop turns abruptly: its D_y is Q_d/(K_1 - K_d) with the initial stiffness K_1, so that no corner is
    /// rounded.
    pub(super) abrupt: bool,
}

impl BilinearLoop {
    /// Of samples of a whole cycle u = D sin(ωt), with the initial stiffness.
    fn new(u: &[f64], f: &[f64], initial: f64) -> Self {
        let measured = Loop::of(u, f);
        let amplitude = measured.amplitude();
        let q_d = 0.5 * (f[4 * QUARTER] - f[2 * QUARTER]);
        // A spring has none but for round-off.
        let q_d = if q_d > 1.0e-9 * measured.f_max.abs() { q_d } else { 0.0 };
        let k_d = (f[QUARTER] - f[3 * QUARTER]) / (2.0 * amplitude) - q_d / amplitude;
        let yield_displacement = if q_d > 0.0 { (amplitude - measured.energy / (4.0 * q_d)).max(0.0) } else { 0.0 };
        let sharp = q_d / (initial - k_d);
        let abrupt = q_d > 0.0 && yield_displacement - sharp <= ROUNDED[0] * sharp + ROUNDED[1] * amplitude;
        Self { q_d, k_d, yield_displacement, amplitude, abrupt }
    }

    /// Effective damping β = 4 Q_d (D - D_y)/(2π K_eff D²) at a displacement D.
    pub(super) fn damping(&self, d: f64) -> f64 {
        let stiffness = self.k_d + self.q_d / d;
        4.0 * self.q_d * (d - self.yield_displacement).max(0.0) / (TAU * stiffness * d * d)
    }
}

/// Cycles of u = D sin(2π t/T) of the upper node in a direction on an element of two nodes; its other displacements stay
/// those under gravity.
///
/// # Errors
/// The element finds no equilibrium.
pub(super) fn shear_test(
    engine: &Engine,
    id: ElementId,
    direction: usize,
    amplitude: f64,
    period: f64,
) -> Result<BilinearLoop, String> {
    let entry = &engine.model().elements[id.0];
    let element = entry.element.as_ref();
    let n = element.dofs();
    let at = n / 2 + direction;
    let state = engine.state();
    let mut committed = state.history[entry.state.clone()].to_vec();
    let mut trial = committed.clone();
    let mut disp: Vec<f64> = entry.dofs.iter().map(|&d| state.disp[d as usize]).collect();
    let (start, mut vel, accel) = (disp[at], vec![0.0; n], vec![0.0; n]);
    let mut stiffness = vec![0.0; n * n];
    element.initial_tangent(&mut stiffness);
    let steps = CYCLES * 4 * QUARTER;
    let dt = period / (4 * QUARTER) as f64;
    let (mut u, mut f) = (vec![0.0; steps + 1], vec![0.0; steps + 1]);
    for step in 0..=steps {
        let phase = TAU * step as f64 / (4 * QUARTER) as f64;
        u[step] = amplitude * phase.sin();
        disp[at] = start + u[step];
        vel[at] = amplitude * TAU / period * phase.cos();
        let input = ElementInput {
            disp: &disp,
            vel: &vel,
            accel: &accel,
            load: &state.element_load[entry.load.clone()],
            still: false,
            opensees: None,
            dt: if step == 0 { 0.0 } else { dt },
            time: state.time + dt * step as f64,
            dynamic: true,
        };
        let mut force = vec![0.0; n];
        let output = ElementOutput { force: &mut force, tangent: None, damping: None, part: MatrixMask::ALL };
        element
            .respond(&input, &mut Histories { committed: &committed, trial: &mut trial }, output)
            .map_err(|e| e.to_string())?;
        element.commit(&trial, &mut committed);
        f[step] = force[at];
    }
    if f.iter().any(|f| !f.is_finite()) {
        return Err("its force is not a number".into());
    }
    let last = (CYCLES - 1) * 4 * QUARTER;
    Ok(BilinearLoop::new(&u[last..], &f[last..], stiffness[at * n + at]))
}

#[cfg(test)]
mod tests {
    use super::{BilinearLoop, QUARTER};
    use std::f64::consts::TAU;

    /// A bilinear loop by an elastic-plastic spring beside a linear one; `rounded` takes corners away.
    fn bilinear(q: f64, k_d: f64, d_y: f64, amplitude: f64) -> BilinearLoop {
        let k = q / d_y;
        let (mut z, mut last) = (0.0f64, 0.0);
        let (mut u, mut f) = (vec![], vec![]);
        for step in 0..=12 * QUARTER {
            let now = amplitude * (TAU * step as f64 / (4 * QUARTER) as f64).sin();
            z = (z + k * (now - last)).clamp(-q, q);
            last = now;
            u.push(now);
            f.push(k_d * now + z);
        }
        BilinearLoop::new(&u[8 * QUARTER..], &f[8 * QUARTER..], k + k_d)
    }

    #[test]
    fn a_bilinear_loop_is_found_again() {
        for (q, k_d, d_y, amplitude) in [(26.0, 440.0, 0.0066, 0.2), (100.0, 0.0, 0.0005, 0.3), (5.0, 80.0, 0.02, 0.1)]
        {
            let found = bilinear(q, k_d, d_y, amplitude);
            assert!((found.q_d / q - 1.0).abs() < 1e-12 && (found.k_d - k_d).abs() < 1e-9 * q / d_y, "{found:?}");
            // Corners between two steps are cut.
            assert!((found.yield_displacement - d_y).abs() < 1e-3 * amplitude, "{found:?}");
            assert!(found.abrupt, "{found:?}");
        }
    }

    #[test]
    fn a_spring_has_no_strength() {
        let u: Vec<f64> = (0..=4 * QUARTER).map(|i| 0.1 * (TAU * i as f64 / (4 * QUARTER) as f64).sin()).collect();
        let f: Vec<f64> = u.iter().map(|u| 50.0 * u).collect();
        let found = BilinearLoop::new(&u, &f, 50.0);
        assert!(found.q_d.abs() < 1e-12 && (found.k_d - 50.0).abs() < 1e-9 && !found.abrupt, "{found:?}");
        assert!(found.yield_displacement >= 0.0);
    }
}
