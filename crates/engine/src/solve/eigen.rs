//! Eigenvalues of K x = λ M x nearest to a shift, by block Lanczos with full reorthogonalisation (Grimes, Lewis and
//! Simon, 1994) on the operator (K - σM)⁻¹ M in the inner product of M, which may be singular. Where K is not symmetric (a
//! slider whose friction follows the axial force) it is block Arnoldi, with the same vectors (Saad, 2011).

use crate::numeric::dot;
use faer::Mat;
use nalgebra::{Complex, DMatrix, DVector, SymmetricEigen};

/// The two matrices as operators.
pub trait Pencil {
    /// Number of equations.
    fn len(&self) -> usize;
    /// Returns true if there are no equations.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// x = (K - σM)⁻¹ x, for one or more vectors that follow each other.
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

/// There is an entry that is not finite, or the iterations for the eigenvalues did not end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotFound;

/// Part of the largest entry by which a matrix that is symmetric but for round-off differs from its transpose.
const SKEW: f64 = 1e-9;

/// A basis of more vectors is a long one.
const LONG: usize = 120;

/// The values are looked at again when the basis has grown by one of these parts: each look costs its size cubed.
const PARTS_OF_BASIS: usize = 6;

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
///
/// # Errors
/// See [`NotFound`].
pub fn nearest(pencil: &mut impl Pencil, count: usize) -> Result<Vec<Pair>, NotFound> {
    let n = pencil.len();
    let block = count.clamp(2, 6).min(n.max(1));
    let mut random = Random(20_261);
    let mut basis = Basis { v: vec![], mv: vec![] };
    // Products of the operator with the basis.
    let mut av: Vec<Vec<f64>> = vec![];
    let mut operator = Operator::default();
    let mut last: Vec<f64> = vec![];
    // Size of the basis at which the values are looked at next.
    let mut next = 0;
    start(pencil, &mut basis, &mut random, block);
    if basis.v.is_empty() {
        return Ok(vec![]);
    }
    loop {
        // Operator times the vectors that are new.
        let known = av.len();
        let full = basis.v.len();
        let mut products = basis.mv[known..full].concat();
        pencil.solve(&mut products);
        av.extend(products.chunks_exact(n).map(<[f64]>::to_vec));
        operator.extend(&basis, &av);
        if full >= next {
            next = full + block.max(full / PARTS_OF_BASIS);
            let ritz = Ritz::of(&operator)?;
            let wanted = &ritz.theta[..count.min(ritz.theta.len())];
            let settled = wanted.len() == last.len()
                && wanted.len() == count
                && wanted.iter().zip(&last).all(|(a, b)| (a - b).abs() <= ritz.tolerance() * a.abs());
            last = wanted.to_vec();
            if settled {
                return Ok(pairs(pencil, &basis, &ritz.complete()?, count));
            }
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
            return Ok(pairs(pencil, &basis, &Ritz::of(&operator)?.complete()?, count));
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
    let mut all = vec![0.0; n * count];
    for mw in all.chunks_exact_mut(n) {
        let w: Vec<f64> = (0..n).map(|_| random.next()).collect();
        pencil.mass(&w, mw);
    }
    pencil.solve(&mut all);
    for w in all.chunks_exact(n) {
        let scale = length(pencil, w);
        basis.add(pencil, w.to_vec(), scale);
    }
}

/// The operator in a basis that grows, by columns.
#[derive(Default)]
struct Operator {
    columns: Vec<Vec<f64>>,
}

impl Operator {
    /// Adds the rows and columns of the vectors that are new; `av` are products of the operator with the basis.
    fn extend(&mut self, basis: &Basis, av: &[Vec<f64>]) {
        self.columns.resize(av.len(), vec![]);
        for (column, av) in self.columns.iter_mut().zip(av) {
            let known = column.len();
            column.extend(basis.mv[known..].iter().map(|mv| dot(mv, av)));
        }
    }
}

/// Eigenvalues and vectors of the operator in a basis.
struct Ritz {
    /// Eigenvalues θ, the largest by size first. Of a complex pair |θ|²/Re θ, so that 1/θ is the real part of λ, as OpenSees
    /// gives it.
    theta: Vec<f64>,
    /// Their vectors; not yet where the operator is not symmetric.
    vectors: Vec<DVector<f64>>,
    /// The operator, where it is not symmetric.
    unsymmetric: Option<Mat<f64>>,
}

/// |θ|²/Re θ.
fn of_pair(theta: Complex<f64>) -> f64 {
    if theta.re == 0.0 { 0.0 } else { theta.norm_sqr() / theta.re }
}

impl Ritz {
    fn of(operator: &Operator) -> Result<Self, NotFound> {
        let m = operator.columns.len();
        let t = DMatrix::from_fn(m, m, |i, j| operator.columns[j][i]);
        if t.iter().any(|x| !x.is_finite()) {
            return Err(NotFound);
        }
        if (&t - t.transpose()).amax() > SKEW * t.amax() {
            let t = Mat::from_fn(m, m, |i, j| t[(i, j)]);
            let mut values = t.eigenvalues().map_err(|_| NotFound)?;
            values.sort_by(|a, b| b.norm_sqr().total_cmp(&a.norm_sqr()));
            let theta = values.into_iter().map(of_pair).collect();
            return Ok(Self { theta, vectors: vec![], unsymmetric: Some(t) });
        }
        let t = DMatrix::from_fn(m, m, |i, j| 0.5 * (t[(i, j)] + t[(j, i)]));
        let eigen = SymmetricEigen::new(t);
        let mut order: Vec<usize> = (0..m).collect();
        order.sort_by(|&a, &b| eigen.eigenvalues[b].abs().total_cmp(&eigen.eigenvalues[a].abs()));
        let theta = order.iter().map(|&i| eigen.eigenvalues[i]).collect();
        let vectors = order.iter().map(|&i| eigen.eigenvectors.column(i).into_owned()).collect();
        Ok(Self { theta, vectors, unsymmetric: None })
    }

    /// With the vectors, of which a search that goes on has no need.
    fn complete(mut self) -> Result<Self, NotFound> {
        let Some(t) = self.unsymmetric.take() else { return Ok(self) };
        let eigen = t.eigen().map_err(|_| NotFound)?;
        let (values, columns) = (eigen.S().column_vector(), eigen.U());
        let mut order: Vec<usize> = (0..t.nrows()).collect();
        order.sort_by(|&a, &b| values[b].norm_sqr().total_cmp(&values[a].norm_sqr()));
        self.theta = order.iter().map(|&i| of_pair(values[i])).collect();
        let real = |i: usize| DVector::from_fn(t.nrows(), |k, _| columns[(k, i)].re);
        self.vectors = order.into_iter().map(real).collect();
        Ok(self)
    }

    /// Part by which values that are settled may still differ. Without symmetry round-off moves them more, and a basis that
    /// has grown long would grow to all equations for it.
    fn tolerance(&self) -> f64 {
        match (&self.unsymmetric, self.theta.len() <= LONG) {
            (None, true) => 1e-15,
            (None, false) | (Some(_), true) => 1e-13,
            (Some(_), false) => 1e-10,
        }
    }
}

fn pairs(pencil: &mut impl Pencil, basis: &Basis, ritz: &Ritz, count: usize) -> Vec<Pair> {
    let n = pencil.len();
    let mut mw = vec![0.0; n];
    let found: Vec<usize> = (0..count.min(ritz.theta.len())).filter(|i| ritz.theta[*i] != 0.0).collect();
    let mut vectors = vec![0.0; n * found.len()];
    for (i, out) in found.iter().zip(vectors.chunks_exact_mut(n)) {
        let mut w = vec![0.0; n];
        for (v, c) in basis.v.iter().zip(ritz.vectors[*i].iter()) {
            w.iter_mut().zip(v).for_each(|(w, v)| *w += c * v);
        }
        // One more product cleans the vector of what the mass does not see.
        pencil.mass(&w, out);
    }
    pencil.solve(&mut vectors);
    let pair = |(i, w): (&usize, &[f64])| {
        pencil.mass(w, &mut mw);
        let length = dot(w, &mw).max(0.0).sqrt();
        // The largest entry is positive, so that the sign is always the same.
        let largest = w.iter().fold(0.0f64, |m, x| if x.abs() > m.abs() * (1.0 + 1e-9) { *x } else { m });
        let factor = largest.signum() / length;
        Pair { lambda: 1.0 / ritz.theta[*i], vector: w.iter().map(|x| x * factor).collect() }
    };
    let mut out: Vec<Pair> = found.iter().zip(vectors.chunks_exact(n)).map(pair).collect();
    out.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
    out
}
