//! Responses of an element that a recorder finds by name.

/// A response of a thing T with a state S, one row of the table of its responses.
pub(crate) struct Response<T: ?Sized, S: ?Sized = [f64]> {
    /// Names in scripts, the preferred one first.
    names: &'static [&'static str],
    /// Names of the columns.
    labels: &'static [&'static str],
    /// Writes the values.
    read: fn(&T, &S, &mut [f64]),
}

impl<T: ?Sized, S: ?Sized> Response<T, S> {
    pub(crate) const fn new(
        names: &'static [&'static str],
        labels: &'static [&'static str],
        read: fn(&T, &S, &mut [f64]),
    ) -> Self {
        Self { names, labels, read }
    }

    /// The response of a name in a table. Its path is its place there.
    pub(crate) fn find(table: &[Self], name: &str) -> Option<Probe> {
        let place = table.iter().position(|response| response.names.contains(&name))?;
        Some(Probe::new(place as u32, table[place].labels.iter().copied()))
    }

    /// Writes the values of the response at a place of a table; false if there is none.
    pub(crate) fn read(table: &[Self], place: u32, thing: &T, state: &S, out: &mut [f64]) -> bool {
        let response = table.get(place as usize);
        response.inspect(|response| (response.read)(thing, state, out)).is_some()
    }

    /// The preferred names of a table.
    pub(crate) fn names(table: &'static [Self]) -> impl Iterator<Item = &'static str> {
        table.iter().map(|response| response.names[0])
    }
}

/// A response found by name: what its columns are called, and how its owner finds it again.
///
/// The path is private to the owner: an element puts its own number first, then that of a material or section, so
/// that nested owners can share one probe. Reading goes through the element each time, never through a copy of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Probe {
    /// Name of each column, as OpenSees calls them.
    pub labels: Vec<String>,
    /// Place of the response in its owner.
    pub path: Vec<u32>,
}

impl Probe {
    /// A response with one number for a path.
    pub fn new<S: Into<String>>(id: u32, labels: impl IntoIterator<Item = S>) -> Self {
        Self { labels: labels.into_iter().map(Into::into).collect(), path: vec![id] }
    }

    /// The same response seen from the owner's owner.
    pub fn inside(mut self, ids: &[u32]) -> Self {
        self.path.splice(0..0, ids.iter().copied());
        self
    }

    /// Number of columns.
    pub fn len(&self) -> usize {
        self.labels.len()
    }

    /// Returns true if there are no columns.
    pub fn is_empty(&self) -> bool {
        self.labels.is_empty()
    }
}
