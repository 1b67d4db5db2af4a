//! Scripts that go too deep, run too long or are no scripts at all. The threads of tests have 2 MiB of stack.

use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use hysteron_tcl::Exception;

use super::{error, interp, value};

const TOO_DEEP: &str = "too many nested evaluations (infinite loop?)";

#[test]
fn endless_recursion_is_an_error() {
    for script in [
        "proc f {} {f}; f",
        "proc f {n} {return [f [expr {$n + 1}]]}; f 1",
        "proc f {n} {expr {[f [expr {$n + 1}]] + 1}}; f 1",
        "proc f {} {if 1 {foreach x {1} {while 1 {f}}}}; f",
        "proc f {} {eval f}; f",
        "proc f {} {uplevel 1 f}; f",
        "proc f {} {catch {f} m; error $m}; f",
        "proc f {} {switch a {a {try {f} finally {}}}}; f",
        "proc unknown args {nosuch}; nosuch",
        "proc f {} {lsort -command {apply {{a b} f}} {1 2}}; f",
        "proc f {} {subst {[f]}}; f",
        "namespace eval a {proc f {} {namespace eval b {::a::f}}}; a::f",
        "proc tcl::mathfunc::g x {expr {g($x)}}; expr {g(1)}",
    ] {
        let (mut interp, ..) = interp();
        assert_eq!(error(&mut interp, script).result.as_str(), TOO_DEEP, "{script}");
    }
}

#[test]
fn a_thousand_levels_are_counted_as_in_tcl() {
    let count = |body: &str| value(&format!("set n 0; proc f {{}} {{global n; incr n; {body}}}; catch f; set n"));
    assert_eq!(count("f"), "999");
    assert_eq!(count("eval f"), "500");
}

#[test]
fn deep_nesting_is_an_error_or_fine() {
    let (mut interp, ..) = interp();
    let brackets = format!("set x {}a{}", "[list ".repeat(50_000), "]".repeat(50_000));
    assert!(interp.eval_str("m.tcl", &brackets).is_err());
    let parens = format!("expr {{{}1{}}}", "(".repeat(50_000), ")".repeat(50_000));
    assert!(interp.eval_str("m.tcl", &parens).is_err());
    let indices = format!("set x {}a{}", "$a(".repeat(50_000), ")".repeat(50_000));
    assert!(interp.eval_str("m.tcl", &indices).is_err());
    let sum = format!("expr {{1{}}}", "+1".repeat(50_000));
    assert_eq!(interp.eval_str("m.tcl", &sum).unwrap().as_str(), "50001");
    let minus = format!("expr {{{}1}}", "-".repeat(50_000));
    assert_eq!(interp.eval_str("m.tcl", &minus).unwrap().as_str(), "1");
    let ternary = format!("expr {{{}1}}", "1?2:".repeat(50_000));
    assert_eq!(interp.eval_str("m.tcl", &ternary).unwrap().as_str(), "2");
    let ifs = format!("{}set x 1{}", "if 1 {".repeat(3_000), "}".repeat(3_000));
    assert_eq!(interp.eval_str("m.tcl", &ifs).unwrap().as_str(), "1");
    let braces = format!("llength {}{}", "{".repeat(100_000), "}".repeat(100_000));
    assert_eq!(interp.eval_str("m.tcl", &braces).unwrap().as_str(), "1");
    let regexp = format!("regexp {{{}a{}}} a", "(".repeat(5_000), ")".repeat(5_000));
    assert!(interp.eval_str("m.tcl", &regexp).is_err());
}

#[test]
fn deep_lists_can_be_built_written_and_let_go() {
    let nest = "set x {}; for {set i 0} {$i < 200000} {incr i} {set x [list $x]}; llength $x";
    assert_eq!(value(nest), "1");
    let nest = "set x {}; for {set i 0} {$i < 2000} {incr i} {set x [list $x a]}; string length $x";
    assert_eq!(value(nest), "8000");
    let walk = "set x [string repeat \\{ 50000][string repeat \\} 50000]; set y $x; set n 0
        while {$y ne {}} {set y [lindex $y 0]; incr n}; set n";
    assert_eq!(value(walk), "50000");
    let dicts = "set d {}; for {set i 0} {$i < 100000} {incr i} {set d [dict create k $d]}; dict size $d";
    assert_eq!(value(dicts), "1");
}

#[test]
fn the_flag_interrupts() {
    let (mut interp, ..) = interp();
    let flag = interp.interrupt.clone();
    let stopper = std::thread::spawn(move || {
        std::thread::sleep(Duration::from_millis(50));
        flag.store(true, Ordering::Relaxed);
    });
    let start = Instant::now();
    let outcome = interp.eval_str("m.tcl", "while 1 {catch {while 1 {}}}");
    assert!(matches!(outcome, Err(Exception::Interrupted)));
    assert!(start.elapsed() < Duration::from_secs(5));
    stopper.join().unwrap();
}

#[test]
fn the_budget_ends_a_script() {
    let (mut interp, ..) = interp();
    interp.budget = Some(1000);
    assert!(matches!(interp.eval_str("m.tcl", "while 1 {}"), Err(Exception::Interrupted)));
    interp.budget = Some(1000);
    assert!(interp.eval_str("m.tcl", "for {set i 0} {$i < 10} {incr i} {}").is_ok());
}

#[test]
fn extreme_numbers_are_errors_or_fine() {
    let (mut interp, ..) = interp();
    interp.eval_str("m.tcl", "set f [open x w+]; puts $f abc").unwrap();
    for number in ["9223372036854775807", "-9223372036854775808", "4294967295", "-4294967295", "99999999999999999999"] {
        for script in [
            "clock add 0 N weeks",
            "clock add N 1 day -gmt 1",
            "clock scan \"N weeks ago\" -base 0",
            "clock format N -gmt 1",
            "seek $f N current",
            "seek $f N end",
            "seek $f N",
            "read $f N",
            "lindex {a b} N",
            "lindex {a b} end-N",
            "lindex {a b} N+N",
            "lrange {a b} N end",
            "linsert {a b} N c",
            "lreplace {a b} N N c",
            "string range abc N N",
            "string index abc end+N",
            "string first a abc N",
            "string last a abc N",
            "info level N",
            "info frame N",
            "uplevel N {}",
            "expr {srand(N)}",
            "expr {N << 1}",
            "expr {N >> 1}",
            "expr {-N}",
            "expr {abs(N)}",
            "expr {N % -1}",
            "expr {N / -1}",
            "expr {int(N * 1.0)}",
            "expr {round(N * 1e300)}",
            "regexp -start N a abc",
            "scan abc %Nd",
            "format %c N",
            "string wordend abc N",
            "lsearch -start N {a b} b",
            "binary scan abc @Na x",
            "chan truncate $f N",
            "after cancel N",
        ] {
            let _ = interp.eval_str("m.tcl", &script.replace('N', number));
        }
    }
}

#[test]
fn huge_results_are_refused() {
    let (mut interp, ..) = interp();
    for script in [
        "string repeat abc 99999999999",
        "lrepeat 9999999999 a",
        "format %999999999999d 1",
        "expr {1 << 99999999999}",
        "expr {10 ** 99999999999}",
        "binary format a99999999999 x",
    ] {
        error(&mut interp, script);
    }
}
