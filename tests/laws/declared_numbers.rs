//! Domains of numbers: a value outside of the domain that a row declares is refused by the name of the argument, and the
//! domain of what is refused is declared.

use super::declared_calls::{Call, calls, context};
use super::script::Script;
use hysteron::opensees::{AMENDMENTS, Arg, Command, Domain, KindUsage, Mode, commands};
use std::collections::BTreeMap;

/// Values one after the other in the place of each number.
const TRIED: [f64; 4] = [-0.7, 0.0, 1.0, 1.7];

/// Commands whose numbers are read only once there are results, modes or an open pattern.
const WITHOUT_CALL: [&str; 4] = ["analyze", "groundMotion", "modalDamping", "responseSpectrumAnalysis"];

/// A row of a table of commands or kinds, by its usage: several kinds may share one.
type Row = &'static str;

/// A value that was refused: itself, the words for the number, and what was expected.
struct Refused {
    x: f64,
    what: String,
    label: String,
}

/// The command of a call, and its kind.
fn made_by(call: &str) -> (&'static Command, Option<KindUsage>) {
    let mut words = call.split(' ');
    let name = words.next().unwrap();
    let command = commands().find(|c| c.name == name).unwrap_or_else(|| panic!("no command {name}"));
    (command, words.next().and_then(|word| command.kinds().into_iter().find(|k| k.names.contains(&word))))
}

fn row((command, kind): (&'static Command, Option<KindUsage>)) -> Row {
    kind.map_or(command.usage, |k| k.usage)
}

/// True for a value that a number of the domain cannot have.
fn is_outside(domain: Domain, x: f64) -> bool {
    match domain {
        Domain::Positive | Domain::UsuallyPositive => x <= 0.0,
        Domain::NotNegative | Domain::UsuallyNotNegative => x < 0.0,
        Domain::Negative => x >= 0.0,
        Domain::Ratio => !(0.0..1.0).contains(&x),
        Domain::Fraction => !(0.0..=1.0).contains(&x),
        Domain::Count => x < 1.0 && x.fract() == 0.0,
        Domain::Number | Domain::Whole | Domain::Tag => false,
    }
}

/// The words that name the arguments of a usage, each with the option before it.
fn named(usage: &str) -> Vec<(String, String)> {
    let mut option = String::new();
    let mut out = vec![];
    for word in usage.split(|c: char| c.is_whitespace() || "<>|{}".contains(c)) {
        match (word.strip_prefix('$'), word.starts_with('-')) {
            (Some(name), _) => out.push((option.clone(), name.to_owned())),
            (None, true) => {
                option = word.to_owned();
                out.push((option.clone(), String::new()));
            }
            (None, false) => {}
        }
    }
    out
}

/// Arguments that a row declares and its usage names.
fn declared(command: &'static Command, kind: Option<KindUsage>) -> Vec<&'static Arg> {
    let usage = kind.map_or(command.usage, |k| k.usage);
    let names = named(usage);
    let own = kind.map_or(command.text, |k| k.text);
    let own = own.arguments.iter().chain(own.groups.iter().copied().flatten());
    let mut out: Vec<&Arg> = own.filter(|a| names.iter().any(|(_, name)| name == a.name)).collect();
    for (option, name) in &names {
        let is_there = out.iter().any(|arg| arg.name == *name && (arg.option == *option || arg.option.is_empty()));
        out.extend(command.argument(kind, option, name).filter(|_| !is_there));
    }
    if command.name == "amend" {
        out.extend(AMENDMENTS.iter().flat_map(|kind| kind.options).map(|option| &option.arg));
    }
    out
}

/// Values that a check refuses in each call, by rows.
fn refused(calls: &[Call]) -> BTreeMap<Row, Vec<Refused>> {
    let mut out: BTreeMap<Row, Vec<Refused>> = BTreeMap::new();
    let mut tag = 1000;
    for Call { ndm, ndf, words: call } in calls {
        let made = made_by(call);
        let at = made.0.definition().1;
        let words: Vec<&str> = call.split(' ').collect();
        let mut script = context(*ndm, *ndf);
        let first = script.lines().count() + 1;
        let mut values = vec![];
        // Commands in braces have rows of their own.
        let outside = words.iter().position(|w| w.starts_with('{')).unwrap_or(words.len());
        for i in (0..outside).filter(|i| *i != at && words[*i].parse::<f64>().is_ok()) {
            for x in TRIED {
                tag += 1;
                let (mut words, text, tag) = (words.clone(), x.to_string(), tag.to_string());
                words[i] = &text;
                if at > 0 && words.get(at).is_some_and(|w| w.parse::<i32>().is_ok()) {
                    words[at] = &tag;
                }
                script += &(words.join(" ") + "\n");
                values.push((x, text));
            }
        }
        let mut check = Script::default();
        check.mode = Mode::Check;
        for d in check.run(&script).warnings() {
            let Some(span) = d.span else { continue };
            let line = script[..(span.start as usize).min(script.len())].lines().count();
            let Some((x, text)) = line.checked_sub(first).and_then(|i| values.get(i)) else { continue };
            if let Some(what) = d.message.strip_suffix(&format!(" is {text}")) {
                let refused = Refused { x: *x, what: what.to_owned(), label: d.label.clone() };
                out.entry(row(made)).or_default().push(refused);
            }
        }
    }
    out
}

/// True if a message about a number is about an argument: of several of them it names one by its place.
fn is_about(what: &str, arg: &Arg) -> bool {
    what.strip_prefix(arg.meaning).is_some_and(|rest| rest.is_empty() || rest.trim_start().parse::<u32>().is_ok())
}

/// Every command and kind.
fn rows() -> impl Iterator<Item = (&'static Command, Option<KindUsage>)> {
    commands().flat_map(|command| {
        let kinds = command.kinds();
        let none = kinds.is_empty().then_some((command, None));
        kinds.into_iter().map(move |kind| (command, Some(kind))).chain(none)
    })
}

#[test]
fn a_value_outside_of_a_declared_domain_is_refused_by_the_name_of_its_argument() {
    let refused = refused(&calls());
    let mut accepted = vec![];
    for (command, kind) in rows() {
        let row = row((command, kind));
        if WITHOUT_CALL.contains(&command.name) {
            continue;
        }
        for arg in declared(command, kind) {
            let Some(domain) = arg.domain.filter(|d| TRIED.iter().any(|x| is_outside(*d, *x))) else { continue };
            let of_row = refused.get(&row).map_or(&[][..], Vec::as_slice);
            if !of_row.iter().any(|r| is_outside(domain, r.x) && is_about(&r.what, arg)) {
                accepted.push(format!("{row}: {} {} \"{}\"", arg.option, arg.name, arg.meaning));
            }
        }
    }
    assert!(accepted.is_empty(), "{} are not refused:\n{}", accepted.len(), accepted.join("\n"));
}

#[test]
fn the_domain_of_a_number_that_is_refused_is_declared() {
    let mut undeclared = vec![];
    // The usage of some kinds names that of another one.
    for (row, of_row) in refused(&calls()).into_iter().filter(|(row, _)| row.contains('$')) {
        let (command, kind) = rows().find(|r| self::row(*r) == row).unwrap();
        let arguments = declared(command, kind);
        for Refused { x, what, label } in &of_row {
            let of_domain = [", a number", ", at least 1"].map(|end| format!("expected the {what}{end}"));
            if !of_domain.iter().any(|expected| label.starts_with(expected)) {
                continue;
            }
            let holds = |arg: &&Arg| is_about(what, arg) && arg.domain.is_some_and(|d| is_outside(d, *x));
            let line = format!("{row}: {what}: {label}");
            if !arguments.iter().any(holds) && !undeclared.contains(&line) {
                undeclared.push(line);
            }
        }
    }
    assert!(undeclared.is_empty(), "{} are not declared:\n{}", undeclared.len(), undeclared.join("\n"));
}

/// Options of a usage, each once, in its order.
fn options(usage: &str) -> Vec<&str> {
    let mut out = vec![];
    for word in usage.split([' ', '<', '>', '|']) {
        let is_option = word.strip_prefix('-').is_some_and(|w| w.starts_with(char::is_alphabetic));
        if is_option && !out.contains(&word) {
            out.push(word);
        }
    }
    out
}

/// A message about a word that is no option lists those of the usage, in its order.
#[test]
fn a_message_about_an_option_lists_those_of_the_usage() {
    let (mut listed, mut wrong) = (0, vec![]);
    for Call { ndm, ndf, words } in calls().iter().filter(|call| !call.words.contains('{')) {
        let (usage, is_amendment) = (row(made_by(words)), words.starts_with("amend "));
        let mut check = Script::default();
        check.mode = Mode::Check;
        let ran = check.run(&format!("{}{words} -zz\n", context(*ndm, *ndf)));
        for d in ran.warnings().iter().filter(|d| d.message.contains("\"-zz\"")) {
            let help = d.help.iter().find_map(|h| h.strip_prefix("known: "));
            // An amendment lists its own options.
            let shown = d.label.strip_prefix("expected one of ").or(help).filter(|shown| shown.starts_with('-'));
            let Some(shown) = shown.filter(|_| !is_amendment) else { continue };
            listed += 1;
            let line = format!("{usage}:\n    {shown}");
            if shown.split(' ').collect::<Vec<_>>() != options(usage) && !wrong.contains(&line) {
                wrong.push(line);
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {listed} list others:\n{}", wrong.len(), wrong.join("\n"));
}
