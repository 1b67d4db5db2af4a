//! Elements that are generic over the number of their displacements, as a model holds them.

use super::Element;
use super::continuum::Continuum;
use super::wall::{PLANE_WALL, SPACE_WALL, WallLines, WallPanels};
use std::sync::Arc;

/// An element made of a generic one. The code of its methods belongs to this crate, with the optimisation of its hot path.
pub trait Shared {
    /// The element as a model holds it.
    fn shared(self) -> Arc<dyn Element>;
}

macro_rules! shared {
    ($($kind:ty),* $(,)?) => { $(impl Shared for $kind {
        fn shared(self) -> Arc<dyn Element> {
            Arc::new(self)
        }
    })* };
}

shared!(
    Continuum<3, 6>,
    Continuum<3, 8>,
    Continuum<3, 12>,
    Continuum<3, 16>,
    Continuum<3, 18>,
    Continuum<4, 8>,
    Continuum<6, 12>,
    Continuum<6, 24>,
    Continuum<6, 30>,
    WallPanels<PLANE_WALL>,
    WallPanels<SPACE_WALL>,
    WallLines<PLANE_WALL>,
    WallLines<SPACE_WALL>,
);
