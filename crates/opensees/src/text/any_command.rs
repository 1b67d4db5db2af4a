//! Arguments that mean the same in every command.

use super::{Arg, Domain};

/// Mass of an element.
pub(crate) const MASS: Arg = Arg::of("-mass", "m", "mass").within(Domain::NotNegative);
/// Iterations inside of an element or a law, and their tolerance.
pub(crate) const ITERATIONS: Arg =
    Arg::of("-iter", "maxIter", "largest number of iterations maxIter").within(Domain::Count);
pub(crate) const TOLERANCE: Arg = Arg::of("-iter", "tol", "tolerance").within(Domain::Positive);
/// Place of the shear force of a link.
pub(crate) const SHEAR_DIST: Arg =
    Arg::of("-shearDist", "sDratio", "place of the shear force as a fraction of the length").within(Domain::Number);

/// Arguments that mean the same in every command.
pub(super) const ANY_COMMAND: &[Arg] = &[
    Arg::flag("-doRayleigh", "the element takes part in Rayleigh damping"),
    Arg::of("-doRayleigh", "flag", "1: the element takes part in Rayleigh damping; 0: it does not")
        .within(Domain::Whole),
    Arg::flag("-cMass", "consistent mass matrix in place of a lumped one"),
    Arg::flag("-lMass", "lumped mass matrix (default)"),
    Arg::of("-cMass", "flag", "1: consistent mass matrix; 0: lumped").within(Domain::Whole),
    Arg::of("-useInitialDisp", "flag", "1: strain counts from the displacements at hand; 0: from zero")
        .within(Domain::Whole),
    Arg::of(
        "-orient",
        "x1",
        "local x axis, then a vector in the local x-y plane; in space three numbers alone are the \
         local y axis",
    )
    .within(Domain::Number),
    SHEAR_DIST,
    Arg::of("-shearDist", "sDy", "distance of the shear forces from node i over the length").within(Domain::Number),
    ITERATIONS,
    TOLERANCE,
    MASS,
    Arg::of("-damp", "damping", "tag of a damping of the element's own").within(Domain::Whole),
    Arg::of("-mat", "mat1", "tags of the laws, one for each direction").within(Domain::Whole),
    Arg::of("-dir", "dir1", "directions of the laws: 1 to 3 displacements, 4 to 6 rotations").within(Domain::Whole),
    Arg::of("-P", "mat", "law of the axial force").within(Domain::Whole),
    Arg::of("-T", "mat", "law of torsion, in space"),
    Arg::of("-My", "mat", "law of the moment about local y, in space"),
    Arg::of("-Mz", "mat", "law of the moment about local z").within(Domain::Whole),
    Arg::of("-Vy", "mat", "law of the shear force along local y").within(Domain::Whole),
    Arg::of("-Vz", "mat", "law of the shear force along local z, in space"),
    Arg::of("-release", "code", "ends without moment: 0 none, 1 end i, 2 end j, 3 both").within(Domain::Whole),
    Arg::of("-releasez", "code", "ends without moment about local z: 0 none, 1 end i, 2 end j, 3 both")
        .within(Domain::Whole),
    Arg::of("-releasey", "code", "ends without moment about local y: 0 none, 1 end i, 2 end j, 3 both")
        .within(Domain::Whole),
    Arg::flag("-geomNonlinear", "second-order effect within the element"),
    Arg::flag("-shear", "deflections follow shear strains too"),
    Arg::of("-integration", "rule", "rule of integration, by its name in `beamIntegration`"),
    Arg::of("-sections", "section1", "tags of the sections, one for each point").within(Domain::Whole),
    Arg::flag("-shape", "plan of the section: `round` or `square`"),
    Arg::flag("-noPDInput", "without the P-Delta effect on the inner equilibrium"),
    Arg::flag("-noTilt", "without the tilt of the shear springs"),
    Arg::flag("-inclVertDisp", "the pendulum rises as it slides"),
    Arg::of("-nMat", "mat1", "tags of the laws, one for each spring").within(Domain::Whole),
    Arg::flag("-axial", "axial law: `kumar` (cavitation and buckling) or `linear`"),
    Arg::flag("-pDelta", "`on` or `off`: moments of the axial force"),
    Arg::of("-dampMats", "mat1", "tags of laws of damping, one for each direction").within(Domain::Whole),
    Arg::flag(
        "-beyond",
        "`hold`: beyond its table rubber keeps the parameters of the end, with a warning; `error`: \
         the analysis ends",
    ),
    Arg::flag("-alpha", "the argument before `$beta` or `$b1` is $(k_a - k_b)/(2 f)$ in place of $f$"),
    Arg::flag("-returnD", "under `--compat opensees`: stress over strain as damping tangent"),
    Arg::of("-factors", "factor1", "factors on the laws, one for each"),
    Arg::flag("-updateElemDisp", "the elements see the displacements at the end of the step"),
    Arg::flag("-determinant", "the sign of the step follows the determinant of the tangent"),
    Arg::flag("-form", "unknown of the equations: displacement `D`, velocity `V` or acceleration `A`"),
    Arg::flag("-factorOnce", "the tangent is factored once"),
    Arg::flag("-initial", "the initial tangent"),
    Arg::flag("-initialTangent", "the initial tangent"),
    Arg::flag("-currentTangent", "the current tangent"),
    Arg::flag("-time", "the first column is the time"),
    Arg::flag("-closeOnWrite", "every row is written at once"),
    Arg::flag("-ret", "returns the numbers in place of printing them"),
    Arg::flag("-print", "prints the report"),
    Arg::flag("-return", "returns the properties as a list"),
    Arg::flag("-unorm", "mode shapes with a largest displacement of 1"),
    Arg::flag("-generalized", "the eigenvalue problem with the mass matrix (default)"),
    Arg::flag("-standard", "the eigenvalue problem without the mass matrix"),
    Arg::flag("-findLargest", "the largest eigenvalues"),
    Arg::flag("-const", "the load is constant in time"),
    Arg::flag("-commit", "the state is committed"),
    Arg::flag("-subtractInit", "the value counts from the displacement at hand"),
    Arg::flag("-dynamic", "with inertia"),
    Arg::flag("-rayleigh", "with Rayleigh damping"),
    Arg::flag("-useLast", "beyond the last point the factor stays; without it, it is zero"),
    Arg::flag("-prependZero", "a zero comes before the first value"),
    Arg::flag("-equal", "both axes have the same scale"),
    Arg::flag("-JSON", "as JSON"),
    Arg::flag("-noCentroid", "coordinates are not moved to the centroid"),
    Arg::of("-temperature", "T", "temperature of the rubber, degC"),
];
