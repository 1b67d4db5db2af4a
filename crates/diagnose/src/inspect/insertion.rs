//! Where in a script physics can be added: after the model, before the first step of an analysis.

use hysteron_tcl::TopLevel;

/// Commands that set an analysis up. The block goes before them, so that the script still reads in its order.
const SETUP: [&str; 7] = ["constraints", "numberer", "system", "test", "algorithm", "integrator", "analysis"];

/// Where the block goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// At this byte of the text, between two commands.
    At(usize),
    /// One command of the script makes the model and analyses it: the block is run by the first `analyze`.
    FirstAnalyze,
}

/// Find the place. `first` is the number of the top-level command that makes the first step, and `made` tells whether
/// the commands before it have made elements.
pub fn place(commands: &[TopLevel], first: usize, made: bool) -> Place {
    if !made {
        return Place::FirstAnalyze;
    }
    let mut at = first;
    while at > 0 && SETUP.contains(&commands[at - 1].name.as_str()) {
        at -= 1;
    }
    Place::At(commands[at].start)
}

/// The script with a block.
pub fn insert(text: &str, place: &Place, block: &[String]) -> String {
    const OPEN: &str = "# ---- added by hysteron diagnose: physics that the model left out ----";
    const CLOSE: &str = "# ---- end of what was added ----";
    let body = block.join("\n");
    match place {
        Place::At(byte) => {
            let (before, after) = text.split_at(*byte);
            // A comment above the command stays with it: the block goes to the beginning of the line.
            let line = before.rfind('\n').map_or(0, |i| i + 1);
            let (before, rest) = if before[line..].trim().is_empty() {
                (&before[..line], format!("{}{after}", &before[line..]))
            } else {
                (before, after.to_owned())
            };
            let newline = if before.is_empty() || before.ends_with('\n') { "" } else { "\n" };
            format!("{before}{newline}{OPEN}\n{body}\n{CLOSE}\n{rest}")
        }
        Place::FirstAnalyze => format!(
            "{OPEN}\n# The model is complete at the first analyze.\nproc hysteron_amend {{}} {{\n{body}\n}}\n\
             rename analyze hysteron_analyze\nproc analyze {{args}} {{\n    rename analyze {{}}\n    \
             rename hysteron_analyze analyze\n    uplevel #0 hysteron_amend\n    uplevel 1 [linsert $args 0 analyze]\n}}\n\
             {CLOSE}\n{text}"
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::{Place, insert, place};
    use hysteron_tcl::top_level;

    #[test]
    fn the_block_goes_before_the_setup() {
        let text = "node 1 0\nelement a\n# go\nconstraints Plain\nanalysis Static\nfor {} {} {} {analyze 1}\n";
        let commands = top_level(text);
        assert_eq!(commands.len(), 5);
        let at = place(&commands, 4, true);
        let with = insert(text, &at, &["amend x".into()]);
        assert!(with.starts_with("node 1 0\nelement a\n# go\n# ---- added"), "{with}");
        assert!(with.contains("# ---- end of what was added ----\nconstraints Plain\n"), "{with}");
        assert_eq!(place(&commands, 4, false), Place::FirstAnalyze);
    }
}
