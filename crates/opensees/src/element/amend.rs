//! `amend`: physics added to elements that a script has made.

use super::amended_place::Place;
use super::amendments::{AMENDMENTS, AmendmentKind, Make, MakeLaw};
use crate::args::Args;
use crate::load::amended_node::amend_node;
use crate::model::nodes::need_model;
use crate::model::parameter_change;
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Command, Outcome, Tcl, finish};
use hysteron_engine::element::amendment::{Amendment, Share};
use hysteron_engine::model::ElementId;
use hysteron_tcl::{Call, Exception, Value};

const SHARE_K: Arg = Arg::of("-share", "k", "stiffness of the elastic part").within(Domain::NotNegative);
const SHARE_ELASTIC: Arg =
    Arg::of("-share", "elastic", "measure in which it acts on the elastic part").within(Domain::Number);
const SHARE_REST: Arg = Arg::of("-share", "rest", "measure in which it acts on the rest").within(Domain::Number);

const TAG: Arg = Arg::whole("tag", "tag of the element");
const KIND: Arg = Arg::new("kind", "kind of amendment");

pub(crate) const COMMANDS: &[Command] = &[Command::new("amend", USAGE, amend)
    .about("Adds physics to an element that exists; see [Amendments](../amendments.md).")
    .own()
    .arguments(&[
        TAG,
        KIND,
        Arg::of("-option", "value", "options of the kind, below"),
        Arg::of("-axial", "dir", "direction that carries the axial force"),
        Arg::of("-axialSeries", "ts", "tag of a series of the compression"),
        SHARE_K,
        SHARE_ELASTIC,
        SHARE_REST,
        Arg::of("-strengthBeside", "k", "stiffness of the elastic part: a factor acts on the strength of the rest"),
        Arg::of("-range", "U", "largest deformation, speed and time for which the law was made"),
        Arg::of(
            "-hysteresis",
            "form",
            "`bilinear`, `boucWen`, `curve` or `own`; deformation before it slips, and strength (of `own` a factor of \
             the element's force)",
        ),
        Arg::of("-spring", "k", "stiffness of the spring"),
        Arg::of("-piece", "side", "side 1, -1 or 0 for both, deformation and stiffness of a piece of the spring"),
        Arg::of("-moving", "k", "stiffness of a spring about the middle of the extremes so far"),
        Arg::of("-curve", "slope", "slopes over the initial one, from unloading at the level to loading at it"),
        Arg::of("-unequal", "strength", "further strength of the positive side"),
        Arg::of("-stop", "level", "level and strength of a further stop"),
        Arg::of("-maxwell", "time", "time constant and stiffness of a Maxwell element"),
        Arg::of("-dashpot", "power", "power of the speed over that of the range, and force at that speed"),
        Arg::of("-viscous", "width", "speed over which friction is smoothed, over that of the range, and its force"),
        Arg::of("-work", "D", "largest work of a stop of the level and of stiffness one"),
        Arg::of(
            "-factor",
            "part",
            "part of the force, slow variable with its numbers, coefficient, and range of the \
             variable",
        ),
        Arg::of("-channel", "name", "name, mean and standard deviation of a channel"),
        Arg::of("-force", "name", "channel, force at three deviations from its mean, and range"),
        Arg::of("-series", "ts", "time series of each channel, or `axial` for the compression of the element"),
        Arg::of("-file", "file", "JSON file of a law"),
        Arg::flag("-beyond", "`clamp` or `continue`: what slow variables do beyond their range"),
        Arg::of("-mat", "mat", "tag of a law, moment over rotation"),
        Arg::flag("-end", "one end, `i` or `j`; both where it is left out"),
        Arg::of("-from", "old", "tag of the node at which the elements have ends"),
        Arg::of("-to", "new", "tag of a node in the same place, which takes the ends over"),
        Arg::new("other", "tag of the node whose mass-proportional damping counts"),
        Arg::of(
            "-by",
            "delay",
            "time, s, by which a uniform excitation reaches the support later; negative for earlier",
        ),
        Arg::new("name", "name of a number that `pset` declares"),
        parameter_change::FACTOR,
        parameter_change::FROM,
        parameter_change::REACHED,
        parameter_change::TO,
        parameter_change::RECOVERED,
    ])];

const USAGE: &str = "amend element $tag <$tag ...> $kind -option $value ... <-dir $dir1 <$dir2>> <-axial $dir | -axialSeries $ts> <-share $k $elastic <$rest> | -strengthBeside $k> | \
                     amend element $tag <$tag ...> learned -range $U $V $T -hysteresis $form $level $strength <-spring $k> <-piece $side $at $k ...> <-moving $k> <-curve $slope ...> <-unequal $strength> <-stop $level $strength ...> <-maxwell $time $k ...> <-dashpot $power $c ...> <-viscous $width $force ...> <-work $D> <-factor $part $variable ...> <-channel $name $mean $deviation ...> <-force $name $a $low $high ...> <-series $ts ...> <-beyond clamp|continue> <-dir $dir1 <$dir2>> | \
                     amend element $tag <$tag ...> learned -file $file <-series $ts ...> <-dir $dir1 <$dir2>> | \
                     amend element $tag <$tag ...> hinges -mat $mat <-end i|j> | \
                     amend element $tag <$tag ...> ends -from $old -to $new | \
                     amend node $tag dampedAs $other | amend node $tag late -by $delay | \
                     amend parameter $name -factor $f <-from $t1> <-reached $t2> <-to $t3> <-recovered $t4>";

fn amend(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, USAGE);
    match a.word("kind of thing to amend")?.as_ref() {
        "element" => {}
        "node" => return amend_node(interp, &mut a),
        "parameter" => return parameter_change::amend_parameter(interp, &mut a),
        _ => return Err(a.unknown_name("thing to amend", ["element", "node", "parameter"])),
    }
    let mut elements = vec![element_of(interp, &mut a)?];
    while a.at_number() {
        elements.push(element_of(interp, &mut a)?);
    }
    let name = a.word(KIND.meaning)?;
    let Some(kind) = AMENDMENTS.iter().find(|k| k.name == name) else {
        return Err(a.unknown_name("amendment", AMENDMENTS.iter().map(|k| k.name)));
    };
    let law = match kind.make {
        Make::Law(law) => law,
        Make::Words(make) => return make(interp, &mut a, &elements),
    };
    let words = Words::take(interp, &mut a, kind, law)?;
    finish(interp, &a)?;
    for id in elements {
        words.place.amend(interp, &a, id, &|stiffness| law.make(&words.numbers, words.share, stiffness))?;
    }
    Ok(Value::EMPTY)
}

/// Returns true if a law has a strength that the element loses.
fn weakens(law: &dyn Amendment) -> bool {
    let mut virgin = vec![0.0; law.state_len()];
    law.init(&mut virgin);
    law.weakening(&virgin).is_some()
}

/// Words after the kind of an amendment.
struct Words {
    /// One for each option.
    numbers: Vec<f64>,
    share: Share,
    place: Place,
}

impl Words {
    fn take(interp: &mut Tcl, a: &mut Args<'_>, kind: &AmendmentKind, law: &dyn MakeLaw) -> Result<Self, Exception> {
        let options = kind.options;
        let mut numbers: Vec<Option<f64>> = options.iter().map(|o| o.default).collect();
        let (mut share, mut place) = (Share::default(), Place::default());
        while let Some(word) = a.option() {
            if place.takes(interp, a, &word)? {
                continue;
            }
            match word.as_ref() {
                "-share" | "-strengthBeside" if share != Share::default() => {
                    return Err(a.refuse("two words for what the factor acts on", "expected -share or -strengthBeside"));
                }
                "-strengthBeside" => share = Share::strength_beside(a.number(&SHARE_K)?),
                "-share" => {
                    share.stiffness = a.number(&SHARE_K)?;
                    share.elastic = a.number(&SHARE_ELASTIC)?;
                    if a.at_number() {
                        share.hysteretic = a.number(&SHARE_REST)?;
                    }
                }
                word => {
                    let Some(i) = options.iter().position(|o| o.arg.option == word) else {
                        let common = ["-axial", "-axialSeries", "-dir", "-share", "-strengthBeside"];
                        let known = options.iter().map(|o| o.arg.option).chain(common);
                        return Err(a.unknown_name("option", known));
                    };
                    numbers[i] = Some(a.read(interp, &options[i].arg)?);
                }
            }
        }
        if let Some((o, _)) = options.iter().zip(&numbers).find(|(_, number)| number.is_none()) {
            let message = format!("amend {}: {} $value is missing", kind.name, o.arg.option);
            return Err(a.refuse(message, format!("expected the {} as well", o.arg.meaning)));
        }
        let numbers: Vec<f64> = numbers.into_iter().flatten().collect();
        if share.of_strength && !weakens(law.make(&numbers, share, 1.0).as_ref()) {
            let message = format!("amend {}: this law has no -strengthBeside", kind.name);
            return Err(a.refuse(message, "expected it of temperature, heating or degradation"));
        }
        Ok(Self { numbers, share, place })
    }
}

/// An element at rest, by its tag.
fn element_of(interp: &Tcl, a: &mut Args<'_>) -> Result<ElementId, Exception> {
    let tag = a.tag(things::ELEMENT, TAG.meaning)?;
    let engine = &interp.host.engine;
    let Some(id) = engine.model().element(tag) else {
        return Err(a.absent(things::ELEMENT, tag, "expected the tag of an element"));
    };
    if engine.model().elements[id.0].dofs.iter().any(|d| engine.state().disp[*d as usize] != 0.0) {
        let message = format!("element {tag} has been moved already");
        return Err(a.refuse(message, "amend it before the first analysis"));
    }
    Ok(id)
}
