//! Confined concrete.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_option, slips, warn};
use hysteron_engine::material::{
    Confinement, ConfinementSection, Dilation, FrpConfinedConcrete02, Hoop, Jacket, Material, UltimateStrain,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;
use std::f64::consts::PI;

const FRPCONFINED_CONCRETE02_EC: Arg = Arg::positive("Ec", "initial modulus Ec");
const FT: Arg = Arg::positive("ft", "tensile strength ft");
const ETS: Arg = Arg::positive("Ets", "softening modulus in tension Ets");
const UNIT: Arg = Arg::whole("Unit", "units, 1: MPa, 0: ksi");
const CONFINED_CONCRETE01_EC: Arg = Arg::positive("Ec", "modulus Ec");

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["FRPConfinedConcrete02"],
        usage: "uniaxialMaterial FRPConfinedConcrete02 $tag $fc0 $Ec $ec0 <-JacketC $tfrp $Efrp $erup $R | -Ultimate $fcu $ecu> \
                $ft $Ets $Unit",
        text: Text::new("Concrete confined by fibre-reinforced polymer.")
            .example(
                "uniaxialMaterial FRPConfinedConcrete02 77 -30. 25000. -0.002 -Ultimate -50. -0.012 3. \
                2000. 1",
            )
            .arguments(&[
                Arg::number("fc0", "strength fc0"),
                FRPCONFINED_CONCRETE02_EC,
                Arg::number("ec0", "strain at the strength ec0"),
                Arg::of(
                    "-JacketC",
                    "tfrp",
                    "jacket of a circular column: thickness, modulus, hoop strain at rupture, radius of the concrete",
                ),
                Arg::of("-Ultimate", "fcu", "ultimate stress and strain, in place of a jacket"),
                FT,
                ETS,
                UNIT,
            ]),
        make: frp_confined_concrete02,
    },
    Kind {
        names: &["ConfinedConcrete01"],
        usage: "uniaxialMaterial ConfinedConcrete01 $tag S1|S2|S3|S4a|S4b|S5|C|R $fpc $Ec -epscu $epscu | -scott | -gamma $gamma \
                -nu $nu | -varub | -varnoub $L1 <$L2> <$L3> $phis $S $fyh $Es0 $haRatio $mu $phiLon <-internal $phisi $Si $fyhi \
                $Es0i $haRatioi $mui> <-wrap $cover $Am $Sw $fuil $Es0w> <-gravel> <-silica> <-tol $tol> <-maxNumIter $maxNumIter> \
                <-epscuLimit $epscuLimit> <-stRatio $stRatio>",
        text: Text::new("Concrete confined by hoops and jackets, by Braga, Gigliotti and Laterza; MPa and mm.")
            .example(
                "uniaxialMaterial ConfinedConcrete01 77 S1 30. 26000. -epscu 0.02 -varub 300. 10. 100. 300. 206000. 0. \
                 1000. 16.",
            )
            .arguments(&[
                Arg::number("fpc", "compressive strength").also(&["fc"]),
                CONFINED_CONCRETE01_EC,
                Arg::of("-epscu", "epscu", "ultimate strain").within(Domain::Number),
                Arg::flag("-scott", "ultimate strain of Scott, Park and Priestley"),
                Arg::of(
                    "-gamma",
                    "gamma",
                    "the ultimate strain is where the stress has fallen to this share of the strength",
                )
                .within(Domain::Positive),
                Arg::of("-nu", "nu", "Poisson's ratio of the concrete, constant").within(Domain::NotNegative),
                Arg::flag("-varub", "Poisson's ratio grows with the strain to 0.5"),
                Arg::of("-varnoub", "L1", "side of the hoops, or diameter").within(Domain::Positive),
                Arg::of(
                    "-internal",
                    "phisi",
                    "inner ties of S2 to S5: diameter, spacing, yield stress, modulus, hardening ratio, ductility",
                ),
                Arg::of("-wrap", "cover", "jacket: cover of the hoops, area, spacing, strength, modulus")
                    .within(Domain::NotNegative),
                Arg::flag("-gravel", "aggregate of gravel in place of crushed stone"),
                Arg::flag("-silica", "concrete with silica fume"),
                Arg::of("-tol", "tol", "relative change of the secant modulus that ends the iteration")
                    .within(Domain::Positive),
                Arg::of("-maxNumIter", "maxNumIter", "most iterations at a strain").within(Domain::Whole),
                Arg::of("-epscuLimit", "epscuLimit", "largest ultimate strain of -gamma").within(Domain::Positive),
                Arg::of("-stRatio", "stRatio", "strength in the column over that of the cylinder")
                    .within(Domain::Positive),
            ]),
        make: confined_concrete01,
    },
];

/// Megapascal per ksi, in the digits of OpenSees.
const KSI: f64 = 6.895;

/// A number in compression, negative in the script, as a positive one.
fn compressive(a: &mut Args<'_>, what: &str) -> Result<f64, Exception> {
    match -a.float(what)? {
        value if value > 0.0 => Ok(value),
        value => Err(a.refuse(format!("the {what} is {}", -value), "expected a negative number: compression")),
    }
}

fn frp_confined_concrete02(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let fc0 = compressive(a, "strength fc0")?;
    let ec = a.number(&FRPCONFINED_CONCRETE02_EC)?;
    let epsc0 = compressive(a, "strain at the strength ec0")?;
    let (fcc, epscu) = if a.flag("-JacketC") {
        let jacket = Jacket {
            thickness: a.positive("thickness of the jacket tfrp")?,
            modulus: a.positive("modulus of the jacket Efrp")?,
            rupture: a.positive("hoop strain at rupture erup")?,
            radius: a.positive("radius of the concrete R")?,
        };
        jacket.confined(fc0, epsc0)
    } else if a.flag("-Ultimate") {
        (compressive(a, "ultimate stress fcu")?, compressive(a, "ultimate strain ecu")?)
    } else {
        // Concrete without confinement (Teng and others, 2009).
        (0.85 * fc0, 1.75 * epsc0)
    };
    if ec <= (fcc - fc0) / epscu {
        return Err(a.refuse("the initial modulus Ec is less than that of the second part", "expected more"));
    }
    let (ft, ets) = (a.number(&FT)?, a.number(&ETS)?);
    let mpa = if a.int(UNIT.meaning)? == 0 { KSI } else { 1.0 };
    Ok(FrpConfinedConcrete02 { fc0, ec, fcc, epscu, ft, ets, mpa }.shared())
}

/// Largest ultimate strain of an envelope, which bounds its points.
const MAX_STRAIN: f64 = 1.0;
/// Options of the command.
const OPTIONS: &[&str] =
    &["-internal", "-internalT", "-wrap", "-gravel", "-silica", "-tol", "-maxNumIter", "-epscuLimit", "-stRatio"];

fn section(a: &mut Args<'_>) -> Result<ConfinementSection, Exception> {
    use ConfinementSection::*;
    let known = [
        ("S1", S1),
        ("S2", S2),
        ("S3", S3),
        ("S4a", S4a),
        ("S4b", S4b),
        ("S5", S5),
        ("C", Circular),
        ("R", Rectangular),
    ];
    let word = a.word("type of the section")?;
    match known.iter().find(|(name, _)| *word == **name || *word == name.to_lowercase()) {
        Some((_, section)) => Ok(*section),
        None => Err(a.unknown_kind("type of section", known.iter().map(|k| k.0))),
    }
}

/// A hoop with the words from its diameter on.
fn hoop(a: &mut Args<'_>, of: &str, semi_length: f64) -> Result<Hoop, Exception> {
    let diameter = a.not_negative(&format!("bar diameter of {of}"))?;
    Ok(Hoop {
        semi_length,
        diameter,
        area: PI * diameter * diameter / 4.0,
        inertia: PI * diameter.powi(4) / 64.0,
        spacing: a.positive(&format!("spacing of {of}"))?,
        yield_stress: a.positive(&format!("yield stress of {of}"))?,
        modulus: a.positive(&format!("modulus of {of}"))?,
        hardening: a.float(&format!("hardening ratio of {of}"))?,
        ductility: a.float(&format!("ductility of {of}"))?,
    })
}

/// Semi-lengths of the hoops of a section from its sides.
fn semi_lengths(a: &mut Args<'_>, section: ConfinementSection) -> Result<Vec<f64>, Exception> {
    use ConfinementSection::*;
    let mut l = vec![0.5 * a.positive("length L1")?];
    match section {
        S1 | Circular => {}
        S2 | S3 => l.push(l[0] * 2f64.sqrt() / 2.0),
        S5 => l.push(l[0]),
        S4b => l.extend([l[0], 0.5 * a.positive("length L2")?]),
        Rectangular => l.push(0.5 * a.positive("length L2")?),
        S4a => {
            l.push(0.5 * a.positive("length L2")?);
            l.extend([l[0], 0.5 * a.positive("length L3")?]);
        }
    }
    Ok(l)
}

/// Area of the ties of a cross, divided by that of their bar, which lie at 45 degrees and belong to two sides.
const CROSS_TIES: f64 = std::f64::consts::SQRT_2 / 4.0;

/// A jacket, and for a rectangle a second one.
fn wrap(a: &mut Args<'_>, section: ConfinementSection, hoops: &mut Vec<Hoop>) -> Result<(), Exception> {
    let cover = a.not_negative("cover of the jacket")?;
    let jacket = Hoop {
        semi_length: hoops[0].semi_length + 0.5 * hoops[0].diameter + cover,
        diameter: 0.0,
        area: a.positive("area Am of the jacket")?,
        inertia: 0.0,
        spacing: a.positive("spacing Sw of the jacket")?,
        yield_stress: a.positive("strength fuil of the jacket")?,
        modulus: a.positive("modulus Es0w of the jacket")?,
        hardening: 1.0,
        ductility: 1.0,
    };
    let second = hoops[hoops.len() - 1];
    hoops.push(jacket);
    if section == ConfinementSection::Rectangular {
        hoops.push(Hoop { semi_length: second.semi_length + 0.5 * second.diameter + cover, ..jacket });
    }
    Ok(())
}

fn confined_concrete01(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    use ConfinementSection::*;
    let section = section(a)?;
    let fpc = match a.float("compressive strength fpc")?.abs() {
        0.0 => return Err(a.refuse("the compressive strength fpc is 0", "expected a strength in MPa")),
        x => x,
    };
    let ec = a.number(&CONFINED_CONCRETE01_EC)?;
    let (mut strain, mut gamma) = (None, None);
    match a.word("ultimate strain: -epscu, -scott or -gamma")?.as_ref() {
        "-scott" | "-Scott" => {}
        "-gamma" => gamma = Some(a.positive("share gamma of the strength")?),
        "-epscu" => strain = Some(a.float("ultimate strain epscu")?.abs()),
        _ => return Err(a.unknown_kind("ultimate strain", ["-epscu", "-scott", "-gamma"])),
    }
    let dilation = match a.word("Poisson's ratio: -nu, -varub or -varnoub")?.as_ref() {
        "-varUB" | "-varub" => Dilation::Bounded,
        "-varNoUB" | "-varnoub" => Dilation::Unbounded,
        "-nu" => Dilation::Constant(a.not_negative("Poisson's ratio nu")?),
        _ => return Err(a.unknown_kind("Poisson's ratio", ["-nu", "-varub", "-varnoub"])),
    };
    let lengths = semi_lengths(a, section)?;
    let first = hoop(a, "the hoops", lengths[0])?;
    let bar = a.positive("diameter of the longitudinal bars phiLon")?;
    let mut hoops: Vec<Hoop> = lengths.iter().map(|&semi_length| Hoop { semi_length, ..first }).collect();
    if section == S2 {
        hoops[1] = Hoop { area: first.area * CROSS_TIES, inertia: 0.0, ..hoops[1] };
    }
    let ultimate = UltimateStrain::Strain(0.0);
    let mut concrete = Confinement {
        section,
        hoops,
        fpc,
        strength_ratio: 1.0,
        ec,
        ultimate,
        dilation,
        bar,
        gravel: false,
        silica: false,
        tolerance: 1e-6,
        max_iterations: 500,
    };
    let limit = options(interp, a, &mut concrete)?;
    concrete.ultimate = match (strain, gamma) {
        (Some(e), _) => UltimateStrain::Strain(e),
        (_, Some(gamma)) => UltimateStrain::Share { gamma, limit },
        _ => UltimateStrain::Strain(concrete.scott()),
    };
    let (UltimateStrain::Strain(end) | UltimateStrain::Share { limit: end, .. }) = concrete.ultimate;
    if end > MAX_STRAIN {
        return Err(
            a.refuse(format!("the ultimate strain is {end}"), "expected at most 1; lengths in mm, stresses in MPa")
        );
    }
    let (law, unfinished) = concrete.law().map_err(|message| a.refuse(message, "expected mm and MPa"))?;
    if let Some(e) = unfinished {
        let d = Diagnostic::warning(
            &checks::materials::UNFINISHED_ITERATION,
            format!("the confining pressure did not converge at a strain of {e:.4}"),
        );
        warn(interp, d.at(a.last_span(), "more iterations (-maxNumIter) or a larger -tol may help"))?;
    }
    Ok(law.shared())
}

/// Options of the command; the largest ultimate strain is returned.
fn options(interp: &mut Tcl, a: &mut Args<'_>, concrete: &mut Confinement) -> Result<f64, Exception> {
    use ConfinementSection::*;
    let mut limit = 0.05;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-internal" | "-internalT" => {
                if matches!(concrete.section, S1 | Circular | Rectangular) {
                    return Err(a.refuse("this section has no inner ties", "expected S2, S3, S4a, S4b or S5"));
                }
                let last = concrete.hoops.len() - 1;
                let mut ties = hoop(a, "the inner ties", concrete.hoops[last].semi_length)?;
                if concrete.section == S2 {
                    // OpenSees takes the diameter in the place of the area.
                    let size = if interp.host.follows(&[slips::CROSS_TIES]) { ties.diameter } else { ties.area };
                    (ties.area, ties.inertia) = (size * CROSS_TIES, 0.0);
                }
                concrete.hoops[last] = ties;
            }
            "-wrap" => wrap(a, concrete.section, &mut concrete.hoops)?,
            "-gravel" => concrete.gravel = true,
            "-silica" => concrete.silica = true,
            "-tol" => concrete.tolerance = a.positive("tolerance tol")?,
            "-maxNumIter" => concrete.max_iterations = a.count("number of iterations maxNumIter")?,
            "-epscuLimit" => limit = a.positive("largest ultimate strain epscuLimit")?,
            "-stRatio" => {
                concrete.strength_ratio = a.positive("strength ratio stRatio")?;
                if concrete.strength_ratio > 1.0 {
                    return Err(a.refuse("the strength ratio stRatio is above 1", "expected a number from 0 to 1"));
                }
            }
            _ => ignore_option(interp, a, OPTIONS)?,
        }
    }
    Ok(limit)
}
