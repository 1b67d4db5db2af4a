//! Results of prototype tests as tables, JSON and a page.

use super::{Bounds, Factors, Nominal, Posterior, Properties, PrototypeTest, Trends};
use crate::check::{Check, check_table};
use crate::codes::Code;
use hysteron_identify::report::{Cell, Table, html as page};
use hysteron_opensees::chart::Figure;
use serde_json::{Value, json};

/// Q_d, K_d and K_eff of each bound with their factors.
pub fn bounds_table(bounds: &Bounds, units: [&str; 2]) -> Table {
    let stiffness = format!("{}/{}", units[0], units[1]);
    let mut table = Table::new([
        ("bound", ""),
        ("Q_d", units[0]),
        ("K_d", &stiffness),
        ("lambda Q_d", ""),
        ("lambda K_d", ""),
        ("lambda_test Q_d", ""),
        ("lambda_test K_d", ""),
    ]);
    for (name, p, l, t) in [
        ("lower", bounds.lower, bounds.lambda_min, bounds.test_min),
        ("nominal", bounds.nominal, Factors::ONE, Factors::ONE),
        ("upper", bounds.upper, bounds.lambda_max, bounds.test_max),
    ] {
        let mut row = vec![Cell::Word(name)];
        row.extend([p.q_d, p.k_d, l.q_d, l.k_d, t.q_d, t.k_d].map(Cell::from));
        table.rows.push(row);
    }
    table
}

/// Bounds by the scatter of the tests: 5 and 95 % of Q_d and K_d over nominal, in words.
pub fn posterior_lines(posterior: &Result<Posterior, String>) -> String {
    let p = match posterior {
        Ok(p) => p,
        Err(e) => return format!("scatter of the tests: {e}\n"),
    };
    let [[q_low, q_high], [k_low, k_high]] = [0, 1].map(|of| p.range(of));
    format!(
        "scatter of {} cycles: 5 to 95 % of Q_d is {q_low:.3} to {q_high:.3}, of K_d {k_low:.3} to {k_high:.3} times nominal, \
         correlation {:.2}\n",
        p.cycles, p.correlation
    )
}

/// Trends in words, one a line.
pub fn trend_lines(t: &Trends) -> String {
    let line = |what: &str, x: f64, digits: usize| {
        if x.is_finite() { format!("{what}: {x:.digits$}\n") } else { format!("{what}: not shown by these tests\n") }
    };
    line("scragging, K_eff of the first over the third cycle of the first test", t.scragging, 3)
        + &line("heating, change of Q_d by unit of dissipated energy over Q_d of the first cycle", t.heating, 6)
        + &line("rate, exponent n of Q_d over velocity", t.rate_strength, 3)
        + &line("rate, exponent n of K_eff over velocity", t.rate_stiffness, 3)
}

fn table_rows(table: &Table) -> Value {
    serde_json::from_str(&table.json()).unwrap_or_default()
}

/// All results. Numbers that tests do not show are null.
pub fn json(
    tests: &[PrototypeTest],
    nominal: &Nominal,
    t: &Trends,
    bounds: &Bounds,
    posterior: Option<&Posterior>,
    checks: &[Check],
    code: &Code,
) -> String {
    let properties =
        |p: Properties, l: Factors| json!({"Q_d": p.q_d, "K_d": p.k_d, "lambda_Q_d": l.q_d, "lambda_K_d": l.k_d});
    let all = json!({
        "cycles": table_rows(&super::cycle_table(tests, nominal, ["", ""])),
        "nominal": {"D": nominal.amplitude, "K_eff": nominal.k_eff, "Q_d": nominal.q_d, "K_d": nominal.k_d},
        "trends": {
            "scragging": t.scragging,
            "heating": t.heating,
            "rate_exponent_Q_d": t.rate_strength,
            "rate_exponent_K_eff": t.rate_stiffness,
        },
        "bounds": {
            "lower": properties(bounds.lower, bounds.lambda_min),
            "nominal": properties(bounds.nominal, Factors::ONE),
            "upper": properties(bounds.upper, bounds.lambda_max),
        },
        "posterior": posterior,
        "checks": table_rows(&check_table(checks)),
        "code": {"name": code.name, "edition": code.edition, "text_read": code.text_read, "source": code.source},
    });
    format!("{all:#}\n")
}

/// Cells of a table as texts.
pub(crate) fn page_table(out: &mut String, table: &Table) {
    let heads: Vec<String> = table.columns.iter().map(|c| page::labelled(&c.name, &c.unit)).collect();
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let cell = |c: &Cell| match c {
        Cell::Number(x) => page::number(*x),
        Cell::Word(w) => (*w).to_owned(),
        Cell::Text(t) => t.clone(),
    };
    page::table(out, &heads, table.rows.iter().map(|r| r.iter().map(cell).collect()));
}

/// A table as parts that fit on a page: each has the first `names` columns, and up to `width` in all.
pub(crate) fn page_table_in_parts(out: &mut String, table: &Table, names: usize, width: usize) {
    let others: Vec<usize> = (names..table.columns.len()).collect();
    for part in others.chunks(width - names) {
        let chosen = || (0..names).chain(part.iter().copied());
        let columns = chosen().map(|i| table.columns[i].clone()).collect();
        let rows = table.rows.iter().map(|r| chosen().map(|i| r[i].clone()).collect()).collect();
        page_table(out, &Table { columns, rows });
    }
}

/// A page with loops, tables and checks. `loops` are names, displacements and forces.
pub fn html(
    loops: &[(&str, &[f64], &[f64])],
    cycles: &Table,
    trends: &str,
    bounds: &Bounds,
    checks: &[Check],
    code: &Code,
    units: [&str; 2],
) -> String {
    let mut out = page::head("Prototype tests");
    out += &format!("<p class=\"note\">{}</p>\n<h2>Checks</h2>\n", page::escaped(&code.remark()));
    page_table(&mut out, &check_table(checks));
    out += "<h2>Bounds</h2>\n";
    page_table(&mut out, &bounds_table(bounds, units));
    out += &format!("<h2>Trends</h2>\n<pre>{}</pre>\n<h2>Loops</h2>\n", page::escaped(trends));
    for (name, u, f) in loops {
        let points = u.iter().copied().zip(f.iter().copied()).collect();
        let figure = Figure {
            title: (*name).to_owned(),
            x_label: page::labelled("Displacement", units[1]),
            y_label: page::labelled("Force", units[0]),
            curves: vec![page::line("", points)],
            ..Figure::default()
        };
        page::picture(&mut out, &figure);
    }
    out += "<h2>Cycles</h2>\n";
    page_table(&mut out, cycles);
    page::end(out)
}
