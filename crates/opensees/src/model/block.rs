//! `block2D` and `block3D`: meshes of quadrilaterals and of bricks.

use crate::args::Args;
use crate::model::nodes::need_model;
use crate::text::Arg;
use crate::{Command, Outcome, Tcl, finish};
use hysteron_tcl::{Call, Exception, Value};

const NX: Arg = Arg::count("nx", "number of elements along 1-2");
const NY: Arg = Arg::count("ny", "number of elements along 2-3");
const NZ: Arg = Arg::count("nz", "number of elements along 1-5");

const FIRST_NODE: Arg = Arg::whole("firstNode", "tag of the first node");
const FIRST_ELEMENT: Arg = Arg::whole("firstElement", "tag of the first element");
const KIND: Arg = Arg::new("kind", "kind of element");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("block2D", USAGE, block2d)
        .about("Makes a grid of nodes and of elements between them, in the plane.")
        .arguments(&[NX, NY, FIRST_NODE, FIRST_ELEMENT, KIND, Arg::flag("-numEleNodes", "nodes of an element")]),
    Command::new("block3D", USAGE_3D, block3d)
        .arguments(&[NX, NY, NZ, FIRST_NODE, FIRST_ELEMENT, KIND])
        .about("Makes a grid of nodes and of bricks between them."),
];

const USAGE_3D: &str = "block3D $nx $ny $nz $firstNode $firstElement $kind {arguments} {1 $x1 $y1 $z1 2 $x2 ... 8 ...}";

/// Corners of a block in space by their place in the unit cube.
const CORNERS: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 0.0, 1.0],
    [1.0, 1.0, 1.0],
    [0.0, 1.0, 1.0],
];

const USAGE: &str =
    "block2D $nx $ny $firstNode $firstElement $kind {arguments} <-numEleNodes 4> {1 $x1 $y1 <$z1> 2 $x2 ...}";

/// Corners, then the middles of the sides 12, 23, 34 and 41, then the middle: by their place in the unit square.
const PLACES: [[f64; 2]; 9] =
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, 0.0]];

/// Points whose mean replaces a point that is not given.
const MEANS: [(usize, &[usize]); 5] = [(4, &[0, 1]), (5, &[1, 2]), (6, &[2, 3]), (7, &[3, 0]), (8, &[0, 1, 2, 3])];

/// Lagrange's parabola through -1, 0 and 1 that is 1 at `at`.
fn parabola(at: f64, x: f64) -> f64 {
    if at == 0.0 { 1.0 - x * x } else { 0.5 * x * (x + at) }
}

/// The points of the block; those that are not given follow from the corners.
fn points(a: &mut Args<'_>, ndm: usize) -> Result<[Vec<f64>; 9], Exception> {
    let given = a.value("points of the block")?;
    let list = given.to_list()?;
    if list.len() % (ndm + 1) != 0 {
        let message = format!("{} words for the points of the block", list.len());
        return Err(a.refuse(message, format!("expected a number 1 to 9 and {ndm} coordinates for each")));
    }
    let mut points: [Vec<f64>; 9] = Default::default();
    for words in list.chunks(ndm + 1) {
        let numbers: Result<Vec<f64>, _> = words.iter().map(Value::to_f64).collect();
        let numbers = numbers.map_err(|_| a.refuse("a point of the block has a word that is no number", ""))?;
        match points.get_mut((numbers[0] as usize).wrapping_sub(1)) {
            Some(p) if numbers[0].fract() == 0.0 => p.extend(&numbers[1..]),
            _ => return Err(a.refuse(format!("{} is no point of a block", numbers[0]), "expected 1 to 9")),
        }
    }
    if let Some(i) = (0..9).find(|&i| if i < 4 { points[i].len() != ndm } else { points[i].len() > ndm }) {
        let message =
            format!("point {} of the block is {}", i + 1, if points[i].is_empty() { "missing" } else { "given twice" });
        return Err(a.refuse(message, "expected the corners 1 to 4 once each"));
    }
    for (i, from) in MEANS {
        if points[i].is_empty() {
            points[i] = (0..ndm).map(|d| from.iter().map(|&k| points[k][d]).sum::<f64>() / from.len() as f64).collect();
        }
    }
    Ok(points)
}

fn block2d(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, USAGE);
    let ndm = interp.host.builder.ndm;
    if ndm < 2 {
        return Err(a.refuse_at(call.span(0), "block2D: the model has one dimension", "expected 2 or 3"));
    }
    let [nx, ny] = a.parts([&NX, &NY])?;
    let (node, element) = (a.int(FIRST_NODE.meaning)?, a.int(FIRST_ELEMENT.meaning)?);
    let kind = a.word(KIND.meaning)?.into_owned();
    let arguments = a.word("arguments of the elements after their nodes")?.into_owned();
    if a.flag("-numEleNodes") && a.int("number of nodes of an element")? != 4 {
        return Err(a.refuse("only elements with 4 nodes can be made", "expected 4"));
    }
    let points = points(&mut a, ndm)?;
    finish(interp, &a)?;
    let tag = |i: usize, j: usize| i64::from(node) + (i + j * (nx + 1)) as i64;
    for j in 0..=ny {
        for i in 0..=nx {
            let (x, y) = (2.0 * i as f64 / nx as f64 - 1.0, 2.0 * j as f64 / ny as f64 - 1.0);
            let mut words = vec![Value::from("node"), Value::from(tag(i, j))];
            words.extend((0..ndm).map(|d| {
                let weighted =
                    PLACES.iter().zip(&points).map(|([px, py], p)| parabola(*px, x) * parabola(*py, y) * p[d]);
                Value::from(weighted.sum::<f64>())
            }));
            interp.eval_value(&Value::list(words))?;
        }
    }
    for j in 0..ny {
        for i in 0..nx {
            let corners = [tag(i, j), tag(i + 1, j), tag(i + 1, j + 1), tag(i, j + 1)].map(|t| t.to_string()).join(" ");
            let number = i64::from(element) + (i + j * nx) as i64;
            make_element(interp, &kind, number, &corners, &arguments)?;
        }
    }
    Ok(Value::EMPTY)
}

/// Make an element of a block. The arguments of a script are read as Tcl, as in OpenSees; those of a host are words.
fn make_element(interp: &mut Tcl, kind: &str, number: i64, nodes: &str, arguments: &str) -> Outcome {
    if !interp.host.called_by_host {
        return interp.eval_value(&Value::from(format!("element {kind} {number} {nodes} {arguments}")));
    }
    let mut words = vec![Value::from("element"), Value::from(kind), Value::from(number)];
    for list in [nodes, arguments] {
        words.extend(Value::from(list).to_list()?.iter().cloned());
    }
    interp.eval_value(&Value::list(words))
}

/// The corners of a block in space.
fn corners(a: &mut Args<'_>) -> Result<[[f64; 3]; 8], Exception> {
    let given = a.value("corners of the block")?;
    let list = given.to_list()?;
    let mut corners = [None; 8];
    for words in list.chunks(4) {
        let numbers: Result<Vec<f64>, _> = words.iter().map(Value::to_f64).collect();
        match numbers.as_deref() {
            Ok(&[corner, x, y, z]) if (1.0..=8.0).contains(&corner) && corner.fract() == 0.0 => {
                corners[corner as usize - 1] = Some([x, y, z]);
            }
            _ => {
                let words: Vec<_> = words.iter().map(Value::as_str).collect();
                let message = format!("\"{}\" is no corner of a block", words.join(" "));
                return Err(a.refuse(message, "expected a number 1 to 8 and 3 coordinates"));
            }
        }
    }
    if let Some(missing) = corners.iter().position(Option::is_none) {
        return Err(a.refuse(format!("corner {} of the block is missing", missing + 1), "expected the corners 1 to 8"));
    }
    Ok(corners.map(Option::unwrap_or_default))
}

fn block3d(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, USAGE_3D);
    if interp.host.builder.ndm != 3 {
        return Err(a.refuse_at(call.span(0), "block3D: the model is not in space", "expected 3 dimensions"));
    }
    let what = [&NX, &NY, &NZ];
    let count = a.parts(what)?;
    let [nx, ny, nz] = count;
    let (node, element) = (a.int(FIRST_NODE.meaning)?, a.int(FIRST_ELEMENT.meaning)?);
    let kind = a.word(KIND.meaning)?.into_owned();
    let arguments = a.word("arguments of the elements after their nodes")?.into_owned();
    let corners = corners(&mut a)?;
    finish(interp, &a)?;
    let tag = |i: usize, j: usize, k: usize| i64::from(node) + (i + (nx + 1) * (j + k * (ny + 1))) as i64;
    let grid =
        |n: [usize; 3]| (0..n[2]).flat_map(move |k| (0..n[1]).flat_map(move |j| (0..n[0]).map(move |i| [i, j, k])));
    for [i, j, k] in grid(count.map(|n| n + 1)) {
        let at = [i as f64 / nx as f64, j as f64 / ny as f64, k as f64 / nz as f64];
        let mut words = vec![Value::from("node"), Value::from(tag(i, j, k))];
        words.extend((0..3).map(|d| {
            let share =
                |c: &[f64; 3]| c.iter().zip(at).map(|(c, x)| if *c == 0.0 { 1.0 - x } else { x }).product::<f64>();
            Value::from(CORNERS.iter().zip(&corners).map(|(c, x)| share(c) * x[d]).sum::<f64>())
        }));
        interp.eval_value(&Value::list(words))?;
    }
    for (number, [i, j, k]) in grid(count).enumerate() {
        let nodes = CORNERS.map(|c| tag(i + c[0] as usize, j + c[1] as usize, k + c[2] as usize).to_string()).join(" ");
        let number = i64::from(element) + number as i64;
        make_element(interp, &kind, number, &nodes, &arguments)?;
    }
    Ok(Value::EMPTY)
}
