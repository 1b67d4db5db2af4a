//! Dictionaries: ordered by insertion, keys by their text.

use std::cell::OnceCell;
use std::ops::Deref;
use std::rc::Rc;

use super::error::Exception;
use super::list::{self, List};
use super::stack;
use super::table::Table;
use super::value::{LazyText, Value};

/// The entries and, once it was asked for, the text.
#[derive(Default)]
pub(crate) struct DictObj {
    table: Table<Value>,
    text: LazyText,
}

impl DictObj {
    pub(crate) fn text(&self) -> &str {
        self.text.get_or_init(|| {
            let write = || {
                let mut out = String::new();
                for (key, value) in self.table.iter() {
                    if !out.is_empty() {
                        out.push(' ');
                    }
                    let first = out.is_empty();
                    list::write_element(&mut out, key, first);
                    out.push(' ');
                    list::write_value(&mut out, value, false);
                }
                out
            };
            stack::grow(write).into_boxed_str()
        })
    }

    pub(crate) fn to_list(&self) -> List {
        List::from(self.table.iter().flat_map(|(k, v)| [k.to_value(), v.clone()]).collect::<Vec<_>>())
    }

    /// The entries, to change them; copied first where the dictionary is shared.
    pub(crate) fn make_mut(this: &mut Rc<Self>) -> &mut Table<Value> {
        if Rc::get_mut(this).is_none() {
            *this = Rc::new(DictObj { table: this.table.clone(), text: OnceCell::new() });
        }
        match Rc::get_mut(this) {
            Some(obj) => {
                obj.text = OnceCell::new();
                &mut obj.table
            }
            None => unreachable!("just made a dictionary of its own"),
        }
    }
}

impl Deref for DictObj {
    type Target = Table<Value>;
    fn deref(&self) -> &Table<Value> {
        &self.table
    }
}

impl Drop for DictObj {
    fn drop(&mut self) {
        list::dismantle(self.take_values());
    }
}

impl DictObj {
    /// The values that hold others, taken out of a dictionary that is about to go.
    pub(crate) fn take_values(&mut self) -> Vec<Value> {
        self.table.values_mut().filter(|v| v.is_nested()).map(std::mem::take).collect()
    }
}

/// A shared dictionary, to look at.
#[derive(Clone, Default)]
pub(crate) struct Dict(pub(crate) Rc<DictObj>);

impl Dict {
    pub(crate) fn from_table(table: Table<Value>) -> Dict {
        Dict(Rc::new(DictObj { table, text: OnceCell::new() }))
    }

    pub(crate) fn from_list(items: &[Value]) -> Result<Dict, Exception> {
        if !items.len().is_multiple_of(2) {
            return Err(Exception::coded("missing value to go with key", &["TCL", "VALUE", "DICTIONARY"]));
        }
        let mut table = Table::default();
        for pair in items.chunks_exact(2) {
            if let [key, value] = pair {
                table.insert(key.to_text(), value.clone());
            }
        }
        Ok(Dict::from_table(table))
    }

    /// From the text of a value. Errors of the list use Tcl's words for dictionaries.
    pub(crate) fn from_text(value: &Value) -> Result<Dict, Exception> {
        let items = value.to_list().map_err(|e| {
            let Exception::Error(e) = e else { return e };
            let message = e.diagnostic.message.replace("list element", "dict element").replace(" in list", " in dict");
            let kind = e.error_code.and_then(|c| c.to_list().ok()?.last().cloned()).unwrap_or_default();
            Exception::coded(message, &["TCL", "VALUE", "DICTIONARY", &kind.as_str()])
        })?;
        Dict::from_list(&items)
    }
}

impl Deref for Dict {
    type Target = Table<Value>;
    fn deref(&self) -> &Table<Value> {
        &self.0.table
    }
}

impl From<Dict> for Value {
    fn from(dict: Dict) -> Value {
        if dict.is_empty() { Value::EMPTY } else { Value(super::value::Rep::Dict(dict.0)) }
    }
}
