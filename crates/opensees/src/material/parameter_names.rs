//! OpenSees' names of parameters of materials, where they differ from the names of the usage lines.
//!
//! Source: `setParameter` of the uniaxial materials of OpenSees.

/// Numbers of the usage line that one name sets, with their signs.
type Numbers = &'static [(&'static str, f64)];

/// Kinds of materials, and their names.
type Names = (&'static [&'static str], &'static [(&'static str, Numbers)]);

/// The names of all kinds that have some.
const NAMES: &[Names] = &[
    (
        &["Steel03", "SteelFractureDI"],
        &[
            ("sigmaY", &[("Fy", 1.0), ("fy", 1.0)]),
            ("fy", &[("Fy", 1.0)]),
            ("Fy", &[("fy", 1.0)]),
            ("E", &[("E0", 1.0)]),
        ],
    ),
    (
        &["Hardening", "GNG"],
        &[
            ("fy", &[("sigmaY", 1.0), ("sigY", 1.0)]),
            ("Fy", &[("sigmaY", 1.0), ("sigY", 1.0)]),
            ("k", &[("E", 1.0)]),
            ("H_kin", &[("Hkin", 1.0)]),
            ("H_iso", &[("Hiso", 1.0)]),
        ],
    ),
    (
        &["Concrete01", "ConfinedConcrete01"],
        &[("fc", &[("fpc", 1.0)]), ("epsco", &[("epsc0", 1.0)]), ("fcu", &[("fpcu", 1.0)])],
    ),
    (&["ElasticPPGap"], &[("k", &[("E", 1.0)]), ("fy", &[("Fy", 1.0)])]),
    (
        &["ElasticBilin"],
        &[
            ("E1p", &[("EP1", 1.0)]),
            ("E2p", &[("EP2", 1.0)]),
            ("eps2p", &[("epsP2", 1.0)]),
            ("E1n", &[("EN1", 1.0)]),
            ("E2n", &[("EN2", 1.0)]),
            ("eps2n", &[("epsN2", 1.0)]),
            ("E1", &[("EP1", 1.0), ("EN1", 1.0)]),
            ("E2", &[("EP2", 1.0), ("EN2", 1.0)]),
            ("eps2", &[("epsP2", 1.0), ("epsN2", -1.0)]),
        ],
    ),
    (
        &["ViscousDamper", "BilinearOilDamper"],
        &[("E", &[("K", 1.0)]), ("eta", &[("C", 1.0)]), ("Lgap", &[("LGap", 1.0)])],
    ),
    (&["CoulombDamper"], &[("Tangent", &[("tangent", 1.0)]), ("Friction", &[("friction", 1.0)])]),
    (
        &["SteelBRB"],
        &[
            ("sigmaY_T", &[("sigmaYT", 1.0)]),
            ("alpha_T", &[("alphaT", 1.0)]),
            ("beta_T", &[("betaT", 1.0)]),
            ("delta_T", &[("deltaT", 1.0)]),
            ("sigmaY_C", &[("sigmaYC", 1.0)]),
            ("alpha_C", &[("alphaC", 1.0)]),
            ("beta_C", &[("betaC", 1.0)]),
            ("delta_C", &[("deltaC", 1.0)]),
        ],
    ),
    (&["InitStressMaterial"], &[("sig0", &[("stress", 1.0)]), ("f0", &[("stress", 1.0)]), ("F0", &[("stress", 1.0)])]),
    (&["Multiplier"], &[("multiplier", &[("factor", 1.0)])]),
];

/// Materials whose points are called otherwise: the names of force and deformation in a parameter, and in the usage line.
const POINTS: &[(&[&str], [[&str; 2]; 2])] = &[
    (&["Hysteretic", "HystereticSM", "LimitState"], [["mom", "s"], ["rot", "e"]]),
    (&["Pinching4"], [["stress", "f"], ["strain", "d"]]),
];

/// The numbers of a point of an envelope by their name: `mom2p` is `s2p`, and `mom2` is `s2p` and `s2n` with its sign.
fn points_of(stems: &[[&str; 2]; 2], name: &str) -> Vec<(String, f64)> {
    let yield_force = matches!(name, "fy" | "Fy").then_some("1p");
    let point = stems.iter().find_map(|[stem, own]| Some((name.strip_prefix(stem)?, own)));
    match (point, yield_force) {
        (None, Some(first)) => vec![(format!("{}{first}", stems[0][1]), 1.0)],
        (Some((of, own)), _) if of.ends_with(['p', 'n']) => vec![(format!("{own}{of}"), 1.0)],
        (Some((of, own)), _) => vec![(format!("{own}{of}p"), 1.0), (format!("{own}{of}n"), -1.0)],
        (None, None) => vec![],
    }
}

/// Numbers of the usage line of a kind that OpenSees' name of a parameter sets, with their signs.
pub(super) fn numbers_of(kind: &str, name: &str) -> Vec<(String, f64)> {
    if let Some((_, stems)) = POINTS.iter().find(|(kinds, _)| kinds.contains(&kind)) {
        return points_of(stems, name);
    }
    let rows = NAMES.iter().filter(|(kinds, _)| kinds.contains(&kind)).flat_map(|(_, names)| *names);
    let numbers = rows.filter(|(n, _)| *n == name).flat_map(|(_, numbers)| *numbers);
    numbers.map(|(number, sign)| ((*number).to_owned(), *sign)).collect()
}
