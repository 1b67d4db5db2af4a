//! Fibers have the numbers of OpenSees, and a point has the same nearest fiber. The tables are of openseespy 3.7.1, read from the
//! strains of the fibers under a unit curvature.

use super::script::run;

/// A section between two nodes, bent by 1 about z and then about y, and the strains of its fibers.
fn places(ndm: usize, section: &str, count: usize) -> Vec<[f64; 2]> {
    let strains = |bent: &str| {
        let line = |i| format!("puts [lindex [eleResponse 1 section fiber {i} stressStrain] 1]");
        let lines: Vec<String> = (0..count).map(line).collect();
        run(&format!("{}\n{}", bent_section(ndm, section, bent), lines.join("\n"))).numbers()
    };
    let y = strains(ABOUT_Z[ndm - 2]).into_iter().map(|e| -e);
    if ndm == 2 { y.map(|y| [y, 0.0]).collect() } else { y.zip(strains(ABOUT_Y)).map(|(y, z)| [y, z]).collect() }
}

/// A curvature of 1 about z, in the plane and in space, and about y.
const ABOUT_Z: [&str; 2] = ["sp 2 3 1", "sp 2 6 1"];
const ABOUT_Y: &str = "sp 2 5 1";

fn bent_section(ndm: usize, section: &str, bent: &str) -> String {
    let (nodes, fixes) = if ndm == 2 {
        ("node 1 0 0; node 2 0 0; node 3 0 0", "fix 1 1 1 1; fix 2 1 1 0; fix 3 0 1 1".to_owned())
    } else {
        // A line of fibers has no stiffness about itself, and the other rotation must not mix in.
        let held = if bent == ABOUT_Y { "0 1" } else { "1 0" };
        (
            "node 1 0 0 0; node 2 0 0 0; node 3 0 0 0",
            format!("fix 1 1 1 1 1 1 1; fix 2 1 1 1 1 {held}; fix 3 0 1 1 1 1 1"),
        )
    };
    format!(
        "model basic -ndm {ndm} -ndf {}
        {nodes}; {fixes}
        uniaxialMaterial Elastic 1 1000; uniaxialMaterial Elastic 2 2000; uniaxialMaterial Elastic 3 3000
        {section}
        element zeroLengthSection 1 1 2 1; element zeroLength 9 1 3 -mat 1 -dir 1
        timeSeries Linear 1; pattern Plain 1 1 {{ {bent} }}
        constraints Transformation; numberer Plain; system FullGeneral; algorithm Linear; integrator LoadControl 1
        analysis Static; analyze 1",
        3 * (ndm - 1)
    )
}

/// Rings of a round section: y and z.
const ROUND: [[f64; 2]; 19] = [
    [1.0091, 0.733156],
    [-0.385443, 1.18627],
    [-1.24732, 0.0],
    [-0.385443, -1.18627],
    [1.0091, -0.733156],
    [2.35457, 1.7107],
    [-0.899366, 2.76797],
    [-2.91041, 0.0],
    [-0.899366, -2.76797],
    [2.35457, -1.7107],
    [3.41974, 2.48458],
    [-1.30622, 4.02014],
    [-4.22703, 0.0],
    [-1.30622, -4.02014],
    [3.41974, -2.48458],
    [2.82843, 2.82843],
    [-2.82843, 2.82843],
    [-2.82843, -2.82843],
    [2.82843, -2.82843],
];

fn check(ndm: usize, section: &str, expected: &[[f64; 2]]) {
    let got = places(ndm, section, expected.len());
    for (i, (got, expected)) in got.iter().zip(expected).enumerate() {
        let near = (0..2).all(|k| (got[k] - expected[k]).abs() < 1e-4);
        assert!(near, "{section}, fiber {i}: {got:?}, not {expected:?}");
    }
    let count = run(&format!("{}\nputs [llength [eleResponse 1 section fiberData]]", bent_section(ndm, section, "")));
    assert_eq!(count.numbers(), [5.0 * expected.len() as f64], "{section}");
}

#[test]
fn shapes_number_their_fibers_as_opensees_does() {
    let plane = |y: &[f64]| y.iter().map(|y| [*y, 0.0]).collect::<Vec<_>>();
    check(2, "section WFSection2d 1 1 10. 1. 6. 2. 3 2", &plane(&[4.5, 3.5, 2.0, 0.0, -2.0, -3.5, -4.5]));
    let concrete = [
        2.69198, 0.0253165, -2.64135, 2.69198, 0.0253165, -2.64135, 4.77532, 4.27532, -4.72468, -4.22468, 4.02532,
        -3.97468, -1.30802, 1.35865,
    ];
    check(2, "section RCSection2d 1 1 2 3 10. 6. 1. 0.3 0.4 0.1 3 2 4", &plane(&concrete));
    let round = "section RCCircularSection 1 1 2 3 10. 1. 0.2 2 1 5 4";
    check(2, round, &ROUND.map(|[y, _]| [y, 0.0]));
    check(3, &format!("{round} -GJ 1."), &ROUND);
}

#[test]
fn patches_and_layers_number_their_fibers_as_opensees_does() {
    let cases: [(&str, &[[f64; 2]]); 9] = [
        (
            "patch rect 1 3 2 -2. -1. 2. 1.",
            &[[-1.33333, -0.5], [0.0, -0.5], [1.33333, -0.5], [-1.33333, 0.5], [0.0, 0.5], [1.33333, 0.5]],
        ),
        (
            "patch rect 1 3 2 2. 1. -2. -1.",
            &[[1.33333, 0.5], [0.0, 0.5], [-1.33333, 0.5], [1.33333, -0.5], [0.0, -0.5], [-1.33333, -0.5]],
        ),
        (
            "patch rect 1 3 2 -2. 1. 2. -1.",
            &[[-1.33333, -0.5], [0.0, -0.5], [1.33333, -0.5], [-1.33333, 0.5], [0.0, 0.5], [1.33333, 0.5]],
        ),
        (
            "patch quad 1 2 2 -2. -1. 2. -1.5 2.5 1. -2. 1.",
            &[[-0.946513, -0.590721], [1.113994, -0.77804], [-0.883949, 0.472875], [1.301647, 0.410429]],
        ),
        (
            "patch circ 1 5 2 0.5 0.25 1. 2.",
            &[
                [1.458647, 0.946498],
                [0.133829, 1.376957],
                [-0.684953, 0.25],
                [0.133829, -0.876957],
                [1.458647, -0.446498],
                [1.833457, 1.218813],
                [-0.009335, 1.817572],
                [-1.148243, 0.25],
                [-0.009335, -1.317572],
                [1.833457, -0.718813],
            ],
        ),
        (
            "patch circ 1 3 2 0.5 0.25 1. 2. 30. 120.",
            &[
                [1.385472, 1.135472],
                [0.824105, 1.459577],
                [0.175895, 1.459577],
                [1.731672, 1.481672],
                [0.950823, 1.932495],
                [0.049177, 1.932495],
            ],
        ),
        (
            "patch rect 1 1 1 -2. -1. 2. 1.; layer straight 2 4 0.1 -1. 0.5 1. 0.25",
            &[[0.0, 0.0], [-1.0, 0.5], [-0.333333, 0.416667], [0.333333, 0.333333], [1.0, 0.25]],
        ),
        (
            "patch rect 1 1 1 -2. -1. 2. 1.; layer circ 2 5 0.1 0. 0. 1.",
            &[
                [0.0, 0.0],
                [1.0, 0.0],
                [0.309017, 0.951057],
                [-0.809017, 0.587785],
                [-0.809017, -0.587785],
                [0.309017, -0.951057],
            ],
        ),
        (
            "patch rect 1 1 1 -2. -1. 2. 1.; layer circ 2 4 0.1 0. 0. 1. 30. 120.",
            &[[0.0, 0.0], [0.866025, 0.5], [0.5, 0.866025], [0.0, 1.0], [-0.5, 0.866025]],
        ),
    ];
    for (body, expected) in cases {
        let data = "puts [eleResponse 1 section fiberData]";
        let ran =
            run(&format!("{}\n{data}", bent_section(3, &format!("section Fiber 1 -GJ 1. {{ {body} }}"), "sp 2 6 1")));
        let got: Vec<[f64; 2]> = ran.numbers().chunks_exact(5).map(|f| [f[0], f[1]]).collect();
        assert_eq!(got.len(), expected.len(), "{body}");
        for (got, expected) in got.iter().zip(expected) {
            assert!((0..2).all(|k| (got[k] - expected[k]).abs() < 1e-5), "{body}: {got:?}, not {expected:?}");
        }
    }
}

/// Dimensions, body of a section, and the fibers that are nearest to points, by their coordinates.
type Nearest = (usize, &'static str, &'static [(&'static str, &'static [f64])]);

/// Points between fibers too: the round-off of the coordinates decides.
const NEAREST: &[Nearest] = &[
    (
        2,
        "patch rect 1 4 2 -0.2 -0.1 0.2 0.1",
        &[
            ("0 0", &[-0.05]),
            ("0.2 0", &[0.15]),
            ("-0.2 0", &[-0.15]),
            ("0.2 0.1", &[0.15]),
            ("0 0.1", &[-0.05]),
            ("0.1 0", &[0.05]),
            ("0 0 1", &[-0.05]),
        ],
    ),
    (
        2,
        "patch rect 1 10 2 -0.25 -0.15 0.25 0.15",
        &[
            ("0 0", &[-0.025]),
            ("0.25 0", &[0.225]),
            ("-0.25 0", &[-0.225]),
            ("0.25 0.15", &[0.225]),
            ("0 0.15", &[-0.025]),
            ("0.125 0", &[0.125]),
            ("0 0 1", &[-0.025]),
        ],
    ),
    (
        2,
        "patch rect 1 20 4 -0.3 -0.2 0.3 0.2",
        &[
            ("0 0", &[-0.015]),
            ("0.3 0", &[0.285]),
            ("-0.3 0", &[-0.285]),
            ("0.3 0.2", &[0.285]),
            ("0 0.2", &[-0.015]),
            ("0.15 0", &[0.165]),
            ("0 0 1", &[-0.015]),
        ],
    ),
    (
        2,
        "patch rect 1 8 2 -10 -6 10 6",
        &[
            ("0 0", &[-1.25]),
            ("10 0", &[8.75]),
            ("-10 0", &[-8.75]),
            ("10 6", &[8.75]),
            ("0 6", &[-1.25]),
            ("5 0", &[3.75]),
            ("0 0 1", &[-1.25]),
        ],
    ),
    (
        2,
        "patch rect 1 16 1 -0.15 -0.1 0.15 0.1",
        &[
            ("0 0", &[-0.009375]),
            ("0.15 0", &[0.140625]),
            ("-0.15 0", &[-0.140625]),
            ("0.15 0.1", &[0.140625]),
            ("0 0.1", &[-0.009375]),
            ("0.075 0", &[0.084375]),
            ("0 0 1", &[-0.009375]),
        ],
    ),
    (
        2,
        "patch rect 1 30 6 -250 -150 250 150",
        &[
            ("0 0", &[8.3333333]),
            ("250 0", &[241.6666667]),
            ("-250 0", &[-241.6666667]),
            ("250 150", &[241.6666667]),
            ("0 150", &[8.3333333]),
            ("125 0", &[125.0]),
            ("0 0 1", &[8.3333333]),
        ],
    ),
    (
        2,
        "patch circ 1 8 2 0 0 0.5 1; layer circ 2 6 0.01 0 0 0.9",
        &[
            ("0 0", &[-0.2361847]),
            ("1 0", &[0.9]),
            ("0 1", &[-0.2361847]),
            ("0 0 1", &[-0.2361847]),
            ("0 0 2", &[-0.45]),
            ("-1 0", &[-0.9]),
        ],
    ),
    (
        3,
        "patch rect 1 4 2 -0.2 -0.1 0.2 0.1",
        &[
            ("0 0", &[-0.05, -0.05]),
            ("0.2 0", &[0.15, -0.05]),
            ("-0.2 0", &[-0.15, -0.05]),
            ("0.2 0.1", &[0.15, 0.05]),
            ("0 0.1", &[-0.05, 0.05]),
            ("0.1 0", &[0.05, -0.05]),
            ("0 0 1", &[-0.05, -0.05]),
        ],
    ),
    (
        3,
        "patch rect 1 10 2 -0.25 -0.15 0.25 0.15",
        &[
            ("0 0", &[-0.025, -0.075]),
            ("0.25 0", &[0.225, 0.075]),
            ("-0.25 0", &[-0.225, -0.075]),
            ("0.25 0.15", &[0.225, 0.075]),
            ("0 0.15", &[-0.025, 0.075]),
            ("0.125 0", &[0.125, -0.075]),
            ("0 0 1", &[-0.025, -0.075]),
        ],
    ),
    (
        3,
        "patch rect 1 20 4 -0.3 -0.2 0.3 0.2",
        &[
            ("0 0", &[-0.015, -0.05]),
            ("0.3 0", &[0.285, 0.05]),
            ("-0.3 0", &[-0.285, -0.05]),
            ("0.3 0.2", &[0.285, 0.15]),
            ("0 0.2", &[-0.015, 0.15]),
            ("0.15 0", &[0.165, -0.05]),
            ("0 0 1", &[-0.015, -0.05]),
        ],
    ),
    (
        3,
        "patch rect 1 8 2 -10 -6 10 6",
        &[
            ("0 0", &[-1.25, -3.0]),
            ("10 0", &[8.75, -3.0]),
            ("-10 0", &[-8.75, -3.0]),
            ("10 6", &[8.75, 3.0]),
            ("0 6", &[-1.25, 3.0]),
            ("5 0", &[3.75, -3.0]),
            ("0 0 1", &[-1.25, -3.0]),
        ],
    ),
    (
        3,
        "patch rect 1 16 1 -0.15 -0.1 0.15 0.1",
        &[
            ("0 0", &[-0.009375, 0.0]),
            ("0.15 0", &[0.140625, 0.0]),
            ("-0.15 0", &[-0.140625, 0.0]),
            ("0.15 0.1", &[0.140625, 0.0]),
            ("0 0.1", &[-0.009375, 0.0]),
            ("0.075 0", &[0.084375, 0.0]),
            ("0 0 1", &[-0.009375, 0.0]),
        ],
    ),
    (
        3,
        "patch rect 1 30 6 -250 -150 250 150",
        &[
            ("0 0", &[8.3333333, 25.0]),
            ("250 0", &[241.6666667, -25.0]),
            ("-250 0", &[-241.6666667, 25.0]),
            ("250 150", &[241.6666667, 125.0]),
            ("0 150", &[-8.3333333, 125.0]),
            ("125 0", &[125.0, -25.0]),
            ("0 0 1", &[8.3333333, 25.0]),
        ],
    ),
    (
        3,
        "patch circ 1 8 2 0 0 0.5 1; layer circ 2 6 0.01 0 0 0.9",
        &[
            ("0 0", &[-0.2361847, -0.5702003]),
            ("1 0", &[0.9, 0.0]),
            ("0 1", &[-0.3285276, 0.7931358]),
            ("0 0 1", &[-0.2361847, -0.5702003]),
            ("0 0 2", &[-0.45, -0.7794229]),
            ("-1 0", &[-0.9, 0.0]),
        ],
    ),
];

#[test]
fn points_have_the_nearest_fiber_of_opensees() {
    let mut wrong = vec![];
    for (ndm, body, points) in NEAREST {
        let section = format!("section Fiber 1 -GJ 1. {{ {body} }}");
        for (i, axis) in ["y", "z"].iter().enumerate().take(ndm - 1) {
            let bent = if i == 0 { ABOUT_Z[ndm - 2] } else { ABOUT_Y };
            let lines = points
                .iter()
                .map(|(point, _)| format!("puts [lindex [eleResponse 1 section fiber {point} stressStrain] 1]"));
            let strains =
                run(&format!("{}\n{}", bent_section(*ndm, &section, bent), lines.collect::<Vec<_>>().join("\n")))
                    .numbers();
            for ((point, place), strain) in points.iter().zip(strains) {
                let got = if i == 0 { -strain } else { strain };
                if (got - place[i]).abs() > 1e-6 * place[i].abs().max(0.1) {
                    wrong.push(format!("{ndm} dimensions, {body}, at {point}: {axis} = {got}, not {}", place[i]));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
