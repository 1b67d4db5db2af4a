//! `hysteron lsp`: the language server.

use super::args::Compat;
use clap::Args;
use hysteron::lsp::{Settings, serve_stdio};
use std::time::Duration;

#[derive(Args, Debug)]
pub(super) struct LspArgs {
    /// Speak over standard input and output, which is the only way there is; editors that ask for it may say so
    #[arg(long)]
    stdio: bool,
    /// Time that a check may take, for instance 10 or 30s
    #[arg(long, value_name = "TIME", value_parser = super::limits::seconds)]
    time_limit: Option<Duration>,
    /// Reproduce known errors of another program
    #[arg(long, value_enum, value_name = "PROGRAM")]
    compat: Option<Compat>,
}

/// Serve an editor until it ends; the exit status.
pub(super) fn lsp(args: &LspArgs) -> i32 {
    let own = Settings::default();
    let time_limit = args.time_limit.unwrap_or(own.time_limit);
    match serve_stdio(Settings { time_limit, compat: args.compat.is_some(), ..own }) {
        Ok(()) => 0,
        Err(message) => {
            eprintln!("error: {message}");
            1
        }
    }
}
