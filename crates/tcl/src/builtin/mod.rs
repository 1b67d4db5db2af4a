//! The commands and variables that Tcl itself brings, one family a file.

mod array;
mod binary;
mod channel;
mod channel_options;
mod clock;
mod clock_scan;
mod control;
mod dict;
mod dict_script;
mod exec;
mod file;
mod format;
mod glob;
mod info;
mod interp;
mod list;
mod loops;
mod lsearch;
mod lset;
mod lsort;
mod namespace;
mod ops;
mod package;
mod proc;
mod regexp;
mod scan;
mod string;
mod string_is;
mod subst;
mod switch;
mod time;
mod try_catch;
mod var;

use super::command::{CommandFn, CoreFn, Imp};
use super::core::Core;
use super::expr::func;
use super::inline::InlinedCommands;
use super::interp::Interp;
use super::value::Value;

/// The version whose behaviour this is.
pub(crate) const VERSION: &str = "8.6";
/// The release of it.
pub(crate) const PATCH_LEVEL: &str = "8.6.13";

/// Make the commands and variables known.
pub(crate) fn install<H>(interp: &mut Interp<H>) {
    let core: [&[(&str, CoreFn)]; 16] = [
        array::COMMANDS,
        binary::COMMANDS,
        channel::COMMANDS,
        clock::COMMANDS,
        exec::COMMANDS,
        file::COMMANDS,
        format::COMMANDS,
        glob::COMMANDS,
        interp::COMMANDS,
        list::COMMANDS,
        lset::COMMANDS,
        scan::COMMANDS,
        string::COMMANDS,
        var::COMMANDS,
        regexp::COMMANDS,
        ops::COMMANDS,
    ];
    for (name, function) in core.into_iter().flatten() {
        interp.register_core(name, *function);
    }
    let full: [&[(&str, CommandFn<H>)]; 13] = [
        &control::commands(),
        &dict_script::commands(),
        &info::commands(),
        &loops::commands(),
        &lsort::commands(),
        &lsearch::commands(),
        &namespace::commands(),
        &package::commands(),
        &proc::commands(),
        &subst::commands(),
        &switch::commands(),
        &time::commands(),
        &try_catch::commands(),
    ];
    for (name, function) in full.into_iter().flatten() {
        interp.register(name, *function);
    }
    let (ns, _) = interp.core.place_for("::tcl::mathfunc::x");
    for name in func::names() {
        interp.core.define(ns, &name.into(), Imp::Core(func::command));
    }
    interp.core.table.inlined = InlinedCommands::new(|name| interp.core.find_command(name));
}

/// The variables that Tcl begins with.
pub(crate) fn variables(core: &mut Core) {
    let machine = match std::env::consts::ARCH {
        "x86_64" if cfg!(windows) => "amd64",
        other => other,
    };
    let (platform, os) = match std::env::consts::OS {
        "windows" => ("windows", "Windows NT"),
        "macos" => ("unix", "Darwin"),
        "linux" => ("unix", "Linux"),
        other => ("unix", other),
    };
    let user = std::env::var("USER").or_else(|_| std::env::var("USERNAME")).unwrap_or_default();
    let texts = [
        ("tcl_version", VERSION),
        ("tcl_patchLevel", PATCH_LEVEL),
        ("tcl_library", ""),
        ("auto_path", ""),
        ("tcl_platform(platform)", platform),
        ("tcl_platform(os)", os),
        ("tcl_platform(osVersion)", ""),
        ("tcl_platform(machine)", machine),
        ("tcl_platform(user)", &user),
        ("tcl_platform(byteOrder)", if cfg!(target_endian = "big") { "bigEndian" } else { "littleEndian" }),
        ("tcl_platform(pathSeparator)", if cfg!(windows) { ";" } else { ":" }),
        ("tcl_platform(engine)", "Tcl"),
        ("argv0", ""),
        ("argv", ""),
    ];
    let numbers: [(&str, i64); 5] = [
        ("tcl_precision", 0),
        ("tcl_interactive", 0),
        ("tcl_platform(wordSize)", 8),
        ("tcl_platform(pointerSize)", 8),
        ("argc", 0),
    ];
    let env = std::env::vars().map(|(k, v)| (format!("env({k})"), Value::from(v)));
    let all = texts.into_iter().map(|(k, v)| (k.to_owned(), Value::from(v)));
    let all = all.chain(numbers.into_iter().map(|(k, v)| (k.to_owned(), Value::from(v))));
    for (name, value) in all.chain(env) {
        // A fresh interpreter has no array of these names that could be in the way.
        let _ = core.set_global(&name, value);
    }
}
