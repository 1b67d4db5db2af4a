//! The methods on functions whose least value is known.

use hysteron::calibrate::{Checkpoint, Evaluated, Plan, Problem, Silent, Status, Strategy, Trial, Watch, search};
use hysteron::study::Mishap;

/// Least squares: a bent valley (Rosenbrock) in each pair of coordinates, its floor at 0.7; one corner has no answer.
struct Valley(usize);

impl Problem for Valley {
    fn dimension(&self) -> usize {
        self.0
    }

    fn evaluate(&self, points: &[Vec<f64>], _: bool) -> Vec<Evaluated> {
        let one = |p: &Vec<f64>| {
            if p.iter().all(|x| *x > 0.95) {
                return Evaluated::failed(Mishap::Failed("corner".into()));
            }
            let x: Vec<f64> = p.iter().map(|x| 1.0 + 2.0 * (x - 0.7)).collect();
            let pair = |w: &[f64]| [3.0 * (w[1] - w[0] * w[0]), 1.0 - w[0]];
            let residuals: Vec<f64> = x.windows(2).flat_map(pair).collect();
            Evaluated { trial: Trial { score: residuals.iter().map(|r| r * r).sum(), residuals }, mishap: None }
        };
        points.iter().map(one).collect()
    }
}

fn plan(strategy: Strategy, polish: bool) -> Plan {
    Plan { strategy, polish, evaluations: Some(4000), generations: 150, ..Plan::default() }
}

#[test]
fn every_method_finds_the_floor() {
    for (name, strategy) in Strategy::ALL {
        let found = search(&Valley(4), Checkpoint::new(plan(strategy, false), vec![0.1; 4]), &mut Silent);
        let best = found.best().unwrap();
        assert!(best.score < 2e-2, "{name}: {}", best.score);
        let polished = search(&Valley(4), Checkpoint::new(plan(strategy, true), vec![0.1; 4]), &mut Silent);
        let best = polished.best().unwrap();
        assert!(best.score < 1e-12 && best.best.iter().all(|x| (x - 0.7).abs() < 1e-5), "{name}: {best:?}");
        assert!(best.history.windows(2).all(|w| w[1].1 < w[0].1 && w[1].0 > w[0].0));
    }
}

/// A floor beyond a side of the cube: the best is on the side.
#[test]
fn sides_hold() {
    struct Beyond;
    impl Problem for Beyond {
        fn dimension(&self) -> usize {
            2
        }
        fn evaluate(&self, points: &[Vec<f64>], _: bool) -> Vec<Evaluated> {
            let one = |p: &Vec<f64>| {
                assert!(p.iter().all(|x| (0.0..=1.0).contains(x)), "{p:?}");
                let residuals = vec![p[0] - 1.5, p[1] + 0.5 * p[0] - 0.9];
                Evaluated { trial: Trial { score: residuals.iter().map(|r| r * r).sum(), residuals }, mishap: None }
            };
            points.iter().map(one).collect()
        }
    }
    for (name, strategy) in Strategy::ALL {
        let found = search(&Beyond, Checkpoint::new(plan(strategy, true), vec![0.5; 2]), &mut Silent);
        let best = found.best().unwrap();
        assert!((best.score - 0.25).abs() < 1e-9 && (best.best[1] - 0.4).abs() < 1e-4, "{name}: {best:?}");
    }
}

/// Stops after some askings, keeping the checkpoint.
struct StopAfter {
    left: usize,
    kept: Option<String>,
    seen: usize,
}

impl Watch for StopAfter {
    fn status(&mut self, s: &Status<'_>) {
        assert!((0.0..=1.0).contains(&s.progress), "{s:?}");
        self.left -= 1;
        self.seen += 1;
    }
    fn stopped(&self) -> bool {
        self.left == 0
    }
    fn checkpoint(&mut self, c: &Checkpoint) {
        self.kept = Some(serde_json::to_string(c).unwrap());
    }
}

/// What goes on from a checkpoint is what would have been without it, to the bit.
#[test]
fn a_stopped_search_goes_on() {
    for (name, strategy) in Strategy::ALL {
        let plan = Plan { repeats: 2, evaluations: Some(600), generations: 10, ..plan(strategy, true) };
        let begin = || Checkpoint::new(plan.clone(), vec![0.2; 3]);
        let whole = search(&Valley(3), begin(), &mut Silent);
        assert!(!whole.stopped && whole.repeats.len() == 2);
        for left in [1, 7, 15, 40] {
            let mut watch = StopAfter { left, kept: None, seen: 0 };
            let part = search(&Valley(3), begin(), &mut watch);
            if !part.stopped {
                continue;
            }
            let at: Checkpoint = serde_json::from_str(&watch.kept.unwrap()).unwrap();
            let again = search(&Valley(3), at, &mut Silent);
            assert_eq!(again, whole, "{name} after {left}");
        }
    }
}

/// Where nothing has an answer there is no best, and the causes are counted.
#[test]
fn nothing_has_an_answer() {
    struct Nothing;
    impl Problem for Nothing {
        fn dimension(&self) -> usize {
            2
        }
        fn evaluate(&self, points: &[Vec<f64>], _: bool) -> Vec<Evaluated> {
            points.iter().map(|_| Evaluated::failed(Mishap::Exit(1))).collect()
        }
    }
    for (name, strategy) in Strategy::ALL {
        let plan = Plan { evaluations: Some(300), generations: 5, ..plan(strategy, true) };
        let found = search(&Nothing, Checkpoint::new(plan, vec![0.5; 2]), &mut Silent);
        assert!(found.best().is_none(), "{name}");
        assert_eq!(found.mishaps().values().sum::<usize>(), found.evaluations(), "{name}");
    }
}
