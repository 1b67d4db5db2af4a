//! The tetrahedra `FourNodeTetrahedron` and `TenNodeTetrahedron`.

use super::brick::strain_rows;
use super::{Body, Continuum, ElementResult, Mass, Rows, least_distance};
use crate::element::{Class, ElementError};
use crate::material::{SOLID, SharedMultiaxial};
use nalgebra::{Matrix3, Vector3};

/// Ends of the edges whose middles are nodes 5 to 10 of the tetrahedron with ten nodes.
const EDGES: [(usize, usize); 6] = [(0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3)];

/// Value and derivatives by the first three volume coordinates.
type Function = (f64, Vector3<f64>);

/// Shape functions of four or ten nodes at volume coordinates.
fn functions(nodes: usize, l: [f64; 4]) -> Vec<Function> {
    let d = [Vector3::x(), Vector3::y(), Vector3::z(), Vector3::from_element(-1.0)];
    if nodes == 4 {
        return l.into_iter().zip(d).collect();
    }
    let corners = (0..4).map(|i| (l[i] * (2.0 * l[i] - 1.0), d[i] * (4.0 * l[i] - 1.0)));
    let middles = EDGES.map(|(i, j)| (4.0 * l[i] * l[j], 4.0 * (d[i] * l[j] + d[j] * l[i])));
    corners.chain(middles).collect()
}

impl<const D: usize> Continuum<SOLID, D> {
    /// Makes a tetrahedron of four nodes with one point of integration, or of ten nodes with four (Zienkiewicz and Taylor,
    /// 2000, section 8.11), with consistent mass. Nodes 5 to 10 are the middles of the edges 1-2, 2-3, 1-3, 1-4, 3-4 and 2-4.
    /// Seen from node 4, the nodes 1, 2 and 3 go against the clock. `force` is the force per volume along the axes;
    /// `weight` is a factor of the volume.
    ///
    /// # Errors
    /// The nodes do not make a tetrahedron.
    pub fn tetrahedron(
        nodes: &[Vector3<f64>],
        law: &SharedMultiaxial<SOLID>,
        (force, weight): ([f64; 3], f64),
    ) -> ElementResult<Self> {
        let quadratic = nodes.len() > 4;
        // Points of degree 1 and 2 (Hammer, Marlowe and Stroud, 1956).
        let (far, near) = (0.25 + 0.15 * 5.0f64.sqrt(), 0.25 - 0.05 * 5.0f64.sqrt());
        let points: Vec<[f64; 4]> = if quadratic {
            (0..4).map(|i| std::array::from_fn(|j| if i == j { far } else { near })).collect()
        } else {
            vec![[0.25; 4]]
        };
        let rho = law.density();
        let mut mass = vec![0.0; D * D];
        let mut body = Body {
            class: if quadratic {
                Class::new("TenNodeTetrahedron", 256)
            } else {
                Class::new("FourNodeTetrahedron", 179)
            },
            points: vec![],
            stabilisation: vec![],
            load_force: [0.0; D],
            mass: Mass::None,
            size: least_distance(&nodes.iter().map(|x| [x.x, x.y, x.z]).collect::<Vec<_>>()),
            extrapolation: vec![],
        };
        for at in &points {
            let functions = functions(nodes.len(), *at);
            let jacobian: Matrix3<f64> = functions.iter().zip(nodes).map(|((_, d), x)| d * x.transpose()).sum();
            let volume = -weight * jacobian.determinant() / (6.0 * points.len() as f64);
            let Some(inverse) = jacobian.try_inverse() else {
                return Err(ElementError("the nodes do not make a tetrahedron".into()));
            };
            let gradients: Vec<Vector3<f64>> = functions.iter().map(|(_, d)| inverse * d).collect();
            let rows: Rows<SOLID, D> = strain_rows(&gradients);
            for i in 0..D {
                let n = functions[i / 3].0;
                body.load_force[i] -= volume * n * force[i % 3];
                for j in (i % 3..D).step_by(3) {
                    mass[i * D + j] += volume * rho * n * functions[j / 3].0;
                }
            }
            body.points.push((rows, volume));
        }
        if rho != 0.0 {
            body.mass = Mass::Consistent(mass);
        }
        Ok(Self::of(body, law))
    }
}
