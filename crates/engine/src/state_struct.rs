//! State as flat data: a law's history is a plain struct of `f64`, kept in a slice of one long vector.
//!
//! Committing a whole model is then one copy, reverting is not storing, and a checkpoint is the vector itself.

use crate::numeric::wide::Wide;

/// A plain struct that can be kept in a slice of `f64`.
pub trait StateStruct: Copy + Default + Send + Sync + 'static {
    /// Number of its state variables.
    const LEN: usize;
    /// Read from the first `LEN` variables.
    fn read(words: &[f64]) -> Self;
    /// Write to the first `LEN` variables.
    fn write(&self, words: &mut [f64]);
}

impl StateStruct for () {
    const LEN: usize = 0;
    fn read(_: &[f64]) -> Self {}
    fn write(&self, _: &mut [f64]) {}
}

/// Declare a struct of `f64` fields (scalars, arrays, structs of the same kind) that implements [`StateStruct`].
///
/// ```
/// hysteron_engine::state_struct! {
///     /// History of some law.
///     pub struct History { /// largest strain
///         strain: f64, /// two hysteretic parameters
///         z: [f64; 2] }
/// }
/// use hysteron_engine::state_struct::StateStruct;
/// let h = History { strain: 0.1, z: [0.2, 0.3] };
/// let mut w = [0.0; History::LEN];
/// h.write(&mut w);
/// assert_eq!(w, [0.1, 0.2, 0.3]);
/// assert_eq!(History::read(&w), h);
/// ```
///
/// A struct with a type parameter can also be read from the numbers of several models side by side.
#[macro_export]
macro_rules! state_struct {
    ($(#[$meta:meta])* $vis:vis struct $name:ident { $($(#[$fmeta:meta])* $field:ident : $ty:ty),* $(,)? }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        $vis struct $name { $($(#[$fmeta])* pub $field: $ty),* }

        impl $crate::state_struct::StateStruct for $name {
            const LEN: usize = 0 $(+ <$ty as $crate::state_struct::Field>::LEN)*;
            #[inline]
            fn read(words: &[f64]) -> Self {
                let words = &words[..<Self as $crate::state_struct::StateStruct>::LEN];
                let mut at = 0;
                $(let $field = <$ty as $crate::state_struct::Field>::get(words, &mut at);)*
                let _ = at;
                Self { $($field),* }
            }
            #[inline]
            fn write(&self, words: &mut [f64]) {
                let words = &mut words[..<Self as $crate::state_struct::StateStruct>::LEN];
                let mut at = 0;
                $($crate::state_struct::Field::put(&self.$field, words, &mut at);)*
                let _ = at;
            }
        }
    };
    ($(#[$meta:meta])* $vis:vis struct $name:ident<$t:ident> { $($(#[$fmeta:meta])* $field:ident : $ty:ty),* $(,)? }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        $vis struct $name<$t = f64> { $($(#[$fmeta])* pub $field: $ty),* }

        impl<$t: $crate::numeric::real::Real> $name<$t>
        where
            $($ty: $crate::state_struct::Field<$t>),*
        {
            const WORDS: usize = 0 $(+ <$ty as $crate::state_struct::Field<$t>>::LEN)*;

            /// Of the state variables of one model, or of several side by side.
            #[inline(always)]
            $vis fn of_words(words: &[$t]) -> Self {
                let words = &words[..Self::WORDS];
                let mut at = 0;
                $(let $field = $crate::state_struct::Field::get(words, &mut at);)*
                let _ = at;
                Self { $($field),* }
            }

            /// Write them.
            #[inline(always)]
            $vis fn to_words(&self, words: &mut [$t]) {
                let words = &mut words[..Self::WORDS];
                let mut at = 0;
                $($crate::state_struct::Field::put(&self.$field, words, &mut at);)*
                let _ = at;
            }
        }

        impl $crate::state_struct::StateStruct for $name {
            const LEN: usize = Self::WORDS;
            #[inline]
            fn read(words: &[f64]) -> Self {
                Self::of_words(words)
            }
            #[inline]
            fn write(&self, words: &mut [f64]) {
                self.to_words(words);
            }
        }
    };
}

/// A type of fields of a [`state_struct!`](crate::state_struct!) struct, in words of one model or of several side by side.
pub trait Field<T = f64>: Sized {
    /// Number of state variables.
    const LEN: usize;
    /// Read at `at` and advance.
    fn get(words: &[T], at: &mut usize) -> Self;
    /// Write at `at` and advance.
    fn put(&self, words: &mut [T], at: &mut usize);
}

macro_rules! one_word {
    ($($ty:ty),*) => {$(
        impl Field<$ty> for $ty {
            const LEN: usize = 1;
            #[inline(always)]
            fn get(words: &[$ty], at: &mut usize) -> Self {
                *at += 1;
                words[*at - 1]
            }
            #[inline(always)]
            fn put(&self, words: &mut [$ty], at: &mut usize) {
                words[*at] = *self;
                *at += 1;
            }
        }
    )*};
}
one_word!(f64, Wide);

impl<U, T: Field<U>, const N: usize> Field<U> for [T; N] {
    const LEN: usize = N * T::LEN;
    #[inline(always)]
    fn get(words: &[U], at: &mut usize) -> Self {
        std::array::from_fn(|_| T::get(words, at))
    }
    #[inline(always)]
    fn put(&self, words: &mut [U], at: &mut usize) {
        self.iter().for_each(|x| x.put(words, at));
    }
}

/// A state struct inside another.
impl<W: StateStruct> Field for W {
    const LEN: usize = W::LEN;
    #[inline]
    fn get(words: &[f64], at: &mut usize) -> Self {
        *at += W::LEN;
        W::read(&words[*at - W::LEN..])
    }
    #[inline]
    fn put(&self, words: &mut [f64], at: &mut usize) {
        self.write(&mut words[*at..]);
        *at += W::LEN;
    }
}
