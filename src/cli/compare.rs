//! Comparison of several calibrated studies.

use hysteron::calibrate::{AmplitudeGroup, CalibrationResult};
use hysteron::study::Role;

fn title(c: &CalibrationResult) -> &str {
    if c.study.title.is_empty() { &c.study.model } else { &c.study.title }
}

/// A text table of objective, holdout error, information criteria and errors by amplitude.
pub(super) fn table(results: &[CalibrationResult]) -> String {
    let mut out =
        format!("{:40} {:>10} {:>10} {:>3} {:>10} {:>10}\n", "model", "objective", "holdout", "k", "AIC", "BIC");
    for c in results {
        let holdout = c.nmse(Role::Holdout).map_or("-".into(), |h| format!("{h:.6}"));
        let criterion = |x: Option<f64>| x.map_or("-".into(), |x| format!("{x:.1}"));
        let (aic, bic) =
            (criterion(c.information_criteria().map(|i| i.0)), criterion(c.information_criteria().map(|i| i.1)));
        let (name, k) = (title(c), c.study.space.dimension());
        out += &format!("{name:40} {:>10.6} {holdout:>10} {k:>3} {aic:>10} {bic:>10}\n", c.objective);
    }
    out += "AIC and BIC compare models of the same recordings only; the smaller the better\n";
    for c in results.iter().filter(|c| c.amplitudes.iter().flatten().any(|a| !a.is_empty())) {
        out += &format!("\n{}: simulated over recorded, less one, by amplitude\n", title(c));
        out += &format!("{:24} {:>10} {:>6} {:>9} {:>9} {:>9}\n", "run", "amplitude", "cycles", "K", "E", "xi");
        for (run, channels) in c.study.runs.iter().zip(&c.amplitudes) {
            for a in channels.iter().flatten() {
                let percent = |pair| format!("{:+.1} %", 100.0 * AmplitudeGroup::error(pair));
                let (k, e, xi) = (percent(a.stiffness), percent(a.energy), percent(a.damping));
                out += &format!("{:24} {:>10.4} {:>6} {k:>9} {e:>9} {xi:>9}\n", run.name, a.amplitude, a.cycles);
            }
        }
    }
    out
}
