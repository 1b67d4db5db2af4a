//! Words that the bearings made of many springs share: shape, distribution, numbers of springs, local axes, options.

use super::{Ends, orientation};
use crate::args::Args;
use crate::text::{Arg, Domain};
use hysteron_engine::element::axes::Orientation;
use hysteron_engine::element::bearing::{Distribution, MAX_LAMBDA, Shape};
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Span;
use nalgebra::Matrix3;

pub(super) const LAMBDA: Arg =
    Arg::of("-lambda", "lambda", "distribution parameter lambda").within(Domain::NotNegative);

/// `round` or `square`.
pub(super) fn shape(a: &mut Args<'_>) -> Result<Shape, Exception> {
    let word = a.word("shape of the section, round or square")?;
    match word.as_ref() {
        "round" => Ok(Shape::Round),
        "square" => Ok(Shape::Square),
        _ => Err(a.refuse(format!("unknown shape \"{word}\""), "expected round or square")),
    }
}

/// λ of the distribution of the vertical stiffness.
pub(super) fn distribution(a: &mut Args<'_>) -> Result<Distribution, Exception> {
    let lambda = a.number(&LAMBDA)?;
    if lambda > MAX_LAMBDA {
        let label = format!("expected (D/t) sqrt(3 G/K) of a rubber layer, 0 to {MAX_LAMBDA}");
        return Err(a.refuse(format!("-lambda is {lambda}"), label));
    }
    Ok(Distribution::Pressure(lambda))
}

/// Largest number of springs along an edge: a million springs in a section.
const MAX_DIVISIONS: usize = 1000;

/// Number of springs along an edge of a section.
pub(super) fn divisions(a: &mut Args<'_>, arg: &Arg) -> Result<usize, Exception> {
    let what = arg.meaning;
    match a.count(arg)? {
        n if n <= MAX_DIVISIONS => Ok(n),
        n => Err(a.refuse(format!("{what} is {n}"), format!("expected a number of springs, 1 to {MAX_DIVISIONS}"))),
    }
}

/// Local axes, where the words after `-orient` may give them.
#[derive(Default)]
pub(super) struct Orient {
    orientation: Orientation,
    span: Option<Span>,
}

impl Orient {
    /// Take the words after `-orient`.
    pub(super) fn take(&mut self, a: &mut Args<'_>) -> Result<(), Exception> {
        self.span = a.last_span();
        self.orientation = orientation(a, 3)?;
        Ok(())
    }

    /// Axes and the distance of the nodes, at `nodes` in the script.
    pub(super) fn axes(
        &self,
        a: &Args<'_>,
        ends: &Ends,
        nodes: Option<Span>,
    ) -> Result<(Matrix3<f64>, f64), Exception> {
        let made = self.orientation.of_link(ends.place.0, ends.place.1, false);
        made.map_err(|e| {
            let label = match self.span {
                Some(_) => "",
                None => "expected -orient with other axes, as nodes at one place or above one another in y need",
            };
            a.refuse_at(self.span.or(nodes), e.message(), label)
        })
    }
}

/// The error for an option that is not there.
pub(super) fn option_missing(a: &Args<'_>, nodes: Option<Span>, element: &str, option: &str, what: &str) -> Exception {
    a.refuse_at(nodes, format!("{element}: {option} is missing"), format!("expected {option} and {what} after this"))
}

/// The error for an option that is given twice.
pub(super) fn once<T>(a: &Args<'_>, known: &Option<T>, option: &str) -> Result<(), Exception> {
    match known {
        None => Ok(()),
        Some(_) => Err(a.refuse(format!("{option} is given twice"), "expected it once")),
    }
}
