//! Uniaxial materials.

use super::Shown::{Case, Nowhere, Test};
use super::{Slip, differs, refused, slips};

slips! {
    HARDENING_TRIAL, Command, Test("tests/laws/frame_materials.rs", "hardening_of_opensees_keeps_the_plastic_strain_of_a_trial"),
    "`Hardening`",
    "An elastic trial state keeps the plastic strain of the trial state before it, and commits it.",
    "A trial state has its own plastic strain.",
    "An iterate that overshoots would leave plastic strain.";

    STEEL_BRB_FIRST, Command, Case("steelbrb_cyclic"),
    "`SteelBRB`",
    "The first increment from zero stress takes the parameters of tension, whatever its sign.",
    "It takes the parameters of its sign.",
    "A brace may be compressed first.";

    STEEL_MPF_START, Command, Test("tests/laws/frame_materials.rs", "a_first_strain_of_zero_is_no_curve_of_steel_mpf"),
    "`SteelMPF` whose first committed strain is 0",
    "openseespy 3.7.1 loads it in tension and does not count its first curve: the curve after the first reversal is as sharp as the \
     first one.",
    "The bar stays virgin, as in later versions.",
    "An analysis that begins at rest would change the answer.";

    CABLE_SAG, Command, Test("tests/laws/reference_stresses.rs", "a_cable_sags_by_its_weight"),
    "`Cable`",
    "A whole division leaves the change of the sag out of the stress, and not out of the tangent. A term of the tangent has another sign.",
    "The sag counts, and the tangent is the derivative of the stress.",
    "The cable would be as stiff as a bar.";

    BILIN_DETERIORATION, Command, Case("bilin_hinges"),
    "`Bilin`, `Bilin02`",
    "A step that crosses zero force and ends beyond the cap of the other side loses all strength. The force jumps to the residual \
     strength. The unloading stiffness stops to deteriorate by other rules on the positive side than on the negative one. Where the \
     backbone deteriorates, the tangent is a slope of the new backbone.",
    "Strength is lost where the branch beyond the cap comes to zero, or at thetaU. Both sides have one rule. The tangent is consistent.",
    "The size of the steps would change the answer. Newton's method converges.";

    PINCHING_TRIALS, Command, Case("frame_hysteresis"),
    "`Pinching4`",
    "The damage that a trial state applies at a reversal stays for the rest of the step and is committed. A segment without slope takes \
     the line of another one. The sides differ in the start of reloading without uForce, and in the path of a start softer than its secant.",
    "A trial state has its own damage. A level segment is level. Both sides have the rules of the positive one.",
    "An iterate that overshoots would change the damage.";

    MOD_IMK_DETERIORATION, Command, Nowhere,
    "`ModIMKPeakOriented`, `ModIMKPinching`",
    "With LambdaC of 0 the strength beyond the cap is lost at the first deterioration. A pinched hinge that has not yielded on the \
     positive side keeps its unloading stiffness in reversals to the negative side. The tangent counts as one of damping too, without a \
     force.",
    "With LambdaC of 0 the strength beyond the cap does not deteriorate. Both sides have one rule. There is no damping.",
    "The manual says that 0 stands for no deterioration. Newton's method converges.";

    IMK_TANGENT, Command, Nowhere,
    "`IMKBilin`, `IMKPeakOriented`, `IMKPinching`",
    "The tangent is the secant of the step.",
    "The tangent is that of the branch.",
    "Newton's method converges.";

    BOND_SLIP_TANGENT, Command, Nowhere,
    "`Bond_SP01`",
    "The tangent leaves out the height of a branch and the change of its exponent.",
    "The tangent is consistent.",
    "Newton's method converges.";

    UVC_RETURN, Command, Nowhere,
    "`UVCuniaxial`",
    "A step across zero stress ends there, if the backstress is greater than the yield stress. The yield function has an absolute \
     tolerance of 1e-9.",
    "The return mapping goes on to round-off.",
    "The stress would be inside the yield surface.";

    HYPERBOLIC_GAP_TRIALS, Command, Nowhere,
    "`HyperbolicGapMaterial`",
    "The smallest displacement of a trial state stays for the rest of the step and is committed.",
    "A trial state has its own smallest displacement.",
    "An iterate that overshoots would change the answer.";

    HYSTERETIC_POLY_BRANCH, Command, Nowhere,
    "`HystereticPoly`",
    "A branch goes on from the middle of its whole length, with the round-off of that length. The initial stiffness is ka.",
    "A branch goes on from its beginning. The initial stiffness is the tangent of the virgin material.",
    "With the default tolerance and a below 3 the force shows the round-off.";

    SOIL_SPRING_ROUNDS, Command, Case("soil_springs"),
    "`PySimple1`, `TzSimple1`, `QzSimple1`",
    "The force is shared out among the springs in at most 19 rounds from the trial state before. A misfit that is left after them stays. \
     The tangent has a floor and leaves out the share of the dashpot.",
    "The springs have one force, to round-off. The tangent is consistent.",
    "The answer would depend on the step and on the iterations.";

    CHANG_MANDER_STRAIN, Command, Nowhere,
    "`Concrete07`",
    "Cracked concrete that leaves the compressive envelope beyond its plastic strain commits a strain of zero, and the tangent of the \
     step before.",
    "The strain is that of the step, and the tangent is zero.",
    "The next step would begin at another strain.";

    BAUSCHINGER_ROUNDS, Command, Case("further_uniaxials"),
    "`Dodd_Restrepo`",
    "The strain of a Bauschinger curve is found to a residual of 0.001, or by ten rounds. The tangent is not that of the curve. Constants \
     have single precision.",
    "It is found to round-off. The tangent is consistent.",
    "Newton's method converges.";

    CROSS_TIES, Command, Nowhere,
    "`ConfinedConcrete01` with `-internal`",
    "The inner ties of section S2 have their diameter in the place of the area of their bar.",
    "The area of the bar.",
    "The area has the unit of an area.";

    LIMIT_STATE, Command, Case("further_uniaxials"),
    "`LimitState`",
    "A step that turns and ends beyond the largest strain keeps the direction of loading. In the energy that damage is divided by, two \
     parts are multiplied.",
    "The direction is that of the step. The energy is the area under the envelopes.",
    "The size of the steps would change the answer. A product of energies is none.";

    STEEL_DRC_STIFFNESS, Command, Case("further_uniaxials"),
    "`SteelDRC`",
    "The tangent is at least 0.005 Es and at most Es. It lacks the dashpot.",
    "The tangent is consistent.",
    "Newton's method converges.";

    MASONRY_SLOPES, Command, Case("further_uniaxials"),
    "`Masonry`",
    "The initial stiffness is the modulus. Where the envelope does not rise, the slope at the end of reloading is divided by a \
     difference of slopes.",
    "The initial stiffness is that of the strut. The slope is half of the secant.",
    "The slopes have the units of slopes.";

    SAWS_ENVELOPE, Command, Nowhere,
    "`SAWS`",
    "The place where the pinched line leaves the envelope is found to a force of 1e-6. The tangent on the envelope has parts of two \
     displacements. Turns within the loop have other rules on the negative side.",
    "The place is found to round-off. The tangent is consistent. Both sides have one rule.",
    "Newton's method converges.";

    MULTI_LINEAR_REST, Command, Nowhere,
    "`MultiLinear`",
    "A yielded state that is committed again at the same strain yields in compression.",
    "It rests.",
    "Nothing has moved.";

    SERIES_ROUND, Command, Case("parallel_series_minmax"),
    "`Series`",
    "The inner iteration has one round. The residual goes on to the next step.",
    "The iteration goes on to round-off.",
    "The parts would not carry one force.";

    SELF_CENTERING_JUMP, Command, Case("selfcentering"),
    "`SelfCentering`",
    "A step that jumps off the flag leaves stale limits. So does a trial state on the flag, such as that of the inner time of HHT. Slip \
     keeps the old tangent.",
    "The material follows the path of small steps.",
    "The size of the steps would change the answer.";

    AXIAL_SP_JUMP, Command, Nowhere,
    "`AxialSp`, `AxialSpHD`",
    "A step that jumps from cavitation past (u_cr, f_cr) stays on a line that it has left. A spring that has just begun to harden closes \
     beyond that point. A yielded spring without stiffness in tension never comes off compression.",
    "The material follows the path of small steps.",
    "The size of the steps would change the answer.";

    KIKUCHI_AIKEN_TANGENT, Command, Case("kikuchi_hdr_x06"),
    "`KikuchiAikenHDR`, `KikuchiAikenLRB`: tangent and loops",
    "The tangent on the skeleton is none. The parameter a is found to 1e-6. A loop that closes to the last bit stays open. In the elastic \
     range the way back loses some 1e-6 of the force.",
    "The tangent is consistent. The parameter a is found to round-off. A closed loop is forgotten. The elastic range is elastic.",
    "Newton's method converges. Cycles of one amplitude do not pile up.";

    KIKUCHI_AIKEN_STEPS, Command, Case("kikuchi_lrb"),
    "`KikuchiAikenHDR`, `KikuchiAikenLRB`: steps of the force",
    "The force steps by 2 u F_m exp(-2a) where a loop comes back to the skeleton: 1e-6 of it for the compounds as they are, 1e-2 with \
     little damping. It steps by up to 3e-4 where one formula of the skeleton follows another.",
    "A factor takes the loop to the skeleton, and the parameter a keeps its equivalent damping. The formulas change over where they meet.",
    "There is no equilibrium at a step of the force. `KikuchiBearing` found none.";

    KIKUCHI_AIKEN_FACTORS, Command, Case("kikuchi_lrb"),
    "`KikuchiAikenHDR`, `KikuchiAikenLRB` with `-coMSS`",
    "Recorders show the displacement times rs/rf. The initial tangent lacks rs.",
    "Recorders show the displacement. The initial tangent is the tangent at rest.",
    "";

    IMPACT_GAP, Command, Nowhere,
    "`ImpactMaterial`",
    "The step that closes the gap counts its way through the gap. The initial tangent is K1 though the gap is open.",
    "Contact begins at the gap.",
    "The size of the steps would change the answer.";

    IMPACT_TANGENT, Command, Nowhere,
    "`HertzDamp`, `JankowskiImpact`",
    "The tangent has the wrong sign. There is no tangent of the damping.",
    "Both tangents are consistent.",
    "Newton's method converges.";

    MIN_MAX_STRAIN, Command, Case("parallel_series_minmax"),
    "`MinMax`",
    "Recorders show a frozen strain after the failure.",
    "Recorders show the strain.",
    "The strain goes on with the nodes.";

    DAMPER_TANGENT, Command, Case("viscous_transient"),
    "`ViscousDamper`, `Maxwell`",
    "There is no tangent of the damping. A rate of zero keeps the last rate. The tangent of `Maxwell` is K.",
    "The tangents are consistent. A rate of zero is a rate.",
    "Newton's method converges.";
}

/// Other differences.
pub(super) const OTHERS: &[Slip] = &[
    differs(
        "`Steel02`: `updateParameter` of `sig0`",
        "The strain is shifted by the new initial stress. A reversal in the next step starts from the stress before the change.",
        "Stress and strain are shifted together.",
    ),
    differs(
        "`Concrete01`: `updateParameter`",
        "The slope of unloading becomes the initial one.",
        "The slope of unloading is that of the largest strain so far.",
    ),
    differs(
        "`Hysteretic`: `updateParameter` of a point of the envelope",
        "Damage by energy is measured by the energy of the envelope that the command made.",
        "It is measured by the energy of the new envelope.",
    ),
    differs(
        "`J2BeamFiber` in the plane with `Hiso`",
        "In an elastic step the accumulated plastic strain is that of the last trial state that yielded.",
        "It is that of the committed state.",
    ),
    differs(
        "`Simplified3DJ2`: initial tangent and reported strain",
        "The initial tangent is the present one, by which `SSPbrick` changes its stabilisation. Reported shear strains are halves.",
        "The initial tangent is elastic. Shear strains are those of the element.",
    ),
    differs(
        "`Fatigue`, the step of the failure",
        "The reported stress is that after the failure, although equilibrium was found before it.",
        "The reported stress is that of the equilibrium.",
    ),
    differs(
        "`BWBN`: tangent",
        "A part of the derivative lacks the increment of the strain. Stresses are the same.",
        "It is the derivative of the stress.",
    ),
    differs(
        "`ReinforcingSteel` with `-GABuck` or `-DMBuck`: tangent",
        "It is that of the bar that does not buckle, with a difference of the reduction at one stress. Stresses are the same.",
        "It is the derivative of the stress.",
    ),
    differs(
        "`BoucWenOriginal`: tangent",
        "It is that at the end of the step, as if the step were short. Stresses are the same.",
        "It is the derivative of the stress, by the implicit rule of the step.",
    ),
    differs(
        "`ECC01`: tangent",
        "In compression before the peak it is the secant of the peak. Stresses are the same.",
        "It is the derivative of the stress.",
    ),
    differs(
        "`ConfinedConcrete01` between the last point of its envelope and the ultimate strain",
        "The stress and the tangent of the step before stay.",
        "The stress is that of the last point.",
    ),
    differs(
        "`Dodd_Restrepo` after fracture",
        "The stress of the last trial stays, and later curves have no strength.",
        "The stress is zero.",
    ),
    differs(
        "`CoulombDamper` with `-numFlipped`, `-reduceFc`, `-dampOutTangent`",
        "After more changes of sign of the rate in the iterations of one step the friction is less.",
        "The friction depends on the rate alone. The options have no effect.",
    ),
    differs(
        "`SteelDRC`: ends of curves at the same distance in both directions",
        "Round-off decides whether the end of a curve moves to the shifted skeleton.",
        "It stays.",
    ),
    differs("`SMA` at a strain of exactly 0", "The stress of the last trial stays.", "The stress is 0."),
    differs("`BoucWen` at rest", "The reported tangent is that of unloading.", "The reported tangent is the last one."),
    differs(
        "`AxialSp`, `AxialSpHD`, `KikuchiAikenHDR`, `KikuchiAikenLRB`, `HertzDamp`: trial states that are not committed",
        "They leave traces: the branch, the largest strain with its parameters, the speed of impact. An iteration that overshoots changes \
         what comes after it.",
        "A law depends on the committed state alone. Results agree to the last digit where no iteration overshoots.",
    ),
    differs(
        "`KikuchiAikenHDR`, `KikuchiAikenLRB`: reversals inside each other",
        "Any number is kept.",
        "48 are kept. Of more loops, the one that hardly differs from the loop around it counts as closed.",
    ),
    differs(
        "`ModIMKPeakOriented`, `ModIMKPinching` with an exponent c other than 1",
        "An excursion that gives back more energy than it took has no power of c: the hinge has no force.",
        "Such an excursion does not deteriorate the hinge.",
    ),
    differs(
        "`Bilin`, `Bilin02` with an exponent c other than 1",
        "An excursion that gives back more energy than it took has no power of c: the hinge is elastic from there on or has no force. The \
         same happens where a side without hardening has lost all strength.",
        "Such an excursion does not deteriorate the hinge.",
    ),
    differs(
        "`IMKBilin`, `IMKPeakOriented`, `IMKPinching` with an exponent c other than 1",
        "An excursion that gives back more energy than it took, or more energy than the capacity, has no power of c: the hinge has no force \
         or stays elastic.",
        "Such an excursion does not deteriorate the hinge.",
    ),
    differs(
        "`Bond_SP01` with a first step of one trial",
        "The slip of friction on the other side is lost. After a yield the first reversal has no stress.",
        "It is stored.",
    ),
    differs(
        "`ConcreteCM`: a second turn within an inner loop of unloading from tension; transitions to the envelope in compression",
        "The transition takes the end of another one, or a number that nobody has set.",
        "It takes its own end.",
    ),
    differs(
        "`ConcretewBeta` beyond the residual strain; `ConcreteD` in tension after compression; `GNG` below zero strain: tangent",
        "It is the secant of the step, lacks the damage of compression, or is zero.",
        "It is consistent.",
    ),
    differs(
        "`UVCuniaxial` at rest after a plastic step",
        "The tangent is the plastic or the elastic one, by round-off.",
        "As in OpenSees, with other round-off.",
    ),
    differs(
        "`Pinching4`: exponents of the damage far below 1",
        "The energy of the elastic range is round-off; its power is not.",
        "As in OpenSees, with other round-off.",
    ),
    differs(
        "`HystereticSmooth`, `HystereticAsym`, `HystereticPoly`: a force that round-off puts beyond the limit curve",
        "There is no number.",
        "The branch goes on.",
    ),
    differs(
        "`HystereticSmooth`, `HystereticAsym`: initial stiffness",
        "openseespy 3.7.1 takes off 2 beta and 2 (b1 + b2).",
        "It is that of the virgin material, as in later versions.",
    ),
    differs(
        "`HystereticPoly` with a below 1 and a small tolerance",
        "The force is round-off.",
        "The force is that of the branch.",
    ),
    differs(
        "`PySimple1`, `TzSimple1`, `QzSimple1` where 19 rounds are not enough",
        "The force depends on the number of calls in the step.",
        "The calls of a `zeroLength` element are not counted: 6e-5 of the largest force where an imposed displacement is asked twice.",
    ),
    differs(
        "`PySimple1`, `TzSimple1`, `QzSimple1` with a dashpot: recorders",
        "A recorder asks once more after the commit. The share of the dashpot is then that of the tangents.",
        "The recorded force is that of equilibrium. Displacements are the same.",
    ),
    refused("`QzSimple1`: suction", "It is at most 0.1, without a word.", "It is at most 0.1, with a warning."),
    differs(
        "`SAWS`: a step from one side to beyond the farthest point on the other",
        "No path is found, and the last force stays.",
        "The force is that of the envelope.",
    ),
    differs(
        "`AxialSp`, `AxialSpHD` with `bty` equal to `bte`",
        "The force is NaN after a yield in compression.",
        "The spring does not cavitate.",
    ),
    differs(
        "`KikuchiAikenLRB` with loops that no a is thin enough for",
        "openseespy 3.7.1 hangs.",
        "The parameter a has its limit.",
    ),
];
