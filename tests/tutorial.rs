//! The tutorials do what they say: files are written, commands run and outputs compared as `docs/tutorial` has them.
//!
//! The first word after the language of a fenced block says what it is: `file=NAME` a file to write, `output` what the
//! commands before it print, `excerpt=NAME` lines of a file that is there by then, `status=N` commands that end with this
//! status in place of 0. `...` stands for anything.

#![cfg(unix)]
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A fenced block: its info string and its lines.
struct Block {
    info: String,
    text: String,
    line: usize,
}

fn blocks(page: &str) -> Vec<Block> {
    let mut out: Vec<Block> = vec![];
    let mut open = false;
    for (i, line) in page.lines().enumerate() {
        match (line.strip_prefix("```"), open) {
            (Some(info), false) => {
                out.push(Block { info: info.to_owned(), text: String::new(), line: i + 1 });
                open = true;
            }
            (Some(_), true) => open = false,
            (None, true) => {
                let block = out.last_mut().unwrap();
                block.text += line;
                block.text.push('\n');
            }
            (None, false) => {}
        }
    }
    assert!(!open, "a block has no end");
    out
}

/// True if `text` is `shown`, in which `...` stands for anything.
fn matches(shown: &str, text: &str) -> bool {
    let mut parts = shown.split("...");
    let first = parts.next().unwrap_or_default();
    let Some(mut rest) = text.strip_prefix(first) else { return false };
    let parts: Vec<&str> = parts.collect();
    let Some((last, middle)) = parts.split_last() else { return rest.is_empty() };
    for part in middle {
        let Some(at) = rest.find(part) else { return false };
        rest = &rest[at + part.len()..];
    }
    rest.ends_with(last)
}

/// The first line that is shown and is not there, after those before it.
fn missing<'a>(shown: &'a str, text: &str) -> Option<&'a str> {
    let mut lines = text.lines();
    shown.lines().filter(|l| l.trim() != "...").find(|line| !lines.any(|l| matches(line.trim_end(), l.trim_end())))
}

/// Words of a command line, as a shell would have them.
fn words(line: &str) -> Vec<String> {
    let mut out = vec![];
    for (i, part) in line.split(['"', '\'']).enumerate() {
        if i % 2 == 1 {
            out.push(part.to_owned());
        } else {
            out.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    out
}

/// Follow a page in a folder of its own; the number of commands that were run.
fn follow(name: &str) -> usize {
    follow_page(&format!("docs/tutorial/{name}"))
}

/// The same for a page of any folder.
fn follow_page(name: &str) -> usize {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(root.join(name)).unwrap();
    let stem = name.replace('/', "-");
    let dir: PathBuf = std::env::temp_dir().join(format!("hysteron-tutorial-{stem}-{}", std::process::id()));
    let _ = fs::remove_dir_all(&dir);
    fs::create_dir_all(&dir).unwrap();
    for shipped in ["tcl-like-inputs", "models"] {
        std::os::unix::fs::symlink(root.join(shipped), dir.join(shipped)).unwrap();
    }
    let (mut said, mut commands) = (String::new(), 0);
    for block in blocks(&page) {
        let (language, rest) = block.info.split_once(' ').unwrap_or((&block.info, ""));
        let place = format!("{name}:{}", block.line);
        if let Some(file) = rest.strip_prefix("file=") {
            fs::write(dir.join(file), &block.text).unwrap();
        } else if let Some(file) = rest.strip_prefix("excerpt=") {
            let text = fs::read_to_string(dir.join(file)).unwrap_or_else(|e| panic!("{place}: {file}: {e}"));
            let none = missing(&block.text, &text);
            assert!(none.is_none(), "{place}: {file} has not {none:?} where it stands:\n{text}");
        } else if rest == "output" {
            let none = missing(&block.text, &said);
            assert!(none.is_none(), "{place}: not printed: {none:?}\n{said}");
        } else if language == "sh" {
            let status: i32 = rest.strip_prefix("status=").map_or(0, |n| n.parse().unwrap());
            said.clear();
            for line in block.text.lines().filter(|l| l.starts_with("hysteron ")) {
                let done = Command::new(env!("CARGO_BIN_EXE_hysteron"))
                    .args(&words(line)[1..])
                    .current_dir(&dir)
                    .output()
                    .unwrap();
                said += &String::from_utf8_lossy(&done.stdout);
                said += &String::from_utf8_lossy(&done.stderr);
                assert_eq!(done.status.code(), Some(status), "{place}: {line}\n{said}");
                commands += 1;
            }
        } else {
            assert!(rest.is_empty(), "{place}: \"{rest}\" is no kind of block");
        }
    }
    for file in ["results/pad/calibration.json", "results/diagnosis.json"] {
        if let Ok(text) = fs::read_to_string(dir.join(file)) {
            let told = fs::read_to_string(root.join("docs/reference/study.md")).unwrap();
            let mut missing = vec![];
            untold(&serde_json::from_str(&text).unwrap(), &told, &mut missing);
            assert!(missing.is_empty(), "docs/reference/study.md does not tell of {missing:?} of {file}");
        }
    }
    fs::remove_dir_all(dir).unwrap();
    commands
}

/// Tables whose keys are names of parameters, numbers, features or mishaps.
const NAMED_BY_DATA: [&str; 6] = ["parameters", "failures", "prior", "weights", "structure_before", "structure_after"];

/// Keys of a result file that a page does not tell of; names of parameters and of mishaps are the study's own.
fn untold(value: &serde_json::Value, page: &str, out: &mut Vec<String>) {
    match value {
        serde_json::Value::Object(map) => {
            for (key, inner) in map {
                if ![format!("`{key}`"), format!(".{key}`")].iter().any(|k| page.contains(k)) {
                    out.push(key.clone());
                }
                if !NAMED_BY_DATA.contains(&key.as_str()) {
                    untold(inner, page, out);
                }
            }
        }
        serde_json::Value::Array(list) => list.iter().for_each(|v| untold(v, page, out)),
        _ => {}
    }
}

#[test]
fn the_front_page() {
    assert_eq!(follow_page("README.md"), 10);
}

#[test]
fn a_first_analysis() {
    assert_eq!(follow("first-analysis.md"), 5);
}

#[test]
fn coming_from_another_program() {
    assert_eq!(follow_page("docs/explanation/from-sap2000.md"), 1);
}

#[test]
fn calibrating_a_bearing() {
    assert_eq!(follow("calibration.md"), 2);
}

#[test]
fn a_first_diagnosis() {
    assert_eq!(follow("diagnosis.md"), 3);
}

#[test]
fn a_shaken_building() {
    assert_eq!(follow("building.md"), 5);
}

#[test]
fn from_prototype_tests_to_the_design_table() {
    assert_eq!(follow("isolation.md"), 8);
}

#[test]
fn an_isolated_bridge() {
    assert_eq!(follow("bridge.md"), 4);
}

/// Pages of commands without an example that can be run: an editor talks to `lsp`.
const WITHOUT_EXAMPLE: [&str; 2] = ["index.md", "lsp.md"];

#[test]
fn examples_of_the_commands() {
    let folder = "docs/reference/command-line";
    let entries = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap();
    let mut pages: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    pages.retain(|p| !WITHOUT_EXAMPLE.contains(&p.as_str()));
    pages.sort();
    for page in pages {
        assert!(follow_page(&format!("{folder}/{page}")) >= 2, "{page} has no example and no error");
    }
}

#[test]
fn an_output_that_differs_is_seen() {
    assert_eq!(missing("peak ... mm\n", "peak 3 mm\n"), None);
    assert_eq!(missing("a\n...\nc\n", "a\nb\nc\n"), None);
    assert!(missing("peak 4 mm\n", "peak 3 mm\n").is_some());
    assert!(missing("c\na\n", "a\nb\nc\n").is_some());
    assert!(missing("peak ... mm\n", "peak 3 m\n").is_some());
    assert_eq!(words("hysteron bearing --device \"lrb 1\""), ["hysteron", "bearing", "--device", "lrb 1"]);
}
