//! Namespaces and the names of commands in them.

use super::command::{CmdId, Definition, Imp};
use super::core::{Core, NsId};
use super::error::Exception;
use super::table::Table;
use super::text::Text;
use super::value::Value;
use super::vars::{Slot, split_qualified};
use crate::diagnostic;

/// A namespace.
pub(crate) struct Namespace {
    /// With all its qualifiers: `::`, `::a::b`.
    pub(crate) full: Text,
    pub(crate) parent: Option<NsId>,
    pub(crate) children: Table<NsId>,
    pub(crate) vars: Table<Slot>,
    pub(crate) commands: Table<CmdId>,
    pub(crate) exports: Vec<Text>,
    /// Namespaces searched for commands besides this one and the global one.
    pub(crate) path: Vec<NsId>,
    pub(crate) unknown: Value,
    pub(crate) deleted: bool,
}

impl Namespace {
    pub(crate) fn global() -> Self {
        Self::named("::", None)
    }

    /// The same for another interpreter: variables with the values that they have, but of its own.
    pub(crate) fn copied(&self) -> Self {
        Namespace {
            full: self.full.clone(),
            parent: self.parent,
            children: self.children.clone(),
            vars: self.vars.clone(),
            commands: self.commands.clone(),
            exports: self.exports.clone(),
            path: self.path.clone(),
            unknown: self.unknown.clone(),
            deleted: self.deleted,
        }
    }

    fn named(full: &str, parent: Option<NsId>) -> Self {
        Namespace {
            full: full.into(),
            parent,
            children: Table::default(),
            vars: Table::default(),
            commands: Table::default(),
            exports: vec![],
            path: vec![],
            unknown: Value::EMPTY,
            deleted: false,
        }
    }
}

/// The parts of a qualified name that are not empty.
fn parts(path: &str) -> impl Iterator<Item = &str> {
    path.split("::").map(|p| p.trim_start_matches(':')).filter(|p| !p.is_empty())
}

impl Core {
    pub(crate) fn ns(&self, id: NsId) -> &Namespace {
        &self.table.namespaces[id.0 as usize]
    }

    pub(crate) fn ns_mut(&mut self, id: NsId) -> &mut Namespace {
        &mut self.table.namespaces[id.0 as usize]
    }

    /// The namespace in which commands run now.
    pub(crate) fn here(&self) -> NsId {
        self.frame().ns
    }

    fn descend(&self, from: NsId, path: &str) -> Option<NsId> {
        parts(path).try_fold(from, |ns, part| self.ns(ns).children.get(part).copied())
    }

    /// The namespace of a path: from the root if it starts with `::`, else from here or, failing that, from the root.
    pub(crate) fn find_namespace(&self, path: &str) -> Option<NsId> {
        if path.starts_with("::") {
            return self.descend(NsId::GLOBAL, path);
        }
        self.descend(self.here(), path).or_else(|| self.descend(NsId::GLOBAL, path))
    }

    /// As [`Core::find_namespace`], with the error for one that is not there.
    pub(crate) fn namespace_named(&self, path: &str) -> Result<NsId, Exception> {
        self.find_namespace(path).ok_or_else(|| {
            let place =
                if path.starts_with("::") { String::new() } else { format!(" in \"{}\"", &*self.ns(self.here()).full) };
            Exception::coded(format!("namespace \"{path}\" not found{place}"), &["TCL", "LOOKUP", "NAMESPACE", path])
        })
    }

    /// The namespace of a path, made as far as it does not exist.
    pub(crate) fn make_namespace(&mut self, path: &str) -> NsId {
        let mut at = if path.starts_with("::") { NsId::GLOBAL } else { self.here() };
        let names: Vec<String> = parts(path).map(str::to_owned).collect();
        for name in names {
            at = match self.ns(at).children.get(&name) {
                Some(&child) => child,
                None => self.add_namespace(at, &name),
            };
        }
        at
    }

    fn add_namespace(&mut self, parent: NsId, name: &str) -> NsId {
        let id = NsId(self.table.namespaces.len() as u32);
        let full = match &*self.ns(parent).full {
            "::" => format!("::{name}"),
            above => format!("{above}::{name}"),
        };
        self.table.namespaces.push(Namespace::named(&full, Some(parent)));
        self.ns_mut(parent).children.insert(name.into(), id);
        id
    }

    /// Remove a namespace with all that is in it.
    pub(crate) fn delete_namespace(&mut self, id: NsId) {
        let children: Vec<NsId> = self.ns(id).children.iter().map(|(_, c)| *c).collect();
        for child in children {
            self.delete_namespace(child);
        }
        let commands: Vec<CmdId> = self.ns(id).commands.iter().map(|(_, c)| *c).collect();
        for command in commands {
            self.delete_command(command);
        }
        let full = self.ns(id).full.clone();
        if let Some(parent) = self.ns(id).parent {
            let name = full.rsplit("::").next().unwrap_or_default();
            self.ns_mut(parent).children.remove(name);
            self.ns_mut(id).deleted = true;
        }
        self.ns_mut(id).vars.clear();
        self.ns_mut(id).path.clear();
        self.renew_epoch();
    }

    /// Namespace of a new command of this name, created if needed, and the last part of the name.
    pub(crate) fn place_for(&mut self, name: &str) -> (NsId, Text) {
        match split_qualified(name) {
            None => (self.here(), name.into()),
            Some((path, tail)) => {
                let path = if name.starts_with("::") { format!("::{path}") } else { path.to_owned() };
                (self.make_namespace(&path), tail.into())
            }
        }
    }

    /// As [`Core::place_for`], without making the namespace.
    pub(crate) fn existing_place_for(&self, name: &str) -> Option<(NsId, Text)> {
        match split_qualified(name) {
            None => Some((self.here(), name.into())),
            Some(("", tail)) if name.starts_with("::") => Some((NsId::GLOBAL, tail.into())),
            Some((path, tail)) => {
                let from = if path.starts_with("::") { NsId::GLOBAL } else { self.here() };
                Some((self.descend(from, path)?, tail.into()))
            }
        }
    }

    /// Make a command, in the place of one of the same name if there is.
    pub(crate) fn define(&mut self, ns: NsId, name: &Text, imp: Imp) -> CmdId {
        self.renew_epoch();
        if let Some(&old) = self.ns(ns).commands.get(name) {
            self.table.commands[old.0 as usize].imp = imp;
            // No longer those of the language.
            self.table.inlined.forget(old);
            return old;
        }
        let id = CmdId(self.table.commands.len() as u32);
        self.table.commands.push(Definition { name: name.clone(), ns, imp });
        self.ns_mut(ns).commands.insert(name.clone(), id);
        id
    }

    /// Give a command another name; what was imported from it stays imported.
    pub(crate) fn move_command(&mut self, id: CmdId, ns: NsId, tail: &Text) {
        let Definition { name: old, ns: from, .. } = &self.table.commands[id.0 as usize];
        let (old, from) = (old.clone(), *from);
        self.ns_mut(from).commands.remove(&old);
        self.ns_mut(ns).commands.insert(tail.clone(), id);
        let definition = &mut self.table.commands[id.0 as usize];
        definition.name = tail.clone();
        definition.ns = ns;
        if let Imp::Proc(proc) = &mut definition.imp
            && proc.ns != ns
        {
            // The body of a procedure runs in the namespace that the procedure is in.
            let moved = super::command::Proc { ns, ..super::command::Proc::clone(proc) };
            *proc = std::rc::Rc::new(moved);
        }
        self.renew_epoch();
    }

    /// Remove a command and what was imported from it.
    pub(crate) fn delete_command(&mut self, id: CmdId) {
        let Definition { name, ns, .. } = &self.table.commands[id.0 as usize];
        let (name, ns) = (name.clone(), *ns);
        if self.ns(ns).commands.get(&name) == Some(&id) {
            self.ns_mut(ns).commands.remove(&name);
        }
        self.table.commands[id.0 as usize].imp = Imp::Deleted;
        self.renew_epoch();
        let imports: Vec<CmdId> = (0..self.table.commands.len() as u32)
            .map(CmdId)
            .filter(|c| matches!(self.table.commands[c.0 as usize].imp, Imp::Import(of) if of == id))
            .collect();
        for import in imports {
            self.delete_command(import);
        }
    }

    /// The command that a name means here.
    pub(crate) fn find_command(&self, name: &str) -> Option<CmdId> {
        self.find_command_from(self.here(), name)
    }

    pub(crate) fn find_command_from(&self, from: NsId, name: &str) -> Option<CmdId> {
        let at = |ns: NsId, tail: &str| self.ns(ns).commands.get(tail).copied();
        if let Some((path, tail)) = split_qualified(name) {
            if name.starts_with("::") {
                return at(self.descend(NsId::GLOBAL, path)?, tail);
            }
            let relative = |from: NsId| self.descend(from, path).and_then(|ns| at(ns, tail));
            return relative(from)
                .or_else(|| self.ns(from).path.iter().find_map(|&ns| relative(ns)))
                .or_else(|| relative(NsId::GLOBAL));
        }
        at(from, name)
            .or_else(|| self.ns(from).path.iter().find_map(|&ns| at(ns, name)))
            .or_else(|| at(NsId::GLOBAL, name))
    }

    /// The name of a command with all its qualifiers.
    pub(crate) fn full_name(&self, id: CmdId) -> String {
        let Definition { name, ns, .. } = &self.table.commands[id.0 as usize];
        self.qualified(*ns, name)
    }

    /// A name in a namespace with all its qualifiers.
    pub(crate) fn qualified(&self, ns: NsId, name: &str) -> String {
        match &*self.ns(ns).full {
            "::" => format!("::{name}"),
            full => format!("{full}::{name}"),
        }
    }

    /// The command behind imports.
    pub(crate) fn origin_of(&self, mut id: CmdId) -> CmdId {
        while let Imp::Import(of) = self.table.commands[id.0 as usize].imp {
            id = of;
        }
        id
    }

    /// The known command nearest to a misspelled name.
    pub(crate) fn nearest_command(&self, name: &str) -> Option<String> {
        let here = self.here();
        let known = [here, NsId::GLOBAL].into_iter().flat_map(|ns| self.ns(ns).commands.iter().map(|(k, _)| &**k));
        diagnostic::nearest(name, known).map(str::to_owned)
    }
}
