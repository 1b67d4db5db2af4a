//! Numbers and texts as bytes that keep every bit: for states and journals that are written to files.
//!
//! Numbers are little-endian. A row or a text stands behind its length, 8 bytes.

/// FNV-1a: 64 bits that are the same on every machine. They tell damage, and no intent.
pub fn checksum<'a>(bytes: impl IntoIterator<Item = &'a u8>) -> u64 {
    bytes.into_iter().fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(*b)).wrapping_mul(0x0100_0000_01b3))
}

/// Numbers and texts one after the other.
#[derive(Clone, Debug, Default)]
pub struct Writer(pub Vec<u8>);

impl Writer {
    /// Append a number.
    pub fn number(&mut self, x: u64) {
        self.0.extend(x.to_le_bytes());
    }

    /// Append a number by its bits.
    pub fn float(&mut self, x: f64) {
        self.number(x.to_bits());
    }

    /// Append bytes behind their length.
    pub fn bytes(&mut self, bytes: &[u8]) {
        self.number(bytes.len() as u64);
        self.0.extend(bytes);
    }

    /// Append bytes behind their length, with their checksum after them.
    pub fn block(&mut self, bytes: &[u8]) {
        self.bytes(bytes);
        self.number(checksum(bytes));
    }

    /// Append numbers behind their count.
    pub fn row(&mut self, row: impl ExactSizeIterator<Item = u64>) {
        self.number(row.len() as u64);
        row.for_each(|x| self.number(x));
    }

    /// Append numbers by their bits, behind their count.
    pub fn floats(&mut self, row: &[f64]) {
        self.row(row.iter().map(|x| x.to_bits()));
    }
}

/// Reads what a [`Writer`] has written. Every method returns `None` where the bytes end before.
#[derive(Clone, Copy, Debug)]
pub struct Reader<'a>(pub &'a [u8]);

impl<'a> Reader<'a> {
    /// The next byte.
    pub fn byte(&mut self) -> Option<u8> {
        let (first, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(*first)
    }

    /// The next number.
    pub fn number(&mut self) -> Option<u64> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(u64::from_le_bytes(*first))
    }

    /// The next number by its bits.
    pub fn float(&mut self) -> Option<f64> {
        self.number().map(f64::from_bits)
    }

    /// The next bytes.
    pub fn bytes(&mut self) -> Option<&'a [u8]> {
        let n = usize::try_from(self.number()?).ok()?;
        let (first, rest) = self.0.split_at_checked(n)?;
        self.0 = rest;
        Some(first)
    }

    /// The next block; `None` for a damaged one too.
    pub fn block(&mut self) -> Option<&'a [u8]> {
        let bytes = self.bytes()?;
        (self.number()? == checksum(bytes)).then_some(bytes)
    }

    /// The next text.
    pub fn text(&mut self) -> Option<String> {
        String::from_utf8(self.bytes()?.to_vec()).ok()
    }

    /// The next row.
    pub fn row(&mut self) -> Option<Vec<u64>> {
        // A count that is damaged allocates nothing.
        let n = usize::try_from(self.number()?).ok().filter(|n| n.checked_mul(8).is_some_and(|b| b <= self.0.len()))?;
        (0..n).map(|_| self.number()).collect()
    }

    /// The next row of numbers by their bits.
    pub fn floats(&mut self) -> Option<Vec<f64>> {
        Some(self.row()?.into_iter().map(f64::from_bits).collect())
    }
}
