//! Texts: shared, with what they were last understood as.

use std::borrow::Borrow;
use std::cell::{Cell, RefCell};
use std::collections::HashSet;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::ops::Deref;
use std::rc::Rc;

use super::dict::DictObj;
use super::list::{self, List};
use super::number::{self, Number};
use super::origin::Origin;
use super::stretch::{Chars, Stretch};
use super::value::{Rep, Value};
use super::vars::VarName;

/// A text together with what it was last understood as.
pub(crate) struct StrObj {
    pub(super) text: Chars,
    /// Place of the text in a script.
    pub(super) origin: Option<Origin>,
    pub(super) cache: RefCell<Cache>,
    /// Number of characters; `u32::MAX` while it is not known.
    pub(super) chars: Cell<u32>,
}

/// Parsed form of a text in its last use.
#[derive(Clone, Default)]
pub(crate) enum Cache {
    #[default]
    None,
    NotNumber,
    Number(Number),
    List(List),
    Dict(Rc<DictObj>),
    Script(Rc<super::ast::Script>),
    Expr(Rc<super::expr::Expr>),
    Var(Rc<VarName>),
    Regex(Rc<super::regex::Regex>),
}

impl StrObj {
    pub(super) fn new(text: String, origin: Option<Origin>) -> Rc<Self> {
        Self::of(Chars::Own(text), origin)
    }

    fn of(text: Chars, origin: Option<Origin>) -> Rc<Self> {
        Rc::new(Self { text, origin, cache: RefCell::default(), chars: Cell::new(u32::MAX) })
    }

    /// A text that is a part of a longer one.
    pub(super) fn shared(text: Stretch, origin: Option<Origin>) -> Rc<Self> {
        Self::of(Chars::Shared(text), origin)
    }

    /// The shared text, if it is a part of one.
    pub(super) fn stretch_if_shared(&self) -> Option<&Stretch> {
        if let Chars::Shared(stretch) = &self.text { Some(stretch) } else { None }
    }

    /// The text for a parser, whose words may share it.
    pub(crate) fn stretch(&self) -> Stretch {
        match &self.text {
            Chars::Own(text) => text.as_str().into(),
            Chars::Shared(stretch) => stretch.clone(),
        }
    }

    pub(crate) fn origin(&self) -> Option<&Origin> {
        self.origin.as_ref()
    }

    pub(crate) fn cached<T>(&self, pick: impl FnOnce(&Cache) -> Option<T>) -> Option<T> {
        pick(&self.cache.borrow())
    }

    pub(crate) fn set_cache(&self, cache: Cache) {
        *self.cache.borrow_mut() = cache;
    }

    pub(super) fn number(&self) -> Option<Number> {
        match &*self.cache.borrow() {
            Cache::Number(n) => return Some(n.clone()),
            Cache::NotNumber => return None,
            // Costly to work out again, and hardly ever a number.
            Cache::Script(_) | Cache::Expr(_) | Cache::Regex(_) => return number::parse(&self.text),
            _ => {}
        }
        let number = number::parse(&self.text);
        self.set_cache(number.clone().map_or(Cache::NotNumber, Cache::Number));
        number
    }
}

impl Drop for StrObj {
    fn drop(&mut self) {
        if let Cache::List(List(l)) = self.cache.take()
            && let Ok(mut l) = Rc::try_unwrap(l)
        {
            list::dismantle(l.take_items());
        }
    }
}

/// A shared text, the key of tables.
#[derive(Clone)]
pub(crate) struct Text(pub(super) Rc<StrObj>);

thread_local! {
    /// Names of variables in scripts. Those that are the same object are equal without a look at their bytes.
    static NAMES: RefCell<HashSet<Text>> = RefCell::default();
}

/// Number of names that a thread keeps.
const MAX_NAMES: usize = 10_000;

impl Text {
    /// A name, the same object each time.
    pub(crate) fn name(text: &str) -> Text {
        NAMES.with_borrow_mut(|names| {
            if let Some(name) = names.get(text) {
                return name.clone();
            }
            let name = Text::from(text);
            if names.len() < MAX_NAMES {
                names.insert(name.clone());
            }
            name
        })
    }

    /// Returns true if both are the same object.
    #[inline]
    pub(crate) fn is(&self, other: &Text) -> bool {
        Rc::ptr_eq(&self.0, &other.0)
    }

    pub(crate) fn to_value(&self) -> Value {
        Value(Rep::Str(self.0.clone()))
    }
}

impl Deref for Text {
    type Target = str;
    fn deref(&self) -> &str {
        &self.0.text
    }
}

impl Borrow<str> for Text {
    fn borrow(&self) -> &str {
        self
    }
}

impl PartialEq for Text {
    fn eq(&self, other: &Text) -> bool {
        **self == **other
    }
}

impl Eq for Text {}

impl Hash for Text {
    fn hash<S: Hasher>(&self, state: &mut S) {
        (**self).hash(state);
    }
}

impl From<&str> for Text {
    fn from(text: &str) -> Self {
        Text(StrObj::new(text.to_owned(), None))
    }
}

impl fmt::Debug for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&**self, f)
    }
}
