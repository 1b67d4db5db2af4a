//! Several calibrated studies side by side.

use hysteron::calibrate::{Amplitude, Calibrated};
use hysteron::study::Role;

fn title(c: &Calibrated) -> &str {
    if c.study.title.is_empty() { &c.study.model } else { &c.study.title }
}

/// Objective, holdout, information criteria and errors by amplitude of each, as text.
pub(super) fn table(done: &[Calibrated]) -> String {
    let mut out =
        format!("{:40} {:>10} {:>10} {:>3} {:>10} {:>10}\n", "model", "objective", "holdout", "k", "AIC", "BIC");
    for c in done {
        let holdout = c.nmse(Role::Holdout).map_or("-".into(), |h| format!("{h:.6}"));
        let criterion = |x: Option<f64>| x.map_or("-".into(), |x| format!("{x:.1}"));
        let (aic, bic) = (criterion(c.information().map(|i| i.0)), criterion(c.information().map(|i| i.1)));
        let (name, k) = (title(c), c.free_parameters());
        out += &format!("{name:40} {:>10.6} {holdout:>10} {k:>3} {aic:>10} {bic:>10}\n", c.objective);
    }
    out += "AIC and BIC compare models of the same recordings only; the smaller the better\n";
    for c in done.iter().filter(|c| c.amplitudes.iter().flatten().any(|a| !a.is_empty())) {
        out += &format!("\n{}: simulated over recorded, less one, by amplitude\n", title(c));
        out += &format!("{:24} {:>10} {:>6} {:>9} {:>9} {:>9}\n", "run", "amplitude", "cycles", "K", "E", "xi");
        for (run, channels) in c.study.runs.iter().zip(&c.amplitudes) {
            for a in channels.iter().flatten() {
                let percent = |pair| format!("{:+.1} %", 100.0 * Amplitude::error(pair));
                let (k, e, xi) = (percent(a.stiffness), percent(a.energy), percent(a.damping));
                out += &format!("{:24} {:>10.4} {:>6} {k:>9} {e:>9} {xi:>9}\n", run.name, a.amplitude, a.cycles);
            }
        }
    }
    out
}
