//! Methods of laws of several stresses that are nothing special.

/// Writes the named methods of [`Multiaxial`](super::Multiaxial) for a law of so many stresses: symmetric, independent of
/// time and size, without bars, and without responses of its own.
macro_rules! plain_methods {
    ($n:ident: $($method:ident)*) => {
        $($crate::material::multiaxial::plain_methods::plain_methods!(@$method $n);)*
    };
    (@is_symmetric $n:ident) => {
        fn is_symmetric(&self) -> bool {
            true
        }
    };
    (@depends_on_time $n:ident) => {
        fn depends_on_time(&self) -> bool {
            false
        }
    };
    (@reinforcement $n:ident) => {
        fn reinforcement(&self) -> f64 {
            0.0
        }
    };
    (@shown_stress $n:ident) => {
        fn shown_stress(&self, _: &[f64], stress: [f64; $n]) -> [f64; $n] {
            stress
        }
    };
    (@of_length $n:ident) => {
        fn of_length(&self, _: f64) -> Option<$crate::material::SharedMultiaxial<$n>> {
            None
        }
    };
    (@probe $n:ident) => {
        fn probe(&self, _: &[&str]) -> Option<$crate::probe::Probe> {
            None
        }
        fn read(&self, _: &[u32], _: &[f64], _: &mut [f64]) {}
    };
}

pub(crate) use plain_methods;

/// Writes the named methods of a law around another, which are those of the other: `storage` of the state, whether it
/// `is_linear` and `is_symmetric`, its other constant `properties`, and its `responses`.
macro_rules! inner_methods {
    ($inner:ident: $($method:ident)*) => {
        $($crate::material::multiaxial::plain_methods::inner_methods!(@$method $inner);)*
    };
    (@storage $inner:ident) => {
        fn state_len(&self) -> usize {
            self.$inner.state_len()
        }
        fn init(&self, state: &mut [f64]) {
            self.$inner.init(state);
        }
    };
    (@is_linear $inner:ident) => {
        fn is_linear(&self) -> bool {
            self.$inner.is_linear()
        }
    };
    (@is_symmetric $inner:ident) => {
        fn is_symmetric(&self) -> bool {
            self.$inner.is_symmetric()
        }
    };
    (@properties $inner:ident) => {
        fn depends_on_time(&self) -> bool {
            self.$inner.depends_on_time()
        }
        fn density(&self) -> f64 {
            self.$inner.density()
        }
        fn reinforcement(&self) -> f64 {
            self.$inner.reinforcement()
        }
    };
    (@responses $inner:ident) => {
        fn probe(&self, words: &[&str]) -> Option<$crate::probe::Probe> {
            self.$inner.probe(words)
        }
        fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
            self.$inner.read(path, state, out);
        }
    };
}

pub(crate) use inner_methods;
