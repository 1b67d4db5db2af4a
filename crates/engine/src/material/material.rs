//! A uniaxial material as elements hold it: the law, and what it was made from.

use super::{CHARACTERISTIC_LENGTH, Uniaxial};
use crate::parameter::{Changed, NewValue, ParameterError, existing};
use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

/// A law of any kind, whose parameters are shared.
pub type SharedUniaxial = Arc<dyn Uniaxial>;

/// The numbers that a law was made from, by which it is made again with another value of one.
pub trait Recipe: fmt::Debug + Send + Sync {
    /// Names of the numbers with their values. The second of two numbers of a name has its option before the name.
    fn numbers(&self) -> Vec<(String, f64)>;

    /// The value of the number of a name, which may be another than that of [`Recipe::numbers`].
    fn number(&self, name: &str) -> Option<f64>;

    /// The law with another value of the number of a name, and its recipe.
    ///
    /// # Errors
    /// There is no number of that name, or the law cannot be made with the value.
    fn with_number(&self, name: &str, value: f64) -> Result<(SharedUniaxial, Arc<dyn Recipe>), ParameterError>;
}

/// The recipe of a law, and the changes of the law itself since.
#[derive(Clone, Debug)]
struct Origin {
    recipe: Arc<dyn Recipe>,
    changes: Vec<(Vec<String>, NewValue)>,
}

/// A material as elements hold it: the parameters are shared, the state is stored by the element.
#[derive(Clone, Debug)]
pub struct Material {
    law: SharedUniaxial,
    origin: Option<Arc<Origin>>,
}

crate::watches_columns!(Material => |m| in m.law.roles().columns);

impl Material {
    /// The material of a law.
    pub fn new(law: impl Uniaxial + 'static) -> Self {
        Self { law: Arc::new(law), origin: None }
    }

    /// The material with the recipe of its law.
    #[must_use]
    pub fn made_by(mut self, recipe: Arc<dyn Recipe>) -> Self {
        self.origin = Some(Arc::new(Origin { recipe, changes: vec![] }));
        self
    }

    /// The law alone.
    pub fn law(&self) -> &SharedUniaxial {
        &self.law
    }

    /// The material with a new value of a parameter, and the value before. The words are those of a `parameter`
    /// command; no value asks for the present one. The layout of the history does not change.
    ///
    /// # Errors
    /// Neither the law nor its recipe has such a parameter, or the law refuses the value.
    pub fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Self> {
        match self.law.with_parameter(words, value) {
            Err(ParameterError::Unknown) => self.made_again(&words.join(" "), value),
            changed => {
                let (law, before) = changed?;
                Ok((Self { law, origin: self.origin_with(words, value) }, before))
            }
        }
    }

    /// Names of the numbers that the material was made from, with their values.
    pub fn numbers(&self) -> Vec<(String, f64)> {
        self.origin.as_ref().map_or_else(Vec::new, |origin| origin.recipe.numbers())
    }

    /// The origin after a change of the law itself.
    fn origin_with(&self, words: &[&str], value: NewValue) -> Option<Arc<Origin>> {
        let Some(origin) = self.origin.as_deref().filter(|_| value != NewValue::Present) else {
            return self.origin.clone();
        };
        let mut new = origin.clone();
        new.changes.push((words.iter().map(|w| (*w).to_owned()).collect(), value));
        Some(Arc::new(new))
    }

    fn made_again(&self, name: &str, value: NewValue) -> Changed<Self> {
        let origin = existing(self.origin.as_deref())?;
        let before = existing(origin.recipe.number(name))?;
        let Some(value) = value.instead_of(before) else { return Ok((self.clone(), before)) };
        let (mut law, recipe) = origin.recipe.with_number(name, value)?;
        for (words, value) in &origin.changes {
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            law = law.with_parameter(&words, *value)?.0;
        }
        if law.state_len() != self.law.state_len() {
            let message = format!("{} keeps another number of state variables with {name}", self.law.name());
            return Err(ParameterError::Refused(message));
        }
        let changes = origin.changes.clone();
        Ok((Self { law, origin: Some(Arc::new(Origin { recipe, changes })) }, before))
    }
}

impl Deref for Material {
    type Target = dyn Uniaxial;

    #[inline(always)]
    fn deref(&self) -> &Self::Target {
        self.law.as_ref()
    }
}

impl From<SharedUniaxial> for Material {
    fn from(law: SharedUniaxial) -> Self {
        Self { law, origin: None }
    }
}

impl<L: Uniaxial + 'static> From<Arc<L>> for Material {
    fn from(law: Arc<L>) -> Self {
        Self { law, origin: None }
    }
}

/// The material for a bar of a length.
pub fn of_length(material: Material, length: f64) -> Material {
    material.with_parameter(&[CHARACTERISTIC_LENGTH], NewValue::Is(length)).map_or(material, |(made, _)| made)
}
