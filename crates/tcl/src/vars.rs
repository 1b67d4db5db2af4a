//! Variables: their names, and what stands under them.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use super::table::{self, Table};
use super::text::{Cache, Text};
use super::value::{Rep, Value};

/// The name of a variable, taken apart once.
#[derive(Debug)]
pub(crate) struct VarName {
    /// As it was written, without the index.
    pub(crate) text: Text,
    /// Last part of a qualified name.
    pub(crate) tail: Text,
    /// Hash of the tail.
    pub(crate) hash: u32,
    /// Place of the name in the table in which it was found last.
    pub(crate) near: Cell<u32>,
    pub(crate) scope: Scope,
    /// True for a name without an index whose setting has no consequences.
    pub(crate) is_plain: bool,
    /// True for `tcl_precision`: setting it has consequences.
    pub(crate) is_precision: bool,
    /// The index where the name was written as `name(index)`.
    pub(crate) element: Option<Text>,
}

/// Target of a variable's name.
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
    // Few names have colons: looking for two in a row takes much longer than for one.
    if !name.as_bytes().contains(&b':') {
        return None;
    }
    let at = name.rfind("::")?;
    Some((name[..at].trim_end_matches(':'), &name[at + 2..]))
}

impl VarName {
    /// A name without an index.
    pub(crate) fn simple(name: &str) -> Rc<VarName> {
        Self::new(name, None, Text::name)
    }

    fn new(name: &str, element: Option<&str>, shared: fn(&str) -> Text) -> Rc<VarName> {
        let text = shared(name);
        let (scope, tail) = match split_qualified(name) {
            None => (Scope::Here, text.clone()),
            Some(("", tail)) if name.starts_with("::") => (Scope::Global, shared(tail)),
            Some((path, tail)) => (Scope::Qualified(path.into()), shared(tail)),
        };
        let hash = table::hash(&tail);
        let is_precision = &*tail == "tcl_precision";
        let is_plain = element.is_none() && !is_precision;
        let element = element.map(Text::from);
        Rc::new(VarName { text, tail, hash, near: Cell::new(0), scope, is_plain, is_precision, element })
    }

    /// A name that may have an index.
    pub(crate) fn parse(name: &str) -> Rc<VarName> {
        Self::parsed(name, Text::name)
    }

    /// The same for a host, which shares no text with the other interpreters of the thread: an interpreter that runs no script
    /// may go to another thread.
    pub(crate) fn of_host(name: &str) -> Rc<VarName> {
        Self::parsed(name, |name: &str| Text::from(name))
    }

    fn parsed(name: &str, shared: fn(&str) -> Text) -> Rc<VarName> {
        match name.strip_suffix(')').and_then(|n| n.split_once('(')) {
            Some((base, element)) => Self::new(base, Some(element), shared),
            None => Self::new(name, None, shared),
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

    pub(super) fn full(&self, index: Option<&str>) -> String {
        match index {
            Some(i) => format!("{}({i})", &*self.text),
            None => self.text.to_string(),
        }
    }
}

/// Content of a name: a scalar, an array or a link.
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
    /// A scalar whose first use is noted.
    Watched(Box<WatchedSlot>),
}

/// A scalar that must be read before it is set again.
#[derive(Debug)]
pub(crate) struct WatchedSlot {
    pub(crate) slot: Slot,
    pub(crate) watch: Watch,
}

/// First use of a watched variable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum FirstUse {
    #[default]
    None,
    Read,
    Set,
}

/// The first use of a variable after it was watched. Clones share it.
#[derive(Clone, Debug, Default)]
pub struct Watch(Rc<Cell<FirstUse>>);

impl Watch {
    /// Returns true if the variable was read, or asked for by `info exists`.
    pub fn was_read(&self) -> bool {
        self.0.get() == FirstUse::Read
    }

    /// Returns true if the script tried to set the variable before it read it, which is an error.
    pub fn was_overwritten(&self) -> bool {
        self.0.get() == FirstUse::Set
    }

    /// Allow the variable to be set.
    pub fn release(&self) {
        self.0.set(FirstUse::Read);
    }

    fn note(&self, first: FirstUse) {
        if self.0.get() == FirstUse::None {
            self.0.set(first);
        }
    }
}

impl Clone for Slot {
    /// A variable of its own with the same value.
    fn clone(&self) -> Self {
        match self {
            Self::Empty => Self::Empty,
            Self::Scalar(value) => Self::Scalar(value.clone()),
            Self::Array(elements) => Self::Array(elements.clone()),
            Self::Shared(variable) | Self::Link(variable) => variable.borrow().clone(),
            Self::Watched(watched) => watched.slot.clone(),
        }
    }
}

impl Slot {
    /// Look at the variable itself.
    pub(crate) fn with<R>(&self, f: impl FnOnce(&Slot) -> R) -> R {
        match self {
            Slot::Shared(s) | Slot::Link(s) => f(s.borrow().read()),
            slot => f(slot.read()),
        }
    }

    /// The content of a watched variable, whose reading is noted; any other as it is.
    #[inline]
    fn read(&self) -> &Slot {
        match self {
            Slot::Watched(watched) => {
                watched.watch.note(FirstUse::Read);
                &watched.slot
            }
            slot => slot,
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

    pub(super) fn scalar(&self) -> Option<Value> {
        self.with(|s| if let Slot::Scalar(v) = s { Some(v.clone()) } else { None })
    }

    /// The value of a scalar. A watch does not take notice.
    pub(super) fn unwatched_scalar(&self) -> Option<Value> {
        match self {
            Slot::Scalar(v) => Some(v.clone()),
            Slot::Shared(s) | Slot::Link(s) => s.borrow().unwatched_scalar(),
            Slot::Watched(watched) => watched.slot.unwatched_scalar(),
            _ => None,
        }
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
    /// A watched variable that has not been read.
    Unread,
}

impl Trouble {
    pub(super) fn text(self) -> &'static str {
        match self {
            Trouble::NoVariable | Trouble::Undefined => "no such variable",
            Trouble::NoElement => "no such element in array",
            Trouble::IsArray => "variable is array",
            Trouble::NotArray => "variable isn't array",
            Trouble::NoNamespace => "parent namespace doesn't exist",
            Trouble::DanglingLink => "upvar refers to variable in deleted namespace",
            Trouble::Unread => "it was given a value that has not been read",
        }
    }
}

pub(super) fn put(slot: &mut Slot, index: Option<&Text>, value: Value) -> Result<(), Trouble> {
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
        (Slot::Watched(watched), _) => {
            watched.watch.note(FirstUse::Set);
            if watched.watch.was_overwritten() {
                return Err(Trouble::Unread);
            }
            // After its first use it is a variable like others.
            *slot = std::mem::take(&mut watched.slot);
            put(slot, index, value)
        }
        (Slot::Shared(_) | Slot::Link(_), _) => Err(Trouble::DanglingLink),
    }
}

pub(super) fn take(slot: &mut Slot, index: Option<&Text>) -> Result<Value, Trouble> {
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
        (Slot::Watched(watched), _) => {
            watched.watch.note(FirstUse::Read);
            take(&mut watched.slot, index)
        }
        _ => Err(Trouble::Undefined),
    }
}
