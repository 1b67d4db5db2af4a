//! The register of the places where the answer is not that of OpenSees.
//!
//! A [`Slip`] of kind [`Kind::Followed`] has a name. The place that acts on it asks [`Session::follows`](crate::Session::follows) with
//! that name, so that a search for the name finds every such place. `docs/reference/compat.md` is [`page`].

mod analysis;
mod bearings;
mod elements;
mod materials;
mod output;

pub use analysis::*;
pub use bearings::*;
pub use elements::*;
pub use materials::*;
pub use output::*;
use std::fmt::Write;

/// Kind of a difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `--compat opensees` gives the answer of OpenSees.
    Followed,
    /// The answer differs with the switch and without it.
    Differs,
    /// The script is refused, or there is a warning.
    Refused,
    /// The answer is that of OpenSees, and may not be the one that is expected.
    Shared,
}

/// The code that acts on a slip which is followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Acts {
    /// A command, which asks [`Session::follows`](crate::Session::follows).
    Command,
    /// The analysis, by its option `compat`.
    Analysis,
    /// No code.
    Nowhere,
}

/// The test that shows a difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// A folder of `validation/opensees`, run against outputs of OpenSees.
    Case(&'static str),
    /// A file and a test function in it.
    Test(&'static str, &'static str),
    /// None.
    Nowhere,
}

/// A place where the answer is not that of OpenSees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slip {
    /// Name of the constant; empty for a difference that is not followed.
    pub name: &'static str,
    /// Kind.
    pub kind: Kind,
    /// Command, or part of it.
    pub place: &'static str,
    /// Answer of OpenSees.
    pub opensees: &'static str,
    /// Answer of hysteron.
    pub hysteron: &'static str,
    /// Reason for the difference.
    pub reason: &'static str,
    /// Code that acts on it.
    pub acts: Acts,
    /// Test that shows it.
    pub shown: Shown,
}

impl Slip {
    /// Returns true if `--compat opensees` follows it.
    pub fn is_followed(&self) -> bool {
        self.kind == Kind::Followed
    }
}

/// A difference that `--compat opensees` does not follow.
const fn differs(place: &'static str, opensees: &'static str, hysteron: &'static str) -> Slip {
    let (kind, acts, shown) = (Kind::Differs, Acts::Nowhere, Shown::Nowhere);
    Slip { name: "", kind, place, opensees, hysteron, reason: "", acts, shown }
}

/// A script that is refused, or that there is a warning for.
const fn refused(place: &'static str, opensees: &'static str, hysteron: &'static str) -> Slip {
    Slip { kind: Kind::Refused, ..differs(place, opensees, hysteron) }
}

/// An answer that both programs give, and the one that may be expected.
const fn shared(place: &'static str, both: &'static str, expected: &'static str) -> Slip {
    Slip { kind: Kind::Shared, ..differs(place, both, expected) }
}

/// Declare slips that are followed, and the list `FOLLOWED` of them: name, acting code, place, OpenSees' answer, hysteron's, reason, test.
macro_rules! slips {
    ($($name:ident, $acts:ident, $shown:expr, $place:literal, $opensees:literal, $hysteron:literal, $reason:literal;)*) => {
        $(
            #[doc = $place]
            pub const $name: $crate::slips::Slip = $crate::slips::Slip {
                name: stringify!($name),
                kind: $crate::slips::Kind::Followed,
                place: $place,
                opensees: $opensees,
                hysteron: $hysteron,
                reason: $reason,
                acts: $crate::slips::Acts::$acts,
                shown: $shown,
            };
        )*
        /// Slips of the family that are followed.
        pub(super) const FOLLOWED: &[$crate::slips::Slip] = &[$($name),*];
    };
}
use slips;

/// Slips of one family.
pub struct Family {
    /// Title on the page.
    pub title: &'static str,
    /// Slips that are followed.
    pub followed: &'static [Slip],
    /// Other differences.
    pub others: &'static [Slip],
}

/// The whole register, by families.
pub const FAMILIES: [Family; 5] = [
    Family { title: "Materials", followed: materials::FOLLOWED, others: materials::OTHERS },
    Family { title: "Bearings", followed: bearings::FOLLOWED, others: bearings::OTHERS },
    Family { title: "Elements", followed: elements::FOLLOWED, others: elements::OTHERS },
    Family { title: "Analysis", followed: analysis::FOLLOWED, others: analysis::OTHERS },
    Family { title: "Output", followed: output::FOLLOWED, others: output::OTHERS },
];

const INTRODUCTION: &str = "# Differences from OpenSees

<!-- Generated from crates/opensees/src/slips: change the register, then run the test of that crate with HYSTERON_WRITE=1. -->

`--compat opensees` gives the answers of OpenSees that the first tables list, and no others. Without the switch hysteron gives the
answer of the equations. \"Shown by\" names a folder of `validation/opensees`, whose outputs differ with the switch, or a test. A dash
says that no test shows the difference.

OpenSees accepts some scripts that mean nothing. There is no number to reproduce: hysteron refuses such a script, or warns, with the
switch and without it. [Conventions](conventions.md#messages) explains the messages.

A kind without a row has no known difference. That is no proof of the same numbers: the [verification](../verification/index.md)
lists the cases and problems that each kind was compared with, and a dash stands where there is none. A command that hysteron does
not have is refused by its name; it has no row either.

Solvers and iterations differ in round-off. The cases of `validation/opensees` show agreement to the tolerances in their files.
";

/// A page in Markdown with every entry of the register.
pub fn page() -> String {
    let mut out = INTRODUCTION.to_owned();
    out += "\n## Followed by `--compat opensees`\n";
    for family in &FAMILIES {
        out += &format!("\n### {}\n\n", family.title);
        out += "| place | OpenSees, and `--compat opensees` | hysteron | reason | shown by |\n| --- | --- | --- | --- | --- |\n";
        for s in family.followed {
            let shown = match s.shown {
                Shown::Case(case) => format!("`{case}`"),
                Shown::Test(_, name) => format!("test `{name}`"),
                Shown::Nowhere => "–".to_owned(),
            };
            let reason = if s.reason.is_empty() { "–" } else { s.reason };
            let _ = writeln!(out, "| {} | {} | {} | {reason} | {shown} |", s.place, s.opensees, s.hysteron);
        }
    }
    for (kind, title) in [
        (Kind::Differs, "Different with the switch and without it"),
        (Kind::Refused, "Refused, or with a warning"),
        (Kind::Shared, "The same as in OpenSees, with the switch and without it"),
    ] {
        out += &format!("\n## {title}\n");
        for family in &FAMILIES {
            let mut entries = family.others.iter().filter(|s| s.kind == kind).peekable();
            if entries.peek().is_none() {
                continue;
            }
            let columns = if kind == Kind::Shared { "both | may be expected" } else { "OpenSees | hysteron" };
            out += &format!("\n### {}\n\n| place | {columns} |\n| --- | --- | --- |\n", family.title);
            for s in entries {
                let _ = writeln!(out, "| {} | {} | {} |", s.place, s.opensees, s.hysteron);
            }
        }
    }
    out
}
