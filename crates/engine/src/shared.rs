//! Laws, sections and elements as a model holds them.

use std::sync::Arc;

/// A thing that a model holds in a role: a law as [`Uniaxial`](crate::material::Uniaxial), a beam as
/// [`Element`](crate::element::Element).
///
/// Most of them are generic, and generic code is compiled where it is used. Each implementation stands in this crate,
/// so that the code of the hot path is compiled here once, with the optimisation of this crate.
pub trait Shared<R: Role + ?Sized> {
    /// The thing as a model holds it.
    fn shared(self) -> R::Held;
}

/// A role in a model, and how the model holds what plays it.
pub trait Role {
    /// Type that the model holds.
    type Held: From<Arc<Self>>;
}

/// Implements [`Shared`] for the kinds of a role.
macro_rules! shared {
    (dyn $role:path: $($kind:ty),* $(,)?) => { $(impl $crate::shared::Shared<dyn $role> for $kind {
        #[inline(never)]
        fn shared(self) -> <dyn $role as $crate::shared::Role>::Held {
            let shared: std::sync::Arc<dyn $role> = std::sync::Arc::new(self);
            shared.into()
        }
    })* };
}
pub(crate) use shared;
