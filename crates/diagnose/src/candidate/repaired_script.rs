//! The repaired script: the user's script with fitted values in its `pset` commands and the commands of a proposal.

use super::variant::Variant;
use crate::inspect::insertion::{InsertionPoint, insert};

/// Text of `corrected.tcl` at values of all parameters of a variant.
///
/// `value_places` are byte ranges of the values of the user's own parameters in `text`.
pub(crate) fn repaired_script(
    text: &str,
    value_places: &[Option<(usize, usize)>],
    point: &InsertionPoint,
    variant: &Variant,
    values: &[f64],
) -> String {
    let (own, added) = variant.split(values);
    let mut out = match &variant.proposal {
        Some(p) if !p.commands.is_empty() => insert(text, point, &p.declared_commands(added)),
        _ => text.to_owned(),
    };
    // Values behind the insertion have moved by its length.
    let moved = out.len() - text.len();
    let from = match point {
        InsertionPoint::At(byte) => text[..*byte].rfind('\n').map_or(0, |i| i + 1),
        InsertionPoint::FirstAnalyze => 0,
    };
    let mut edits: Vec<(usize, usize, f64)> = value_places
        .iter()
        .zip(own)
        .filter_map(|(p, v)| p.map(|(a, b)| (a, b, *v)))
        .map(|(a, b, v)| if a >= from { (a + moved, b + moved, v) } else { (a, b, v) })
        .collect();
    // From the end on, so that earlier places stay valid.
    edits.sort_by_key(|e| std::cmp::Reverse(e.0));
    for (start, end, value) in edits {
        if out.get(start..end).is_some() {
            out.replace_range(start..end, &format!("{value:?}"));
        }
    }
    out
}
