//! Places where a user says what a file does not, and how each spells it.

/// Places where a user says what a file does not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Way {
    /// Options of the command line.
    #[default]
    CommandLine,
    /// Keys of a study.
    Study,
    /// Options of a command in a script.
    Script,
    /// Arguments of a function of Python.
    Python,
}

/// Key that a message asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// Unit.
    Unit,
    /// Step of time.
    Step,
    /// Quantity.
    Quantity,
    /// Layout of rows.
    Layout,
    /// One of several channels.
    Channel,
    /// Derivatives in the place of velocities and displacements.
    Differentiate,
}

impl Way {
    /// The key as it is written there.
    pub fn spelled(self, key: Key) -> &'static str {
        let of = |command, study, script, python| match self {
            Self::CommandLine => command,
            Self::Study => study,
            Self::Script => script,
            Self::Python => python,
        };
        match key {
            Key::Unit => of("--unit", "unit = \"...\"", "-unit", "unit="),
            Key::Step => of("--dt", "dt = ...", "-dt", "dt="),
            Key::Quantity => of("--quantity", "quantity = \"...\"", "-quantity", "quantity="),
            Key::Layout => of("--layout", "layout = \"...\"", "-layout", "layout="),
            Key::Channel => of("--channel", "channels = [...]", "-channel", "an index"),
            Key::Differentiate => match self {
                Self::CommandLine => "--differentiate",
                Self::Study => "differentiate = true",
                Self::Script | Self::Python => "hysteron recording FILE --differentiate --out FILE.csv",
            },
        }
    }
}
