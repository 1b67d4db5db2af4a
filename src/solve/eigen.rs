//! Eigenvalues of K x = λ M x nearest to a shift, by block Lanczos with full reorthogonalisation (Grimes, Lewis and
//! Simon, 1994) on the operator (K - σM)⁻¹ M in the inner product of M, which may be singular. Where K is not symmetric (a
//! slider whose friction follows the axial force) it is block Arnoldi, with the same vectors (Saad, 2011).

use crate::numeric::dot;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// The two matrices as operators.
pub trait Pencil {
    /// Number of equations.
    fn len(&self) -> usize;
    /// Whether there are no equations.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// x = (K - σM)⁻¹ x.
    fn solve(&mut self, x: &mut [f64]);
    /// y = M x.
    fn mass(&self, x: &[f64], y: &mut [f64]);
}

/// An eigenvalue and its vector, which has unit length in M.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// λ - σ.
    pub lambda: f64,
    /// Vector.
    pub vector: Vec<f64>,
}

/// Part of the largest entry by which a matrix that is symmetric but for round-off differs from its transpose.
const SKEW: f64 = 1e-9;

/// Vectors start from the same numbers every time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    }
}

/// A basis that is orthonormal in M, with the products of M and its vectors.
struct Basis {
    v: Vec<Vec<f64>>,
    mv: Vec<Vec<f64>>,
}

impl Basis {
    /// Add what is new in `w`; `false` where nothing is. `scale` is the length in M that `w` came with.
    fn add(&mut self, pencil: &impl Pencil, mut w: Vec<f64>, scale: f64) -> bool {
        for _ in 0..2 {
            for (v, mv) in self.v.iter().zip(&self.mv) {
                let c = dot(mv, &w);
                w.iter_mut().zip(v).for_each(|(w, v)| *w -= c * v);
            }
        }
        let mut mw = vec![0.0; w.len()];
        pencil.mass(&w, &mut mw);
        let length = dot(&w, &mw).max(0.0).sqrt();
        if length.is_nan() || length <= 1e-10 * scale {
            return false;
        }
        w.iter_mut().chain(&mut mw).for_each(|x| *x /= length);
        self.v.push(w);
        self.mv.push(mw);
        true
    }
}

/// The `count` pairs nearest to the shift, by rising λ; fewer where the mass has fewer.
pub fn nearest(pencil: &mut impl Pencil, count: usize) -> Vec<Pair> {
    let n = pencil.len();
    let block = count.clamp(2, 6).min(n.max(1));
    let mut random = Random(20_261);
    let mut basis = Basis { v: vec![], mv: vec![] };
    // Products of the operator with the basis.
    let mut av: Vec<Vec<f64>> = vec![];
    let mut last: Vec<f64> = vec![];
    start(pencil, &mut basis, &mut random, block);
    if basis.v.is_empty() {
        return vec![];
    }
    loop {
        // Operator times the vectors that are new.
        let known = av.len();
        let full = basis.v.len();
        for mv in &basis.mv[known..full] {
            let mut w = mv.clone();
            pencil.solve(&mut w);
            av.push(w);
        }
        let (theta, s) = ritz(&basis, &av);
        let wanted = &theta[..count.min(theta.len())];
        let settled = wanted.len() == last.len()
            && wanted.len() == count
            && wanted.iter().zip(&last).all(|(a, b)| (a - b).abs() <= 1e-15 * a.abs());
        last = wanted.to_vec();
        if settled {
            return pairs(pencil, &basis, &theta, &s, count);
        }
        for w in &av[known..full] {
            let scale = length(pencil, w);
            basis.add(pencil, w.clone(), scale);
        }
        // Vectors that the operator leads no further belong to values of which there are more than in a block.
        if basis.v.len() == full {
            start(pencil, &mut basis, &mut random, block);
        }
        if basis.v.len() == full {
            return pairs(pencil, &basis, &theta, &s, count);
        }
    }
}

/// Length in M.
fn length(pencil: &impl Pencil, w: &[f64]) -> f64 {
    let mut mw = vec![0.0; w.len()];
    pencil.mass(w, &mut mw);
    dot(w, &mw).max(0.0).sqrt()
}

/// Add vectors in the range of the operator, where the length in M is a length.
fn start(pencil: &mut impl Pencil, basis: &mut Basis, random: &mut Random, count: usize) {
    let n = pencil.len();
    for _ in 0..count {
        let w: Vec<f64> = (0..n).map(|_| random.next()).collect();
        let mut mw = vec![0.0; n];
        pencil.mass(&w, &mut mw);
        pencil.solve(&mut mw);
        let scale = length(pencil, &mw);
        basis.add(pencil, mw, scale);
    }
}

/// Eigenvalues θ of the operator in the basis, the largest by size first, and their coordinates.
fn ritz(basis: &Basis, av: &[Vec<f64>]) -> (Vec<f64>, Vec<DVector<f64>>) {
    let m = av.len();
    let t = DMatrix::from_fn(m, m, |i, j| dot(&basis.mv[i], &av[j]));
    if (&t - t.transpose()).amax() > SKEW * t.amax() {
        return unsymmetric_ritz(&t);
    }
    let t = DMatrix::from_fn(m, m, |i, j| 0.5 * (t[(i, j)] + t[(j, i)]));
    let eigen = SymmetricEigen::new(t);
    let mut order: Vec<usize> = (0..m).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].abs().total_cmp(&eigen.eigenvalues[a].abs()));
    (
        order.iter().map(|&i| eigen.eigenvalues[i]).collect(),
        order.iter().map(|&i| eigen.eigenvectors.column(i).into_owned()).collect(),
    )
}

/// Eigenvalues of a matrix that is not symmetric, the largest by size first, and their vectors. Of a complex pair 1/θ is given
/// by its real part, as OpenSees gives λ.
fn unsymmetric_ritz(t: &DMatrix<f64>) -> (Vec<f64>, Vec<DVector<f64>>) {
    let mut values: Vec<_> = t.complex_eigenvalues().iter().copied().collect();
    values.sort_by(|a, b| b.norm_sqr().total_cmp(&a.norm_sqr()));
    let mut random = Random(20_261);
    let vector = |value: f64| {
        // Inverse iteration, from next to the value: on it there is nothing to divide by.
        let shift = value + 1e-10 * t.amax();
        let lu = (t - DMatrix::identity(t.nrows(), t.nrows()) * shift).lu();
        let mut x = DVector::from_fn(t.nrows(), |_, _| random.next());
        for _ in 0..3 {
            x = lu.solve(&x).unwrap_or(x).normalize();
        }
        x
    };
    let vectors = values.iter().map(|v| v.re).map(vector).collect();
    let inverse = |v: &nalgebra::Complex<f64>| if v.re == 0.0 { 0.0 } else { v.norm_sqr() / v.re };
    (values.iter().map(inverse).collect(), vectors)
}

fn pairs(pencil: &mut impl Pencil, basis: &Basis, theta: &[f64], s: &[DVector<f64>], count: usize) -> Vec<Pair> {
    let n = pencil.len();
    let mut mw = vec![0.0; n];
    let mut out: Vec<Pair> = theta
        .iter()
        .zip(s)
        .take(count)
        .filter(|(theta, _)| **theta != 0.0)
        .map(|(theta, s)| {
            let mut w = vec![0.0; n];
            for (v, c) in basis.v.iter().zip(s.iter()) {
                w.iter_mut().zip(v).for_each(|(w, v)| *w += c * v);
            }
            // One more product cleans the vector of what the mass does not see.
            pencil.mass(&w, &mut mw);
            w.copy_from_slice(&mw);
            pencil.solve(&mut w);
            pencil.mass(&w, &mut mw);
            let length = dot(&w, &mw).max(0.0).sqrt();
            // The largest entry is positive, so that the sign is always the same.
            let largest = w.iter().fold(0.0f64, |m, x| if x.abs() > m.abs() * (1.0 + 1e-9) { *x } else { m });
            let factor = largest.signum() / length;
            w.iter_mut().for_each(|x| *x *= factor);
            Pair { lambda: 1.0 / theta, vector: w }
        })
        .collect();
    out.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
    out
}
