//! The work on variants, with its progress, and what an explanation is.

use crate::candidate::variant::Variant;
use crate::evidence::likelihood::{Residuals, priced};
use crate::evidence::parametric_bootstrap::Near;
use crate::fit::checkpoint::{Kept, Told, number};
use crate::fit::evaluator::{Answer, Bench, Fitted, Job, Task};
use crate::verdict::diagnosis::Watch;
use hysteron_identify::study::Study;
use std::sync::Arc;

/// Iterations of the last search.
pub(crate) const LAST: usize = 20;

/// An explanation that has been fitted.
#[derive(Clone)]
pub(crate) struct Explained {
    pub(crate) variant: Arc<Variant>,
    pub(crate) fitted: Fitted,
    /// What it leaves of samples that it was not fitted to.
    pub(crate) held: Option<Residuals>,
    /// Log evidence.
    pub(crate) evidence: f64,
}

impl Explained {
    pub(crate) fn new(variant: Arc<Variant>, fitted: Fitted) -> Self {
        Self { variant, fitted, held: None, evidence: f64::NEG_INFINITY }
    }

    pub(crate) fn cause(&self) -> &'static str {
        self.variant.cause()
    }

    /// The second of two effects.
    pub(crate) fn second(&self) -> Option<&'static str> {
        self.variant.second()
    }

    pub(crate) fn score(&self) -> f64 {
        priced(self.fitted.objective, self.variant.dimension(), self.variant.known())
    }
}

/// A variant that has been screened: where a search had best start, and the objective to be expected.
#[derive(Clone)]
pub(crate) struct Screened {
    pub(crate) variant: Arc<Variant>,
    pub(crate) start: Vec<f64>,
    pub(crate) expected: f64,
}

impl Screened {
    pub(crate) fn score(&self) -> f64 {
        priced(self.expected, self.variant.dimension(), self.variant.known())
    }
}

fn screened((variant, answer): (Arc<Variant>, Option<Answer>)) -> Option<Screened> {
    match answer {
        Some(Answer::Screened(Some((expected, start)))) => Some(Screened { variant, start, expected }),
        _ => None,
    }
}

pub(crate) struct Work<'a> {
    pub(crate) study: Arc<Study>,
    pub(crate) bench: Bench,
    pub(crate) watch: &'a mut dyn Watch,
    /// What an interrupted diagnosis came to, job after job, and how many jobs there have been.
    pub(crate) earlier: Vec<Kept>,
    pub(crate) jobs: usize,
}

impl Work<'_> {
    /// An error where the user wants to stop.
    pub(crate) fn go_on(&self) -> Result<(), String> {
        if self.watch.stopped() { Err("interrupted".into()) } else { Ok(()) }
    }

    /// The next job, or what an interrupted diagnosis came to in its place. Jobs follow from the answers to those before:
    /// where another one stands in its place, all that comes after it is forgotten.
    fn told(&mut self, job: Job, number: u64) -> Job {
        self.jobs += 1;
        let Some(kept) = self.earlier.get(self.jobs - 1) else { return job };
        match kept.of_job(number) {
            Some(Told::Again) => job,
            Some(told) => Job { task: Task::Told(told.clone()), ..job },
            None => {
                self.earlier.truncate(self.jobs - 1);
                job
            }
        }
    }

    fn run(&mut self, stage: &str, jobs: Vec<Job>) -> Result<Vec<Option<Answer>>, String> {
        let of = jobs.len();
        let mut out = Vec::with_capacity(of);
        // In portions, so that progress is seen and an interruption heard.
        let mut jobs = jobs.into_iter().peekable();
        while jobs.peek().is_some() {
            self.go_on()?;
            self.watch.stage(stage, out.len(), of);
            let first = self.jobs;
            let portion: Vec<Job> = jobs.by_ref().take(8).collect();
            let numbers: Vec<u64> = portion.iter().map(number).collect();
            let portion: Vec<Job> = portion.into_iter().zip(&numbers).map(|(job, n)| self.told(job, *n)).collect();
            let answers = self.bench.run(portion);
            // An analysis that was cut off says nothing: what was worked out before it is kept.
            if let Err(stopped) = self.go_on() {
                self.watch.keep(&self.earlier);
                return Err(stopped);
            }
            let known = self.earlier.len().saturating_sub(first);
            let kept = numbers.into_iter().zip(&answers).map(|(n, a)| Kept::of(n, a.as_ref()));
            self.earlier.extend(kept.skip(known));
            self.watch.keep(&self.earlier);
            out.extend(answers);
        }
        self.watch.stage(stage, of, of);
        Ok(out)
    }

    pub(crate) fn fit(&mut self, stage: &str, jobs: Vec<Job>) -> Result<Vec<Option<Fitted>>, String> {
        let fitted = |a| match a {
            Some(Answer::Fitted(f)) if !f.fits.is_empty() => Some(f),
            _ => None,
        };
        Ok(self.run(stage, jobs)?.into_iter().map(fitted).collect())
    }

    /// A search from a point with so many iterations.
    pub(crate) fn search(variant: &Arc<Variant>, start: Vec<f64>, iterations: usize) -> Job {
        let budget = iterations * (variant.dimension() + 2);
        let task = Task::Fit { start, budget, closely: iterations >= LAST };
        Job { variant: variant.clone(), task }
    }

    /// Screen variants, each at points of which the first coordinates are known: best first. The known ones stand `at` a
    /// point of the variant `from`, and follow by its derivatives.
    pub(crate) fn screen(
        &mut self,
        stage: &str,
        from: &Arc<Variant>,
        at: &[f64],
        tried: Vec<(Arc<Variant>, Vec<Vec<f64>>)>,
    ) -> Result<Vec<Screened>, String> {
        let derive = Task::Derive { point: at.to_vec() };
        let known = match self.run(stage, vec![Job { variant: from.clone(), task: derive }])?.pop() {
            Some(Some(Answer::Derived(Some(known)))) => Arc::new(known),
            _ => return Ok(vec![]),
        };
        let (variants, jobs): (Vec<_>, Vec<_>) = tried
            .into_iter()
            .map(|(variant, points)| {
                let points = points.iter().map(|p| at.iter().chain(&p[at.len()..]).copied().collect());
                let task = Task::Screen { points: points.collect(), known: Some(known.clone()) };
                (variant.clone(), Job { variant, task })
            })
            .unzip();
        let answers = self.run(stage, jobs)?;
        let mut out: Vec<Screened> = variants.into_iter().zip(answers).filter_map(screened).collect();
        out.sort_by(|a, b| a.score().total_cmp(&b.score()));
        Ok(out)
    }

    /// For each variant the point of its own that comes nearest, as it is, with the objective there; nothing of those that have no
    /// answer at any.
    pub(crate) fn nearest(
        &mut self,
        stage: &str,
        tried: Vec<(Arc<Variant>, Vec<Vec<f64>>)>,
    ) -> Result<Vec<Screened>, String> {
        let variants: Vec<Arc<Variant>> = tried.iter().map(|(v, _)| v.clone()).collect();
        let job = |(variant, points)| Job { variant, task: Task::Screen { points, known: None } };
        let answers = self.run(stage, tried.into_iter().map(job).collect())?;
        Ok(variants.into_iter().zip(answers).filter_map(screened).collect())
    }

    /// Search from where the screening says.
    pub(crate) fn search_all(
        &mut self,
        stage: &str,
        from: Vec<Screened>,
        iterations: usize,
    ) -> Result<Vec<Explained>, String> {
        let jobs = from.iter().map(|s| Self::search(&s.variant, s.start.clone(), iterations)).collect();
        let fitted = self.fit(stage, jobs)?;
        let mut all: Vec<Explained> =
            from.into_iter().zip(fitted).filter_map(|(s, f)| Some(Explained::new(s.variant, f?))).collect();
        all.sort_by(|a, b| a.score().total_cmp(&b.score()));
        Ok(all)
    }

    /// What an explanation comes to where it stands when the steps of the script are made in so many parts, from now on.
    pub(crate) fn with_steps_in(&mut self, stage: &str, parts: u32, e: &Explained) -> Result<Option<Fitted>, String> {
        self.bench.refine(parts);
        let job = Job { variant: e.variant.clone(), task: Task::Look { point: e.fitted.point.clone() } };
        Ok(self.fit(stage, vec![job])?.pop().flatten())
    }

    /// What each leaves near its fit; nothing of those without an answer.
    pub(crate) fn near(&mut self, stage: &str, all: &[&Explained]) -> Result<Vec<Option<Near>>, String> {
        let job =
            |e: &&Explained| Job { variant: e.variant.clone(), task: Task::Near { point: e.fitted.point.clone() } };
        let near = |answer| match answer {
            Some(Answer::Near(near)) => near,
            _ => None,
        };
        Ok(self.run(stage, all.iter().map(job).collect())?.into_iter().map(near).collect())
    }

    /// What each says of samples that it was not fitted to.
    pub(crate) fn hold_back(&mut self, stage: &str, all: &mut [Explained]) -> Result<(), String> {
        let job =
            |e: &Explained| Job { variant: e.variant.clone(), task: Task::HoldBack { point: e.fitted.point.clone() } };
        let answers = self.run(stage, all.iter().map(job).collect())?;
        for (e, a) in all.iter_mut().zip(answers) {
            e.held = match a {
                Some(Answer::HeldBack(r)) => r,
                _ => None,
            };
        }
        Ok(())
    }
}
