//! Tables as text: spreadsheets, loggers, test machines, recorders; and lists of numbers alone.

use super::{Format, Input, list};
use crate::content::Content;
use crate::fault::Fault;
use crate::sheet::{Form, Sheet, SheetError};

pub(super) const TABLE: Format = Format {
    name: "table",
    recognised_by: "any other text: rows of as many cells, or numbers alone",
    states: "what the names of the columns say: quantity and unit of acc[g], vel_m/s, Force (kN); time[s], time_ms or dates",
    description: "RFC 4180, with the separators, decimal signs and units that spreadsheets and loggers write; fixed columns of Fortran",
    is: |_| true,
    read,
};

pub(super) const MTS: Format = Format {
    name: "MTS",
    recognised_by: "\"MTS\" and \"|\" in the first line",
    states: "names and units of the columns",
    description: "MTS 793 MultiPurpose TestWare, specimen data file: header lines, names, units, rows between tabs",
    is: |input| input.head.first().is_some_and(|l| l.starts_with("MTS") && l.contains('|')),
    read: sheet_alone,
};

pub(super) const SEISMOSIGNAL: Format = Format {
    name: "SeismoSignal",
    recognised_by: "\"SeismoSignal\", \"SeismoSpect\", \"SeismoMatch\" or \"Seismosoft\" in the header",
    states: "names and units of the columns",
    description: "Seismosoft, SeismoSignal: text output of time series",
    is: |input| ["seismosignal", "seismosoft", "seismomatch", "seismospect"].iter().any(|w| input.has(&[w])),
    read: sheet_alone,
};

fn sheet_alone(input: &Input<'_>) -> Result<Content, Fault> {
    let sheet = Sheet::parse(input.text, &Form { name: input.name, ..Form::default() })?;
    Ok(Content::Table(sheet))
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    match Sheet::parse(input.text, &Form { name: input.name, ..Form::default() }) {
        // One column without a name is a list too, and its header is told apart more strictly.
        Ok(sheet) if sheet.named || sheet.columns.len() > 1 || sheet.rows() == 0 => Ok(Content::Table(sheet)),
        Ok(_) => list::read(input),
        // The list has its own fault; that of the table says more if the list is none either.
        Err(SheetError::List(fault)) => {
            list::read(input).map_err(|of_list| if of_list.line.is_some() { of_list } else { fault })
        }
        Err(SheetError::Fault(fault)) => Err(fault),
    }
}
