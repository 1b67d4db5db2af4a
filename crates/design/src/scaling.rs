//! Amplitude scaling of a suite to a target spectrum: one factor a motion or pair.

/// Scaled suite.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scaling {
    /// Factor of each motion or pair.
    pub factors: Vec<f64>,
    /// Root mean square of ln(scaled/target) of each.
    pub misfits: Vec<f64>,
    /// Mean of the scaled spectra over the target at each period.
    pub ratios: Vec<f64>,
    /// Factor common to the suite, which the rule on the least ratio asked for; contained in the factors.
    pub common: f64,
}

/// Factors that bring spectra close to a target: least squares of ln(s·spectrum/target) over the periods, which gives
/// ln s = mean of ln(target/spectrum). If the mean of the scaled spectra falls below `least` times the target at a period,
/// all factors are raised alike until it does not.
///
/// # Errors
/// There is no spectrum, the target has no value at a period, or a spectrum is zero.
pub fn scale(spectra: &[Vec<f64>], target: &[f64], least: Option<f64>) -> Result<Scaling, String> {
    if spectra.is_empty() || target.is_empty() {
        return Err("there is nothing to scale".into());
    }
    if target.iter().any(|t| !t.is_finite() || *t <= 0.0) {
        return Err("the target spectrum does not cover the periods of the scaling".into());
    }
    let mut out = Scaling { common: 1.0, ..Scaling::default() };
    for s in spectra {
        if s.iter().any(|x| *x <= 0.0 || !x.is_finite()) {
            return Err("a spectrum is zero at a period of the scaling".into());
        }
        let logs: Vec<f64> = target.iter().zip(s).map(|(t, s)| (t / s).ln()).collect();
        let mean = logs.iter().sum::<f64>() / logs.len() as f64;
        out.factors.push(mean.exp());
        out.misfits.push((logs.iter().map(|l| (l - mean).powi(2)).sum::<f64>() / logs.len() as f64).sqrt());
    }
    let n = spectra.len() as f64;
    let mean = |i: usize, factors: &[f64]| factors.iter().zip(spectra).map(|(f, s)| f * s[i]).sum::<f64>() / n;
    out.ratios = (0..target.len()).map(|i| mean(i, &out.factors) / target[i]).collect();
    let lowest = out.ratios.iter().copied().fold(f64::INFINITY, f64::min);
    if let Some(least) = least.filter(|l| lowest < *l) {
        out.common = least / lowest;
        out.factors.iter_mut().chain(&mut out.ratios).for_each(|x| *x *= out.common);
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::scale;

    #[test]
    fn factors_are_those_of_least_squares_in_logarithms() {
        let target = [1.0, 2.0, 4.0];
        let spectra = [vec![0.5, 1.0, 2.0], vec![1.0, 4.0, 4.0]];
        let s = scale(&spectra, &target, None).expect("a scaling");
        assert!((s.factors[0] - 2.0).abs() < 1e-12 && s.misfits[0] < 1e-12);
        // The sum of squares grows on both sides of the factor.
        let misfit = |f: f64| -> f64 { spectra[1].iter().zip(target).map(|(s, t)| (f * s / t).ln().powi(2)).sum() };
        let f = s.factors[1];
        assert!(misfit(f) < misfit(1.001 * f) && misfit(f) < misfit(0.999 * f));
        let raised = scale(&spectra, &target, Some(1.0)).expect("a scaling");
        let lowest = raised.ratios.iter().copied().fold(f64::INFINITY, f64::min);
        assert!((lowest - 1.0).abs() < 1e-12 && raised.common > 1.0);
        assert!(scale(&spectra, &[1.0, f64::NAN, 1.0], None).is_err() && scale(&[], &target, None).is_err());
    }
}
