//! Pages are read sentence by sentence: nine of ten have at most twenty words.

use std::fs;
use std::path::{Path, PathBuf};

/// Words of the sentence at the 90th percentile of a page, at most.
const MAX_WORDS: usize = 20;
/// Fewest sentences of a page that is judged.
const MIN_SENTENCES: usize = 10;
/// Pages whose sentences are formulas, or rows that the usage of commands gives.
const OF_FORMULAS: [&str; 2] = ["docs/verification", "docs/reference/commands"];

/// Markdown pages below a folder.
pub(super) fn pages_below(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            pages_below(&path, found);
        } else if path.extension().is_some_and(|e| e == "md") {
            found.push(path);
        }
    }
}

/// The text without spans of code, and without the targets of links.
fn plain(text: &str) -> String {
    let without_code: Vec<&str> =
        text.split('`').enumerate().map(|(i, part)| if i % 2 == 0 { part } else { "X" }).collect();
    let mut out = String::new();
    let mut rest = without_code.concat();
    while let Some(begin) = rest.find("](") {
        let Some(end) = rest[begin..].find(')') else { break };
        out += &rest[..begin];
        rest = rest[begin + end + 1..].to_owned();
    }
    (out + &rest).replace(['[', ']'], "")
}

/// Paragraphs, items of lists and cells of tables.
fn blocks(page: &str) -> Vec<String> {
    let (mut all, mut open, mut in_code) = (vec![], String::new(), false);
    for line in page.lines() {
        let text = line.trim();
        if text.starts_with("```") {
            in_code = !in_code;
        }
        let numbered = text.split_once(". ").is_some_and(|(n, _)| n.parse::<u32>().is_ok());
        let item = text.strip_prefix("- ").or_else(|| text.split_once(". ").filter(|_| numbered).map(|(_, t)| t));
        let ends = in_code || text.is_empty() || text.starts_with(['#', '|', '<']) || text.starts_with("```");
        if ends || item.is_some() || line.starts_with("    ") {
            all.push(std::mem::take(&mut open));
        }
        if in_code || line.starts_with("    ") {
            continue;
        }
        match item {
            Some(item) => open += item,
            None if text.starts_with('|') => all.extend(text.split('|').map(|cell| cell.trim().to_owned())),
            None if !ends => {
                open.push(' ');
                open += text;
            }
            None => {}
        }
    }
    all.push(open);
    all
}

/// Numbers of words of the sentences of a block.
fn sentences(block: &str) -> Vec<usize> {
    let words: Vec<String> = plain(block).split_whitespace().map(str::to_owned).collect();
    let (mut all, mut count) = (vec![], 0);
    for (i, word) in words.iter().enumerate() {
        count += usize::from(word.contains(|c: char| c.is_ascii_alphanumeric()));
        let next = words.get(i + 1).and_then(|w| w.chars().next());
        let ends = word.ends_with(['.', '!', '?', ':', ';']);
        if next.is_none_or(|c| ends && (c.is_uppercase() || "*\"(".contains(c))) {
            all.push(count);
            count = 0;
        }
    }
    all.into_iter().filter(|n| *n >= 3).collect()
}

#[test]
fn nine_of_ten_sentences_of_a_page_are_short() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut pages = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"].map(|p| root.join(p)).to_vec();
    pages_below(&root.join("docs"), &mut pages);
    let mut long = vec![];
    for page in pages {
        let name = page.strip_prefix(root).unwrap().to_string_lossy().replace('\\', "/");
        let mut counts: Vec<usize> =
            blocks(&fs::read_to_string(&page).unwrap()).iter().flat_map(|b| sentences(b)).collect();
        counts.sort_unstable();
        let percentile = counts.get(counts.len() * 9 / 10).copied().unwrap_or(0);
        let is_judged = counts.len() >= MIN_SENTENCES && !OF_FORMULAS.iter().any(|p| name.starts_with(p));
        if is_judged && percentile > MAX_WORDS {
            long.push(format!("{name}: a tenth of its {} sentences has {percentile} words and more", counts.len()));
        }
    }
    assert!(long.is_empty(), "at most {MAX_WORDS} words:\n{}", long.join("\n"));
}

/// Phrases of earlier texts that a reader has to guess at.
const UNCLEAR: [&str; 4] = ["came to no end", "comes to no end", "what it leaves of", "least unreduced force"];

/// Files of source text below a folder.
fn sources_below(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources_below(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

#[test]
fn unclear_phrases_are_in_no_page_and_no_message() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = vec![root.join("README.md")];
    pages_below(&root.join("docs"), &mut files);
    ["crates", "src", "bindings/python/src"].iter().for_each(|f| sources_below(&root.join(f), &mut files));
    let mut found = vec![];
    for file in files {
        // A sentence may be broken over lines.
        let text = fs::read_to_string(&file).unwrap();
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        found.extend(UNCLEAR.iter().filter(|p| text.contains(*p)).map(|p| format!("{}: {p}", file.display())));
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn words_of_a_sentence_are_counted() {
    assert_eq!(sentences("One two three. Four five `six seven` [eight](nine.md) ten."), [3, 5]);
    assert_eq!(
        blocks("a b\nc\n\n- d\n- e\n  f\n\n```sh\nno\n```\n| g | h |").iter().filter(|b| !b.trim().is_empty()).count(),
        5
    );
}
