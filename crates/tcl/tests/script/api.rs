//! Interface between interpreter and host.

use hysteron_tcl::diagnostic::{Check, Diagnostic};
use hysteron_tcl::{Call, Exception, Interp, MemoryFiles, Recorded, Value};

use super::{elements, error, interp, value};

static LARGE: Check = Check::new("large", "An amount is large.", "Take less.");

fn add(interp: &mut Interp<f64>, call: &Call<'_>) -> Result<Value, Exception> {
    if call.len() != 2 {
        return Err(call.usage(1, "amount"));
    }
    let amount = call.arg(1).to_f64()?;
    if amount < 0.0 {
        let diagnostic = Diagnostic::error("amount is negative").at(call.span(1), "must not be negative");
        return Err(call.refuse(1, diagnostic));
    }
    if amount > 1e3 {
        interp.warn(Diagnostic::warning(&LARGE, "a large amount").at(call.span(1), "more than 1000"));
    }
    interp.host += amount;
    Ok(Value::from(interp.host))
}

fn block(interp: &mut Interp<f64>, call: &Call<'_>) -> Result<Value, Exception> {
    interp.eval_value(call.arg(call.len() - 1))
}

fn host() -> Interp<f64> {
    let mut interp = Interp::new(0.0, Box::new(Recorded::default()), Box::new(MemoryFiles::default()));
    interp.register("add", add);
    interp.register("pattern", block);
    interp
}

#[test]
fn host_commands_work_on_the_host() {
    let mut interp = host();
    let result = interp.eval_str("m.tcl", "foreach x {1 2 3} {add $x}; add 0.5").unwrap();
    assert_eq!(result.as_str(), "6.5");
    assert!((interp.host - 6.5).abs() < 1e-12);
}

#[test]
fn host_errors_point_at_words() {
    let mut interp = host();
    let script = "set v -3\nproc go {} {\n    global v\n    add $v\n}\npattern Plain 1 {\n  go\n}";
    let Err(Exception::Error(e)) = interp.eval_str("m.tcl", script) else { panic!("no error") };
    assert_eq!(e.result.as_str(), "amount is negative");
    let span = e.diagnostic.span.unwrap();
    let at = interp.sources.location(span);
    assert_eq!((at.line, at.column, interp.sources.snippet(span)), (4, 9, "$v"));
    let callers: Vec<_> = e.diagnostic.callers.iter().map(|c| c.what.as_str()).collect();
    assert_eq!(callers, ["proc \"go\""]);
    assert_eq!(interp.sources.location(e.diagnostic.callers[0].span).line, 7);
}

#[test]
fn wrong_number_of_words_tells_the_usage() {
    let mut interp = host();
    let Err(Exception::Error(e)) = interp.eval_str("m.tcl", "add 1 2") else { panic!("no error") };
    assert_eq!(e.result.as_str(), "wrong # args: should be \"add amount\"");
}

#[test]
fn warnings_are_collected_with_their_place() {
    let mut interp = host();
    interp.eval_str("m.tcl", "add 5\nadd 5000").unwrap();
    assert_eq!(interp.warnings.len(), 1);
    assert_eq!(interp.sources.location(interp.warnings[0].span.unwrap()).line, 2);
}

#[test]
fn an_unknown_command_names_the_nearest_one() {
    let (mut interp, ..) = interp();
    let e = error(&mut interp, "proc storey {} {}\nstorye");
    assert_eq!(e.result.as_str(), "invalid command name \"storye\"");
    assert_eq!(e.diagnostic.help, ["did you mean \"storey\"?"]);
    let e = error(&mut interp, "foreech x {1} {}");
    assert_eq!(e.diagnostic.help, ["did you mean \"foreach\"?"]);
}

#[test]
fn exit_is_an_outcome() {
    let (mut interp, ..) = interp();
    let outcome = interp.eval_str("m.tcl", "catch {exit 3}; error no");
    assert!(matches!(outcome, Err(Exception::Exit(3))));
}

#[test]
fn files_can_be_in_memory() {
    let (mut interp, console, files) = interp();
    files.insert("/model/a.tcl", "source sub/b.tcl; puts \"$b [file exists sub/b.tcl] [pwd]\"");
    files.insert("/model/sub/b.tcl", "set b [file tail [info script]]");
    interp.set_current_dir("/model");
    interp.eval_file("a.tcl").unwrap();
    assert_eq!(console.out(), "b.tcl 1 /model\n");
    interp.eval_str("w.tcl", "set f [open out/x.txt w]").unwrap_err();
    interp.eval_str("w.tcl", "file mkdir out; set f [open out/x.txt w]; puts $f hello").unwrap();
    // What was written is there although the script did not close the file.
    assert_eq!(files.get("/model/out/x.txt").unwrap(), b"hello\n");
    assert_eq!(interp.eval_str("w.tcl", "close $f; glob out/*").unwrap().as_str(), "out/x.txt");
}

#[test]
fn a_file_is_parsed_once() {
    let (mut interp, _, files) = interp();
    files.insert("/a.tcl", "incr n");
    interp.eval_file("/a.tcl").unwrap();
    assert_eq!(interp.eval_file("/a.tcl").unwrap().as_str(), "2");
    files.insert("/a.tcl", "incr n 10");
    assert_eq!(interp.eval_file("/a.tcl").unwrap().as_str(), "12");
}

#[test]
fn values_convert() {
    assert_eq!(Value::from("0x10").to_i64().unwrap(), 16);
    assert!((Value::from("1e3").to_f64().unwrap() - 1000.0).abs() < 1e-9);
    assert!(Value::from("yes").to_bool().unwrap());
    assert_eq!(elements(&Value::from("a {b c} \"d e\" f\\ g")), ["a", "b c", "d e", "f g"]);
    assert_eq!(Value::list(["a b", "", "{"].map(Value::from)).as_str(), "{a b} {} \\{");
    let Err(Exception::Error(e)) = Value::from("abc").to_f64() else { panic!("no error") };
    assert_eq!(e.result.as_str(), "expected floating-point number but got \"abc\"");
}

#[test]
fn a_script_cannot_reach_out() {
    for script in ["exec ls", "open |ls", "socket localhost 80", "load x.so"] {
        let (mut interp, ..) = interp();
        let e = error(&mut interp, script);
        assert!(e.result.as_str().contains("cannot"), "{script}: {}", e.result);
        assert_eq!(interp.eval_str("m.tcl", &format!("catch {{{script}}}")).unwrap().as_str(), "1");
    }
}

#[test]
fn random_numbers_come_out_the_same_every_time() {
    let script = "set l {}; for {set i 0} {$i < 3} {incr i} {lappend l [expr {rand()}]}; set l";
    assert_eq!(value(script), value(script));
}

/// Interpreters of a thread share what they have parsed, not what the names in it mean.
#[test]
fn a_script_run_again_finds_its_own_commands() {
    let run = |definitions: &str| {
        let files = MemoryFiles::default();
        files.insert("/definitions.tcl", definitions);
        files.insert("/main.tcl", "source definitions.tcl\nset all {}\nforeach i {1 2} {lappend all [go $i]}\nset all");
        let mut interp = Interp::new(0.0, Box::new(Recorded::default()), Box::new(files));
        interp.register("add", add);
        interp.eval_file("/main.tcl").unwrap().as_str().to_string()
    };
    let [one, two] = ["proc go {x} {expr {$x + 1}}", "proc other {x} {add $x}\nproc go {x} {other $x}"];
    assert_eq!(run(one), "2 3");
    assert_eq!(run(two), "1.0 3.0");
    assert_eq!(run("proc spare {} {}\nrename spare {}\nproc go {x} {return a$x}"), "a1 a2");
    assert_eq!(run(one), "2 3");
}
