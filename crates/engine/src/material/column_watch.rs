//! Laws that watch columns, and the parts of a model that hold such laws.

use super::{ColumnResponse, LimitCurve, Material};
use std::fmt;

/// Committed responses of columns, each found by the limit curve that names the column.
#[derive(Clone, Copy, Debug)]
pub struct ObservedColumns<'a> {
    /// Limit curves.
    pub curves: &'a [LimitCurve],
    /// Response of the column of each curve; `None` where the model lacks it.
    pub responses: &'a [Option<ColumnResponse>],
}

impl ObservedColumns<'_> {
    /// Response of the column that a curve names.
    pub fn of(&self, curve: &LimitCurve) -> Option<ColumnResponse> {
        let at = self.curves.iter().position(|c| c == curve)?;
        self.responses.get(at).copied().flatten()
    }
}

/// A law, a section or an element, which may watch columns or hold laws that do. It has no method with a default, so that
/// every kind decides; [`watches_columns!`](crate::watches_columns!) writes the common cases.
pub trait WatchesColumns: fmt::Debug {
    /// Limit curves of all laws inside.
    fn limit_curves(&self) -> Vec<&LimitCurve>;
    /// Changes the histories of the laws inside by the responses of their columns. `committed` is the committed state that
    /// the type itself writes.
    fn observe(&self, committed: &mut [f64], columns: &ObservedColumns<'_>);
}

/// Implements [`WatchesColumns`](crate::material::WatchesColumns) for a type: `nothing` for one that holds no law, `in` for
/// parts that take the same state as the type, and `at` for parts with the range of their own state.
///
/// Generic parameters stand in brackets in front of the type.
#[macro_export]
macro_rules! watches_columns {
    ([$($generics:tt)*] $type:ty => nothing) => {
        impl<$($generics)*> $crate::material::WatchesColumns for $type {
            fn limit_curves(&self) -> Vec<&$crate::material::LimitCurve> {
                vec![]
            }
            fn observe(&self, _: &mut [f64], _: &$crate::material::ObservedColumns<'_>) {}
        }
    };
    ([$($generics:tt)*] $type:ty => |$own:ident| in $parts:expr) => {
        impl<$($generics)*> $crate::material::WatchesColumns for $type {
            fn limit_curves(&self) -> Vec<&$crate::material::LimitCurve> {
                let $own = self;
                $parts.into_iter().flat_map(|part| part.limit_curves()).collect()
            }
            fn observe(&self, committed: &mut [f64], columns: &$crate::material::ObservedColumns<'_>) {
                let $own = self;
                $parts.into_iter().for_each(|part| part.observe(committed, columns));
            }
        }
    };
    ([$($generics:tt)*] $type:ty => |$own:ident| at $parts:expr) => {
        impl<$($generics)*> $crate::material::WatchesColumns for $type {
            fn limit_curves(&self) -> Vec<&$crate::material::LimitCurve> {
                let $own = self;
                $parts.into_iter().flat_map(|(_, part)| part.limit_curves()).collect()
            }
            fn observe(&self, committed: &mut [f64], columns: &$crate::material::ObservedColumns<'_>) {
                let $own = self;
                $parts.into_iter().for_each(|(range, part)| part.observe(&mut committed[range], columns));
            }
        }
    };
    ($type:ty => $($rest:tt)*) => {
        $crate::watches_columns!([] $type => $($rest)*);
    };
}

/// Shows the columns to `n` points in the layout of the law.
pub(crate) fn observe_points(law: &Material, n: usize, states: &mut [f64], columns: &ObservedColumns<'_>) {
    if law.limit_curves().is_empty() {
        return;
    }
    let mut one = vec![0.0; law.state_len()];
    for i in 0..n {
        law.copy_history((states, i, n), (&mut one, 0, 1));
        law.observe(&mut one, columns);
        law.copy_history((&one, 0, 1), (&mut *states, i, n));
    }
}
