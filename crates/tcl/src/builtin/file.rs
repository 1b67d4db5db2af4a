//! `file`, `cd`, `pwd`.

use std::io::{self, Write as _};
use std::time::Duration;

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::ensemble::dispatch;
use crate::error::Exception;
use crate::files::{FileInfo, FileKind, OpenMode, posix};
use crate::paths;
use crate::value::Value;
use crate::vars::VarName;

pub(crate) const COMMANDS: &[(&str, CoreFn)] =
    &[("cd", cd), ("file", |core, call| dispatch(core, call, SUBS)), ("pwd", pwd)];

const SUBS: &[(&str, CoreFn)] = &[
    ("atime", |core, call| time(core, call, "atime")),
    ("attributes", attributes),
    ("channels", |core, call| {
        call.expect(2..=3, "file channels ?pattern?")?;
        let pattern = call.get(2).map_or("*".into(), Value::as_str);
        let fits = |name: &&str| crate::glob::matches(&pattern, name);
        Ok(Value::list(core.channels.names().filter(fits).map(Value::from)))
    }),
    ("copy", |core, call| transfer(core, call, "copy")),
    ("delete", delete),
    ("dirname", |_, call| on_name(call, "dirname", paths::dirname)),
    ("executable", |core, call| permitted(core, call, "executable", 0o111)),
    ("exists", |core, call| test(core, call, "exists", |_| true)),
    ("extension", |_, call| on_name(call, "extension", |n| paths::extension(n).to_owned())),
    ("isdirectory", |core, call| test(core, call, "isdirectory", |i| i.kind == FileKind::Directory)),
    ("isfile", |core, call| test(core, call, "isfile", |i| i.kind == FileKind::File)),
    ("join", join),
    ("link", |_, call| unsupported(call)),
    ("lstat", |core, call| stat(core, call, "lstat", false)),
    ("mkdir", mkdir),
    ("mtime", |core, call| time(core, call, "mtime")),
    ("nativename", |_, call| {
        on_name(call, "nativename", |n| if cfg!(windows) { n.replace('/', "\\") } else { n.to_owned() })
    }),
    ("normalize", |core, call| {
        call.expect(3..=3, "file normalize name")?;
        Ok(Value::from(core.absolute(&call.arg(2).as_str())))
    }),
    ("owned", |core, call| test(core, call, "owned", |_| true)),
    ("pathtype", |_, call| {
        on_name(call, "pathtype", |n| if paths::is_absolute(n) { "absolute" } else { "relative" }.to_owned())
    }),
    ("readable", |core, call| permitted(core, call, "readable", 0o444)),
    ("readlink", |_, call| unsupported(call)),
    ("rename", |core, call| transfer(core, call, "rename")),
    ("rootname", |_, call| on_name(call, "rootname", |n| n[..n.len() - paths::extension(n).len()].to_owned())),
    ("separator", |_, _| Ok(Value::from(if cfg!(windows) { "\\" } else { "/" }))),
    ("size", size),
    ("split", |_, call| {
        call.expect(3..=3, "file split name")?;
        Ok(Value::list(paths::split(&call.arg(2).as_str()).into_iter().map(Value::from)))
    }),
    ("stat", |core, call| stat(core, call, "stat", true)),
    ("system", |_, call| on_name(call, "system", |_| "native".to_owned())),
    ("tail", |_, call| on_name(call, "tail", paths::tail)),
    ("tempfile", |_, call| unsupported(call)),
    ("type", file_type),
    ("volumes", |_, _| Ok(Value::from("/"))),
    ("writable", |core, call| permitted(core, call, "writable", 0o222)),
];

fn unsupported(call: &Call<'_>) -> Result<Value, Exception> {
    Err(call.error_at(1, format!("file {} is not supported", call.arg(1)), "not supported"))
}

fn on_name(call: &Call<'_>, sub: &str, f: impl Fn(&str) -> String) -> Result<Value, Exception> {
    call.expect(3..=3, &format!("file {sub} name"))?;
    Ok(Value::from(f(&call.arg(2).as_str())))
}

fn join(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3.., "file join name ?name ...?")?;
    let names: Vec<_> = call.from(2).iter().map(Value::as_str).collect();
    Ok(Value::from(paths::join(names.iter().map(|n| &**n))))
}

fn info(core: &Core, name: &Value, follow: bool) -> io::Result<FileInfo> {
    core.files.info(&core.absolute(&name.as_str()), follow)
}

fn test(core: &Core, call: &Call<'_>, sub: &str, fits: fn(&FileInfo) -> bool) -> Result<Value, Exception> {
    call.expect(3..=3, &format!("file {sub} name"))?;
    Ok(Value::from(info(core, call.arg(2), true).is_ok_and(|i| fits(&i))))
}

fn permitted(core: &Core, call: &Call<'_>, sub: &str, mask: u32) -> Result<Value, Exception> {
    call.expect(3..=3, &format!("file {sub} name"))?;
    Ok(Value::from(info(core, call.arg(2), true).is_ok_and(|i| i.mode & mask != 0)))
}

fn could_not_read<'a>(call: &'a Call<'a>) -> impl FnOnce(io::Error) -> Exception + 'a {
    move |e| posix(&e, |why| format!("could not read \"{}\": {why}", call.arg(2))).at(call.span(2), "")
}

fn size(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "file size name")?;
    let info = info(core, call.arg(2), true).map_err(could_not_read(call))?;
    Ok(Value::from(info.size as i64))
}

fn time(core: &mut Core, call: &Call<'_>, sub: &str) -> Result<Value, Exception> {
    call.expect(3..=4, &format!("file {sub} name ?time?"))?;
    let found = info(core, call.arg(2), true).map_err(could_not_read(call))?;
    if let Some(time) = call.get(3) {
        let seconds = time.to_i64()?;
        if sub == "mtime" {
            let path = core.absolute(&call.arg(2).as_str());
            let time = Duration::from_secs(seconds.max(0) as u64);
            core.files.set_modified(&path, time).map_err(could_not_read(call))?;
        }
        return Ok(Value::from(seconds));
    }
    let time = if sub == "mtime" { found.modified } else { found.accessed };
    Ok(Value::from(time.as_secs() as i64))
}

fn kind_name(kind: FileKind) -> &'static str {
    match kind {
        FileKind::File => "file",
        FileKind::Directory => "directory",
        FileKind::Link => "link",
        FileKind::Other => "characterSpecial",
    }
}

fn file_type(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "file type name")?;
    let info = info(core, call.arg(2), false).map_err(could_not_read(call))?;
    Ok(Value::from(kind_name(info.kind)))
}

fn stat(core: &mut Core, call: &Call<'_>, sub: &str, follow: bool) -> Result<Value, Exception> {
    call.expect(4..=4, &format!("file {sub} name varName"))?;
    let found = info(core, call.arg(2), follow).map_err(could_not_read(call))?;
    let name = VarName::of(call.arg(3));
    let kind = if found.kind == FileKind::Directory { 0o040_000 } else { 0o100_000 };
    let fields = [
        ("atime", found.accessed.as_secs() as i64),
        ("ctime", found.modified.as_secs() as i64),
        ("mtime", found.modified.as_secs() as i64),
        ("mode", i64::from(found.mode) | kind),
        ("size", found.size as i64),
        ("blksize", 4096),
        ("blocks", found.size.div_ceil(512) as i64),
        ("dev", 0),
        ("gid", 0),
        ("ino", 0),
        ("nlink", 1),
        ("uid", 0),
    ];
    for (key, value) in fields {
        core.write(&name, Some(&key.into()), Value::from(value))?;
    }
    core.write(&name, Some(&"type".into()), Value::from(kind_name(found.kind)))?;
    Ok(Value::EMPTY)
}

fn attributes(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=4, "file attributes name ?option? ?value? ?option value ...?")?;
    let found = info(core, call.arg(2), true).map_err(could_not_read(call))?;
    let permissions = Value::from(format!("0{:04o}", found.mode & 0o7777));
    match call.get(3) {
        None => Ok(Value::list([Value::from("-permissions"), permissions])),
        Some(_) => {
            call.choose(3, "option", &["-permissions"], false)?;
            Ok(permissions)
        }
    }
}

fn cd(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(1..=2, "cd ?dirName?")?;
    let name = call.get(1).map_or("~".into(), Value::as_str);
    let path = core.absolute(&name);
    let refuse = |e: io::Error| {
        posix(&e, |why| format!("couldn't change working directory to \"{name}\": {why}")).at(call.span(1), "")
    };
    match core.files.info(&path, true) {
        Ok(info) if info.kind == FileKind::Directory => core.cwd = Some(path),
        Ok(_) => return Err(refuse(io::ErrorKind::NotADirectory.into())),
        Err(e) => return Err(refuse(e)),
    }
    Ok(Value::EMPTY)
}

fn pwd(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(1..=1, "pwd")?;
    Ok(Value::from(&*core.current_dir()))
}

fn mkdir(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    for (i, name) in call.from(2).iter().enumerate() {
        let path = core.absolute(&name.as_str());
        let mut at = String::new();
        for part in paths::split(&path) {
            at = paths::join([at.as_str(), part.as_str()]);
            let result = match core.files.info(&at, true) {
                Ok(info) if info.kind == FileKind::Directory => Ok(()),
                Ok(_) => Err(io::ErrorKind::AlreadyExists.into()),
                Err(_) => core.files.make_dir(&at),
            };
            result.map_err(|e| {
                posix(&e, |why| format!("can't create directory \"{}\": {why}", shown(&name.as_str(), &at, &path)))
                    .at(call.span(i + 2), "")
            })?;
        }
    }
    Ok(Value::EMPTY)
}

/// The part of a name up to the folder that could not be made.
fn shown(name: &str, at: &str, path: &str) -> String {
    let missing = paths::split(path).len() - paths::split(at).len();
    let parts = paths::split(name);
    paths::join(parts[..parts.len().saturating_sub(missing)].iter().map(String::as_str))
}

/// The names after `-force` and `--`.
fn forced<'a>(call: &Call<'a>) -> Result<(bool, &'a [Value]), Exception> {
    let mut force = false;
    let mut i = 2;
    while let Some(word) = call.get(i) {
        match &*word.as_str() {
            "-force" => force = true,
            "--" => {
                i += 1;
                break;
            }
            option if option.starts_with('-') => {
                let message = format!("bad option \"{option}\": must be -force or --");
                let code = ["TCL", "LOOKUP", "INDEX", "option", option];
                return Err(Exception::coded(message, &code).at(call.span(i), ""));
            }
            _ => break,
        }
        i += 1;
    }
    Ok((force, call.from(i)))
}

fn delete(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let (force, names) = forced(call)?;
    for name in names {
        let path = core.absolute(&name.as_str());
        let Ok(info) = core.files.info(&path, false) else { continue };
        let result =
            if force && info.kind == FileKind::Directory { remove_all(core, &path) } else { core.files.remove(&path) };
        result.map_err(|e| {
            let full = e.kind() == io::ErrorKind::DirectoryNotEmpty;
            posix(&e, |why| {
                let why = if full { "directory not empty" } else { why };
                format!("error deleting \"{name}\": {why}")
            })
        })?;
    }
    Ok(Value::EMPTY)
}

fn remove_all(core: &mut Core, path: &str) -> io::Result<()> {
    // Folders are emptied before they go; without recursion, since they nest as deep as the disk has room.
    let mut waiting = vec![(path.to_owned(), false)];
    while let Some((path, emptied)) = waiting.pop() {
        let is_dir = core.files.info(&path, false)?.kind == FileKind::Directory;
        if emptied || !is_dir {
            core.files.remove(&path)?;
            continue;
        }
        let inside = core.files.list(&path)?;
        waiting.push((path.clone(), true));
        waiting.extend(inside.into_iter().map(|name| (format!("{path}/{name}"), false)));
    }
    Ok(())
}

fn transfer(core: &mut Core, call: &Call<'_>, sub: &str) -> Result<Value, Exception> {
    let usage = format!("file {sub} ?-option value ...? source ?source ...? target");
    let (force, names) = forced(call)?;
    let Some((target, sources)) = names.split_last().filter(|(_, s)| !s.is_empty()) else {
        return Err(call.wrong_args(&usage));
    };
    let to = core.absolute(&target.as_str());
    let into_dir = core.files.info(&to, true).is_ok_and(|i| i.kind == FileKind::Directory);
    let doing = if sub == "copy" { "copying" } else { "renaming" };
    if sources.len() > 1 && !into_dir {
        let message = format!("error {doing}: target \"{target}\" is not a directory");
        return Err(Exception::coded(message, &["POSIX", "ENOTDIR", "not a directory"]));
    }
    for source in sources {
        let from = core.absolute(&source.as_str());
        let to = if into_dir { format!("{to}/{}", paths::tail(&from)) } else { to.clone() };
        let found =
            core.files.info(&from, true).map_err(|e| posix(&e, |why| format!("error {doing} \"{source}\": {why}")))?;
        let shown = if into_dir { format!("{target}/{}", paths::tail(&from)) } else { target.as_str().into_owned() };
        if !force && core.files.info(&to, true).is_ok() {
            let e: io::Error = io::ErrorKind::AlreadyExists.into();
            return Err(posix(&e, |why| format!("error {doing} \"{source}\" to \"{shown}\": {why}")));
        }
        let result = match (sub, found.kind) {
            ("rename", _) => core.files.rename(&from, &to),
            (_, FileKind::Directory) => copy_all(core, &from, &to),
            _ => copy_file(core, &from, &to),
        };
        result.map_err(|e| posix(&e, |why| format!("error {doing} \"{source}\" to \"{shown}\": {why}")))?;
    }
    Ok(Value::EMPTY)
}

fn copy_file(core: &mut Core, from: &str, to: &str) -> io::Result<()> {
    let content = core.files.read(from)?;
    let mode = OpenMode { write: true, create: true, truncate: true, ..OpenMode::default() };
    core.files.open(to, mode)?.write_all(&content)
}

fn copy_all(core: &mut Core, from: &str, to: &str) -> io::Result<()> {
    let mut waiting = vec![(from.to_owned(), to.to_owned())];
    while let Some((from, to)) = waiting.pop() {
        if core.files.info(&from, true)?.kind != FileKind::Directory {
            copy_file(core, &from, &to)?;
            continue;
        }
        if core.files.info(&to, true).is_err() {
            core.files.make_dir(&to)?;
        }
        for name in core.files.list(&from)? {
            waiting.push((format!("{from}/{name}"), format!("{to}/{name}")));
        }
    }
    Ok(())
}
