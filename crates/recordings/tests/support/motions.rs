//! Formats of agencies.

use super::{File, Known, Random};
use std::fmt::Write as _;

/// Numbers of a width, so many in a line.
fn fixed(values: &[f64], per_line: usize, format: impl Fn(f64) -> String) -> String {
    values.chunks(per_line).map(|row| row.iter().map(|x| format(*x)).collect::<String>() + "\n").collect()
}

fn title_case(word: &str) -> String {
    word[..1].to_uppercase() + &word[1..]
}

pub fn peer(k: &Known, r: &mut Random) -> Option<File> {
    let n = k.values.len();
    let unit = match k.unit {
        "g" => r.of(&["G", "g"]),
        "cm/s2" => r.of(&["CM/SEC/SEC", "CM/S2", "CM/SEC**2"]),
        "m/s2" => r.of(&["M/S/S", "M/SEC2"]),
        "cm/s" => r.of(&["CM/S", "CM/SEC"]),
        _ => "CM",
    };
    let word = k.word().to_uppercase();
    let statement = match r.below(3) {
        0 => format!("{word} TIME SERIES IN UNITS OF {unit}"),
        1 => format!("{word} TIME HISTORY IN UNITS OF {unit}."),
        _ => format!("{} time series ({unit})", title_case(k.word())),
    };
    let dt = k.dt;
    let counts = match r.below(8) {
        0 => format!("NPTS=  {n}, DT=   {dt:.4} SEC,"),
        1 => format!("NPTS={n},DT={dt:.4}"),
        2 => format!("DT= {dt:.4} SEC, NPTS= {n}"),
        3 => format!("   {n}    {dt:.4}   NPTS, DT"),
        4 => format!("NPTS: {n}  DT: {dt:e} s"),
        5 => format!("NPTS= {n}, DT= {:.1} MSEC", dt * 1000.0),
        6 => format!("npts = {n}; dt = {dt:.5} sec"),
        _ => format!("NPTS {n} DT .{:04}", (dt * 10_000.0).round() as usize),
    };
    let header =
        format!("PEER NGA STRONG MOTION DATABASE RECORD\nNowhere, 1/02/1999, Somewhere, 270\n{statement}\n{counts}\n");
    let data = match r.below(3) {
        0 => fixed(&k.values, 5, |x| format!("{x:>18.9e}")),
        1 => fixed(&k.values, 8, |x| format!(" {x:.8}")),
        _ => fixed(&k.values, 1, |x| format!("{x:.9E}")),
    };
    let extension = match k.word() {
        "velocity" => "VT2",
        "displacement" => "DT2",
        _ => "AT2",
    };
    Some(File::new(&format!("RSN1.{extension}"), header, data))
}

pub fn csmip(k: &Known, r: &mut Random) -> Option<File> {
    let values = k.in_unit("cm/s2")?;
    let n = values.len();
    let blank = " ".repeat(r.below(4));
    let header = format!(
        "CORRECTED ACCELEROGRAM\nCHAN  1:  {} DEG\n{blank}{n} POINTS OF ACCEL DATA EQUALLY SPACED AT  {:.3} SEC.\n",
        r.of(&[90, 270, 360]),
        k.dt
    );
    let mut data = fixed(&values, 8, |x| format!("{x:>10.5}"));
    let _ = write!(
        data,
        "{n} POINTS OF VELOC DATA EQUALLY SPACED AT  {:.3} SEC.\n{}",
        k.dt,
        fixed(&values, 8, |x| format!("{x:>10.5}"))
    );
    Some(File::new("CHAN001.V2", header, data))
}

pub fn cosmos(k: &Known, r: &mut Random) -> Option<File> {
    let (unit, code) = match k.unit {
        "g" => ("g", 2),
        "cm/s2" => (r.of(&["cm/sec2", "cm/sec/sec", "cm/s2"]), 4),
        "cm/s" => (r.of(&["cm/s", "cm/sec"]), 5),
        "cm" => ("cm", 6),
        _ => return None,
    };
    let entries = |entry: usize, value: &str| {
        let cells: Vec<String> = (1..=100).map(|i| if i == entry { value.into() } else { "-999".into() }).collect();
        cells.chunks(10).map(|c| c.iter().map(|x| format!("{x:>8}")).collect::<String>() + "\n").collect::<String>()
    };
    let (step, step_entry) =
        if r.below(2) == 0 { (format!("{:.3}", k.dt * 1000.0), 62) } else { (format!("{:.4}", k.dt), 34) };
    let n = k.values.len();
    let format = r.of(&["Format=(5E15.7)", "Format= (5E15.7)"]);
    let header = format!(
        "Corrected {word} (Format v01.20 with 13 text lines)\nEarthquake\n\n\nStation\n  \
         100 Integer-header values follow on 10 lines, Format= (10I8)\n{}  \
         100 Real-header values follow on 10 lines, Format= (10F8.3)\n{}   \
         1 Comment line(s) follow, each starting with a \"|\":\n|none\n    \
         {n} {word} pts, approx  4 secs, units={unit} (0{code}),{format}\n",
        entries(54, "90"),
        entries(step_entry, &step),
        word = k.word(),
    );
    let data = fixed(&k.values, 5, |x| format!("{x:>15.7e}")) + "End-of-data for Chan  1 acceleration\n";
    Some(File::new("chan.v2c", header, data))
}

pub fn smc(k: &Known, _: &mut Random) -> Option<File> {
    let (kind, unit) = match k.word() {
        "velocity" => ("3 VELOCITY", "cm/s"),
        "displacement" => ("4 DISPLACEMENT", "cm"),
        _ => ("2 CORRECTED ACCELEROGRAM", "cm/s2"),
    };
    let values = k.in_unit(unit)?;
    let mut header = format!("{kind}\n*\nABC1\n     1989  10  18    0004 Somewhere\n\nstation = A\n\n\n*\n*\n*\n");
    let mut whole = [-32768i64; 48];
    (whole[1], whole[13], whole[15], whole[16]) = (1989, 65, 2, values.len() as i64);
    whole.chunks(8).for_each(|c| header += &(c.iter().map(|x| format!("{x:>10}")).collect::<String>() + "\n"));
    let mut real = [1.7e38; 50];
    real[1] = 1.0 / k.dt;
    header += &fixed(&real, 5, |x| format!("{x:>15.7e}"));
    header += "|\n|a comment\n";
    // Four digits in ten characters, as the format has them: see `exact`.
    Some(File::new("a.smc", header, fixed(&values, 8, |x| format!("{x:>10.5}"))))
}

pub fn knet(k: &Known, r: &mut Random) -> Option<File> {
    let values = k.in_unit("cm/s2")?;
    let scale = r.of(&[(3920.0, 6_182_761_000.0), (2000.0, 8_388_608_000.0)]);
    let n = values.len();
    let header = format!(
        "Origin Time       2016/04/16 01:25:00\nLat.              32.753\nStation Code      XYZ001\n\
         Record Time       2016/04/16 01:25:20\nSampling Freq(Hz) {}Hz\nDuration Time(s)  {}\nDir.              {}\n\
         Scale Factor      {}(gal)/{}\nMax. Acc. (gal)   294.200\nLast Correction   2016/04/16 01:25:00\nMemo.             \n",
        (1.0 / k.dt).round(),
        n as f64 * k.dt,
        r.of(&["N-S", "E-W", "5", "1"]),
        scale.0,
        scale.1,
    );
    let data = fixed(&values, 8, |x| format!("{:>13}", (x / scale.0 * scale.1).round()));
    Some(File::new("XYZ001.EW", header, data))
}

pub fn esm(k: &Known, r: &mut Random) -> Option<File> {
    let unit = match k.unit {
        "cm/s2" => r.of(&["cm/s^2", "cm/s2", "CM/S^2"]),
        other => other,
    };
    let header = format!(
        "EVENT_NAME: TEST\nEVENT_DATE_YYYYMMDD: 20161030\nNETWORK: IT\nSTATION_CODE: TST\n\
         DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS: 20161030_064003.000\nSAMPLING_INTERVAL_S: {:.6}\nNDATA: {}\n\
         STREAM: {}\nUNITS: {unit}\nDATA_TYPE: {}\nUSER1: \n",
        k.dt,
        k.values.len(),
        r.of(&["HGE", "HNN", "HNZ"]),
        k.word().to_uppercase(),
    );
    Some(File::new("IT.TST.ASC", header, fixed(&k.values, 1, |x| format!("{x:.9}"))))
}

pub fn afad(k: &Known, r: &mut Random) -> Option<File> {
    let values = k.in_unit("cm/s2")?;
    let header = format!(
        "NATIONAL STRONG-MOTION NETWORK OF TURKEY (TR-NSMN)\n\nEARTHQUAKE DATE          : 06/02/2023 01:17:32 (GMT)\n\
         STATION ID               : 4614\nNUMBER OF DATA           : {}\nSAMPLING INTERVAL ({})  : {:.6}\n\
         RAW PGA VALUES (gal)     : (N-S) 294.2 (E-W) 147.1 (U-D) 73.5\n\n{}\n",
        values.len(),
        r.of(&["sec", "s"]),
        k.dt,
        r.of(&["N-S              E-W              U-D", "N-S E-W U-D", "  N-S\tE-W\tU-D"]),
    );
    let row = |x: &f64| format!("{x:>17.9}{:>17.9}{:>17.9}\n", 0.5 * x, 0.25 * x);
    Some(File::new("20230206.txt", header, values.iter().map(row).collect()))
}

pub fn geonet(k: &Known, r: &mut Random) -> Option<File> {
    let values = k.in_unit("mm/s2")?;
    let n = values.len();
    let mut header = String::from("Corrected accelerogram 20161113_110256_HSES_20 GNS Science\nSite HSES\nSomewhere\n");
    (3..12).for_each(|_| header += "text\n");
    header += &format!("Component {}  Axis\ntext\ntext\ntext\n", r.of(&["N10E", "S80E", "Up"]));
    let mut whole = [0usize; 40];
    (whole[30], whole[33], whole[34], whole[35]) = (n, n, n, n);
    whole.chunks(10).for_each(|c| header += &(c.iter().map(|x| format!("{x:>8}")).collect::<String>() + "\n"));
    let mut real = [0.0; 60];
    real[25] = k.dt;
    header += &fixed(&real, 10, |x| format!("{x:>8.4}"));
    let block = fixed(&values, 10, |x| format!("{x:>8.2}"));
    Some(File::new("a.V2A", header, block.repeat(3)))
}

pub fn volume1(k: &Known, r: &mut Random) -> Option<File> {
    let values = k.in_unit("g")?;
    let n = values.len();
    let (factor, unit) = r.of(&[(10.0, "G/10"), (1.0, "G")]);
    let duration = n as f64 * k.dt;
    let mut header = format!(
        "{}\nEARTHQUAKE\nJUNE 28, 1992\n1\nSTATION NO. 1\nSOMEWHERE\n{}\nx\ny\nINSTR PERIOD =  .0388 SEC\n\
         NO. OF POINTS =  {n}  RECORD LENGTH = {duration:.3} SEC\nUNITS OF UNCOR ACCEL ARE SEC AND {unit}.\nRMS\n",
        r.of(&["UNCORRECTED ACCELEROGRAM DATA", "* VOL1DS FILE:  5520/01"]),
        r.of(&["CHAN  1:  90 DEG", "COMP S58W"]),
    );
    (0..14).for_each(|_| header += "    0    0\n");
    let pairs = r.below(2) == 0;
    let data = if pairs {
        let cells: Vec<[f64; 2]> = values.iter().enumerate().map(|(i, x)| [i as f64 * k.dt, factor * x]).collect();
        let row = |c: &[[f64; 2]]| c.iter().map(|[t, x]| format!("{t:>8.3}{x:>13.9}")).collect::<String>() + "\n";
        cells.chunks(5).map(row).collect()
    } else {
        fixed(&values, 8, |x| format!("{:>16.8E}", factor * x))
    };
    let end = if r.below(2) == 0 { "/& ---- End of Data ----\n" } else { "" };
    Some(File::new("a.V1", header, data + end))
}
