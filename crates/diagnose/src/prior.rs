//! Every number that a verdict depends on.
//!
//! The module stands below all others, because inspection, residuals, fits and evidence read it. Log odds, log evidences
//! and costs are in nats. Shares are parts of one. A source names the place where a value comes from; "a choice" means
//! that no trial has fixed it. Trials are those of `validation/diagnosis`.
//!
//! The range of a parameter that a hypothesis adds stands in the file of the hypothesis. Numbers that only steer a search
//! stand in `fit/search_settings.rs`.

use serde::Serialize;
use std::collections::BTreeMap;

/// A number that the verdict depends on.
#[derive(Clone, Debug, Serialize)]
pub struct PriorNumber {
    /// Its value; several for a list.
    pub value: Vec<f64>,
    /// Unit; `share` for parts of one, `count` for whole numbers without a unit.
    pub unit: &'static str,
    /// Its effect and its source, in words.
    pub meaning: String,
}

/// Numbers of one or several values.
trait Values {
    fn values(&self) -> Vec<f64>;
}

macro_rules! values {
    ($($number:ty),*) => {$(
        impl Values for $number {
            fn values(&self) -> Vec<f64> {
                vec![*self as f64]
            }
        }
        impl<const N: usize> Values for [$number; N] {
            fn values(&self) -> Vec<f64> {
                self.iter().map(|x| *x as f64).collect()
            }
        }
    )*};
}

values!(f64, usize, isize, u32);

/// Constants with their units, and the list of them that `diagnosis.json` prints.
macro_rules! prior {
    ($($(#[doc = $doc:literal])+ $name:ident: $type:ty = $value:expr, $unit:literal;)+) => {
        $($(#[doc = $doc])+ pub(crate) const $name: $type = $value;)+

        /// All numbers by name.
        pub(crate) fn numbers() -> BTreeMap<&'static str, PriorNumber> {
            let mut all = BTreeMap::new();
            $(all.insert(
                stringify!($name),
                PriorNumber { value: $name.values(), unit: $unit, meaning: concat!($($doc),+).trim().into() },
            );)+
            all
        }
    };
}

prior! {
    // ---- likelihood ----

    /// Independent samples that one channel counts for, however long it is. Source: calibration of confidence on simulated cases.
    EFFECTIVE_SAMPLES: f64 = 40.0, "samples";
    /// Points to which the residual of a channel is averaged before it is compared. A choice.
    LIKELIHOOD_POINTS: usize = 400, "points";
    /// Cycles that a run of steady motion has at least, for what differs between them. A change needs cycles on both sides.
    MIN_CYCLES: usize = 4, "count";
    /// Samples that a cycle has at least. A choice.
    MIN_CYCLE_SAMPLES: usize = 20, "count";
    /// Largest share of the square of a steady motion that its mean cycle leaves. Machines repeat a cycle within a few per cent.
    MAX_UNSTEADY_SHARE: f64 = 0.02, "share";
    /// Log odds over every other cause, on what differs where a motion repeats, from which a changed condition has that evidence. A
    /// choice.
    REPEATED_MOTION_LOG_ODDS: f64 = 5.0, "nats";
    /// Order of the autoregressive noise that whitens residuals. A choice.
    LIKELIHOOD_NOISE_ORDER: usize = 2, "count";
    /// Largest root of that noise, of as many points. Its correlation falls to a third within a fortieth of the record. A choice.
    MAX_NOISE_ROOT: f64 = 0.9, "1";
    /// Blocks into which a run is cut for held-out samples. A choice.
    HOLDOUT_BLOCKS: usize = 8, "count";
    /// Folds to which these blocks belong in turn; each fold is held out once. A choice.
    HOLDOUT_FOLDS: usize = 4, "count";
    /// Fractions of a predicted step that are tried when a fold is held out, the longest first. A choice.
    HOLDOUT_STEP_FRACTIONS: [f64; 3] = [1.0, 0.3, 0.1], "share";
    /// Divisor of the squared residual that damps a least-squares step. Parameters that samples do not determine stay. A choice.
    STEP_DAMPING_DIVISOR: f64 = 100.0, "1";

    // ---- odds before anything is seen ----

    /// Log odds of a complete model against any one cause. A choice.
    COMPLETE_MODEL_LOG_ODDS: f64 = 3.0, "nats";
    /// Log odds of one effect against two. A choice.
    ONE_EFFECT_LOG_ODDS: f64 = 6.0, "nats";
    /// Log odds of a range fault in all runs against one in a single run, where runs differ in load or temperature. A choice:
    /// a law that depends on load or temperature explains the difference without a coincidence.
    RANGE_FAULT_IN_ALL_RUNS_LOG_ODDS: f64 = 8.0, "nats";
    /// Log odds of a fault that the recording itself shows. More than any remaining structure says for `unknown`. A choice.
    VISIBLE_FAULT_LOG_ODDS: f64 = 15.0, "nats";
    /// Log odds by which an auxiliary channel supports or opposes a cause. It need not drive the observed channels. A choice.
    AUXILIARY_CHANNEL_LOG_ODDS: f64 = 4.0, "nats";
    /// Difference of log evidence within which two forms of a cause count as equal. A choice.
    EQUAL_FORM_LOG_EVIDENCE: f64 = 0.5, "nats";

    // ---- other values of the user's parameters ----

    /// Runs that may have another value of a parameter, those with the largest error. More would be another fit. A choice.
    MAX_CONDITION_RUNS: usize = 3, "count";
    /// Parameters that may have another value in a run. A choice between time and thoroughness.
    MAX_CONDITION_PARAMETERS: usize = 6, "count";
    /// Parameters of which two may change together. A choice between time and thoroughness.
    MAX_CONDITION_PARAMETERS_IN_PAIRS: usize = 4, "count";
    /// Range of the factor on a parameter. A band that is slack, a valve that is open and a magnet without current leave a tenth
    /// of the force. A choice.
    CONDITION_FACTORS: [f64; 2] = [0.05, 20.0], "ratio";
    /// Largest difference of the deformations and rates of devices in two runs of like motion: neither amplitude nor rate then
    /// tells the runs apart. Machines repeat a motion within a few per cent. A choice.
    LIKE_MOTION: f64 = 0.1, "share";
    /// Least share of the largest deformation that a device must have to count in that comparison. A choice.
    LIKE_MOTION_DEVICE: f64 = 0.1, "share";
    /// Error of a run with other values over that of a run of like motion, up to which the values are all that differs. A choice.
    LIKE_ERROR_RATIO: f64 = 2.0, "ratio";
    /// Error of a run held out with the other values over that with the usual ones, below which it follows the others. A choice
    /// between two values needs a clear difference.
    FOLLOWS_OTHER_VALUES: f64 = 0.5, "ratio";
    /// Places of a run at which a parameter may change. As many as the independent samples of a channel.
    CHANGE_PLACES: usize = 40, "count";
    /// Least length of a ramp in such places. A shorter one is a step to the independent samples. A choice.
    MIN_RAMP_PLACES: usize = 6, "count";
    /// Time constants of heat that is lost, with which a ramp is compared, in parts of the longest run. A choice.
    RAMP_HEAT_TIMES: [f64; 2] = [0.1, 0.3], "share";
    /// Parameters that a time of change counts for. What N samples tell of it narrows with 1/N and not with 1/sqrt(N), so that
    /// its price is ln N.
    CHANGE_POINT_PARAMETERS: usize = 2, "count";
    /// Spans of time with another value of a parameter that are proposed. A choice between time and thoroughness.
    MAX_CONDITION_SPANS: usize = 4, "count";
    /// Scales of histories on which a parameter may go to a limit, in parts of the largest value; infinity for proportion. What
    /// such a history tells as well is no change at a time. A choice.
    HISTORY_SCALES: [f64; 3] = [f64::INFINITY, 0.3, 0.1], "share";

    // ---- parametric bootstrap ----

    /// Recordings that each explanation simulates. The smallest share that they resolve is 1/200.
    BOOTSTRAP_RECORDINGS: usize = 199, "count";
    /// Largest share of a cause's recordings with an equal gain at which the gain refutes the cause. The usual 5 % level.
    MAX_REFUTED_SHARE: f64 = 0.05, "share";
    /// Largest step of a parameter for which its derivative is trusted, in parts of its range. A choice.
    MAX_LINEAR_STEP: f64 = 0.4, "share";

    // ---- from evidence to probabilities ----

    /// Share of any probability that all candidates get in equal parts. No evidence is beyond doubt: of the surest 48 of 99
    /// answers to cases of unseen authors two were wrong.
    LAPSE_SHARE: f64 = 0.03, "share";

    // ---- repairs and reports ----

    /// Gain over the user's model from which a repair is written although structure remains. A choice.
    MIN_REPAIR_GAIN: f64 = 5.0, "nats";
    /// Gain of a pair over its first effect alone from which the repair may have both, although the second has no sure name. A
    /// choice: well above that of chance.
    MIN_SECOND_REPAIR_GAIN: f64 = 10.0, "nats";
    /// Error in the runs held out, over that of the first effect alone, below which such a repair has both. A choice.
    MAX_SECOND_REPAIR_RATIO: f64 = 0.8, "ratio";
    /// Structured share of the residual of the user's model above which two effects are sought although no single one gains. A
    /// choice.
    MIN_STRUCTURE_FOR_PAIRS: f64 = 0.18, "1";
    /// Structured share of the residual of the user's model above which whole laws may replace that of a device. A choice.
    MIN_STRUCTURE_FOR_WHOLE_LAWS: f64 = 0.18, "1";
    /// Least probability with which another cause is reported. A choice.
    MIN_REPORTED_PROBABILITY: f64 = 0.005, "share";

    // ---- runs held out ----

    /// Ratio of held-out NMSE after and before a repair above which the runs count as worsened. A choice.
    WORSENED_RATIO: f64 = 1.5, "ratio";
    /// Reducible share of the held-out error that a repair removes if it predicts them. Of 16 names that removed less, but
    /// some, 13 were right; of 8 with the truth taken out of the library, none.
    PREDICTED_SHARE: f64 = 0.8, "share";
    /// Reducible share of the held-out error that a repair must remove if a repeated search has found it. A choice: runs that
    /// have refuted one repair select the next.
    MIN_REPEATED_SHARE: f64 = 0.5, "share";
    /// Ratio of held-out NMSE and noise below which held-out runs cannot judge. A choice.
    MIN_HOLDOUT_SIGNAL_RATIO: f64 = 1.25, "ratio";

    // ---- structure of residuals ----

    /// Points to which a residual is averaged in the search for structure. Mechanisms act on the scale of the motion. A choice.
    STRUCTURE_POINTS: usize = 1500, "points";
    /// Order of the noise that is removed before residuals are compared with the motion. A choice.
    STRUCTURE_NOISE_ORDER: usize = 2, "count";
    /// Order of the noise that is removed before bursts are sought. A choice.
    BURST_NOISE_ORDER: usize = 8, "count";
    /// Blocks of time for cross-validation of regressions. A choice.
    STRUCTURE_BLOCKS: usize = 6, "count";
    /// Samples that each regressor needs. A choice.
    SAMPLES_PER_REGRESSOR: usize = 8, "samples";
    /// Ridge of a regression, in parts of the mean square of a regressor. A choice.
    REGRESSION_RIDGE: f64 = 1e-3, "share";
    /// Shifts of the averaged channel that serve as regressors. Neighbouring points reveal a fault of its transfer. A choice.
    CHANNEL_SHIFTS: [isize; 9] = [-16, -8, -4, -2, 0, 2, 4, 8, 16], "points";
    /// Shifts of other channels' residuals that serve as regressors, samples. A choice.
    RESIDUAL_SHIFTS: [isize; 13] = [0, -1, 1, -2, 2, -3, 3, -4, 4, -5, 5, -6, 6], "samples";
    /// Devices whose motion serves as regressors, each in one direction. A choice.
    REGRESSION_DEVICES: usize = 2, "count";
    /// Gaussian bumps along the deformation of a device that serve as regressors. A choice.
    DEFORMATION_BUMPS: usize = 24, "count";
    /// Residual power over the variance of its channel below which structure counts in proportion. A choice.
    NEGLIGIBLE_RESIDUAL: f64 = 1e-4, "share";
    /// Reweighted least-squares steps for noise that grows with its channel. A choice.
    VARIANCE_FIT_STEPS: usize = 20, "count";
    /// Least part of the noise power that does not grow with the channel. A choice.
    MIN_CONSTANT_VARIANCE: f64 = 1e-3, "share";
    /// Relative determinant below which the two parts of the variance are not separable. Round-off of double precision.
    SINGULAR_VARIANCE_FIT: f64 = 1e-12, "1";

    /// Stretches into which a record is cut for bursts. A choice.
    BURST_STRETCHES: usize = 40, "count";
    /// Samples that such a stretch needs. A choice.
    MIN_BURST_SAMPLES: usize = 8, "samples";
    /// Power over the expected power from which a stretch is a burst. Noise of one level exceeds its median four times in none.
    BURST_POWER_RATIO: f64 = 4.0, "ratio";

    /// Samples of which a spectrum is taken at most. A choice.
    MAX_SPECTRUM_SAMPLES: usize = 8192, "samples";
    /// Samples that a spectrum needs. A choice.
    MIN_SPECTRUM_SAMPLES: usize = 64, "samples";
    /// Power over the median around it from which a frequency is a line. Noise exceeds 25 times its median once in 3e7.
    LINE_POWER_RATIO: f64 = 25.0, "ratio";
    /// Least half width of the band around a line, frequencies. A choice.
    MIN_LINE_BAND: usize = 6, "frequencies";
    /// Half width of the close band around a line, frequencies: narrow-band noise stands above its octave. A choice.
    LINE_BAND: usize = 24, "frequencies";
    /// Frequencies on both sides to which a line itself reaches under a Hann window.
    LINE_SKIRT: usize = 2, "frequencies";
    /// Cycles per record below which nothing is called a line. A choice.
    MIN_LINE_CYCLES: usize = 8, "cycles";

    /// Surrogate series with which a residual is compared. None may come near it.
    SURROGATES: usize = 99, "count";
    /// Standard deviations of the surrogates by which a residual must exceed their mean. A choice.
    SURROGATE_Z: f64 = 5.0, "standard deviations";
    /// Divisor of the record's length that gives each end of its cosine taper. A choice.
    TAPER_DIVISOR: usize = 20, "count";
    /// Numbers of stretches into which a record is cut for steadiness, coarse and fine. A choice.
    STEADINESS_STRETCHES: [usize; 4] = [6, 12, 24, 48], "count";
    /// Samples that such a stretch needs. A choice.
    MIN_STEADINESS_SAMPLES: usize = 8, "samples";
    /// Divisor of the number of stretches that gives the quietest ones. A choice.
    QUIETEST_DIVISOR: usize = 4, "count";

    /// Cells along the stroke that resolve the error of another form of law. A choice.
    COARSE_STROKE_CELLS: usize = 12, "count";
    /// Cells that resolve changes within the stroke. A choice.
    FINE_STROKE_CELLS: [usize; 3] = [24, 48, 96], "count";
    /// Mean number of samples that a cell needs. A choice.
    SAMPLES_PER_CELL: usize = 4, "samples";

    // ---- drift against slow noise ----

    /// Points to which a residual is averaged. A choice.
    DRIFT_POINTS: usize = 512, "points";
    /// Points below which a drift is never distinguished from noise. A choice.
    MIN_DRIFT_POINTS: usize = 16, "points";
    /// Divisor of the record that gives the places at which a jump is tried. A choice.
    JUMP_PLACES: usize = 40, "count";
    /// Standard deviations of the surrogates by which a drift must exceed their mean: every channel and run is searched. A choice.
    DRIFT_Z: f64 = 4.0, "standard deviations";
    /// Lowest frequencies whose power gives the standard deviation of the mean of slow noise. A choice.
    MEAN_DEVIATION_FREQUENCIES: usize = 6, "frequencies";
    /// Standard deviations of the mean above which a constant offset is no noise. A choice.
    OFFSET_Z: f64 = 5.0, "standard deviations";
    /// Least remaining share of a residual whose logarithm is taken.
    MIN_REMAINING_SHARE: f64 = 1e-12, "share";

    // ---- saturation of a channel ----

    /// Difference of samples that count as equal, in parts of the channel's range. Digits of a file.
    EQUAL_SAMPLES: f64 = 1e-6, "share";
    /// Distance from an end that counts as near it, in parts of the channel's range. A choice.
    NEAR_END: f64 = 5e-3, "share";
    /// Samples at an end that saturation needs. A choice.
    MIN_SATURATED_SAMPLES: usize = 6, "samples";
    /// Successive samples at an end that saturation needs. A choice.
    MIN_SATURATED_IN_A_ROW: usize = 4, "count";
    /// Samples at an end over those near it that saturation needs. A choice.
    MIN_SATURATED_OVER_NEAR: usize = 2, "ratio";
    /// Motion of the model meanwhile, in parts of the channel's range. A plateau of the motion is no saturation. A choice.
    MIN_MOTION_WHILE_SATURATED: f64 = 2e-3, "share";
    /// Distance within which a saturated level is the extreme of the recordings, in parts of the channel's range. A choice.
    SATURATED_EXTREME: f64 = 1e-3, "share";

    // ---- conditions and auxiliary channels ----

    /// Difference of temperature below which runs have the same surroundings, degrees. A choice.
    MIN_TEMPERATURE_DIFFERENCE: f64 = 2.0, "degrees";
    /// Samples at the beginning of a run that give its ambient temperature. A choice.
    AMBIENT_SAMPLES: usize = 10, "samples";
    /// Difference of axial loads, in parts of the largest, from which runs differ in load. A choice.
    MIN_AXIAL_LOAD_DIFFERENCE: f64 = 0.05, "share";
    /// Ratio of amplitudes from which runs differ in amplitude. Softening with amplitude exceeds the noise there. A choice.
    MIN_AMPLITUDE_RATIO: f64 = 3.0, "ratio";
    /// Deviation from one of a sampling interval that still counts samples, s. Digits of a file.
    COUNTED_INTERVAL_TOLERANCE: f64 = 1e-9, "s";
    /// Rise of temperature within a run that shows self-heating, degrees. A choice.
    MIN_TEMPERATURE_RISE: f64 = 3.0, "degrees";
    /// Points to which a recorded temperature is averaged. A choice.
    TEMPERATURE_POINTS: usize = 20, "points";
    /// Samples over which a recorded axial force is averaged. It follows the motion. A choice.
    AXIAL_FORCE_SAMPLES: usize = 5, "samples";
    /// Standard deviation over mean from which an axial force varies. In trials 0.09 to 0.29 where it does.
    MIN_VARYING_AXIAL_FORCE: f64 = 0.05, "ratio";
    /// Standard deviation over mean up to which an axial force is constant. In trials 0.002 where it is.
    MAX_CONSTANT_AXIAL_FORCE: f64 = 0.02, "ratio";

    /// Share of a residual that follows the motion, comes again or moves other channels, from which its loudness counts as
    /// physics. Independent noise of several channels shares less.
    MIN_SHARED_STRUCTURE: f64 = 0.05, "share";

    // ---- gates ----

    /// Share of the error of the user's model that a repair must take away to be an answer at all. A choice.
    MIN_TAKEN_ERROR: f64 = 0.005, "share";
    /// Largest probability of a cause whose repair drives a user's parameter to a bound: the bound, not the recordings, then
    /// decides its size. A choice.
    BOUND_PROBABILITY: f64 = 0.5, "share";
    /// Largest probability of a cause where loops of a table are fitted. Their rows share cycles and are no samples with the noise
    /// of an instrument, which the evidence takes them for. A choice.
    TABLE_PROBABILITY: f64 = 0.5, "share";
    /// Move of a unit coordinate away from its bound, and of one whose influence is sought. A choice.
    BOUND_STEP: f64 = 0.02, "share";
    /// Rise of the error by that move from which the bound matters. A choice.
    MIN_BOUND_EFFECT: f64 = 0.01, "share";
    /// Largest probability of a fault of a sensor beside which no other channel shows the same quantity. A choice.
    SINGLE_SENSOR_PROBABILITY: f64 = 0.85, "share";
    /// Log evidence by which an effect on the structure may be behind a fault of a sensor, to explain as much: odds of 20. A choice.
    SENSOR_BESIDE_PHYSICS_LOG_ODDS: f64 = 3.0, "nats";
    /// Largest probability of a cause that is not told from another: a fault of a sensor beside such an effect, and two causes
    /// that are one model. Even odds.
    NOT_TOLD_APART_PROBABILITY: f64 = 0.5, "share";
    /// Error that the user's parameters of one run leave, over that with a fault of that run, up to which they explain as
    /// much. A choice.
    PARAMETERS_IN_ONE_RUN_RATIO: f64 = 1.1, "ratio";
    /// Largest probability of a complete model whose error is many times the noise and follows the motion. A choice: the noise of
    /// a record alone is known within a factor.
    INCOMPLETE_PROBABILITY: f64 = 0.5, "share";
    /// Error over the noise of the recordings from which that limit holds. The estimate of the noise is within a factor of two.
    MAX_NOISE_OF_COMPLETE_MODEL: f64 = 4.0, "ratio";
    /// Error over the noise of the recordings from which another value of a parameter in one run is no answer. A choice.
    MAX_NOISE_OF_CONDITION: f64 = 10.0, "ratio";
    /// Structured share of the residual from which another value of a parameter in one run is not the whole of the matter. A
    /// choice.
    MAX_STRUCTURE_OF_CONDITION: f64 = 0.3, "share";
    /// Squared correlation of a wandering zero with what the motion leaves behind from which it is no drift. A choice.
    FOLLOWED_HISTORY_SHARE: f64 = 0.6, "share";

    // ---- share taken, and kinds of memory ----

    /// Share of the error above the noise that a repair must take away, on blocks held back and in runs held out, to have a
    /// name. A choice.
    MIN_TAKEN_SHARE: f64 = 0.5, "share";
    /// Error in the fitted runs and in those held out, NMSE, up to which a model is not told from what a test does not repeat:
    /// 7 % of the r.m.s. value. A choice: a quarter of the least difference, 0.02 to 0.06, of repeated runs on measured rigs.
    REPEATED_NMSE: f64 = 0.005, "NMSE";
    /// Error in the fitted runs, NMSE, up to which structure in it is not called `unknown`. Source: of 232 seeded models that lack
    /// an effect of no library none left less than 0.002; of 204 complete ones 89 left at most this.
    NEGLIGIBLE_NMSE: f64 = 0.001, "NMSE";
    /// The same in parts of the noise of the recordings. A choice.
    MAX_NOISE_OF_SMALL_ERROR: f64 = 2.0, "ratio";
    /// Largest probability of `unknown` there. A choice.
    SMALL_ERROR_PROBABILITY: f64 = 0.3, "share";
    /// Share of so small an error that a repair must take away, on blocks held back or in runs held out. A choice.
    MIN_TAKEN_OF_SMALL_ERROR: f64 = 0.67, "share";
    /// Share of the structure in so small an error from which a repair explains it, however small its gain. A choice.
    MIN_EXPLAINED_STRUCTURE: f64 = 0.9, "share";
    /// The same of a fault of a sensor, which claims that the model is right but for it. A choice.
    MIN_TAKEN_SHARE_OF_SENSOR: f64 = 0.75, "share";
    /// Largest probability of a fault of a sensor that takes away less. A choice.
    PARTIAL_SENSOR_PROBABILITY: f64 = 0.3, "share";
    /// Largest probability of `unknown` over the share that a repair leaves, where it takes away most. A choice.
    UNKNOWN_PER_SHARE_LEFT: f64 = 1.5, "ratio";
    /// Distance of log likelihoods up to which the fitted weights alone count it, nats. A choice.
    FREE_DISTANCE: f64 = 15.0, "nats";
    /// Distance beyond it that costs one unit of log odds, nats. Evidence between forms of law is overstated. A choice.
    NATS_PER_COST: f64 = 10.0, "nats";
    /// Advantage over a closer fit with no more parameters, at most, nats: whitening alone is no evidence. A choice.
    MAX_ADVANTAGE_OF_WORSE_FIT: f64 = 5.0, "nats";
    /// Advantage of a second effect over another beside the same first effect, at most, where both reach the noise, nats. A choice.
    MAX_SECOND_EFFECT_GAIN: f64 = 20.0, "nats";
    /// Log likelihood by which a second effect leads every other beside the same first effect, to be named far from the noise:
    /// odds of 20. A choice.
    SECOND_EFFECT_LEAD: f64 = 3.0, "nats";
    /// Ratio of the errors of a cause and of a law with another memory from which the other explains more. Right families
    /// led by 1.4 to 18 in a prototype.
    MEMORY_ERROR_RATIO: f64 = 1.5, "ratio";
    /// Difference of the logarithms of the errors within which two kinds of memory tie. A choice.
    MEMORY_TIE: f64 = 0.15, "nats";
    /// Terms of a law that compares kinds of memory, at most. A choice.
    MAX_COMPARED_TERMS: usize = 3, "count";
    /// Terms of a learned law at most. A choice.
    MAX_LEARNED_TERMS: usize = 4, "count";
    /// Further terms that a second kind of memory may add. A choice.
    SECOND_FAMILY_TERMS: usize = 2, "count";
    /// Least fall of the logarithm of the error held back with which a term enters. A choice.
    ENTERING_TERM: f64 = 0.08, "nats";
    /// The same for a second kind of memory. A choice.
    ENTERING_FAMILY: f64 = 0.2, "nats";
    /// The same for slopes of hysteresis. A choice.
    ENTERING_SLOPES: f64 = 0.04, "nats";
    /// Lead of the logarithm of the error with which a law of the clock is taken: elapsed time stands for whatever changes in the
    /// course of a run, and predicts no other run. A choice.
    CLOCK_LEAD: f64 = 0.4, "nats";
    /// Error of a plain shape over that of the user's law up to which kinds of memory are compared on it: memory can act on its
    /// strength. A choice.
    MAX_COMPARED_SHAPE_RATIO: f64 = 1.3, "ratio";
    /// The same ratio up to which learned laws are built on it beside the user's. A choice.
    MAX_LEARNED_SHAPE_RATIO: f64 = 4.0, "ratio";
    /// Least share of the user's error on the runs held out that a learned law must take away to be written. A choice.
    MIN_LEARNED_GAIN: f64 = 0.3, "share";
    /// Error over the noise up to which a learned law is said to reach it. A choice.
    NOISE_RATIO: f64 = 3.0, "ratio";
    /// Probability of faulty sensors above which no law is learned, since it would absorb their fault. A choice.
    MAX_LEARNED_SENSOR_PROBABILITY: f64 = 0.25, "share";
    /// Largest probability of a cause where another kind of memory explains clearly more. A choice.
    MEMORY_PROBABILITY: f64 = 0.1, "share";
    /// Log odds against a cause whose kinds of memory leave e times the error of the best. A choice.
    MEMORY_LOG_ODDS: f64 = 2.0, "nats";

    // ---- error of the time steps ----

    /// Share of a residual's power that halved steps may move without consequence. A choice.
    NEGLIGIBLE_STEP_ERROR: f64 = 0.005, "share";
    /// Residual power over the variance of its channel below which the channel counts as reproduced. A choice.
    REPRODUCED_CHANNEL: f64 = 1e-4, "share";
    /// Largest number of parts into which a step is divided. A choice.
    MAX_STEP_PARTS: u32 = 8, "count";
    /// Ratio of successive moves above which shorter steps do not converge. A choice.
    MAX_STEP_ERROR_RATIO: f64 = 0.5, "ratio";
}
