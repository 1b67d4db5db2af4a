//! Local axes of two-node elements.

use nalgebra::{Matrix3, Vector3};

/// Sine of the angle below which two vectors are taken as parallel.
const MIN_SINE: f64 = 1e-12;

/// Error of a construction of axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxesError {
    /// The local x axis has no length.
    NoLength,
    /// The vectors that span the local x-y plane are parallel.
    Parallel,
}

impl AxesError {
    /// Text of the error for messages.
    pub fn message(self) -> &'static str {
        match self {
            Self::NoLength => "the local x axis has no length",
            Self::Parallel => "the two vectors that span the local axes are parallel",
        }
    }
}

/// Rotation from global to local axes; its rows are the local x, y and z axes. The vector `x` is along the local x
/// axis, `y` lies in the local x-y plane.
///
/// # Errors
/// `x` has no length, or `y` is parallel to it.
pub fn from_x_and_y(x: Vector3<f64>, y: Vector3<f64>) -> Result<Matrix3<f64>, AxesError> {
    if x.norm() == 0.0 {
        return Err(AxesError::NoLength);
    }
    let z = x.cross(&y);
    if z.norm() <= MIN_SINE * x.norm() * y.norm() {
        return Err(AxesError::Parallel);
    }
    let y = z.cross(&x);
    Ok(Matrix3::from_rows(&[x.normalize().transpose(), y.normalize().transpose(), z.normalize().transpose()]))
}

/// Rotation from global to local axes for a vector `xz` in the local x-z plane, the convention of `geomTransf`.
///
/// # Errors
/// `x` has no length, or `xz` is parallel to it.
pub fn from_x_and_xz(x: Vector3<f64>, xz: Vector3<f64>) -> Result<Matrix3<f64>, AxesError> {
    if x.norm() == 0.0 {
        return Err(AxesError::NoLength);
    }
    let y = xz.cross(&x);
    if y.norm() <= MIN_SINE * x.norm() * xz.norm() {
        return Err(AxesError::Parallel);
    }
    let z = x.cross(&y);
    Ok(Matrix3::from_rows(&[x.normalize().transpose(), y.normalize().transpose(), z.normalize().transpose()]))
}

/// Axes of the option `-orient`: `x` and `y`, `y` alone, or neither.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Orientation {
    /// Local x axis.
    pub x: Option<Vector3<f64>>,
    /// A vector in the local x-y plane.
    pub y: Option<Vector3<f64>>,
}

impl Orientation {
    /// Rotation to local axes and length of a link from `i` to `j` (global coordinates), by the convention of OpenSees'
    /// bearings and links. The local x axis is `x`, by default the line between the nodes. Without `y`, the local y
    /// axis of a `plane` model is normal to x. In space it is then in the plane of x and the global Y.
    ///
    /// # Errors
    /// No x axis, or `y` parallel to it.
    pub fn of_link(&self, i: Vector3<f64>, j: Vector3<f64>, plane: bool) -> Result<(Matrix3<f64>, f64), AxesError> {
        let line = j - i;
        let length = if line.norm() > f64::EPSILON { line.norm() } else { 0.0 };
        let x = match self.x {
            Some(x) => x,
            None if length > 0.0 => line,
            None => return Err(AxesError::NoLength),
        };
        let y = match self.y {
            None if plane => Vector3::new(-x.y, x.x, 0.0),
            y => y.unwrap_or_else(Vector3::y),
        };
        Ok((from_x_and_y(x, y)?, length))
    }
}
