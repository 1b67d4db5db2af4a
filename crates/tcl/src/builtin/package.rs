//! `package`. Nothing is searched for: there is Tcl itself, what a script provides, and the part of tcllib that scripts of
//! models use.

use std::cmp::Ordering;

use crate::command::{Call, CommandFn};
use crate::core::Core;
use crate::error::Exception;
use crate::interp::Interp;
use crate::value::Value;

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 1] {
    [("package", package)]
}

/// Packages of tcllib by name, version and script.
const LIBRARY: [[&str; 3]; 2] = [
    ["math::statistics", "1.0", include_str!("library/statistics.tcl")],
    ["math::linearalgebra", "1.1", include_str!("library/linear_algebra.tcl")],
];

const NAMES: [&str; 11] = [
    "forget",
    "ifneeded",
    "names",
    "prefer",
    "present",
    "provide",
    "require",
    "unknown",
    "vcompare",
    "versions",
    "vsatisfies",
];

fn package<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    let core = &mut interp.core;
    call.expect(2.., "package option ?arg ...?")?;
    match NAMES[call.choose(1, "option", &NAMES, false)?] {
        "forget" => {
            for name in call.from(2) {
                core.packages.provided.remove(&name.as_str());
            }
            Ok(Value::EMPTY)
        }
        "ifneeded" => {
            call.expect(4..=5, "package ifneeded package version ?script?")?;
            version_numbers(call.arg(3))?;
            let (name, version) = (call.arg(2).clone(), call.arg(3).clone());
            let known = core.packages.offered.iter().position(|o| o[0] == name && o[1] == version);
            match (call.get(4), known) {
                (None, known) => Ok(known.map(|at| core.packages.offered[at][2].clone()).unwrap_or_default()),
                (Some(script), known) => {
                    if let Some(at) = known {
                        core.packages.offered.remove(at);
                    }
                    core.packages.offered.push([name, version, script.clone()]);
                    Ok(Value::EMPTY)
                }
            }
        }
        "names" => {
            call.expect(2..=2, "package names")?;
            let offered: Vec<Value> = core.packages.offered.iter().map(|o| o[0].clone()).collect();
            Ok(Value::list(
                [Value::from("Tcl")]
                    .into_iter()
                    .chain(core.packages.provided.iter().map(|(k, _)| k.to_value()))
                    .chain(offered),
            ))
        }
        "prefer" => Ok(Value::from("stable")),
        "present" => require(core, call, true),
        "provide" => {
            call.expect(3..=4, "package provide package ?version?")?;
            match call.get(3) {
                None => Ok(provided(core, &call.arg(2).as_str()).unwrap_or_default()),
                Some(version) => {
                    version_numbers(version)?;
                    core.packages.provided.insert(call.arg(2).to_text(), version.clone());
                    Ok(Value::EMPTY)
                }
            }
        }
        "require" => {
            offer(interp, call)?;
            require(&mut interp.core, call, false)
        }
        "unknown" => Ok(Value::EMPTY),
        "vcompare" => {
            call.expect(4..=4, "package vcompare version1 version2")?;
            let order = version_numbers(call.arg(2))?.cmp(&version_numbers(call.arg(3))?);
            Ok(Value::from(order as i64))
        }
        "versions" => {
            call.expect(3..=3, "package versions package")?;
            let of = core.packages.offered.iter().filter(|o| o[0] == *call.arg(2)).map(|o| o[1].clone());
            Ok(Value::list(of))
        }
        _ => {
            call.expect(4.., "package vsatisfies version ?requirement ...?")?;
            Ok(Value::from(satisfies(call.arg(2), call.from(3))?))
        }
    }
}

fn provided(core: &Core, name: &str) -> Option<Value> {
    if name == "Tcl" {
        return Some(Value::from(super::PATCH_LEVEL));
    }
    core.packages.provided.get(name).cloned()
}

/// `8.6.1`, `8.6b2`: numbers to compare; alpha and beta come before the release.
fn version_numbers(version: &Value) -> Result<Vec<i64>, Exception> {
    let text = version.as_str();
    let bad = || {
        let message = format!("expected version number but got \"{text}\"");
        Exception::coded(message, &["TCL", "VALUE", "VERSION"])
    };
    if !text.starts_with(|c: char| c.is_ascii_digit()) || !text.ends_with(|c: char| c.is_ascii_digit()) {
        return Err(bad());
    }
    let mut numbers = vec![];
    let mut rest: &str = &text;
    loop {
        let length = rest.bytes().take_while(u8::is_ascii_digit).count();
        numbers.push(rest[..length].parse().map_err(|_| bad())?);
        rest = &rest[length..];
        let Some(separator) = rest.chars().next() else { break };
        rest = &rest[separator.len_utf8()..];
        match separator {
            '.' => {}
            // Before the release, which has a zero there.
            'a' => numbers.push(-2),
            'b' => numbers.push(-1),
            _ => return Err(bad()),
        }
    }
    // Of equal length they compare as if zeros followed.
    numbers.resize(numbers.len().max(8), 0);
    Ok(numbers)
}

/// Returns true if a version is at least the required one and has the same major version.
fn satisfies(version: &Value, requirements: &[Value]) -> Result<bool, Exception> {
    let have = version_numbers(version)?;
    let mut fits = requirements.is_empty();
    for requirement in requirements {
        let text = requirement.as_str();
        let (least, most) = match text.split_once('-') {
            None => {
                let least = version_numbers(requirement)?;
                let mut next_major = vec![0; 8];
                next_major[0] = least.first().copied().unwrap_or(0) + 1;
                (least, Some(next_major))
            }
            Some((least, "")) => (version_numbers(&Value::from(least))?, None),
            Some((least, most)) => (version_numbers(&Value::from(least))?, Some(version_numbers(&Value::from(most))?)),
        };
        fits |= have >= least && most.is_none_or(|m| have.cmp(&m) == Ordering::Less || have == least);
    }
    Ok(fits)
}

/// Run the script that provides a package, the newest version that will do, unless it is there already.
fn offer<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<(), Exception> {
    let exact = call.arg(2).as_str() == "-exact";
    let at = if exact { 3 } else { 2 };
    let name = call.arg(at);
    if name.is_empty() || provided(&interp.core, &name.as_str()).is_some() {
        return Ok(());
    }
    let mut best: Option<(Vec<i64>, Value)> = None;
    for [package, version, script] in &interp.core.packages.offered {
        let fits = if exact {
            version_numbers(version)? == version_numbers(call.arg(at + 1))?
        } else {
            satisfies(version, call.from(at + 1))?
        };
        if package == name && fits {
            let numbers = version_numbers(version)?;
            if best.as_ref().is_none_or(|(b, _)| *b < numbers) {
                best = Some((numbers, script.clone()));
            }
        }
    }
    let library = LIBRARY.iter().find(|[known, ..]| *known == name.as_str());
    match (best, library) {
        (Some((_, script)), _) => interp.eval_value(&script).map(drop),
        (None, Some([_, _, script])) => interp.eval_value(&Value::from(*script)).map(drop),
        (None, None) => Ok(()),
    }
}

fn require(core: &mut Core, call: &Call<'_>, present: bool) -> Result<Value, Exception> {
    let verb = if present { "present" } else { "require" };
    let exact = call.arg(2).as_str() == "-exact";
    let at = if exact { 3 } else { 2 };
    if call.len() <= at || (exact && call.len() != 5) {
        return Err(call.wrong_args(&format!("package {verb} ?-exact? package ?requirement ...?")));
    }
    let name = call.arg(at).as_str();
    let requirements = call.from(at + 1);
    for requirement in requirements {
        satisfies(&Value::from("1"), std::slice::from_ref(requirement))?;
    }
    let shown: String =
        requirements.iter().map(|r| if exact { format!(" exactly {r}") } else { format!(" {r}") }).collect();
    let Some(version) = provided(core, &name) else {
        let message = match present {
            true => format!("package {name}{shown} is not present"),
            false => format!("can't find package {name}{shown}"),
        };
        let code = if present { vec!["TCL", "LOOKUP", "PACKAGE", &name] } else { vec!["TCL", "PACKAGE", "UNFOUND"] };
        return Err(Exception::coded(message, &code).at(call.span(at), "no such package here"));
    };
    let fits = match requirements.first().filter(|_| exact) {
        Some(wanted) => version_numbers(&version)? == version_numbers(wanted)?,
        None => satisfies(&version, requirements)?,
    };
    if !fits {
        let need = if exact {
            format!("exactly {}", requirements[0])
        } else {
            requirements.iter().map(|r| r.as_str().into_owned()).collect::<Vec<_>>().join(" ")
        };
        let message = format!("version conflict for package \"{name}\": have {version}, need {need}");
        return Err(Exception::coded(message, &["TCL", "PACKAGE", "VERSIONCONFLICT"]).at(call.span(at), ""));
    }
    Ok(version)
}
