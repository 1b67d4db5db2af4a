//! The fiber that the words of a recorder select.

/// Place of a fiber and tag of its material.
#[derive(Clone, Copy, Debug)]
pub(super) struct FiberPlace {
    pub(super) y: f64,
    pub(super) z: f64,
    pub(super) tag: i32,
}

/// Index of the fiber that the words select, and the words after them: an index, or coordinates with an optional tag of a
/// material. Of fibers that are as near the first one is taken, as in OpenSees. The z coordinate counts in a section that is
/// bent about both axes.
pub(super) fn select<'a, 'b>(
    words: &'a [&'b str],
    biaxial: bool,
    fibers: impl ExactSizeIterator<Item = FiberPlace>,
) -> Option<(usize, &'a [&'b str])> {
    let number = |w: &str| w.parse::<f64>().ok();
    let y = number(words.first()?)?;
    let Some(z) = words.get(1).and_then(|w| number(w)) else {
        return Some((y as usize, &words[1..])).filter(|f| f.0 < fibers.len());
    };
    let (tag, rest) = match words.get(2).and_then(|w| w.parse::<i32>().ok()) {
        Some(tag) => (Some(tag), &words[3..]),
        None => (None, &words[2..]),
    };
    let square = |f: FiberPlace| (f.y - y).powi(2) + if biaxial { (f.z - z).powi(2) } else { 0.0 };
    let chosen = fibers.enumerate().filter(|(_, f)| tag.is_none_or(|t| f.tag == t));
    let nearest = chosen.map(|(i, f)| (i, square(f))).min_by(|a, b| a.1.total_cmp(&b.1))?;
    Some((nearest.0, rest))
}
