//! Places of the nodes of single elements.

use nalgebra::Vector3;

/// Nodes of an element: in a line, at one place, or at the corners of a quadrilateral, a triangle or a brick.
#[derive(Clone, Copy, PartialEq)]
pub enum Shape {
    /// Uniform along its length: two elements in series equal one in extension and bending.
    Line,
    /// Its springs do not scale with its length.
    Link,
    MaterialPoint,
    Corners,
    Triangle,
    Brick,
    /// Corners, middles of the sides, and the centre, as many as there are nodes.
    Quadratic(usize),
    /// One above the other.
    Wall,
    /// An oblique rectangle in space.
    SpaceWall,
    /// Corners, and the middles of the edges if there are ten nodes.
    Tetrahedron(usize),
    /// At the middles of the edges of a rectangle, with a node of the element's own in its centre.
    Joint,
    /// The same without one; in space the rectangle is upright.
    Panel,
    /// In a line, and loaded by its own weight.
    Cable,
}

/// Coordinates of the nodes.
pub fn nodes(ndm: usize, shape: Shape) -> Vec<Vector3<f64>> {
    let start = Vector3::new(0.4, -0.3, if ndm == 3 { 0.7 } else { 0.0 });
    let along = if ndm == 3 { Vector3::new(1.0, 0.5, 1.0) } else { Vector3::new(0.9, 1.2, 0.0) };
    match shape {
        Shape::Line | Shape::Link | Shape::Cable => vec![start, start + along],
        Shape::MaterialPoint => vec![start, start],
        Shape::Panel if ndm == 3 => {
            [[0.0, -0.4], [0.3, 0.0], [0.0, 0.4], [-0.3, 0.0]].map(|[x, z]| Vector3::new(0.6 * x, 0.8 * x, z)).to_vec()
        }
        Shape::Joint | Shape::Panel => {
            [[0.0, -0.4], [0.3, 0.0], [0.0, 0.4], [-0.3, 0.0]].map(|[x, y]| Vector3::new(x, y, 0.0)).to_vec()
        }
        Shape::Wall => vec![start, start + 1.2 * Vector3::y()],
        Shape::SpaceWall => {
            let (across, up) = (0.3 * Vector3::new(2.0, 2.0, -1.0), 0.4 * Vector3::new(-1.0, 2.0, 2.0));
            vec![start, start + across, start + across + up, start + up]
        }
        Shape::Tetrahedron(count) => {
            let corners = [[0.0, 0.0, 0.0], [1.1, 0.1, 0.2], [0.1, 1.2, -0.1], [0.2, 0.3, 0.9]].map(Vector3::from);
            let middles =
                [(0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3)].map(|(i, j)| 0.5 * (corners[i] + corners[j]));
            corners.into_iter().chain(middles).take(count).collect()
        }
        Shape::Corners | Shape::Triangle => {
            let count = if shape == Shape::Triangle { 3 } else { 4 };
            let corners = [[0.0, 0.0], [1.1, 0.1], [1.3, 0.9], [-0.1, 0.8]];
            // In space the plane of the corners is oblique.
            let height = |x: f64, y: f64| if ndm == 3 { 0.3 * x - 0.4 * y + 0.2 } else { 0.0 };
            corners[..count].iter().map(|&[x, y]| Vector3::new(x, y, height(x, y))).collect()
        }
        Shape::Quadratic(count) => {
            let corners = [[0.0, 0.0], [1.1, 0.1], [1.3, 0.9], [-0.1, 0.8]].map(|[x, y]| Vector3::new(x, y, 0.0));
            let corners = if count == 6 { &corners[..3] } else { &corners[..] };
            let middle = |i: usize| {
                let bend = 0.03 * Vector3::new(1.0, i as f64 - 1.0, 0.0);
                0.5 * (corners[i] + corners[(i + 1) % corners.len()]) + bend
            };
            let centre = corners.iter().sum::<Vector3<f64>>() / corners.len() as f64;
            let all = corners.iter().copied().chain((0..corners.len()).map(middle)).chain([centre]);
            all.take(count).collect()
        }
        Shape::Brick => {
            let corners = [[0.0, 0.0], [1.1, 0.1], [1.3, 0.9], [-0.1, 0.8]];
            let layer = |z: f64| corners.map(|[x, y]| Vector3::new(x + 0.1 * z, y - 0.2 * z, z + 0.1 * x)).to_vec();
            [layer(0.0), layer(0.9)].concat()
        }
    }
}

/// The commands that make the nodes.
pub fn node_words(ndm: usize, ndf: usize, places: &[Vector3<f64>]) -> String {
    let mut out = format!("model basic -ndm {ndm} -ndf {ndf}\n");
    for (i, x) in places.iter().enumerate() {
        let words: Vec<String> = x.iter().take(ndm).map(ToString::to_string).collect();
        out += &format!("node {} {}\n", i + 1, words.join(" "));
    }
    out
}

/// The command that makes an element of a row, of so many nodes.
pub fn element_words(words: &str, count: usize) -> String {
    let tags: Vec<String> = (1..=count).map(|i| i.to_string()).collect();
    format!("element {}\n", words.replacen('@', &format!("1 {}", tags.join(" ")), 1))
}

/// Displacements of a small rigid rotation `spin` about the origin, and a translation.
pub fn rigid(places: &[Vector3<f64>], (ndm, ndf): (usize, usize), shift: Vector3<f64>, spin: Vector3<f64>) -> Vec<f64> {
    let spin = if ndm == 2 { Vector3::new(0.0, 0.0, spin.z) } else { spin };
    let mut u = vec![];
    for x in places {
        u.extend((shift + spin.cross(x)).iter().take(ndm));
        match (ndm, ndf) {
            (2, 3) => u.push(spin.z),
            (3, 6) => u.extend(spin.iter()),
            _ => {}
        }
    }
    u
}
