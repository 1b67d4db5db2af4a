//! Insertion of commands into a script: after its model, before the first step of an analysis.

use hysteron_tcl::TopLevel;

/// Commands that set up an analysis. Insertion before them keeps the order of a usual script.
const ANALYSIS_SETUP: [&str; 7] = ["constraints", "numberer", "system", "test", "algorithm", "integrator", "analysis"];

/// Place of inserted commands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum InsertionPoint {
    /// At this byte of the text, between two commands.
    At(usize),
    /// In front of the first `analyze` at run time, because one command makes the model and analyses it.
    FirstAnalyze,
}

impl InsertionPoint {
    /// Byte of the text, if the model exists there.
    pub(crate) fn byte(&self) -> Option<usize> {
        match self {
            Self::At(byte) => Some(*byte),
            Self::FirstAnalyze => None,
        }
    }
}

/// The insertion point before a top-level command.
///
/// `first_step` is the index of the command that makes the first step. `model_exists` is true if earlier commands have
/// made elements.
pub(crate) fn insertion_point(commands: &[TopLevel], first_step: usize, model_exists: bool) -> InsertionPoint {
    if !model_exists {
        return InsertionPoint::FirstAnalyze;
    }
    let mut at = first_step;
    while at > 0 && ANALYSIS_SETUP.contains(&commands[at - 1].name.as_str()) {
        at -= 1;
    }
    InsertionPoint::At(commands[at].start)
}

/// Comments around inserted commands.
const OPEN: &str = "# ---- added by hysteron diagnose: physics that the model left out ----";
const CLOSE: &str = "# ---- end of what was added ----";
/// Lines before and after commands that wait for the first `analyze`.
const DEFERRED_OPEN: &str = "# The model is complete at the first analyze.\nproc hysteron_amend {} {\n";
const DEFERRED_CLOSE: &str = "\n}\nrename analyze";

/// Inserted commands in a script.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct InsertedBlock {
    /// First byte of the commands, and the byte after their last.
    pub(crate) body: (usize, usize),
    /// The same with the comments around them.
    pub(crate) whole: (usize, usize),
    /// False if the commands wait for the first `analyze` in a procedure.
    pub(crate) at_top_level: bool,
}

/// The block that [`insert`] has added to a script.
pub(crate) fn inserted_block(text: &str) -> Option<InsertedBlock> {
    let open = text.find(OPEN)?;
    let mut from = open + OPEN.len() + 1;
    let close = from + text.get(from..)?.find(CLOSE)?;
    let mut to = close - 1;
    let at_top_level = !text[from..close].starts_with(DEFERRED_OPEN);
    if !at_top_level {
        from += DEFERRED_OPEN.len();
        to = from + text[from..close].find(DEFERRED_CLOSE)?;
    }
    Some(InsertedBlock { body: (from, to), whole: (open, close + CLOSE.len() + 1), at_top_level })
}

/// The script with inserted commands between two comments.
pub(crate) fn insert(text: &str, point: &InsertionPoint, commands: &[String]) -> String {
    let body = commands.join("\n");
    match point {
        InsertionPoint::At(byte) => {
            let (before, after) = text.split_at(*byte);
            // The insertion starts a line, so that a comment above the next command stays with it.
            let line = before.rfind('\n').map_or(0, |i| i + 1);
            let (before, rest) = if before[line..].trim().is_empty() {
                (&before[..line], format!("{}{after}", &before[line..]))
            } else {
                (before, after.to_owned())
            };
            let newline = if before.is_empty() || before.ends_with('\n') { "" } else { "\n" };
            format!("{before}{newline}{OPEN}\n{body}\n{CLOSE}\n{rest}")
        }
        InsertionPoint::FirstAnalyze => format!(
            "{OPEN}\n{DEFERRED_OPEN}{body}{DEFERRED_CLOSE} hysteron_analyze\nproc analyze {{args}} {{\n    rename analyze {{}}\n    \
             rename hysteron_analyze analyze\n    uplevel #0 hysteron_amend\n    uplevel 1 [linsert $args 0 analyze]\n}}\n\
             {CLOSE}\n{text}"
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::{InsertionPoint, insert, inserted_block, insertion_point};
    use hysteron_tcl::top_level;

    #[test]
    fn commands_are_inserted_before_the_analysis_setup() {
        let text = "node 1 0\nelement a\n# go\nconstraints Plain\nanalysis Static\nfor {} {} {} {analyze 1}\n";
        let commands = top_level(text);
        assert_eq!(commands.len(), 5);
        let at = insertion_point(&commands, 4, true);
        let with = insert(text, &at, &["amend x".into()]);
        assert!(with.starts_with("node 1 0\nelement a\n# go\n# ---- added"), "{with}");
        assert!(with.contains("# ---- end of what was added ----\nconstraints Plain\n"), "{with}");
        assert_eq!(insertion_point(&commands, 4, false), InsertionPoint::FirstAnalyze);
    }

    #[test]
    fn an_inserted_block_is_found_again() {
        let text = "node 1 0\nelement a\nanalyze 1\n";
        let commands = ["pset hy_x 1.0".to_owned(), "amend x".to_owned()];
        for (point, at_top_level) in [(InsertionPoint::At(19), true), (InsertionPoint::FirstAnalyze, false)] {
            let with = insert(text, &point, &commands);
            let block = inserted_block(&with).expect("a block");
            assert_eq!(&with[block.body.0..block.body.1], "pset hy_x 1.0\namend x");
            assert_eq!(format!("{}{}", &with[..block.whole.0], &with[block.whole.1..]), text);
            assert_eq!(block.at_top_level, at_top_level);
        }
        assert_eq!(inserted_block(text), None);
    }
}
