//! Rendering of diagnostics with file, line and column.

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use hysteron::diagnostic::{Diagnostic, Severity, SourceMap};
use std::io::IsTerminal;

/// Renders diagnostics as text.
pub(super) struct Messages {
    renderer: Renderer,
}

impl Messages {
    pub(super) fn new() -> Self {
        let colour = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
        let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
        Self { renderer: renderer.decor_style(DecorStyle::Ascii) }
    }

    /// A diagnostic with its source line, its help, and the calls that led to it.
    pub(super) fn render(&self, d: &Diagnostic, sources: &SourceMap) -> String {
        let level = match d.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
            Severity::Note => Level::NOTE,
        };
        let title = level.primary_title(titled(d));
        // Texts live as long as the report.
        let spans: Vec<_> = d.span.iter().chain(d.callers.iter().map(|c| &c.span)).copied().collect();
        let texts: Vec<_> = spans.iter().map(|s| (sources.text(s.source), sources.name(s.source))).collect();
        let mut texts_of = texts.iter();
        let mut group = Group::with_title(title);
        if let (Some(span), Some((text, name))) = (d.span, d.span.and_then(|_| texts_of.next())) {
            let range = span.start as usize..span.end as usize;
            let annotation = AnnotationKind::Primary.span(range).label(d.label.as_str());
            group = group.element(Snippet::source(&**text).path(&**name).annotation(annotation));
        }
        group = d.help.iter().fold(group, |g, h| g.element(Level::HELP.message(h.as_str())));
        let mut report = vec![group];
        for (caller, (text, name)) in d.callers.iter().zip(texts_of) {
            let range = caller.span.start as usize..caller.span.end as usize;
            let snippet = Snippet::source(&**text)
                .path(&**name)
                .annotation(AnnotationKind::Context.span(range).label("called here"));
            report.push(Group::with_title(Level::NOTE.secondary_title(format!("in {}", caller.what))).element(snippet));
        }
        self.renderer.render(&report).to_string()
    }

    /// A diagnostic in one line.
    pub(super) fn line(&self, d: &Diagnostic, sources: &SourceMap) -> String {
        match d.span {
            Some(span) => format!("{}: {}", sources.location(span), titled(d)),
            None => titled(d),
        }
    }
}

/// The message with the code of its check, which `hysteron explain` explains.
fn titled(d: &Diagnostic) -> String {
    match d.check {
        Some(check) => format!("{} [{}]", d.message, check.code),
        None => d.message.clone(),
    }
}
