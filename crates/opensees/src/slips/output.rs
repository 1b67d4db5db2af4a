//! Recorders, reactions and the exit status.

use super::Shown::{Case, Nowhere, Test};
use super::{Slip, differs, shared, slips};

slips! {
    INCR_DISP, Analysis, Case("truss2d_loadcontrol"),
    "`recorder Node ... incrDisp`",
    "The record is zero.",
    "The record is the displacement less that of the last row.",
    "OpenSees clears the field before it is recorded.";

    REACTIONS_RAYLEIGH, Analysis, Nowhere,
    "`reactions -rayleigh`, recorder `rayleighForces`",
    "The damping of elements with `-doRayleigh` off counts.",
    "The damping that acts counts.",
    "OpenSees asks no element if it takes part.";

    MISSING_RESPONSE, Command, Test("tests/cli/recorders.rs", "missing_response"),
    "`recorder Node`, `EnvelopeNode` without a response",
    "The displacements are recorded. A warning says so.",
    "It is refused.",
    "Another response may have been meant.";

    KEPT_REACTIONS, Command, Test("tests/analysis/opensees.rs", "reactions_are_those_of_the_command"),
    "`nodeReaction`",
    "Reactions are those of the last `reactions`, or of the last row of a recorder of reactions; zero without either.",
    "Reactions are those of the present state.",
    "A reaction of another state is wrong.";

    FAILED_TEST, Command, Nowhere,
    "`testIter` after a step that failed",
    "One more test is counted.",
    "The tests that were made are counted.",
    "";

    EXIT_STATUS, Command, Nowhere,
    "Exit status where the last `analyze` failed and the script went on to its end",
    "It is 0.",
    "It is 1, with a message.",
    "A batch must see it.";
}

/// Other differences.
pub(super) const OTHERS: &[Slip] = &[
    differs(
        "Elements that an integrator leaves behind (`AlphaOS` without `-updateElemDisp`, `...HSFixedNumIter`)",
        "Elastic beams show the force at the displacement of the nodes, other elements that at which they were asked.",
        "All elements show the force of the equations.",
    ),
    shared(
        "`recorder` with `-dT`",
        "The first step is a row. The next one is due an interval after the last: rows come late by up to a step, and the delays add up.",
        "Rows stand at the multiples of the interval.",
    ),
    differs(
        "`printA`, `printB`, `printX`",
        "They depend on the numberer and on the system.",
        "Equations have the order of rising tags of the nodes, as by `numberer Plain`. The matrix is there whatever the system; under `system Diagonal` it is the diagonal, as in OpenSees.",
    ),
];
