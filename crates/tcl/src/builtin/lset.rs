//! `lset`.

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::error::Exception;
use crate::index::index;
use crate::value::Value;
use crate::vars::VarName;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[("lset", lset)];

fn lset(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3.., "lset listVar ?index? ?index ...? value")?;
    let name = VarName::of(call.arg(1));
    let last = call.len() - 1;
    let value = call.arg(last).clone();
    let words = &call.from(2)[..last - 2];
    core.value_of(&name)?;
    core.update(&name, false, "read", |list, _| match words {
        [one] if index(one, 0).is_err() => {
            let path = one.to_list()?;
            if path.len() == 1 { set(list, std::slice::from_ref(one), value) } else { set(list, &path, value) }
        }
        path => set(list, path, value),
    })?;
    core.value_of(&name)
}

/// Set the element at the end of a path; one place past the end of a list appends to it.
fn set(list: &mut Value, path: &[Value], value: Value) -> Result<(), Exception> {
    check(list, path)?;
    let mut at = list;
    for place in path {
        let items = at.list_mut()?;
        let i = index(place, items.len() as i64 - 1)?;
        let i = usize::try_from(i).unwrap_or_default();
        if i >= items.len() {
            items.push(Value::EMPTY);
        }
        let last = items.len() - 1;
        at = &mut items[i.min(last)];
    }
    *at = value;
    Ok(())
}

/// Check the whole path before anything is changed.
fn check(list: &Value, path: &[Value]) -> Result<(), Exception> {
    let mut value = list.clone();
    for place in path {
        let items = value.to_list()?;
        let i = index(place, items.len() as i64 - 1)?;
        if i < 0 || i > items.len() as i64 {
            return Err(Exception::coded("list index out of range", &["TCL", "OPERATION", "LSET", "BADINDEX"]));
        }
        value = items.get(i as usize).cloned().unwrap_or_default();
    }
    Ok(())
}
