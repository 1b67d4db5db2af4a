//! Numbers that steer the search for fits. All are choices between time and thoroughness.
//!
//! Coordinates are those of the unit cube, in which a parameter's range is one. Log evidence is in nats.

// ---- least squares ----

/// Relative gain of an iteration at which a search ends.
pub(crate) const SEARCH_TOLERANCE: f64 = 1e-3;
/// The same for precise searches.
pub(crate) const PRECISE_SEARCH_TOLERANCE: f64 = 1e-6;
/// Evaluations of an iteration beyond the number of parameters.
pub(crate) const EXTRA_EVALUATIONS: usize = 2;
/// Iterations of a baseline search.
pub(crate) const BASELINE_ITERATIONS: usize = 12;
/// Iterations of a first-round search.
pub(crate) const FIRST_ROUND_ITERATIONS: usize = 4;
/// Iterations of a global search in the first round.
pub(crate) const GLOBAL_ITERATIONS: usize = 6;
/// Iterations of a search for finalists and pairs.
pub(crate) const SECOND_ROUND_ITERATIONS: usize = 12;
/// Iterations in which a fit follows another length of step.
pub(crate) const STEP_ERROR_ITERATIONS: usize = 6;
/// Iterations of the last search. Searches from this number on are precise.
pub(crate) const LAST_ITERATIONS: usize = 20;
/// Iterations in which a channel fault is followed in screening; it needs no analysis.
pub(crate) const CHANNEL_FAULT_ITERATIONS: usize = 6;
/// Wider steps of finite differences, coordinates. Stick-slip and contact make the objective rough on a narrow scale.
pub(crate) const WIDER_DIFFERENCE_STEPS: [f64; 2] = [1e-3, 1e-2];
/// Relative gain of the baseline from which wider differences are kept.
pub(crate) const MIN_WIDER_STEP_GAIN: f64 = 0.02;
/// Baseline minima that are followed with wider differences.
pub(crate) const WIDER_STEP_STARTS: usize = 2;
/// Jobs between two reports of progress.
pub(crate) const JOBS_PER_BATCH: usize = 8;

// ---- linear prediction of the user's parameters ----

/// Damping of derivatives, in parts of their norm.
pub(crate) const PROJECTION_DAMPING: f64 = 1e-3;
/// Largest predicted move, coordinates.
pub(crate) const MAX_PROJECTED_STEP: f64 = 0.4;

// ---- quality of the baseline ----

/// NMSE from which a baseline says little about its parameters.
pub(crate) const POOR_NMSE: f64 = 0.2;
/// The same where a parameter is at a bound.
pub(crate) const POOR_NMSE_AT_BOUND: f64 = 0.02;
/// Distance from a bound that counts as none, coordinates.
const BOUND_DISTANCE: f64 = 1e-3;

/// Returns true if a coordinate of the unit interval is at an end.
pub(crate) fn is_at_bound(coordinate: f64) -> bool {
    !(BOUND_DISTANCE..=1.0 - BOUND_DISTANCE).contains(&coordinate)
}

// ---- screening and first round ----

/// Points per parameter, and one more set, at which a proposal is screened from the fitted baseline.
pub(crate) const SCREENING_POINTS: usize = 2;
/// The same from the user's values.
pub(crate) const SCREENING_POINTS_AT_USER_VALUES: usize = 1;
/// Distance of the user's values from the fitted ones from which they are screened as well, coordinates.
pub(crate) const MIN_USER_VALUE_DISTANCE: f64 = 0.03;
/// Proposals that are fitted in the first batch, at most.
pub(crate) const FIRST_ROUND_SEARCHES: usize = 20;
/// Proposals that are fitted in the first batch even without a promise.
pub(crate) const UNPROMISING_SEARCHES: usize = 8;
/// Forms of one cause in that batch.
pub(crate) const FORMS_PER_CAUSE: usize = 3;
/// Expected log evidence over the baseline below which a proposal is not promising.
pub(crate) const MIN_EXPECTED_GAIN: f64 = -3.0;
/// Causes that reach the second round.
pub(crate) const FINALIST_CAUSES: usize = 8;
/// Forms that reach it of the first cause and its look-alikes; of other causes one does.
pub(crate) const FINALIST_FORMS: usize = 2;

// ---- alternative forms ----

/// Leading causes whose neighbouring and extended forms are fitted.
pub(crate) const LEADING_CAUSES: usize = 3;
/// Expansions to neighbouring forms, each from the best form so far.
pub(crate) const NEIGHBOUR_EXPANSIONS: usize = 2;
/// Points per further parameter, and one more set, at which an extended form is tried.
pub(crate) const EXTENDED_FORM_POINTS: usize = 4;
/// The same for look-alikes of the best hypothesis.
pub(crate) const COMPETITOR_POINTS: usize = 8;

// ---- global search ----

/// Points per parameter, and one more set, in the whole cube.
pub(crate) const GLOBAL_POINTS: usize = 5;
/// Interleaved groups of these points; the best of each is a start.
pub(crate) const GLOBAL_GROUPS: usize = 2;
/// Starts of one cause that are followed.
pub(crate) const GLOBAL_STARTS_PER_CAUSE: usize = 4;
/// Product of searches and samples up to which a global search is affordable.
pub(crate) const MAX_GLOBAL_SAMPLES: usize = 100_000;

// ---- pairs of effects ----

/// First effects beside which a second one is sought.
pub(crate) const FIRST_EFFECTS: usize = 3;
/// Log evidence by which a first effect may be behind the best: another pair may lead.
pub(crate) const MAX_FIRST_EFFECT_DEFICIT: f64 = 20.0;
/// Second effects that are fitted beside each first one.
pub(crate) const SECOND_EFFECTS: usize = 3;
/// Pairs that are kept of these.
pub(crate) const KEPT_PAIRS: usize = 2;
/// Points per parameter, and one more set, at which a second effect is screened.
pub(crate) const SECOND_EFFECT_POINTS: usize = 2;
/// Exchanges of one effect of the leading pair, at most.
pub(crate) const MAX_EXCHANGES: usize = 4;
/// Ratio of step lengths in screening and fitting of pairs.
pub(crate) const SCREENING_STEP_RATIO: u32 = 4;
/// Expected log evidence over one effect below which a pair is not fitted.
pub(crate) const MIN_EXPECTED_PAIR_GAIN: f64 = -1.0;

// ---- other values of the user's parameters ----

/// Moves of a time at which a parameter changes that are tried after a search, coordinates: from a place of the first scan on.
pub(crate) const CHANGE_POINT_MOVES: [f64; 5] = [0.025, 0.0125, 0.006, 0.003, 0.0015];
/// Searches that follow such a move, at most.
pub(crate) const CHANGE_POINT_ROUNDS: usize = 3;

/// Steps of the search for its value there, each along the secant of the last two.
pub(crate) const CHANGED_PARAMETER_STEPS: usize = 6;
/// Change of a coordinate that ends it.
pub(crate) const CHANGED_PARAMETER_TOLERANCE: f64 = 1e-4;

// ---- last search ----

/// Further starts around the fitted point: contact and yielding make ridges.
pub(crate) const LAST_SEARCH_STARTS: usize = 3;
/// Side of the cube around the fitted point in which they lie, coordinates.
pub(crate) const LAST_SEARCH_SIDE: f64 = 0.1;

/// Searches without a cause whose repair the runs held out have refuted, at most.
pub(crate) const MAX_RESTARTS: usize = 3;
