//! Round layered rubber bearings: stiffnesses and strengths from material and geometry.

/// π as in OpenSees' layered bearings. It is kept because scripts compare results to the last digit; rubber properties
/// are less accurate.
#[allow(clippy::approx_constant)]
pub const PI: f64 = 3.14159;

/// Properties of a round bearing; annular with a hole or a lead core.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layers {
    /// Shear modulus of the rubber G.
    pub g: f64,
    /// Bulk modulus of the rubber K.
    pub bulk: f64,
    /// Inner diameter D₁, 0 without a hole.
    pub inner: f64,
    /// Outer diameter D₂ of the shims.
    pub outer: f64,
    /// Thickness of a shim t_s.
    pub shim: f64,
    /// Thickness of a layer of rubber t_r.
    pub layer: f64,
    /// Number of layers n.
    pub count: f64,
    /// Cover t_c, added to the outer diameter.
    pub cover: f64,
    /// A lead plug fills the hole, so that rubber bulges only at the outside.
    pub plugged: bool,
}

/// Stiffnesses and strengths of an undeformed bearing.
///
/// Source: M. Kumar, A. Whittaker and M. Constantinou, "An advanced numerical model of elastomeric seismic isolation
/// bearings", Earthquake Engineering and Structural Dynamics 43 (2014) 1955-1974.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rubber {
    /// Bonded area A.
    pub area: f64,
    /// Radius of gyration r of the area.
    pub gyration: f64,
    /// Outer diameter D₂, for the overlap of the ends.
    pub diameter: f64,
    /// Total thickness T_r of rubber.
    pub thickness: f64,
    /// Total height h of rubber and shims.
    pub height: f64,
    /// Axial stiffness K_v0 = A E_c / T_r.
    pub axial: f64,
    /// Shear stiffness of the rubber G A / T_r.
    pub shear: f64,
    /// Torsional stiffness 2 G I_s / h.
    pub torsion: f64,
    /// Rotational stiffness E_r I_s / h.
    pub rotation: f64,
    /// Critical load in compression P_cr = √(P_E G A_s), positive.
    pub critical: f64,
    /// Cavitation force F_c = 3 G A.
    pub cavitation: f64,
}

impl Layers {
    /// Shape factor S of a layer: loaded area over the area free to bulge.
    pub fn shape_factor(&self) -> f64 {
        let (d1, d2) = (self.inner, self.outer);
        if self.plugged { (d2 * d2 - d1 * d1) / (4.0 * d2 * self.layer) } else { (d2 - d1) / (4.0 * self.layer) }
    }

    /// Factor of the compression modulus for a hole; 1 without one (Constantinou, Kartoum and Kelly, 1992).
    fn hole_factor(&self) -> f64 {
        if self.inner < f64::EPSILON {
            return 1.0;
        }
        let r = self.outer / self.inner;
        (r * r + 1.0) / ((r - 1.0) * (r - 1.0)) + (1.0 + r) / ((1.0 - r) * r.ln())
    }

    /// Compression modulus E_c of the bearing.
    pub fn compression_modulus(&self) -> f64 {
        let s = self.shape_factor();
        1.0 / (1.0 / (6.0 * self.g * s * s * self.hole_factor()) + 4.0 / 3.0 / self.bulk)
    }

    /// Total thickness of the shims.
    pub fn shims(&self) -> f64 {
        (self.count - 1.0) * self.shim
    }

    /// Properties of the bearing of these layers.
    pub fn bearing(&self) -> Rubber {
        let outside = self.outer + self.cover;
        let area = PI / 4.0 * (outside * outside - self.inner * self.inner);
        let inertia = PI / 64.0 * (outside.powi(4) - self.inner.powi(4));
        let thickness = self.count * self.layer;
        let height = thickness + self.shims();
        let modulus = self.compression_modulus();
        let rotation_modulus = modulus / 3.0;
        // Shims are rigid: area and second moment are increased as if rubber had the total height.
        let (shear_area, raised) = (area * height / thickness, inertia * height / thickness);
        let euler = PI * PI * rotation_modulus * raised / (height * height);
        Rubber {
            area,
            gyration: (inertia / area).sqrt(),
            diameter: self.outer,
            thickness,
            height,
            axial: area * modulus / thickness,
            shear: self.g * area / thickness,
            torsion: self.g * 2.0 * raised / height,
            rotation: rotation_modulus * raised / height,
            critical: (euler * self.g * shear_area).sqrt(),
            cavitation: 3.0 * self.g * area,
        }
    }
}
