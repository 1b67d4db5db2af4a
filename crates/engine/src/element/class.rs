//! Classes of elements.

/// A class of elements, as OpenSees has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Class {
    /// Name, as recorders and `print` show it.
    pub name: &'static str,
    /// Number in OpenSees' `SRC/classTags.h`; 0 of a class that OpenSees does not have.
    pub tag: i64,
}

impl Class {
    /// A class of OpenSees.
    pub const fn new(name: &'static str, tag: i64) -> Self {
        Self { name, tag }
    }

    /// A class that OpenSees does not have.
    pub const fn own(name: &'static str) -> Self {
        Self::new(name, 0)
    }
}
