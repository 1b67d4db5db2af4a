//! Checks of the analyses.

hysteron_tcl::checks! {
    NO_ANALYSIS "no-analysis":
        "The command analyze stands before any command analysis.",
        "It returns -1 and does nothing, as in OpenSees.";
    NO_DERIVATIVES "no-derivatives" (once):
        "A script asks for a derivative before the command sensitivityAlgorithm.",
        "It is zero, as in OpenSees.";
    NO_PENALTY "no-penalty" (once):
        "A handler of constraints has a penalty of zero, so that nothing is held.",
        "The matrices are those without constraints. For an analysis take \"constraints Transformation\".";
    FAILED_STEP "failed-step":
        "A step of an analysis has failed.",
        "The command analyze returns a negative number, and the script decides. The message says where the largest \
         residual is.";
    UNKNOWN_INTEGRATOR "unknown-integrator":
        "An integrator is not known, and the command does nothing, as in OpenSees.",
        "The integrator before it stays. Without \"--compat opensees\" the command is refused.";
    UNSTABLE_METHOD "unstable-method":
        "The parameters of an integrator make a method that is not stable for every step.",
        "The motion may grow by itself. The label gives the range of stable parameters.";
    UNSTABLE_STEPS "unstable-steps" (once):
        "The steps of an explicit integrator are longer than its longest stable one.",
        "The motion grows until it overflows. Take shorter steps, or an implicit integrator.";
    PLAIN_CONSTRAINTS "plain-constraints" (once):
        "OpenSees' handler Plain leaves out a constraint or an imposed motion that hysteron follows.",
        "The command \"constraints Transformation\" gives the same answer in both programs.";
    FIXED_AND_TIED "fixed-and-tied" (once):
        "A degree of freedom is held, and a constraint ties it to one that is not.",
        "Hold the node that it follows, or remove one of both.";
    LOOSE_CONSTRAINT "loose-constraint" (once):
        "A penalty is too small to keep a constraint.",
        "The node misses the one it should follow by more than a hundredth. Take a larger factor, or \
         Transformation.";
    PSEUDO_TIME "pseudo-time" (once):
        "A law that depends on the rate stands under an integrator in which no time passes.",
        "An imposed displacement over a Path series under LoadControl goes at the rate of that path.";
    NO_VELOCITY "no-velocity":
        "A law depends on the velocity, and no analysis of the script gives its nodes one.",
        "A transient analysis gives it, and so does a displacement that is imposed in time.";
    NEARLY_SINGULAR "nearly-singular" (once):
        "The equations have hardly any stiffness left in one degree of freedom.",
        "Few digits of the results are right. Look for a mechanism at the node of the message.";
    OUT_OF_BALANCE "out-of-balance" (once):
        "Steps count as converged while a part of the loads has no counterpart.",
        "A test of the unbalance, or a smaller tolerance, shows it.";
    OVERLOADED_BEARING "overloaded-bearing" (once):
        "The axial load of a bearing is above its critical load.",
        "It has buckled. Its critical load falls with the shear displacement.";
    BUCKLED_BEAM "buckled-beam" (once):
        "The compression of a beam is above its Euler load.",
        "The beam has buckled. Its elastic force means nothing beyond that load.";
    SOFTENING_BEARING "softening-bearing" (once):
        "A bearing has come to displacements at which its backbone pushes away from rest.",
        "Parameters that were calibrated to loops hold within the shear of these loops.";
    EXCESS "excess" (once):
        "A response is beyond what the model can mean.",
        "Units, stiffness and the scale of the excitation are the usual reasons.";
    DAMPED_ISOLATORS "damped-isolators" (once):
        "Rayleigh damping takes a large part of the energy that goes into isolators.",
        "A bearing has no such damping. Give the factors to the superstructure alone.";
    NEGATIVE_DAMPING "negative-damping":
        "Rayleigh damping is negative.",
        "It feeds the motion. The factors should not be less than zero.";
    DAMPING_OF_MODES "damping-of-modes":
        "The numbers of damping ratios and of modes differ.",
        "The other modes are not damped, or the other ratios are left out.";
    FEW_MODES "few-modes":
        "The model has fewer modes than the command asks for.",
        "Modes exist where there is mass. The others have an infinite eigenvalue.";
    RIGID_MODES "rigid-modes":
        "Modes move the model as a rigid body or a mechanism.",
        "They have no period. A model that is held everywhere has none.";
    NO_GRAVITY "no-gravity" (once):
        "A ground motion begins while the bearings of the model carry no vertical load.",
        "Apply the weight in a static analysis and hold it with \"loadConst -time 0.0\". A slider without weight has no \
         friction, and a bearing no P-Delta effect.";
    FLOOR_WITHOUT_MASS "floor-without-mass" (once):
        "A floor of a building has no mass along a ground motion, and other floors have one.",
        "The command \"mass\" gives it one, at its nodes or at the retained node of its diaphragm.";
    STATIC_GROUND_MOTION "static-ground-motion" (once):
        "A static analysis runs under the record of a ground motion.",
        "It has neither velocities nor inertia of the model. The commands \"analysis Transient\" and \"integrator \
         Newmark 0.5 0.25\" follow the record.";
    GRAVITY_UPWARDS "gravity-upwards" (once):
        "The static loads are the weight of the masses and push upwards.",
        "Turn their sign. Beams and bearings would be in tension.";
    MASS_IS_WEIGHT "mass-is-weight" (once):
        "The masses are the same numbers as the static loads.",
        "A mass is its weight over g. With such masses each period is too long by the root of g.";
    MASS_UNITS "mass-units" (once):
        "The masses are a thousand times too large for the static loads.",
        "A mass is its weight over g: tonnes go with kN and m, kilograms with N and m.";
    LONG_PERIOD "long-period" (once):
        "The first period is longer than that of the tallest buildings.",
        "Check the units of masses and stiffness.";
    BEARING_ON_ITS_SIDE "bearing-on-its-side" (once):
        "The shear of a bearing would carry the load, and not its axis.",
        "The option -orient gives the local x, which is the axis of the bearing.";
}
