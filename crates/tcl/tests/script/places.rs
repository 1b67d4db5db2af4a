//! Errors point into the script: file, line, column, word, and the calls that led there.

use hysteron_tcl::ScriptError;

use super::{error, interp};

/// `line:column word` of an error.
fn place(script: &str) -> String {
    let (mut interp, ..) = interp();
    let e = error(&mut interp, script);
    told(&interp, &e)
}

fn told(interp: &hysteron_tcl::Interp<()>, e: &ScriptError) -> String {
    let span = e.diagnostic.span.unwrap_or_else(|| panic!("no place: {}", e.result));
    let at = interp.sources.location(span);
    format!("{}:{} {}", at.line, at.column, interp.sources.snippet(span))
}

#[test]
fn the_offending_word() {
    assert_eq!(place("set a 1\nputs $b"), "2:6 $b");
    assert_eq!(place("  nosuch 1 2"), "1:3 nosuch");
    assert_eq!(place("set l {a b}\nlindex $l x"), "2:11 x");
    assert_eq!(place("string lenght abc"), "1:8 lenght");
    assert_eq!(place("lsort -intger {1 2}"), "1:7 -intger");
    assert_eq!(place("puts \"a $b c\""), "1:9 $b");
    assert_eq!(place("puts [list a [set nosuch]]"), "1:19 nosuch");
    assert_eq!(place("puts é; puts $b"), "1:14 $b");
    assert_eq!(place("incr i abc"), "1:8 abc");
    assert_eq!(place("set x(1) 2\nputs $x(2)"), "2:6 $x(2)");
    assert_eq!(place("source nosuch.tcl"), "1:8 nosuch.tcl");
    assert_eq!(place("open nosuch.txt"), "1:6 nosuch.txt");
    assert_eq!(place("proc f {a} {}\nf 1 2"), "2:1 f 1 2");
    assert_eq!(place("list {*}$nosuch"), "1:9 $nosuch");
    assert_eq!(place("set args {a b c}\nstring {*}$args"), "2:8 {*}$args");
}

#[test]
fn within_expressions() {
    assert_eq!(place("expr {1 + $x}"), "1:11 $x");
    assert_eq!(place("set x abc\nexpr {2 * $x}"), "2:11 $x");
    assert_eq!(place("set x abc\nset y [expr {$x + 2}]"), "2:14 $x");
    assert_eq!(place("expr {1 + sin(1, 2)}"), "1:11 sin(1, 2)");
    assert_eq!(place("expr {1 + sqr(2)}"), "1:11 sqr(2)");
    assert_eq!(place("expr {1 + foo}"), "1:11 foo");
    assert_eq!(place("expr {(1 + 2}"), "1:13 ");
    assert_eq!(place("if {$x > 1} {}"), "1:5 $x");
    assert_eq!(place("set x a\nif {$x} {}"), "2:5 $x");
    assert_eq!(place("set i a\nwhile {$i > 5 && 1 + $i} {}"), "2:22 $i");
    assert_eq!(place("set x abc\nexpr $x * 2"), "2:6 $x");
    assert_eq!(place("expr {1 / 0}"), "1:11 0");
    assert_eq!(place("expr {1 +\n  [nosuch]}"), "2:4 nosuch");
}

#[test]
fn within_bodies_passed_on() {
    let repeat = "proc repeat {n body} {\n  for {set i 0} {$i < $n} {incr i} {\n    uplevel 1 $body\n  }\n}\n";
    assert_eq!(place(&format!("{repeat}repeat 5 {{\n  incr acc 3\n  nosuch\n}}")), "8:3 nosuch");
    assert_eq!(place("set body {\n  set x 1\n  puts $nosuch\n}\neval $body"), "3:8 $nosuch");
    assert_eq!(place("foreach x {1 2} {\n  if {$x == 2} {\n    puts $y\n  }\n}"), "3:10 $y");
    assert_eq!(place("switch a {\n  a {\n    nosuch\n  }\n}"), "3:5 nosuch");
    assert_eq!(place("namespace eval n {\n  proc f {} {\n    nosuch\n  }\n}\nn::f"), "3:5 nosuch");
    assert_eq!(place("dict for {k v} {a 1} {\n  nosuch\n}"), "2:3 nosuch");
    assert_eq!(place("apply {{x} {\n  nosuch\n}} 1"), "2:3 nosuch");
    assert_eq!(place("set bodies [list {puts a} {\n nosuch}]\neval [lindex $bodies 1]"), "2:2 nosuch");
    assert_eq!(place("array set b {one {\n  nosuch\n}}\neval $b(one)"), "2:3 nosuch");
    assert_eq!(place("try {\n nosuch\n} finally {}"), "2:2 nosuch");
    assert_eq!(place("lmap x {1} {\n nosuch}"), "2:2 nosuch");
}

#[test]
fn continued_lines_do_not_shift_it() {
    assert_eq!(place("set a \\\n  1\nputs $b"), "3:6 $b");
    assert_eq!(place("if 1 {\n  set a \\\n     1\n  puts $b\n}"), "4:8 $b");
    assert_eq!(place("if 1 {\n  list a \\\n     b $c \\\n    d\n}"), "3:8 $c");
    assert_eq!(place("if 1 {\n  if 1 {\n  list a \\\n     b \\\n   c \\\n    $d\n}\n}"), "6:5 $d");
    assert_eq!(place("eval \"list a \\$\\\n  b; nosuch\""), "2:6 nosuch");
    assert_eq!(place("expr {1 + \\\n   $x}"), "2:4 $x");
}

#[test]
fn text_built_at_run_time_points_at_the_word_that_evaluates_it() {
    assert_eq!(place("set c nosuch\neval \"$c 1\""), "2:6 \"$c 1\"");
    assert_eq!(place("set c nosuch\neval $c"), "1:7 nosuch");
    assert_eq!(place("set c nosuch\nuplevel #0 \"$c 1\""), "2:12 \"$c 1\"");
    assert_eq!(place("set c nosuch\nif 1 \"$c 2\""), "2:6 \"$c 2\"");
    assert_eq!(place("set x 1\nset v nosuch\nexpr \"\\$$v + $x\""), "3:6 \"\\$$v + $x\"");
}

#[test]
fn texts_that_are_no_scripts() {
    assert_eq!(place("set a 1\nif 1 {\n  set b 2\n"), "2:6 {");
    assert_eq!(place("set a \"b\nset c"), "1:7 \"");
    assert_eq!(place("set a [list b"), "1:7 [");
    assert_eq!(place("set a {b}c"), "1:10 c");
    assert_eq!(place("set a \"b\"c d"), "1:10 c");
    assert_eq!(place("set a ${b"), "1:7 ${");
    assert_eq!(place("set a $b(c"), "1:9 (");
    assert_eq!(place("proc f {} {\n  set a {\n  }\n"), "1:11 {");
    assert_eq!(place("if 1 {\n  set a \"b\n}"), "2:9 \"");
    assert_eq!(place("set l \"a {b\"\nllength $l"), "2:9 $l");
}

#[test]
fn the_chain_of_calls() {
    let (mut interp, _, files) = interp();
    files.insert("/helpers.tcl", "proc storey {n} {\n    brace $n\n}\nproc brace {n} {\n    node $n\n}\n");
    files.insert("/main.tcl", "source helpers.tcl\nforeach i {1 2} {\n    storey $i\n}\n");
    let Err(hysteron_tcl::Exception::Error(e)) = interp.eval_file("/main.tcl") else { panic!("no error") };
    assert_eq!(told(&interp, &e), "5:5 node");
    assert_eq!(&*interp.sources.location(e.diagnostic.span.unwrap()).name, "helpers.tcl");
    let chain: Vec<String> =
        e.diagnostic.callers.iter().map(|c| format!("{} {}", c.what, interp.sources.location(c.span))).collect();
    assert_eq!(chain, ["proc \"brace\" helpers.tcl:2:5", "proc \"storey\" /main.tcl:3:5"]);
    files.insert("/main.tcl", "proc load_it {} {\n  source bad.tcl\n}\nload_it\n");
    files.insert("/bad.tcl", "set x 1\nfoo\n");
    let Err(hysteron_tcl::Exception::Error(e)) = interp.eval_file("/main.tcl") else { panic!("no error") };
    assert_eq!(told(&interp, &e), "2:1 foo");
    let chain: Vec<&str> = e.diagnostic.callers.iter().map(|c| c.what.as_str()).collect();
    assert_eq!(chain, ["source \"bad.tcl\"", "proc \"load_it\""]);
}

#[test]
fn the_nearest_name_is_offered() {
    let help = |script: &str| {
        let (mut interp, ..) = interp();
        error(&mut interp, script).diagnostic.help
    };
    assert_eq!(help("set storey 1\nputs $story"), ["did you mean \"storey\"?"]);
    assert_eq!(help("set length 1\nproc f {} {puts $lenght}\nf"), ["did you mean \"::length\"?"]);
    assert_eq!(help("string lenght a"), ["did you mean \"length\"?"]);
    assert_eq!(help("lsort -intger {1 2}"), ["did you mean \"-integer\"?"]);
    assert_eq!(help("expr {sqr(2)}"), ["did you mean \"sqrt\"?"]);
    assert_eq!(help("array set a {one 1 two 2}; puts $a(tow)"), ["did you mean \"a(two)\"?"]);
    assert_eq!(help("dict get {length 1} lenght"), ["did you mean \"length\"?"]);
}

#[test]
fn an_error_thrown_again_keeps_its_place() {
    let script = "proc f {} {\n  try {\n    nosuch\n  } finally {\n    set x 1\n  }\n}\nf";
    assert_eq!(place(script), "3:5 nosuch");
}
