//! Responses of an element that a recorder finds by name.

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
