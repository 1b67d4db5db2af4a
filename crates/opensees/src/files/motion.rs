//! Files of ground motions: PEER's AT2, CSMIP's V2, and plain columns.

/// A motion at equal steps of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// Step of time in s, where the file gives it.
    pub dt: Option<f64>,
    /// Values, in the unit of the file: g in AT2, cm/s² in V2.
    pub values: Vec<f64>,
}

/// Read a motion: the kind of file is seen from its header.
///
/// # Errors
/// Description of the fault in the file.
pub fn parse(text: &str) -> Result<Motion, String> {
    let lines: Vec<&str> = text.lines().collect();
    let lower = |l: &str| l.to_ascii_lowercase();
    let motion = if let Some(at) = lines.iter().position(|l| lower(l).contains("npts") && lower(l).contains("dt")) {
        peer(lines[at], &lines[at + 1..])?
    } else if let Some(at) = lines.iter().position(|l| lower(l).contains("accel") && lower(l).contains("spaced at")) {
        csmip(lines[at], &lines[at + 1..])?
    } else {
        columns(&lines)?
    };
    if motion.dt.is_some_and(|dt| dt <= 0.0 || !dt.is_finite()) {
        return Err(format!("the step of time is {}", motion.dt.unwrap_or_default()));
    }
    if motion.values.is_empty() || motion.values.iter().any(|v| !v.is_finite()) {
        return Err("there are no values, or some that are not finite".into());
    }
    Ok(motion)
}

/// Numbers of a header line, whatever stands between them.
fn header_numbers(line: &str) -> Vec<f64> {
    line.split(|c: char| !(c.is_ascii_digit() || c == '.')).filter_map(|w| w.parse().ok()).collect()
}

/// Count and step are in the header, `NPTS= 4000, DT= .0100 SEC` or `4000 0.0100 NPTS, DT`.
fn peer(header: &str, lines: &[&str]) -> Result<Motion, String> {
    let [count, dt, ..] = header_numbers(header)[..] else {
        return Err(format!("no count and no step of time in \"{}\"", header.trim()));
    };
    let words = lines.iter().flat_map(|l| l.split_whitespace());
    let values = words.map(|w| w.parse().map_err(|_| format!("\"{w}\" is not a number")));
    complete(values.collect::<Result<_, _>>()?, count, dt)
}

/// Values in columns of ten characters, as many as the header says; velocities and displacements follow.
fn csmip(header: &str, lines: &[&str]) -> Result<Motion, String> {
    let numbers = header_numbers(header);
    let (Some(&count), Some(at)) = (numbers.first(), header.to_ascii_lowercase().find("spaced at")) else {
        return Err(format!("no count in \"{}\"", header.trim()));
    };
    let Some(&dt) = header_numbers(&header[at..]).first() else {
        return Err(format!("no step of time in \"{}\"", header.trim()));
    };
    let mut values = vec![];
    for line in lines.iter().take_while(|l| l.is_ascii()) {
        let cells = line.trim_end().as_bytes().chunks(10);
        for cell in cells.map(|c| String::from_utf8_lossy(c).trim().to_owned()) {
            if values.len() as f64 >= count {
                return complete(values, count, dt);
            }
            values.push(cell.parse().map_err(|_| format!("\"{cell}\" is not a number"))?);
        }
    }
    complete(values, count, dt)
}

fn complete(mut values: Vec<f64>, count: f64, dt: f64) -> Result<Motion, String> {
    if (values.len() as f64) < count {
        return Err(format!("the header says {count} values, but there are {}", values.len()));
    }
    values.truncate(count as usize);
    Ok(Motion { dt: Some(dt), values })
}

/// One column of values, or two of times and values; lines that are no numbers may stand before them.
fn columns(lines: &[&str]) -> Result<Motion, String> {
    let row = |l: &str| {
        l.split(|c: char| c.is_whitespace() || c == ',')
            .filter(|w| !w.is_empty())
            .map(|w| w.parse::<f64>().ok())
            .collect::<Option<Vec<f64>>>()
    };
    let rows: Vec<Vec<f64>> = lines.iter().filter_map(|l| row(l)).filter(|r| !r.is_empty()).collect();
    if rows.is_empty() || rows.iter().any(|r| r.len() != 2) {
        return Ok(Motion { dt: None, values: rows.concat() });
    }
    let dt = if rows.len() > 1 { (rows[rows.len() - 1][0] - rows[0][0]) / (rows.len() - 1) as f64 } else { 0.0 };
    if rows.windows(2).any(|w| (w[1][0] - w[0][0] - dt).abs() > 1e-2 * dt.abs()) {
        return Err("the times of the first column are not at equal steps: use timeSeries Path -time".into());
    }
    Ok(Motion { dt: Some(dt), values: rows.into_iter().map(|r| r[1]).collect() })
}
