//! The law of several bearings side by side.

use super::response::Coefficients;
use super::{Damage, GrantShear, Rules};
use crate::element::bearing::laws::rubber_shear::RubberShearLockstep;
use crate::element::bearing::laws::shear::Shear;
use crate::numeric::wide::{WIDTH, Wide};
use crate::rules::Consistent;

/// Laws with the rules of their source.
#[derive(Debug)]
pub(super) struct GrantLockstep(Coefficients<Wide>);

impl GrantLockstep {
    /// `None` where the rules are others.
    pub(super) fn new<R: Rules>(all: &[&GrantShear<R>; WIDTH]) -> Option<Self> {
        R::SIDE_BY_SIDE.then(|| {
            Self(Coefficients {
                a: std::array::from_fn(|i| Wide(all.map(|law| law.a[i]))),
                b: std::array::from_fn(|i| Wide(all.map(|law| law.b[i]))),
                c: std::array::from_fn(|i| Wide(all.map(|law| law.c[i]))),
            })
        })
    }
}

impl RubberShearLockstep for GrantLockstep {
    #[inline(always)]
    fn step(&self, c: &Shear<2, Wide>, memory: &[Wide], next: &mut [Wide], u: [Wide; 2], size: Wide) -> Shear<2, Wide> {
        let m = Damage::of_words(memory);
        let (shear, damage) = self.0.step::<Consistent>(c, [&m, &m], u, size);
        damage.to_words(next);
        shear
    }
}
