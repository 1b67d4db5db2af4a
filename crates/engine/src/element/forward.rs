//! Methods of an element around another one that are those of the element inside.

/// Writes the named methods of [`Element`](super::Element) as calls of the element in the field `inner`.
///
/// `commit`, `overload`, `softening`, `exhausted`, `outside_range` and `add_own_damping` give the inner element the first `inner_len` state variables.
/// A wrapper names each method, so that a new method of the trait is decided upon in every wrapper.
macro_rules! forward_to_inner {
    ($($method:ident)*) => { $($crate::element::forward::forward_to_inner!(@$method);)* };
    (@class) => {
        fn class(&self) -> &'static str {
            self.inner.class()
        }
    };
    (@dofs) => {
        fn dofs(&self) -> usize {
            self.inner.dofs()
        }
    };
    (@commit) => {
        fn commit(&self, trial: &[f64], committed: &mut [f64]) {
            let (own, rest) = committed.split_at_mut(self.inner_len);
            self.inner.commit(&trial[..self.inner_len], own);
            rest.copy_from_slice(&trial[self.inner_len..]);
        }
    };
    (@initial_tangent) => {
        fn initial_tangent(&self, tangent: &mut [f64]) {
            self.inner.initial_tangent(tangent);
        }
    };
    (@mass) => {
        fn mass(&self) -> $crate::element::Mass {
            self.inner.mass()
        }
    };
    (@inertance) => {
        fn inertance(&self) -> Option<Vec<f64>> {
            self.inner.inertance()
        }
    };
    (@has_own_damping) => {
        fn has_own_damping(&self) -> bool {
            self.inner.has_own_damping()
        }
    };
    (@renews_tangent) => {
        fn renews_tangent(&self) -> bool {
            self.inner.renews_tangent()
        }
    };
    // A wrapper is evaluated by itself.
    (@lockstep) => {
        fn lockstep(
            &self,
            _: &[&std::sync::Arc<dyn $crate::element::Element>; $crate::numeric::wide::WIDTH],
        ) -> Option<Box<dyn $crate::element::LockstepElement>> {
            None
        }
    };
    (@load_len) => {
        fn load_len(&self) -> usize {
            self.inner.load_len()
        }
    };
    (@add_load) => {
        fn add_load(
            &self,
            load: &$crate::element::ElementLoad,
            factor: f64,
            sums: &mut [f64],
        ) -> Result<(), $crate::element::ElementError> {
            self.inner.add_load(load, factor, sums)
        }
    };
    (@basic_rows) => {
        fn basic_rows(&self) -> Vec<$crate::element::BasicRow> {
            self.inner.basic_rows()
        }
    };
    (@add_own_damping) => {
        fn add_own_damping(&self, s: &$crate::element::Snapshot<'_>, factor: f64, force: &mut [f64]) {
            let state = &s.state[..self.inner_len];
            self.inner.add_own_damping(&$crate::element::Snapshot { state, ..*s }, factor, force);
        }
    };
    (@overload) => {
        fn overload(&self, history: &[f64]) -> Option<$crate::element::Overload> {
            self.inner.overload(&history[..self.inner_len])
        }
    };
    (@softening) => {
        fn softening(&self, history: &[f64]) -> Option<$crate::element::Softening> {
            self.inner.softening(&history[..self.inner_len])
        }
    };
    (@stretch) => {
        fn stretch(&self, disp: &[f64]) -> Option<$crate::element::Stretch> {
            self.inner.stretch(disp)
        }
    };
    (@exhausted) => {
        fn exhausted(&self, history: &[f64]) -> Option<String> {
            self.inner.exhausted(&history[..self.inner_len])
        }
    };
    (@outside_range) => {
        fn outside_range(&self, history: &[f64]) -> Option<$crate::element::OutsideRange> {
            self.inner.outside_range(&history[..self.inner_len])
        }
    };
    (@euler_load) => {
        fn euler_load(&self) -> Option<f64> {
            self.inner.euler_load()
        }
    };
    (@probe) => {
        fn probe(&self, words: &[&str]) -> Option<$crate::probe::Probe> {
            self.inner.probe(words)
        }
    };
    (@probe_names) => {
        fn probe_names(&self) -> &'static [&'static str] {
            self.inner.probe_names()
        }
    };
    (@all_probe_names) => {
        fn all_probe_names(&self) -> Vec<&'static str> {
            self.inner.all_probe_names()
        }
    };
    (@force_labels) => {
        fn force_labels(&self) -> Vec<String> {
            self.inner.force_labels()
        }
    };
}

pub(crate) use forward_to_inner;
