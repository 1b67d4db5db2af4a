//! Every number that a verdict depends on.
//!
//! The module stands below all others, because inspection, residuals, fits and evidence read it. Log odds, log evidences
//! and costs are in nats. Shares are parts of one. A source names the place where a value comes from; "a choice" means
//! that no trial has fixed it. Trials are those of `validation/diagnosis`.
//!
//! The range of a parameter that a hypothesis adds stands in the file of the hypothesis. Numbers that only steer a search
//! stand in `fit/search_settings.rs`.

// ---- likelihood ----

/// Independent samples that one channel counts for, however long it is. Source: calibration of confidence on simulated cases.
pub(crate) const EFFECTIVE_SAMPLES: f64 = 40.0;
/// Points to which the residual of a channel is averaged before it is compared. A choice.
pub(crate) const LIKELIHOOD_POINTS: usize = 400;
/// Order of the autoregressive noise that whitens residuals. A choice.
pub(crate) const LIKELIHOOD_NOISE_ORDER: usize = 2;
/// Largest root of that noise. Its correlation falls to a third within a fortieth of the record. A choice.
pub(crate) const MAX_NOISE_ROOT: f64 = 0.9;
/// Blocks into which a run is cut for held-out samples. A choice.
pub(crate) const HOLDOUT_BLOCKS: usize = 8;
/// Folds to which these blocks belong in turn; each fold is held out once. A choice.
pub(crate) const HOLDOUT_FOLDS: usize = 4;
/// Fractions of a predicted step that are tried when a fold is held out, the longest first. A choice.
pub(crate) const HOLDOUT_STEP_FRACTIONS: [f64; 3] = [1.0, 0.3, 0.1];
/// Divisor of the squared residual that damps a least-squares step. Parameters that samples do not determine stay. A choice.
pub(crate) const STEP_DAMPING_DIVISOR: f64 = 100.0;

// ---- odds before anything is seen ----

/// Log odds of a complete model against any one cause. A choice.
pub(crate) const COMPLETE_MODEL_LOG_ODDS: f64 = 3.0;
/// Log odds of one effect against two. A choice.
pub(crate) const ONE_EFFECT_LOG_ODDS: f64 = 6.0;
/// Log odds of a range fault in all runs against one in a single run, where runs differ in load or temperature. A choice:
/// a law that depends on load or temperature explains the difference without a coincidence.
pub(crate) const RANGE_FAULT_IN_ALL_RUNS_LOG_ODDS: f64 = 8.0;
/// Log odds of a fault that the recording itself shows. More than any remaining structure says for `unknown`. A choice.
pub(crate) const VISIBLE_FAULT_LOG_ODDS: f64 = 15.0;
/// Log odds by which an auxiliary channel supports or opposes a cause. It need not drive the observed channels. A choice.
pub(crate) const AUXILIARY_CHANNEL_LOG_ODDS: f64 = 4.0;
/// Difference of log evidence within which two forms of a cause count as equal. A choice.
pub(crate) const EQUAL_FORM_LOG_EVIDENCE: f64 = 0.5;

// ---- parametric bootstrap ----

/// Recordings that each explanation simulates. The smallest share that they resolve is 1/200.
pub(crate) const BOOTSTRAP_RECORDINGS: usize = 199;
/// Largest share of a cause's recordings with an equal gain at which the gain refutes the cause. The usual 5 % level.
pub(crate) const MAX_REFUTED_SHARE: f64 = 0.05;
/// Largest step of a parameter for which its derivative is trusted, in parts of its range. A choice.
pub(crate) const MAX_LINEAR_STEP: f64 = 0.4;
/// Least log evidence by which the first cause leads causes that the recordings do not distinguish from it. It exceeds
/// the loss by [`NAMED_VERDICT_ERROR_SHARE`].
pub(crate) const MIN_BOOTSTRAP_LEAD: f64 = 0.3;

// ---- from evidence to probabilities ----

/// Largest structured share of a residual that counts for `unknown`. A choice.
pub(crate) const MAX_STRUCTURED_SHARE: f64 = 0.6;
/// Cost of `unknown` against noise. Complete models leave no structure. A choice.
pub(crate) const UNKNOWN_OVER_NOISE_COST: f64 = 4.0;
/// Cost of `unknown` against a named cause. No law of the library is exact. A choice.
pub(crate) const UNKNOWN_OVER_NAMED_COST: f64 = 9.0;
/// Share of the explainable misfit above which a named cause becomes harder to doubt. A choice.
pub(crate) const MIN_EXPLAINED_SHARE: f64 = 0.5;
/// Additional cost of `unknown` per unit of the explained share above [`MIN_EXPLAINED_SHARE`]. A choice.
pub(crate) const EXPLAINED_SHARE_COST: f64 = 45.0;
/// Gain of a named cause above which the gain itself counts against `unknown`. Laws gained at most 2 in the first batches
/// where the effect was none of the library.
pub(crate) const MIN_COUNTED_GAIN: f64 = 4.0;
/// Part of [`MIN_EXPLAINED_SHARE`] below which the gain counts nothing. Two laws that fitted a foreign effect had gained 9
/// and 20 there.
pub(crate) const MIN_GAIN_COUNTING_PART: f64 = 0.8;
/// Share of named verdicts that are wrong although nothing speaks against them. Trials from seed 20000 on, rounded up: of
/// 27 later verdicts given 95 % all were right.
pub(crate) const NAMED_ERROR_SHARE: f64 = 0.05;
/// The same of the verdicts `none` and `unknown`. Of 16 later verdicts given 80 to 90 % all but one were right.
pub(crate) const UNNAMED_ERROR_SHARE: f64 = 0.15;
/// Further share of wrong names per unit of structured residual. Of 395 names 97 % were right without structure, 93 % up
/// to two fifths, 92 % up to three fifths, and seven of nine beyond. With the truth removed, half the names left a third or
/// more. The value follows if the library lacks the cause in one case of five.
pub(crate) const STRUCTURED_ERROR_SHARE: f64 = 0.4;
/// Part of a doubt that goes to causes that look alike; the rest goes to `unknown`. A choice.
pub(crate) const LOOK_ALIKE_DOUBT_PART: f64 = 0.5;
/// Power of the likelihood between causes that look alike. A choice.
pub(crate) const LOOK_ALIKE_POWER: f64 = 0.5;
/// Gain over the user's model from which a repair is written although structure remains. A choice.
pub(crate) const MIN_REPAIR_GAIN: f64 = 5.0;
/// Least probability with which another cause is reported. A choice.
pub(crate) const MIN_REPORTED_PROBABILITY: f64 = 0.005;

// ---- runs held out ----

/// Part of the confidence that remains where held-out runs do not improve. A choice.
pub(crate) const KEPT_IF_CONTRADICTED: f64 = 0.6;
/// Part that remains where they get worse by [`WORSENED_RATIO`]. Of eight such effects three were right.
pub(crate) const KEPT_IF_WORSENED: f64 = 0.4;
/// Ratio of held-out NMSE after and before a repair above which the runs count as worsened. A choice.
pub(crate) const WORSENED_RATIO: f64 = 1.5;
/// Reducible share of the held-out error that a repair removes if it predicts them. Of 16 names that removed less, but
/// some, 13 were right; of 8 with the truth taken out of the library, none.
pub(crate) const PREDICTED_SHARE: f64 = 0.8;
/// Reducible share below which a repair counts as contradicted. Same trials.
pub(crate) const FAILED_SHARE: f64 = 0.4;
/// Ratio of held-out NMSE and noise below which held-out runs cannot judge. A choice.
pub(crate) const MIN_HOLDOUT_SIGNAL_RATIO: f64 = 1.25;

// ---- structure of residuals ----

/// Points to which a residual is averaged in the search for structure. Mechanisms act on the scale of the motion. A choice.
pub(crate) const STRUCTURE_POINTS: usize = 1500;
/// Order of the noise that is removed before residuals are compared with the motion. A choice.
pub(crate) const STRUCTURE_NOISE_ORDER: usize = 2;
/// Order of the noise that is removed before bursts are sought. A choice.
pub(crate) const BURST_NOISE_ORDER: usize = 8;
/// Blocks of time for cross-validation of regressions. A choice.
pub(crate) const STRUCTURE_BLOCKS: usize = 6;
/// Samples that each regressor needs. A choice.
pub(crate) const SAMPLES_PER_REGRESSOR: usize = 8;
/// Ridge of a regression, in parts of the mean square of a regressor. A choice.
pub(crate) const REGRESSION_RIDGE: f64 = 1e-3;
/// Shifts of the channel that serve as regressors, samples. Neighbouring samples reveal a fault of its transfer. A choice.
pub(crate) const CHANNEL_SHIFTS: [isize; 9] = [-16, -8, -4, -2, 0, 2, 4, 8, 16];
/// Shifts of other channels' residuals that serve as regressors, samples. A choice.
pub(crate) const RESIDUAL_SHIFTS: [isize; 13] = [0, -1, 1, -2, 2, -3, 3, -4, 4, -5, 5, -6, 6];
/// Devices whose motion serves as regressors, each in one direction. A choice.
pub(crate) const REGRESSION_DEVICES: usize = 2;
/// Gaussian bumps along the deformation of a device that serve as regressors. A choice.
pub(crate) const DEFORMATION_BUMPS: usize = 24;
/// Residual power over the variance of its channel below which structure counts in proportion. A choice.
pub(crate) const NEGLIGIBLE_RESIDUAL: f64 = 1e-4;
/// Reweighted least-squares steps for noise that grows with its channel. A choice.
pub(crate) const VARIANCE_FIT_STEPS: usize = 20;
/// Least part of the noise power that does not grow with the channel. A choice.
pub(crate) const MIN_CONSTANT_VARIANCE: f64 = 1e-3;
/// Relative determinant below which the two parts of the variance are not separable. Round-off of double precision.
pub(crate) const SINGULAR_VARIANCE_FIT: f64 = 1e-12;

/// Stretches into which a record is cut for bursts. A choice.
pub(crate) const BURST_STRETCHES: usize = 40;
/// Samples that such a stretch needs. A choice.
pub(crate) const MIN_BURST_SAMPLES: usize = 8;
/// Power over the expected power from which a stretch is a burst. Noise of one level exceeds its median four times in none.
pub(crate) const BURST_POWER_RATIO: f64 = 4.0;

/// Samples of which a spectrum is taken at most, and needs at least. A choice.
pub(crate) const MAX_SPECTRUM_SAMPLES: usize = 8192;
pub(crate) const MIN_SPECTRUM_SAMPLES: usize = 64;
/// Power over the median around it from which a frequency is a line. Noise exceeds 25 times its median once in 3e7.
pub(crate) const LINE_POWER_RATIO: f64 = 25.0;
/// Least half width of the band around a line, frequencies. A choice.
pub(crate) const MIN_LINE_BAND: usize = 6;
/// Half width of the close band around a line, frequencies: narrow-band noise stands above its octave. A choice.
pub(crate) const LINE_BAND: usize = 24;
/// Frequencies on both sides to which a line itself reaches under a Hann window.
pub(crate) const LINE_SKIRT: usize = 2;
/// Cycles per record below which nothing is called a line. A choice.
pub(crate) const MIN_LINE_CYCLES: usize = 8;

/// Surrogate series with which a residual is compared. None may come near it.
pub(crate) const SURROGATES: usize = 99;
/// Standard deviations of the surrogates by which a residual must exceed their mean. A choice.
pub(crate) const SURROGATE_Z: f64 = 5.0;
/// Divisor of the record's length that gives each end of its cosine taper. A choice.
pub(crate) const TAPER_DIVISOR: usize = 20;
/// Numbers of stretches into which a record is cut for steadiness, coarse and fine. A choice.
pub(crate) const STEADINESS_STRETCHES: [usize; 4] = [6, 12, 24, 48];
/// Samples that such a stretch needs. A choice.
pub(crate) const MIN_STEADINESS_SAMPLES: usize = 8;
/// Divisor of the number of stretches that gives the quietest ones. A choice.
pub(crate) const QUIETEST_DIVISOR: usize = 4;

/// Cells along the stroke that resolve the error of another form of law. A choice.
pub(crate) const COARSE_STROKE_CELLS: usize = 12;
/// Cells that resolve changes within the stroke. A choice.
pub(crate) const FINE_STROKE_CELLS: [usize; 3] = [24, 48, 96];
/// Mean number of samples that a cell needs. A choice.
pub(crate) const SAMPLES_PER_CELL: usize = 4;

// ---- drift against slow noise ----

/// Points to which a residual is averaged. A choice.
pub(crate) const DRIFT_POINTS: usize = 512;
/// Points below which a drift is never distinguished from noise. A choice.
pub(crate) const MIN_DRIFT_POINTS: usize = 16;
/// Divisor of the record that gives the places at which a jump is tried. A choice.
pub(crate) const JUMP_PLACES: usize = 40;
/// Standard deviations of the surrogates by which a drift must exceed their mean: every channel and run is searched. A choice.
pub(crate) const DRIFT_Z: f64 = 4.0;
/// Lowest frequencies whose power gives the standard deviation of the mean of slow noise. A choice.
pub(crate) const MEAN_DEVIATION_FREQUENCIES: usize = 6;
/// Standard deviations of the mean above which a constant offset is no noise. A choice.
pub(crate) const OFFSET_Z: f64 = 5.0;
/// Least remaining share of a residual whose logarithm is taken.
pub(crate) const MIN_REMAINING_SHARE: f64 = 1e-12;

// ---- saturation of a channel ----

/// Difference of samples that count as equal, in parts of the channel's range. Digits of a file.
pub(crate) const EQUAL_SAMPLES: f64 = 1e-6;
/// Distance from an end that counts as near it, in parts of the channel's range. A choice.
pub(crate) const NEAR_END: f64 = 5e-3;
/// Samples at an end that saturation needs. A choice.
pub(crate) const MIN_SATURATED_SAMPLES: usize = 6;
/// Successive samples at an end that saturation needs. A choice.
pub(crate) const MIN_SATURATED_IN_A_ROW: usize = 4;
/// Samples at an end over those near it that saturation needs. A choice.
pub(crate) const MIN_SATURATED_OVER_NEAR: usize = 2;
/// Motion of the model meanwhile, in parts of the channel's range. A plateau of the motion is no saturation. A choice.
pub(crate) const MIN_MOTION_WHILE_SATURATED: f64 = 2e-3;
/// Distance within which a saturated level is the extreme of the recordings, in parts of the channel's range. A choice.
pub(crate) const SATURATED_EXTREME: f64 = 1e-3;

// ---- conditions and auxiliary channels ----

/// Difference of temperature below which runs have the same surroundings, degrees. A choice.
pub(crate) const MIN_TEMPERATURE_DIFFERENCE: f64 = 2.0;
/// Samples at the beginning of a run that give its ambient temperature. A choice.
pub(crate) const AMBIENT_SAMPLES: usize = 10;
/// Difference of axial loads, in parts of the largest, from which runs differ in load. A choice.
pub(crate) const MIN_AXIAL_LOAD_DIFFERENCE: f64 = 0.05;
/// Ratio of amplitudes from which runs differ in amplitude. Softening with amplitude exceeds the noise there. A choice.
pub(crate) const MIN_AMPLITUDE_RATIO: f64 = 3.0;
/// Deviation from one of a sampling interval that still counts samples, s. Digits of a file.
pub(crate) const COUNTED_INTERVAL_TOLERANCE: f64 = 1e-9;
/// Rise of temperature within a run that shows self-heating, degrees. A choice.
pub(crate) const MIN_TEMPERATURE_RISE: f64 = 3.0;
/// Points to which a recorded temperature is averaged. A choice.
pub(crate) const TEMPERATURE_POINTS: usize = 20;
/// Samples over which a recorded axial force is averaged. It follows the motion. A choice.
pub(crate) const AXIAL_FORCE_SAMPLES: usize = 5;
/// Standard deviation over mean from which an axial force varies. In trials 0.09 to 0.29 where it does.
pub(crate) const MIN_VARYING_AXIAL_FORCE: f64 = 0.05;
/// Standard deviation over mean up to which an axial force is constant. In trials 0.002 where it is.
pub(crate) const MAX_CONSTANT_AXIAL_FORCE: f64 = 0.02;

// ---- error of the time steps ----

/// Share of a residual's power that halved steps may move without consequence. A choice.
pub(crate) const NEGLIGIBLE_STEP_ERROR: f64 = 0.005;
/// Residual power over the variance of its channel below which the channel counts as reproduced. A choice.
pub(crate) const REPRODUCED_CHANNEL: f64 = 1e-4;
/// Largest number of parts into which a step is divided. A choice.
pub(crate) const MAX_STEP_PARTS: u32 = 8;
/// Ratio of successive moves above which shorter steps do not converge. A choice.
pub(crate) const MAX_STEP_ERROR_RATIO: f64 = 0.5;
