//! Errors before and after a repair, beside the noise of the recordings.

use super::quantity::digits;
use super::summary::{SummaryContext, percent, variance};

/// Share of the error above the noise that the repair takes away, and what it leaves. Empty where the noise is not known, or
/// hides the error.
fn share_above_noise(c: &SummaryContext<'_>) -> String {
    let Some(noise) = c.uncertainty.and_then(|u| u.judgement.noise) else { return String::new() };
    let share = |before: f64, after: f64, noise: f64| {
        let is_visible = before > MIN_ERROR_OVER_NOISE * noise;
        is_visible.then(|| percent(((before - after) / (before - noise)).clamp(0.0, 1.0)))
    };
    let (b, r) = (c.baseline, c.corrected);
    let Some(fitted) = share(b.fit_nmse, r.fit_nmse, noise.noise) else { return String::new() };
    let held_out = b.holdout_nmse.zip(r.holdout_nmse).zip(noise.holdout_noise);
    let of_held_out = held_out.and_then(|((before, after), noise)| share(before, after, noise));
    let of_held_out = of_held_out.map_or_else(String::new, |share| format!(", {share} of that of the held-out ones"));
    let noise = digits(noise.noise, 2);
    format!(" It takes {fitted} of the fitted error above the noise (NMSE {noise}){of_held_out}.")
}

/// Error over the noise below which no share of it is told. A choice.
const MIN_ERROR_OVER_NOISE: f64 = 1.5;

/// Errors before and after the repair, with the share of the error above the noise.
pub(super) fn gain(c: &SummaryContext<'_>) -> String {
    errors(c) + &share_above_noise(c)
}

/// Errors before and after the repair.
fn errors(c: &SummaryContext<'_>) -> String {
    let (b, r) = (c.baseline, c.corrected);
    let change = |before: f64, after: f64| {
        let first = variance(before).replace(" of the variance", "");
        format!("from {first} to {} (NMSE {} to {})", variance(after), digits(before, 2), digits(after, 2))
    };
    match b.holdout_nmse.zip(r.holdout_nmse) {
        Some((before, after)) => format!(
            "The error of the runs held out {} {}; that of the fitted runs from {} to {}.",
            verb(before, after),
            change(before, after),
            digits(b.fit_nmse, 2),
            digits(r.fit_nmse, 2)
        ),
        None => format!(
            "The error of the fitted runs {} {}. No run was held out to check it.",
            verb(b.fit_nmse, r.fit_nmse),
            change(b.fit_nmse, r.fit_nmse)
        ),
    }
}

fn verb(before: f64, after: f64) -> &'static str {
    if after < before { "falls" } else { "rises" }
}
