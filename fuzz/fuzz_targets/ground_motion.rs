//! Any bytes as the file of a ground motion, read in every way.
#![no_main]

#[path = "../../tests/support/fuzzed.rs"]
mod fuzzed;

use hysteron::analysis::Options;
use hysteron::opensees::Mode;
use libfuzzer_sys::fuzz_target;

const SCRIPT: &str = "model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 1; fix 1 1
uniaxialMaterial Elastic 1 100; element zeroLength 1 1 2 -mat 1 -dir 1
catch {timeSeries Path 1 -dt 0.01 -filePath gm.txt}
catch {timeSeries Path 2 -fileTime gm.txt -filePath gm.txt}
catch {timeSeries PeerMotion 3 {} gm.txt 1.0}
catch {motionFile 4 gm.txt}
foreach s {1 2 3 4} {catch {pattern UniformExcitation $s 1 -accel $s}}
integrator Newmark 0.5 0.25; analysis Transient; catch {analyze 20 0.01}";

fuzz_target!(|data: &[u8]| fuzzed::run(SCRIPT, &[("/gm.txt", data)], Mode::Run, Options::default(), false));
