//! Messages about steps that failed.

use crate::checks;
use crate::host::Mode;
use crate::session::Session;
use hysteron_engine::analysis::{Cause, Failure, Kind};
use hysteron_tcl::diagnostic::{Diagnostic, Span};

/// A failure as a message.
pub(super) fn failure_message(session: &Session, failure: &Failure, span: Option<Span>) -> Diagnostic {
    let mut d = Diagnostic::warning(&checks::analysis::FAILED_STEP, failure.to_string())
        .at(span, format!("returns {}", failure.code));
    if let Some(section) = &failure.exhausted {
        d = d.help(format!(
            "{section}: a load factor beyond what it carries has no equilibrium, DisplacementControl follows \
                            the plateau"
        ));
    }
    match (&failure.cause, &failure.exhausted) {
        (Cause::NotConverged { .. }, None) => {
            d = d.help("\"ladder on\" tries other algorithms and shorter steps before it gives up");
        }
        (Cause::Singular, None) => {
            d = d.help("hold the degree of freedom, or join it to something with stiffness");
        }
        _ => {}
    }
    match unheld_patterns(session) {
        Some(patterns) => d.help(patterns),
        None => d,
    }
}

/// Names the patterns that grow together under an integrator that determines the load factor, where steps were made before:
/// the one of gravity is often meant to stay.
fn unheld_patterns(session: &Session) -> Option<String> {
    let engine = &session.engine;
    let follows = engine.setup().is_some_and(|s| s.kind == Kind::Static && !s.integrator.elapses());
    if !follows || session.mode == Mode::Check || engine.steps == 0 {
        return None;
    }
    let time = engine.state().time;
    let growing: Vec<String> =
        engine.model().patterns.iter().filter(|(_, p)| p.grows(time)).map(|(tag, _)| tag.to_string()).collect();
    let (last, others) = growing.split_last()?;
    (!others.is_empty()).then(|| {
        format!(
            "the loads of patterns {} and {last} all grow with the load factor: \"loadConst -time 0.0\" after the analysis of \
             pattern {} holds its loads",
            others.join(", "),
            growing[0]
        )
    })
}
