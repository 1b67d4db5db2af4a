//! `hysteron`: see `hysteron --help`.

#![forbid(unsafe_code)]
// The binary is the only place that prints.
#![allow(clippy::print_stdout, clippy::print_stderr)]

mod cli;

fn main() {
    std::process::exit(cli::main());
}
