//! Patterns of `string match`.

/// Returns true if a text matches a pattern with `*`, `?`, `[a-z]` and backslashes.
pub(crate) fn matches(pattern: &str, text: &str) -> bool {
    if pattern == "*" {
        return true;
    }
    matches_from(pattern, text, false)
}

/// As [`matches`], with upper and lower case alike.
pub(crate) fn matches_nocase(pattern: &str, text: &str) -> bool {
    matches_from(pattern, text, true)
}

/// Returns true if a text has none of the characters that are special in a pattern.
pub(crate) fn is_plain(pattern: &str) -> bool {
    !pattern.contains(['*', '?', '[', '\\'])
}

fn fold(c: char, nocase: bool) -> char {
    if nocase { c.to_lowercase().next().unwrap_or(c) } else { c }
}

/// Without recursion: at a mismatch go back to the last star and let it take one character more.
fn matches_from(pattern: &str, text: &str, nocase: bool) -> bool {
    let mut p = pattern;
    let mut t = text;
    let mut star: Option<(&str, &str)> = None;
    loop {
        if let Some(rest) = p.strip_prefix('*') {
            p = rest.trim_start_matches('*');
            if p.is_empty() {
                return true;
            }
            star = Some((p, t));
            continue;
        }
        if p.is_empty() && t.is_empty() {
            return true;
        }
        match one(p, t, nocase) {
            Some((next_p, next_t)) => (p, t) = (next_p, next_t),
            None => match &mut star {
                Some((after, from)) => {
                    let mut chars = from.chars();
                    if chars.next().is_none() {
                        return false;
                    }
                    *from = chars.as_str();
                    (p, t) = (after, from);
                }
                None => return false,
            },
        }
    }
}

/// Match one character of the text against the start of the pattern; what is left of both.
fn one<'p, 't>(pattern: &'p str, text: &'t str, nocase: bool) -> Option<(&'p str, &'t str)> {
    let mut t = text.chars();
    let c = t.next()?;
    let mut p = pattern.chars();
    let same = |a: char| a == c || (nocase && fold(a, true) == fold(c, true));
    let fits = match p.next()? {
        '?' => true,
        '[' => {
            let c = fold(c, nocase);
            let mut found = false;
            while let Some(low) = p.next() {
                if low == ']' {
                    break;
                }
                let low = fold(low, nocase);
                let mut ahead = p.clone();
                if ahead.next() == Some('-') {
                    p = ahead;
                    let Some(high) = p.next() else { break };
                    let high = fold(high, nocase);
                    found |= (low.min(high)..=low.max(high)).contains(&c);
                } else {
                    found |= low == c;
                }
                if found {
                    // The rest of the set does not matter.
                    while p.next().is_some_and(|c| c != ']') {}
                    break;
                }
            }
            found
        }
        '\\' => same(p.next().unwrap_or('\\')),
        other => same(other),
    };
    if fits { Some((p.as_str(), t.as_str())) } else { None }
}
