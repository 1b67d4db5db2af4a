//! Slow variables of the past, and forces of it, by family. They are of the order of one.

use super::data::{Data, DeviceRun};
use super::family::Family;
use super::operators::{leaky, low_pass, rest, running_maximum, speed, stop_work};

/// A slow variable in all runs.
pub(super) struct SlowVariable {
    /// What it remembers.
    pub(super) family: Family,
    /// Its formula in words.
    pub(super) name: String,
    /// Its series by run.
    pub(super) runs: Vec<Vec<f64>>,
    /// The same at the samples.
    pub(super) at_samples: Vec<f64>,
}

/// Builder of one family's variables.
struct Builder<'a> {
    data: &'a Data,
    family: Family,
    out: Vec<SlowVariable>,
}

impl Builder<'_> {
    fn add(&mut self, name: impl Into<String>, of_run: impl Fn(&DeviceRun) -> Vec<f64>) {
        let runs: Vec<Vec<f64>> = self.data.runs.iter().map(of_run).collect();
        // Values beyond those of the fitted runs say nothing.
        let of_fitted = |i: &usize| self.data.fitted[*i];
        let fitted: Vec<f64> = {
            let all = self.data.sampled(&runs);
            (0..all.len()).filter(of_fitted).map(|i| all[i]).collect()
        };
        let low = fitted.iter().copied().fold(f64::INFINITY, f64::min);
        let high = fitted.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if low.is_finite() && high > low {
            let runs: Vec<Vec<f64>> =
                runs.into_iter().map(|r| r.into_iter().map(|x| x.clamp(low, high)).collect()).collect();
            let at_samples = self.data.sampled(&runs);
            self.out.push(SlowVariable { family: self.family, name: name.into(), runs, at_samples });
        }
    }
}

/// Largest absolute deformation so far, over that of all fitted runs; not less than a thousandth.
fn largest(run: &DeviceRun, scale: f64) -> Vec<f64> {
    running_maximum(run.deformation.iter().map(|u| u.abs() / scale)).into_iter().map(|m| m.max(1e-3)).collect()
}

/// Factors of a family. `level` is the slip level of the law.
pub(super) fn factors(data: &Data, family: Family, condition: Option<usize>, level: f64) -> Vec<SlowVariable> {
    let mut b = Builder { data, family, out: vec![] };
    let (u_max, s) = (data.scales.deformation, &data.scales);
    match family {
        Family::Shape => {
            b.add("|u|", |r| r.deformation.iter().map(|u| u.abs() / u_max).collect());
            b.add("u^2", |r| r.deformation.iter().map(|u| (u / u_max).powi(2)).collect());
        }
        Family::Clock => {
            let since = |r: &DeviceRun| -> Vec<f64> { r.times.iter().map(|t| (t - r.times[0]) / s.duration).collect() };
            b.add("t", since);
            for e in [0.1, 0.3] {
                b.add(format!("1-exp(-t/{e}T)"), |r| since(r).iter().map(|t| 1.0 - (-t / e).exp()).collect());
            }
            for c in [0.25, 0.5, 0.75] {
                b.add(format!("after {c}T"), |r| {
                    since(r).iter().map(|t| 1.0 / (1.0 + ((c - t) / 0.05).exp())).collect()
                });
            }
        }
        Family::Work | Family::Heat => work_factors(&mut b, level),
        Family::Largest => largest_factors(&mut b),
        Family::Pinching => {
            for e in [0.15, 0.35] {
                b.add(format!("exp(-(u/{e}m)^2)"), |r| {
                    let m = largest(r, u_max);
                    let x = r.deformation.iter().zip(&m).map(|(u, m)| u / u_max / (e * m));
                    x.map(|x| (-x * x).exp()).collect()
                });
            }
        }
        Family::Rate => {
            let scaled = |v: f64, e: f64| (v / e).ln_1p() / (1.0 / e).ln_1p();
            let rate =
                |r: &DeviceRun| speed(&r.deformation, &r.times).iter().map(|v| v.abs() / s.speed).collect::<Vec<_>>();
            for e in [0.003, 0.03, 0.3] {
                b.add(format!("ln(1+v/{e}V)"), |r| rate(r).iter().map(|v| scaled(*v, e)).collect());
            }
            for constant in &s.constants[2..5] {
                b.add(format!("ln(1+v/0.03V) over {constant:.3}"), |r| {
                    low_pass(&rate(r), &r.times, *constant, 0.0).iter().map(|v| scaled(*v, 0.03)).collect()
                });
            }
        }
        Family::Rest => {
            for length in [0.03, 0.15, 0.6] {
                b.add(format!("ln(1+rest), slip {length}U"), |r| {
                    let slip: Vec<f64> = stop_work(&r.deformation, level).iter().map(|w| w / level).collect();
                    let aged = rest(&slip, &r.times, length * u_max, 0.01 * s.duration);
                    aged.into_iter().map(|x| 0.25 * x).collect()
                });
            }
        }
        Family::Side => b.add("u", |r| r.deformation.iter().map(|u| u / u_max).collect()),
        Family::Set => {}
        Family::Temperature | Family::AxialForce | Family::Channel => condition_factors(&mut b, condition),
    }
    b.out
}

fn work_factors(b: &mut Builder<'_>, level: f64) {
    let s = &b.data.scales;
    let work = |r: &DeviceRun| stop_work(&r.deformation, level);
    let of_fitted = b.data.runs.iter().filter(|r| !r.held_out);
    let most = of_fitted.filter_map(|r| work(r).last().copied()).fold(f64::MIN_POSITIVE, f64::max);
    let relative = move |r: &DeviceRun| work(r).iter().map(|w| w / most).collect::<Vec<f64>>();
    if b.family == Family::Work {
        b.add("D", relative);
        for e in [0.1, 0.3] {
            b.add(format!("1-exp(-D/{e})"), |r| relative(r).iter().map(|d| 1.0 - (-d / e).exp()).collect());
        }
        return;
    }
    for constant in &s.constants[2..] {
        let recent = |r: &DeviceRun| leaky(&relative(r), &r.times, *constant);
        b.add(format!("recent work, {constant:.3}"), recent);
        b.add(format!("1/(1+4 recent work), {constant:.3}"), |r| {
            recent(r).iter().map(|w| 1.0 / (1.0 + 4.0 * w * s.duration / constant)).collect()
        });
    }
}

fn largest_factors(b: &mut Builder<'_>) {
    let u_max = b.data.scales.deformation;
    let of_side = |r: &DeviceRun| -> Vec<f64> {
        let up = running_maximum(r.deformation.iter().map(|u| u.max(0.0)));
        let down = running_maximum(r.deformation.iter().map(|u| (-u).max(0.0)));
        let sides = r.deformation.iter().zip(up.iter().zip(&down));
        sides.map(|(u, (up, down))| if *u > 0.0 { up / u_max } else { down / u_max }).collect()
    };
    b.add("m", |r| largest(r, u_max));
    b.add("m of the side", of_side);
    for e in [0.15, 0.4] {
        b.add(format!("exp(-m/{e}U)"), |r| largest(r, u_max).iter().map(|m| (-m / e).exp()).collect());
        b.add(format!("exp(-m/{e}U) of the side"), |r| of_side(r).iter().map(|m| (-m / e).exp()).collect());
    }
    for power in [2, 4] {
        b.add(format!("(u/m)^{power}"), |r| {
            r.deformation.iter().zip(largest(r, u_max)).map(|(u, m)| (u.abs() / u_max / m).powi(power)).collect()
        });
    }
}

fn condition_factors(b: &mut Builder<'_>, condition: Option<usize>) {
    let Some(i) = condition else { return };
    let s = &b.data.scales;
    let (mean, deviation) = s.conditions[i];
    let scaled = |r: &DeviceRun| {
        let values = r.conditions[i].values.iter();
        values.map(|x| if x.is_finite() { (x - mean) / (3.0 * deviation) } else { 0.0 }).collect::<Vec<f64>>()
    };
    b.add("x", scaled);
    b.add("x^2", |r| scaled(r).iter().map(|x| x * x).collect());
    if b.data.has_clock {
        for constant in &s.constants[..4] {
            b.add(format!("x late by {constant:.3}"), |r| {
                let x = scaled(r);
                low_pass(&x, &r.times, *constant, x.first().copied().unwrap_or(0.0))
            });
        }
    }
}

/// Forces of a family beside those of springs and dashpots. A force of the clock alone is a matter of a sensor.
pub(super) fn forces(data: &Data, family: Family, condition: Option<usize>) -> Vec<SlowVariable> {
    let mut b = Builder { data, family, out: vec![] };
    let (u_max, s) = (data.scales.deformation, &data.scales);
    match family {
        Family::Set => {
            let middle = |r: &DeviceRun| -> Vec<f64> {
                let up = running_maximum(r.deformation.iter().map(|u| u.max(0.0)));
                let down = running_maximum(r.deformation.iter().map(|u| (-u).max(0.0)));
                up.iter().zip(&down).map(|(up, down)| 0.5 * (up - down) / u_max).collect()
            };
            b.add("middle of the extremes", middle);
            if data.has_clock {
                for constant in &s.constants[2..] {
                    b.add(format!("middle of the extremes, late by {constant:.3}"), |r| {
                        low_pass(&middle(r), &r.times, *constant, 0.0)
                    });
                    b.add(format!("u over {constant:.3}"), |r| {
                        let scaled: Vec<f64> = r.deformation.iter().map(|u| u / u_max).collect();
                        low_pass(&scaled, &r.times, *constant, 0.0)
                    });
                }
            }
        }
        Family::Temperature | Family::AxialForce | Family::Channel => {
            if let Some(i) = condition {
                let (mean, deviation) = s.conditions[i];
                b.add("force by x", |r| {
                    r.conditions[i].values.iter().map(|x| (x - mean) / (3.0 * deviation)).collect()
                });
            }
        }
        _ => {}
    }
    b.out
}
