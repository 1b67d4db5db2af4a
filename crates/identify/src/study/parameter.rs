//! Parameters of a study, and the way from a point of the unit cube to their values.

use exmex::prelude::*;
use std::fmt;

/// How a parameter is spread over its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// Its logarithm evenly.
    Log,
}

/// What a parameter may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Least value.
    pub lower: f64,
    /// Greatest value.
    pub upper: f64,
    /// How it is spread in between.
    pub scale: Scale,
}

impl Range {
    /// The value at a place from 0 (least) to 1 (greatest).
    pub fn value(&self, place: f64) -> f64 {
        let x = match self.scale {
            Scale::Linear => self.lower + (self.upper - self.lower) * place,
            Scale::Log => self.lower * (self.upper / self.lower).powf(place),
        };
        x.clamp(self.lower, self.upper)
    }

    /// The place of a value; beyond 0 and 1 outside of the range.
    pub fn place(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => (value - self.lower) / (self.upper - self.lower),
            Scale::Log => (value / self.lower).ln() / (self.upper / self.lower).ln(),
        }
    }

    /// Derivative of the value with respect to the place.
    pub fn slope(&self, place: f64) -> f64 {
        match self.scale {
            Scale::Linear => self.upper - self.lower,
            Scale::Log => self.value(place) * (self.upper / self.lower).ln(),
        }
    }
}

/// Where the value of a parameter comes from.
#[derive(Clone, Debug)]
pub enum Source {
    /// It is to be found.
    Free(Range),
    /// It is given.
    Fixed(f64),
    /// It follows from others.
    Tied {
        /// The formula as it was written.
        text: String,
        /// The formula.
        formula: Box<FlatEx<f64>>,
        /// The parameters that it takes, in its order, by their number.
        of: Vec<usize>,
        /// Least and greatest value that it may come to.
        within: (f64, f64),
    },
}

/// A parameter of a script.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name in the script: `pset NAME VALUE`.
    pub name: String,
    /// Where its value comes from.
    pub source: Source,
}

/// A tied parameter has no value, or one outside of its range.
#[derive(Clone, Debug, PartialEq)]
pub struct Outside {
    /// Its name.
    pub name: String,
    /// What its formula gives.
    pub value: f64,
}

impl fmt::Display for Outside {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} comes to {}, outside of its range", self.name, self.value)
    }
}

/// All parameters of a study. The free ones span a unit cube, in which they are sought.
#[derive(Clone, Debug, Default)]
pub struct Space {
    /// In the order of the study.
    pub parameters: Vec<Parameter>,
    /// Numbers of the tied ones, each after those that it takes.
    order: Vec<usize>,
}

impl Space {
    /// Put parameters in order.
    ///
    /// # Errors
    /// The number of a tied parameter that depends on itself.
    pub fn new(parameters: Vec<Parameter>) -> Result<Self, usize> {
        let mut known: Vec<bool> = parameters.iter().map(|p| !matches!(p.source, Source::Tied { .. })).collect();
        let mut order = vec![];
        loop {
            let ready = |i: usize| match &parameters[i].source {
                Source::Tied { of, .. } => !known[i] && of.iter().all(|j| known[*j]),
                _ => false,
            };
            let Some(next) = (0..parameters.len()).find(|i| ready(*i)) else { break };
            known[next] = true;
            order.push(next);
        }
        match known.iter().position(|k| !k) {
            Some(cyclic) => Err(cyclic),
            None => Ok(Self { parameters, order }),
        }
    }

    /// The free parameters: number and range.
    pub fn free(&self) -> impl Iterator<Item = (usize, &Range)> + Clone {
        self.parameters.iter().enumerate().filter_map(|(i, p)| match &p.source {
            Source::Free(range) => Some((i, range)),
            _ => None,
        })
    }

    /// Number of free parameters.
    pub fn dimension(&self) -> usize {
        self.free().count()
    }

    /// Name of the free parameter of a number.
    pub fn free_name(&self, number: usize) -> &str {
        self.free().nth(number).map_or("", |(i, _)| &self.parameters[i].name)
    }

    /// Values of all parameters at a point of the unit cube.
    ///
    /// # Errors
    /// A tied parameter comes to no number, or to one outside of its range.
    pub fn values(&self, point: &[f64]) -> Result<Vec<f64>, Outside> {
        let mut values = vec![0.0; self.parameters.len()];
        for ((i, range), place) in self.free().zip(point) {
            values[i] = range.value(*place);
        }
        for (v, p) in values.iter_mut().zip(&self.parameters) {
            if let Source::Fixed(x) = p.source {
                *v = x;
            }
        }
        for i in &self.order {
            let Source::Tied { formula, of, within, .. } = &self.parameters[*i].source else { continue };
            let taken: Vec<f64> = of.iter().map(|j| values[*j]).collect();
            let value = formula.eval(&taken).unwrap_or(f64::NAN);
            if !(within.0..=within.1).contains(&value) || !value.is_finite() {
                return Err(Outside { name: self.parameters[*i].name.clone(), value });
            }
            values[*i] = value;
        }
        Ok(values)
    }

    /// The point of the unit cube where the free parameters have these values (of all parameters), moved to its surface
    /// where they are outside of their ranges.
    pub fn point(&self, values: &[f64]) -> Vec<f64> {
        let place = |(i, range): (usize, &Range)| {
            let place = range.place(values[i]);
            if place.is_finite() { place.clamp(0.0, 1.0) } else { 0.5 }
        };
        self.free().map(place).collect()
    }
}
