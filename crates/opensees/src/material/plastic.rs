//! Bars, plastic laws and connections.

use super::Kind;
use super::by_rules::by_rules;
use super::steel::{B, hardening_ratio};
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown, warn};
use hysteron_engine::material::{
    BarFatigue, BondSp01, Buckling, DoddRestrepo, Gng, Hardening, MAX_BACKSTRESSES, Material, MultiLinear,
    ReinforcingSteel, SteelFractureDi, UvcUniaxial,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const GOMES: [Arg; 4] = [
    Arg::of("-GABuck", "lsr", "slenderness lsr").within(Domain::NotNegative),
    Arg::of("-GABuck", "beta", "amplification beta").within(Domain::Number),
    Arg::of("-GABuck", "r", "buckling reduction r").within(Domain::Number),
    Arg::of("-GABuck", "gamma", "buckling constant gamma").within(Domain::Number),
];
const DM_ALPHA: Arg = Arg::of("-DMBuck", "alpha", "adjustment alpha").within(Domain::Number);
const FATIGUE: [Arg; 3] = [
    Arg::of("-CMFatigue", "Cf", "ductility constant Cf").within(Domain::NotNegative),
    Arg::of("-CMFatigue", "alpha", "fatigue exponent alpha").within(Domain::Number),
    Arg::of("-CMFatigue", "Cd", "strength reduction constant Cd").within(Domain::NotNegative),
];
const ISO_A1: Arg = Arg::of("-IsoHard", "a1", "hardening constant a1").within(Domain::Number);
const ISO_LIMIT: Arg = Arg::of("-IsoHard", "limit", "least share of the plateau").within(Domain::Number);
const CURVE: [Arg; 3] = [
    Arg::of("-MPCurveParams", "R1", "constant R1").within(Domain::Number),
    Arg::of("-MPCurveParams", "R2", "constant R2").within(Domain::Number),
    Arg::of("-MPCurveParams", "R3", "constant R3").within(Domain::Number),
];
const POINT_STRAIN: Arg = Arg::positive("u1", "strain of a point");
const POINT_STRESS: Arg = Arg::number("f1", "stress of a point");

const REINFORCING: [Arg; 2] = [Arg::positive("fy", "yield strength fy"), Arg::positive("fu", "ultimate strength fu")];
const REINFORCING_CURVE: [Arg; 4] = [
    Arg::positive("Es", "elastic modulus Es"),
    Arg::positive("Esh", "tangent of hardening Esh"),
    Arg::positive("esh", "strain of hardening esh"),
    Arg::positive("eult", "ultimate strain eult"),
];
const UVC: [Arg; 6] = [
    Arg::positive("E", "elastic modulus E"),
    Arg::positive("fy", "initial yield stress fy"),
    Arg::number("QInf", "growth QInf of the yield stress"),
    Arg::number("b", "rate b of the growth"),
    Arg::number("DInf", "decrease DInf of the yield stress"),
    Arg::number("a", "rate a of the decrease"),
];
const MODULUS_OF_BACKSTRESS: Arg = Arg::number("C1", "modulus C of backstress");
const RATE_OF_BACKSTRESS: Arg = Arg::not_negative("gamma1", "rate gamma of backstress");
const UVCUNIAXIAL_N: Arg = Arg::whole("N", "number of backstresses N");

const DODD_RESTREPO: [Arg; 7] = [
    Arg::positive("Fy", "yield stress Fy"),
    Arg::positive("Fsu", "strength Fsu"),
    Arg::not_negative("ESH", "strain ESH where hardening begins"),
    Arg::positive("ESU", "strain ESU of the strength"),
    Arg::positive("Youngs", "modulus Youngs"),
    Arg::number("ESHI", "strain ESHI on the hardening curve"),
    Arg::number("FSHI", "stress FSHI on the hardening curve"),
];
const OMEGA: Arg = Arg::number("OmegaFac", "factor of the Bauschinger curves OmegaFac");
const STRAIN_UNIT: [Arg; 1] = [Arg::positive("Conv", "unit of the strains Conv")];

const HARDENING: [Arg; 4] = [
    Arg::usually_positive("E", "elastic modulus E"),
    Arg::of_domain("sigmaY", "yield stress sigmaY", Domain::UsuallyNotNegative).also(&["fy", "Fy"]),
    Arg::number("Hiso", "isotropic hardening modulus Hiso").also(&["H_iso"]),
    Arg::number("Hkin", "kinematic hardening modulus Hkin").also(&["H_kin"]),
];
const VISCOSITY: Arg = Arg::number("eta", "viscosity eta");

const BAR: [Arg; 2] =
    [Arg::positive("fy", "yield strength fy of the bar"), Arg::positive("sy", "slip sy at the yield strength")];
const ULTIMATE: [Arg; 2] =
    [Arg::positive("fu", "ultimate strength fu of the bar"), Arg::number("su", "slip su at the ultimate strength")];
const LOOPS: [Arg; 2] = [Arg::positive("b", "initial hardening ratio b"), Arg::positive("R", "pinching factor R")];
/// Numbers without effect in OpenSees.
const UNUSED: [Arg; 4] = [
    Arg::number("Cd", "damage factor Cd"),
    Arg::number("db", "bar diameter db"),
    Arg::number("fc", "concrete strength fc"),
    Arg::number("la", "anchorage length la"),
];

const FRACTURE: [Arg; 3] = [
    Arg::positive("Fy", "yield strength in tension Fy").also(&["sigmaY", "fy"]),
    Arg::positive("FyC", "yield strength in compression FyC"),
    Arg::positive("E0", "elastic modulus E0").also(&["E"]),
];
const FRACTURE_TRANSITION: [Arg; 3] =
    [Arg::positive("R0", "sharpness of the transition R0"), Arg::number("cR1", "cR1"), Arg::positive("cR2", "cR2")];
const FRACTURE_ISOTROPIC: [Arg; 4] = [
    Arg::number("a1", "isotropic hardening parameter a1"),
    Arg::positive("a2", "isotropic hardening parameter a2"),
    Arg::number("a3", "isotropic hardening parameter a3"),
    Arg::positive("a4", "isotropic hardening parameter a4"),
];
const DAMAGE_INDEX: [Arg; 4] = [
    Arg::positive("sigcr", "critical sum of stresses sigcr"),
    Arg::not_negative("m", "share of compression that heals, m"),
    Arg::not_negative("sigmin", "stress sigmin up to which nothing counts"),
    Arg::positive("FI_lim", "index FI_lim at which the steel breaks"),
];

const GRIP: [Arg; 3] = [
    Arg::positive("E", "elastic stiffness E").also(&["k"]),
    Arg::positive("sigY", "yield force sigY").also(&["Fy", "fy"]),
    Arg::positive("P", "pitch of the teeth P"),
];
const GRIP_HARDENING: Arg = Arg::number("eta", "hardening ratio eta");

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["ReinforcingSteel"],
        usage: "uniaxialMaterial ReinforcingSteel $tag $fy $fu $Es $Esh $esh $eult <-GABuck $lsr $beta $r $gamma | \
                -DMBuck $lsr $alpha> <-CMFatigue $Cf $alpha $Cd> <-IsoHard $a1 $limit> <-MPCurveParams $R1 $R2 $R3>",
        text: Text::new("Reinforcing bar with yield plateau, strain hardening, buckling and fatigue.")
            .example("uniaxialMaterial ReinforcingSteel 77 60. 90. 29000. 700. 0.008 0.1")
            .arguments(&[
                Arg::of("-DMBuck", "lsr", "buckling of Dhakal and Maekawa: slenderness, adjustment 0.75 to 1"),
                ISO_A1,
                ISO_LIMIT,
            ])
            .groups(&[&REINFORCING, &REINFORCING_CURVE, &GOMES, &FATIGUE, &CURVE]),
        make: reinforcing_steel,
    },
    Kind {
        names: &["Dodd_Restrepo", "DoddRestrepo", "Restrepo"],
        usage: "uniaxialMaterial Dodd_Restrepo $tag $Fy $Fsu $ESH $ESU $Youngs $ESHI $FSHI <$OmegaFac <$Conv>>",
        text: Text::new("Reinforcing bar with a yield plateau, in true stresses and natural strains.")
            .example("uniaxialMaterial Dodd_Restrepo 77 400. 600. 0.01 0.12 2e5 0.04 520.")
            .groups(&[&DODD_RESTREPO, &[OMEGA], &STRAIN_UNIT]),
        make: dodd_restrepo,
    },
    Kind {
        names: &["Hardening"],
        usage: "uniaxialMaterial Hardening $tag $E $sigmaY $Hiso $Hkin <$eta>",
        text: Text::new("Plastic with linear kinematic and isotropic hardening.")
            .example("uniaxialMaterial Hardening 77 1 1 1 1")
            .groups(&[&HARDENING, &[VISCOSITY]]),
        make: hardening,
    },
    Kind {
        names: &["MultiLinear"],
        usage: "uniaxialMaterial MultiLinear $tag $u1 $f1 <$u2 $f2 ...>",
        text: Text::new("Plastic with a multilinear backbone and kinematic hardening.")
            .example("uniaxialMaterial MultiLinear 77 1 1")
            .arguments(&[POINT_STRAIN, POINT_STRESS, POINT_STRAIN.called("u2"), POINT_STRESS.called("f2")]),
        make: multi_linear,
    },
    Kind {
        names: &["UVCuniaxial"],
        usage: "uniaxialMaterial UVCuniaxial $tag $E $fy $QInf $b $DInf $a $N $C1 $gamma1 <$C2 $gamma2 ...>",
        text: Text::new("Structural steel: updated Voce-Chaboche plasticity.")
            .example("uniaxialMaterial UVCuniaxial 77 200. 2. 0.5 10. 0.3 100. 2 20. 40. 4. 5.")
            .arguments(&[
                UVCUNIAXIAL_N,
                MODULUS_OF_BACKSTRESS,
                RATE_OF_BACKSTRESS,
                MODULUS_OF_BACKSTRESS.called("C2"),
                RATE_OF_BACKSTRESS.called("gamma2"),
            ])
            .groups(&[&UVC]),
        make: uvc_uniaxial,
    },
    Kind {
        names: &["Bond_SP01", "Bond"],
        usage: "uniaxialMaterial Bond_SP01 $tag $fy $sy $fu $su $b $R <$Cd $db $fc $la>",
        text: Text::new("Slip of an anchored bar by strain penetration, ksi and in.")
            .example("uniaxialMaterial Bond_SP01 77 60. 0.02 90. 0.6 0.4 0.7")
            .groups(&[&BAR, &ULTIMATE, &LOOPS, &UNUSED]),
        make: bond_sp01,
    },
    Kind {
        names: &["SteelFractureDI"],
        usage: "uniaxialMaterial SteelFractureDI $tag $Fy $FyC $E0 $b $R0 $cR1 $cR2 $a1 $a2 $a3 $a4 $sigcr $m $sigmin $FI_lim",
        text: Text::new(
            "Steel of Giuffrè, Menegotto and Pinto that breaks in tension when a damage index comes to its limit.",
        )
        .example("uniaxialMaterial SteelFractureDI 77 1 1 1 2 1 1 1 1 1 1 1 1 1 1 1")
        .groups(&[&FRACTURE, &[B], &FRACTURE_TRANSITION, &FRACTURE_ISOTROPIC, &DAMAGE_INDEX]),
        make: steel_fracture_di,
    },
    Kind {
        names: &["GNG"],
        usage: "uniaxialMaterial GNG $tag $E $sigY $P <$eta>",
        text: Text::new("Grip 'n' grab: a tension device that ratchets.")
            .example("uniaxialMaterial GNG 77 1 1 1")
            .groups(&[&GRIP, &[GRIP_HARDENING]]),
        make: gng,
    },
];

fn steel_fracture_di(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [tension, compression, e0] = a.read_all(interp, &FRACTURE)?;
    let b = hardening_ratio(interp, a)?;
    if b == 1.0 {
        return Err(a.refuse("the hardening ratio is 1", "the asymptotes never meet"));
    }
    let [r0, c_r1, c_r2] = a.read_all(interp, &FRACTURE_TRANSITION)?;
    if c_r1 > 1.0 {
        return Err(a.refuse(format!("cR1 is {c_r1}"), "the sharpness would become negative: expected at most 1"));
    }
    let isotropic = a.read_all(interp, &FRACTURE_ISOTROPIC)?;
    let [critical, healing, threshold, limit] = a.read_all(interp, &DAMAGE_INDEX)?;
    let (fy, c_r) = ([compression, tension], [c_r1, c_r2]);
    let law = SteelFractureDi { fy, e0, b, r0, c_r, a: isotropic, critical, healing, threshold, limit };
    Ok(law.shared())
}

fn dodd_restrepo(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fy, fsu, esh, esu, e0, eshi, fshi] = a.read_all(interp, &DODD_RESTREPO)?;
    let omega = a.read_or(interp, &OMEGA, 1.0)?;
    let [unit] = a.read_all_or(interp, &STRAIN_UNIT, [1.0])?;
    let law = DoddRestrepo::new([fy, fsu], [esh, esu], e0, [eshi, fshi], omega, unit)
        .map_err(|message| a.refuse(message, "expected a point between the beginning of hardening and the strength"))?;
    Ok(law.compat(interp.host.follows(&[slips::BAUSCHINGER_ROUNDS])).shared())
}

fn hardening(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [e, sigma_y, h_iso, h_kin] = a.read_all(interp, &HARDENING)?;
    if e + h_iso + h_kin <= 0.0 {
        let message = format!("E + Hiso + Hkin is {}", e + h_iso + h_kin);
        return Err(a.refuse(message, "expected a modulus after yield that softens less than E stiffens"));
    }
    if a.read_optional(interp, &VISCOSITY)?.is_some_and(|eta| eta != 0.0) {
        let message = "Hardening: the viscosity is ignored, as in OpenSees";
        warn(
            interp,
            Diagnostic::warning(&checks::words::UNUSED_WORD, message).at(a.last_span(), "expected 0 or nothing"),
        )?;
    }
    Ok(Hardening { e, sigma_y, h_iso, h_kin, compat: interp.host.follows(&[slips::HARDENING_TRIAL]) }.shared())
}

fn multi_linear(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let mut points = vec![];
    while a.left() > 0 {
        points.push([a.number(&POINT_STRAIN)?, a.number(&POINT_STRESS)?]);
        let n = points.len();
        if n > 1 && points[n - 1][0] <= points[n - 2][0] {
            let message =
                format!("the strains of the points do not rise: {} after {}", points[n - 1][0], points[n - 2][0]);
            return Err(a.refuse(message, "expected a strain greater than that of the point before"));
        }
    }
    let compat = interp.host.follows(&[slips::MULTI_LINEAR_REST]);
    let law = MultiLinear::new(points, compat)
        .ok_or_else(|| a.refuse("MultiLinear has no points", "expected pairs of strain and stress"))?;
    Ok(law.shared())
}

fn uvc_uniaxial(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [e, fy, q_inf, b, d_inf, rate] = a.numbers(&UVC)?;
    let n = a.int(UVCUNIAXIAL_N.meaning)?;
    if !(0..=MAX_BACKSTRESSES as i32).contains(&n) {
        return Err(a.refuse(format!("there are {n} backstresses"), format!("expected 0 to {MAX_BACKSTRESSES}")));
    }
    let mut backstresses = vec![];
    for i in 1..=n {
        backstresses
            .push([a.nth_number(&MODULUS_OF_BACKSTRESS, i as usize)?, a.nth_number(&RATE_OF_BACKSTRESS, i as usize)?]);
    }
    Ok(
        by_rules!(interp, slips::UVC_RETURN, rules => UvcUniaxial { e, fy, q_inf, b, d_inf, a: rate, backstresses, rules }),
    )
}

/// Yield strength, ksi, and yield slip, in, from which on the units cannot be those of the law.
const LARGEST_BAR: [f64; 2] = [1000.0, 1.0];

fn bond_sp01(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fy, sy] = a.read_all(interp, &BAR)?;
    if fy >= LARGEST_BAR[0] || sy >= LARGEST_BAR[1] {
        let message = "Bond_SP01: the first reversal goes to a slip of 0.00405 in, whatever the units";
        warn(
            interp,
            Diagnostic::warning(&checks::materials::FIXED_UNITS, message).at(a.last_span(), "expected ksi and in"),
        )?;
    }
    let [fu, su] = a.read_all(interp, &ULTIMATE)?;
    if su <= sy {
        return Err(
            a.refuse(format!("the ultimate slip su is {su}"), format!("expected more than the yield slip, {sy}"))
        );
    }
    let [b, r] = a.read_all(interp, &LOOPS)?;
    for arg in &UNUSED {
        a.read_optional(interp, arg)?;
    }
    Ok(by_rules!(interp, slips::BOND_SLIP_TANGENT, rules => BondSp01 { fy, sy, fu, su, b, r, rules }))
}

fn gng(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [e, yield_stress, pitch] = a.read_all(interp, &GRIP)?;
    let mut eta = a.read_or(interp, &GRIP_HARDENING, 0.0)?;
    if eta.abs() >= 1.0 {
        let message = format!("GNG: the hardening ratio {eta} is taken for 0");
        warn(
            interp,
            Diagnostic::warning(&checks::words::REPLACED_VALUE, message)
                .at(a.last_span(), "expected a ratio between -1 and 1"),
        )?;
        eta = 0.0;
    }
    Ok(Gng { e, yield_stress, pitch, eta }.shared())
}

fn reinforcing_steel(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fy, fu] = a.numbers(&REINFORCING)?;
    if fu <= fy {
        return Err(a.refuse(format!("the ultimate strength fu is {fu}"), format!("expected more than fy, {fy}")));
    }
    let [es, esh, eps_sh, eps_ult] = a.numbers(&REINFORCING_CURVE)?;
    if eps_sh <= fy / es || eps_ult <= eps_sh {
        return Err(a.refuse(
            format!("the strains of yield, hardening and ultimate stress are {}, {eps_sh}, {eps_ult}", fy / es),
            "expected rising strains",
        ));
    }
    let (mut buckling, mut fatigue) = (Buckling::None, None);
    let (mut curve, mut hardening) = ([1.0 / 3.0, 18.0, 4.0], [0.0, 0.01]);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-GABuck" => {
                let [slenderness, _, reduction, pivot] = a.numbers(&GOMES)?;
                buckling = Buckling::Gomes { slenderness, reduction: reduction.clamp(0.0, 1.0), pivot };
            }
            "-DMBuck" => {
                let slenderness = a.number(&GOMES[0])?;
                let alpha = a.optional_number(&DM_ALPHA)?.unwrap_or(1.0);
                if !(0.75..=1.0).contains(&alpha) {
                    return Err(a.refuse(format!("the adjustment alpha is {alpha}"), "expected 0.75 to 1"));
                }
                buckling = Buckling::Dhakal { slenderness, alpha };
            }
            "-CMFatigue" => {
                let [cf, alpha, cd] = a.numbers(&FATIGUE)?;
                fatigue = (cf != 0.0 && alpha != 0.0).then_some(BarFatigue { cf, alpha, cd });
            }
            "-IsoHard" => {
                let rate = a.optional_number(&ISO_A1)?.unwrap_or(4.3);
                hardening = [rate, a.optional_number(&ISO_LIMIT)?.unwrap_or(0.01)];
            }
            "-MPCurveParams" => curve = a.numbers(&CURVE)?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(ReinforcingSteel { fy, fu, es, esh, eps_sh, eps_ult, buckling, fatigue, curve, hardening }.shared())
}
