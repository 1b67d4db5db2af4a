//! XML files that tell what their columns are.

use super::RecordError;
use super::output::{Group, Output, TIME, TIME_OUTPUT};
use super::place::PlacedFile;
use crate::io::number::Style;
use std::fmt::Write as _;
use std::path::Path;

const HEAD: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n <OpenSees\n  \
    xmlns:xsi = \"http://www.w3.org/2001/XMLSchema-instance\"\n  xsi:noNamespaceSchemaLocation = \
    \"http://OpenSees.berkeley.edu/xml-schema/xmlns/OpenSees.xsd\">\n";

/// A file in the form of OpenSees' `-xml`: an element of XML for each node or element with the names of its columns,
/// and then the rows as text.
#[derive(Debug)]
pub struct XmlFile {
    file: PlacedFile,
    style: Style,
    head: String,
    /// The head has been written, and must be closed.
    begun: bool,
    line: String,
}

impl XmlFile {
    /// Begin a file. With `close_on_write` every row goes to its place at once.
    ///
    /// # Errors
    /// It cannot be made.
    pub fn create(place: &Path, style: Style, close_on_write: bool) -> Result<Self, RecordError> {
        let file = PlacedFile::create(place, close_on_write)?;
        Ok(Self { file, style, head: HEAD.to_owned(), begun: false, line: String::new() })
    }

    fn begin_data(&mut self) -> Result<(), RecordError> {
        if self.begun {
            return Ok(());
        }
        self.begun = true;
        self.file.write(self.head.as_bytes())?;
        self.file.write(b"    <Data>\n")
    }
}

/// Text as the value of an attribute or the content of an element.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

impl Output for XmlFile {
    fn describe(&mut self, groups: &[Group]) -> Result<(), RecordError> {
        // A file has one head: columns that change with the model later on are as in a text file.
        if self.begun {
            return Ok(());
        }
        self.head.clear();
        self.head.push_str(HEAD);
        for group in groups {
            let _ = write!(self.head, "    <{}", group.name);
            for (name, value) in &group.attributes {
                let _ = write!(self.head, " {name}=\"{}\"", escaped(value));
            }
            for (i, x) in group.place.iter().flatten().enumerate() {
                let _ = write!(self.head, " coord{}=\"", i + 1);
                Style { scientific: false, ..self.style }.push(*x, &mut self.head);
                self.head.push('"');
            }
            if group.columns.is_empty() {
                self.head.push_str("/>\n");
                continue;
            }
            self.head.push_str(">\n");
            for column in &group.columns {
                // The time before a column of an envelope stands in an element of its own.
                if column == TIME && group.name != TIME_OUTPUT {
                    let _ = writeln!(self.head, "        <{TIME_OUTPUT}>");
                    let _ = writeln!(self.head, "            <ResponseType>{TIME}</ResponseType>");
                    let _ = writeln!(self.head, "        </{TIME_OUTPUT}>");
                    continue;
                }
                let _ = writeln!(self.head, "        <ResponseType>{}</ResponseType>", escaped(column));
            }
            let _ = writeln!(self.head, "    </{}>", group.name);
        }
        Ok(())
    }

    fn row(&mut self, row: &[f64]) -> Result<(), RecordError> {
        self.begin_data()?;
        self.line.clear();
        self.line.push_str("        ");
        for x in row {
            self.style.push(*x, &mut self.line);
            self.line.push(' ');
        }
        self.line.push('\n');
        self.file.write_row(self.line.as_bytes())
    }

    fn restart(&mut self) -> Result<(), RecordError> {
        self.begun = false;
        self.file.restart()
    }

    fn wants_every_row(&self) -> bool {
        self.file.at_once()
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.file.flush()
    }

    fn finish(&mut self) -> Result<(), RecordError> {
        if self.file.is_open() {
            self.begin_data()?;
            self.file.write(b"        </Data>\n</OpenSees>\n")?;
        }
        self.file.finish()
    }
}

impl Drop for XmlFile {
    fn drop(&mut self) {
        // A recorder that was dropped without an end leaves a whole file all the same.
        let _ = self.finish();
    }
}
