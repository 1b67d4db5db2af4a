//! Names of the numbers among the words of a call: those of the usage line.

use hysteron_tcl::NumberNote;

/// A part of a usage line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part<'a> {
    /// `$name`: a word of the call.
    Word(&'a str),
    /// `-option`.
    Option(&'a str),
    /// `...`: more words like those before.
    More,
    /// Any other word.
    Other,
}

/// The parts of a usage line after its tag. Optional words before required ones are left out where so few words are given
/// that they cannot be among them.
fn parts(usage: &str, given: usize) -> Vec<Part<'_>> {
    let (mut parts, mut depth) = (vec![], 0);
    for word in usage.split_whitespace().skip_while(|w| *w != "$tag").skip(1) {
        depth += word.matches('<').count();
        let (w, optional) = (word.trim_matches(['<', '>']), depth > 0);
        depth = depth.saturating_sub(word.matches('>').count());
        let part = match (w.strip_prefix('$'), w.starts_with('-')) {
            (Some(name), _) => Part::Word(name),
            (None, true) => Part::Option(w),
            (None, false) if w == "..." => Part::More,
            (None, false) if w == "|" || w.is_empty() => continue,
            _ => Part::Other,
        };
        parts.push((part, optional));
    }
    let is_word = |(part, _): &&(Part<'_>, bool)| matches!(part, Part::Word(_));
    let end = parts.iter().rposition(|p| !p.1 && is_word(&p)).map_or(0, |i| i + 1);
    // Forms that exclude each other have no number of words.
    if given < parts[..end].iter().filter(is_word).count() && !usage.contains(" | ") {
        let mut i = 0;
        parts.retain(|(_, optional)| {
            i += 1;
            i > end || !optional
        });
    }
    parts.into_iter().map(|(part, _)| part).collect()
}

/// A name without the number at its end, and that number.
fn numbered(name: &str) -> Option<(&str, usize)> {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    Some((stem, name[stem.len()..].parse().ok()?))
}

/// Names of one kind in a row of them, as `u` and `f` of `$u1 $f1 $u2 $f2 ...`, and the last number.
fn row<'a>(parts: &[Part<'a>], more: usize) -> Option<(Vec<&'a str>, usize)> {
    let mut stems = vec![];
    let mut last = None;
    for part in parts[..more].iter().rev() {
        let Part::Word(name) = part else { break };
        let Some((stem, i)) = numbered(name) else { break };
        if stems.contains(&stem) {
            break;
        }
        last = last.or(Some(i));
        stems.insert(0, stem);
    }
    Some((stems, last?)).filter(|(stems, _)| !stems.is_empty())
}

/// The place of a name that the words of a message contain: from `from` on first, then anywhere.
fn named_in(what: &str, parts: &[Part<'_>], from: usize) -> Option<usize> {
    let words: Vec<&str> = what.split(' ').collect();
    let joined = match words[..] {
        [.., stem, i] if i.parse::<usize>().is_ok() => format!("{stem}{i}"),
        _ => String::new(),
    };
    let is = |part: &Part<'_>| matches!(part, Part::Word(n) if *n == joined || words.last() == Some(n));
    parts.iter().skip(from).position(is).map(|i| from + i).or_else(|| parts.iter().position(is))
}

/// A name that no other number has: with its option before it, or a count behind it.
fn unique(name: &str, option: Option<&String>, names: &[(usize, String)]) -> String {
    let free = |name: &String| names.iter().all(|(_, n)| n != name);
    let with_option = option.map(|option| format!("{option} {name}"));
    let candidates = std::iter::once(name.to_owned()).chain(with_option);
    candidates.chain((2..).map(|i| format!("{name}{i}"))).find(free).unwrap_or_default()
}

/// Places and names of the numbers of a call, but for counts, switches and tags. `numbers` are in order.
///
/// A number is named as the usage line names it: by the name in its message, else by its place. The second number of
/// a name is told from the first by its option, as in `-DMBuck alpha`.
pub(crate) fn number_names(usage: &str, words: &[String], numbers: &[NumberNote]) -> Vec<(usize, String)> {
    let parts = parts(usage, words.len().saturating_sub(usage.split(' ').take_while(|w| *w != "$tag").count() + 1));
    let (mut at, mut seen, mut beyond) = (0, 0, 0);
    let mut option = None;
    let mut names: Vec<(usize, String)> = vec![];
    for NumberNote { word: i, what, whole } in numbers {
        let flag = words[seen..*i].iter().rev().find_map(|w| {
            let place = parts.iter().position(|p| *p == Part::Option(w))?;
            Some((w, place))
        });
        if let Some((w, place)) = flag {
            (option, at, beyond) = (Some(w), place + 1, 0);
        }
        seen = i + 1;
        let name = match (named_in(what, &parts, at), parts.get(at)) {
            (Some(place), _) => {
                at = place + 1;
                let Part::Word(name) = parts[place] else { continue };
                name.to_owned()
            }
            (None, Some(Part::Word(name))) => {
                at += 1;
                (*name).to_owned()
            }
            (None, Some(Part::More)) if row(&parts, at).is_some() => {
                let Some((stems, last)) = row(&parts, at) else { continue };
                beyond += 1;
                format!("{}{}", stems[(beyond - 1) % stems.len()], last + 1 + (beyond - 1) / stems.len())
            }
            // One name stands for a list: the second number is `name2`.
            _ => {
                beyond += 1;
                match at.checked_sub(1).map(|i| parts[i]) {
                    Some(Part::Word(name)) => format!("{name}{}", beyond + 1),
                    _ => what.rsplit(' ').next().unwrap_or(what).to_owned(),
                }
            }
        };
        if *whole {
            continue;
        }
        names.push((*i, unique(&name, option, &names)));
    }
    names
}

#[cfg(test)]
mod tests {
    use super::{NumberNote, number_names};

    fn names(usage: &str, words: &str, numbers: &[(usize, &str)]) -> Vec<String> {
        let words: Vec<String> = words.split(' ').map(str::to_owned).collect();
        let note =
            |(word, what): &(usize, &str)| NumberNote { word: *word, what: (*what).to_owned(), whole: *what == "tag" };
        let numbers: Vec<_> = numbers.iter().map(note).collect();
        number_names(usage, &words, &numbers).into_iter().map(|(_, name)| name).collect()
    }

    #[test]
    fn numbers_are_named_by_place_by_message_and_by_option() {
        let usage = "m K $tag $E <$fy $b> <-kin $b $r> <-e $e1 $e2 ...>";
        let numbers = [(3, "modulus"), (4, "ratio b"), (6, "ratio"), (7, "radius"), (9, "x"), (10, "x"), (11, "x")];
        let of = names(usage, "m K 1 200. 0.1 -kin 0.2 20. -e 1. 2. 3.", &numbers);
        assert_eq!(of, ["E", "b", "-kin b", "r", "e1", "e2", "e3"]);
        let after_a_tag = names("m K $tag $mat $k <$c>", "m K 1 7 200. 3.", &[(3, "tag"), (4, "x"), (5, "x")]);
        assert_eq!(after_a_tag, ["k", "c"]);
        let usage = "m K $tag $s1p <$s2p> $s1n <$s2n> $beta <$r>";
        assert_eq!(names(usage, "m K 1 2 3 4", &[3, 4, 5].map(|i| (i, "n"))), ["s1p", "s1n", "beta"]);
        let all = names(usage, "m K 1 2 3 4 5 6 7", &[3, 4, 5, 6, 7, 8].map(|i| (i, "n")));
        assert_eq!(all, ["s1p", "s2p", "s1n", "s2n", "beta", "r"]);
        let pairs = names("m K $tag $u1 $f1 <$u2 $f2 ...>", "m K 1 1 2 3 4 5 6", &[3, 4, 5, 6, 7, 8].map(|i| (i, "n")));
        assert_eq!(pairs, ["u1", "f1", "u2", "f2", "u3", "f3"]);
    }
}
