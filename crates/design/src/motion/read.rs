//! Files of ground motions: PEER AT2, CSMIP V2, COSMOS V2c, tables with and without names.

use super::{G, Motion, cosmos};
use hysteron_identify::study::unit::{self, Quantity};
use hysteron_opensees::files::motion;
use hysteron_opensees::files::table::Table;

/// Kind of quantity that a motion has.
pub(super) const ACCELERATION: Quantity = Quantity::Acceleration;

/// Unit and step of files that do not give them, as the user gives them.
#[derive(Clone, Debug, Default)]
pub struct ReadOptions {
    /// Unit of accelerations where the file gives none.
    pub unit: Option<String>,
    /// Step of time in s where the file gives none.
    pub dt: Option<f64>,
}

/// The motions of a file: one, or one for each channel of accelerations.
///
/// PEER AT2 is in g and CSMIP V2 in cm/s². COSMOS files and the columns of tables name their units.
///
/// # Errors
/// A description of the fault: of the file, or a unit or step that neither the file nor the options give.
pub fn read(name: &str, text: &str, options: &ReadOptions) -> Result<Vec<Motion>, String> {
    let lower = text.to_ascii_lowercase();
    let has = |words: &[&str]| lower.lines().take(80).any(|l| words.iter().all(|w| l.contains(w)));
    let motions = if cosmos::is_cosmos(text) {
        cosmos::parse(name, text)?
    } else if has(&["npts", "dt"]) {
        vec![peer(name, text)?]
    } else if has(&["accel", "spaced at"]) {
        csmip(name, text)?
    } else {
        table(name, text, options)?
    };
    match motions.iter().find(|m| m.acceleration.len() < 2 || m.acceleration.iter().any(|a| !a.is_finite())) {
        Some(m) => Err(format!("{} has fewer than two values, or some that are not finite", m.name)),
        None => Ok(motions),
    }
}

/// AT2: the second line is `event, date, station, component`, whose last word is the azimuth if it is a number.
fn peer(name: &str, text: &str) -> Result<Motion, String> {
    let m = motion::parse(text)?;
    let head: Vec<&str> = text.lines().take(4).map(str::trim).collect();
    let line = head.iter().find(|l| l.matches(',').count() >= 2 && !l.to_ascii_lowercase().contains("npts"));
    let last = line.and_then(|l| l.rsplit(',').next());
    // The component stands alone, or before the name of the station in brackets.
    let word = last.map(|w| w.split('(').next().unwrap_or(w).trim());
    let azimuth = word.and_then(|w| w.trim_start_matches('0').parse().ok().or((w == "000").then_some(0.0)));
    let dt = m.dt.ok_or("the header gives no step of time")?;
    let title = line.map_or("", |l| l).to_owned();
    let azimuth = azimuth.filter(|a| (0.0..=360.0).contains(a));
    let acceleration = m.values.iter().map(|a| G * a).collect();
    Ok(Motion { name: name.to_owned(), title, azimuth, dt, acceleration })
}

/// CSMIP V2: one channel after another, each with a header of 45 lines.
fn csmip(name: &str, text: &str) -> Result<Vec<Motion>, String> {
    let lines: Vec<&str> = text.lines().collect();
    let lower = |l: &str| l.to_ascii_lowercase();
    let is_data = |l: &str| lower(l).contains("accel") && lower(l).contains("spaced at");
    let starts: Vec<usize> = (0..lines.len()).filter(|i| is_data(lines[*i])).collect();
    let mut motions = vec![];
    for (k, &at) in starts.iter().enumerate() {
        let m = motion::parse(&lines[at..].join("\n"))?;
        let from = if k == 0 { 0 } else { starts[k - 1] + 1 };
        let head = &lines[from..at];
        // "CHAN  1:  360 DEG".
        let degrees = |l: &&str| {
            let upper = l.to_ascii_uppercase();
            let before = upper.split("DEG").next().filter(|_| upper.contains("CHAN") && upper.contains("DEG"))?;
            before.split_whitespace().last()?.trim_start_matches(':').parse::<f64>().ok()
        };
        let azimuth = head.iter().find_map(degrees).filter(|a| (0.0..=360.0).contains(a));
        let title = head.iter().map(|l| l.trim()).find(|l| !l.is_empty()).unwrap_or_default().to_owned();
        let name = if starts.len() > 1 { format!("{name} channel {}", k + 1) } else { name.to_owned() };
        let dt = m.dt.ok_or("the header gives no step of time")?;
        let acceleration = m.values.iter().map(|a| 0.01 * a).collect();
        motions.push(Motion { name, title, azimuth, dt, acceleration });
    }
    Ok(motions)
}

/// Name and unit of `acc[g]`, `acc (g)` or `acc_g`; no unit if it is none of an acceleration.
fn name_and_unit(head: &str) -> (String, Option<f64>) {
    let factor = |u: &str| unit::unit(u).filter(|u| u.quantity == ACCELERATION).map(|u| u.factor);
    let bracketed = |open, close| head.trim().strip_suffix(close).and_then(|c: &str| c.split_once(open));
    let parts = bracketed('[', ']').or_else(|| bracketed('(', ')')).or_else(|| head.rsplit_once('_'));
    match parts {
        Some((name, u)) if factor(u.trim()).is_some() => (name.trim().to_owned(), factor(u.trim())),
        _ => (head.trim().to_owned(), None),
    }
}

/// A table: the first of several columns is the time; one column alone, or rows of many values, are accelerations.
fn table(name: &str, text: &str, options: &ReadOptions) -> Result<Vec<Motion>, String> {
    let given = match &options.unit {
        None => None,
        Some(word) => {
            Some(unit::unit(word).filter(|u| u.quantity == ACCELERATION).map(|u| u.factor).ok_or_else(|| {
                let near = unit::nearest_name(word).map_or(String::new(), |n| format!("; did you mean {n}?"));
                format!("\"{word}\" is no unit of accelerations{near}")
            })?)
        }
    };
    let unknown = || "the file gives no unit of its accelerations: add --unit (g, m/s2, cm/s2, in/s2)".to_owned();
    let wrapped = || -> Result<Vec<Motion>, String> {
        let m = motion::parse(text)?;
        let dt = options.dt.or(m.dt).ok_or("the file gives no step of time: add --dt")?;
        let factor = given.ok_or_else(unknown)?;
        let acceleration = m.values.iter().map(|a| factor * a).collect();
        Ok(vec![Motion { name: name.to_owned(), title: String::new(), azimuth: None, dt, acceleration }])
    };
    let table = match Table::parse(text) {
        Ok(t) if t.columns.len() > 1 && steps(&t.columns[0]).is_ok() => t,
        Ok(t) if !t.names.is_empty() && t.columns.len() > 1 => {
            return Err(steps(&t.columns[0]).err().unwrap_or_default());
        }
        _ => return wrapped(),
    };
    let dt = steps(&table.columns[0])?;
    let mut motions = vec![];
    for (i, values) in table.columns.iter().enumerate().skip(1) {
        let (column, unit) = table.names.get(i).map_or((String::new(), None), |n| name_and_unit(n));
        let Some(factor) = unit.or(given) else {
            // A table may have channels of other quantities beside the accelerations.
            if table.names.iter().any(|n| name_and_unit(n).1.is_some()) {
                continue;
            }
            return Err(unknown());
        };
        let name = match (table.columns.len(), column.is_empty()) {
            (2, _) => name.to_owned(),
            (_, true) => format!("{name} column {}", i + 1),
            _ => format!("{name} {column}"),
        };
        let acceleration = values.iter().map(|a| factor * a).collect();
        motions.push(Motion { name, title: String::new(), azimuth: None, dt, acceleration });
    }
    Ok(motions)
}

/// The step of equally spaced times.
fn steps(times: &[f64]) -> Result<f64, String> {
    let n = times.len();
    if n < 2 {
        return Err("there are fewer than two rows".into());
    }
    let dt = (times[n - 1] - times[0]) / (n - 1) as f64;
    let uneven = times.windows(2).position(|w| (w[1] - w[0] - dt).abs() > 0.02 * dt.abs());
    match uneven {
        None if dt > 0.0 => Ok(dt),
        None => Err("the times of the first column do not increase".into()),
        Some(i) => {
            Err(format!("the times of the first column are not at equal steps: row {} follows after {}", i + 2, {
                times[i + 1] - times[i]
            }))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{ReadOptions, read};

    fn one(text: &str) -> super::Motion {
        read("f", text, &ReadOptions::default()).expect("a motion").remove(0)
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
        let m = read("f", &(channel(270) + &channel(360)), &ReadOptions::default()).expect("motions");
        assert_eq!((m.len(), m[0].azimuth, m[1].azimuth), (2, Some(270.0), Some(360.0)));
        assert!((m[1].acceleration[1] + 2.0).abs() < 1e-12 && m[0].acceleration.len() == 4);
    }

    #[test]
    fn tables_with_units_in_names_or_options() {
        let m = one("time_s,acc_g\n0,0.1\n0.01,0.2\n0.02,0.3\n");
        assert!((m.acceleration[0] - 0.980665).abs() < 1e-12 && (m.dt - 0.01).abs() < 1e-12);
        let m = one("t[s],a[cm/s2]\n0,1\n0.5,2\n");
        assert!((m.acceleration[1] - 0.02).abs() < 1e-12);
        let options = ReadOptions { unit: Some("g".into()), dt: Some(0.02) };
        let wrapped = read("f", "0.1 0.2 0.3\n0.4 0.5\n", &options).expect("a motion");
        assert_eq!((wrapped[0].acceleration.len(), wrapped[0].dt), (5, 0.02));
        let told = |text: &str, o: &ReadOptions| read("f", text, o).expect_err("a fault");
        assert!(told("0 1\n1 2\n2 3\n", &ReadOptions::default()).contains("--unit"));
        assert!(told("1\n2\n", &ReadOptions { unit: Some("g".into()), dt: None }).contains("--dt"));
        assert!(told("1\n2\n", &ReadOptions { unit: Some("gg".into()), dt: None }).contains("gg"));
        assert!(told("t,a[g]\n0,1\n1,2\n5,3\n", &ReadOptions::default()).contains("equal steps"));
    }
}
