//! Findings as the diagnostics of the protocol.

use crate::buffer::{Buffer, Known};
use crate::finding::Finding;
use crate::script::Place;
use crate::text::Text;
use crate::uri;
use hysteron_tcl::diagnostic::Severity;
use lsp_types::{
    Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, Location, NumberOrString, PublishDiagnosticsParams,
    Range, Uri,
};
use std::collections::{BTreeMap, BTreeSet};

/// Name of the server in diagnostics.
pub(crate) const SOURCE: &str = "hysteron";

/// Address of a file: that of the editor, where it is open.
fn uri_of(path: &str, buffers: &BTreeMap<String, Buffer>) -> Option<Uri> {
    buffers.get(path).map_or_else(|| uri::from_path(path), |b| Some(b.uri.clone()))
}

/// Texts of a check with their lines, each made once.
struct Texts<'a> {
    known: &'a Known,
    lines: BTreeMap<&'a str, Text>,
}

impl<'a> Texts<'a> {
    /// Range of a place. An empty one takes its character, or its line where it is at the beginning.
    fn range(&mut self, place: &'a Place) -> Range {
        let text = self.known.checked.texts.get(&place.path);
        let text = self.lines.entry(&place.path).or_insert_with(|| Text::new(text.map_or("", |t| t)));
        if place.start == 0 && place.end == 0 {
            return text.range(0, text.line_range(0).end);
        }
        text.range(place.start, place.end.max(place.start))
    }
}

/// Diagnostics of the files that are concerned, from all checks that have read them.
pub(crate) fn diagnostics<'a>(
    known: impl Iterator<Item = &'a Known>,
    buffers: &BTreeMap<String, Buffer>,
    concerned: &BTreeSet<String>,
) -> Vec<PublishDiagnosticsParams> {
    let mut all: BTreeMap<&str, Vec<Diagnostic>> = concerned.iter().map(|p| (p.as_str(), vec![])).collect();
    let mut stale: BTreeSet<&str> = BTreeSet::new();
    for known in known {
        let is_stale = |p: &&String| match (known.checked.texts.get(*p), buffers.get(*p)) {
            (Some(text), Some(buffer)) => **text != *buffer.text.as_str(),
            _ => false,
        };
        stale.extend(concerned.iter().filter(is_stale).map(String::as_str));
        let mut texts = Texts { known, lines: BTreeMap::new() };
        for f in &known.checked.findings {
            let Some(of_file) = all.get_mut(f.place.path.as_str()) else { continue };
            let d = diagnostic(f, &mut texts, buffers);
            if !of_file.contains(&d) {
                of_file.push(d);
            }
        }
    }
    let params = |(path, diagnostics): (&str, Vec<Diagnostic>)| {
        // Of a text that has changed since, the version is not that of the editor.
        let version = buffers.get(path).map(|b| b.version).filter(|_| !stale.contains(path));
        Some(PublishDiagnosticsParams { uri: uri_of(path, buffers)?, diagnostics, version })
    };
    all.into_iter().filter_map(params).collect()
}

fn diagnostic<'a>(f: &'a Finding, texts: &mut Texts<'a>, buffers: &BTreeMap<String, Buffer>) -> Diagnostic {
    let mut related = vec![];
    for (place, message) in &f.related {
        if let Some(uri) = uri_of(&place.path, buffers) {
            let location = Location { uri, range: texts.range(place) };
            related.push(DiagnosticRelatedInformation { location, message: message.clone() });
        }
    }
    Diagnostic {
        range: texts.range(&f.place),
        severity: Some(match f.severity {
            Severity::Error => DiagnosticSeverity::ERROR,
            Severity::Warning => DiagnosticSeverity::WARNING,
            Severity::Note => DiagnosticSeverity::INFORMATION,
        }),
        code: (!f.code.is_empty()).then(|| NumberOrString::String(f.code.to_owned())),
        source: Some(SOURCE.to_owned()),
        message: f.message.clone(),
        related_information: (!related.is_empty()).then_some(related),
        ..Diagnostic::default()
    }
}
