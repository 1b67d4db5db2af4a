//! Looking variables up, setting and removing them.

use std::rc::Rc;

use super::core::{Core, NsId};
use super::error::Exception;
use super::table::Table;
use super::text::Text;
use super::value::Value;
use super::vars::{Scope, Slot, Trouble, VarName, Watch, WatchedSlot, put, take};
use crate::check::UNKNOWN_VARIABLE;
use crate::diagnostic::{self, Absent, VARIABLE};

impl Core {
    /// The error for a variable, in Tcl's words: `can't read "x": no such variable`.
    pub(crate) fn var_error(&self, doing: &str, name: &VarName, index: Option<&str>, why: Trouble) -> Exception {
        let full = name.full(index);
        let message = format!("can't {doing} \"{full}\": {}", why.text());
        let code: &[&str] = match (why, doing) {
            (Trouble::NoVariable | Trouble::DanglingLink, _) => &["TCL", "LOOKUP", "VARNAME", &name.text],
            (Trouble::Undefined, "unset") => &["TCL", "UNSET", "VARNAME"],
            (Trouble::Undefined, _) => &["TCL", "READ", "VARNAME"],
            (Trouble::NoElement, "read") => &["TCL", "READ", "VARNAME"],
            (Trouble::NoElement, _) => &["TCL", "LOOKUP", "ELEMENT", index.unwrap_or_default()],
            (Trouble::IsArray, "read") => &["TCL", "READ", "VARNAME"],
            (Trouble::IsArray, _) => &["TCL", "WRITE", "VARNAME"],
            (Trouble::NotArray, "array set") => &["TCL", "WRITE", "ARRAY"],
            (Trouble::NotArray | Trouble::NoNamespace, _) => &["TCL", "LOOKUP", "VARNAME", &name.text],
            (Trouble::Unread, _) => &["TCL", "WRITE", "VARNAME"],
        };
        let mut e = Exception::coded(message, code);
        if let Trouble::NoVariable | Trouble::Undefined = why {
            e = e.by(&UNKNOWN_VARIABLE).absent(Absent::new(VARIABLE, &full));
        }
        if self.calls.catching > 0 {
            return e;
        }
        match (why, index) {
            (Trouble::NoVariable | Trouble::Undefined, _) => e.suggest(&full, self.nearest_variable(name)),
            (Trouble::NoElement, Some(index)) => {
                let near = self.slot(name).and_then(|slot| {
                    slot.with(|s| match s {
                        Slot::Array(a) => diagnostic::nearest(index, a.iter().map(|(k, _)| &**k)).map(str::to_owned),
                        _ => None,
                    })
                });
                e.suggest(&full, near.map(|k| name.full(Some(&k))))
            }
            _ => e,
        }
    }

    fn nearest_variable(&self, name: &VarName) -> Option<String> {
        let near = |vars: &Table<Slot>| {
            let known = vars.iter().filter(|(_, slot)| slot.exists()).map(|(k, _)| &**k);
            diagnostic::nearest(&name.tail, known).map(str::to_owned)
        };
        let frame = self.frame();
        let local = if frame.is_proc { near(&frame.vars) } else { near(&self.ns(frame.ns).vars) };
        local.or_else(|| {
            let global = near(&self.ns(NsId::GLOBAL).vars)?;
            Some(if frame.is_proc { format!("::{global}") } else { global })
        })
    }

    /// The namespace in which a qualified name is looked up.
    fn scope_of(&self, name: &VarName) -> Option<NsId> {
        match &name.scope {
            Scope::Here => Some(self.frame().ns),
            Scope::Global => Some(NsId::GLOBAL),
            Scope::Qualified(path) => self.find_namespace(path),
        }
    }

    /// The slot of a variable, if there is one.
    pub(crate) fn slot(&self, name: &VarName) -> Option<&Slot> {
        let frame = self.frame();
        if let Scope::Here = name.scope {
            if frame.is_proc {
                return frame.vars.get_near(&name.tail, name.hash, &name.near);
            }
            if frame.ns != NsId::GLOBAL
                && let Some(slot) = self.ns(frame.ns).vars.get_near(&name.tail, name.hash, &name.near)
            {
                return Some(slot);
            }
            return self.ns(NsId::GLOBAL).vars.get_near(&name.tail, name.hash, &name.near);
        }
        self.ns(self.scope_of(name)?).vars.get_near(&name.tail, name.hash, &name.near)
    }

    /// As [`Core::slot`], to change it.
    pub(crate) fn slot_mut(&mut self, name: &VarName) -> Option<&mut Slot> {
        let active = self.calls.active;
        if let Scope::Here = name.scope {
            if self.calls.frames[active].is_proc {
                return self.calls.frames[active].vars.get_near_mut(&name.tail, name.hash, &name.near);
            }
            let ns = self.calls.frames[active].ns;
            let here = ns != NsId::GLOBAL && self.ns(ns).vars.get_near(&name.tail, name.hash, &name.near).is_some();
            let ns = if here { ns } else { NsId::GLOBAL };
            return self.ns_mut(ns).vars.get_near_mut(&name.tail, name.hash, &name.near);
        }
        let ns = self.scope_of(name)?;
        self.ns_mut(ns).vars.get_near_mut(&name.tail, name.hash, &name.near)
    }

    /// The slot of a variable, made if there is none; `None` where its namespace does not exist.
    pub(crate) fn slot_or_new(&mut self, name: &VarName) -> Option<&mut Slot> {
        let active = self.calls.active;
        if let Scope::Here = name.scope
            && self.calls.frames[active].is_proc
        {
            return Some(self.calls.frames[active].vars.entry_or(&name.tail, name.hash, Slot::default));
        }
        let mut ns = self.scope_of(name)?;
        if let Scope::Here = name.scope
            && ns != NsId::GLOBAL
            && self.ns(ns).vars.get_near(&name.tail, name.hash, &name.near).is_none()
            && self.ns(NsId::GLOBAL).vars.get_near(&name.tail, name.hash, &name.near).is_some_and(Slot::exists)
        {
            ns = NsId::GLOBAL;
        }
        Some(self.ns_mut(ns).vars.entry_or(&name.tail, name.hash, Slot::default))
    }

    /// The value of a variable.
    pub(crate) fn read(&self, name: &VarName, index: Option<&str>) -> Result<Value, Exception> {
        self.peek(name, index).map_err(|why| self.var_error("read", name, index, why))
    }

    /// The value of a variable whose name may have an index.
    pub(crate) fn value_of(&self, name: &VarName) -> Result<Value, Exception> {
        self.read(name, name.element.as_deref())
    }

    /// As [`Core::value_of`], or why there is none.
    pub(crate) fn look(&self, name: &VarName) -> Result<Value, Trouble> {
        self.peek(name, name.element.as_deref())
    }

    /// Set a variable whose name may have an index.
    pub(crate) fn assign(&mut self, name: &VarName, value: Value) -> Result<(), Exception> {
        self.write(name, name.element.as_ref(), value)
    }

    /// The value of a variable, or why there is none.
    pub(crate) fn peek(&self, name: &VarName, index: Option<&str>) -> Result<Value, Trouble> {
        let Some(slot) = self.slot(name) else {
            // The variables of a procedure are known from its text on.
            let known = self.frame().is_proc && matches!(name.scope, Scope::Here);
            return Err(if known { Trouble::Undefined } else { Trouble::NoVariable });
        };
        slot.with(|slot| match (slot, index) {
            (Slot::Scalar(v), None) => Ok(v.clone()),
            (Slot::Array(a), Some(i)) => a.get(i).and_then(Slot::scalar).ok_or(Trouble::NoElement),
            (Slot::Array(_), None) => Err(Trouble::IsArray),
            (Slot::Scalar(_), Some(_)) => Err(Trouble::NotArray),
            _ => Err(Trouble::Undefined),
        })
    }

    /// Set a variable.
    pub(crate) fn write(&mut self, name: &VarName, index: Option<&Text>, value: Value) -> Result<(), Exception> {
        let value = match index {
            None => match self.set_scalar(name, value) {
                None => return Ok(()),
                Some(value) => value,
            },
            Some(_) => value,
        };
        let done = match self.slot_or_new(name) {
            None => Err(Trouble::NoNamespace),
            Some(slot) => slot.with_mut(|slot| put(slot, index, value)),
        };
        if name.is_precision {
            self.take_precision()?;
        }
        done.map_err(|why| self.var_error("set", name, index.map(|t| &**t), why))
    }

    /// Change the value of a variable where it is, so that a list of its own is not copied.
    /// A variable that does not exist starts out empty if `create`. `doing`: what an error says of a variable that is in the
    /// way, `read` or `set`.
    pub(crate) fn update<R>(
        &mut self,
        name: &VarName,
        create: bool,
        doing: &str,
        change: impl FnOnce(&mut Value, bool) -> Result<R, Exception>,
    ) -> Result<R, Exception> {
        let index = name.element.as_ref();
        // Takes the value out first: the change may want to tell of an error without the variable being borrowed.
        let taken = match self.slot_mut(name) {
            None => Err(Trouble::NoVariable),
            Some(slot) => slot.with_mut(|slot| take(slot, index)),
        };
        let (mut value, existed) = match taken {
            Ok(value) => (value, true),
            Err(Trouble::NoVariable | Trouble::Undefined | Trouble::NoElement) if create => (Value::EMPTY, false),
            Err(why) => {
                let doing = if matches!(why, Trouble::IsArray) { "set" } else { doing };
                return Err(self.var_error(doing, name, index.map(|t| &**t), why));
            }
        };
        let result = change(&mut value, existed);
        if existed || result.is_ok() {
            self.write(name, index, value)?;
        }
        result
    }

    /// Remove a variable, or return the reason that forbids it.
    pub(crate) fn unset(&mut self, name: &VarName, index: Option<&str>) -> Result<(), Exception> {
        let known = index.is_none() && self.frame().is_proc && matches!(name.scope, Scope::Here);
        let done = match self.slot_mut(name) {
            None if known => Err(Trouble::Undefined),
            None => Err(Trouble::NoVariable),
            Some(slot) => slot.with_mut(|slot| match (slot, index) {
                (Slot::Empty, _) => Err(Trouble::Undefined),
                (Slot::Array(a), Some(i)) => match a.get_mut(i).filter(|s| s.exists()) {
                    None => Err(Trouble::NoElement),
                    Some(element) => {
                        let named_elsewhere = matches!(&*element, Slot::Shared(s) if Rc::strong_count(s) > 1);
                        if named_elsewhere {
                            element.with_mut(|s| *s = Slot::Empty);
                        } else {
                            a.remove(i);
                        }
                        Ok(())
                    }
                },
                (_, Some(_)) => Err(Trouble::NotArray),
                (slot, None) => {
                    *slot = Slot::Empty;
                    Ok(())
                }
            }),
        };
        if index.is_none() && done.is_ok() {
            self.drop_slot(name);
        }
        done.map_err(|why| self.var_error("unset", name, index, why))
    }

    /// Forget the name of an empty variable, unless it stands for a variable elsewhere.
    fn drop_slot(&mut self, name: &VarName) {
        let gone = match self.slot(name) {
            Some(Slot::Shared(s)) => Rc::strong_count(s) == 1,
            Some(Slot::Empty) => true,
            _ => false,
        };
        if !gone {
            return;
        }
        let frame = self.frame();
        let ns = match name.scope {
            Scope::Here if frame.is_proc => None,
            Scope::Here if self.ns(frame.ns).vars.get_near(&name.tail, name.hash, &name.near).is_none() => {
                Some(NsId::GLOBAL)
            }
            _ => self.scope_of(name),
        };
        match ns {
            None => {
                let active = self.calls.active;
                self.calls.frames[active].vars.remove(&name.tail);
            }
            Some(ns) => {
                self.ns_mut(ns).vars.remove(&name.tail);
            }
        }
    }

    /// Look at the elements of an array; `None` where the variable is none.
    pub(crate) fn array<R>(&self, name: &VarName, look: impl FnOnce(&Table<Slot>) -> R) -> Option<R> {
        let found = match &name.element {
            None => self.slot(name)?,
            Some(_) => return None,
        };
        found.with(|slot| if let Slot::Array(a) = slot { Some(look(a)) } else { None })
    }

    /// Make a variable an array unless it is one.
    pub(crate) fn make_array(&mut self, name: &VarName) -> Result<(), Trouble> {
        match self.slot_or_new(name) {
            None => Err(Trouble::NoNamespace),
            Some(slot) => slot.with_mut(|slot| match slot {
                Slot::Empty => {
                    *slot = Slot::Array(Box::default());
                    Ok(())
                }
                Slot::Array(_) => Ok(()),
                _ => Err(Trouble::NotArray),
            }),
        }
    }

    /// The value of a variable by name, `name(index)` and qualified names included.
    ///
    /// # Errors
    /// There is no such variable, or it is an array.
    pub fn get_var(&self, name: &str) -> Result<Value, Exception> {
        let name = VarName::of_host(name);
        self.value_of(&name)
    }

    /// Set a variable by name.
    ///
    /// # Errors
    /// A scalar under the name of an array, an array under the name of a scalar, or a namespace that does not exist.
    pub fn set_var(&mut self, name: &str, value: impl Into<Value>) -> Result<(), Exception> {
        let name = VarName::of_host(name);
        self.assign(&name, value.into())
    }

    /// Scalars of the global namespace with their values, in any order.
    pub fn globals(&self) -> Vec<(String, Value)> {
        let vars = self.ns(NsId::GLOBAL).vars.iter();
        vars.filter_map(|(name, slot)| Some((name.to_string(), slot.unwatched_scalar()?))).collect()
    }

    /// Note the first use of a scalar that is there: setting it before it is read becomes an error. `None` if there is no
    /// such scalar.
    pub fn watch_var(&mut self, name: &str) -> Option<Watch> {
        let name = VarName::of_host(name);
        let slot = self.slot_mut(&name).filter(|_| name.element.is_none())?;
        slot.with_mut(|slot| {
            let watch = Watch::default();
            let scalar = matches!(slot, Slot::Scalar(_));
            scalar.then(|| {
                *slot = Slot::Watched(Box::new(WatchedSlot { slot: std::mem::take(slot), watch: watch.clone() }));
                watch
            })
        })
    }

    /// `tcl_precision` has been set: take it over, or refuse it.
    fn take_precision(&mut self) -> Result<(), Exception> {
        let value = match self.ns(NsId::GLOBAL).vars.get("tcl_precision") {
            Some(slot) => slot.scalar(),
            None => None,
        };
        match value.as_ref().map(|v| v.to_i64().unwrap_or(-1)) {
            Some(p @ 0..=17) => {
                self.precision = p as usize;
                Ok(())
            }
            None => Ok(()),
            Some(_) => {
                let old = Value::from(self.precision);
                if let Some(slot) = self.ns_mut(NsId::GLOBAL).vars.get_mut("tcl_precision") {
                    slot.with_mut(|s| *s = Slot::Scalar(old));
                }
                Err(Exception::coded(
                    "can't set \"tcl_precision\": improper value for precision",
                    &["TCL", "WRITE", "VARNAME"],
                ))
            }
        }
    }
}
