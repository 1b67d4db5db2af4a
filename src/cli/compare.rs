//! Several calibrated studies side by side.

use hysteron::calibrate::Calibrated;
use hysteron::study::Role;

/// Objective, holdout and information criteria of each, in one table.
pub(super) fn table(done: &[Calibrated]) {
    eprintln!();
    eprintln!("{:40} {:>10} {:>10} {:>3} {:>10} {:>10}", "model", "objective", "holdout", "k", "AIC", "BIC");
    for c in done {
        let title = if c.study.title.is_empty() { c.study.model.as_str() } else { c.study.title.as_str() };
        let holdout = c.nmse(Role::Holdout).map_or("-".into(), |h| format!("{h:.6}"));
        let (aic, bic) =
            c.information().map_or(("-".into(), "-".into()), |(a, b)| (format!("{a:.1}"), format!("{b:.1}")));
        let k = c.free_parameters();
        eprintln!("{title:40} {:>10.6} {holdout:>10} {k:>3} {aic:>10} {bic:>10}", c.objective);
    }
    eprintln!("AIC and BIC compare models of the same recordings only; the smaller the better");
}
