//! Shear failure by the rotation of a plastic hinge (Leborgne, 2012; Leborgne and Ghannoum, 2014), kip, in. and ksi.

use super::ColumnResponse;

/// Rotation at which a column fails in shear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RotationLimit {
    /// Regression of the rotation of the hinge.
    Hinge,
    /// ASCE 41's total rotation of the column.
    Total,
    /// 45 % of the total rotation.
    Flexural,
    /// ASCE 41's plastic rotation.
    Plastic,
    /// 45 % of the plastic rotation.
    FlexuralPlastic,
}

/// Column section and reinforcement of the regressions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Kind of rotation.
    pub limit: RotationLimit,
    /// Width, effective depth and depth.
    pub size: [f64; 3],
    /// Length.
    pub length: f64,
    /// Spacing of the hoops.
    pub spacing: f64,
    /// Area of the longitudinal bars.
    pub steel: f64,
    /// Area of the core.
    pub core: f64,
    /// Development length of the longitudinal bars.
    pub development: f64,
    /// Diameter of the longitudinal bars.
    pub bar: f64,
    /// Ratio of hoops.
    pub hoops: f64,
    /// Strength of the concrete.
    pub fc: f64,
    /// Yield stress of the longitudinal bars.
    pub fy: f64,
    /// Yield stress of the hoops.
    pub fyt: f64,
    /// Shift of the rotation.
    pub shift: f64,
}

/// Failure by rotation or by shear force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotationShear {
    /// Shear force at failure; 0 for ASCE 41's shear strength, negative without.
    pub strength: f64,
    /// Rotation at failure, of a column without data.
    pub rotation: f64,
    /// Data of the column.
    pub column: Option<Column>,
}

impl Column {
    /// Rotation at failure, and the least rotation at which it counts.
    fn rotation(&self, shear: f64, axial: f64) -> [f64; 2] {
        let [b, d, h] = self.size;
        let (load, spacing) = (axial / (b * h * self.fc), self.spacing / d);
        let stress = shear / (b * d) / ((self.fc * 1000.0).sqrt() / 1000.0);
        let total = 0.044 - 0.017 * spacing - 0.021 * load - 0.002 * stress;
        let plastic = 0.032 - 0.014 * spacing - 0.017 * load - 0.0016 * stress;
        let [rotation, least] = match self.limit {
            RotationLimit::Hinge => [0.026515 - 0.033432 * load - 0.009963 * spacing, 0.006],
            RotationLimit::Total => [total, 0.009],
            RotationLimit::Flexural => [0.45 * total, 0.00405],
            RotationLimit::Plastic => [plastic, 0.0],
            RotationLimit::FlexuralPlastic => [0.45 * plastic, 0.0],
        };
        [rotation + self.shift, least]
    }

    /// Shear strength of ASCE 41.
    fn strength(&self, shear: f64, axial: f64, moment: f64) -> f64 {
        let [b, d, h] = self.size;
        let (gross, root) = (b * h, 6.0 * (self.fc * 1000.0).sqrt());
        let ratio = moment / (shear * d);
        let concrete = 0.8 * gross * (root / ratio * (1.0 + axial * 1000.0 / (root * gross)).sqrt()) / 1000.0;
        concrete + self.hoops * self.spacing * b * self.fyt * d / self.spacing
    }
}

impl RotationShear {
    pub(super) fn is_reached(&self, shear: f64, seen: &ColumnResponse) -> bool {
        let (axial, moment) = (seen.force[0].abs(), seen.force[2].abs());
        let strong = match (&self.column, self.strength) {
            (Some(column), 0.0) => shear >= column.strength(shear, axial, moment),
            (_, strength) => strength > 0.0 && shear >= strength,
        };
        let turned = match &self.column {
            Some(column) => {
                let [limit, least] = column.rotation(shear, axial);
                seen.deformation >= limit && seen.deformation >= least
            }
            None => seen.deformation >= self.rotation,
        };
        strong || turned
    }

    /// Slope and residual force after failure at a shear force.
    pub(super) fn failure(&self, shear: f64, slope: f64, residual: f64) -> [f64; 2] {
        let left = match (residual, &self.column) {
            (-1.0, Some(c)) => shear * (0.362283 - 0.170283 * (c.spacing / c.size[1])).max(0.0),
            (-1.0, None) => 0.2 * shear,
            (r, _) if r < 0.0 => (shear * r).abs(),
            (r, _) => r,
        };
        let falling = match (slope, &self.column) {
            (0.0, Some(c)) => {
                let gross = c.size[0] * c.size[2];
                let drift = -0.158370 - 15.437656 * c.hoops - 0.009391 * (c.development / c.bar)
                    + 0.697682 * (c.core / gross)
                    + 0.582667 * (c.fy * c.steel / (c.fc * gross));
                -shear / (drift.max(0.02) * c.length)
            }
            _ => slope,
        };
        [falling, left]
    }
}
