//! `time`, `after`, `update`, `vwait`.

use std::time::{Duration, Instant};

use crate::command::{Call, CommandFn};
use crate::error::Exception;
use crate::eval::script_of;
use crate::interp::Interp;
use crate::value::Value;

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 4] {
    [("after", after), ("time", time), ("update", update), ("vwait", vwait)]
}

fn time<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "time command ?count?")?;
    let count = match call.get(2) {
        None => 1,
        Some(count) => count.to_i64()?,
    };
    let body = call.arg(1);
    let script = script_of(body);
    let start = Instant::now();
    for _ in 0..count {
        interp.core.tick()?;
        interp.body_again(&script, body, "\"time\" body")?;
    }
    let micros = start.elapsed().as_secs_f64() * 1e6;
    let each = if count > 0 { micros / count as f64 } else { 0.0 };
    // As in Tcl: whole microseconds for one round, a fraction for the mean of several.
    let each = if count <= 1 { Value::from(each.round() as i64) } else { Value::from(each) };
    Ok(Value::from(format!("{each} microseconds per iteration")))
}

fn after<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "after option ?arg ...?")?;
    let Ok(millis) = call.arg(1).to_i64() else {
        match call.choose(1, "argument", &["cancel", "idle", "info"], true) {
            Ok(_) => return Err(no_events(call)),
            Err(_) => {
                let word = call.arg(1);
                let message = format!("bad argument \"{word}\": must be cancel, idle, info, or an integer");
                let code = ["TCL", "LOOKUP", "INDEX", "argument", &word.as_str()];
                return Err(Exception::coded(message, &code).at(call.span(1), ""));
            }
        }
    };
    if call.len() > 2 {
        return Err(no_events(call));
    }
    interp.core.pause();
    let end = Instant::now() + Duration::from_millis(millis.clamp(0, 1 << 40) as u64);
    // In short pieces, so that the script can be interrupted.
    while let Some(left) = end.checked_duration_since(Instant::now()).filter(|d| !d.is_zero()) {
        std::thread::sleep(left.min(Duration::from_millis(50)));
        interp.core.tick()?;
    }
    Ok(Value::EMPTY)
}

fn no_events(call: &Call<'_>) -> Exception {
    let message = format!("{}: nothing can be run later here, there is no event loop", call.name());
    call.error_at(0, message, "not supported")
}

fn update<H>(_: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(1..=2, "update ?idletasks?")?;
    if call.len() == 2 {
        call.choose(1, "option", &["idletasks"], false)?;
    }
    Ok(Value::EMPTY)
}

fn vwait<H>(_: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    Err(no_events(call))
}
