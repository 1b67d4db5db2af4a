//! The reference of the commands of scripts: the pages that `tests/reference.rs` writes from the commands themselves.

use hysteron_opensees::{Text, commands};
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// The pages.
pub const PAGES: [&str; 8] = [
    include_str!("../../../docs/reference/commands/model.md"),
    include_str!("../../../docs/reference/commands/material.md"),
    include_str!("../../../docs/reference/commands/element.md"),
    include_str!("../../../docs/reference/commands/section.md"),
    include_str!("../../../docs/reference/commands/load.md"),
    include_str!("../../../docs/reference/commands/analysis.md"),
    include_str!("../../../docs/reference/commands/output.md"),
    include_str!("../../../docs/reference/commands/hysteron.md"),
];

/// A command or kind of the reference.
#[derive(Clone, Debug)]
pub struct Section {
    /// `uniaxialMaterial Steel02`, or several that share the section.
    names: Vec<&'static str>,
    /// Lines of the page, the sentence first.
    pub lines: Vec<&'static str>,
}

/// An argument or option of a command.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Argument {
    /// As the usage writes it: `$tag`, `<-mass $m>`.
    pub name: String,
    /// Meaning, with its domain.
    pub meaning: String,
}

impl Argument {
    /// The option that it begins with; none for a positional argument.
    pub fn option(&self) -> Option<&str> {
        let bare = self.name.trim_start_matches('<');
        let word = bare.split([' ', '>']).next()?;
        word.starts_with('-').then_some(word)
    }
}

/// The sections of all pages.
fn sections() -> impl Iterator<Item = Section> {
    PAGES.iter().flat_map(|page| {
        let mut sections: Vec<Section> = vec![];
        for line in page.lines() {
            if let Some(heading) = line.strip_prefix("## ").or_else(|| line.strip_prefix("### ")) {
                let names = heading.split('`').skip(1).step_by(2).collect();
                sections.push(Section { names, lines: vec![] });
            } else if let Some(s) = sections.last_mut() {
                s.lines.push(line);
            }
        }
        sections
    })
}

/// The sections by the name of a command, or of a command with a kind: `element Truss`. Each has the sentence of its name.
pub fn by_name() -> &'static BTreeMap<String, Section> {
    static ALL: OnceLock<BTreeMap<String, Section>> = OnceLock::new();
    ALL.get_or_init(|| {
        let named = |s: Section| s.names.clone().into_iter().map(move |name| (name.to_owned(), s.clone()));
        let mut all: BTreeMap<String, Section> = sections().flat_map(named).collect();
        let mut tell = |name: String, usage, text: Text| {
            if !text.about.is_empty() {
                all.entry(name).and_modify(|s| s.tell(text.about)).or_insert_with(|| Section::of(usage, text.about));
            }
        };
        for c in commands() {
            tell(c.name.to_owned(), c.usage, c.text);
            for kind in c.kinds() {
                tell(format!("{} {}", c.name, kind.names[0]), kind.usage, kind.text);
            }
        }
        all
    })
}

/// The section of a command, or of a command with a kind.
pub fn section(name: &str) -> Option<&'static Section> {
    by_name().get(name)
}

/// The cells of a row of a table; `None` for other lines, for rules and for headings.
pub fn cells(line: &str) -> Option<Vec<String>> {
    let inner = line.strip_prefix("| ")?.strip_suffix('|')?;
    let hidden = inner.replace("\\|", "\u{1}");
    let row: Vec<String> = hidden.split('|').map(|c| c.trim().replace('\u{1}', "|")).collect();
    let is_heading = ["---", "argument", "option", "kind"].contains(&row[0].as_str());
    (!is_heading).then_some(row)
}

impl Section {
    /// Of a command or kind that has no section on the pages.
    fn of(usage: &'static str, sentence: &'static str) -> Self {
        Self { names: vec![], lines: vec!["", sentence, "", "```tcl", usage, "```"] }
    }

    /// Put a sentence in the place of those of all its names.
    fn tell(&mut self, sentence: &'static str) {
        let summary = self.summary();
        if let Some(line) = self.lines.iter_mut().find(|l| **l == summary && !l.is_empty()) {
            *line = sentence;
        }
    }

    /// Its text in Markdown: usage, meaning, arguments, responses.
    pub fn markdown(&self) -> String {
        self.lines.join("\n").trim().to_owned()
    }

    /// Its first sentences.
    pub fn summary(&self) -> &'static str {
        self.lines.iter().find(|l| !l.is_empty() && !l.starts_with(['`', '|'])).copied().unwrap_or_default()
    }

    /// Its arguments and options.
    pub fn arguments(&self) -> Vec<Argument> {
        let row = |line: &&str| {
            let row = cells(line)?;
            let cell = |i: usize| row.get(i).map_or("", String::as_str);
            let name = cell(0).trim_matches('`').to_owned();
            let (meaning, value) = (cell(1), cell(2));
            let meaning = if value.is_empty() { meaning.to_owned() } else { format!("{meaning} ({value})") };
            Some(Argument { name, meaning })
        };
        self.lines.iter().filter_map(row).collect()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::section;

    #[test]
    fn a_command_that_shares_a_section_has_its_own_sentence() {
        assert_eq!(section("nodeVel").unwrap().summary(), "Returns the velocity of a node.");
        assert_eq!(section("timeSeries Triangle").unwrap().summary(), "A triangular wave between two times.");
        assert_eq!(section("analysis Static").unwrap().summary(), "Steps of the load factor or of a displacement.");
        assert_eq!(section("prp").unwrap().summary(), hysteron_opensees::WITHOUT_EFFECT);
    }

    #[test]
    fn a_kind_has_its_arguments_and_options() {
        let beam = section("element elasticBeamColumn").unwrap();
        let arguments = beam.arguments();
        assert_eq!(arguments[0].name, "$tag");
        assert!(arguments.iter().any(|a| a.option() == Some("-mass")));
        assert!(beam.summary().starts_with("Elastic beam"), "{}", beam.summary());
        assert!(section("node").is_some() && section("nothing").is_none());
    }
}
