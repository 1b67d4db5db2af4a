//! A large model on several threads.

use super::script::Script;
use hysteron::analysis::{Options, Threads, WorkCounts};

/// Frames of fibers: enough for several threads in the elements, and of bearings: enough for several in the factors.
const FRAME: &str = include_str!("../../benches/fiber_frame.tcl");
const ISOLATED: &str = include_str!("../../benches/large_frame.tcl");

/// The printed results of a bench without its seconds, and the work.
fn results(text: &str, arguments: &str, threads: usize) -> (Vec<String>, WorkCounts) {
    let options = Options { threads: Threads::new(threads), ..Options::default() };
    let mut script = Script::default();
    script.options = options;
    let ran = script.run(&format!("set argv {{{arguments}}}\n{text}")).done();
    let kept = ["settlement", "periods", "drift", "roof"];
    let lines = ran.out.lines().filter(|l| kept.iter().any(|k| l.starts_with(k))).map(str::to_owned).collect();
    (lines, ran.work)
}

#[test]
fn threads_change_no_digit_of_a_frame_of_fibers() {
    // 77 beams with 385 sections of 60 fibers.
    let one = results(FRAME, "7 5 4", 1);
    assert_eq!(one.0.len(), 1);
    assert_eq!(results(FRAME, "7 5 4", 3), one);
}

#[test]
fn threads_change_no_digit_of_an_isolated_frame() {
    // 2430 equations: their factors are made by fronts, and are unsymmetric under bearings that yield in two directions.
    let one = results(ISOLATED, "8 4", 1);
    assert_eq!(one.0.len(), 3);
    assert_eq!(results(ISOLATED, "8 4", 3), one);
}
