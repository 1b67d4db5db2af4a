//! One reader of everything measured: ground motions, tests, sensors, tables.
//!
//! A measured series is data with its meaning: quantity, unit, times, channel, direction, station, event, and the place in
//! its file. Nothing of that is guessed. It is known from the format, the header, the name of a column with a unit, or
//! told by the user ([`UserStatements`]); otherwise the fault shows the header and what to say.
//!
//! [`Measured::read`] recognises the format ([`FORMATS`]). [`Measured::series`] gives the channels,
//! [`Measured::accelerations`] those of a motion in m/s², [`Table`] the columns as written, [`Recording`] the channels of a
//! study.
#![forbid(unsafe_code)]

mod archive;
pub mod check;
mod content;
pub mod convert;
pub mod export;
pub mod fault;
mod format;
mod interpret;
mod measured;
mod motion;
mod number;
mod recording;
pub mod series;
pub mod sheet;
mod stated;
mod table;
pub mod text;
pub mod unit;
pub mod user_statements;
mod way;

pub use content::MAX_UNPACKED;
pub use fault::Fault;
pub use format::{Beside, FORMATS, Format};
pub use measured::Measured;
pub use motion::{Channel, Channels};
pub use recording::{Column, Recording};
pub use series::{Clock, Origin, Series};
pub use sheet::Sheet;
pub use table::Table;
pub use user_statements::{Layout, Statement, UserStatements, Way};
