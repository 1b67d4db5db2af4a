//! The checks of all commands: what their messages have in common, and what their codes mean.

use hysteron_tcl::check::Check;

pub use hysteron_identify::checks::CHANNEL_DOUBT;
pub use hysteron_opensees::checks::Family;

/// The whole register, by families: scripts and studies.
pub fn families() -> impl Iterator<Item = Family> {
    hysteron_opensees::checks::families().into_iter().chain([("Studies", hysteron_identify::checks::ALL)])
}

/// All checks.
pub fn all() -> impl Iterator<Item = &'static Check> {
    families().flat_map(|(_, checks)| checks.iter().copied())
}

const INTRODUCTION: &str = "# Codes of messages

<!-- Generated from the registers of checks: change them, then run HYSTERON_WRITE=1 cargo test --release --test reference. -->

A warning ends with the code of its check in brackets, and so does an error that many commands share. `hysteron explain` with a
code prints what stands here. `--format json` has the code of each message.
";

/// A page in Markdown with every check.
pub fn page() -> String {
    let mut out = INTRODUCTION.to_owned();
    for (title, checks) in families() {
        out += &format!("\n## {title}\n\n| code | what is found | what to do |\n| --- | --- | --- |\n");
        checks.iter().for_each(|c| out += &format!("| `{}` | {} | {} |\n", c.code, c.finds, c.advice));
    }
    out
}
