//! Figures of measured recordings on the pages are those of the table of answers. No diagnosis is run here.
//! After a change of the table, `HYSTERON_WRITE=1 cargo test --test measured` writes them anew.

#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Cells of a line, of which those with a comma stand in quotes.
fn cells(line: &str) -> Vec<String> {
    let (mut out, mut quoted) = (vec![String::new()], false);
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => out.push(String::new()),
            c => out.last_mut().unwrap().push(c),
        }
    }
    out
}

type Row = BTreeMap<String, String>;

fn table(file: &str) -> Vec<Row> {
    let text = fs::read_to_string(root().join(file)).unwrap();
    let head = cells(text.lines().next().unwrap());
    let row = |line| {
        let values = cells(line);
        assert_eq!(values.len(), head.len(), "{file}: {line}");
        head.iter().cloned().zip(values).collect()
    };
    text.lines().skip(1).map(row).collect()
}

/// An answer, judged by the names that an engineer would give.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Judged {
    Right,
    Other,
    Unknown,
    /// Nothing was found although something is missing.
    Nothing,
}

impl Judged {
    const ALL: [Self; 4] = [Self::Right, Self::Unknown, Self::Nothing, Self::Other];

    fn word(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Other => "another name",
            Self::Unknown => "unknown",
            Self::Nothing => "none",
        }
    }

    /// The first name counts, as does its absence where the library lacks the cause.
    fn of(cause: &str, names: &str) -> Self {
        match cause {
            _ if names.split(" or ").any(|n| n == cause) => Self::Right,
            "unknown" => Self::Unknown,
            "none" => Self::Nothing,
            _ => Self::Other,
        }
    }
}

struct Answer {
    row: Row,
    names: String,
    who: String,
    judged: Judged,
}

impl Answer {
    fn is(&self, column: &str) -> &str {
        &self.row[column]
    }

    fn number(&self, column: &str) -> Option<f64> {
        self.is(column).parse().ok()
    }

    /// True if a cause of the library is known to be missing.
    fn can_be_named(&self) -> bool {
        !self.names.split(" or ").any(|n| n == "unknown" || n == "none")
    }
}

/// Rows of the table, each with the names of the first row of `expected.csv` for its study, what is known of it, or its source.
fn answers() -> Vec<Answer> {
    let expected = table("validation/recordings/expected.csv");
    let find = |row: &Row| {
        let known = row["known"].split(" (").next().unwrap();
        let of = |study: &str| expected.iter().find(|e| e["source"] == row["source"] && e["study"] == study).cloned();
        of(&row["study"]).or_else(|| of(known)).or_else(|| of("*"))
    };
    let answer = |row: Row| {
        let told =
            find(&row).unwrap_or_else(|| panic!("expected.csv has no row for {} {}", row["source"], row["study"]));
        let judged = Judged::of(&row["cause"], &told["names"]);
        Answer { row, names: told["names"].clone(), who: told["who"].clone(), judged }
    };
    table("validation/recordings/answers.csv").into_iter().map(answer).collect()
}

fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}

fn change(answer: &Answer, before: &str, after: &str) -> String {
    match [before, after].map(|c| answer.number(c)) {
        [Some(b), Some(a)] => format!("{} → {}", figures(b), figures(a)),
        _ => String::new(),
    }
}

/// Three significant figures.
fn figures(x: f64) -> String {
    let digits = if x > 0.0 { (2 - x.log10().floor() as i32).max(0) as usize } else { 0 };
    format!("{x:.digits$}")
}

/// Sources with a row of counts in place of a row a study.
const COUNTED: [&str; 2] = ["rc_columns", "rig_faults"];

fn rows(all: &[Answer]) -> String {
    let mut out = String::from(
        "| source, study | answer | then | an engineer's name | who says so | judged | fitted NMSE | held out NMSE | of a model made by hand | least peak over recorded, held out | build |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    let handmade = table("validation/recordings/handmade.csv");
    for a in all.iter().filter(|a| !COUNTED.contains(&a.is("source"))) {
        let also = if a.is("also").is_empty() { String::new() } else { format!(" + {}", a.is("also")) };
        let second = a.number("second_probability").map(|p| format!("{} {}", a.is("second"), percent(p)));
        let by_hand = handmade.iter().find(|h| h["source"] == a.is("source") && h["study"] == a.is("study"));
        let by_hand = by_hand.map(|h| format!("{} ({})", figures(h["held_out"].parse().unwrap()), h["model"]));
        let cells = [
            format!("[{0}]({0}/outcome.md), {1}", a.is("source"), a.is("study")),
            format!("{}{also}, {}", a.is("cause"), percent(a.number("probability").unwrap())),
            second.unwrap_or_default(),
            a.names.clone(),
            a.who.clone(),
            a.judged.word().to_owned(),
            change(a, "fitted_before", "fitted_after"),
            change(a, "held_before", "held_after"),
            by_hand.unwrap_or_default(),
            change(a, "peak_before", "peak_after"),
            format!("`{}`", a.is("build")),
        ];
        let _ = writeln!(out, "| {} |", cells.join(" | "));
    }
    out
}

/// Answers of a group by judgement, and the wrong ones among those given 80 % and more.
fn counts(title: &str, group: &[(Judged, f64)]) -> String {
    let mut out = format!("| {title} | {} |", group.len());
    for judged in Judged::ALL {
        let _ = write!(out, " {} |", group.iter().filter(|a| a.0 == judged).count());
    }
    let sure: Vec<_> = group.iter().filter(|a| a.1 >= 0.8).collect();
    let wrong = sure.iter().filter(|a| matches!(a.0, Judged::Other | Judged::Nothing)).count();
    let _ = writeln!(out, " {wrong} of {} |", sure.len());
    out
}

const COUNTS: &str = "\
| | answers | right | unknown, a cause of the library | none, something is missing | another name | wrong of those given 80 % and more |
| --- | --- | --- | --- | --- | --- | --- |
";

fn measured(all: &[Answer]) -> String {
    let group = |test: &dyn Fn(&Answer) -> bool| -> Vec<_> {
        all.iter().filter(|a| test(a)).map(|a| (a.judged, a.number("probability").unwrap())).collect()
    };
    let single = |a: &Answer| !COUNTED.contains(&a.is("source"));
    let mut out =
        counts("measured: what is missing is a cause of the library", &group(&|a| single(a) && a.can_be_named()));
    out += &counts(
        "measured: nothing is missing, or no cause of the library is",
        &group(&|a| single(a) && !a.can_be_named()),
    );
    for (source, title) in [
        ("rc_columns", "measured: columns of concrete"),
        ("rig_faults", "measured: faults put into one channel, and two recordings as they are"),
    ] {
        let of = group(&|a| a.is("source") == source);
        if !of.is_empty() {
            out += &counts(title, &of);
        }
    }
    out
}

/// First answers to the sealed batch that was opened last.
fn made() -> String {
    let all = table("validation/diagnosis/outcomes.csv");
    let last = all.iter().filter_map(|r| r["batch"].parse::<u32>().ok()).max().unwrap().to_string();
    let of = |named: bool| -> Vec<_> {
        let opened = all.iter().filter(|r| r["batch"] == last && r["state"] == "opened");
        let kind = opened.filter(|r| ["none", "unknown"].contains(&r["concealed"].as_str()) != named);
        let judged = |r: &Row| match (r["right"].as_str(), r["answer"].as_str()) {
            ("yes", _) => Judged::Right,
            (_, "unknown") => Judged::Unknown,
            (_, "none") => Judged::Nothing,
            _ => Judged::Other,
        };
        kind.map(|r| (judged(r), r["confidence"].parse::<f64>().unwrap() / 100.0)).collect()
    };
    counts(&format!("made, sealed batch {last}: an effect of the library"), &of(true))
        + &counts(&format!("made, sealed batch {last}: nothing, or an effect that the library lacks"), &of(false))
}

/// Repairs and what they do to runs that were not fitted.
fn repairs(all: &[Answer]) -> String {
    let mut builds: BTreeMap<&str, usize> = BTreeMap::new();
    all.iter().for_each(|a| *builds.entry(a.is("build")).or_default() += 1);
    let builds: Vec<String> = builds.iter().map(|(build, n)| format!("{n} of the build `{build}`")).collect();
    let ratio = |a: &Answer| match [a.number("held_before"), a.number("held_after")] {
        [Some(b), Some(a)] if b != a => Some(a / b),
        _ => None,
    };
    let mut ratios: Vec<f64> = all.iter().filter_map(ratio).collect();
    ratios.sort_by(f64::total_cmp);
    if ratios.is_empty() {
        return String::new();
    }
    let fell = ratios.iter().filter(|r| **r < 1.0).count();
    let accused =
        all.iter().filter(|a| !COUNTED.contains(&a.is("source")) && a.is("cause").starts_with("sensor")).count();
    let builds = builds.join(", ");
    format!(
        "Answers by build: {builds}.\n\
         Of {} answers that changed the model and have runs held out, the error of these runs fell in {fell} and grew in {}. \
         The median of the NMSE after over before is {}, the extremes are {} and {}.\n\
         A sensor is named first in {accused} answers; none is known to be at fault but those of `rig_faults`.\n",
        ratios.len(),
        ratios.len() - fell,
        figures(ratios[ratios.len() / 2]),
        figures(ratios[0]),
        figures(ratios[ratios.len() - 1]),
    )
}

/// Answers by weights that have not seen the author or the family of models.
fn unseen() -> String {
    let all = table("validation/diagnosis/verdict_predictions.csv");
    let (without, with): (Vec<&Row>, Vec<&Row>) = all.iter().partition(|r| r["group"].starts_with("left out"));
    let is_sure = |r: &&&Row| r["probability"].parse::<f64>().unwrap() >= 0.9;
    let sure = |of: &[&Row]| {
        let wrong = of.iter().filter(is_sure).filter(|r| r["right"] != "1").count();
        format!("Of {} answers given 90 % and more {wrong} were wrong.", of.iter().filter(is_sure).count())
    };
    format!(
        "Weights that were fitted to other authors and families predict {} cases. {}\n\
         With the concealed cause taken out of the library they predict {} cases. {}\n",
        with.len(),
        sure(&with),
        without.len(),
        sure(&without)
    )
}

const BEGIN: &str = "<!-- written by HYSTERON_WRITE=1 cargo test --test measured: ";
const END: &str = "<!-- end -->";

/// The page with each marked part replaced by its figures, and the parts that it names.
fn renewed(text: &str, parts: &BTreeMap<&str, String>) -> (String, BTreeSet<String>) {
    let (mut out, mut named) = (String::new(), BTreeSet::new());
    let mut rest = text;
    while let Some(at) = rest.find(BEGIN) {
        let (name, after) = rest[at + BEGIN.len()..].split_once(" -->").unwrap();
        let end = after.find(END).unwrap();
        let part = parts.get(name).unwrap_or_else(|| panic!("no part is called {name}"));
        let _ = write!(out, "{}{BEGIN}{name} -->\n\n{part}\n{END}", &rest[..at]);
        named.insert(name.to_owned());
        rest = &after[end + END.len()..];
    }
    (out + rest, named)
}

fn parts() -> BTreeMap<&'static str, String> {
    let all = answers();
    let switched: Vec<Answer> = answers().into_iter().filter(|a| a.is("source") == "switched").collect();
    BTreeMap::from([
        ("answers", rows(&all)),
        ("judged", format!("{COUNTS}{}", measured(&all))),
        ("side by side", format!("{COUNTS}{}{}", made(), measured(&all))),
        ("repairs", repairs(&all)),
        ("unseen", unseen()),
        ("switched", rows(&switched).replace("](switched/", "](../../validation/recordings/switched/")),
    ])
}

fn hold(page: &Path, wanted: &[&str]) {
    let text = fs::read_to_string(page).unwrap();
    let (new, named) = renewed(&text, &parts());
    assert_eq!(named, wanted.iter().map(|w| (*w).to_owned()).collect(), "{}", page.display());
    if std::env::var_os("HYSTERON_WRITE").is_some() {
        fs::write(page, &new).unwrap();
    } else {
        assert!(new == text, "HYSTERON_WRITE=1 cargo test --test measured writes {} anew", page.display());
    }
}

#[test]
fn the_pages_have_the_figures_of_the_table() {
    hold(&root().join("validation/recordings/README.md"), &["answers", "judged", "repairs"]);
    hold(&root().join("docs/explanation/does-it-work.md"), &["repairs", "side by side", "switched", "unseen"]);
}

/// A probability or an NMSE in a sentence about an answer would be a second copy of the table.
#[test]
fn sentences_of_the_pages_repeat_no_figure_of_an_answer() {
    let folder = root().join("validation/recordings");
    let empty = parts().into_keys().map(|k| (k, String::new())).collect();
    let is_cause = |word: &str| !word.is_empty() && word.chars().all(|c| c.is_ascii_lowercase() || c == '_');
    for page in
        fs::read_dir(&folder).unwrap().map(|e| e.unwrap().path().join("README.md")).chain([folder.join("README.md")])
    {
        let Ok(text) = fs::read_to_string(&page) else { continue };
        for line in renewed(&text, &empty).0.lines() {
            // A name in code with a percentage behind it, and a change of an error.
            let mut named = line.split('`').skip(1).step_by(2).zip(line.split('`').skip(2).step_by(2));
            let probability = |after: &str| {
                let digits = after.trim_start_matches([',', ' ']);
                digits.split_once(" %").is_some_and(|(n, _)| n.parse::<f64>().is_ok())
            };
            assert!(!named.any(|(word, after)| is_cause(word) && probability(after)), "{}: {line}", page.display());
            assert!(!line.contains('→'), "{}: {line}", page.display());
        }
    }
}

#[test]
fn each_study_has_one_answer_and_a_name_that_exists() {
    let causes = fs::read_to_string(root().join("docs/reference/causes.md")).unwrap();
    let mut seen = BTreeSet::new();
    for a in answers() {
        assert!(
            seen.insert((a.is("source").to_owned(), a.is("study").to_owned())),
            "{} {} twice",
            a.is("source"),
            a.is("study")
        );
        for name in a.names.split(" or ").chain([a.is("cause")]) {
            assert!(causes.contains(&format!("| `{name}` |")), "{name} is no cause");
        }
        assert!((0.0..=1.0).contains(&a.number("probability").unwrap()));
    }
}

#[test]
fn a_first_name_decides() {
    let word = |cause, names| Judged::of(cause, names).word();
    assert_eq!(word("pinching", "cyclic_degradation or pinching"), "right");
    assert_eq!(word("mullins_softening", "cyclic_degradation or pinching"), "another name");
    assert_eq!(word("unknown", "pinching"), "unknown");
    assert_eq!(word("unknown", "none or unknown"), "right");
    assert_eq!(word("none", "pinching"), "none");
    assert_eq!(figures(0.012_34), "0.0123");
    assert_eq!(figures(3.676), "3.68");
}
