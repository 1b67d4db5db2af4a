//! Analyses against closed forms, and one way of solving against another.

#![allow(clippy::unwrap_used, unreachable_pub)]

#[path = "analysis/algorithms.rs"]
mod algorithms;
#[path = "analysis/amended.rs"]
mod amended;
#[path = "analysis/beam_deflection.rs"]
mod beam_deflection;
#[path = "analysis/bounds.rs"]
mod bounds;
#[path = "analysis/calls.rs"]
mod calls;
#[path = "analysis/columns.rs"]
mod columns;
#[path = "analysis/constraints.rs"]
mod constraints;
#[path = "analysis/continua.rs"]
mod continua;
#[path = "analysis/domains.rs"]
mod domains;
#[path = "analysis/dynamics.rs"]
mod dynamics;
#[path = "analysis/element_dynamics.rs"]
mod element_dynamics;
#[path = "analysis/energy.rs"]
mod energy;
#[path = "analysis/fiber_order.rs"]
mod fiber_order;
#[path = "analysis/imposed_rates.rs"]
mod imposed_rates;
#[path = "analysis/inelastic.rs"]
mod inelastic;
#[path = "analysis/late_support.rs"]
mod late_support;
#[path = "analysis/lockstep.rs"]
mod lockstep;
#[path = "analysis/lockstep_in_time.rs"]
mod lockstep_in_time;
#[path = "analysis/materials.rs"]
mod materials;
#[path = "analysis/model.rs"]
mod model;
#[path = "analysis/modes.rs"]
mod modes;
#[path = "analysis/motion_files.rs"]
mod motion_files;
#[path = "analysis/opensees.rs"]
mod opensees;
#[path = "analysis/parameter_change.rs"]
mod parameter_change;
#[path = "analysis/plateau.rs"]
mod plateau;
#[path = "analysis/refine.rs"]
mod refine;
#[path = "analysis/rubber.rs"]
mod rubber;
#[path = "support/script.rs"]
mod script;
#[path = "analysis/sections.rs"]
mod sections;
#[path = "analysis/sensitivities.rs"]
mod sensitivities;
#[path = "analysis/side_by_side.rs"]
mod side_by_side;
#[path = "analysis/statics.rs"]
mod statics;
#[path = "analysis/threads.rs"]
mod threads;
#[path = "analysis/transformed_nodes.rs"]
mod transformed_nodes;
#[path = "analysis/trapezoidal.rs"]
mod trapezoidal;
#[path = "analysis/variable.rs"]
mod variable;

/// Returns true if two numbers agree to a fraction of the larger.
#[must_use]
fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * a.abs().max(b.abs())
}
