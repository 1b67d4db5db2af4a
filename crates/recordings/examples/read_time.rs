//! Time of reading a file: `cargo run --release -p hysteron-recordings --example read_time FILE`.

#![allow(clippy::print_stdout, clippy::print_stderr)]

use hysteron_recordings::Measured;
use std::time::Instant;

fn main() {
    let Some(file) = std::env::args().nth(1) else { return eprintln!("expected a file") };
    let start = Instant::now();
    let bytes = match std::fs::read(&file) {
        Ok(bytes) => bytes,
        Err(e) => return eprintln!("cannot read {file}: {e}"),
    };
    match Measured::read(&file, &bytes) {
        Ok(m) => {
            let size = m.sheet().map_or((0, 0), |s| (s.rows(), s.columns.len()));
            println!("{} rows, {} columns, {:.2} s", size.0, size.1, start.elapsed().as_secs_f64());
        }
        Err(e) => eprintln!("{file}: {e}"),
    }
}
