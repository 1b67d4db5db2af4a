//! `set`, `unset`, `incr`, `append`, `lappend`, and names for variables elsewhere.

use crate::check::PASSED_OVER;
use crate::diagnostic::Diagnostic;
use std::rc::Rc;

use num_bigint::BigInt;

use crate::command::{Call, CoreFn};
use crate::core::{Core, NsId};
use crate::error::Exception;
use crate::expr::arith;
use crate::number::Number;
use crate::value::{Rep, Value};
use crate::vars::{Slot, Trouble, VarName};

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[
    ("append", append),
    ("global", global),
    ("incr", incr),
    ("lappend", lappend),
    ("set", set),
    ("unset", unset),
    ("upvar", upvar),
    ("variable", variable),
    ("trace", trace),
];

fn set(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "set varName ?newValue?")?;
    let name = VarName::of(call.arg(1));
    match call.get(2) {
        None => core.value_of(&name),
        Some(value) => {
            core.assign(&name, value.clone())?;
            Ok(value.clone())
        }
    }
}

fn unset(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let mut complain = true;
    let mut i = 1;
    while let Some(word) = call.get(i) {
        match &*word.as_str() {
            "-nocomplain" => complain = false,
            "--" => {
                i += 1;
                break;
            }
            _ => break,
        }
        i += 1;
    }
    for (at, word) in call.from(i).iter().enumerate() {
        let name = VarName::of(word);
        let result = core.unset(&name, name.element.as_deref());
        if complain {
            result.map_err(|e| e.at(call.span(i + at), ""))?;
        }
    }
    Ok(Value::EMPTY)
}

/// An integer of any size, with the error that `incr` has for others.
pub(super) fn incrementable(value: &Value) -> Result<Number, Exception> {
    value.to_integer().map_err(|e| e.with_code(Value::list(["TCL", "VALUE", "INTEGER"].map(Value::from))))
}

fn incr(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "incr varName ?increment?")?;
    let name = VarName::of(call.arg(1));
    let by = match call.get(2) {
        None => Number::Int(1),
        Some(by) => match incrementable(by) {
            Ok(by) => by,
            Err(e) => {
                // Tcl looks at the variable first.
                core.look(&name).ok().map_or(Ok(()), |v| incrementable(&v).map(|_| ()))?;
                return Err(e.at(call.span(2), ""));
            }
        },
    };
    core.update(&name, true, "read", |value, existed| {
        let sum = match (&value.0, &by) {
            (Rep::Int(i), Number::Int(by)) => i.checked_add(*by),
            (Rep::Empty, Number::Int(by)) if !existed => Some(*by),
            _ => None,
        };
        *value = match sum {
            Some(sum) => Value::from(sum),
            None => {
                let old = if existed { arith::big(&incrementable(value)?) } else { BigInt::ZERO };
                Value::from(old + arith::big(&by))
            }
        };
        Ok(value.clone())
    })
}

fn append(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "append varName ?value ...?")?;
    let name = VarName::of(call.arg(1));
    if call.len() == 2 {
        return core.value_of(&name);
    }
    core.update(&name, true, "set", |value, _| {
        if value.is_empty() && call.len() == 3 {
            *value = call.arg(2).clone();
        } else {
            let text = value.text_mut();
            for word in call.from(2) {
                word.write_to(text);
            }
        }
        Ok(())
    })?;
    core.value_of(&name)
}

fn lappend(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "lappend varName ?value ...?")?;
    let name = VarName::of(call.arg(1));
    if call.len() == 2 && core.look(&name).is_ok() {
        let value = core.value_of(&name)?;
        value.to_list()?;
        return Ok(value);
    }
    core.update(&name, true, "set", |value, _| {
        if call.len() > 2 {
            value.list_mut()?.extend_from_slice(call.from(2));
        }
        Ok(())
    })?;
    core.value_of(&name)
}

impl Core {
    /// Make a name here stand for a variable elsewhere.
    pub(crate) fn link(&mut self, name: &str, target: Rc<std::cell::RefCell<Slot>>) -> Result<(), Exception> {
        if name.ends_with(')') && name.contains('(') {
            let message = format!(
                "bad variable name \"{name}\": can't create a scalar variable that looks like an array element"
            );
            return Err(Exception::coded(message, &["TCL", "UPVAR", "LOCAL_ELEMENT"]));
        }
        let parsed = VarName::simple(name);
        let Some(slot) = self.slot_or_new(&parsed) else {
            return Err(self.var_error("access", &parsed, None, Trouble::NoNamespace));
        };
        match slot {
            Slot::Empty | Slot::Link(_) => {
                if let Slot::Link(old) = slot
                    && Rc::ptr_eq(old, &target)
                {
                    return Ok(());
                }
                *slot = Slot::Link(target);
                Ok(())
            }
            Slot::Shared(own) if Rc::ptr_eq(own, &target) => {
                let message = "can't upvar from variable to itself";
                Err(Exception::coded(message, &["TCL", "UPVAR", "SELF"]))
            }
            Slot::Shared(own) if matches!(*own.borrow(), Slot::Empty) => {
                *slot = Slot::Link(target);
                Ok(())
            }
            _ => {
                let message = format!("variable \"{name}\" already exists");
                Err(Exception::coded(message, &["TCL", "UPVAR", "EXISTS"]))
            }
        }
    }

    /// The variable of a name in another frame, made undefined if there is none.
    pub(crate) fn variable_in(
        &mut self,
        frame: usize,
        name: &VarName,
    ) -> Result<Rc<std::cell::RefCell<Slot>>, Exception> {
        let active = std::mem::replace(&mut self.calls.active, frame);
        let result = self.shared(name);
        self.calls.active = active;
        result.map_err(|why| self.var_error("access", name, name.element.as_deref(), why))
    }

    fn shared(&mut self, name: &VarName) -> Result<Rc<std::cell::RefCell<Slot>>, Trouble> {
        let Some(slot) = self.slot_or_new(name) else { return Err(Trouble::NoNamespace) };
        let Some(element) = &name.element else { return Ok(slot.share()) };
        slot.with_mut(|slot| {
            if matches!(slot, Slot::Empty) {
                *slot = Slot::Array(Box::default());
            }
            match slot {
                Slot::Array(a) => {
                    let hash = crate::table::hash(element);
                    Ok(a.entry_or(element, hash, Slot::default).share())
                }
                _ => Err(Trouble::NotArray),
            }
        })
    }
}

fn upvar(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let usage = "upvar ?level? otherVar localVar ?otherVar localVar ...?";
    call.expect(3.., usage)?;
    let level = call.arg(1).as_str();
    let leveled = call.len().is_multiple_of(2);
    let (frame, from) = match core.find_level(&level).filter(|_| leveled) {
        Some(frame) => (frame?, 2),
        None if leveled => {
            let message = format!("bad level \"{level}\"");
            return Err(Exception::coded(message, &["TCL", "LOOKUP", "LEVEL", &level]).at(call.span(1), ""));
        }
        None => {
            let up = core.frame().level.checked_sub(1).and_then(|l| core.frame_at(l));
            let bad = || Exception::coded("bad level \"1\"", &["TCL", "LOOKUP", "LEVEL", "1"]);
            (up.ok_or_else(bad)?, 1)
        }
    };
    for pair in call.from(from).chunks_exact(2) {
        let [other, local] = pair else { continue };
        let target = core.variable_in(frame, &VarName::of(other))?;
        core.link(&local.as_str(), target)?;
    }
    Ok(Value::EMPTY)
}

fn global(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    if !core.frame().is_proc {
        return Ok(Value::EMPTY);
    }
    for word in call.args() {
        let name = word.as_str();
        let local = name.rsplit("::").next().unwrap_or_default();
        let target = core.variable_in(0, &VarName::simple(&name))?;
        core.link(local, target)?;
    }
    Ok(Value::EMPTY)
}

fn variable(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    for pair in call.args().chunks(2) {
        let Some(word) = pair.first() else { continue };
        let text = word.as_str();
        if text.ends_with(')') && text.contains('(') {
            let message = format!("can't define \"{text}\": name refers to an element in an array");
            return Err(Exception::coded(message, &["TCL", "UPVAR", "LOCAL_ELEMENT"]));
        }
        let ns = core.here();
        let name = if text.starts_with("::") || ns == NsId::GLOBAL {
            VarName::simple(&text)
        } else {
            VarName::simple(&core.qualified(ns, &text))
        };
        let target = core
            .variable_in(0, &name)
            .map_err(|_| core.var_error("define", &VarName::simple(&text), None, Trouble::NoNamespace))?;
        if let Some(value) = pair.get(1) {
            core.write(&VarName::simple(&format!("::{}", name.text.trim_start_matches(':'))), None, value.clone())?;
        }
        if core.frame().is_proc {
            let local = text.rsplit("::").next().unwrap_or_default();
            core.link(local, target)?;
        }
    }
    Ok(Value::EMPTY)
}

/// Watching of executions changes no result and is passed over; that of variables may.
fn trace(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let words: Vec<_> = call.args().iter().take(2).map(Value::as_str).collect();
    if let [_, kind] = &words[..]
        && matches!(kind.as_ref(), "execution" | "command")
    {
        let warning = Diagnostic::warning(&PASSED_OVER, "trace: commands are not watched here: it is ignored");
        core.warn(warning.at(call.span(0), "not supported"));
        return Ok(Value::EMPTY);
    }
    let message = "trace: variables cannot be watched here";
    Err(call.error_at(0, message, "not supported"))
}
