//! Motions of measured files of any format.

use super::Motion;
use hysteron_recordings::check::doubts;
use hysteron_recordings::series::find_channel;
use hysteron_recordings::{Beside, Channel, Measured, UserStatements};

/// Statements of the user about files that do not state them.
#[derive(Clone, Debug, Default)]
pub struct ReadOptions {
    /// Unit, step, quantity, layout.
    pub told: UserStatements,
    /// Names or numbers of the channels that are taken; all accelerations if it is empty.
    pub channels: Vec<String>,
    /// Differentiate velocities and displacements where a file has no accelerations.
    pub differentiate: bool,
}

/// The motions of a file, and what is to be said about them.
#[derive(Clone, Debug, Default)]
pub struct ReadMotions {
    /// One motion for each channel of accelerations.
    pub motions: Vec<Motion>,
    /// Remarks: samples left out or converted, doubts. Each names the file.
    pub notes: Vec<String>,
}

/// The motions of a file: one, or one for each channel of accelerations. `beside` gives the bytes of another file of its
/// folder.
///
/// # Errors
/// A description of the fault: of the file, or a unit, step or quantity that neither the file nor the options give.
pub fn read(name: &str, bytes: &[u8], options: &ReadOptions, beside: Beside<'_>) -> Result<ReadMotions, String> {
    let measured = Measured::read_beside(name, bytes, beside)?;
    let found = measured.accelerations(&options.told, options.differentiate)?;
    let channels = chosen(found.channels, &options.channels)?;
    let mut notes: Vec<String> = measured.notes.iter().chain(&found.notes).map(|n| format!("{name}: {n}")).collect();
    let width = measured.sheet().map_or(0, |s| s.columns.len());
    let mut motions = vec![];
    for channel in channels {
        let s = &channel.series;
        let name = match s.origin.column {
            _ if s.name.is_empty() && s.origin.column.is_none() => name.to_owned(),
            Some(_) if width == 2 => name.to_owned(),
            Some(i) if s.name.is_empty() => format!("{name} column {i}"),
            _ => format!("{name} {}", s.name),
        };
        notes.extend(doubts(&channel).into_iter().map(|d| format!("{name}: {d}")));
        let (title, azimuth, dt) = (s.title.clone(), s.azimuth, channel.dt);
        motions.push(Motion { name, title, azimuth, dt, acceleration: channel.values });
    }
    Ok(ReadMotions { motions, notes })
}

/// The channels of these names, directions or numbers, in this order.
fn chosen(all: Vec<Channel>, which: &[String]) -> Result<Vec<Channel>, String> {
    if which.is_empty() {
        return Ok(all);
    }
    let find = |word: &String| Ok(all[find_channel(all.iter().map(|c| &c.series), word)?].clone());
    which.iter().map(find).collect()
}

#[cfg(test)]
mod tests {
    use super::{ReadOptions, read};
    use hysteron_recordings::UserStatements;

    fn one(text: &str) -> super::Motion {
        read("f", text.as_bytes(), &ReadOptions::default(), &|_| None).expect("a motion").motions.remove(0)
    }

    #[test]
    fn at2_in_g_with_its_azimuth() {
        let text = "PEER NGA STRONG MOTION DATABASE RECORD\nNorthridge-01, 1/17/1994, Castaic - Old Ridge Route, 090\n\
                    ACCELERATION TIME SERIES IN UNITS OF G\nNPTS=  3, DT= .0200 SEC\n 0.1 -0.2\n .3\n";
        let m = one(text);
        assert_eq!((m.azimuth, m.dt, m.acceleration.len()), (Some(90.0), 0.02, 3));
        assert!((m.acceleration[1] + 1.96133).abs() < 1e-9);
        let head =
            "IMPERIAL VALLEY 5/19/40, EL CENTRO ARRAY #9, 180 (USGS STATION 117)\nNPTS=  2, DT= .01 SEC\n.1 .2\n";
        assert_eq!(one(head).azimuth, Some(180.0));
        let head = "1559 points, 8F10.5, i.e., 8 points across\nNPTS=  2, DT= .01 SEC\n.1 .2\n";
        assert_eq!(one(head).azimuth, None);
    }

    #[test]
    fn v2_with_two_channels() {
        let channel = |deg: u32| {
            format!(
                "CORRECTED ACCELEROGRAM\nCHAN  1:  {deg} DEG\n    4 POINTS OF ACCEL DATA EQUALLY SPACED AT  .010 SEC.\n\
                 {:>10}{:>10}{:>10}{:>10}\n    4 POINTS OF VELOC DATA EQUALLY SPACED AT  .010 SEC.\n{:>10}\n",
                1.0, -200.0, 3.0, 4.0, 9.0
            )
        };
        let text = channel(270) + &channel(360);
        let m = read("f", text.as_bytes(), &ReadOptions::default(), &|_| None).expect("motions").motions;
        assert_eq!((m.len(), m[0].azimuth, m[1].azimuth), (2, Some(270.0), Some(360.0)));
        assert!((m[1].acceleration[1] + 2.0).abs() < 1e-12 && m[0].acceleration.len() == 4);
    }

    #[test]
    fn tables_with_units_in_names_or_options() {
        let m = one("time_s,acc_g\n0,0.1\n0.01,0.2\n0.02,0.3\n");
        assert!((m.acceleration[0] - 0.980665).abs() < 1e-12 && (m.dt - 0.01).abs() < 1e-12);
        let m = one("t[s],a[cm/s2]\n0,1\n0.5,2\n");
        assert!((m.acceleration[1] - 0.02).abs() < 1e-12);
        let options = |unit: &str, dt| ReadOptions {
            told: UserStatements { unit: Some(unit.into()), dt, ..UserStatements::default() },
            ..ReadOptions::default()
        };
        let wrapped =
            read("f", b"0.1 0.2 0.3\n0.4 0.5\n", &options("g", Some(0.02)), &|_| None).expect("a motion").motions;
        assert_eq!((wrapped[0].acceleration.len(), wrapped[0].dt), (5, 0.02));
        let told = |text: &str, o: &ReadOptions| read("f", text.as_bytes(), o, &|_| None).expect_err("a fault");
        assert!(told("0 1\n1 2\n2 3\n", &ReadOptions::default()).contains("--unit"));
        assert!(told("1\n2\n", &options("g", None)).contains("--dt"));
        assert!(told("1\n2\n", &options("gg", None)).contains("gg"));
        assert!(told("t,a[g]\n0,1\n1,2\n5,3\n", &ReadOptions::default()).contains("equal steps"));
    }
}
