//! Parameters: numbers of laws, sections and elements that a script may change by the words of `parameter`.
//!
//! A change makes a copy with another value. The state of the thing stays as it is, so the copy has the same layout.

/// Reason why a parameter has not been changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ParameterError {
    /// The thing has no parameter of this name.
    Unknown,
    /// The thing refuses the value: the reason in words.
    Refused(String),
}

/// A thing with a new value of a parameter, and the value before.
pub type Changed<T> = Result<(T, f64), ParameterError>;

/// Value that a parameter is to have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NewValue {
    /// The present one, which is asked for.
    Present,
    /// This one.
    Is(f64),
    /// The present one and so much. Several numbers under one name keep their differences.
    Plus(f64),
}

impl NewValue {
    /// The value in place of a present one. `None` where it is asked for.
    pub fn instead_of(self, present: f64) -> Option<f64> {
        match self {
            Self::Present => None,
            Self::Is(value) => Some(value),
            Self::Plus(more) => Some(present + more),
        }
    }

    /// The same of a number that is a multiple of the parameter.
    pub(crate) fn times(self, factor: f64) -> Self {
        match self {
            Self::Present => Self::Present,
            Self::Is(value) => Self::Is(factor * value),
            Self::Plus(more) => Self::Plus(factor * more),
        }
    }
}

/// Puts the new value in its place, if there is one, and returns the value before.
pub(crate) fn exchange(place: &mut f64, value: NewValue) -> f64 {
    let before = *place;
    *place = value.instead_of(before).unwrap_or(before);
    before
}

/// The first of the words that name a parameter.
pub(crate) fn first<'a>(words: &[&'a str]) -> Result<&'a str, ParameterError> {
    words.first().copied().ok_or(ParameterError::Unknown)
}

/// A word that counts from 1, counted from 0.
pub(crate) fn index(word: &str) -> Result<usize, ParameterError> {
    word.parse::<usize>().ok().and_then(|i| i.checked_sub(1)).ok_or(ParameterError::Unknown)
}

/// The thing among several, or none.
pub(crate) fn existing<T>(thing: Option<T>) -> Result<T, ParameterError> {
    thing.ok_or(ParameterError::Unknown)
}

/// Of changes to several things: the value before of the last that has the parameter. A refusal by one refuses all.
pub(crate) fn last_of(changes: impl Iterator<Item = Result<f64, ParameterError>>) -> Result<f64, ParameterError> {
    let mut last = Err(ParameterError::Unknown);
    for change in changes {
        match change {
            Err(ParameterError::Unknown) => {}
            Err(refused) => return Err(refused),
            Ok(before) => last = Ok(before),
        }
    }
    last
}
