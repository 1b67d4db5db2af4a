//! Buffers of contributions, which are used again: fresh memory costs the system as much as the products in it.

use std::sync::{Mutex, PoisonError};

/// Buffers that nothing is in.
#[derive(Debug, Default)]
pub(super) struct Buffers(Mutex<Vec<Vec<f64>>>);

impl Buffers {
    /// Zeros, in the smallest buffer that has room for them.
    pub(super) fn zeros(&self, len: usize) -> Vec<f64> {
        let mut buffers = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let suits = |b: &(usize, &Vec<f64>)| b.1.capacity() >= len;
        let found = buffers.iter().enumerate().filter(suits).min_by_key(|(_, b)| b.capacity()).map(|(i, _)| i);
        let buffer = found.map(|i| buffers.swap_remove(i));
        drop(buffers);
        let Some(mut buffer) = buffer else { return vec![0.0; len] };
        buffer.clear();
        buffer.resize(len, 0.0);
        buffer
    }

    /// Take back a buffer.
    pub(super) fn give(&self, buffer: Vec<f64>) {
        if buffer.capacity() > 0 {
            self.0.lock().unwrap_or_else(PoisonError::into_inner).push(buffer);
        }
    }
}
