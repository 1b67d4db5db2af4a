//! Warnings about the numbers of an analysis that has been made: balance, singular equations, bearings beyond their range.

use crate::checks;
use crate::host::Mode;
use crate::{Tcl, warn};
use hysteron_engine::element::Overload;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::{Diagnostic, Span};

/// Warn, once each, of steps that were out of balance though they counted as converged, and of equations that are
/// nearly singular.
pub(super) fn warn_of_numerics(interp: &mut Tcl, span: Option<Span>) -> Result<(), Exception> {
    let session = &mut interp.host;
    let weak =
        if session.warnings.has(&checks::analysis::NEARLY_SINGULAR) { None } else { session.engine.weak_pivot() };
    if let Some((place, ratio)) = weak {
        session.warnings.note(&checks::analysis::NEARLY_SINGULAR);
        let message =
            format!("the equations are nearly singular at {place}: {ratio:.1e} of the stiffness is left there");
        let d = Diagnostic::warning(&checks::analysis::NEARLY_SINGULAR, message)
            .at(span, "few digits of the results are right");
        warn(interp, d)?;
    }
    let session = &mut interp.host;
    let told = session.warnings.has(&checks::analysis::OUT_OF_BALANCE);
    if let Some(i) = session.engine.imbalance.as_ref().filter(|_| !told) {
        let message = format!(
            "a step counted as converged though the forces are out of balance: {:.1} % of the largest force \
             at time {} ({})",
            100.0 * i.ratio,
            i.time,
            i.place
        );
        session.warnings.note(&checks::analysis::OUT_OF_BALANCE);
        let d = Diagnostic::warning(&checks::analysis::OUT_OF_BALANCE, message)
            .at(span, "a tighter test, or one of the unbalance, shows it");
        warn(interp, d)?;
    }
    report_overload(interp, span);
    report_softening(interp, span);
    Ok(())
}

/// Report once a bearing whose backbone is negative. It is no error, even where warnings are: a script may study this.
fn report_softening(interp: &mut Tcl, span: Option<Span>) {
    let session = &mut interp.host;
    if session.mode == Mode::Check || session.warnings.has(&checks::analysis::SOFTENING_BEARING) {
        return;
    }
    let Some(d) = session.output.recorders.backbones.warning(span) else { return };
    session.warnings.note(&checks::analysis::SOFTENING_BEARING);
    crate::report(interp, d);
}

/// Report once a bearing under more than its critical load.
///
/// The script may study exactly this, so that it is no error, even where warnings are.
fn report_overload(interp: &mut Tcl, span: Option<Span>) {
    let session = &mut interp.host;
    if session.mode == Mode::Check || session.warnings.has(&checks::analysis::OVERLOADED_BEARING) {
        return;
    }
    let Some((e, Overload { load, critical })) = session.engine.overload() else { return };
    let message = format!(
        "the axial load of {} {} is {load:.4e}, above its critical load of {critical:.4e}",
        e.element.class().name,
        e.tag
    );
    session.warnings.note(&checks::analysis::OVERLOADED_BEARING);
    crate::report(
        interp,
        Diagnostic::warning(&checks::analysis::OVERLOADED_BEARING, message).at(span, "it has buckled"),
    );
}
