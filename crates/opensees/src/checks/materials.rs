//! Checks of the materials.

hysteron_tcl::checks! {
    UNUSUAL_PARAMETER "unusual-parameter":
        "A parameter of a law has a value that is seldom meant.",
        "OpenSees computes with it and so does hysteron. Check units, signs and the order of the numbers.";
    UNBOUNDED_FORCE "unbounded-force":
        "The hysteretic force of a Bouc-Wen law is not bounded.",
        "The sum of beta and gamma must be greater than zero.";
    FIXED_UNITS "fixed-units":
        "A law holds in certain units, and its numbers are of other ones.",
        "The message names the units. Convert the model or choose another law.";
    NO_STAGES "no-stages":
        "A material is given a stage, and its law has none.",
        "Stages belong to laws of soils that hysteron does not have. Leave the command out, or keep it for OpenSees.";
    UNFINISHED_ITERATION "unfinished-iteration":
        "An iteration inside a law has not converged where its curve is made.",
        "More iterations or a larger tolerance may help. The curve holds up to the strain of the message.";
    BEYOND_COMPOUND "beyond-compound":
        "A rubber that heats itself leaves the temperatures for which its parameters are known.",
        "It keeps the parameters of the last temperature. The option -beyond hold says that this is meant, and -beyond \
         error stops there.";
}
