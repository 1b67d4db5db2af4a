//! High damping rubber, and softening around any law.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown, read_text, warn};
use hysteron_engine::material::hdr::{Compound, NAMES, Parameters, Stack, Thermal};
use hysteron_engine::material::{Decay, GallardoShear, HdrRheology, Material, Mullins, Softening};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::{Diagnostic, Span};

const TEMPERATURE: Arg = Arg::of("-temperature", "T", "temperature of the rubber").within(Domain::Number);
/// Factors and exponents of the softening.
const SOFTENING: [[Arg; 2]; 4] = [
    [Arg::not_negative("fs1", "factor fs1 of the softening"), Arg::positive("ps1", "exponent ps1")],
    [Arg::not_negative("fs2", "factor fs2 of the softening of the cubic term"), Arg::positive("ps2", "exponent ps2")],
    [
        Arg::not_negative("fs3", "factor fs3 of the softening of the fifth-order term"),
        Arg::positive("ps3", "exponent ps3"),
    ],
    [Arg::not_negative("fm", "factor fm of the softening by cycles"), Arg::positive("pm", "exponent pm")],
];
const PPHI: Arg = Arg::not_negative("Pphi", "rate Pphi of the temporary hardening");
const THICKNESS: Arg = Arg::positive("h", "thickness h of the rubber");

const COMPOUND_NAME: Arg = Arg::of("-compound", "name", "name of a compound, or of a file with its table");
const AREA_A: Arg = Arg::of("-area", "A", "area of the bearing").within(Domain::Positive);
const HEIGHT_H: Arg = Arg::of("-height", "h", "height of the rubber").within(Domain::Positive);
const LINEAR_C: Arg = Arg::of("-linear", "C", "stiffness C of the linear overstress spring").within(Domain::Positive);
const HEAT_CAPACITY_C: Arg =
    Arg::of("-heatCapacity", "c", "heat capacity per volume of rubber").within(Domain::Positive);
const COOLING_TIME_S: Arg = Arg::of("-coolingTime", "s", "time constant of cooling").within(Domain::Positive);
const AMBIENT_T: Arg = Arg::of("-ambient", "T", "temperature of the surroundings").within(Domain::Number);
const PRELOAD_STRAIN: Arg = Arg::of("-preload", "strain", "strain of the preloading").within(Domain::NotNegative);
const EXCESS: Arg = Arg::not_negative("excess", "excess of stiffness of virgin rubber");
const STRAIN: Arg = Arg::positive("strain", "strain over which the excess goes");
const POWER_P: Arg = Arg::of("-power", "p", "exponent of the way back to the virgin path").within(Domain::Positive);
const FORCES: [Arg; 3] = [
    Arg::not_negative("a1", "force a1 of the linear term"),
    Arg::not_negative("a2", "force a2 of the cubic term"),
    Arg::not_negative("a3", "force a3 of the fifth-order term"),
];
const LOOP: [Arg; 3] = [
    Arg::positive("ky", "stiffness ky of the hysteretic part per strain"),
    Arg::positive("fy", "strength fy of the hysteretic part"),
    Arg::number("beta", "loop shape beta"),
];
const ETA: Arg = Arg::positive("eta", "exponent eta of the transition");
const PHI_MAX: Arg = Arg::not_negative("phiMax", "largest temporary hardening phiMax");

const HEALED: Arg = Arg::of("-heal", "fraction", "fraction that heals").within(Domain::NotNegative);
const HEALING_TIME: Arg = Arg::of("-heal", "time", "time constant of healing").within(Domain::Positive);

/// Arguments of the rheology, of the law and of the bearing.
pub(crate) const RHEOLOGY_ARGUMENTS: &[Arg] = &[
    Arg::new("C1eq", "parameter C1eq"),
    Arg::number("C2eq", "parameter C2eq"),
    Arg::number("C3eq", "parameter C3eq"),
    Arg::number("tauCrEq", "parameter tauCrEq"),
    Arg::number("m", "parameter m"),
    Arg::number("C1oe", "parameter C1oe"),
    Arg::number("C2oe", "parameter C2oe"),
    Arg::number("tauCrOe", "parameter tauCrOe"),
    Arg::number("a", "parameter a"),
    COMPOUND_NAME,
    LINEAR_C,
    HEAT_CAPACITY_C,
    COOLING_TIME_S,
    AMBIENT_T,
    EXCESS.after("-mullins"),
    STRAIN.after("-mullins"),
    HEALED,
    HEALING_TIME,
    PRELOAD_STRAIN,
];

/// Arguments of a stack of layers that conduct heat.
pub(crate) const CONDUCTION: [Arg; 9] = [
    Arg::count("layers", "number of layers of rubber").after("-conduction"),
    Arg::positive("tRubber", "thickness tRubber of a layer of rubber").after("-conduction"),
    Arg::not_negative("tSteel", "thickness tSteel of a steel plate").after("-conduction"),
    Arg::not_negative("tPlate", "thickness tPlate of an end plate").after("-conduction"),
    Arg::positive("kRubber", "thermal conductivity kRubber").after("-conduction"),
    Arg::positive("cRubber", "heat capacity cRubber per volume of rubber").after("-conduction"),
    Arg::positive("kSteel", "thermal conductivity kSteel").after("-conduction"),
    Arg::positive("cSteel", "heat capacity cSteel per volume of steel").after("-conduction"),
    Arg::not_negative("film", "heat transfer coefficient film of the end plates").after("-conduction"),
];

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["HDRRheology"],
        usage: USAGE,
        text: Text::new(
            "High damping rubber with rate, temperature and self-heating; see [High damping \
             rubber](../../explanation/rubber.md).",
        )
        .example("uniaxialMaterial HDRRheology 77 0.4 0.05 0.01 0.2 3. 0.9 0.1 0.4 0.3 0.2")
        .own()
        .arguments(&[Arg::number("n", "parameter n"), AREA_A, HEIGHT_H])
        .groups(&[RHEOLOGY_ARGUMENTS, &CONDUCTION]),
        make: |interp, a| Ok(rheology(interp, a, |_, _, _| Ok(false))?.shared()),
    },
    Kind {
        names: &["Mullins"],
        usage: "uniaxialMaterial Mullins $tag $material $excess $strain <-power $p> <-heal $fraction $time> \
                <-preload $strain>",
        text: Text::new(
            "Softens another law as virgin rubber softens; see [High damping rubber](../../explanation/rubber.md).",
        )
        .example("uniaxialMaterial Mullins 77 1 1 1")
        .own()
        .arguments(&[EXCESS, STRAIN, POWER_P, HEALED, HEALING_TIME, PRELOAD_STRAIN]),
        make: mullins,
    },
    Kind {
        names: &["HDR_mat"],
        usage: "uniaxialMaterial HDR_mat $tag $a1 $a2 $a3 $fs1 $ps1 $fs2 $ps2 $fs3 $ps3 $fm $pm $ky $fy $beta $eta \
                $phiMax $Pphi $h",
        text: Text::new(
            "Shear of a high damping rubber bearing by Gallardo et al. (2023): softening by the largest strain and by \
             cycles, stiffening, temporary hardening. Forces over displacements.",
        )
        .example(
            "uniaxialMaterial HDR_mat 77 46. 59. 317. 1.04 0.38 30. 0.71 3.4 0.37 0.06 0.57 121. 1.8 0.9 0.32 \
             0.14 0.018 20.4",
        )
        .groups(&[&FORCES, SOFTENING.as_flattened(), &LOOP, &[ETA, PHI_MAX, PPHI, THICKNESS]])
        .own(),
        make: gallardo,
    },
];

pub(crate) const USAGE: &str = "uniaxialMaterial HDRRheology $tag -compound $name -temperature $T | $C1eq \
    $C2eq $C3eq $tauCrEq $m $C1oe $C2oe $tauCrOe $a $n <-area $A -height $h> <-linear $C> \
    <-heatCapacity $c <-coolingTime $s>> <-conduction $layers $tRubber $tSteel $tPlate $kRubber $cRubber $kSteel \
    $cSteel $film> <-ambient $T> <-beyond hold|error> <-mullins $excess $strain <-heal $fraction $time> <-preload \
    $strain>>";

/// The options as far as they have been taken.
#[derive(Default)]
struct Options {
    compound: Option<(Compound, Option<Span>)>,
    temperature: Option<(f64, Option<Span>)>,
    ambient: Option<(f64, Option<Span>)>,
    area: Option<f64>,
    height: Option<f64>,
    linear: Option<f64>,
    capacity: Option<f64>,
    cooling: Option<(f64, Option<Span>)>,
    stack: Option<(Stack, Option<Span>)>,
    hold_ends: Option<bool>,
    softening: Option<Softening>,
}

/// A law of high damping rubber from parameters and options. `known` are the options that may be given, and `other` takes
/// those that are not the law's: the last word taken is one.
pub(crate) fn rheology(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    mut other: impl FnMut(&mut Tcl, &mut Args<'_>, &str) -> Result<bool, Exception>,
) -> Result<HdrRheology, Exception> {
    let (mut o, known) = (Options::default(), a.options());
    if a.at_number() {
        o.compound = Some((Compound::constant(explicit(a)?), None));
    }
    let explicit = o.compound.is_some();
    while let Some(option) = a.option() {
        match option.as_ref() {
            option if !known.contains(&option) => ignore_unknown(interp, a)?,
            "-compound" if explicit => {
                return Err(a.refuse(
                    "the parameters are given already, by number",
                    "expected either -compound or ten numbers",
                ));
            }
            "-compound" => o.compound = Some((compound(interp, a)?, a.last_span())),
            "-temperature" => o.temperature = Some((a.number(&TEMPERATURE)?, a.last_span())),
            "-ambient" => o.ambient = Some((a.number(&AMBIENT_T)?, a.last_span())),
            "-area" => o.area = Some(a.number(&AREA_A)?),
            "-height" => o.height = Some(a.number(&HEIGHT_H)?),
            "-linear" => o.linear = Some(a.number(&LINEAR_C)?),
            "-heatCapacity" => o.capacity = Some(a.number(&HEAT_CAPACITY_C)?),
            "-coolingTime" => o.cooling = Some((a.number(&COOLING_TIME_S)?, a.last_span())),
            "-conduction" => o.stack = Some((stack(a)?, a.last_span())),
            "-beyond" => {
                o.hold_ends = Some(match a.word("what to do beyond the table: hold or error")?.as_ref() {
                    "hold" => true,
                    "error" => false,
                    _ => return Err(a.unknown_name("way beyond the table", ["hold", "error"])),
                });
            }
            "-mullins" => o.softening = Some(softening(a)?),
            "-heal" | "-preload" if o.softening.is_none() => {
                return Err(a.refuse(format!("{option} stands without softening"), "expected -mullins before"));
            }
            "-heal" => heal(a, o.softening.as_mut())?,
            "-preload" => preload(a, o.softening.as_mut())?,
            option => {
                if !other(interp, a, option)? {
                    ignore_unknown(interp, a)?;
                }
            }
        }
    }
    assemble(interp, a, o, explicit)
}

/// The law from its options.
fn assemble(interp: &mut Tcl, a: &Args<'_>, o: Options, explicit: bool) -> Result<HdrRheology, Exception> {
    let Some((compound, span)) = o.compound else {
        return Err(a.refuse("HDRRheology has no parameters", "expected -compound with a name, or ten numbers"));
    };
    let compound = match o.linear {
        Some(c2_oe) => compound.map(|p| Parameters { c1_oe: 0.0, tau_cr_oe: 0.0, c2_oe, ..*p }),
        None => compound,
    };
    let ambient = match (o.ambient, o.temperature) {
        (Some((ambient, _)), Some((t, at))) if t != ambient => {
            let d = Diagnostic::warning(
                &checks::words::OVERRIDDEN,
                format!("HDRRheology: the rubber begins at the -ambient {ambient}, not at {t}"),
            );
            warn(interp, d.at(at, "is ignored: expected one of -temperature and -ambient"))?;
            ambient
        }
        (Some((t, _)), _) | (None, Some((t, _))) => t,
        (None, None) if explicit => 0.0,
        (None, None) => return Err(a.refuse_at(span, "a compound without a temperature", "expected -temperature too")),
    };
    if let Err(e) = compound.at(ambient) {
        let at = o.ambient.or(o.temperature).and_then(|(_, at)| at);
        let (lo, hi) = e.range;
        return Err(a.refuse_at(at, e.to_string(), format!("expected a temperature from {lo} to {hi}")));
    }
    let thermal = match (o.capacity, o.cooling, o.stack) {
        (None, None, None) => None,
        (Some(capacity), cooling, None) => Some(Thermal::lumped(capacity, cooling.map_or(f64::INFINITY, |c| c.0))),
        (None, None, Some((stack, _))) => Some(Thermal::stack(&stack)),
        (_, _, Some((_, at))) => {
            let label = "expected either -conduction or -heatCapacity with -coolingTime";
            return Err(a.refuse_at(at, "two kinds of self-heating", label));
        }
        (None, Some((_, at)), None) => {
            return Err(a.refuse_at(at, "-coolingTime stands without self-heating", "expected -heatCapacity too"));
        }
    };
    if thermal.is_some() && !explicit && o.hold_ends.is_none() {
        let (lo, hi) = compound.range();
        let d = Diagnostic::warning(
            &checks::materials::BEYOND_COMPOUND,
            format!(
                "HDRRheology: the compound is known from {lo} to {hi}; rubber that heats itself beyond keeps the parameters \
             of {hi}"
            ),
        );
        let d = d.at(span, "the temperature goes on to rise, the parameters do not change");
        warn(interp, d.help("\"-beyond hold\" says that this is meant, \"-beyond error\" stops there"))?;
    }
    Ok(HdrRheology {
        ambient,
        thermal,
        hold_ends: o.hold_ends.unwrap_or(true),
        softening: o.softening,
        area: o.area.unwrap_or(1.0),
        height: o.height.unwrap_or(1.0),
        compound,
    })
}

/// Ten parameters by number.
fn explicit(a: &mut Args<'_>) -> Result<Parameters, Exception> {
    let mut p = [0.0; 10];
    let mut spans = [None; 10];
    for ((x, span), (name, ..)) in p.iter_mut().zip(&mut spans).zip(NAMES) {
        *x = a.float(&format!("parameter {name}"))?;
        *span = a.last_span();
    }
    Parameters::new(p).map_err(|(i, label)| a.refuse_at(spans[i], format!("{} is {}", NAMES[i].0, p[i]), label))
}

/// A compound that comes with the program, or from a table in a file.
fn compound(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Compound, Exception> {
    let name = a.word(COMPOUND_NAME.meaning)?;
    let text = match Compound::built_in(&name) {
        Some(text) => text.to_owned(),
        None if name.contains('.') => read_text(interp, &name)
            .map_err(|e| a.refuse(format!("cannot read the compound {name}: {e}"), "expected the name of a file"))?,
        None => return Err(a.unknown_name("compound", Compound::names())),
    };
    Compound::parse(&text).map_err(|e| a.refuse(format!("compound {name}: {e}"), "expected a table of parameters"))
}

fn stack(a: &mut Args<'_>) -> Result<Stack, Exception> {
    let [layers, rubber, steel, plate, k_rubber, c_rubber, k_steel, c_steel, film] = a.numbers(&CONDUCTION)?;
    let (rubber_properties, steel_properties) = ((k_rubber, c_rubber), (k_steel, c_steel));
    Ok(Stack { layers: layers as usize, rubber, steel, plate, rubber_properties, steel_properties, film })
}

fn softening(a: &mut Args<'_>) -> Result<Softening, Exception> {
    let excess = a.number(&EXCESS)?;
    let strain = a.number(&STRAIN)?;
    Ok(Softening { excess, strain, power: None, healed: 0.0, time: 1.0, preload: 0.0 })
}

fn heal(a: &mut Args<'_>, softening: Option<&mut Softening>) -> Result<(), Exception> {
    let healed = a.number(&HEALED)?;
    if healed > 1.0 {
        return Err(a.refuse(format!("the fraction that heals is {healed}"), "expected a fraction, 0 to 1"));
    }
    let time = a.number(&HEALING_TIME)?;
    if let Some(s) = softening {
        (s.healed, s.time) = (healed, time);
    }
    Ok(())
}

fn preload(a: &mut Args<'_>, softening: Option<&mut Softening>) -> Result<(), Exception> {
    let preload = a.number(&PRELOAD_STRAIN)?;
    if let Some(s) = softening {
        s.preload = preload;
    }
    Ok(())
}

fn mullins(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let inner = a.of(&interp.host.builder.definitions.materials)?;
    let mut law = softening(a)?;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-heal" => heal(a, Some(&mut law))?,
            "-preload" => preload(a, Some(&mut law))?,
            "-power" => law.power = Some(a.number(&POWER_P)?),
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(Mullins::new(inner, law).shared())
}

/// A factor and an exponent of a softening.
fn decay(a: &mut Args<'_>, [factor, power]: &[Arg; 2]) -> Result<Decay, Exception> {
    Ok(Decay { factor: a.number(factor)?, power: a.number(power)? })
}

fn gallardo(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let forces = a.numbers(&FORCES)?;
    let softening = [decay(a, &SOFTENING[0])?, decay(a, &SOFTENING[1])?, decay(a, &SOFTENING[2])?];
    let cycling = decay(a, &SOFTENING[3])?;
    let [ky, fy, beta] = a.numbers(&LOOP)?;
    if !(0.5..=1.0).contains(&beta) {
        return Err(a.refuse(format!("beta is {beta}"), "expected a number from 0.5 to 1"));
    }
    let eta = a.number(&ETA)?;
    let phi_max = a.number(&PHI_MAX)?;
    if phi_max >= 0.5 {
        return Err(a.refuse(
            format!("phiMax is {phi_max}"),
            "expected a number less than 0.5: the hysteretic force would not be bounded",
        ));
    }
    let [phi_rate, height] = a.numbers(&[PPHI, THICKNESS])?;
    Ok(GallardoShear { a: forces, softening, cycling, ky, fy, beta, eta, phi_max, phi_rate, height }.shared())
}
