//! Names that a file binds once.

use crate::token::{Kind, Tokens};
use std::collections::BTreeMap;

/// Words after which a name is bound.
const BINDING: [&str; 8] = ["as", "def", "class", "global", "nonlocal", "del", "import", "lambda"];

/// Number of times that each name is bound anywhere in a file. A name that only looks as if it were bound counts too.
pub(crate) fn bindings(text: &str, tokens: &Tokens) -> BTreeMap<String, usize> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for line in &tokens.lines {
        let all = &tokens.all[line.tokens.clone()];
        let word = |i: usize| all.get(i).map_or("", |t| &text[t.at.clone()]);
        let mut bind = |i: usize| {
            if all.get(i).is_some_and(|t| t.kind == Kind::Name) {
                *counts.entry(word(i).to_owned()).or_default() += 1;
            }
        };
        let is_head = matches!(word(0), "def" | "async");
        let (mut depth, mut statement) = (0_usize, 0);
        let mut i = 0;
        while i < all.len() {
            match word(i) {
                "(" | "[" | "{" => depth += 1,
                ")" | "]" | "}" => depth = depth.saturating_sub(1),
                ";" if depth == 0 => statement = i + 1,
                ":=" => bind(i.saturating_sub(1)),
                "for" => {
                    let end = (i..all.len()).find(|j| word(*j) == "in").unwrap_or(all.len());
                    (i + 1..end).for_each(&mut bind);
                }
                "lambda" => {
                    let end = (i..all.len()).find(|j| word(*j) == ":").unwrap_or(all.len());
                    (i + 1..end).for_each(&mut bind);
                }
                sign if depth == 0 && sign.ends_with('=') && !matches!(sign, "==" | "!=" | "<=" | ">=") => {
                    (statement..i).for_each(&mut bind);
                    statement = i + 1;
                }
                word if BINDING.contains(&word) => {
                    // `import a, b` and `global a, b` bind several.
                    let several = matches!(word, "global" | "nonlocal" | "del" | "import");
                    let end = if several { all.len() } else { i + 2 };
                    (i + 1..end).for_each(&mut bind);
                }
                _ if is_head && depth > 0 => bind(i),
                _ => {}
            }
            i += 1;
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::bindings;
    use crate::token::Tokens;

    #[test]
    fn names_that_are_bound_once_are_told_from_others() {
        let text = "import numpy as np\nL = 3.0\nH: float = 2\na, b = 1, 2\nfor i in range(3): L2 = i\nn = 1\nn += 1\n\
                    def f(H2, w=L): return w\nx = [k for k in a]; y = 1\nif (z := 3) == z: pass\nfixed(L=4)\n";
        let counts = bindings(text, &Tokens::of(text));
        let count = |name: &str| counts.get(name).copied().unwrap_or(0);
        for name in ["L", "H", "a", "b", "i", "L2", "x", "y", "z", "k", "np", "f", "H2"] {
            assert!(count(name) >= 1, "{name}");
        }
        assert_eq!((count("H"), count("a"), count("x"), count("y"), count("n")), (1, 1, 1, 1, 2));
        assert_eq!(count("fixed"), 0);
    }
}
