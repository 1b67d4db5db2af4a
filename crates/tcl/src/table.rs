//! A hash table with two orders: of insertion, for dictionaries, and of Tcl's own hash tables, for arrays and names in a
//! namespace. `array names` therefore lists in the order of tclsh.

use std::cell::Cell;

use super::text::Text;

const NONE: u32 = u32::MAX;
/// Entries per bucket above which Tcl rebuilds a table with four times the buckets.
const LOAD: usize = 3;

/// Tcl's hash of a string. Weak, but the order in which scripts see array elements follows from it.
pub(crate) fn hash(key: &str) -> u32 {
    let mut bytes = key.bytes();
    let first = bytes.next().map_or(0, u32::from);
    bytes.fold(first, |h, b| h.wrapping_mul(9).wrapping_add(u32::from(b)))
}

/// Equality of texts that are almost surely equal and mostly short: a call of `memcmp` takes longer than the comparison.
#[inline]
fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    if a.len() <= 8 { a.len() == b.len() && a.iter().zip(b).all(|(x, y)| x == y) } else { a == b }
}

#[derive(Clone, Debug)]
struct Entry<V> {
    key: Text,
    hash: u32,
    next: u32,
    value: V,
}

#[derive(Clone, Debug)]
enum Heads {
    Small([u32; 4]),
    Large(Vec<u32>),
}

impl Heads {
    fn as_slice(&self) -> &[u32] {
        match self {
            Heads::Small(a) => a,
            Heads::Large(v) => v,
        }
    }

    fn at(&mut self, hash: u32) -> &mut u32 {
        let heads: &mut [u32] = match self {
            Heads::Small(a) => a,
            Heads::Large(v) => v,
        };
        let mask = heads.len() - 1;
        &mut heads[hash as usize & mask]
    }

    fn first(&self, hash: u32) -> u32 {
        let heads = self.as_slice();
        heads[hash as usize & (heads.len() - 1)]
    }
}

/// The table.
#[derive(Clone, Debug)]
pub(crate) struct Table<V> {
    /// In the order of insertion; `None` where an entry was removed.
    entries: Vec<Option<Entry<V>>>,
    heads: Heads,
    len: usize,
}

impl<V> Default for Table<V> {
    fn default() -> Self {
        Self { entries: Vec::new(), heads: Heads::Small([NONE; 4]), len: 0 }
    }
}

impl<V> Table<V> {
    pub(crate) fn len(&self) -> usize {
        self.len
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Forget everything but keep the memory, for the next call of a procedure.
    pub(crate) fn clear(&mut self) {
        self.entries.clear();
        self.heads = Heads::Small([NONE; 4]);
        self.len = 0;
    }

    #[inline]
    fn find(&self, key: &str, hash: u32) -> Option<usize> {
        let mut at = self.heads.first(hash);
        while at != NONE {
            let entry = self.entries[at as usize].as_ref()?;
            if entry.hash == hash && same(&entry.key, key) {
                return Some(at as usize);
            }
            at = entry.next;
        }
        None
    }

    /// The value under a name, if it stands at this place.
    #[inline(always)]
    pub(crate) fn at(&self, place: u32, key: &Text) -> Option<&V> {
        match self.entries.get(place as usize) {
            Some(Some(entry)) if entry.key.is(key) => Some(&entry.value),
            _ => None,
        }
    }

    /// As [`Table::at`], to change the value.
    #[inline(always)]
    pub(crate) fn at_mut(&mut self, place: u32, key: &Text) -> Option<&mut V> {
        match self.entries.get_mut(place as usize) {
            Some(Some(entry)) if entry.key.is(key) => Some(&mut entry.value),
            _ => None,
        }
    }

    /// As [`Table::find`], for a name that was found at `near` before.
    #[inline]
    fn find_near(&self, key: &Text, hash: u32, near: &Cell<u32>) -> Option<usize> {
        if self.at(near.get(), key).is_some() {
            return Some(near.get() as usize);
        }
        let at = self.find(key, hash)?;
        near.set(at as u32);
        Some(at)
    }

    /// The value under a name that was found at `near` before. The place is noted there.
    #[inline]
    pub(crate) fn get_near(&self, key: &Text, hash: u32, near: &Cell<u32>) -> Option<&V> {
        let at = self.find_near(key, hash, near)?;
        self.entries[at].as_ref().map(|e| &e.value)
    }

    /// As [`Table::get_near`], to change the value.
    #[inline]
    pub(crate) fn get_near_mut(&mut self, key: &Text, hash: u32, near: &Cell<u32>) -> Option<&mut V> {
        let at = self.find_near(key, hash, near)?;
        self.entries[at].as_mut().map(|e| &mut e.value)
    }

    pub(crate) fn get(&self, key: &str) -> Option<&V> {
        self.find(key, hash(key)).and_then(|at| self.entries[at].as_ref()).map(|e| &e.value)
    }

    pub(crate) fn get_mut(&mut self, key: &str) -> Option<&mut V> {
        let at = self.find(key, hash(key))?;
        self.entries[at].as_mut().map(|e| &mut e.value)
    }

    pub(crate) fn contains(&self, key: &str) -> bool {
        self.find(key, hash(key)).is_some()
    }

    /// The value under a key, put there if there was none.
    pub(crate) fn entry_or(&mut self, key: &Text, hash: u32, new: impl FnOnce() -> V) -> &mut V {
        let at = match self.find(key, hash) {
            Some(at) => at,
            None => self.push(key.clone(), hash, new()),
        };
        // `find` and `push` give the place of an entry that is there.
        match &mut self.entries[at] {
            Some(entry) => &mut entry.value,
            None => unreachable!("an entry was just found here"),
        }
    }

    pub(crate) fn insert(&mut self, key: Text, value: V) -> Option<V> {
        let hash = hash(&key);
        if let Some(at) = self.find(&key, hash)
            && let Some(entry) = &mut self.entries[at]
        {
            return Some(std::mem::replace(&mut entry.value, value));
        }
        self.push(key, hash, value);
        None
    }

    /// Put a value under a key that is not there. Returns its place.
    pub(crate) fn push(&mut self, key: Text, hash: u32, value: V) -> usize {
        let at = self.entries.len();
        let head = self.heads.at(hash);
        let next = std::mem::replace(head, at as u32);
        self.entries.push(Some(Entry { key, hash, next, value }));
        self.len += 1;
        if self.len >= self.heads.as_slice().len() * LOAD {
            self.grow();
        }
        at
    }

    fn grow(&mut self) {
        let old = std::mem::replace(&mut self.heads, Heads::Small([NONE; 4]));
        self.heads = Heads::Large(vec![NONE; old.as_slice().len() * 4]);
        for &head in old.as_slice() {
            let mut at = head;
            while let Some(entry) = self.entries.get_mut(at as usize).and_then(Option::as_mut) {
                let new_head = self.heads.at(entry.hash);
                let following = entry.next;
                entry.next = std::mem::replace(new_head, at);
                at = following;
            }
        }
    }

    pub(crate) fn remove(&mut self, key: &str) -> Option<V> {
        let hash = hash(key);
        let found = self.find(key, hash)?;
        let entry = self.entries[found].take()?;
        let mut at = self.heads.first(hash);
        if at as usize == found {
            *self.heads.at(hash) = entry.next;
        } else {
            while let Some(e) = self.entries.get_mut(at as usize).and_then(Option::as_mut) {
                if e.next as usize == found {
                    e.next = entry.next;
                    break;
                }
                at = e.next;
            }
        }
        self.len -= 1;
        if found + 1 == self.entries.len() {
            self.entries.pop();
        } else if self.entries.len() > 16 && self.len * 2 < self.entries.len() {
            self.compact();
        }
        Some(entry.value)
    }

    /// Close the gaps that removals have left; both orders stay.
    fn compact(&mut self) {
        let mut place = vec![NONE; self.entries.len()];
        let mut kept = 0;
        for (at, entry) in self.entries.iter().enumerate() {
            if entry.is_some() {
                place[at] = kept;
                kept += 1;
            }
        }
        let moved = |at: u32| if at == NONE { NONE } else { place[at as usize] };
        self.entries.retain(Option::is_some);
        for entry in self.entries.iter_mut().flatten() {
            entry.next = moved(entry.next);
        }
        let heads: &mut [u32] = match &mut self.heads {
            Heads::Small(a) => a,
            Heads::Large(v) => v,
        };
        for head in heads {
            *head = moved(*head);
        }
    }

    /// In the order of insertion.
    pub(crate) fn iter(&self) -> impl DoubleEndedIterator<Item = (&Text, &V)> {
        self.entries.iter().flatten().map(|e| (&e.key, &e.value))
    }

    /// In the order in which Tcl walks its hash table.
    pub(crate) fn iter_hashed(&self) -> impl Iterator<Item = (&Text, &V)> {
        let entry = |at: u32| self.entries.get(at as usize).and_then(Option::as_ref);
        self.heads
            .as_slice()
            .iter()
            .flat_map(move |&head| std::iter::successors(entry(head), move |e| entry(e.next)))
            .map(|e| (&e.key, &e.value))
    }

    /// The values, each once, to change them.
    pub(crate) fn values_mut(&mut self) -> impl Iterator<Item = &mut V> {
        self.entries.iter_mut().flatten().map(|e| &mut e.value)
    }
}
