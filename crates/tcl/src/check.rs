//! Checks: what messages have in common that one rule finds.

/// A check of a script or of its analysis.
///
/// The code is stable: other programs and users refer to it. Its page follows from the two texts.
#[derive(Debug, PartialEq, Eq)]
pub struct Check {
    /// Stable name: small letters, with hyphens between the words.
    pub code: &'static str,
    /// Finding, in one sentence.
    pub finds: &'static str,
    /// Reason and remedy, in sentences.
    pub advice: &'static str,
    /// At one place only the first message counts, whatever its words. Otherwise messages that differ by their numbers alone
    /// count as one.
    pub once: bool,
}

impl Check {
    /// A check by its code, what it finds and what to do.
    pub const fn new(code: &'static str, finds: &'static str, advice: &'static str) -> Self {
        Self { code, finds, advice, once: false }
    }

    /// The same check with one message at a place.
    pub const fn once(self) -> Self {
        Self { once: true, ..self }
    }
}

/// Declare checks, and the list `ALL` of them: name, code, `(once)` for one message at a place, what is found, what to do.
#[macro_export]
macro_rules! checks {
    ($($name:ident $code:literal $(($once:ident))?: $finds:literal, $advice:literal;)*) => {
        $(
            #[doc = $finds]
            pub static $name: $crate::check::Check = $crate::check::Check::new($code, $finds, $advice)$(.$once())?;
        )*
        /// All of them.
        pub static ALL: &[&$crate::check::Check] = &[$(&$name),*];
    };
}

checks! {
    UNKNOWN_COMMAND "unknown-command":
        "A script calls a command that does not exist.",
        "The nearest known name is shown. \"hysteron commands\" lists all commands of OpenSees that are known. A \
         procedure must be defined before it is called.";
    UNKNOWN_VARIABLE "unknown-variable":
        "A script reads a variable that has no value.",
        "The nearest known name is shown. A procedure sees its own variables; \"global\" or \"::\" reaches those of the \
         script. A study may set the variable.";
    WRONG_ARGUMENTS "wrong-arguments":
        "A command of Tcl or a procedure has too few or too many words.",
        "The message shows how the command is written. A value with blanks needs quotes or braces.";
    NEVER_CLOSED "never-closed":
        "A brace, a bracket, a parenthesis or a quote is never closed.",
        "The message points at the one that is open. A brace in a comment counts.";
    PASSED_OVER "passed-over":
        "A command of Tcl that changes no result is passed over.",
        "Commands and their executions are not watched here. The rest of the script runs as it stands.";
}
