//! Files of Python: what is told of their calls, and what is not.

#![allow(clippy::unwrap_used)]

use hysteron_calls::{Settings, check};
use hysteron_engine::analysis::Options;
use hysteron_opensees::{Mode, run};
use hysteron_tcl::MemoryFiles;
use std::sync::Arc;

const HEAD: &str = "import openseespy.opensees as ops\nops.wipe()\nops.model('basic', '-ndm', 2, '-ndf', 3)\n";

/// Findings as `line:word code message`.
fn told(text: &str) -> Vec<String> {
    let run = run::Settings { mode: Mode::Check, strict: false, options: Options::default() };
    let settings = Settings { run, files: Box::new(MemoryFiles::default()), stop: Arc::default(), index: true };
    let Some(checked) = check("m.py", text, settings) else { return vec!["no calls".into()] };
    let interp = &checked.run.interp;
    let line = |d: &hysteron_tcl::diagnostic::Diagnostic| {
        let at = d.span.map(|s| (interp.sources.location(s).line, interp.sources.snippet(s).to_owned()));
        let (line, word) = at.unwrap_or_default();
        format!("{line}:{} {} {}", word.lines().next().unwrap_or_default(), d.code(), d.message)
    };
    interp.warnings.iter().map(line).collect()
}

fn after(lines: &str) -> Vec<String> {
    told(&format!("{HEAD}{lines}"))
}

#[test]
fn literal_calls_are_checked_at_the_argument() {
    let lines = "L = 6.0\nH = L/2\nops.node(1, 0, 0); ops.node(2, L, 'x')\nops.node(1, *[0.0, H])\nops.fix(9, 1, 1, 1)\n\
        ops.uniaxialMaterial('Stel01', 1, 1, 1, 0.1)\nops.uniaxialMaterial('Steel01', 2, 1.0, -L, 0.1)\n\
        ops.uniaxialMaterial('Elastic', 3)\nops.fix(1, 1, 1, 2)\nops.nod(3, 0, 0)\n";
    assert_eq!(
        after(lines),
        [
            "6:'x' not-a-number y coordinate is not a number: \"x\"",
            "7:1 tag-in-use there is a node 1 already",
            "8:9 not-defined there is no node 9",
            "9:'Stel01' unknown-kind unknown uniaxial material \"Stel01\"",
            "10:-L out-of-range elastic modulus E0 is -6",
            "11:uniaxialMaterial('Elastic', 3) missing-word uniaxialMaterial: the elastic modulus E is missing",
            "12:2 no-flag flag of degree of freedom 3 is 2 and counts as 1",
            "13:nod unknown-command unknown command \"nod\"",
        ]
    );
}

#[test]
fn all_ways_to_import_the_commands_count() {
    for (import, call) in [
        ("from openseespy.opensees import *", "model('basic', '-ndm', 1); node(1, 'x')"),
        ("from openseespy import opensees as o", "o.model('basic', '-ndm', 1); o.node(1, 'x')"),
        (
            "import openseespy.opensees",
            "openseespy.opensees.model('basic', '-ndm', 1); openseespy.opensees.node(1, 'x')",
        ),
        ("from hysteron.opensees import model, node as n", "model('basic', '-ndm', 1); n(1, 'x')"),
    ] {
        let found = told(&format!("{import}\n{call}\n"));
        assert_eq!(found, ["2:'x' not-a-number x coordinate is not a number: \"x\""], "{import}");
    }
    assert_eq!(told("import numpy as ops\nops.node(1, 'x')\n"), ["no calls"]);
}

/// Behind a loop the model is not known: the words of calls are checked alone.
#[test]
fn what_depends_on_the_model_is_told_of_straight_calls_alone() {
    let lines = "for i in range(3):\n    ops.node(i + 1, 3.0*i, 0.0)\nops.fix(2, 1, 1, 1)\nops.fix(77, 1, 1)\n\
        ops.element('truss', 1, 1, 2, 'A', 1)\nops.element('trus', 2, 1, 2, 0.1, 1)\nops.element('truss', 1, 1, 2, 0.1, 1)\n\
        ops.element('trus', i, 1, 2, 0.1, 1)\n";
    assert_eq!(
        after(lines),
        [
            "8:'A' not-a-number cross-sectional area A is not a number: \"A\"",
            "9:'trus' unknown-kind unknown element \"trus\"",
            "11:'trus' unknown-kind unknown element \"trus\"",
        ]
    );
    // A function that is called may do anything; one that is not called does nothing.
    assert_eq!(after("def f():\n    ops.node(1, 0, 0)\nops.fix(1, 1, 1, 1)\n").len(), 1);
    for body in [
        "def f():\n    ops.node(1, 0, 0)\nf()\nops.fix(1, 1, 1, 1)\n",
        "import helper\nops.fix(1, 1, 1, 1)\n",
        "if L > 2:\n    ops.node(1, 0, 0)\nops.fix(1, 1, 1, 1)\n",
        "exec(open('a.py').read())\nops.fix(1, 1, 1, 1)\n",
        "try:\n    ops.fix(1, 1, 1, 'x')\nexcept Exception:\n    pass\n",
        "a = [ops.node(i, i, 0) for i in (1, 2)]\nops.fix(1, 1, 1, 1)\n",
        "f = lambda: ops.node(1, 0, 0)\nf()\nops.fix(1, 1, 1, 1)\n",
        "x and ops.node(1, 0, 0)\nops.node(1, 0, 0)\n",
        "tag = 1\ntag += 1\nops.node(tag, 0, 0)\nops.node(tag, 1, 0)\n",
    ] {
        assert_eq!(after(body), [] as [&str; 0], "{body}");
    }
}

/// A call that changes no model leaves it known.
#[test]
fn plots_and_queries_leave_the_model_known() {
    let lines = "import numpy as np, matplotlib.pyplot as plt\nxs = []\nfor x in np.linspace(0, 1, 5):\n    xs.append(x)\n\
        plt.plot(xs)\nprint(len(xs), ops.getNodeTags())\nif __name__ == '__main__':\n    ops.fix(5, 1, 1, 1)\n";
    assert_eq!(after(lines), ["11:5 not-defined there is no node 5"]);
}

/// Kinds and commands that OpenSees alone has are right in its module.
#[test]
fn names_of_opensees_alone_are_told_for_hysteron_only() {
    let lines = |module: &str| {
        format!(
            "import {module}.opensees as ops\nops.model('basic', '-ndm', 1)\nops.uniaxialMaterial('Masonryt', 1, 2)\n\
                 ops.setNumThreads(2)\n"
        )
    };
    assert_eq!(told(&lines("openseespy")), [] as [&str; 0]);
    assert_eq!(told(&lines("hysteron")).len(), 2);
}

#[test]
fn half_typed_text_is_told_where_it_is_open() {
    assert_eq!(after("ops.node(1, 0, 0)\nops.node(2, 0"), ["5:( never-closed \"(\" is never closed"]);
    for text in
        ["ops.node(", "ops.", "'", "ops.node(1,,)", "ops.node(*)", "ops.node(1, 2 3)", "def", "if", "for x in", "x ="]
    {
        let _ = after(text);
    }
}

/// The help shows how Python writes the command.
#[test]
fn help_is_written_as_calls() {
    let run = run::Settings { mode: Mode::Check, strict: false, options: Options::default() };
    let settings = Settings { run, files: Box::new(MemoryFiles::default()), stop: Arc::default(), index: false };
    let checked = check("m.py", &format!("{HEAD}ops.node(1)\n"), settings).unwrap();
    let help = &checked.run.interp.warnings[0].help;
    assert!(help.iter().any(|h| h.starts_with("usage: node(tag, x")), "{help:?}");
}
