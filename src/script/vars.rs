//! Variables: scalars, arrays, and names that stand for variables elsewhere.

use std::cell::RefCell;
use std::rc::Rc;

use super::core::{Core, NsId};
use super::error::Exception;
use super::table::{self, Table};
use super::text::{Cache, Text};
use super::value::{Rep, Value};
use crate::diagnostic;

/// The name of a variable, taken apart once.
#[derive(Debug)]
pub(crate) struct VarName {
    /// As it was written, without the index.
    pub(crate) text: Text,
    /// Last part of a qualified name.
    pub(crate) tail: Text,
    /// Hash of the tail.
    pub(crate) hash: u32,
    pub(crate) scope: Scope,
    /// The index where the name was written as `name(index)`.
    pub(crate) element: Option<Text>,
}

/// Where a name points.
#[derive(Debug)]
pub(crate) enum Scope {
    /// A plain name: where the command stands.
    Here,
    /// `::name`
    Global,
    /// `path::name`
    Qualified(Box<str>),
}

/// The qualifiers before the last `::` and the name after it.
pub(crate) fn split_qualified(name: &str) -> Option<(&str, &str)> {
    let at = name.rfind("::")?;
    Some((name[..at].trim_end_matches(':'), &name[at + 2..]))
}

impl VarName {
    /// A name without an index.
    pub(crate) fn simple(name: &str) -> Rc<VarName> {
        Self::new(name, None)
    }

    fn new(name: &str, element: Option<&str>) -> Rc<VarName> {
        let text = Text::from(name);
        let (scope, tail) = match split_qualified(name) {
            None => (Scope::Here, text.clone()),
            Some(("", tail)) if name.starts_with("::") => (Scope::Global, Text::from(tail)),
            Some((path, tail)) => (Scope::Qualified(path.into()), Text::from(tail)),
        };
        let hash = table::hash(&tail);
        Rc::new(VarName { text, tail, hash, scope, element: element.map(Text::from) })
    }

    /// A name that may have an index.
    pub(crate) fn parse(name: &str) -> Rc<VarName> {
        match name.strip_suffix(')').and_then(|n| n.split_once('(')) {
            Some((base, element)) => Self::new(base, Some(element)),
            None => Self::new(name, None),
        }
    }

    /// The name that a value is.
    pub(crate) fn of(value: &Value) -> Rc<VarName> {
        let Rep::Str(s) = &value.0 else { return Self::parse(&value.as_str()) };
        if let Some(name) = s.cached(|c| if let Cache::Var(v) = c { Some(v.clone()) } else { None }) {
            return name;
        }
        let name = Self::parse(&value.as_str());
        s.set_cache(Cache::Var(name.clone()));
        name
    }

    fn full(&self, index: Option<&str>) -> String {
        match index {
            Some(i) => format!("{}({i})", &*self.text),
            None => self.text.to_string(),
        }
    }
}

/// What stands under a name.
#[derive(Debug, Default)]
pub(crate) enum Slot {
    #[default]
    Empty,
    Scalar(Value),
    Array(Box<Table<Slot>>),
    /// A variable that has other names elsewhere.
    Shared(Rc<RefCell<Slot>>),
    /// One of the other names.
    Link(Rc<RefCell<Slot>>),
}

impl Slot {
    /// Look at the variable itself.
    pub(crate) fn with<R>(&self, f: impl FnOnce(&Slot) -> R) -> R {
        match self {
            Slot::Shared(s) | Slot::Link(s) => f(&s.borrow()),
            slot => f(slot),
        }
    }

    /// Change the variable itself.
    pub(crate) fn with_mut<R>(&mut self, f: impl FnOnce(&mut Slot) -> R) -> R {
        match self {
            Slot::Shared(s) | Slot::Link(s) => f(&mut s.borrow_mut()),
            slot => f(slot),
        }
    }

    pub(crate) fn exists(&self) -> bool {
        self.with(|s| !matches!(s, Slot::Empty))
    }

    /// The variable, to give it another name.
    pub(crate) fn share(&mut self) -> Rc<RefCell<Slot>> {
        match self {
            Slot::Shared(s) | Slot::Link(s) => s.clone(),
            slot => {
                let shared = Rc::new(RefCell::new(std::mem::take(slot)));
                *slot = Slot::Shared(shared.clone());
                shared
            }
        }
    }

    fn scalar(&self) -> Option<Value> {
        self.with(|s| if let Slot::Scalar(v) = s { Some(v.clone()) } else { None })
    }
}

/// Why a variable cannot be used as asked.
#[derive(Clone, Copy)]
pub(crate) enum Trouble {
    NoVariable,
    /// The name is there, but nothing is set.
    Undefined,
    NoElement,
    IsArray,
    NotArray,
    NoNamespace,
    DanglingLink,
}

impl Trouble {
    fn text(self) -> &'static str {
        match self {
            Trouble::NoVariable | Trouble::Undefined => "no such variable",
            Trouble::NoElement => "no such element in array",
            Trouble::IsArray => "variable is array",
            Trouble::NotArray => "variable isn't array",
            Trouble::NoNamespace => "parent namespace doesn't exist",
            Trouble::DanglingLink => "upvar refers to variable in deleted namespace",
        }
    }
}

impl Core {
    /// The error for a variable, in Tcl's words: `can't read "x": no such variable`.
    pub(crate) fn var_error(&self, doing: &str, name: &VarName, index: Option<&str>, why: Trouble) -> Exception {
        let full = name.full(index);
        let message = format!("can't {doing} \"{full}\": {}", why.text());
        let code: &[&str] = match (why, doing) {
            (Trouble::NoVariable | Trouble::DanglingLink, _) => &["TCL", "LOOKUP", "VARNAME", &full],
            (Trouble::Undefined, "unset") => &["TCL", "UNSET", "VARNAME"],
            (Trouble::Undefined, _) => &["TCL", "READ", "VARNAME"],
            (Trouble::NoElement, "read") => &["TCL", "READ", "VARNAME"],
            (Trouble::NoElement, _) => &["TCL", "LOOKUP", "ELEMENT", index.unwrap_or_default()],
            (Trouble::IsArray, "read") => &["TCL", "READ", "VARNAME"],
            (Trouble::IsArray, _) => &["TCL", "WRITE", "VARNAME"],
            (Trouble::NotArray, "array set") => &["TCL", "WRITE", "ARRAY"],
            (Trouble::NotArray | Trouble::NoNamespace, _) => &["TCL", "LOOKUP", "VARNAME", &name.text],
        };
        let e = Exception::coded(message, code);
        if self.catching > 0 {
            return e;
        }
        match (why, index) {
            (Trouble::NoVariable | Trouble::Undefined, _) => e.suggest(self.nearest_variable(name)),
            (Trouble::NoElement, Some(index)) => {
                let near = self.slot(name).and_then(|slot| {
                    slot.with(|s| match s {
                        Slot::Array(a) => diagnostic::nearest(index, a.iter().map(|(k, _)| &**k)).map(str::to_owned),
                        _ => None,
                    })
                });
                e.suggest(near.map(|k| name.full(Some(&k))))
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
                return frame.vars.get_hashed(&name.tail, name.hash);
            }
            if frame.ns != NsId::GLOBAL
                && let Some(slot) = self.ns(frame.ns).vars.get_hashed(&name.tail, name.hash)
            {
                return Some(slot);
            }
            return self.ns(NsId::GLOBAL).vars.get_hashed(&name.tail, name.hash);
        }
        self.ns(self.scope_of(name)?).vars.get_hashed(&name.tail, name.hash)
    }

    fn slot_mut(&mut self, name: &VarName) -> Option<&mut Slot> {
        let active = self.active;
        if let Scope::Here = name.scope {
            if self.frames[active].is_proc {
                return self.frames[active].vars.get_hashed_mut(&name.tail, name.hash);
            }
            let ns = self.frames[active].ns;
            let here = ns != NsId::GLOBAL && self.ns(ns).vars.get_hashed(&name.tail, name.hash).is_some();
            let ns = if here { ns } else { NsId::GLOBAL };
            return self.ns_mut(ns).vars.get_hashed_mut(&name.tail, name.hash);
        }
        let ns = self.scope_of(name)?;
        self.ns_mut(ns).vars.get_hashed_mut(&name.tail, name.hash)
    }

    /// The slot of a variable, made if there is none; `None` where its namespace does not exist.
    pub(crate) fn slot_or_new(&mut self, name: &VarName) -> Option<&mut Slot> {
        let active = self.active;
        if let Scope::Here = name.scope
            && self.frames[active].is_proc
        {
            return Some(self.frames[active].vars.entry_or(&name.tail, name.hash, Slot::default));
        }
        let mut ns = self.scope_of(name)?;
        if let Scope::Here = name.scope
            && ns != NsId::GLOBAL
            && self.ns(ns).vars.get_hashed(&name.tail, name.hash).is_none()
            && self.ns(NsId::GLOBAL).vars.get_hashed(&name.tail, name.hash).is_some_and(Slot::exists)
        {
            ns = NsId::GLOBAL;
        }
        Some(self.ns_mut(ns).vars.entry_or(&name.tail, name.hash, Slot::default))
    }

    /// The value of a variable.
    pub(crate) fn read(&self, name: &VarName, index: Option<&str>) -> Result<Value, Exception> {
        self.peek(name, index).map_err(|why| self.var_error("read", name, index, why))
    }

    /// The value of a variable, or why there is none.
    pub(crate) fn peek(&self, name: &VarName, index: Option<&str>) -> Result<Value, Trouble> {
        let Some(slot) = self.slot(name) else { return Err(Trouble::NoVariable) };
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
        let done = match self.slot_or_new(name) {
            None => Err(Trouble::NoNamespace),
            Some(slot) => slot.with_mut(|slot| put(slot, index, value)),
        };
        if &*name.tail == "tcl_precision" {
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

    /// Remove a variable, or tell why it cannot be removed.
    pub(crate) fn unset(&mut self, name: &VarName, index: Option<&str>) -> Result<(), Exception> {
        let done = match self.slot_mut(name) {
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
            Scope::Here if self.ns(frame.ns).vars.get_hashed(&name.tail, name.hash).is_none() => Some(NsId::GLOBAL),
            _ => self.scope_of(name),
        };
        match ns {
            None => {
                let active = self.active;
                self.frames[active].vars.remove(&name.tail);
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
    pub fn get_var(&self, name: &str) -> Result<Value, Exception> {
        let name = VarName::parse(name);
        self.read(&name, name.element.as_deref())
    }

    /// Set a variable by name.
    pub fn set_var(&mut self, name: &str, value: impl Into<Value>) -> Result<(), Exception> {
        let name = VarName::parse(name);
        self.write(&name, name.element.as_ref(), value.into())
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

fn put(slot: &mut Slot, index: Option<&Text>, value: Value) -> Result<(), Trouble> {
    match (&mut *slot, index) {
        (Slot::Scalar(old), None) => {
            *old = value;
            Ok(())
        }
        (Slot::Empty, None) => {
            *slot = Slot::Scalar(value);
            Ok(())
        }
        (Slot::Array(a), Some(i)) => {
            a.entry_or(i, table::hash(i), Slot::default).with_mut(|s| *s = Slot::Scalar(value));
            Ok(())
        }
        (Slot::Empty, Some(i)) => {
            let mut array = Box::<Table<Slot>>::default();
            array.insert(i.clone(), Slot::Scalar(value));
            *slot = Slot::Array(array);
            Ok(())
        }
        (Slot::Array(_), None) => Err(Trouble::IsArray),
        (Slot::Scalar(_), Some(_)) => Err(Trouble::NotArray),
        (Slot::Shared(_) | Slot::Link(_), _) => Err(Trouble::DanglingLink),
    }
}

fn take(slot: &mut Slot, index: Option<&Text>) -> Result<Value, Trouble> {
    match (slot, index) {
        (Slot::Scalar(v), None) => Ok(std::mem::take(v)),
        (Slot::Array(a), Some(i)) => match a.get_mut(i) {
            None => Err(Trouble::NoElement),
            Some(element) => element.with_mut(|e| match e {
                Slot::Scalar(v) => Ok(std::mem::take(v)),
                _ => Err(Trouble::NoElement),
            }),
        },
        (Slot::Array(_), None) => Err(Trouble::IsArray),
        (Slot::Scalar(_), Some(_)) => Err(Trouble::NotArray),
        _ => Err(Trouble::Undefined),
    }
}
