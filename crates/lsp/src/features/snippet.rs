//! Snippets of commands, from their usage lines.

/// Dimensions of a model and degrees of freedom of its nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Dimensions {
    pub(crate) ndm: usize,
    pub(crate) ndf: usize,
}

/// A word of a usage line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct UsageWord<'a> {
    /// As it stands there, with the brackets of an optional one.
    pub(crate) text: &'a str,
    pub(crate) is_optional: bool,
}

/// The form of a usage that suits the dimensions, where it has one for the plane and one for space.
pub(crate) fn form(usage: &str, dimensions: Option<Dimensions>) -> &str {
    let wanted = match dimensions.map(|d| d.ndm) {
        Some(3) => "(in space)",
        _ => "(in the plane)",
    };
    let forms: Vec<&str> = usage.split(" or ").collect();
    let found = forms.iter().find(|f| f.contains(wanted)).or(forms.first()).copied().unwrap_or(usage);
    found.split(" (").next().unwrap_or(found)
}

/// The words of a usage line; what is in brackets is one word.
pub(crate) fn words(usage: &str) -> Vec<UsageWord<'_>> {
    let (mut out, mut depth, mut start) = (vec![], 0_usize, 0);
    for (i, c) in usage.char_indices().chain([(usage.len(), ' ')]) {
        match c {
            '<' => depth += 1,
            '>' => depth = depth.saturating_sub(1),
            ' ' if depth == 0 => {
                let text = &usage[start..i];
                if !text.is_empty() {
                    out.push(UsageWord { text, is_optional: text.starts_with('<') });
                }
                start = i + 1;
            }
            _ => {}
        }
    }
    out
}

/// Names of the words that a model needs in the place of one that is repeated: `$x <$y <$z>>` in space, `$m1 <$m2 ...>`.
fn repeated(word: &str, next: Option<&UsageWord<'_>>, dimensions: Dimensions) -> Vec<String> {
    let Some(next) = next.filter(|n| n.is_optional) else { return vec![word.to_owned()] };
    let bare = next.text.trim_start_matches('<');
    if word == "x" && bare.starts_with("$y") {
        return ["x", "y", "z"][..dimensions.ndm.clamp(1, 3)].iter().map(|s| (*s).to_owned()).collect();
    }
    match word.strip_suffix('1') {
        Some(stem) if bare.starts_with(&format!("${stem}2")) => {
            (1..=dimensions.ndf.clamp(1, 6)).map(|i| format!("{stem}{i}")).collect()
        }
        _ => vec![word.to_owned()],
    }
}

/// The words that a command needs behind the first `given` ones of its usage, as a snippet of the protocol.
pub(crate) fn of_usage(usage: &str, given: usize, dimensions: Option<Dimensions>) -> String {
    let shown = form(usage, dimensions);
    let all = words(shown);
    let mut out = vec![];
    let mut number = 0;
    for (i, word) in all.iter().enumerate().skip(given).filter(|(_, w)| !w.is_optional) {
        let text = word.text.split('|').next().unwrap_or_default();
        let Some(name) = text.strip_prefix('$') else {
            if text != "..." && !text.is_empty() {
                out.push(escaped(text));
            }
            continue;
        };
        let names = dimensions.map_or_else(|| vec![name.to_owned()], |d| repeated(name, all.get(i + 1), d));
        for name in names {
            number += 1;
            out.push(format!("${{{number}:{}}}", escaped(&name)));
        }
    }
    out.join(" ")
}

/// A text in which a snippet has no signs of its own.
pub(crate) fn escaped(text: &str) -> String {
    text.chars().flat_map(|c| ['\\'].into_iter().filter(move |_| "$}\\".contains(c)).chain([c])).collect()
}

#[cfg(test)]
mod tests {
    use super::{Dimensions, of_usage};

    #[test]
    fn a_snippet_knows_the_dimensions() {
        let node = "node $tag $x <$y <$z>> <-ndf $ndf>";
        let space = Some(Dimensions { ndm: 3, ndf: 6 });
        let plane = Some(Dimensions { ndm: 2, ndf: 3 });
        assert_eq!(of_usage(node, 1, space), "${1:tag} ${2:x} ${3:y} ${4:z}");
        assert_eq!(of_usage(node, 1, plane), "${1:tag} ${2:x} ${3:y}");
        assert_eq!(of_usage(node, 1, None), "${1:tag} ${2:x}");
        assert_eq!(of_usage("mass $node $m1 <$m2 ...>", 1, plane), "${1:node} ${2:m1} ${3:m2} ${4:m3}");
        let beam = "element e $tag $A $Iz <$G> $t (in the plane) or $A $J $t (in space) <-mass $m>";
        assert_eq!(of_usage(beam, 2, plane), "${1:tag} ${2:A} ${3:Iz} ${4:t}");
    }
}
