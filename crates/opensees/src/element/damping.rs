//! `damping`, and the elements that take one.

use crate::args::Args;
use crate::load::series::series_of;
use crate::text::{Arg, Domain, Text};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, ignore_unknown, kind};
use hysteron_engine::element::damping::{Damped, DampingLaw, ElementDamping, Filters, user_defined};
use hysteron_engine::element::{Element, ElementResult};
use hysteron_tcl::{Call, Exception, Value};
use std::sync::Arc;

const TOLERANCE: Arg = Arg::of("-tol", "tol", "tolerance of the damping ratios").within(Domain::Positive);
const ROUNDS: Arg = Arg::of("-maxiter", "rounds", "largest number of rounds").within(Domain::Count);

const TAG: Arg = Arg::whole("tag", "tag of the damping");
const ZETA: Arg = Arg::positive("zeta", "damping ratio zeta");
const UNIFORM_FREQ1: Arg = Arg::positive("freq1", "lower frequency freq1");
const UNIFORM_FREQ2: Arg = Arg::positive("freq2", "upper frequency freq2");
const ACTIVATE_TIME_TA: Arg = Arg::of("-activateTime", "ta", "time of activation").within(Domain::Number);
const DEACTIVATE_TIME_TD: Arg = Arg::of("-deactivateTime", "td", "time of deactivation").within(Domain::Number);
const BETA: Arg = Arg::positive("beta", "coefficient beta");
const FREQUENCY: Arg = Arg::positive("freq1", "frequency freq");
const RATIO: Arg = Arg::number("zeta1", "damping ratio zeta");
const COEFFICIENT: Arg = Arg::number("beta1", "coefficient beta");
const N: Arg = Arg::count("n", "number of frequencies n");

pub(crate) const COMMANDS: &[Command] = &[Command::new("damping", "damping $kind $tag ...", damping)
    .arguments(&[TAG, Arg::of("-factor", "series", "time series")])
    .about("Makes a damping of single elements, for their option `-damp` and for `region -damp`.")
    .defining(&[things::DAMPING], 2)
    .with_kinds(|| kind::usages(KINDS))];

/// A kind of damping, made from the words after its tag.
type Kind = kind::Kind<fn(&mut Tcl, &mut Args<'_>) -> Result<ElementDamping, Exception>>;

const KINDS: &[Kind] = &[
    Kind {
        names: &["Uniform"],
        usage: "damping Uniform $tag $zeta $freq1 $freq2 <-activateTime $ta> <-deactivateTime $td> <-factor $series>",
        text: Text::new(
            "A constant damping ratio over a range of frequencies, by low-pass filters of the element's forces.",
        )
        .arguments(&[ZETA, UNIFORM_FREQ1, UNIFORM_FREQ2, ACTIVATE_TIME_TA, DEACTIVATE_TIME_TD]),
        make: uniform,
    },
    Kind {
        names: &["SecStif", "SecStiff"],
        usage: "damping SecStif $tag $beta <-activateTime $ta> <-deactivateTime $td> <-factor $series>",
        text: Text::new(
            "Forces in proportion to the rate of the element's forces: those before the first dynamic step count as 0.",
        )
        .arguments(&[BETA, ACTIVATE_TIME_TA, DEACTIVATE_TIME_TD]),
        make: secant_stiffness,
    },
    Kind {
        names: &["URD"],
        usage: "damping URD $tag $n $freq1 $zeta1 $freq2 $zeta2 ... <-tol $tol> <-maxiter $rounds> \
                <-activateTime $ta> <-deactivateTime $td> <-factor $series> <-prttag>",
        text: Text::new("Damping ratios given over the frequency, by low-pass filters of the element's forces.")
            .arguments(&[
                N,
                FREQUENCY,
                RATIO,
                FREQUENCY.called("freq2"),
                RATIO.called("zeta2"),
                TOLERANCE,
                ROUNDS,
                Arg::of("-activateTime", "ta", "time at which it begins"),
                Arg::of("-deactivateTime", "td", "time at which it ends"),
                Arg::of("-factor", "series", "tag of a time series that the forces are multiplied by"),
                Arg::flag("-prttag", "printing of the filters in OpenSees, without effect"),
            ]),
        make: user_defined_ratios,
    },
    Kind {
        names: &["URDbeta"],
        usage: "damping URDbeta $tag $n $freq1 $beta1 $freq2 $beta2 ... <-activateTime $ta> <-deactivateTime $td> \
                <-factor $series>",
        text: Text::new("Low-pass filters of given frequencies and coefficients.").arguments(&[
            N,
            FREQUENCY,
            COEFFICIENT,
            FREQUENCY.called("freq2"),
            COEFFICIENT.called("beta2"),
            ACTIVATE_TIME_TA,
            DEACTIVATE_TIME_TD,
        ]),
        make: filters,
    },
];

/// Time at which a damping without `-deactivateTime` ends.
const NEVER: f64 = 1e20;

fn damping(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "damping $kind $tag ...");
    let kind = kind::take(&mut a, "kind of damping", "damping", KINDS.iter())?;
    interp.host.note_kind("damping", kind.names[0]);
    let tag = a.int(TAG.meaning)?;
    let span = a.last_span();
    let made = (kind.make)(interp, &mut a)?;
    finish(interp, &a)?;
    if !interp.host.builder.definitions.dampings.add(tag, Arc::new(made)) {
        return Err(a.exists_at(span, things::DAMPING, tag));
    }
    Ok(Value::EMPTY)
}

/// A damping of these words after the numbers of its law.
fn with_options(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    law: DampingLaw,
    own: &mut Options<'_>,
) -> Result<ElementDamping, Exception> {
    let mut made = ElementDamping { law, window: [0.0, NEVER], factor: None };
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-activateTime" | "-ActivateTime" => made.window[0] = a.number(&ACTIVATE_TIME_TA)?,
            "-deactivateTime" | "-DeactivateTime" => made.window[1] = a.number(&DEACTIVATE_TIME_TD)?,
            "-factor" | "-fact" => made.factor = Some(series_of(interp, a)?),
            "-tol" | "-tolerence" if own.fits() => own.tolerance = a.number(&TOLERANCE)?,
            "-maxiter" | "-iter" if own.fits() => own.rounds = a.count(&ROUNDS)?.max(1),
            // The filters are not printed.
            "-prttag" | "-print" if own.fits() => {}
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(made)
}

/// Options of one kind.
struct Options<'a> {
    known: &'a [&'a str],
    tolerance: f64,
    rounds: usize,
}

impl Options<'_> {
    fn common() -> Self {
        Options { known: &["-activateTime", "-deactivateTime", "-factor"], tolerance: 0.05, rounds: 100 }
    }
    fn fits(&self) -> bool {
        self.known.len() > 3
    }
}

fn uniform(interp: &mut Tcl, a: &mut Args<'_>) -> Result<ElementDamping, Exception> {
    let zeta = a.number(&ZETA)?;
    let (first, last) = (a.number(&UNIFORM_FREQ1)?, a.number(&UNIFORM_FREQ2)?);
    if first >= last {
        return Err(a.refuse(format!("the frequencies are {first} and {last}"), "expected freq1 < freq2"));
    }
    let Some(filters) = Filters::uniform(first, last) else {
        return Err(a.refuse("no number of filters damps this range uniformly", "expected a narrower range"));
    };
    with_options(interp, a, DampingLaw::Filters { filters, loss: Some(2.0 * zeta) }, &mut Options::common())
}

fn secant_stiffness(interp: &mut Tcl, a: &mut Args<'_>) -> Result<ElementDamping, Exception> {
    let beta = a.number(&BETA)?;
    with_options(interp, a, DampingLaw::SecantStiffness { beta }, &mut Options::common())
}

/// The number of pairs, and frequencies with a second number each.
fn pairs(a: &mut Args<'_>, value: &Arg) -> Result<(Vec<f64>, Vec<f64>), Exception> {
    let n = a.count(&N)?;
    if n < 2 {
        return Err(a.refuse(format!("the number of frequencies n is {n}"), "expected 2 at least"));
    }
    let (mut frequencies, mut values) = (vec![], vec![]);
    for i in 1..=n {
        frequencies.push(a.nth_number(&FREQUENCY, i)?);
        values.push(a.nth_number(value, i)?);
    }
    Ok((frequencies, values))
}

fn user_defined_ratios(interp: &mut Tcl, a: &mut Args<'_>) -> Result<ElementDamping, Exception> {
    let (frequencies, ratios) = pairs(a, &RATIO)?;
    let last = a.last_span();
    let mut points: Vec<(f64, f64)> = frequencies.into_iter().zip(ratios).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    if points.iter().any(|p| p.1 <= 0.0) {
        return Err(a.refuse("a damping ratio is not positive", "expected numbers greater than 0"));
    }
    if points.windows(2).any(|p| p[0].0 == p[1].0) {
        return Err(a.refuse("a frequency is given twice", "expected different frequencies"));
    }
    let mut own =
        Options { known: &["-tol", "-maxiter", "-activateTime", "-deactivateTime", "-factor"], ..Options::common() };
    let law = DampingLaw::Filters { filters: Filters::default(), loss: None };
    let mut made = with_options(interp, a, law, &mut own)?;
    let (frequencies, ratios): (Vec<f64>, Vec<f64>) = points.into_iter().unzip();
    let Some(filters) = user_defined(&frequencies, &ratios, own.tolerance, own.rounds) else {
        let label = "expected a larger tolerance (-tol), or ratios that change less";
        return Err(a.refuse_at(last, "no number of filters has these damping ratios", label));
    };
    made.law = DampingLaw::Filters { filters, loss: None };
    Ok(made)
}

fn filters(interp: &mut Tcl, a: &mut Args<'_>) -> Result<ElementDamping, Exception> {
    let (frequencies, betas) = pairs(a, &COEFFICIENT)?;
    let law = DampingLaw::Filters { filters: Filters::new(&frequencies, betas), loss: None };
    with_options(interp, a, law, &mut Options::common())
}

/// A damping by its tag, after `-damp`.
pub(crate) fn of_tag(interp: &Tcl, a: &mut Args<'_>) -> Result<Arc<ElementDamping>, Exception> {
    a.of(&interp.host.builder.definitions.dampings).map(|(damping, _)| damping)
}

/// A damping by `-damp`, if that is the next word.
pub(crate) fn optional(interp: &Tcl, a: &mut Args<'_>) -> Result<Option<Arc<ElementDamping>>, Exception> {
    if a.flag("-damp") { of_tag(interp, a).map(Some) } else { Ok(None) }
}

/// The element with a damping, where it has one.
pub(crate) fn damped(
    element: Arc<dyn Element>,
    damping: Option<Arc<ElementDamping>>,
) -> ElementResult<Arc<dyn Element>> {
    Ok(match damping {
        Some(damping) => Arc::new(Damped::new(element, damping)?),
        None => element,
    })
}
