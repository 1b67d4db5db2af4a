//! Steels and other plastic materials.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Text};
use crate::{Tcl, ignore_option, warn};
use hysteron_engine::material::{
    BarFatigue, BondSp01, BrbBranch, Buckling, Cast, DoddRestrepo, Gng, Hardening, MAX_BACKSTRESSES, Material,
    MultiLinear, ReinforcingSteel, Steel01, Steel02, Steel03, SteelBrb, SteelFractureDi, SteelMpf, UvcUniaxial,
};
use hysteron_engine::rules::{Consistent, OpenSees};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["CastFuse", "Cast"],
        usage: "uniaxialMaterial CastFuse $tag $n $bo $h $fy $E $L $b $R0 $cR1 $cR2 <$a1 $a2 $a3 $a4>",
        text: Text::new("Yielding fingers of a cast steel brace, which pull at large deformations.")
            .example("uniaxialMaterial CastFuse 77 8 5. 1.5 50. 29000. 12. 0.05 20. 0.92 0.15")
            .arguments(&[Arg::new("a1", "isotropic hardening in compression, its scale, and the same in tension")]),
        make: cast_fuse,
    },
    Kind {
        names: &["Steel01"],
        usage: "uniaxialMaterial Steel01 $tag $Fy $E0 $b <$a1 $a2 $a3 $a4>",
        text: Text::new("Bilinear steel with kinematic and optional isotropic hardening."),
        make: steel01,
    },
    Kind {
        names: &["Steel02"],
        usage: "uniaxialMaterial Steel02 $tag $Fy $E0 $b <$R0 $cR1 $cR2 <$a1 $a2 $a3 $a4 <$sigInit>>>",
        text: Text::new("Steel of Giuffré, Menegotto and Pinto with curved transitions."),
        make: steel02,
    },
    Kind {
        names: &["Steel03"],
        usage: "uniaxialMaterial Steel03 $tag $fy $E0 $b $r $cR1 $cR2 <$a1 $a2 $a3 $a4>",
        text: Text::new("Steel with a curved transition to hardening and isotropic hardening as of `Steel01`."),
        make: steel03,
    },
    Kind {
        names: &["SteelBRB"],
        usage: "uniaxialMaterial SteelBRB $tag $E $sigmaY0 $sigmaYT $alphaT $betaT $deltaT $sigmaYC $alphaC $betaC $deltaC \
                <$tol>",
        text: Text::new("Steel core of a buckling-restrained brace."),
        make: steel_brb,
    },
    Kind {
        names: &["SteelMPF"],
        usage: "uniaxialMaterial SteelMPF $tag $fyp $fyn $E0 $bp $bn $R0 $cR1 $cR2 <$a1 $a2 $a3 $a4>",
        text: Text::new("Steel of Menegotto and Pinto with its own yield strength and hardening on either side."),
        make: steel_mpf,
    },
    Kind {
        names: &["ReinforcingSteel"],
        usage: "uniaxialMaterial ReinforcingSteel $tag $fy $fu $Es $Esh $esh $eult <-GABuck $lsr $beta $r $gamma | \
                -DMBuck $lsr $alpha> <-CMFatigue $Cf $alpha $Cd> <-IsoHard $a1 $limit> <-MPCurveParams $R1 $R2 $R3>",
        text: Text::new("Reinforcing bar with yield plateau, strain hardening, buckling and fatigue.")
            .example("uniaxialMaterial ReinforcingSteel 77 60. 90. 29000. 700. 0.008 0.1")
            .arguments(&[
                Arg::of(
                    "-GABuck",
                    "lsr",
                    "buckling of Gomes and Appleton: slenderness, an amplification that OpenSees does not use, least \
                     share of the buckled stress, stress of the pivot as a share of the ultimate one",
                ),
                Arg::of("-DMBuck", "lsr", "buckling of Dhakal and Maekawa: slenderness, adjustment 0.75 to 1"),
                Arg::of(
                    "-CMFatigue",
                    "Cf",
                    "fatigue of Coffin and Manson: ductility constant, exponent, strength reduction constant",
                ),
                Arg::of("-IsoHard", "a1", "shortening of the yield plateau per plastic strain, and its least share"),
                Arg::of("-MPCurveParams", "R1", "constants of the curves after reversals"),
            ]),
        make: reinforcing_steel,
    },
    Kind {
        names: &["Dodd_Restrepo", "DoddRestrepo", "Restrepo"],
        usage: "uniaxialMaterial Dodd_Restrepo $tag $Fy $Fsu $ESH $ESU $Youngs $ESHI $FSHI <$OmegaFac <$Conv>>",
        text: Text::new("Reinforcing bar with a yield plateau, in true stresses and natural strains.")
            .example("uniaxialMaterial Dodd_Restrepo 77 400. 600. 0.01 0.12 2e5 0.04 520."),
        make: dodd_restrepo,
    },
    Kind {
        names: &["Hardening"],
        usage: "uniaxialMaterial Hardening $tag $E $sigmaY $Hiso $Hkin <$eta>",
        text: Text::new("Plastic with linear kinematic and isotropic hardening."),
        make: hardening,
    },
    Kind {
        names: &["MultiLinear"],
        usage: "uniaxialMaterial MultiLinear $tag $u1 $f1 <$u2 $f2 ...>",
        text: Text::new("Plastic with a multilinear backbone and kinematic hardening.").arguments(&[
            Arg::new("u2", "strains of more points"),
            Arg::new("f2", "stresses of more points"),
            Arg::new("u1", "strain of the first point"),
            Arg::new("f1", "stress of the first point"),
        ]),
        make: multi_linear,
    },
    Kind {
        names: &["UVCuniaxial"],
        usage: "uniaxialMaterial UVCuniaxial $tag $E $fy $QInf $b $DInf $a $N $C1 $gamma1 <$C2 $gamma2 ...>",
        text: Text::new("Structural steel: updated Voce-Chaboche plasticity.")
            .example("uniaxialMaterial UVCuniaxial 77 200. 2. 0.5 10. 0.3 100. 2 20. 40. 4. 5.")
            .arguments(&[
                Arg::new("C2", "modulus of the second backstress"),
                Arg::new("gamma2", "rate of the second backstress"),
            ]),
        make: uvc_uniaxial,
    },
    Kind {
        names: &["Bond_SP01", "Bond"],
        usage: "uniaxialMaterial Bond_SP01 $tag $fy $sy $fu $su $b $R <$Cd $db $fc $la>",
        text: Text::new("Slip of an anchored bar by strain penetration, ksi and in.")
            .example("uniaxialMaterial Bond_SP01 77 60. 0.02 90. 0.6 0.4 0.7"),
        make: bond_sp01,
    },
    Kind {
        names: &["SteelFractureDI"],
        usage: "uniaxialMaterial SteelFractureDI $tag $Fy $FyC $E0 $b $R0 $cR1 $cR2 $a1 $a2 $a3 $a4 $sigcr $m $sigmin $FI_lim",
        text: Text::new(
            "Steel of Giuffrè, Menegotto and Pinto that breaks in tension when a damage index comes to its limit.",
        ),
        make: steel_fracture_di,
    },
    Kind {
        names: &["GNG"],
        usage: "uniaxialMaterial GNG $tag $E $sigY $P <$eta>",
        text: Text::new("Grip 'n' grab: a tension device that ratchets."),
        make: gng,
    },
];

/// The hardening ratio of a steel, with a warning where it is none: numbers in another order, or percent.
fn hardening_ratio(interp: &mut Tcl, a: &mut Args<'_>) -> Result<f64, Exception> {
    let b = a.float("hardening ratio b")?;
    if !(0.0..=1.0).contains(&b) {
        let d = Diagnostic::warning(&checks::materials::UNUSUAL_PARAMETER, format!("the hardening ratio b is {b}"));
        let d = d.at(a.last_span(), "expected the stiffness after yielding over that before, 0 to 1");
        let what = if b < 0.0 { "softens after yielding" } else { "is stiffer after yielding than before" };
        warn(interp, d.help(format!("such a steel {what}")))?;
    }
    Ok(b)
}

fn steel01(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let fy = a.usually_positive(interp, "yield strength Fy")?;
    let e0 = a.usually_positive(interp, "elastic modulus E0")?;
    let b = hardening_ratio(interp, a)?;
    let isotropic = isotropic(a, Steel01::NO_ISOTROPIC)?;
    Ok(Steel01 { fy, e0, b, a: isotropic }.shared())
}

/// a1 to a4: all or none.
fn isotropic(a: &mut Args<'_>, mut values: [f64; 4]) -> Result<[f64; 4], Exception> {
    if a.left() > 0 {
        for (value, name) in values.iter_mut().zip(["a1", "a2", "a3", "a4"]) {
            *value = a.float(&format!("isotropic hardening parameter {name}"))?;
        }
    }
    Ok(values)
}

fn steel03(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let fy = a.positive("yield stress fy")?;
    let e0 = a.positive("elastic modulus E0")?;
    let b = hardening_ratio(interp, a)?;
    if b == 1.0 {
        return Err(a.refuse("the hardening ratio is 1", "the asymptotes never meet: use the material Elastic"));
    }
    let r = a.positive("radius of the transition r")?;
    let c_r = [a.not_negative("coefficient cR1")?, a.not_negative("coefficient cR2")?];
    if c_r[0] >= Steel03::TRILINEAR && c_r[1] == 0.0 {
        return Err(a.refuse("the coefficient cR2 is 0", "expected more than 0, or cR1 less than 0.1"));
    }
    let isotropic = isotropic(a, Steel03::NO_ISOTROPIC)?;
    for scale in [isotropic[1], isotropic[3]] {
        if scale <= 0.0 {
            let label = "expected a2 and a4 greater than 0";
            return Err(a.refuse(format!("isotropic hardening starts at {scale} yield strains"), label));
        }
    }
    Ok(Steel03 { fy, e0, b, r, c_r, a: isotropic }.shared())
}

fn steel_fracture_di(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let tension = a.positive("yield strength in tension Fy")?;
    let fy = [a.positive("yield strength in compression FyC")?, tension];
    let e0 = a.positive("elastic modulus E0")?;
    let b = hardening_ratio(interp, a)?;
    if b == 1.0 {
        return Err(a.refuse("the hardening ratio is 1", "the asymptotes never meet"));
    }
    let r0 = a.positive("sharpness of the transition R0")?;
    let c_r = [a.float("cR1")?, a.positive("cR2")?];
    if c_r[0] > 1.0 {
        return Err(a.refuse(format!("cR1 is {}", c_r[0]), "the sharpness would become negative: expected at most 1"));
    }
    let mut isotropic = [0.0; 4];
    for (i, value) in isotropic.iter_mut().enumerate() {
        let what = format!("isotropic hardening parameter a{}", i + 1);
        *value = if i % 2 == 0 { a.float(&what)? } else { a.positive(&what)? };
    }
    let critical = a.positive("critical sum of stresses sigcr")?;
    let healing = a.not_negative("share of compression that heals, m")?;
    let threshold = a.not_negative("stress sigmin up to which nothing counts")?;
    let limit = a.positive("index FI_lim at which the steel breaks")?;
    let law = SteelFractureDi { fy, e0, b, r0, c_r, a: isotropic, critical, healing, threshold, limit };
    Ok(law.shared())
}

fn steel02(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let fy = a.usually_positive(interp, "yield strength Fy")?;
    let e0 = a.usually_positive(interp, "elastic modulus E0")?;
    let b = hardening_ratio(interp, a)?;
    if b == 1.0 {
        let d = Diagnostic::warning(
            &checks::materials::UNUSUAL_PARAMETER,
            "the hardening ratio is 1: the steel never yields",
        );
        warn(interp, d.at(a.last_span(), "expected less than 1, or the material Elastic"))?;
    }
    let [mut r0, mut c_r1, mut c_r2] = Steel02::TRANSITION;
    if a.left() > 0 {
        r0 = a.usually_positive(interp, "sharpness of the transition R0")?;
        c_r1 = a.float("cR1")?;
        if c_r1 > 1.0 {
            let label = "the sharpness of the transition would come to be negative: expected at most 1";
            return Err(a.refuse(format!("cR1 is {c_r1}"), label));
        }
        c_r2 = a.usually_positive(interp, "cR2")?;
    }
    let isotropic = isotropic(a, Steel02::NO_ISOTROPIC)?;
    for [growth, scale] in [[isotropic[0], isotropic[1]], [isotropic[2], isotropic[3]]] {
        if growth != 0.0 && scale <= 0.0 {
            let label = "expected a2 and a4 greater than 0";
            return Err(a.refuse(format!("isotropic hardening starts at {scale} yield strains"), label));
        }
    }
    let sig_init = a.optional_float("initial stress sigInit")?.unwrap_or(0.0);
    Ok(Steel02 { fy, e0, b, r0, c_r: [c_r1, c_r2], a: isotropic, sig_init }.shared())
}

fn steel_brb(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.positive("elastic modulus E")?;
    let yield_stress = a.positive("initial yield stress sigmaY0")?;
    let mut branch = |side: &str| {
        Ok::<_, Exception>(BrbBranch {
            yield_stress: a.positive(&format!("hardened yield stress sigmaY{side}"))?,
            alpha: a.positive(&format!("exponent alpha{side} of the transition"))?,
            beta: a.not_negative(&format!("kinematic hardening beta{side}"))?,
            delta: a.positive(&format!("plastic strain delta{side} of isotropic hardening"))?,
        })
    };
    let (tension, compression) = (branch("T")?, branch("C")?);
    // Found to round-off here.
    a.optional_float("tolerance")?;
    let compat = interp.host.follows(&[slips::STEEL_BRB_FIRST]);
    Ok(SteelBrb { e, yield_stress, tension, compression, compat }.shared())
}

fn dodd_restrepo(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let stress = [a.positive("yield stress Fy")?, a.positive("strength Fsu")?];
    let strain = [a.not_negative("strain ESH where hardening begins")?, a.positive("strain ESU of the strength")?];
    let e0 = a.positive("modulus Youngs")?;
    let inner = [a.float("strain ESHI on the hardening curve")?, a.float("stress FSHI on the hardening curve")?];
    let omega = a.optional_float("factor of the Bauschinger curves OmegaFac")?.unwrap_or(1.0);
    let unit = if a.left() > 0 { a.positive("unit of the strains Conv")? } else { 1.0 };
    let law = DoddRestrepo::new(stress, strain, e0, inner, omega, unit)
        .map_err(|message| a.refuse(message, "expected a point between the beginning of hardening and the strength"))?;
    Ok(law.compat(interp.host.follows(&[slips::BAUSCHINGER_ROUNDS])).shared())
}

fn hardening(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.usually_positive(interp, "elastic modulus E")?;
    let sigma_y = a.usually_not_negative(interp, "yield stress sigmaY")?;
    let h_iso = a.float("isotropic hardening modulus Hiso")?;
    let h_kin = a.float("kinematic hardening modulus Hkin")?;
    if e + h_iso + h_kin <= 0.0 {
        let message = format!("E + Hiso + Hkin is {}", e + h_iso + h_kin);
        return Err(a.refuse(message, "expected a modulus after yield that softens less than E stiffens"));
    }
    if a.optional_float("viscosity eta")?.is_some_and(|eta| eta != 0.0) {
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
        points.push([a.positive("strain of a point")?, a.float("stress of a point")?]);
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
    let e = a.positive("elastic modulus E")?;
    let fy = a.positive("initial yield stress fy")?;
    let q_inf = a.float("growth QInf of the yield stress")?;
    let b = a.float("rate b of the growth")?;
    let d_inf = a.float("decrease DInf of the yield stress")?;
    let rate = a.float("rate a of the decrease")?;
    let n = a.int("number of backstresses N")?;
    if !(0..=MAX_BACKSTRESSES as i32).contains(&n) {
        return Err(a.refuse(format!("there are {n} backstresses"), format!("expected 0 to {MAX_BACKSTRESSES}")));
    }
    let mut backstresses = vec![];
    for i in 1..=n {
        backstresses.push([
            a.float(&format!("modulus C{i} of a backstress"))?,
            a.not_negative(&format!("rate gamma{i} of a backstress"))?,
        ]);
    }
    if interp.host.follows(&[slips::UVC_RETURN]) {
        return Ok(UvcUniaxial { e, fy, q_inf, b, d_inf, a: rate, backstresses, rules: OpenSees }.shared());
    }
    Ok(UvcUniaxial { e, fy, q_inf, b, d_inf, a: rate, backstresses, rules: Consistent }.shared())
}

/// Yield strength, ksi, and yield slip, in, from which on the units cannot be those of the law.
const LARGEST_BAR: [f64; 2] = [1000.0, 1.0];

fn bond_sp01(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let fy = a.positive("yield strength fy of the bar")?;
    let sy = a.positive("slip sy at the yield strength")?;
    if fy >= LARGEST_BAR[0] || sy >= LARGEST_BAR[1] {
        let message = "Bond_SP01: the first reversal goes to a slip of 0.00405 in, whatever the units";
        warn(
            interp,
            Diagnostic::warning(&checks::materials::FIXED_UNITS, message).at(a.last_span(), "expected ksi and in"),
        )?;
    }
    let fu = a.positive("ultimate strength fu of the bar")?;
    let su = a.float("slip su at the ultimate strength")?;
    if su <= sy {
        return Err(
            a.refuse(format!("the ultimate slip su is {su}"), format!("expected more than the yield slip, {sy}"))
        );
    }
    let b = a.positive("initial hardening ratio b")?;
    let r = a.positive("pinching factor R")?;
    for what in ["damage factor Cd", "bar diameter db", "concrete strength fc", "anchorage length la"] {
        // Without effect in OpenSees.
        a.optional_float(what)?;
    }
    if interp.host.follows(&[slips::BOND_SLIP_TANGENT]) {
        return Ok(BondSp01 { fy, sy, fu, su, b, r, rules: OpenSees }.shared());
    }
    Ok(BondSp01 { fy, sy, fu, su, b, r, rules: Consistent }.shared())
}

fn gng(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.positive("elastic stiffness E")?;
    let yield_stress = a.positive("yield force sigY")?;
    let pitch = a.positive("pitch of the teeth P")?;
    let mut eta = a.optional_float("hardening ratio eta")?.unwrap_or(0.0);
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

fn steel_mpf(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let fy = [a.positive("yield strength in tension fyp")?, a.positive("yield strength in compression fyn")?];
    let e = a.positive("elastic modulus E0")?;
    let mut b = [0.0; 2];
    for (b, side) in b.iter_mut().zip(["tension bp", "compression bn"]) {
        *b = a.float(&format!("hardening ratio in {side}"))?;
        if *b >= 1.0 {
            return Err(a.refuse(format!("the hardening ratio is {b}"), "expected less than 1"));
        }
    }
    let r0 = a.positive("exponent of the first loading R0")?;
    let cr1 = a.float("loss of the exponent cR1")?;
    let cr2 = a.positive("plastic strain of half the loss cR2")?;
    let mut shift = [(0.0, 1.0); 2];
    if a.left() > 0 {
        for (shift, (share, first)) in shift.iter_mut().rev().zip([("a1", "a2"), ("a3", "a4")]) {
            *shift =
                (a.float(&format!("isotropic hardening {share}"))?, a.float(&format!("isotropic hardening {first}"))?);
        }
    }
    Ok(SteelMpf { fy, e, b, r0, cr1, cr2, shift }.shared())
}

fn reinforcing_steel(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let (fy, fu) = (a.positive("yield strength fy")?, a.positive("ultimate strength fu")?);
    if fu <= fy {
        return Err(a.refuse(format!("the ultimate strength fu is {fu}"), format!("expected more than fy, {fy}")));
    }
    let (es, esh) = (a.positive("elastic modulus Es")?, a.positive("tangent of hardening Esh")?);
    let (eps_sh, eps_ult) = (a.positive("strain of hardening esh")?, a.positive("ultimate strain eult")?);
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
                let slenderness = a.not_negative("slenderness lsr")?;
                a.float("amplification beta")?;
                let reduction = a.float("buckling reduction r")?.clamp(0.0, 1.0);
                buckling = Buckling::Gomes { slenderness, reduction, pivot: a.float("buckling constant gamma")? };
            }
            "-DMBuck" => {
                let slenderness = a.not_negative("slenderness lsr")?;
                let alpha = a.optional_float("adjustment alpha")?.unwrap_or(1.0);
                if !(0.75..=1.0).contains(&alpha) {
                    return Err(a.refuse(format!("the adjustment alpha is {alpha}"), "expected 0.75 to 1"));
                }
                buckling = Buckling::Dhakal { slenderness, alpha };
            }
            "-CMFatigue" => {
                let (cf, alpha) = (a.not_negative("ductility constant Cf")?, a.float("fatigue exponent alpha")?);
                let cd = a.not_negative("strength reduction constant Cd")?;
                fatigue = (cf != 0.0 && alpha != 0.0).then_some(BarFatigue { cf, alpha, cd });
            }
            "-IsoHard" => {
                let rate = a.optional_float("hardening constant a1")?.unwrap_or(4.3);
                hardening = [rate, a.optional_float("least share of the plateau")?.unwrap_or(0.01)];
            }
            "-MPCurveParams" => curve = [a.float("constant R1")?, a.float("constant R2")?, a.float("constant R3")?],
            _ => ignore_option(interp, a, &["-GABuck", "-DMBuck", "-CMFatigue", "-IsoHard", "-MPCurveParams"])?,
        }
    }
    Ok(ReinforcingSteel { fy, fu, es, esh, eps_sh, eps_ult, buckling, fatigue, curve, hardening }.shared())
}

fn cast_fuse(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let legs = a.positive("number of fingers n")?;
    let (width, thickness) = (a.positive("width of a finger bo")?, a.positive("thickness of a finger h")?);
    let (fy, e) = (a.positive("yield stress fy")?, a.positive("elastic modulus E")?);
    let length = a.positive("length of a finger L")?;
    let b = a.float("hardening ratio b")?;
    if b >= 1.0 {
        return Err(a.refuse(format!("the hardening ratio b is {b}"), "expected less than 1"));
    }
    let r = [a.positive("radius R0")?, a.not_negative("coefficient cR1")?, a.positive("coefficient cR2")?];
    let mut hardening = [0.0, 1.0, 0.0, 1.0];
    if a.left() > 0 {
        hardening = [
            a.not_negative("isotropic hardening a1")?,
            a.positive("isotropic hardening a2")?,
            a.not_negative("isotropic hardening a3")?,
            a.positive("isotropic hardening a4")?,
        ];
    }
    Ok(Cast { legs, width, thickness, length, fy, e, b, r, a: hardening }.shared())
}
