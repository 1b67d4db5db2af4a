//! Confined concrete.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown, slips, warn};
use hysteron_engine::material::{
    Confinement, ConfinementSection, Dilation, FrpConfinedConcrete02, Hoop, Jacket, Material, UltimateStrain,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;
use std::f64::consts::PI;

const JACKET: [Arg; 4] = [
    Arg::of("-JacketC", "tfrp", "thickness of the jacket tfrp").within(Domain::Positive),
    Arg::of("-JacketC", "Efrp", "modulus of the jacket Efrp").within(Domain::Positive),
    Arg::of("-JacketC", "erup", "hoop strain at rupture erup").within(Domain::Positive),
    Arg::of("-JacketC", "R", "radius of the concrete R").within(Domain::Positive),
];
const SIDES: [Arg; 3] = [
    Arg::of("-varnoub", "L1", "length L1").within(Domain::Positive),
    Arg::of("-varnoub", "L2", "length L2").within(Domain::Positive),
    Arg::of("-varnoub", "L3", "length L3").within(Domain::Positive),
];
/// A hoop.
const HOOPS: [Arg; 6] = [
    Arg::of("-varnoub", "phis", "bar diameter of the hoops").within(Domain::NotNegative),
    Arg::of("-varnoub", "S", "spacing of the hoops").within(Domain::Positive),
    Arg::of("-varnoub", "fyh", "yield stress of the hoops").within(Domain::Positive),
    Arg::of("-varnoub", "Es0", "modulus of the hoops").within(Domain::Positive),
    Arg::of("-varnoub", "haRatio", "hardening ratio of the hoops").within(Domain::Number),
    Arg::of("-varnoub", "mu", "ductility of the hoops").within(Domain::Number),
];
/// Inner ties of S2 to S5.
const TIES: [Arg; 6] = [
    Arg::of("-internal", "phisi", "bar diameter of the inner ties").within(Domain::NotNegative),
    Arg::of("-internal", "Si", "spacing of the inner ties").within(Domain::Positive),
    Arg::of("-internal", "fyhi", "yield stress of the inner ties").within(Domain::Positive),
    Arg::of("-internal", "Es0i", "modulus of the inner ties").within(Domain::Positive),
    Arg::of("-internal", "haRatioi", "hardening ratio of the inner ties").within(Domain::Number),
    Arg::of("-internal", "mui", "ductility of the inner ties").within(Domain::Number),
];
const WRAP: [Arg; 5] = [
    Arg::of("-wrap", "cover", "cover of the jacket").within(Domain::NotNegative),
    Arg::of("-wrap", "Am", "area Am of the jacket").within(Domain::Positive),
    Arg::of("-wrap", "Sw", "spacing Sw of the jacket").within(Domain::Positive),
    Arg::of("-wrap", "fuil", "strength fuil of the jacket").within(Domain::Positive),
    Arg::of("-wrap", "Es0w", "modulus Es0w of the jacket").within(Domain::Positive),
];
const FPC: Arg = Arg::number("fpc", "compressive strength fpc").also(&["fc"]);
const GAMMA: Arg =
    Arg::of("-gamma", "gamma", "share gamma of the strength to which the stress falls at the ultimate strain")
        .within(Domain::Positive);
const EPSCU: Arg = Arg::of("-epscu", "epscu", "ultimate strain epscu").within(Domain::Number);
const NU: Arg = Arg::of("-nu", "nu", "Poisson's ratio nu").within(Domain::NotNegative);
const PHI_LON: Arg = Arg::of("-varnoub", "phiLon", "diameter of the longitudinal bars phiLon").within(Domain::Positive);
const TOL: Arg = Arg::of("-tol", "tol", "tolerance tol").within(Domain::Positive);
const MAX_NUM_ITER: Arg = Arg::of("-maxNumIter", "maxNumIter", "number of iterations maxNumIter").within(Domain::Count);
const EPSCU_LIMIT: Arg =
    Arg::of("-epscuLimit", "epscuLimit", "largest ultimate strain epscuLimit").within(Domain::Positive);
const ST_RATIO: Arg = Arg::of("-stRatio", "stRatio", "strength ratio stRatio").within(Domain::Positive);

const FRPCONFINED_CONCRETE02_EC: Arg = Arg::positive("Ec", "initial modulus Ec");
const TENSION: [Arg; 2] =
    [Arg::positive("ft", "tensile strength ft"), Arg::positive("Ets", "softening modulus in tension Ets")];
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
                Arg::of("-Ultimate", "fcu", "ultimate stress and strain, in place of a jacket"),
                UNIT,
            ])
            .groups(&[&JACKET, &TENSION]),
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
                FPC,
                CONFINED_CONCRETE01_EC,
                EPSCU,
                Arg::flag("-scott", "ultimate strain of Scott, Park and Priestley"),
                GAMMA,
                NU,
                Arg::flag("-varub", "Poisson's ratio grows with the strain to 0.5"),
                PHI_LON,
                Arg::flag("-gravel", "aggregate of gravel in place of crushed stone"),
                Arg::flag("-silica", "concrete with silica fume"),
                TOL,
                MAX_NUM_ITER,
                EPSCU_LIMIT,
                ST_RATIO,
            ])
            .groups(&[&SIDES, &HOOPS, &TIES, &WRAP]),
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
        let [thickness, modulus, rupture, radius] = a.numbers(&JACKET)?;
        Jacket { thickness, modulus, rupture, radius }.confined(fc0, epsc0)
    } else if a.flag("-Ultimate") {
        (compressive(a, "ultimate stress fcu")?, compressive(a, "ultimate strain ecu")?)
    } else {
        // Concrete without confinement (Teng and others, 2009).
        (0.85 * fc0, 1.75 * epsc0)
    };
    if ec <= (fcc - fc0) / epscu {
        return Err(a.refuse("the initial modulus Ec is less than that of the second part", "expected more"));
    }
    let [ft, ets] = a.numbers(&TENSION)?;
    let mpa = if a.int(UNIT.meaning)? == 0 { KSI } else { 1.0 };
    Ok(FrpConfinedConcrete02 { fc0, ec, fcc, epscu, ft, ets, mpa }.shared())
}

/// Largest ultimate strain of an envelope, which bounds its points.
const MAX_STRAIN: f64 = 1.0;

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
fn hoop(a: &mut Args<'_>, words: &[Arg; 6], semi_length: f64) -> Result<Hoop, Exception> {
    let [diameter, spacing, yield_stress, modulus, hardening, ductility] = a.numbers(words)?;
    let (area, inertia) = (PI * diameter * diameter / 4.0, PI * diameter.powi(4) / 64.0);
    Ok(Hoop { semi_length, diameter, area, inertia, spacing, yield_stress, modulus, hardening, ductility })
}

/// Semi-lengths of the hoops of a section from its sides.
fn semi_lengths(a: &mut Args<'_>, section: ConfinementSection) -> Result<Vec<f64>, Exception> {
    use ConfinementSection::*;
    let mut l = vec![0.5 * a.number(&SIDES[0])?];
    match section {
        S1 | Circular => {}
        S2 | S3 => l.push(l[0] * 2f64.sqrt() / 2.0),
        S5 => l.push(l[0]),
        S4b => l.extend([l[0], 0.5 * a.number(&SIDES[1])?]),
        Rectangular => l.push(0.5 * a.number(&SIDES[1])?),
        S4a => {
            l.push(0.5 * a.number(&SIDES[1])?);
            l.extend([l[0], 0.5 * a.number(&SIDES[2])?]);
        }
    }
    Ok(l)
}

/// Area of the ties of a cross, divided by that of their bar, which lie at 45 degrees and belong to two sides.
const CROSS_TIES: f64 = std::f64::consts::SQRT_2 / 4.0;

/// A jacket, and for a rectangle a second one.
fn wrap(a: &mut Args<'_>, section: ConfinementSection, hoops: &mut Vec<Hoop>) -> Result<(), Exception> {
    let [cover, area, spacing, yield_stress, modulus] = a.numbers(&WRAP)?;
    let jacket = Hoop {
        semi_length: hoops[0].semi_length + 0.5 * hoops[0].diameter + cover,
        diameter: 0.0,
        area,
        inertia: 0.0,
        spacing,
        yield_stress,
        modulus,
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
    let fpc = match a.number(&FPC)?.abs() {
        0.0 => return Err(a.refuse("the compressive strength fpc is 0", "expected a strength in MPa")),
        x => x,
    };
    let ec = a.number(&CONFINED_CONCRETE01_EC)?;
    let (mut strain, mut gamma) = (None, None);
    match a.word("ultimate strain: -epscu, -scott or -gamma")?.as_ref() {
        "-scott" | "-Scott" => {}
        "-gamma" => gamma = Some(a.number(&GAMMA)?),
        "-epscu" => strain = Some(a.number(&EPSCU)?.abs()),
        _ => return Err(a.unknown_kind("ultimate strain", ["-epscu", "-scott", "-gamma"])),
    }
    let dilation = match a.word("Poisson's ratio: -nu, -varub or -varnoub")?.as_ref() {
        "-varUB" | "-varub" => Dilation::Bounded,
        "-varNoUB" | "-varnoub" => Dilation::Unbounded,
        "-nu" => Dilation::Constant(a.number(&NU)?),
        _ => return Err(a.unknown_kind("Poisson's ratio", ["-nu", "-varub", "-varnoub"])),
    };
    let lengths = semi_lengths(a, section)?;
    let first = hoop(a, &HOOPS, lengths[0])?;
    let bar = a.number(&PHI_LON)?;
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
                let mut ties = hoop(a, &TIES, concrete.hoops[last].semi_length)?;
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
            "-tol" => concrete.tolerance = a.number(&TOL)?,
            "-maxNumIter" => concrete.max_iterations = a.count(&MAX_NUM_ITER)?,
            "-epscuLimit" => limit = a.number(&EPSCU_LIMIT)?,
            "-stRatio" => {
                concrete.strength_ratio = a.number(&ST_RATIO)?;
                if concrete.strength_ratio > 1.0 {
                    return Err(a.refuse("the strength ratio stRatio is above 1", "expected a number from 0 to 1"));
                }
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(limit)
}
