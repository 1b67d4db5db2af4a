//! Checks of the nodes, constraints and parameters.

hysteron_tcl::checks! {
    MODEL_WIPED "model-wiped":
        "A command follows \"wipe\" without a new \"model\".",
        "The dimensions of the former model still hold, as in OpenSees. A command \"model\" makes it plain.";
    NOTHING_TO_REMOVE "nothing-to-remove":
        "A command removes a thing that does not exist.",
        "OpenSees passes it over, and so does hysteron. Check the tag if the thing should be there.";
    NO_SUCH_PARAMETER "no-such-parameter":
        "No element that a parameter names has a number under that name.",
        "The parameter changes nothing. The names of a material's numbers are those of its command.";
    DIAPHRAGM_IGNORED "diaphragm-ignored":
        "A rigid diaphragm joins nothing, since the nodes lack the degrees of freedom for it.",
        "A diaphragm needs six degrees of freedom at a node in space, or a model in the plane.";
    DIAPHRAGM_APART "diaphragm-apart":
        "A node of a diaphragm in the plane lies beside the axis through the retained node.",
        "It moves as far as the retained node, and does not follow its rotation.";
    FOLLOWS_ITSELF "follows-itself":
        "A constraint joins a node with itself, which constrains nothing.",
        "Leave the retained node out. OpenSees leaves out the whole diaphragm, or its equations have no answer.";
    HELD_TWICE "held-twice":
        "A degree of freedom is held by a support and by an imposed displacement, or by two imposed ones.",
        "OpenSees does not define which of them holds. Remove one.";
    OFFSETS_IGNORED "offsets-ignored":
        "Joint offsets are taken for zero: no number follows the option, or a corotational transformation in space follows OpenSees.",
        "Give the offsets, or leave the option out. Without \"--compat opensees\" those of a corotational transformation count.";
}
