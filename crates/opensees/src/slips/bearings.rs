//! Bearings.

use super::Shown::{Case, Nowhere, Test};
use super::{Slip, differs, refused, slips};

slips! {
    P_DELTA_TANGENT, Command, Case("isolators_hht_modes"),
    "`elastomericBearingPlasticity`, `elastomericBearingBoucWen`, `elastomericBearingUFRP`, `HDR`, `ElastomericX`, `LeadRubberX`: tangent \
     of the P-Delta moments",
    "The tangent is that under the axial force at hand. Rayleigh damping and modes show it.",
    "The tangent has the change of the axial force too.",
    "Newton's method converges.";

    PLASTICITY_TRIAL, Command, Nowhere,
    "`elastomericBearingPlasticity`: plastic displacement",
    "A trial state that slides leaves its plastic displacement behind where the step ends sticking.",
    "The plastic displacement is that of the committed state.",
    "The answer would depend on the path of the iterations.";

    BOUC_WEN_TANGENT, Command, Case("building_boucwen"),
    "`elastomericBearingBoucWen`: tangent",
    "The tangent is that of the rate. In space it is taken along the last increment, with no entry of the hysteretic part beyond 1. \
     `eigen`, `-doRayleigh` and `algorithm Linear` show it.",
    "The tangent is that of the step.",
    "Newton's method converges. In space under loads OpenSees often fails.";

    SLIDER_TRIAL, Command, Case("flatslider3d_uplift"),
    "`flatSliderBearing`, `singleFPBearing`, `RJWatsonEqsBearing`: plastic displacement",
    "A trial state that slides leaves its plastic displacement behind where the step ends sticking.",
    "The plastic displacement is that of the committed state.",
    "The answer would depend on the path of the iterations.";

    SLIDER_FORCE, Command, Test("tests/laws/sliders.rs", "substitution_and_newton_agree"),
    "`flatSliderBearing`, `singleFPBearing`, `RJWatsonEqsBearing`: shear force",
    "The force is found by substitution, to the tolerance of `-iter`.",
    "The force is found by Newton's method, to round-off.",
    "";

    SLIDER_TANGENT, Command, Case("rjwatson3d_orbit"),
    "`flatSliderBearing`, `singleFPBearing`, `RJWatsonEqsBearing`: tangent",
    "The tangent leaves out the normal force, the speed, the rise of the slider and the arms of the moments.",
    "The tangent and the damping are consistent.",
    "Newton's method converges.";

    SLIDER_UPLIFT, Command, Case("flatslider3d_uplift"),
    "`flatSliderBearing`, `singleFPBearing`, `RJWatsonEqsBearing` that lift off",
    "The friction model and the moment materials keep their last state. In the plane the axial material goes back to its last strain, and \
     the slider stays where the axial force is exactly 0. The initial stiffness stays whole, except in the plane under tension.",
    "Everything follows the motion. A share `-kFactUplift` (1e-6) of the initial stiffness stays.",
    "Landing must not depend on iterations.";

    PTV_HEAT, Command, Case("pendulum_heated"),
    "`FPBearingPTV`: friction and heat",
    "The coefficient of the first trial state holds for the step, by the speed that is predicted there. The heat has the coefficient of the \
     step before. In static analyses the speed comes from displacements. The first step of a domain time that went back has the reference \
     coefficient and forgets the heat. π is 22/7. The heat comes at the ends of the steps.",
    "Pressure and speed are those of the step, the temperature is that of its beginning. The heat is the work of the friction in the step.",
    "The friction would depend on the predictor.";

    PTV_FORCE, Command, Case("pendulum_heated"),
    "`FPBearingPTV`: shear and tangent",
    "The shear is that under the axial force, by the circle at the displacement in its own direction. The tangent is none.",
    "The shear is that under the force normal to the surface, as in `singleFPBearing`. The tangent is consistent.",
    "The force follows the surface. Newton's method converges.";

    PTV_TENSION, Command, Case("pendulum_heated"),
    "`FPBearingPTV`: tension, rotation about z",
    "Under tension a ten-thousandth of it pushes. At exactly no force everything stays as it was. Where no node moves, the material of the \
     rotation about z goes back to zero.",
    "Under tension the bearing carries nothing. The rotation is that of the nodes.",
    "";

    RUBBER_LAG, Command, Case("elastomericx_cyclic"),
    "`HDR`, `ElastomericX`, `LeadRubberX`: axial stiffness, cavitation displacement, critical load, shear stiffness under axial force",
    "They are those of the displacements and forces of the last step.",
    "They are those of the step.",
    "The size of the steps would change the answer.";

    RUBBER_TENSION, Command, Case("hdr_cavitation_tension"),
    "`HDR`, `ElastomericX`, `LeadRubberX`: tension",
    "A bearing that is pulled while it is sheared gains cavitation strength. The force jumps where the bearing was damaged at another shear \
     displacement.",
    "There is no damage before cavitation. The force is continuous.",
    "Pulling does not heal.";

    RUBBER_COMPRESSION, Command, Case("leadrubberx_heating_transient"),
    "`HDR`, `ElastomericX`, `LeadRubberX`: compression",
    "After the least critical load so far, the force jumps to that load where the present one is reached.",
    "The force goes on from the present critical load.",
    "There is no equilibrium at a jump of the force.";

    HDR_TRIAL, Command, Case("hdr_cyclic_scragging"),
    "`HDR`",
    "Damages of a trial state stay. The tangent has 1 - c4 for 1 - c3 and leaves out the turn of the direction. The initial tangent \
     leaves out b1 b3.",
    "The damages follow from the committed state. The tangents are consistent.",
    "The path of the iterations would change the answer.";

    RUBBER_REST, Command, Case("elastomericx_cyclic"),
    "`ElastomericX`, `LeadRubberX`: rest and tangent",
    "Where the displacement is the same to the last bit, force and tangent are those of the last step. The tangent ∂z/∂u is taken along the \
     increment.",
    "The force is that of the state. The tangent is consistent.",
    "Newton's method converges.";

    LEAD_HEATING, Command, Case("leadrubberx_heating_transient"),
    "`LeadRubberX`: lead core",
    "The heating takes z of the last step. It never cools in its first stage and takes the losses of the step after.",
    "The heating is found by the backward Euler method.",
    "In long steps the core would cool below its start.";

    TRIPLE_FRICTION, Command, Case("triple_pendulum_orbit"),
    "`TripleFrictionPendulum`: friction",
    "The friction has the speeds of the last trial state, from the whole displacement of a segment.",
    "The friction has the speed of sliding at the end of the step.",
    "The answer would depend on the iterations. Newton's method fails with friction that depends on the speed.";

    TRIPLE_FORCE, Command, Case("triple_pendulum_orbit"),
    "`TripleFrictionPendulum`: shear",
    "The shear is found by increments to the tolerance of the command, which are halved where they fail. A force that does not converge \
     stays.",
    "The shear is found by Newton's method, to round-off.",
    "";

    TRIPLE_TENSION, Command, Case("triple_pendulum_transient"),
    "`TripleFrictionPendulum`: tension",
    "The reported pressure is `minFv`. The vertical material goes back to its last strain.",
    "The vertical force is that of `kvt`.",
    "The bearing would push up while it is lifted.";

    TRIPLE_MOMENTS, Command, Case("triple_pendulum_orbit"),
    "`TripleFrictionPendulum`: moments of the rotational materials",
    "They have the same sign at both nodes.",
    "They have opposite signs.",
    "The element would not be in balance.";

    TRIPLE_TANGENT, Command, Case("triple_pendulum_orbit"),
    "`TripleFrictionPendulum`: tangent; `localDisplacement`, rotations of `basicDisplacement`",
    "The tangent leaves out the vertical force and the moments. The records are zero.",
    "The tangent is consistent. The records are those of the nodes.",
    "";

    TRIPLE_RAYLEIGH, Command, Case("triple_rayleigh_lead_hht"),
    "`TripleFrictionPendulum`, `TripleFrictionPendulumX`: Rayleigh damping",
    "The damping is in the forces, with no option against it, and not in the tangent.",
    "The damping is in both.",
    "Newton's method converges.";

    TRIPLE_X_MATERIALS, Command, Case("triple_pendulum_heated"),
    "`TripleFrictionPendulumX`: materials",
    "The tag of the conduction, `tagT2`, is taken for that of the vertical material. The four materials of the script move on by one, and \
     the last is not used.",
    "The materials are those of the script.",
    "The example of OpenSees stands on a spring of 10 N/m.";

    TRIPLE_X_HEAT, Command, Case("triple_pendulum_heated"),
    "`TripleFrictionPendulumX`: friction and heat",
    "The friction has the displacements, speeds and normal force of the last step. Those of the inner surfaces are a step older, and the \
     coefficients two steps. The first step of a domain time that went back has the reference coefficients and forgets the heat.",
    "Speed and pressure are those of the step, the temperature is that of its beginning. The heat is the work of the friction in the step.",
    "The friction would lag behind the motion. A step that is repeated after a failure would cool the bearing.";

    TRIPLE_X_CONDUCTION, Command, Case("triple_pendulum_heated"),
    "`TripleFrictionPendulumX`: conduction",
    "π is 22/7 or 3.14159. The heat comes at the ends of the steps. Series are cut at a thousandth. A surface at its middle does not warm.",
    "π is π. The heat is spread over the step. Series are whole.",
    "";

    TRIPLE_X_FORCE, Command, Case("triple_pendulum_heated"),
    "`TripleFrictionPendulumX`: shear, tension, moments, tangent, records",
    "As `TripleFrictionPendulum`.",
    "As `TripleFrictionPendulum`.",
    "";

    YAMAMOTO_EULER, Command, Case("yamamoto_biaxial"),
    "`YamamotoBiaxialHDR`",
    "Q takes one step of Euler's method forward. The tangent is always the initial one. The mass of node j goes to the rotations of node i.",
    "Q is found to 1e-4 whatever the step. The difference is a few per cent of the force at 30 steps a cycle. The tangent is consistent. \
     Both ends have their masses.",
    "The size of the steps would change the answer.";

    SHEAR_SPRINGS_LIMIT, Command, Case("mss_figure_eight"),
    "`multipleShearSpring` with `-lim`",
    "The stiffness has a factor of its own.",
    "The stiffness is the derivative of the force.",
    "Newton's method converges.";

    NORMAL_SPRINGS_COMMIT, Command, Case("mns_rocking"),
    "`multipleNormalSpring`: histories",
    "The first n of the n x n springs are committed. The others are virgin in every step.",
    "All springs are committed.",
    "A yielded section would heal.";

    NORMAL_SPRINGS_AXIAL_SP, Command, Case("kikuchi_uplift_varying_axial"),
    "`AxialSp`, `AxialSpHD` in `KikuchiBearing` and `multipleNormalSpring`",
    "A spring goes on from the branch of the last trial state.",
    "A spring goes on from the committed state.",
    "A trial state leaves no trace.";

    KIKUCHI_ITERATION, Command, Case("kikuchi_square_bidirectional"),
    "`KikuchiBearing`: inner nodes",
    "Each call is one Newton step, with the springs of the last call and the geometry of the last step. `-doBalance` corrects them when a \
     step is committed.",
    "They are in balance to round-off at every trial state, with a consistent tangent. `-doBalance` has nothing left to do.",
    "The answer would depend on the number of calls and on the size of the steps: see [kikuchi.md](../../validation/opensees/kikuchi.md).";

    KIKUCHI_SHARED, Command, Case("building_kikuchi"),
    "`KikuchiBearing`: several in a model",
    "Displacements, tilts and tangent are variables of the class: all bearings take those of the bearing that was asked last.",
    "Each bearing has its own.",
    "They move differently.";

    KIKUCHI_OFFSET, Command, Case("kikuchi_square_bidirectional"),
    "`KikuchiBearing`: the P-Delta moments that `-adjustPDOutput` takes off",
    "The displacement along y changes the moments about y, that along z those about z.",
    "The displacement along y changes the moments about z, that along z those about y.",
    "A force along x with an offset along y has its moment about z.";

    KIKUCHI_TILT, Command, Case("kikuchi_uplift_varying_axial"),
    "`KikuchiBearing`: axial force on the tilted links",
    "Each end has the tilt of its own link. The shear forces at the ends differ where the ends turn.",
    "Both ends have the mean tilt. The axial shortening comes from the same potential.",
    "The forces are in balance, and no energy comes from nowhere.";

    KIKUCHI_LIMIT, Command, Case("kikuchi_round_cyclic"),
    "`KikuchiBearing` with `-limDisp`",
    "The forces are scaled by the displacement of the last step. The stiffness has a factor of its own.",
    "The forces are scaled by the displacement at hand. The stiffness is their derivative.",
    "The tangent is consistent, and the force does not jump at rest.";

    KIKUCHI_FIRST_STIFFNESS, Command, Case("kikuchi_round_cyclic"),
    "`KikuchiBearing`: first stiffness",
    "It is that of a bearing without height.",
    "It is that of the bearing.",
    "OpenSees finds it before the height is known.";

    KIKUCHI_INITIAL, Command, Case("kikuchi_rayleigh_linesearch"),
    "`KikuchiBearing`: initial stiffness, in algorithms and Rayleigh damping",
    "It is the current one.",
    "It is that of the virgin bearing.",
    "";

    COMMITTED_DAMPING, Analysis, Case("traces_hht_trbdf2"),
    "`KikuchiBearing`, `multipleShearSpring`, `multipleNormalSpring`, `YamamotoBiaxialHDR`: Rayleigh damping by the committed stiffness",
    "The stiffness is always that at the beginning of the analysis.",
    "The stiffness is that of the last step.",
    "These elements do not tell the base class that a step was committed.";

    BEARING_MASS_REACTIONS, Analysis, Case("isolators_hht_modes"),
    "Bearings with `-mass`: reactions of supports under `UniformExcitation`",
    "The inertia of the mass at the support is left out.",
    "It counts, as that of the masses of nodes does.",
    "";
}

/// Other differences.
pub(super) const OTHERS: &[Slip] = &[
    differs(
        "`ElastomericX`, `LeadRubberX` with cd",
        "cd/Δt is part of the stiffness in static analyses too. Δt is the difference of domain times, which has any size and sign after \
         `loadConst -time 0`: a step seems to converge that has not.",
        "cd is a damping matrix. With the switch cd/Δt is part of the stiffness, with the Δt of the step.",
    ),
    differs(
        "`HDR`, `ElastomericX`, `LeadRubberX`: π",
        "It is 3.14159: the axial stiffness is a part in a million less.",
        "It is 3.14159 too.",
    ),
    differs(
        "`singleFPBearing`: `-inclVertDisp`, `-shearDist`",
        "openseespy 3.7.1 spells the first one `-inclVertdisp`, and takes no notice of the second one in the plane.",
        "Both spellings and the option count, as in later versions.",
    ),
    differs(
        "`-mass` of several `multipleShearSpring`, `multipleNormalSpring`, `KikuchiBearing` or `YamamotoBiaxialHDR`",
        "Elements of a kind share one load vector. Under `UniformExcitation` the inertia of each counts once for every one of them.",
        "It counts once.",
    ),
    differs(
        "`elastomericBearingUFRP`",
        "openseespy 3.7.1 reads one of its eleven numbers and cannot make it.",
        "It follows the Tcl command.",
    ),
    differs(
        "Rayleigh damping by the committed stiffness where an analysis is made anew in motion",
        "The bearings of the family of `KikuchiBearing` keep the stiffness of the time of `rayleigh`.",
        "The switch takes that of the beginning of the new analysis.",
    ),
    refused("`KikuchiBearing` with `-limDisp 0`", "There are no numbers.", "It is refused."),
    differs("`KikuchiBearing`: `-orient` with three numbers", "It must be the last option.", "It may stand anywhere."),
    differs("`multipleNormalSpring`: `-shape square`", "It is not known.", "It is taken."),
    differs(
        "`-orient` with three numbers, in all bearings",
        "openseespy 3.7.1 swallows the option behind it.",
        "The option counts.",
    ),
    differs(
        "`rayleigh` with the committed stiffness on `multipleShearSpring` and `YamamotoBiaxialHDR`",
        "The stiffness stays that of the time when the damping was given.",
        "It is that of the last step.",
    ),
    differs(
        "`rayleigh` with the current or committed stiffness on bearings with `-doRayleigh`",
        "The tangents are no derivatives and make another damping matrix.",
        "The damping matrix is that of consistent tangents. The response `basicStiffness` of the Bouc-Wen bearings is consistent too.",
    ),
    differs(
        "`FPBearingPTV`: domain times that do not rise evenly",
        "Speeds and ages of the heat are none.",
        "They are those of the motion.",
    ),
    differs(
        "`YamamotoBiaxialHDR` with `-mass` under `UniformExcitation`",
        "The reported force has the inertia that OpenSees puts at the rotations of node i.",
        "The reported force has no inertia there.",
    ),
    refused(
        "`TripleFrictionPendulumX` with `tagT` 0",
        "The displacements are divided by regimes of the force, which depends on the number of iterations.",
        "They are those of `tagT` 1, with a warning.",
    ),
    refused("`TripleFrictionPendulumX`: record `SurfaceHistory`", "It is written.", "It is refused."),
    differs(
        "`TripleFrictionPendulumX` where the domain time is 0 when the element is made",
        "openseespy 3.7.1 writes the heat beyond its arrays, and ends in a crash or in any numbers. `setTime 1.0` before the element and \
         `setTime 0.0` after it keep it within.",
        "The heat is kept.",
    ),
    differs(
        "`TripleFrictionPendulumX`: steps of different length, times that do not begin with the first step",
        "The ages of the heat are none.",
        "They are those of the heat.",
    ),
];
