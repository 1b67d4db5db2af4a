//! Files in memory, for studies that run scripts without touching the disk.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io::{self, Cursor, Read, Seek, SeekFrom, Write};
use std::rc::Rc;
use std::time::Duration;

use super::files::{FileInfo, FileKind, Files, OpenMode, Stream};

type Content = Rc<RefCell<Vec<u8>>>;

#[derive(Clone)]
enum Node {
    Directory,
    File(Content),
}

/// Files that exist only here. Clones share them. `/` is there from the start and is the current folder.
#[derive(Clone)]
pub struct MemoryFiles {
    nodes: Rc<RefCell<BTreeMap<String, Node>>>,
}

impl Default for MemoryFiles {
    fn default() -> Self {
        Self { nodes: Rc::new(RefCell::new(BTreeMap::from([("/".to_owned(), Node::Directory)]))) }
    }
}

pub(super) fn parent(path: &str) -> &str {
    match path.rfind('/') {
        Some(0) | None => "/",
        Some(at) => &path[..at],
    }
}

impl MemoryFiles {
    /// Put a file there, with the folders that it needs.
    pub fn insert(&self, path: &str, content: impl Into<Vec<u8>>) {
        self.insert_dir(parent(path));
        self.nodes.borrow_mut().insert(path.to_owned(), Node::File(Rc::new(RefCell::new(content.into()))));
    }

    /// Put a folder there, with those above it.
    pub fn insert_dir(&self, path: &str) {
        let mut nodes = self.nodes.borrow_mut();
        let mut folder = path;
        while folder != "/" {
            nodes.insert(folder.to_owned(), Node::Directory);
            folder = parent(folder);
        }
    }

    /// The content of a file.
    pub fn get(&self, path: &str) -> Option<Vec<u8>> {
        match self.nodes.borrow().get(path)? {
            Node::File(content) => Some(content.borrow().clone()),
            Node::Directory => None,
        }
    }

    fn check_parent(&self, path: &str) -> io::Result<()> {
        match self.nodes.borrow().get(parent(path)) {
            Some(Node::Directory) => Ok(()),
            Some(Node::File(_)) => Err(io::ErrorKind::NotADirectory.into()),
            None => Err(io::ErrorKind::NotFound.into()),
        }
    }

    fn children(&self, path: &str) -> Vec<String> {
        let prefix = if path == "/" { "/".to_owned() } else { format!("{path}/") };
        let nodes = self.nodes.borrow();
        nodes.keys().filter(|k| k.len() > prefix.len() && k.starts_with(&prefix)).cloned().collect()
    }
}

impl Files for MemoryFiles {
    fn current_dir(&self) -> String {
        "/".to_owned()
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        self.check_parent(path)?;
        let mut nodes = self.nodes.borrow_mut();
        let content = match nodes.get(path) {
            Some(Node::Directory) => return Err(io::ErrorKind::IsADirectory.into()),
            Some(Node::File(_)) if mode.exclusive => return Err(io::ErrorKind::AlreadyExists.into()),
            Some(Node::File(content)) => content.clone(),
            None if mode.create => {
                let content = Content::default();
                nodes.insert(path.to_owned(), Node::File(content.clone()));
                content
            }
            None => return Err(io::ErrorKind::NotFound.into()),
        };
        if mode.truncate {
            content.borrow_mut().clear();
        }
        Ok(Box::new(MemoryStream { content, at: 0, append: mode.append }))
    }

    fn info(&self, path: &str, _follow: bool) -> io::Result<FileInfo> {
        let (kind, size, mode) = match self.nodes.borrow().get(path) {
            Some(Node::Directory) => (FileKind::Directory, 0, 0o755),
            Some(Node::File(c)) => (FileKind::File, c.borrow().len() as u64, 0o644),
            None => return Err(io::ErrorKind::NotFound.into()),
        };
        Ok(FileInfo { kind, size, modified: Duration::ZERO, accessed: Duration::ZERO, mode })
    }

    fn list(&self, path: &str) -> io::Result<Vec<String>> {
        if !matches!(self.nodes.borrow().get(path), Some(Node::Directory)) {
            return Err(io::ErrorKind::NotFound.into());
        }
        let own = |k: &String| parent(k) == path;
        let name = |k: String| k.rsplit('/').next().unwrap_or_default().to_owned();
        Ok(self.children(path).into_iter().filter(own).map(name).collect())
    }

    fn make_dir(&mut self, path: &str) -> io::Result<()> {
        self.check_parent(path)?;
        let mut nodes = self.nodes.borrow_mut();
        if nodes.contains_key(path) {
            return Err(io::ErrorKind::AlreadyExists.into());
        }
        nodes.insert(path.to_owned(), Node::Directory);
        Ok(())
    }

    fn remove(&mut self, path: &str) -> io::Result<()> {
        if !self.children(path).is_empty() {
            return Err(io::ErrorKind::DirectoryNotEmpty.into());
        }
        self.nodes.borrow_mut().remove(path).map(|_| ()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn rename(&mut self, from: &str, to: &str) -> io::Result<()> {
        self.check_parent(to)?;
        let below = self.children(from);
        let mut nodes = self.nodes.borrow_mut();
        let node = nodes.remove(from).ok_or(io::ErrorKind::NotFound)?;
        nodes.insert(to.to_owned(), node);
        for old in below {
            if let Some(node) = nodes.remove(&old) {
                nodes.insert(format!("{to}{}", &old[from.len()..]), node);
            }
        }
        Ok(())
    }

    fn set_modified(&mut self, path: &str, _time: Duration) -> io::Result<()> {
        self.info(path, true).map(|_| ())
    }
}

struct MemoryStream {
    content: Content,
    at: u64,
    append: bool,
}

impl MemoryStream {
    /// Act on the content as a cursor at the current place.
    fn cursor<R>(&mut self, act: impl FnOnce(&mut Cursor<&mut Vec<u8>>) -> io::Result<R>) -> io::Result<R> {
        let mut content = self.content.borrow_mut();
        let mut cursor = Cursor::new(&mut *content);
        cursor.set_position(self.at);
        let result = act(&mut cursor);
        self.at = cursor.position();
        result
    }
}

impl Read for MemoryStream {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.cursor(|c| c.read(buffer))
    }
}

impl Write for MemoryStream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let append = self.append;
        self.cursor(|c| {
            if append {
                c.seek(SeekFrom::End(0))?;
            }
            c.write(bytes)
        })
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for MemoryStream {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.cursor(|c| c.seek(to))
    }
}

impl Stream for MemoryStream {
    fn set_len(&mut self, length: u64) -> io::Result<()> {
        let mut content = self.content.borrow_mut();
        let more = (length as usize).saturating_sub(content.len());
        content.try_reserve(more).map_err(|_| io::Error::from(io::ErrorKind::OutOfMemory))?;
        content.resize(length as usize, 0);
        Ok(())
    }
}
