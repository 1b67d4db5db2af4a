//! Checks of the elements and sections.

hysteron_tcl::checks! {
    SAME_NODE "same-node":
        "An element joins a node with itself.",
        "A zeroLength element too needs two nodes: both may have the same coordinates.";
    ZERO_VECTOR "zero-vector":
        "A vector that gives a direction has no length.",
        "In space the vector of geomTransf lies in the local x-z plane and is not parallel to the element.";
    MATERIALS_AND_DIRECTIONS "materials-and-directions":
        "A link has another number of materials than of directions.",
        "Each direction behind -dir has the material in the same place behind -mat; one material may stand twice.";
    THERMAL_UNITS "thermal-units" (once):
        "The thermal constants of lead do not go with the units of the bearing.",
        "The lead heats as no lead does. The message gives the constants in common units. The defaults hold for SI.";
    NODES_APART "nodes-apart":
        "The nodes of a zero-length element are not at one place.",
        "The element takes no notice of the distance. A moment of its force over that distance is missing.";
    FEWER_MATERIALS "fewer-materials":
        "An element has fewer materials than directions.",
        "The directions without a material stay free. Give each direction its material.";
    INCLINED_JOINT "inclined-joint":
        "A beam-column joint is inclined.",
        "Its springs act along the global axes. Nodes below, right, above and left of the centre are expected.";
    NO_STIFFNESS "no-stiffness":
        "A beam, a section or a fiber section has no stiffness in one of its actions.",
        "The model may become a mechanism. Give the property a value, or the section another resultant.";
    SEGMENTS_IN_SERIES "segments-in-series":
        "A triple pendulum element computes displacements of its surfaces in one way only.",
        "Speeds and heat are those of the series of segments, which OpenSees calls tagT 1.";
    UNSCALED_SPRINGS "unscaled-springs":
        "The shear springs of a multiple spring element are not scaled.",
        "Together they are several times as stiff as the one that the material describes. The option -limDisp scales \
         them.";
    INVERTED_ELEMENT "inverted-element":
        "The corners of an element go round the wrong way.",
        "Its stiffness and mass are negative. Reverse the order of the corners.";
    PATCH_TURNED_ROUND "patch-turned-round":
        "Radii and angles of a patch are both given from the larger to the smaller one.",
        "The fibers are those of the patch the right way round. Write the inner radius and the first angle first.";
    FIBER_WITHOUT_AREA "fiber-without-area":
        "A fiber has no area, and is left out.",
        "OpenSees integrates it without effect. Correct the area or remove the fiber.";
    DAMPING_LEFT_OUT "damping-left-out":
        "An element cannot have the damping of its region.",
        "The message says why. The element is left without this damping.";
    OUTSIDE_LEARNED_RANGE "outside-learned-range" (once):
        "A device with a learned law has left the range that the law was fitted in.",
        "Nothing was measured there. The law is held at the end of its range or goes on, as its script says.";
}
