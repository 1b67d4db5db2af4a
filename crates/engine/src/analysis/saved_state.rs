//! The committed state as data that can be kept, written and read.

use super::engine::Engine;
use super::state::State;
use crate::bytes::{Reader, Writer, checksum};
use crate::model::{Model, Tag};

/// First bytes of a state that has been written.
const MAGIC: &[u8; 8] = b"hystst\x00\x01";

/// A committed state, with the load factors that are held.
#[derive(Clone, Debug, Default)]
pub struct SavedState {
    state: State,
    /// Held load factor of each pattern, by tag.
    held: Vec<(Tag, Option<f64>)>,
    /// Tags and sizes of the nodes and elements that it belongs to.
    shape: Vec<u64>,
}

/// Tags and sizes of nodes and elements: a state fits a model of the same shape.
fn shape(model: &Model) -> Vec<u64> {
    let nodes = model.nodes.iter().flat_map(|n| [n.tag as u64, n.ndf as u64]);
    let elements = model.elements.iter().flat_map(|e| {
        let class = checksum(e.element.class().name.as_bytes());
        [e.tag as u64, class, e.state.len() as u64, e.force.len() as u64]
    });
    [model.nodes.len() as u64].into_iter().chain(nodes).chain(elements).collect()
}

impl Engine {
    /// The committed state. What is remembered of earlier steps is forgotten, so that this run goes on to the same bits as one
    /// that restores the state.
    pub fn save(&mut self) -> SavedState {
        self.forget_work();
        SavedState {
            state: self.state().clone(),
            held: self.model().patterns.iter().map(|(tag, p)| (*tag, p.held)).collect(),
            shape: shape(self.model()),
        }
    }

    /// Go back to a state. Patterns that it does not know stay as they are. Integrators with a memory of earlier steps begin
    /// anew.
    ///
    /// # Errors
    /// It is that of another model.
    pub fn restore_saved(&mut self, saved: SavedState) -> Result<(), String> {
        if saved.shape != shape(self.model()) {
            return Err("it belongs to a model with other nodes or elements".into());
        }
        let held = saved.held;
        self.change_model(|m| {
            for (tag, held) in held {
                if let Some(pattern) = m.patterns.get_mut(&tag) {
                    pattern.held = held;
                }
            }
        });
        self.restore(&saved.state);
        Ok(())
    }
}

impl SavedState {
    /// The state as bytes, which keep every bit. They end with a checksum.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut w = Writer(MAGIC.to_vec());
        let s = &self.state;
        w.row(self.shape.iter().copied());
        w.floats(&[s.time]);
        for row in [&s.disp, &s.vel, &s.accel, &s.history, &s.force, &s.element_load, &s.multipliers, &s.shared] {
            w.floats(row);
        }
        w.row(self.held.iter().map(|(tag, _)| *tag as u64));
        w.row(self.held.iter().map(|(_, held)| u64::from(held.is_some())));
        w.floats(&self.held.iter().map(|(_, held)| held.unwrap_or(0.0)).collect::<Vec<_>>());
        let sum = checksum(&w.0);
        w.number(sum);
        w.0
    }

    /// A state from its bytes; `None` if they are none, or damaged.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (content, sum) = bytes.split_last_chunk()?;
        if checksum(content) != u64::from_le_bytes(*sum) {
            return None;
        }
        let mut r = Reader(content.strip_prefix(MAGIC)?);
        let shape = r.row()?;
        let [time] = r.floats()?[..] else { return None };
        let [disp, vel, accel, history] = [r.floats()?, r.floats()?, r.floats()?, r.floats()?];
        let [force, element_load, multipliers, shared] = [r.floats()?, r.floats()?, r.floats()?, r.floats()?];
        let (tags, is_held, values) = (r.row()?, r.row()?, r.floats()?);
        let held = tags.iter().zip(is_held).zip(values);
        let held = held.map(|((tag, is_held), value)| (*tag as Tag, (is_held != 0).then_some(value)));
        let state = State { time, disp, vel, accel, history, force, element_load, multipliers, shared };
        Some(Self { state, held: held.collect(), shape })
    }
}

#[cfg(test)]
mod tests {
    use super::{SavedState, State};

    #[test]
    fn bytes_keep_every_bit_and_damage_is_seen() {
        let state = State { time: -0.0, disp: vec![f64::MIN_POSITIVE / 3.0, 1.0 / 3.0], ..State::default() };
        let saved = SavedState { state, held: vec![(-3, Some(0.1)), (4, None)], shape: vec![1, 2] };
        let bytes = saved.to_bytes();
        let read = SavedState::from_bytes(&bytes).expect("whole");
        assert_eq!(read.to_bytes(), bytes);
        assert!(read.state.time.is_sign_negative() && read.held == saved.held);
        for i in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[i] ^= 0x10;
            assert!(SavedState::from_bytes(&damaged).is_none() && SavedState::from_bytes(&bytes[..i]).is_none(), "{i}");
        }
    }
}
