//! A known series written in every format, with spellings by chance.

mod binary;
mod motions;
mod tables;
pub mod zip;

use hysteron_recordings::{Fault, Measured};

/// Random numbers: a linear congruential generator (Knuth, MMIX).
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % n as u64) as usize
    }

    pub fn of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }
}

/// The series that is written.
pub struct Known {
    pub values: Vec<f64>,
    pub dt: f64,
    /// Unit of the values, as `unit` knows it.
    pub unit: &'static str,
}

impl Known {
    /// Some hundred values of a smooth series whose peak is 0.3 in g, or as much in another unit.
    pub fn new(random: &mut Random, n: usize) -> Self {
        let (unit, peak) = random.of(&[("g", 0.3), ("cm/s2", 294.0), ("m/s2", 2.94), ("cm/s", 31.0), ("cm", 8.5)]);
        Self::of(unit, peak, random.of(&[0.01, 0.005, 0.02]), n)
    }

    pub fn of(unit: &'static str, peak: f64, dt: f64, n: usize) -> Self {
        let value = |i: usize| {
            let t = i as f64;
            peak * (0.21 * t).sin() * (0.013 * t + 0.3).cos()
        };
        Self { values: (0..n).map(value).collect(), dt, unit }
    }

    /// The quantity in the words of headers.
    pub fn word(&self) -> &'static str {
        match self.unit {
            "cm/s" => "velocity",
            "cm" => "displacement",
            _ => "acceleration",
        }
    }

    /// The values in a unit of the same quantity; `None` of another.
    pub fn in_unit(&self, unit: &'static str) -> Option<Vec<f64>> {
        let of = |name| hysteron_recordings::unit::unit(name).expect("a unit");
        let (factor, _) = of(self.unit).conversion(&of(unit))?;
        Some(self.values.iter().map(|x| factor * x).collect())
    }
}

/// A file: its name and its bytes, and the index of the first byte of its data.
pub struct File {
    pub name: String,
    pub bytes: Vec<u8>,
    pub data: usize,
    /// Name and bytes of a file beside it that it names.
    pub beside: Option<(String, Vec<u8>)>,
}

impl File {
    pub fn new(name: &str, header: String, data: String) -> Self {
        let at = header.len();
        Self { name: name.to_owned(), bytes: (header + &data).into_bytes(), data: at, beside: None }
    }

    /// Read its bytes, or those that they were changed to.
    pub fn read(&self, bytes: &[u8]) -> Result<Measured, Fault> {
        let of = |name: &str| self.beside.as_ref().filter(|b| b.0 == name).map(|b| b.1.clone());
        Measured::read_beside(&self.name, bytes, &of)
    }
}

/// A writer of a format. `None` if the format has no such quantity.
pub type Writer = fn(&Known, &mut Random) -> Option<File>;

/// Name of the format, and its writer.
pub const WRITERS: &[(&str, Writer)] = &[
    ("PEER", motions::peer),
    ("CSMIP", motions::csmip),
    ("Volume 1", motions::volume1),
    ("COSMOS", motions::cosmos),
    ("SMC", motions::smc),
    ("K-NET", motions::knet),
    ("ESM", motions::esm),
    ("AFAD", motions::afad),
    ("GeoNet", motions::geonet),
    ("table", tables::csv),
    ("MTS", tables::mts),
    ("SeismoSignal", tables::seismosignal),
    ("LabVIEW", tables::labview),
    ("Tcl list", tables::tcl),
    ("counted list", tables::counted),
    ("JSON", tables::json),
    ("NumPy", binary::npy),
    ("MATLAB", binary::mat),
    ("SAC", binary::sac),
    ("miniSEED", binary::miniseed),
    ("DIAdem", binary::diadem),
    ("xlsx", binary::xlsx),
    ("ods", binary::ods),
];
