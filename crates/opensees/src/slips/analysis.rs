//! Constraints, integrators, algorithms and damping.

use super::Shown::{Case, Nowhere, Test};
use super::{Slip, differs, refused, shared, slips};

slips! {
    PLAIN_IMPOSED, Command, Test("tests/analysis/constraints.rs", "plain_holds_imposed_motions_only_when_told_to"),
    "`constraints Plain` with an `sp` that is not zero",
    "The value is ignored: the degree of freedom is held at zero.",
    "The value is imposed.",
    "The script says so. A result for another motion is wrong.";

    PLAIN_CONSTRAINTS, Command, Test("tests/cli/mistakes.rs", "plain_handler"),
    "`constraints Plain` with a multi-point constraint other than equality",
    "The constraint is ignored.",
    "The constraint holds.",
    "The model would not be that of the script.";

    CONTROLLED_CONSTRAINED, Analysis, Test("tests/analysis/opensees.rs", "control_of_a_constrained_node"),
    "`integrator DisplacementControl` of a constrained node under `constraints Transformation`",
    "The number of the degree of freedom counts those of the node that are free, and then those of the retained node.",
    "The degree of freedom of the node moves by the increment.",
    "Another displacement would be controlled.";

    REFERENCE_LOAD, Analysis, Test("tests/analysis/opensees.rs", "reference_load_of_a_state_out_of_balance"),
    "`integrator DisplacementControl`, `ArcLength` and `MinUnbalDispNorm` from a state out of equilibrium",
    "The reference load is the whole unbalance at one more of the load factor. Iterations converge more slowly, and end elsewhere within \
     the tolerance of the test.",
    "The reference load is what one more of the load factor adds.",
    "The answer would depend on how the analysis begins.";

    HS_CONSTRAINT, Analysis, Test("tests/analysis/algorithms.rs", "hyper_spherical_steps"),
    "`integrator HSConstraint`",
    "Corrections go half of the way to a constraint in which the sum of the displacements stands for one. Steps are much shorter than asked \
     for.",
    "Steps have the length that is asked for.",
    "OpenSees takes a number from each component of a vector, where it is meant to take it from their scalar product.";

    EMPTY_PATH, Command, Test("tests/analysis/algorithms.rs", "a_path_of_an_empty_file_is_zero"),
    "`timeSeries Path` of a file without numbers",
    "The series is zero. A warning says so.",
    "It is refused.",
    "A motion that is missing would go unnoticed.";

    MECHANISMS, Analysis, Test("tests/analysis/opensees.rs", "an_unloaded_mechanism_stands_still"),
    "A mechanism that carries no load",
    "The analysis goes on; the mechanism stands still, up to round-off. Without mass it has no mode.",
    "The step fails, and the message names the degree of freedom without stiffness.",
    "A mechanism is mostly a mistake, and its round-off may grow.";

    TRANSFORMATION_FIRST, Analysis, Nowhere,
    "`constraints Transformation` with several multi-point constraints on one constrained node",
    "Only the first one holds.",
    "All of them hold.",
    "The model would not be that of the script.";

    HELD_AND_TIED, Analysis, Test("tests/analysis/opensees.rs", "a_tie_of_a_held_node_hands_its_forces_on"),
    "`constraints Transformation` with a multi-point constraint of a degree of freedom that is held too",
    "The degree of freedom stands still. Its forces and its stiffness go to the node that it should follow. The next one of the node that \
     does not follow stands still too.",
    "The constraint of the held degree of freedom is left out. A warning names it.",
    "The support would carry nothing, and the retained node would be held back by springs that do not move.";

    UNKNOWN_INTEGRATOR, Command, Test("tests/analysis/opensees.rs", "an_unknown_integrator_changes_nothing"),
    "`integrator` of an unknown kind",
    "The command does nothing. A warning names the kind.",
    "It is refused.",
    "The analysis would go on with another integrator.";

    CHAINED_TIES, Analysis, Test("tests/analysis/opensees.rs", "chains_of_rigid_links_are_not_multiplied"),
    "`constraints Transformation` with a node that follows one which follows another",
    "It moves as if the last node stood where the one in the middle is. If the one in the middle has the greater tag, it follows a step or \
     an iteration late, and its forces are lost.",
    "The constraints of the chain are multiplied.",
    "Rigid bodies of several links would bend.";

    FAILED_TIES, Analysis, Test("tests/analysis/transformed_nodes.rs", "a_failed_step_is_missing_in_tied_nodes"),
    "`constraints Transformation` after a transient step that has failed",
    "openseespy 3.7.1 takes the motion of the failed step off that of the constrained nodes in the next one: they are behind from there on. \
     Where a node follows one that is constrained or held itself, `--compat opensees` refuses to go on.",
    "The constraint holds.",
    "The constraint would not hold.";

    LATE_TIES, Analysis, Test("tests/analysis/transformed_nodes.rs", "a_node_that_follows_a_held_one"),
    "`constraints Transformation` with a node that follows one which is held in some of the degrees of freedom",
    "Where loads are applied, the constrained node goes to where the held ones take it: of the others no more than the last increment \
     counts. `--compat opensees` refuses this, and nodes that follow late, for integrators other than static ones, `Newmark`, `HHT`, \
     `GeneralizedAlpha`, `HHTGeneralized`, `TRBDF2` and other multistep methods. It refuses `algorithm Linear` in transient analyses where the mass of such a node joins degrees \
     of freedom that no element joins: OpenSees drops these terms in every system but `FullGeneral`.",
    "All degrees of freedom of the retained node count.",
    "The constraint would not hold.";

    EIGEN_LAPACK, Command, Test("tests/analysis/opensees.rs", "modal_damping_of_the_masses_of_elements"),
    "`eigen -fullGenLapack`",
    "The values are the smallest ones whatever `-findLargest` says. They are infinite where the mass has no more modes. Shapes are scaled \
     by row sums of the mass matrix.",
    "As the other solvers.",
    "Shapes of two solvers should agree.";

    ELEMENT_CLOCKS, Analysis, Case("triple_rayleigh_lead_hht"),
    "`HHT`, `HHTGeneralized`, `GeneralizedAlpha`: laws that depend on time (`ViscousDamper`, heating)",
    "At the end of a step as much time has passed for them as at its inner time.",
    "The time of the step has passed.",
    "Their clocks would lose a part of every step.";

    LINE_SEARCH_SIGN, Analysis, Case("kikuchi_rayleigh_linesearch"),
    "`algorithm NewtonLineSearch`",
    "The work of the unbalance changes its sign with the first search. The search goes on along the correction and the part that the \
     integrator added to it. An answer that depends on the iterations shows it.",
    "There is one sign and one direction.",
    "The search would not search.";

    INNER_TIME_LOADS, Analysis, Case("integrators_imposed_motion"),
    "Integrators that solve a step at another time than its end (`HHT` and its relatives, `Collocation`, `AlphaOS`, `KRAlphaExplicit`)",
    "Loads, imposed motions and reported inertia at the end of a step are those of that time.",
    "They are those of the end.",
    "Supports would stand where they are not.";

    INNER_TIME_CLOCK, Analysis, Case("integrators_imposed_motion"),
    "The same integrators: domain time",
    "It goes on from the inner time by the rest of the step, and rounds so. A motion that ends with the analysis may have ended in its \
     last step.",
    "It goes on from the beginning of the step by all of it.",
    "The sum rounds less.";

    GENERALIZED_ALPHA, Command, Case("integrators_sdof"),
    "`integrator GeneralizedAlpha`",
    "After a correction the full acceleration stands where the weighted one belongs.",
    "The weighted acceleration is used.",
    "The scheme would not be that of its paper.";

    CENTRAL_DIFFERENCE_START, Command, Case("trapezoidal_integrators"),
    "`integrator CentralDifference`, `CentralDifferenceAlternative`, `CentralDifferenceNoDamping`",
    "The start ignores initial velocity and acceleration. `CentralDifferenceAlternative` has the damping forces at the velocity in the \
     middle of the last step, which it reports, and reports no accelerations.",
    "Initial velocity and acceleration count. `CentralDifferenceAlternative` is `CentralDifference`.",
    "Free vibration would start wrong. Damping would be of first order in the step only.";

    EXPLICIT_START, Command, Nowhere,
    "`integrator ExplicitDifference`, `ExplicitBathe`",
    "They begin with the acceleration that was set, zero as a rule. `ExplicitDifference` takes the initial velocity for that half a step \
     before the start.",
    "They begin with the acceleration of equilibrium, and half a step back from the initial velocity.",
    "A motion that starts with a force would start late.";

    HHT_TP_ORDER, Command, Case("trapezoidal_integrators"),
    "`integrator HHT_TP` with three numbers",
    "They are alpha, beta, gamma.",
    "They are alpha, gamma, beta.",
    "This is the order of its manual and of `HHT`.";

    EXPLICIT_ELEMENTS, Command, Nowhere,
    "`integrator HHTExplicit`, `HHTGeneralizedExplicit`, `KRAlphaExplicit` without `-updateElemDisp`",
    "Elements stay at the displacement of the equations.",
    "Elements are at the end of the step.",
    "Recorders would show forces of another time.";

    GROUND_MOTION_RATES, Command, Case("multisupport_rates"),
    "`groundMotion Plain` with `-disp` without `-vel`, or `-vel` without `-accel`",
    "Velocity and acceleration that are not given are zero.",
    "They are derivatives, by central differences.",
    "Damping proportional to the stiffness would resist the ground.";

    GROUND_MOTION_INTEGRAL, Command, Test("tests/analysis/imposed_rates.rs", "integrals_of_opensees"),
    "`groundMotion Plain` with `-accel` without `-vel`, or `-vel` without `-disp`",
    "The trapezoidal rule begins at zero one step before the first value. The integral of a series without an end (`Constant`, `Linear`) is \
     zero.",
    "The integral is zero at the first value. That of a series without an end has no end either.",
    "A support pushed at a constant velocity would stand still.";

    UNIFORM_RATES, Command, Test("tests/analysis/imposed_rates.rs", "a_uniform_excitation_by_velocity"),
    "`pattern UniformExcitation` with `-vel` or `-disp` without `-accel`",
    "The ground rests.",
    "The acceleration is the derivative: exact for a formula, by central differences for points.",
    "The motion that is given would be left out.";

    IMPOSED_RATES, Analysis, Test("tests/analysis/imposed_rates.rs", "an_sp_node_has_the_velocity_of_its_series"),
    "`sp` in a load pattern: velocity and acceleration of the node",
    "They are zero under `constraints Plain` and `Transformation`. Under `Penalty` and `Lagrange` the integrator makes them of the \
     displacements, and the velocity of a motion that starts with one alternates between zero and twice its value.",
    "They are the derivatives of the series under every handler. In a static analysis whose load factor is the time, so is the velocity.",
    "Friction, dashpots and lead cores that depend on velocity would see none.";
}

/// Other differences.
pub(super) const OTHERS: &[Slip] = &[
    differs(
        "`eigen` without `-fullGenLapack`, tangents that are not symmetric (bearings with P-Delta moments, friction that follows the axial \
         force)",
        "The method of ARPACK for symmetric matrices finds other values: 1e-5 apart for rubber and sliders at rest, far off where they \
         slide. They depend on the vector that it starts from. Damping that a script makes of them differs as much.",
        "The values are those of the tangent. They agree with those of `-fullGenLapack` to 1e-9. Of a complex pair the real part is given.",
    ),
    differs(
        "`algorithm BFGS` and `Broyden` with force-based beams",
        "Iterations take another way within the tolerance of the test. `BFGS` fails in steps that converge here.",
        "The answer is another one within the tolerance of the test.",
    ),
    shared(
        "`rigidLink bar`",
        "All translations of the two nodes are the same, whatever the direction of the bar.",
        "The bar keeps its length, and the node turns about the other.",
    ),
    shared(
        "`eigen` without an analysis, in a Tcl script",
        "It makes a transient analysis of the parts that have been given, and of `constraints Transformation`, Newmark's method and Newton's \
         algorithm. In Python that is gone after the command.",
        "`analyze` has nothing to carry out.",
    ),
    differs(
        "`integrator ParkLMS3`",
        "openseespy 3.7.1 does not know it, and Newmark's method acts in its place. The Tcl interpreter has it.",
        "It is Park's method, with the numbers of the Tcl interpreter.",
    ),
    differs("`constraints Lagrange` with multi-point constraints", "openseespy 3.7.1 stops.", "They hold."),
    differs(
        "`fix` on a node that has moved",
        "`constraints Transformation` snaps it back to zero.",
        "It is held in its place, as by `Plain` in both programs.",
    ),
    differs(
        "`setNodeVel`, `setNodeAccel` between two `analyze`",
        "Integrators keep copies and do not see them.",
        "They count.",
    ),
    differs(
        "`integrator LoadControl` with bounds of the increment, after a step that has failed",
        "The iterations of the failed step count: the next increment is shorter.",
        "The iterations of the last step that converged count.",
    ),
    differs(
        "`integrator ArcLength1`",
        "openseespy 3.7.1 takes a denominator without α² Δλ and with s² times the sum of the unit displacements. Steps are longer or shorter \
         than the script says.",
        "The correction keeps the constraint to first order, as in the source of OpenSees.",
    ),
    differs(
        "`CollocationHSIncrReduct`, `CollocationHSIncrLimit`",
        "Elements stay at the place of collocation.",
        "Elements are at the end of the step.",
    ),
    differs(
        "`KRAlphaExplicit` with a banded or sparse system",
        "Of the effective mass, which is full, the pattern of the system has room for a part.",
        "All of it counts, as in OpenSees with `FullGeneral`.",
    ),
    differs(
        "`modalDamping` with `HHT` and its relatives",
        "The velocity is that of the end of the step. All other forces are those within it.",
        "The velocity is that within the step.",
    ),
    differs(
        "`eigen`: sign of a shape",
        "It differs between the solvers. A shape and its negative are the same mode.",
        "It is the same with every solver.",
    ),
    differs("`remove sp $node $dof $pattern`", "The motion of a pattern stays.", "The motion is gone."),
    differs(
        "`eigen` after a static analysis with `constraints Transformation`",
        "Elements at constrained nodes may be asked once more before, at rest. Their tangents are then those at rest.",
        "Elements are not asked again.",
    ),
    differs(
        "`groundMotion -accel` or `-vel` with a series of `-useLast`",
        "openseespy 3.7.1 has no integral. Integrals end at zero with the series.",
        "They go on with the last value of the series; under the switch they stay at their last value, as in later versions.",
    ),
    differs("`CentralDifferenceNoDamping`", "It reports no accelerations.", "It reports accelerations."),
    differs(
        "Integrators of the trapezoidal rule (`HHT_TP` and the like): unbalance at the start",
        "The loads are those that were applied last. Those of a pattern that is new and not zero at the start do not count. With \
         `modalDamping` damping forces count whole at both ends of a step.",
        "The loads are those of the start.",
    ),
    differs(
        "`sensNodeDisp`, `sensSectionForce` and the like: derivatives with respect to parameters",
        "They are zero for many laws, and of some responses they are not those of the analysis: under `DisplacementControl` a \
         displacement that is controlled has one.",
        "They are those of the analysis, for every law.",
    ),
    refused("`setParameter` without `-ele`, `-eleRange` or `-node`", "It does nothing.", "It is refused."),
];
