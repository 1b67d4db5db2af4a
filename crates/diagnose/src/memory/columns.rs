//! Columns of the spring and of the viscous parts of a law.

use super::data::{DeviceRun, Mode};
use super::law::{Fitter, Group, HINGES, Law, POWERS, SIDE_HINGES, WIDTHS};
use super::operators::{maxwell, speed};
use hysteron_engine::element::amendment::learned::operators;
use std::rc::Rc;

impl Fitter<'_> {
    /// A column of the deformation over its largest.
    fn of_deformation(&self, name: &str, f: &dyn Fn(f64) -> f64) -> Rc<Vec<f64>> {
        let (d, u) = (self.data, self.data.scales.deformation);
        self.cached(name, 0.0, || d.at_samples(|r| r.deformation.iter().map(|x| f(x / u)).collect()))
    }

    /// Segments of a spring of a side, or of both for 0: each is the deformation within it.
    fn segments(&self, ends: &[f64], side: f64) -> Vec<Rc<Vec<f64>>> {
        let starts = std::iter::once(0.0).chain(ends.iter().copied());
        let all = starts.zip(ends.iter().copied().chain([f64::INFINITY]));
        all.map(|(from, to)| {
            self.of_deformation(&format!("segment {side} {from}"), &|x| {
                if side * x < 0.0 { 0.0 } else { (x.abs().min(to) - from).max(0.0).copysign(x) }
            })
        })
        .collect()
    }

    /// Columns of the spring.
    pub(super) fn elastic(&self, law: &Law) -> Vec<Rc<Vec<f64>>> {
        let has = |g: Group| law.groups.contains(&g);
        if self.data.mode == Mode::Engine && law.groups.iter().any(|g| g.is_elastic()) {
            let hinges = if has(Group::Hinges) { self.segments(&HINGES, 0.0) } else { vec![] };
            let sides = [1.0, -1.0].into_iter().filter(|_| has(Group::Sides));
            return hinges.into_iter().chain(sides.flat_map(|s| self.segments(&SIDE_HINGES, s))).collect();
        }
        let hinge = |x: f64, side: f64, at: f64| side * (side * x - at).max(0.0);
        let mut out = vec![self.of_deformation("u", &|x| x)];
        for g in &law.groups {
            match g {
                Group::Hinges => out.extend(HINGES.map(|at| {
                    self.of_deformation(&format!("hinge {at}"), &|x| hinge(x, 1.0, at) + hinge(x, -1.0, at))
                })),
                Group::Sides => {
                    let all = [(1.0, 0.0), (1.0, 0.35), (-1.0, 0.35), (1.0, 0.7), (-1.0, 0.7)];
                    out.extend(
                        all.map(|(side, at)| {
                            self.of_deformation(&format!("side {side} {at}"), &|x| hinge(x, side, at))
                        }),
                    );
                }
                _ => {}
            }
        }
        out
    }

    /// Time constants of a group of Maxwell elements.
    pub(super) fn maxwell_times(&self, group: Group) -> &[f64] {
        let c = &self.data.scales.constants;
        match group {
            Group::Maxwell => &c[..6],
            Group::Creep => &c[2..],
            _ => &[],
        }
    }

    /// Columns of the viscous parts.
    pub(super) fn viscous(&self, group: Group) -> Vec<Rc<Vec<f64>>> {
        let (d, s) = (self.data, &self.data.scales);
        let of_speed = |name: String, f: &dyn Fn(f64) -> f64| {
            self.cached(&name, 0.0, || {
                d.at_samples(|r| speed(&r.deformation, &r.times).iter().map(|v| f(v / s.speed)).collect())
            })
        };
        match group {
            Group::Maxwell | Group::Creep => {
                let of = |t: &f64| {
                    let of_run = |r: &DeviceRun| {
                        maxwell(&r.deformation, &r.times, *t).into_iter().map(|h| h / s.deformation).collect()
                    };
                    self.cached("maxwell", *t, || d.at_samples(of_run))
                };
                self.maxwell_times(group).iter().map(of).collect()
            }
            Group::Dashpots => {
                POWERS.map(|p| of_speed(format!("dashpot {p}"), &|v| operators::dashpot(v, p).0)).to_vec()
            }
            Group::Viscous => {
                WIDTHS.map(|e| of_speed(format!("viscous {e}"), &|v| operators::smoothed_friction(v, e).0)).to_vec()
            }
            _ => vec![],
        }
    }
}
