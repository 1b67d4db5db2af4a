//! The calls that a model was told, from which another one like it is made.

use hysteron_opensees::effect::{Effect, effect};
use hysteron_opensees::run::Run;
use hysteron_opensees::{Command, Continued};
use hysteron_tcl::{Exception, Form, Value};

/// Words that are kept at most: some 30 MB. A model that was told more cannot be copied.
const MAX_WORDS: usize = 1_000_000;

/// The command whose calls follow each other in loops.
const ANALYZE: &str = "analyze";

/// A command with its words, and how often it was called one after the other.
struct Told {
    command: &'static Command,
    words: Vec<Value>,
    times: u64,
}

/// The calls since the model was empty that made it what it is.
#[derive(Default)]
pub(crate) struct CallLog {
    calls: Vec<Told>,
    /// Number of words of the calls.
    words: usize,
    /// Number and length of the steps of the last call, where it is an analysis that was gone on with.
    last_steps: Option<(usize, Option<f64>)>,
    /// Reason for which the calls do not make the model again.
    lost: Option<&'static str>,
}

impl CallLog {
    /// Take a call that was accepted.
    pub(crate) fn add(&mut self, command: &'static Command, words: Vec<Value>) {
        match effect(command, words.get(1)) {
            Effect::Asks | Effect::Nothing => return,
            Effect::Empties => {
                *self = Self::default();
                return;
            }
            Effect::ReadsState => self.lost = Some("it has read a state from a database"),
            Effect::Changes => {}
        }
        self.last_steps = steps_of(command, &words);
        if self.lost.is_some() {
            return;
        }
        if let Some(last) = self.calls.last_mut()
            && std::ptr::eq(last.command, command)
            && command.name == ANALYZE
            && is_same(&last.words, &words)
        {
            last.times += 1;
            return;
        }
        self.words += words.len();
        if self.words > MAX_WORDS {
            self.lose("it was told more than a million words");
            return;
        }
        self.calls.push(Told { command, words, times: 1 });
    }

    /// Take an analysis, or another call that may be interrupted.
    pub(crate) fn analysed(&mut self, command: &'static Command, words: Vec<Value>, is_interrupted: bool) {
        if is_interrupted {
            self.lose("a call was interrupted");
        } else {
            self.add(command, words);
        }
    }

    /// Take steps of an analysis that goes on, as the last call made them. `false` if the last call was another one.
    pub(crate) fn again(&mut self, steps: usize, dt: Option<f64>) -> bool {
        let is_same =
            self.last_steps.is_some_and(|(n, last)| n == steps && last.map(f64::to_bits) == dt.map(f64::to_bits));
        match self.calls.last_mut() {
            Some(last) if is_same => last.times += 1,
            _ => return self.lost.is_some(),
        }
        true
    }

    /// The calls do not make the model again from here on, until it is wiped.
    pub(crate) fn lose(&mut self, reason: &'static str) {
        *self = Self { lost: Some(reason), ..Self::default() };
    }

    /// Reason for which the calls do not make the model again.
    pub(crate) fn lost(&self) -> Option<&'static str> {
        self.lost
    }

    /// The same calls with words of their own: nothing is shared between two models.
    pub(crate) fn anew(&self) -> Self {
        let calls = self.calls.iter().map(|c| Told { words: c.words.iter().map(anew).collect(), ..*c }).collect();
        Self { calls, ..*self }
    }

    /// Make the calls.
    ///
    /// # Errors
    /// A call is not accepted, with the name of its command.
    pub(crate) fn make(&self, run: &mut Run) -> Result<(), (&'static str, Exception)> {
        for told in &self.calls {
            for _ in 0..told.times {
                Self::make_one(told, run).map_err(|e| (told.command.name, e))?;
            }
        }
        Ok(())
    }

    fn make_one(told: &Told, run: &mut Run) -> Result<Value, Exception> {
        if let Some((steps, dt)) = steps_of(told.command, &told.words)
            && let Some(again) = run.continue_analysis(steps, dt)
        {
            return match again {
                Continued::Silent => Ok(Value::EMPTY),
                Continued::Told(done) => run.conclude(done, &told.words),
            };
        }
        run.call(told.command, &told.words)
    }
}

/// Number and length of the steps of an analysis.
fn steps_of(command: &Command, words: &[Value]) -> Option<(usize, Option<f64>)> {
    let steps = words.get(1).filter(|_| command.name == ANALYZE && words.len() <= 3)?.to_i64().ok()?;
    let dt = words.get(2).map(Value::to_f64).transpose().ok()?;
    Some((usize::try_from(steps).ok()?, dt))
}

fn is_same(a: &[Value], b: &[Value]) -> bool {
    // The first is the name of the command.
    a.len() == b.len() && a.iter().zip(b).skip(1).all(|(a, b)| a.as_str() == b.as_str())
}

fn anew(value: &Value) -> Value {
    match value.form() {
        Form::Empty => Value::EMPTY,
        Form::Int(i) => Value::from(i),
        Form::Double(x) => Value::from(x),
        Form::Text(text) => Value::from(&*text),
        Form::List(items) | Form::Dict(items) => Value::list(items.iter().map(anew).collect::<Vec<_>>()),
    }
}
