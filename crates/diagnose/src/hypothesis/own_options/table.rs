//! The options that commands have for an effect: one row for each form.
//!
//! A row names the command by its kind, the effect, what the command must look like, and the edit of its words. Added
//! parameters are written `$::hy_name`, so that they are found inside procedures too. `{old}` is the word before.

use super::{OwnOption, OwnParameter, Unit};

const NONE: OwnOption = OwnOption {
    kinds: &[],
    cause: "",
    form: "",
    lengths: &[],
    needs: &[],
    without: &[],
    replaced: &[],
    after: None,
    appended: "",
    parameters: &[],
    source: "",
};

const HDR_RHEOLOGY: &[&str] = &["HDRRheology", "HDRRheologyBearing"];
/// Words of `Hysteretic` with two points and with three, each with and without the last option.
const HYSTERETIC_OF_TWO: &[usize] = &[15, 16];
const HYSTERETIC_OF_THREE: &[usize] = &[19, 20];

/// Rubber has 1.9 to 2.1 MPa per degree, rubber between steel plates up to 3.5.
const HEAT_CAPACITY: OwnParameter = OwnParameter::log("heatCapacity", 0.5, 20.0, 3.0, Unit::One);
const PINCH: [OwnParameter; 2] = [
    OwnParameter::linear("pinchX", 0.1, 1.0, 0.7, Unit::One),
    OwnParameter::linear("pinchY", 0.1, 1.0, 0.5, Unit::One),
];
/// Losses for each unit of ductility less one, and of energy over that at yield.
const DAMAGE: [OwnParameter; 2] = [
    OwnParameter::linear("damageDuctility", 0.0, 0.2, 0.01, Unit::One),
    OwnParameter::linear("damageEnergy", 0.0, 0.2, 0.01, Unit::One),
];

/// Corners are rounder with a smaller exponent, and those of a bilinear law with a large one.
const EXPONENT: OwnParameter = OwnParameter::log("exponent", 0.5, 20.0, 2.0, Unit::One);

/// Part of the fall of the stiffness that follows the sense of the motion: with one half a device unloads elastically.
const UNLOADING: OwnParameter = OwnParameter::linear("unloading", 0.2, 1.0, 0.5, Unit::One);

/// Words of `BoucWen`, with and without tolerance and number of iterations.
const BOUC_WEN: &[usize] = &[12, 13, 14];
/// Losses over the work of the run with most of it. The hysteretic energy is less than that work, and Ao stays positive.
const DELTA_NU: OwnParameter = OwnParameter::linear("deltaNu", 0.0, 5.0, 0.3, Unit::PerWork);
const DELTA_ETA: OwnParameter = OwnParameter::linear("deltaEta", 0.0, 5.0, 0.3, Unit::PerWork);

/// All rows. The unit of ranges is that of the field's sources; `Unit` scales them to the devices of a study.
pub(super) const OWN_OPTIONS: &[OwnOption] = &[
    OwnOption {
        kinds: HDR_RHEOLOGY,
        cause: "self_heating",
        form: "heat capacity of the law, no cooling",
        needs: &["-compound"],
        without: &["-heatCapacity", "-conduction"],
        appended: "-heatCapacity $::hy_heatCapacity -beyond hold",
        parameters: &[HEAT_CAPACITY],
        source: "D. A. Nguyen, dissertation, Eqs 5.2 and 5.3",
        ..NONE
    },
    OwnOption {
        kinds: HDR_RHEOLOGY,
        cause: "self_heating",
        form: "heat capacity of the law, with cooling",
        needs: &["-compound"],
        without: &["-heatCapacity", "-conduction"],
        appended: "-heatCapacity $::hy_heatCapacity -coolingTime $::hy_coolingTime -beyond hold",
        parameters: &[HEAT_CAPACITY, OwnParameter::log("coolingTime", 1.0, 1e5, 300.0, Unit::One)],
        source: "D. A. Nguyen, dissertation, Eqs 5.2 and 5.3",
        ..NONE
    },
    OwnOption {
        kinds: HDR_RHEOLOGY,
        cause: "mullins_softening",
        form: "softening of the law",
        without: &["-mullins"],
        appended: "-mullins $::hy_excess $::hy_strain",
        parameters: &[
            OwnParameter::linear("excess", 0.0, 1.2, 0.2, Unit::One),
            OwnParameter::log("strain", 0.02, 3.0, 0.5, Unit::One),
        ],
        source: "Ogden and Roxburgh (1999)",
        ..NONE
    },
    OwnOption {
        kinds: HDR_RHEOLOGY,
        cause: "ambient_temperature",
        form: "temperature of the compound",
        needs: &["-compound"],
        without: &["-ambient"],
        after: Some(("-temperature", "$::hy_temperature")),
        parameters: &[OwnParameter::linear("temperature", -30.0, 23.0, 5.0, Unit::One)],
        source: "D. A. Nguyen, dissertation, Tables 3.1 and 3.2",
        ..NONE
    },
    OwnOption {
        kinds: &["LeadRubberX"],
        cause: "self_heating",
        form: "heating of the lead core",
        lengths: &[36],
        replaced: &[(28, None, "[expr {$::hy_leadCapacity*({old})}]"), (35, Some(0.0), "1")],
        parameters: &[OwnParameter::log("leadCapacity", 0.3, 3.0, 1.0, Unit::One)],
        source: "Kalpakidis and Constantinou (2009)",
        ..NONE
    },
    OwnOption {
        kinds: &["FPBearingPTV"],
        cause: "self_heating",
        form: "friction that falls with the temperature",
        replaced: &[(8, Some(0.0), "1"), (10, None, "[expr {$::hy_conductivity*({old})}]")],
        parameters: &[OwnParameter::log("conductivity", 0.3, 3.0, 1.0, Unit::One)],
        source: "Kumar, Whittaker and Constantinou (2015)",
        ..NONE
    },
    OwnOption {
        kinds: &["FPBearingPTV"],
        cause: "rate_dependence",
        form: "friction that grows with speed",
        replaced: &[(11, Some(0.0), "1"), (12, None, "[expr {$::hy_speedFactor*({old})}]")],
        parameters: &[OwnParameter::log("speedFactor", 0.1, 10.0, 1.0, Unit::One)],
        source: "Kumar, Whittaker and Constantinou (2015)",
        ..NONE
    },
    OwnOption {
        kinds: &["FPBearingPTV"],
        cause: "varying_axial_load",
        form: "friction that falls with the pressure",
        replaced: &[(6, Some(0.0), "1"), (7, None, "[expr {$::hy_referencePressure*({old})}]")],
        parameters: &[OwnParameter::log("referencePressure", 0.2, 5.0, 1.0, Unit::One)],
        source: "Kumar, Whittaker and Constantinou (2015)",
        ..NONE
    },
    OwnOption {
        kinds: &["Hysteretic"],
        cause: "pinching",
        form: "pinching of the law",
        lengths: HYSTERETIC_OF_TWO,
        replaced: &[(11, Some(1.0), "$::hy_pinchX"), (12, Some(1.0), "$::hy_pinchY")],
        parameters: &PINCH,
        source: "OpenSees' manual, Hysteretic",
        ..NONE
    },
    OwnOption {
        kinds: &["Hysteretic"],
        cause: "pinching",
        form: "pinching of the law",
        lengths: HYSTERETIC_OF_THREE,
        replaced: &[(15, Some(1.0), "$::hy_pinchX"), (16, Some(1.0), "$::hy_pinchY")],
        parameters: &PINCH,
        source: "OpenSees' manual, Hysteretic",
        ..NONE
    },
    OwnOption {
        kinds: &["Hysteretic"],
        cause: "cyclic_degradation",
        form: "damage of the law",
        lengths: HYSTERETIC_OF_TWO,
        replaced: &[(13, Some(0.0), "$::hy_damageDuctility"), (14, Some(0.0), "$::hy_damageEnergy")],
        parameters: &DAMAGE,
        source: "OpenSees' manual, Hysteretic",
        ..NONE
    },
    OwnOption {
        kinds: &["Hysteretic"],
        cause: "cyclic_degradation",
        form: "damage of the law",
        lengths: HYSTERETIC_OF_THREE,
        replaced: &[(17, Some(0.0), "$::hy_damageDuctility"), (18, Some(0.0), "$::hy_damageEnergy")],
        parameters: &DAMAGE,
        source: "OpenSees' manual, Hysteretic",
        ..NONE
    },
    OwnOption {
        kinds: &["Bilin"],
        cause: "cyclic_degradation",
        form: "deterioration of the law",
        replaced: &[(8, Some(0.0), "$::hy_lambda"), (9, Some(0.0), "$::hy_lambda")],
        parameters: &[OwnParameter::log("lambda", 1.0, 1e3, 20.0, Unit::Deformation)],
        source: "Lignos and Krawinkler (2011)",
        ..NONE
    },
    OwnOption {
        kinds: &["BoucWen"],
        cause: "cyclic_degradation",
        form: "loss of strength and of stiffness of the law",
        lengths: BOUC_WEN,
        replaced: &[(10, Some(0.0), "$::hy_deltaNu"), (11, Some(0.0), "$::hy_deltaEta")],
        parameters: &[DELTA_NU, DELTA_ETA],
        source: "Baber and Wen (1981)",
        ..NONE
    },
    OwnOption {
        kinds: &["BoucWen"],
        cause: "cyclic_degradation",
        form: "loss of the hysteretic force of the law",
        lengths: BOUC_WEN,
        replaced: &[(9, Some(0.0), "$::hy_deltaA")],
        parameters: &[OwnParameter::linear("deltaA", 0.0, 0.9, 0.2, Unit::PerWork)],
        source: "Baber and Wen (1981)",
        ..NONE
    },
    OwnOption {
        kinds: &["elastomericBearingPlasticity", "ElastomericBearingPlasticity"],
        cause: "rounded_yielding",
        form: "smooth transition to yielding",
        replaced: &[(1, None, "elastomericBearingBoucWen"), (9, None, "{old} $::hy_exponent 0.5 0.5")],
        parameters: &[EXPONENT],
        source: "Park, Wen and Ang (1986)",
        ..NONE
    },
    OwnOption {
        kinds: &["elastomericBearingPlasticity", "ElastomericBearingPlasticity"],
        cause: "rounded_yielding",
        form: "smooth transition to yielding, and unloading of another stiffness",
        replaced: &[
            (1, None, "elastomericBearingBoucWen"),
            (9, None, "{old} $::hy_exponent $::hy_unloading [expr {1.0-$::hy_unloading}]"),
        ],
        parameters: &[EXPONENT, UNLOADING],
        source: "Park, Wen and Ang (1986)",
        ..NONE
    },
    OwnOption {
        kinds: &["Steel01"],
        cause: "rounded_yielding",
        form: "smooth transition to yielding",
        lengths: &[6],
        replaced: &[
            (1, None, "BoucWen"),
            (3, None, "{5}"),
            (4, None, "{old} $::hy_exponent"),
            (
                5,
                None,
                "[expr {0.5/pow(double({3})/({4}),$::hy_exponent)}] [expr {0.5/pow(double({3})/({4}),$::hy_exponent)}] \
                 1.0 0.0 0.0 0.0",
            ),
        ],
        parameters: &[EXPONENT],
        source: "Wen (1976)",
        ..NONE
    },
];
