//! The repaired script: the user's own with fitted values in its `pset` commands and the block of what was added.

use crate::candidate::variant::{Variant, declared};
use crate::inspect::insertion::{Place, insert};

/// The text of `corrected.tcl`, from the values of all parameters of the variant. `places` are those of the values of the
/// user's own parameters in the text.
pub(crate) fn script(
    text: &str,
    places: &[Option<(usize, usize)>],
    at: &Place,
    variant: &Variant,
    values: &[f64],
) -> String {
    let (own, added) = variant.split(values);
    let with_block = match &variant.proposal {
        Some(p) if !p.block.is_empty() => insert(text, at, &declared(p, added)),
        _ => text.to_owned(),
    };
    // The block has gone in at one place: what stands behind it has moved by its length.
    let moved = with_block.len() - text.len();
    let from = match at {
        Place::At(byte) => text[..*byte].rfind('\n').map_or(0, |i| i + 1),
        Place::FirstAnalyze => 0,
    };
    let mut edits: Vec<(usize, usize, f64)> = places
        .iter()
        .zip(own)
        .filter_map(|(p, v)| p.map(|(a, b)| (a, b, *v)))
        .map(|(a, b, v)| if a >= from { (a + moved, b + moved, v) } else { (a, b, v) })
        .collect();
    edits.sort_by_key(|e| std::cmp::Reverse(e.0));
    let mut out = with_block;
    for (start, end, value) in edits {
        if out.get(start..end).is_some() {
            out.replace_range(start..end, &format!("{value:?}"));
        }
    }
    out
}
