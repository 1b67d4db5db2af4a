//! Rules of codes, read from data: clause, edition, numbers, and the state of their source.

use hysteron_tcl::diagnostic::nearest;
use serde::Deserialize;
use std::collections::BTreeMap;

/// The codes that the program brings with it, by name.
const BUILT_IN: [(&str, &str); 4] = [
    ("asce7-16", include_str!("../codes/asce7-16.toml")),
    ("asce7-22", include_str!("../codes/asce7-22.toml")),
    ("aashto", include_str!("../codes/aashto.toml")),
    ("en1998", include_str!("../codes/en1998.toml")),
];

/// Source of the wording of a rule.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Reading {
    /// The text of the code itself was read.
    Text,
    /// A source that uses the rule was read.
    Secondary,
    /// Neither was read.
    #[default]
    Knowledge,
}

impl Reading {
    /// Words for tables.
    pub fn word(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Secondary => "secondary",
            Self::Knowledge => "not read",
        }
    }
}

/// Kind of structure, on which some rules depend.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Structure {
    /// A building.
    #[default]
    Building,
    /// A bridge.
    Bridge,
}

impl Structure {
    /// Name, as files have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Building => "building",
            Self::Bridge => "bridge",
        }
    }
}

/// A rule of a code.
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Rule {
    /// Clause, table or equation.
    pub clause: String,
    /// Source of the wording.
    #[serde(default)]
    pub read: Reading,
    /// The rule in own words.
    pub text: String,
    /// Numbers by name.
    #[serde(default)]
    pub values: BTreeMap<String, f64>,
    /// Words by name.
    #[serde(default)]
    pub words: BTreeMap<String, String>,
    /// Rows of a table with rising abscissas.
    #[serde(default)]
    pub table: Vec<[f64; 2]>,
}

/// Shapes of elastic spectra of EN 1998-1 by ground type: S, T_B, T_C and T_D.
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
pub struct SpectrumShapes {
    /// Table.
    pub clause: String,
    /// Parameters by ground type.
    #[serde(flatten)]
    pub grounds: BTreeMap<String, [f64; 4]>,
}

/// A code.
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Code {
    /// Name.
    pub name: String,
    /// Short name with the edition, for tables.
    pub label: String,
    /// Edition.
    pub edition: String,
    /// Kind of structure that the code is for.
    #[serde(default)]
    pub structure: Structure,
    /// True if the rules were compared with the text of the code itself.
    pub text_read: bool,
    /// Source of the rules.
    pub source: String,
    /// Rules by name.
    pub rule: BTreeMap<String, Rule>,
    /// Shapes of spectra by name.
    #[serde(default)]
    pub spectrum: BTreeMap<String, SpectrumShapes>,
}

impl Code {
    /// Names of the codes that the program brings with it.
    pub fn names() -> impl Iterator<Item = &'static str> {
        BUILT_IN.iter().map(|(name, _)| *name)
    }

    /// A code of the program by its name.
    ///
    /// # Errors
    /// There is none of the name, with the nearest one.
    pub fn named(name: &str) -> Result<Self, String> {
        let Some((_, text)) = BUILT_IN.iter().find(|(n, _)| *n == name) else {
            let near = nearest(name, Self::names()).map_or(String::new(), |n| format!("; did you mean {n}?"));
            let known: Vec<&str> = Self::names().collect();
            return Err(format!("there is no code \"{name}\": expected {}{near}", known.join(", ")));
        };
        Self::parse(text)
    }

    /// A code from the text of its file.
    ///
    /// # Errors
    /// The text is no such file.
    pub fn parse(text: &str) -> Result<Self, String> {
        toml::from_str(text).map_err(|e| e.to_string())
    }

    /// A number of a rule, if the code has both.
    pub fn value(&self, rule: &str, name: &str) -> Option<f64> {
        self.rule.get(rule)?.values.get(name).copied()
    }

    /// A word of a rule, if the code has both.
    pub fn word(&self, rule: &str, name: &str) -> Option<&str> {
        self.rule.get(rule)?.words.get(name).map(String::as_str)
    }

    /// Edition and clause of a rule; empty without one.
    pub fn clause(&self, rule: &str) -> String {
        self.rule.get(rule).map_or(String::new(), |r| match r.clause.starts_with("EN ") {
            true => r.clause.clone(),
            false => format!("{}, {}", self.label, r.clause),
        })
    }

    /// Source of the wording of a rule; `None` without the rule.
    pub fn reading(&self, rule: &str) -> Option<Reading> {
        self.rule.get(rule).map(|r| r.read)
    }

    /// The wording of a rule behind its clause; `None` if the code has no such rule.
    pub fn statement(&self, rule: &str) -> Option<String> {
        self.rule.get(rule).map(|r| format!("{}: {}", self.clause(rule), r.text))
    }

    /// Remark on the source that a result must carry; empty if the text was read.
    pub fn remark(&self) -> String {
        if self.text_read {
            return String::new();
        }
        format!("{}: the text was not read, check against the standard (source: {})", self.name, self.source)
    }

    /// Damping coefficient B that divides the spectrum of 5 % damping, for an effective damping β of 0 or more.
    pub fn damping_coefficient(&self, damping: f64) -> Option<f64> {
        let rule = self.rule.get("damping_coefficient")?;
        if let (Some(first), Some(last)) = (rule.table.first(), rule.table.last()) {
            let at = rule.table.partition_point(|r| r[0] < damping);
            return Some(match at {
                0 => first[1],
                i if i == rule.table.len() => last[1],
                i => {
                    let ([x0, y0], [x1, y1]) = (rule.table[i - 1], rule.table[i]);
                    y0 + (y1 - y0) * (damping - x0) / (x1 - x0)
                }
            });
        }
        let value = |name: &str| rule.values.get(name).copied();
        if let (Some(power), Some(reference), Some(most)) = (value("power"), value("reference"), value("most")) {
            return Some((damping / reference).powf(power).min(most));
        }
        let eta = (value("numerator")? / (value("offset")? + 100.0 * damping)).sqrt();
        Some(1.0 / eta.max(value("least")?))
    }
}

#[cfg(test)]
mod tests {
    use super::Code;

    #[test]
    fn built_in_codes_are_read_and_say_that_their_text_was_not() {
        for name in Code::names() {
            let code = Code::named(name).expect(name);
            assert!(!code.text_read && code.remark().contains("check against the standard"), "{name}");
            assert!(code.rule.values().all(|r| !r.clause.is_empty() && !r.text.is_empty()), "{name}");
        }
        assert!(Code::named("asce7-61").expect_err("none").contains("asce7-16"));
    }

    /// Every rule of every file is used somewhere by its name.
    #[test]
    fn no_rule_is_listed_without_being_applied() {
        fn texts(folder: &std::path::Path, out: &mut String) {
            for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
                let path = entry.path();
                if path.is_dir() {
                    texts(&path, out);
                } else if path.file_name().is_some_and(|n| n != "codes.rs") {
                    *out += &std::fs::read_to_string(&path).expect("a file");
                }
            }
        }
        let mut all = String::from("rule.get(\"damping_coefficient\")");
        texts(&std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut all);
        for name in Code::names() {
            for rule in Code::named(name).expect(name).rule.keys() {
                assert!(all.contains(&format!("\"{rule}\"")), "{name}: {rule} is not applied");
            }
        }
    }

    #[test]
    fn damping_coefficients_of_three_codes() {
        let of = |name: &str, damping: f64| Code::named(name).expect(name).damping_coefficient(damping).expect("B");
        for (name, damping, expected) in [
            ("asce7-16", 0.05, 1.0),
            ("asce7-16", 0.15, 1.35),
            ("asce7-16", 0.01, 0.8),
            ("asce7-16", 0.7, 2.0),
            ("aashto", 0.05, 1.0),
            ("aashto", 0.20, 4f64.powf(0.3)),
            ("aashto", 0.60, 1.7),
            ("en1998", 0.05, 1.0),
            ("en1998", 0.15, 2f64.sqrt()),
            ("en1998", 0.60, 1.0 / 0.55),
        ] {
            assert!((of(name, damping) - expected).abs() < 1e-12, "{name} {damping}");
        }
    }
}
