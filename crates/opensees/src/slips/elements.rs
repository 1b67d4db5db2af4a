//! Beams, trusses and links.

use super::Shown::{Case, Nowhere, Test};
use super::{Slip, differs, shared, slips};

slips! {
    COROTATIONAL_OFFSETS, Command, Test("tests/analysis/opensees.rs", "corotational_offsets_are_ignored_in_space"),
    "`geomTransf Corotational` with `-jntOffset` in space",
    "The offsets are taken for zero.",
    "They count.",
    "The beam would end elsewhere.";

    DOMAINS, Command, Test("tests/analysis/domains.rs", "numbers_that_opensees_takes_are_warnings"),
    "Numbers without a meaning: `section Elastic`, `elasticBeamColumn`, `ElasticTimoshenkoBeam`, `truss` with a stiffness of 0 or less, \
     `layer` with a radius or an area of 0 or less, `patch circ` with a negative radius, `Steel01`, `Steel02`, `Hardening`, `ElasticPP` \
     with a strength or a modulus of 0 or less, `ViscousDamper` without stiffness, `truss` without length, a node out of the plane of its \
     `rigidDiaphragm`, one point of `Lobatto`, `constraints Penalty` with a penalty of 0 or less, `test` with less than one iteration",
    "It computes with them: a truss without length and a beam of one Lobatto point carry nothing, the node out of the plane is left out, \
     the test allows one iteration.",
    "They are refused.",
    "A slip of the pen would become a result.";

    NEGATIVE_AREAS, Command, Test("tests/analysis/opensees.rs", "fibers_of_negative_area"),
    "`patch` with corners or angles the other way round",
    "The fibers have negative areas.",
    "The command is refused.",
    "The section would lose what it was meant to gain.";

    FLAT_FIBERS, Command, Test("tests/analysis/opensees.rs", "fibers_in_the_plane_lie_at_z_0"),
    "Responses `fiberData`, `fiberData2` and `centroid` of `section Fiber` and `NDFiber` in the plane",
    "z is 0.",
    "z is that of the fiber.",
    "A picture of the section needs it.";

    PLANE_DEFORMATIONS, Analysis, Test("tests/analysis/opensees.rs", "deformations_of_an_elastic_beam_in_the_plane"),
    "Response `deformations` of `elasticBeamColumn` in the plane",
    "There is none of that name; it is `basicDeformation`.",
    "The basic deformations.",
    "Other beams have it.";

    COROTATIONAL_TRIALS, Command, Case("force_beams_space_pushed"),
    "`geomTransf Corotational` in space, `ASDShellQ4` and `ASDShellT3` with `-corotational`: large rotations of the nodes",
    "They are the sum of those of all trial states. The tangent of the shells is that of fixed axes.",
    "They are the sum of those of all steps.",
    "They would depend on the iterations.";

    FORCE_BEAM_TRIALS, Command, Case("force_beams_shaken"),
    "`forceBeamColumn`, `nonlinearBeamColumn`, `beamWithHinges`",
    "The element goes on from the last trial state until an energy of 1e-12 (`-iter`) is left. A step that does not converge is tried with \
     the initial flexibility, then cut into parts (`-subdivide`), then given up. Sections may be left that carry less than the forces \
     along the beam.",
    "The element goes on from the committed state to round-off, in up to a hundred parts. Its sections carry the forces along the beam, \
     or the step fails.",
    "The answer would depend on the iterations.";

    DEFLECTED_BEAM, Command, Case("deflected_beams"),
    "`forceBeamColumnCBDI`, `forceBeamColumnCSBDI`",
    "The element goes on from the last trial state until an energy of 1e-12 (`-iter`) is left, and stops after ten iterations. A call \
     without an increment of the deformations and without loads leaves it as it was. The switch follows this with elastic sections; others \
     agree to the tolerance. In the plane loads between the ends do not reach the sections. \
     Slopes of shear strains are measured from the strain at node i.",
    "The element goes on from the committed state to round-off. Loads reach the sections. Slopes are measured from the mean, as the \
     deflections are.",
    "The answer would depend on the iterations, and equilibrium would be lost along the beam.";

    COUPLED_ZERO_LENGTH, Command, Nowhere,
    "`CoupledZeroLength`",
    "The tangent is that of the spring in both directions.",
    "The tangent is the derivative of the force, which turns with the offset.",
    "Newton's method converges.";

    SHELL_AXES, Command, Case("shells_enhanced"),
    "`ASDShellQ4` and `ASDShellT3`: axes of the section",
    "Without `-local` axis 1 is square to the side from node 1 to node 2; transverse shear strains turn from the axes of the shell to \
     those of the section the other way round (openseespy 3.7.1).",
    "Axis 1 runs along the first direction of the mesh, as documented, and all strains turn with it.",
    "Layers and recorders would be turned by a right angle.";

    JOINT_MASS, Analysis, Case("joint_2d"),
    "`beamColumnJoint`: modes, and tangents of transient analyses",
    "Its mass and its damping matrix are its stiffness. Forces have neither.",
    "It has no mass.",
    "Periods would be wrong, and steps would need more iterations.";

    WALL_MASS, Command, Case("wall_lines"),
    "`MVLEM` with a density",
    "The element has no mass: it is computed before the height is known.",
    "Half of density times volume is at each node.",
    "A mass that is given counts.";

    TETRAHEDRON_VOLUME, Command, Case("plastic_continua"),
    "`TenNodeTetrahedron`",
    "Stiffness, mass and body forces are a sixth: the weights of the points are divided by six twice.",
    "They are those of the volume.",
    "Displacements would be six times too large.";

    GROUND_INERTIA_TWICE, Analysis, Case("timoshenko_plane"),
    "`elasticBeamColumn` with `-mass` in the plane, `ElasticTimoshenkoBeam` with `-mass`: `UniformExcitation`",
    "The inertia force of the ground motion on the mass of the element counts twice.",
    "It counts once.",
    "OpenSees subtracts the load in the resisting force and where it adds the inertia.";

    GROUND_INERTIA_REPORTED, Analysis, Case("timoshenko_space"),
    "`elasticBeamColumn`, `ElasticTimoshenkoBeam`, `dispBeamColumn`, `forceBeamColumn`, `truss` with mass under `UniformExcitation`: \
     reported `force`",
    "It is the resisting force plus mass times ground acceleration.",
    "It is the resisting force.",
    "An end force is no inertia.";
}

/// Other differences.
pub(super) const OTHERS: &[Slip] = &[
    differs(
        "`ASDShellT3`, and `-drillingNL`, with layers that yield",
        "Its transverse shear is reduced for the thickness that the current stiffness of the layers has, and damage is measured by it.",
        "Both are by the initial stiffness.",
    ),
    differs(
        "`ASDShellQ4` without `-noeas`, with layers that yield",
        "Internal modes of the membrane take one step of Newton's method in each iteration, and what is left is committed.",
        "They are in equilibrium to round-off.",
    ),
    differs(
        "`forceBeamColumnCBDI`, `forceBeamColumnCSBDI` in space: moment about y",
        "The moment that the sections keep has the deflection in the other plane.",
        "It has the deflection in its own plane, so that each section is in equilibrium with the ends.",
    ),
    differs(
        "`zeroLengthContact3D`, `inerter` with `-pDelta`: tangent",
        "A term of sliding friction in two directions is wrong; the stiffness of the P-Delta forces counts as mass. Forces are the same.",
        "The tangent is the derivative of the force.",
    ),
    differs(
        "`beamColumnJoint` in space: response `deformation`",
        "Each reading adds the displacements to those of all readings before.",
        "It is that of the state.",
    ),
    differs(
        "`bbarQuad`: responses `stresses` and `strains`, and its mass under `UniformExcitation`",
        "The fourth component of a point is the third. The inertia force of the ground is read from beyond the end of a vector.",
        "It is the shear. The inertia force is that of the mass.",
    ),
    differs(
        "`SSPbrick` that is no parallelepiped: mass and body forces of the corners",
        "They come from an expansion of the volume whose terms are multiplied by the volume once more.",
        "They are the integrals of the shape functions.",
    ),
    differs(
        "`zeroLengthImpact3D`, `zeroLengthContact2D` and `zeroLengthContact3D`: reported force while it slides",
        "It is computed anew from the committed state, in which the friction is zero.",
        "It is the force of the step.",
    ),
    differs(
        "`tri6n` with a pressure",
        "On the half of the side 3-1 that ends at node 1 it is taken along the line from node 6 to node 4.",
        "It is square to the sides.",
    ),
    differs(
        "`ASDShellQ4` with `-noeas`, nodes in no parallelogram",
        "The drilling strain at the centre is that of the last point of the shell that was evaluated before.",
        "It is that of the shell.",
    ),
    differs(
        "`eleLoad` on an `elasticBeamColumn` with releases",
        "openseespy 3.7.1 takes the end moments of the clamped beam for partial loads, and in space for point loads. A moment is left at a \
         released end.",
        "The moment there is zero, as in later versions.",
    ),
    differs(
        "`eleLoad -type -beamUniform` with a start and an end, and only some values at the end",
        "openseespy takes zero for those that are left out. In space openseespy 3.7.1 takes no notice of values at the end.",
        "Those left out are the values at the start, as in the Tcl interpreter. In space they hold, as in later versions.",
    ),
    differs("`ElasticTimoshenkoBeam`: element loads", "Uniform loads count, others are lost.", "All loads count."),
    differs(
        "`mixedBeamColumn` in the plane with sections that shear",
        "The shear deformations of the sections have no part in the beam.",
        "They have.",
    ),
    super::refused(
        "`ElasticTimoshenkoBeam` with joint offsets, or with a section without G",
        "The offsets change the length and not the axes. G is 1.",
        "Both are refused.",
    ),
    differs(
        "`geomTransf Corotational` with `-jntOffset` in the plane",
        "openseespy 3.7.1 does not converge.",
        "The offsets count.",
    ),
    differs(
        "`forceBeamColumn` after a step that failed",
        "The first call of the next step has the sections as they were.",
        "The first call is like any other.",
    ),
    differs(
        "`rayleigh` with the initial stiffness and `geomTransf Corotational` in space",
        "The initial stiffness turns with the beam.",
        "It stays as it was.",
    ),
    differs(
        "`beamIntegration CompositeSimpson` with other than three points",
        "The weights do not add up to the length.",
        "The rule is that of Simpson.",
    ),
    differs(
        "`ShellDKGT`, `enhancedQuad`: Rayleigh damping by the initial stiffness, and algorithms with the initial tangent",
        "The initial stiffness is another matrix than the tangent at rest.",
        "It is the tangent at rest.",
    ),
    shared(
        "`zeroLength` with `-dampMats` and `-doRayleigh`",
        "The last of the two options holds: `-doRayleigh` behind `-dampMats` takes the damping materials away. A warning says so.",
        "The materials damp in either order.",
    ),
    differs(
        "`ShellNLDKGQ`: tangent",
        "The geometric stiffness is that of the membrane forces. Large steps may not converge.",
        "It is the derivative of the forces. Forces are the same.",
    ),
];
