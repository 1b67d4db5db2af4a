//! Random edits of shipped inputs: the server answers, and no check fails by a fault of its own.
//!
//! `HYSTERON_EDITS=100000` makes more of them.

#![allow(clippy::unwrap_used, clippy::panic, unreachable_pub, dead_code)]

#[path = "editor/mod.rs"]
mod editor;

use editor::Editor;
use serde_json::{Value as Json, json};
use std::path::Path;

/// Edits without the variable of the environment.
const EDITS: usize = 300;
/// Edits between two waits for diagnostics.
const BURST: usize = 6;
/// Edits after which the text is that of the input again.
const RESTART: usize = 40;

const INPUTS: [&str; 5] = [
    "tcl-like-inputs/yielding_portal.tcl",
    "tcl-like-inputs/friction_pendulum.tcl",
    "tcl-like-inputs/kikuchi_bearing.tcl",
    "tcl-like-inputs/isolated_building.tcl",
    "models/rubber.tcl",
];

/// What is put into a text.
const PIECES: [&str; 30] = [
    "{",
    "}",
    "[",
    "]",
    "\"",
    "$",
    ";",
    "\\",
    "\n",
    " ",
    "#",
    "-",
    "0",
    "1e400",
    "𝛼",
    "\r",
    "node ",
    "element ",
    "$i",
    "while 1 {",
    "[expr ",
    "source x.tcl\n",
    "proc p {a} {",
    "wipe\n",
    "(",
    ")",
    "'",
    "ops.",
    ", *[",
    "    ",
];

const METHODS: [&str; 8] = [
    "textDocument/hover",
    "textDocument/completion",
    "textDocument/definition",
    "textDocument/references",
    "textDocument/signatureHelp",
    "textDocument/prepareRename",
    "textDocument/rename",
    "textDocument/documentHighlight",
];

const WHOLE: [&str; 4] = [
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/semanticTokens/full",
    "textDocument/formatting",
];

/// A generator of numbers: each test has the same.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n.max(1)
    }

    fn of<'a>(&mut self, all: &[&'a str]) -> &'a str {
        all[self.below(all.len())]
    }
}

/// The lines of the driver, which are those of the server.
fn line_lengths(text: &str) -> Vec<usize> {
    text.split('\n').map(|l| l.encode_utf16().count()).collect()
}

/// A file of Python with what a file may have.
const PYTHON: &str = "\
import openseespy.opensees as ops
import numpy as np
L, H = 6.0, 3.0
ops.wipe()
ops.model('basic', '-ndm', 2, '-ndf', 3)
def bay(i, x):
    ops.node(i, x, 0.0)  # of the ground
for i in range(1, 3):
    bay(i, L*i)
ops.node(11, *[0.0, H]); ops.fix(11, 1, 1, 1)
ops.uniaxialMaterial('Steel01', 1, 250e3, 2e8, 0.01)
ops.section('Fiber', 1)
ops.patch('rect', 1, 4, 4, -0.1, -0.1, 0.1, 0.1)
ops.element('truss', 1, 1, 11, 0.1, 1)
if __name__ == '__main__':
    ops.timeSeries('Path', 1, '-dt', 0.01, '-values', *[0.0, 1.0])
    ops.pattern('Plain', 1, 1)
    ops.load(11, 1.0, 0.0, 0.0)
    print(\"\"\"done
\"\"\", ops.nodeDisp(11, 1))
";

#[test]
fn no_edit_breaks_the_server() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let texts: Vec<String> = INPUTS.iter().map(|p| std::fs::read_to_string(root.join(p)).unwrap()).collect();
    edited("m.tcl", &texts);
}

#[test]
fn no_edit_of_python_breaks_the_server() {
    edited("m.py", &[PYTHON.to_owned()]);
}

/// Edit texts at random in an editor.
fn edited(name: &str, texts: &[String]) {
    let edits = std::env::var("HYSTERON_EDITS").ok().and_then(|n| n.parse().ok()).unwrap_or(EDITS);
    let mut random = Random(20_261_127);
    let mut e = Editor::with(json!({ "timeLimit": 2 }));
    e.open(name, &texts[0]);
    let (mut version, mut lengths) = (1, line_lengths(&texts[0]));
    for n in 0..edits {
        version += 1;
        if n % RESTART == 0 {
            let text = &texts[(n / RESTART) % texts.len()];
            e.replace(name, version, text);
            lengths = line_lengths(text);
        } else {
            // Positions are those of the input: behind later edits they are anywhere, as an editor's never are.
            let line = random.below(lengths.len());
            let character = random.below(lengths[line] + 1);
            let removed = [0, 0, 1, 3, 20][random.below(5)];
            let lines = random.below(8) / 7;
            let range = [line as u32, character as u32, (line + lines) as u32, (character + removed) as u32];
            let piece = if removed > 0 && random.below(2) == 0 { "" } else { random.of(&PIECES) };
            e.edit(name, version, range, piece);
        }
        let (line, character) = (random.below(lengths.len()) as u32, random.below(60) as u32);
        let answer = match random.below(4) {
            0 => {
                let options = json!({ "tabSize": 4, "insertSpaces": true });
                let method = random.of(&WHOLE);
                e.request(method, json!({ "textDocument": { "uri": e.uri(name) }, "options": options }))
            }
            _ => {
                let more = json!({ "newName": "9", "context": { "includeDeclaration": true } });
                e.at(random.of(&METHODS), name, line, character, more)
            }
        };
        assert!(answer["error"].as_str().is_none_or(|m| !m.ends_with(" failed")), "edit {n}: {answer}");
        if n % BURST == 0 || n + 1 == edits {
            let told = e.diagnostics(name, version);
            let fault = |d: &Json| d["message"].as_str().unwrap().contains("fault of hysteron");
            assert!(!told.iter().any(fault), "edit {n}: {told:?}");
        }
    }
    assert_eq!(e.end(), Ok(()));
}
