//! A residual force in words.

use super::{ResidualForce, ResidualPart, STROKE};
use crate::verdict::quantity::digits;
use crate::verdict::summary::{MAX_WINDOWS, longest_windows, percent};

/// Excess of the share of the square over that of the time from which a quadrant is told.
const MIN_EXCESS: f64 = 0.15;
/// Share of the part along the stroke beyond that of a sign from which it is told in its place.
const STROKE_LEAD: f64 = 0.2;
/// Length of the windows over that of the run from which the force is there throughout.
const THROUGHOUT: f64 = 0.75;

impl ResidualForce {
    /// The first sentence: place, run, size and time.
    pub(super) fn where_and_when(&self) -> String {
        let listed = longest_windows(&self.windows);
        let most = if self.windows.len() > MAX_WINDOWS { ", mostly at " } else { ", at " };
        let times = &self.course.times;
        let run = times.first().zip(times.last()).map_or(0.0, |(a, b)| b - a);
        let at = match self.windows.iter().map(|w| w[1] - w[0]).sum::<f64>() {
            within if within > THROUGHOUT * run => ", throughout the run".to_owned(),
            _ if listed.is_empty() => String::new(),
            _ => format!("{most}{}", listed),
        };
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        format!(
            "The missing force is largest in {}, run {}: {}{unit} r.m.s., {} of the recorded one{at}.",
            self.place,
            self.run,
            digits(self.rms, 3),
            percent(self.ratio)
        )
    }

    /// The second sentence: the part that follows the motion, and the quadrant that has most of it.
    pub(super) fn at_what_motion(&self) -> String {
        let Some((_, direction)) = &self.course.deformation else {
            return "No device of the model shows the deformation there: record it to see what the missing force follows."
                .into();
        };
        let resists = |p: &ResidualPart| p.sense > 0.0;
        let (along_stroke, signs): (Vec<&ResidualPart>, Vec<&ResidualPart>) =
            self.parts.iter().partition(|p| p.follows == STROKE);
        let of_sign = signs.first().map_or(0.0, |p| p.share);
        let leads = along_stroke.first().filter(|p| p.share > of_sign + STROKE_LEAD);
        let part = leads.or(signs.first()).map(|p| {
            let what = match (p.follows, resists(p)) {
                (STROKE, _) => "comes again wherever the deformation does".to_owned(),
                ("speed", true) => "acts against the speed: the recorded loops are wider".to_owned(),
                ("speed", false) => "acts along the speed: the recorded loops are narrower".to_owned(),
                ("deformation", true) => "acts against the deformation: the recorded part is stiffer".to_owned(),
                ("deformation", false) => "acts along the deformation: the recorded part is softer".to_owned(),
                (_, true) => format!("acts against {direction} all the time"),
                (_, false) => format!("acts towards {direction} all the time"),
            };
            format!("{} of its square {what}", percent(p.share))
        });
        let excess = |q: &[f64; 2]| q[0] - q[1];
        let quadrants = self.quadrants.iter().flatten().enumerate();
        let most = quadrants.max_by(|a, b| excess(a.1).total_cmp(&excess(b.1))).filter(|(_, q)| excess(q) > MIN_EXCESS);
        let quadrant = most.map(|(k, [square, time])| {
            let back = direction.replacen('+', "-", 1).replacen("positive", "negative", 1);
            let motion = match k {
                0 => format!("the deformation towards {direction} grows"),
                1 => format!("the deformation towards {direction} shrinks"),
                2 => format!("the deformation towards {back} grows"),
                _ => format!("the deformation towards {back} shrinks"),
            };
            format!("{} of it lies where {motion}, {} of the time", percent(*square), percent(*time))
        });
        match (part, quadrant) {
            (Some(part), Some(quadrant)) => format!("{part}; {quadrant}."),
            (Some(part), None) => format!("{part}."),
            (None, Some(quadrant)) => format!("{}.", quadrant.replacen("of it lies", "of its square lies", 1)),
            (None, None) => "It follows the sign neither of the deformation nor of the speed there.".into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::inspect::inventory::ModelInventory;
    use crate::inspect::probe::tests::inventory_of;
    use crate::inspect::response::{ResponseHistory, ResponseRanges};
    use crate::test_support::{pad_study, white_noise};
    use crate::verdict::quantity::Units;
    use crate::verdict::residual_force::motion::Motion;
    use crate::verdict::residual_force::{FittedModelRuns, ResidualForce, residual_forces};
    use hysteron_identify::study::{ObservedChannel, Role, Score, ScoredRun, Study};

    const SAMPLES: usize = 1200;
    const DT: f64 = 0.01;

    fn times() -> Vec<f64> {
        (0..SAMPLES).map(|i| DT * i as f64).collect()
    }

    fn deformation() -> Vec<f64> {
        times().iter().map(|t| 0.05 * ((3.0 * t).sin() + 0.5 * (5.3 * t).sin())).collect()
    }

    fn speeds() -> Vec<f64> {
        times().iter().map(|t| 0.05 * (3.0 * (3.0 * t).cos() + 2.65 * (5.3 * t).cos())).collect()
    }

    /// A study of one run with some channels: name, unit, recorded samples.
    fn study(channels: &[(&str, &str, Vec<f64>)]) -> Study {
        let mut study = pad_study();
        study.runs.retain(|r| r.role == Role::Fit);
        study.runs.truncate(1);
        let run = &mut study.runs[0];
        run.recording.times = times();
        let observed = |(name, unit, values): &(&str, &str, Vec<f64>)| ObservedChannel {
            channel: (*name).into(),
            unit: (*unit).into(),
            output: "out".into(),
            column: 1,
            measure: None,
            at: String::new(),
            weight: 1.0,
            shift: 0.0,
            values: values.clone(),
            variance: 1.0,
        };
        run.observe = channels.iter().map(observed).collect();
        study
    }

    fn forces(
        study: &Study,
        inventory: &ModelInventory,
        histories: &[(i32, Vec<f64>, Vec<f64>)],
        columns: &[&str],
        simulated: Vec<Vec<f64>>,
    ) -> Vec<ResidualForce> {
        let history = |(tag, deformation, force): &(i32, Vec<f64>, Vec<f64>)| {
            let h = ResponseHistory { times: times(), deformation: deformation.clone(), force: force.clone() };
            ((0, *tag, 1), h)
        };
        let responses =
            ResponseRanges { histories: histories.iter().map(history).collect(), ..ResponseRanges::default() };
        let scores = vec![Score { nmse: 0.0, samples: SAMPLES, dropped: 0 }; simulated.len()];
        let fits = [Some(ScoredRun { channels: simulated, scores })];
        let columns = [columns.iter().map(|c| (*c).to_owned()).collect::<Vec<String>>()];
        let units = Units { length: "m".into(), force: "kN".into() };
        residual_forces(&FittedModelRuns {
            study,
            inventory,
            responses: &responses,
            fits: &fits,
            columns: &columns,
            units: &units,
        })
    }

    /// A pad between a support and a driven node; `element` connects them in either order.
    fn pad(nodes: &str) -> ModelInventory {
        inventory_of(&format!(
            "model basic -ndm 1 -ndf 1\nnode 1 0.\nnode 2 0.\nfix 1 1\nuniaxialMaterial Elastic 1 1e3\n\
             element zeroLength 7 {nodes} -mat 1 -dir 1\ntimeSeries Linear 1\npattern Plain 1 1 {{ sp 2 1 1.0 }}\n\
             constraints Transformation\nintegrator LoadControl 0.1\nanalysis Static\nanalyze 2\n"
        ))
    }

    /// The only residual force of a pad that lacks `missing`, beside noise.
    fn of_pad(missing: &[f64], nodes: &str) -> ResidualForce {
        let (u, noise) = (deformation(), white_noise(3, SAMPLES));
        let simulated: Vec<f64> = u.iter().map(|u| 1000.0 * u).collect();
        let recorded = (0..SAMPLES).map(|i| simulated[i] + missing[i] + 0.3 * noise[i]).collect();
        let study = study(&[("force", "kN", recorded)]);
        // The deformation of a device from the driven node to the support has the other sign, and so has its force.
        let sign = if nodes == "1 2" { 1.0 } else { -1.0 };
        let history = |x: &[f64]| x.iter().map(|x| sign * x).collect::<Vec<f64>>();
        let histories = [(7, history(&u), history(&simulated))];
        let mut found = forces(&study, &pad(nodes), &histories, &["element 7 force"], vec![simulated]);
        assert_eq!(found.len(), 1);
        found.remove(0)
    }

    #[test]
    fn missing_friction_acts_against_the_speed_throughout() {
        let friction: Vec<f64> = speeds().iter().map(|v| 3.0 * v.signum()).collect();
        for nodes in ["1 2", "2 1"] {
            let found = of_pad(&friction, nodes);
            let first = &found.parts[0];
            assert!((first.follows, first.sense) == ("speed", 1.0) && first.share > 0.9, "{found:?}");
            assert!((found.rms - 3.0).abs() < 0.1 && found.unit == "kN", "{}", found.rms);
            assert!(found.text[0].starts_with("The missing force is largest in element 7"), "{:?}", found.text);
            assert!(found.text[1].contains("acts against the speed: the recorded loops are wider"), "{:?}", found.text);
        }
        // A model with too much of it.
        let surplus: Vec<f64> = friction.iter().map(|f| -f).collect();
        assert!(of_pad(&surplus, "1 2").text[1].contains("narrower"));
    }

    /// A wall on one side is met while the deformation towards it grows, at certain times.
    #[test]
    fn a_wall_is_met_on_its_side_in_its_seconds() {
        let (u, t) = (deformation(), times());
        let wall: Vec<f64> =
            u.iter().zip(&t).map(|(u, t)| if *t > 6.0 { 2000.0 * (u - 0.04).max(0.0) } else { 0.0 }).collect();
        for (nodes, missing) in [("1 2", wall.clone()), ("2 1", wall.clone())] {
            let found = of_pad(&missing, nodes);
            let towards = found.quadrants.map(|q| q[0][0] + q[1][0]).unwrap_or_default();
            assert!(towards > 0.9, "{:?}", found.quadrants);
            assert!(found.text[1].contains("the deformation towards +X"), "{:?}", found.text);
            assert!(found.windows.iter().all(|w| w[0] > 5.5) && !found.windows.is_empty(), "{:?}", found.windows);
        }
        let behind: Vec<f64> = u.iter().map(|u| -2000.0 * (-u - 0.04).max(0.0)).collect();
        assert!(of_pad(&behind, "1 2").text[1].contains("the deformation towards -X"));
    }

    /// A force that waves along the stroke follows no sign, and comes again.
    #[test]
    fn a_wave_along_the_stroke_comes_again() {
        let wave: Vec<f64> = deformation().iter().map(|u| 2.0 * (u / 0.004).sin()).collect();
        let found = of_pad(&wave, "1 2");
        assert!(found.parts[0].follows == "stroke" && found.parts[0].share > 0.5, "{:?}", found.parts);
        assert!(found.text[1].contains("comes again wherever the deformation does"), "{:?}", found.text);
        assert!(found.text[0].ends_with("throughout the run."), "{:?}", found.text);
    }

    #[test]
    fn noise_follows_nothing() {
        for seed in 4..12 {
            let found = of_pad(&white_noise(seed, SAMPLES), "1 2");
            assert!(found.parts.is_empty(), "{:?}", found.parts);
            assert!(found.text[1].starts_with("It follows the sign neither"), "{:?}", found.text);
        }
    }

    #[test]
    fn a_device_at_rest_has_no_signs() {
        let motion = Motion::of(&times(), &vec![0.0; SAMPLES]);
        let force = white_noise(1, SAMPLES);
        assert!(motion.parts(&force).is_empty());
        assert_eq!(motion.quadrants(&force), [[0.0; 2]; 4]);
    }

    /// Two storeys in a chain without heights: each resists the inertia of what it carries.
    #[test]
    fn a_storey_resists_the_inertia_of_the_masses_above_it() {
        let inventory = inventory_of(
            "model basic -ndm 1 -ndf 1\nforeach n {1 2 3} {node $n 0.}\nfix 1 1\nmass 2 5.\nmass 3 2.\n\
             uniaxialMaterial Elastic 1 1e3\nelement zeroLength 7 1 2 -mat 1 -dir 1\nelement zeroLength 8 2 3 -mat 1 -dir 1\n\
             timeSeries Constant 2\npattern UniformExcitation 2 1 -accel 2\nconstraints Plain\nsystem FullGeneral\n\
             integrator Newmark 0.5 0.25\nanalysis Transient\nanalyze 2 0.01\n",
        );
        // The upper storey lacks friction against its own speed.
        let friction: Vec<f64> = speeds().iter().map(|v| 4.0 * v.signum()).collect();
        let (zero, u) = (vec![0.0; SAMPLES], deformation());
        let wave: Vec<f64> = times().iter().map(|t| 3.0 * (7.0 * t).sin()).collect();
        let lower: Vec<f64> = wave.iter().zip(&friction).map(|(w, f)| w + f / 5.0).collect();
        let upper: Vec<f64> = wave.iter().zip(&friction).map(|(w, f)| w - f / 2.0).collect();
        let study = study(&[("low", "m/s2", lower), ("high", "m/s2", upper)]);
        let histories = [(7, u.clone(), zero.clone()), (8, u, zero)];
        let columns = ["node 2 dof 1", "node 3 dof 1"];
        let found = forces(&study, &inventory, &histories, &columns, vec![wave.clone(), wave]);
        let of = |tag: &str| found.iter().find(|f| f.place == tag).expect(tag);
        let (base, top) = (of("element 7 (at the base)"), of("element 8"));
        assert!(base.rms < 1e-9 && (top.rms - 4.0).abs() < 1e-2, "{} {}", base.rms, top.rms);
        assert_eq!((found[0].place.as_str(), top.unit.as_str()), ("element 8", "kN"));
        assert_eq!((top.parts[0].follows, top.parts[0].sense), ("speed", 1.0));
        assert_eq!((base.channels.len(), top.channels.len()), (2, 1));
        // A mass that no channel shows is told, and a displacement shows no force.
        let one = self::study(&[("low", "m/s2", white_noise(1, SAMPLES)), ("drift", "m", white_noise(2, SAMPLES))]);
        let zero = vec![0.0; SAMPLES];
        let found = forces(&one, &inventory, &[], &["node 2 dof 1", "node 3 dof 1"], vec![zero.clone(), zero]);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].place, "element 7 (at the base), less the inertia of a mass that no channel shows");
        assert!(found[0].text[1].contains("record it"), "{:?}", found[0].text);
    }
}
