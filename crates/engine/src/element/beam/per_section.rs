//! One value for each section of a beam, without memory from the heap for usual beams.

use std::iter::{Chain, Flatten};
use std::slice::{Iter, IterMut};

/// Number of sections that take no memory from the heap.
const USUAL_SECTIONS: usize = 12;

/// Values in the order of the sections along a beam.
#[derive(Debug)]
pub(super) struct PerSection<T> {
    first: [Option<T>; USUAL_SECTIONS],
    len: usize,
    rest: Vec<T>,
}

impl<T> PerSection<T> {
    pub(super) fn new() -> Self {
        Self { first: [const { None }; USUAL_SECTIONS], len: 0, rest: vec![] }
    }

    pub(super) fn push(&mut self, value: T) {
        match self.first.get_mut(self.len) {
            Some(place) => *place = Some(value),
            None => self.rest.push(value),
        }
        self.len += 1;
    }
}

impl<T> FromIterator<T> for PerSection<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        let mut all = Self::new();
        values.into_iter().for_each(|value| all.push(value));
        all
    }
}

impl<'a, T> IntoIterator for &'a PerSection<T> {
    type Item = &'a T;
    type IntoIter = Chain<Flatten<Iter<'a, Option<T>>>, Iter<'a, T>>;

    fn into_iter(self) -> Self::IntoIter {
        self.first.iter().flatten().chain(&self.rest)
    }
}

impl<'a, T> IntoIterator for &'a mut PerSection<T> {
    type Item = &'a mut T;
    type IntoIter = Chain<Flatten<IterMut<'a, Option<T>>>, IterMut<'a, T>>;

    fn into_iter(self) -> Self::IntoIter {
        self.first.iter_mut().flatten().chain(&mut self.rest)
    }
}

#[cfg(test)]
mod tests {
    use super::{PerSection, USUAL_SECTIONS};

    #[test]
    fn values_keep_their_order_beyond_the_usual_number() {
        let n = USUAL_SECTIONS + 3;
        let mut all: PerSection<usize> = (0..n).collect();
        (&mut all).into_iter().for_each(|x| *x += 1);
        assert!((&all).into_iter().copied().eq(1..=n));
    }
}
