//! XML files with a description of their columns.

use super::file::Form;
use super::output::{Group, TIME, TIME_OUTPUT};
use crate::number_format::Style;
use std::fmt::Write as _;

const HEAD: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n <OpenSees\n  \
    xmlns:xsi = \"http://www.w3.org/2001/XMLSchema-instance\"\n  xsi:noNamespaceSchemaLocation = \
    \"http://OpenSees.berkeley.edu/xml-schema/xmlns/OpenSees.xsd\">\n";

/// Text before the rows.
const DATA: &str = "    <Data>\n";

/// OpenSees' `-xml`: an element of XML for each node or element with the names of its columns, and then the rows as text.
#[derive(Debug)]
pub(super) struct Xml {
    style: Style,
    head: String,
}

impl Xml {
    pub(super) fn new(style: Style) -> Self {
        Self { style, head: format!("{HEAD}{DATA}") }
    }
}

/// Text as the value of an attribute or the content of an element.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

impl Form for Xml {
    fn describe(&mut self, groups: &[Group]) {
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
        self.head.push_str(DATA);
    }

    fn head(&self) -> &[u8] {
        self.head.as_bytes()
    }

    fn row(&self, row: &[f64], to: &mut Vec<u8>) {
        to.extend_from_slice(b"        ");
        for x in row {
            self.style.push_bytes(*x, to);
            to.push(b' ');
        }
        to.push(b'\n');
    }

    fn tail(&self) -> &[u8] {
        b"        </Data>\n</OpenSees>\n"
    }
}
