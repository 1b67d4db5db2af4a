//! `hysteron explain`: what the code of a message means.

use super::commands::{indented, wrapped};
use hysteron::checks::{all, families};
use hysteron::diagnostic::nearest;

/// The meaning of a code, or all codes with a sentence each.
///
/// # Errors
///
/// A message with the nearest known code.
pub(super) fn explained(code: Option<&str>) -> Result<String, String> {
    let Some(code) = code else { return Ok(list()) };
    match all().find(|c| c.code == code) {
        Some(c) => Ok(format!("{}\n{}{}", c.code, indented(c.finds), indented(c.advice))),
        None => Err(match nearest(code, all().map(|c| c.code)) {
            Some(near) => format!("there is no code \"{code}\": did you mean \"{near}\"?"),
            None => format!("there is no code \"{code}\": \"hysteron explain\" lists all"),
        }),
    }
}

fn list() -> String {
    let family = |(title, checks): hysteron::checks::Family| {
        let rows: String = checks.iter().map(|c| format!("  {}\n{}", c.code, wrapped(c.finds, 6, 6) + "\n")).collect();
        format!("{title}\n{rows}")
    };
    families().map(family).collect::<Vec<_>>().join("\n")
}
