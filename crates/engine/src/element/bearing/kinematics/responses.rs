//! Common responses of OpenSees' multiple spring bearings in space.

use crate::element::Snapshot;
use crate::element::bearing::kinematics::link::Link;
use crate::probe::Probe;

/// Responses with OpenSees' column names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::element::bearing) enum Response {
    /// End forces in local axes.
    LocalForce,
    /// Forces of the basic system.
    BasicForce,
    /// End displacements in local axes.
    LocalDisp,
    /// Deformations of the basic system.
    Deformation,
}

/// Names of the responses.
pub(in crate::element::bearing) const NAMES: &[&str] =
    &["localForce", "basicForce", "localDisplacement", "deformation", "basicDeformation", "basicDisplacement"];

const LOCAL_FORCES: [&str; 12] =
    ["N_ 1", "Vy_1", "Vz_1", "T_1", "My_1", "Tz_1", "N_2", "Py_2", "Pz_2", "T_2", "My_2", "Mz_2"];

impl Response {
    const ALL: [Self; 4] = [Self::LocalForce, Self::BasicForce, Self::LocalDisp, Self::Deformation];

    /// The response for the arguments of a recorder.
    pub(in crate::element::bearing) fn probe(words: &[&str]) -> Option<Probe> {
        let numbered = |stem: &str| (1..=6).map(|i| format!("{stem}{i}")).collect::<Vec<_>>();
        let (which, labels) = match *words.first()? {
            "localForce" | "localForces" => (Self::LocalForce, LOCAL_FORCES.map(str::to_owned).to_vec()),
            "basicForce" | "basicForces" => (Self::BasicForce, numbered("qb")),
            "localDisplacement" | "localDisplacements" => {
                let names = ["ux", "uy", "uz", "rx", "ry", "rz"];
                let ends = (1..=2).flat_map(|e| names.iter().map(move |n| format!("{n}_{e}")));
                (Self::LocalDisp, ends.collect())
            }
            "deformation" | "deformations" | "basicDeformation" | "basicDeformations" | "basicDisplacement"
            | "basicDisplacements" => (Self::Deformation, numbered("ub")),
            _ => return None,
        };
        Some(Probe::new(which as u32, labels))
    }

    /// The response of a path.
    pub(in crate::element::bearing) fn of(path: &[u32]) -> Self {
        Self::ALL.into_iter().find(|r| path.first() == Some(&(*r as u32))).unwrap_or(Self::LocalForce)
    }

    /// Writes its value; `basic_force` computes basic forces.
    pub(in crate::element::bearing) fn read(
        self,
        link: &Link<12, 6>,
        s: &Snapshot<'_>,
        out: &mut [f64],
        basic_force: impl FnOnce(&mut [f64]),
    ) {
        match self {
            Self::LocalForce => link.local_force(s.force, out),
            Self::BasicForce => basic_force(out),
            Self::LocalDisp => link.local_force(s.disp, out),
            Self::Deformation => out.copy_from_slice(&link.deformation(s.disp)),
        }
    }
}
