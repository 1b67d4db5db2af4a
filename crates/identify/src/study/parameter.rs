//! Parameters of a study, and the mapping between the unit cube and their physical values.

use exmex::prelude::*;
use std::fmt;

/// Scale on which a parameter is spread over its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Uniform in the value.
    Linear,
    /// Uniform in the logarithm of the value.
    Log,
}

/// Range of a free parameter. The prior is uniform over it on its scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterRange {
    /// Least value.
    pub lower: f64,
    /// Greatest value.
    pub upper: f64,
    /// Scale between the bounds.
    pub scale: Scale,
}

impl ParameterRange {
    /// The value at a unit coordinate, from 0 at the lower to 1 at the upper bound.
    pub fn value(&self, unit_coordinate: f64) -> f64 {
        let x = match self.scale {
            Scale::Linear => self.lower + (self.upper - self.lower) * unit_coordinate,
            Scale::Log => self.lower * (self.upper / self.lower).powf(unit_coordinate),
        };
        x.clamp(self.lower, self.upper)
    }

    /// The unit coordinate of a value. Values outside of the range have coordinates below 0 or above 1.
    pub fn unit_coordinate(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => (value - self.lower) / (self.upper - self.lower),
            Scale::Log => (value / self.lower).ln() / (self.upper / self.lower).ln(),
        }
    }

    /// Derivative of the value with respect to the unit coordinate.
    pub fn slope(&self, unit_coordinate: f64) -> f64 {
        match self.scale {
            Scale::Linear => self.upper - self.lower,
            Scale::Log => self.value(unit_coordinate) * (self.upper / self.lower).ln(),
        }
    }
}

/// Origin of the value of a parameter.
#[derive(Clone, Debug)]
pub enum ParameterKind {
    /// The value is identified within a range.
    Free(ParameterRange),
    /// The value is a constant of the study.
    Fixed(f64),
    /// The value is a formula of other parameters.
    Tied {
        /// The formula as it was written.
        text: String,
        /// The parsed formula.
        formula: Box<FlatEx<f64>>,
        /// Indices of the parameters in the formula, in its order.
        arguments: Vec<usize>,
        /// Least and greatest allowed value.
        bounds: (f64, f64),
    },
}

/// A parameter of a script.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name in the script: `pset NAME VALUE`.
    pub name: String,
    /// Origin of its value.
    pub kind: ParameterKind,
}

/// The error of a tied parameter whose formula gives no number, or one outside of its range.
#[derive(Clone, Debug, PartialEq)]
pub struct OutOfRange {
    /// Name of the parameter.
    pub name: String,
    /// Value of its formula.
    pub value: f64,
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} comes to {}, outside of its range", self.name, self.value)
    }
}

/// All parameters of a study. The free ones span a unit cube.
#[derive(Clone, Debug, Default)]
pub struct ParameterSpace {
    /// Parameters in the order of the study.
    pub parameters: Vec<Parameter>,
    /// Indices of the tied parameters, each after its arguments.
    tied_order: Vec<usize>,
}

impl ParameterSpace {
    /// A space of parameters.
    ///
    /// # Errors
    /// The index of a tied parameter that depends on itself.
    pub fn new(parameters: Vec<Parameter>) -> Result<Self, usize> {
        let mut is_evaluated: Vec<bool> =
            parameters.iter().map(|p| !matches!(p.kind, ParameterKind::Tied { .. })).collect();
        let mut tied_order = vec![];
        loop {
            let is_ready = |i: usize| match &parameters[i].kind {
                ParameterKind::Tied { arguments, .. } => !is_evaluated[i] && arguments.iter().all(|j| is_evaluated[*j]),
                _ => false,
            };
            let Some(next) = (0..parameters.len()).find(|i| is_ready(*i)) else { break };
            is_evaluated[next] = true;
            tied_order.push(next);
        }
        match is_evaluated.iter().position(|e| !e) {
            Some(cyclic) => Err(cyclic),
            None => Ok(Self { parameters, tied_order }),
        }
    }

    /// The free parameters: index and range.
    pub fn free(&self) -> impl Iterator<Item = (usize, &ParameterRange)> + Clone {
        self.parameters.iter().enumerate().filter_map(|(i, p)| match &p.kind {
            ParameterKind::Free(range) => Some((i, range)),
            _ => None,
        })
    }

    /// Names of the free parameters.
    pub fn free_names(&self) -> impl Iterator<Item = &str> + Clone {
        self.free().map(|(i, _)| self.parameters[i].name.as_str())
    }

    /// Number of free parameters.
    pub fn dimension(&self) -> usize {
        self.free().count()
    }

    /// Values of all parameters at a point of the unit cube.
    ///
    /// # Errors
    /// The formula of a tied parameter gives no number, or one outside of its range.
    pub fn values_at(&self, unit_point: &[f64]) -> Result<Vec<f64>, OutOfRange> {
        let mut values = vec![0.0; self.parameters.len()];
        for ((i, range), unit_coordinate) in self.free().zip(unit_point) {
            values[i] = range.value(*unit_coordinate);
        }
        for (v, p) in values.iter_mut().zip(&self.parameters) {
            if let ParameterKind::Fixed(x) = p.kind {
                *v = x;
            }
        }
        for i in &self.tied_order {
            let ParameterKind::Tied { formula, arguments, bounds, .. } = &self.parameters[*i].kind else { continue };
            let arguments: Vec<f64> = arguments.iter().map(|j| values[*j]).collect();
            let value = formula.eval(&arguments).unwrap_or(f64::NAN);
            if !(bounds.0..=bounds.1).contains(&value) || !value.is_finite() {
                return Err(OutOfRange { name: self.parameters[*i].name.clone(), value });
            }
            values[*i] = value;
        }
        Ok(values)
    }

    /// The point of the unit cube for values of all parameters. Values outside of a range are moved to its bound.
    pub fn unit_point(&self, values: &[f64]) -> Vec<f64> {
        let unit_coordinate = |(i, range): (usize, &ParameterRange)| {
            let x = range.unit_coordinate(values[i]);
            if x.is_finite() { x.clamp(0.0, 1.0) } else { 0.5 }
        };
        self.free().map(unit_coordinate).collect()
    }
}
