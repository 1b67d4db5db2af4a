//! Constitutive laws of bearings: shear, axial force, springs of a section, heating of a lead core.

pub(in crate::element::bearing) mod axial;
pub(in crate::element::bearing) mod bouc_wen;
pub(in crate::element::bearing) mod grant;
pub(in crate::element::bearing) mod lead;
pub(in crate::element::bearing) mod normal_layout;
pub(in crate::element::bearing) mod normal_springs;
pub(in crate::element::bearing) mod plasticity;
pub(in crate::element::bearing) mod rheology;
pub(in crate::element::bearing) mod rubber;
pub(in crate::element::bearing) mod rubber_bouc_wen;
pub(in crate::element::bearing) mod rubber_shear;
pub(in crate::element::bearing) mod shear;
pub(in crate::element::bearing) mod shear_springs;
pub(in crate::element::bearing) mod ufrp;
pub(in crate::element::bearing) mod yamamoto;
