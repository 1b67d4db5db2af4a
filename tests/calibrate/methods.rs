//! Tests of the search methods on functions with a known minimum.

use hysteron::calibrate::{
    Checkpoint, Evaluation, NoObserver, Problem, SearchMethod, SearchObserver, SearchSettings, SearchStatus, Trial,
    search,
};
use hysteron::study::SimulationError;

/// Rosenbrock's function in each pair of coordinates, with the minimum at 0.7. One corner has no response.
struct Rosenbrock(usize);

impl Problem for Rosenbrock {
    fn dimension(&self) -> usize {
        self.0
    }

    fn evaluate(&self, unit_points: &[Vec<f64>], _: bool) -> Vec<Evaluation> {
        let one = |p: &Vec<f64>| {
            if p.iter().all(|x| *x > 0.95) {
                return Evaluation::failed(SimulationError::Failed("corner".into()));
            }
            let x: Vec<f64> = p.iter().map(|x| 1.0 + 2.0 * (x - 0.7)).collect();
            let pair = |w: &[f64]| [3.0 * (w[1] - w[0] * w[0]), 1.0 - w[0]];
            let residuals: Vec<f64> = x.windows(2).flat_map(pair).collect();
            Evaluation { trial: Trial { objective: residuals.iter().map(|r| r * r).sum(), residuals }, error: None }
        };
        unit_points.iter().map(one).collect()
    }
}

fn settings(method: SearchMethod, polish: bool) -> SearchSettings {
    SearchSettings { method, polish, evaluations: Some(4000), generations: 150, ..SearchSettings::default() }
}

#[test]
fn every_method_finds_the_minimum() {
    for (name, method) in SearchMethod::ALL {
        let found = search(&Rosenbrock(4), Checkpoint::new(settings(method, false), vec![0.1; 4]), &mut NoObserver);
        let best = found.best().unwrap();
        assert!(best.objective < 2e-2, "{name}: {}", best.objective);
        let polished = search(&Rosenbrock(4), Checkpoint::new(settings(method, true), vec![0.1; 4]), &mut NoObserver);
        let best = polished.best().unwrap();
        assert!(best.objective < 1e-12 && best.unit_point.iter().all(|x| (x - 0.7).abs() < 1e-5), "{name}: {best:?}");
        assert!(best.history.windows(2).all(|w| w[1].1 < w[0].1 && w[1].0 > w[0].0));
    }
}

/// The unconstrained minimum is outside of the cube.
#[test]
fn constrained_minimum_is_on_the_bound() {
    struct OutsideMinimum;
    impl Problem for OutsideMinimum {
        fn dimension(&self) -> usize {
            2
        }
        fn evaluate(&self, unit_points: &[Vec<f64>], _: bool) -> Vec<Evaluation> {
            let one = |p: &Vec<f64>| {
                assert!(p.iter().all(|x| (0.0..=1.0).contains(x)), "{p:?}");
                let residuals = vec![p[0] - 1.5, p[1] + 0.5 * p[0] - 0.9];
                Evaluation { trial: Trial { objective: residuals.iter().map(|r| r * r).sum(), residuals }, error: None }
            };
            unit_points.iter().map(one).collect()
        }
    }
    for (name, method) in SearchMethod::ALL {
        let found = search(&OutsideMinimum, Checkpoint::new(settings(method, true), vec![0.5; 2]), &mut NoObserver);
        let best = found.best().unwrap();
        assert!((best.objective - 0.25).abs() < 1e-9 && (best.unit_point[1] - 0.4).abs() < 1e-4, "{name}: {best:?}");
    }
}

/// Stops after some generations, and keeps the checkpoint.
struct StopAfter {
    remaining: usize,
    checkpoint: Option<String>,
}

impl SearchObserver for StopAfter {
    fn status(&mut self, s: &SearchStatus<'_>) {
        assert!((0.0..=1.0).contains(&s.progress), "{s:?}");
        self.remaining -= 1;
    }
    fn stopped(&self) -> bool {
        self.remaining == 0
    }
    fn checkpoint(&mut self, c: &Checkpoint) {
        self.checkpoint = Some(serde_json::to_string(c).unwrap());
    }
}

#[test]
fn search_from_a_checkpoint_gives_the_same_bits() {
    for (name, method) in SearchMethod::ALL {
        let settings = SearchSettings { repeats: 2, evaluations: Some(600), generations: 10, ..settings(method, true) };
        let begin = || Checkpoint::new(settings.clone(), vec![0.2; 3]);
        let whole = search(&Rosenbrock(3), begin(), &mut NoObserver);
        assert!(!whole.stopped && whole.repeats.len() == 2);
        for generations in [1, 7, 15, 40] {
            let mut observer = StopAfter { remaining: generations, checkpoint: None };
            let part = search(&Rosenbrock(3), begin(), &mut observer);
            if !part.stopped {
                continue;
            }
            let at: Checkpoint = serde_json::from_str(&observer.checkpoint.unwrap()).unwrap();
            let again = search(&Rosenbrock(3), at, &mut NoObserver);
            assert_eq!(again, whole, "{name} after {generations}");
        }
    }
}

#[test]
fn failures_are_counted_if_all_evaluations_fail() {
    struct NoResponse;
    impl Problem for NoResponse {
        fn dimension(&self) -> usize {
            2
        }
        fn evaluate(&self, unit_points: &[Vec<f64>], _: bool) -> Vec<Evaluation> {
            unit_points.iter().map(|_| Evaluation::failed(SimulationError::Exit(1))).collect()
        }
    }
    for (name, method) in SearchMethod::ALL {
        let settings = SearchSettings { evaluations: Some(300), generations: 5, ..settings(method, true) };
        let found = search(&NoResponse, Checkpoint::new(settings, vec![0.5; 2]), &mut NoObserver);
        assert!(found.best().is_none(), "{name}");
        assert_eq!(found.failures().values().sum::<usize>(), found.evaluations(), "{name}");
    }
}
