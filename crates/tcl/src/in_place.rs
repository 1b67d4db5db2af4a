//! Reading and changing scalars where they are, the ways that loops of scripts take.

use super::core::{Core, NsId};
use super::expr::Num;
use super::value::{Rep, Value};
use super::vars::{Scope, Slot, VarName};

impl Core {
    /// The slot of a plain name of a procedure or of the global namespace, if it is where it was last.
    #[inline(always)]
    fn near_slot(&self, name: &VarName) -> Option<&Slot> {
        let Scope::Here = name.scope else { return None };
        let frame = self.frame();
        if frame.is_proc {
            return frame.vars.at(name.near.get(), &name.tail);
        }
        if frame.ns != NsId::GLOBAL {
            return None;
        }
        self.ns(NsId::GLOBAL).vars.at(name.near.get(), &name.tail)
    }

    /// As [`Core::near_slot`], to change it.
    #[inline(always)]
    fn near_slot_mut(&mut self, name: &VarName) -> Option<&mut Slot> {
        let Scope::Here = name.scope else { return None };
        let active = self.calls.active;
        if self.calls.frames[active].is_proc {
            return self.calls.frames[active].vars.at_mut(name.near.get(), &name.tail);
        }
        if self.calls.frames[active].ns != NsId::GLOBAL {
            return None;
        }
        self.ns_mut(NsId::GLOBAL).vars.at_mut(name.near.get(), &name.tail)
    }

    /// The value of a variable that is a plain scalar; `None` does not mean that there is no variable.
    #[inline]
    pub(crate) fn scalar(&self, name: &VarName) -> Option<&Value> {
        match self.near_slot(name) {
            Some(Slot::Scalar(value)) => Some(value),
            _ => match self.slot(name) {
                Some(Slot::Scalar(value)) => Some(value),
                _ => None,
            },
        }
    }

    /// Look at a scalar, by another name of it too.
    #[inline]
    pub(crate) fn with_scalar<R>(&self, name: &VarName, look: impl FnOnce(&Value) -> Option<R>) -> Option<R> {
        if let Some(Slot::Scalar(value)) = self.near_slot(name) {
            return look(value);
        }
        self.slot(name)?.with(|slot| if let Slot::Scalar(value) = slot { look(value) } else { None })
    }

    /// Change a scalar, by another name of it too. `None`, with nothing done, where that takes more.
    #[inline]
    fn change_scalar<R>(&mut self, name: &VarName, change: impl FnOnce(&mut Value) -> Option<R>) -> Option<R> {
        if !name.is_plain {
            return None;
        }
        if let Some(Slot::Scalar(value)) = self.near_slot_mut(name) {
            return change(value);
        }
        self.slot_mut(name)?.with_mut(|slot| if let Slot::Scalar(value) = slot { change(value) } else { None })
    }

    /// Give a scalar another value. The value, with nothing done, where that takes more.
    #[inline]
    pub(crate) fn set_scalar(&mut self, name: &VarName, value: Value) -> Option<Value> {
        let mut value = Some(value);
        self.change_scalar(name, |old| {
            if let Some(value) = value.take() {
                *old = value;
            }
            Some(())
        });
        value
    }

    /// Give a scalar another value, a number; false, with nothing done, where that takes more.
    #[inline]
    pub(crate) fn set_number(&mut self, name: &VarName, n: Num) -> bool {
        let set = |old: &mut Value| {
            *old = n.into();
            Some(())
        };
        self.change_scalar(name, set).is_some()
    }

    /// Add to an integer; `None`, with nothing done, where that takes more.
    #[inline]
    pub(crate) fn increment(&mut self, name: &VarName, by: i64) -> Option<Value> {
        self.change_scalar(name, |value| {
            let Rep::Int(old) = value.0 else { return None };
            let sum = Value::from(old.checked_add(by)?);
            *value = sum.clone();
            Some(sum)
        })
    }

    /// Append to a text. The whole text; `None`, with nothing done, where that takes more.
    #[inline]
    pub(crate) fn append_text(&mut self, name: &VarName, text: &str) -> Option<Value> {
        self.change_scalar(name, |value| {
            if !matches!(value.0, Rep::Str(_)) {
                return None;
            }
            value.text_mut().push_str(text);
            Some(value.clone())
        })
    }

    /// Append an item to a list. The list; `None`, with nothing done, where that takes more.
    #[inline]
    pub(crate) fn push_item(&mut self, name: &VarName, item: &Value) -> Option<Value> {
        self.change_scalar(name, |value| {
            if !matches!(value.0, Rep::List(_) | Rep::Empty) {
                return None;
            }
            value.list_mut().ok()?.push(item.clone());
            Some(value.clone())
        })
    }
}
