//! Lines of a residual's spectrum: hum, a machine.

use crate::prior::{
    LINE_BAND, LINE_POWER_RATIO, LINE_SKIRT, MAX_SPECTRUM_SAMPLES, MIN_LINE_BAND, MIN_LINE_CYCLES, MIN_SPECTRUM_SAMPLES,
};
use crate::series::median;
use hysteron_identify::fourier::{Complex, forward};

/// Share of the power of a series in lines of its spectrum, and the frequency of the strongest line in cycles per sample.
///
/// Lines weaker than the `model` at the same frequency are errors of its motion and do not count.
pub(crate) fn line_share(x: &[f64], model: &[f64]) -> (f64, f64) {
    let n = x.len().min(MAX_SPECTRUM_SAMPLES);
    if n < MIN_SPECTRUM_SAMPLES {
        return (0.0, 0.0);
    }
    let spectrum_of = |x: &[f64]| {
        let mean = x[..n].iter().sum::<f64>() / n as f64;
        // A Hann window keeps the skirts of a line narrow.
        let windowed: Vec<f64> =
            (0..n).map(|t| (x[t] - mean) * (std::f64::consts::PI * t as f64 / n as f64).sin().powi(2)).collect();
        periodogram(&windowed)
    };
    let (spectrum, motion) = (spectrum_of(x), spectrum_of(model));
    let m = spectrum.len();
    let total: f64 = spectrum.iter().sum();
    if total <= 0.0 {
        return (0.0, 0.0);
    }
    let (mut share, mut strongest) = (0.0, (0.0, 0.0));
    for (i, p) in spectrum.iter().enumerate().skip(MIN_LINE_CYCLES) {
        // A line stands above an octave on both sides and above its close band. Broad noise falls with frequency, and
        // narrow-band noise stands above its octave.
        let octave_width = (i / 2).max(MIN_LINE_BAND);
        let band = octave_width.min(LINE_BAND);
        let (below, above) = (i - band.min(i)..i - LINE_SKIRT.min(i), i + LINE_SKIRT + 1..i + band + 1);
        let close_band = below.chain(above).filter(|k| *k < m);
        let octave = (i - octave_width.min(i)..i + octave_width).filter(|k| *k < m);
        let power_at = |k: usize| spectrum[k];
        let level = median(octave.map(power_at).collect()).max(median(close_band.map(power_at).collect()));
        let skirt = &motion[i - LINE_SKIRT.min(i)..(i + LINE_SKIRT + 1).min(m)];
        let of_model = skirt.iter().fold(0.0, |a: f64, p| a.max(*p));
        if *p > LINE_POWER_RATIO * level && *p > of_model {
            share += p / total;
            if *p > strongest.0 {
                strongest = (*p, i as f64 / n as f64);
            }
        }
    }
    (share, strongest.1)
}

/// |DFT|² at the frequencies from 0 to below one half per sample.
fn periodogram(x: &[f64]) -> Vec<f64> {
    let mut buffer: Vec<Complex<f64>> = x.iter().map(|x| Complex { re: *x, im: 0.0 }).collect();
    forward(buffer.len()).process(&mut buffer);
    buffer[..x.len() / 2].iter().map(Complex::norm_sqr).collect()
}

#[cfg(test)]
mod tests {
    use super::line_share;
    use crate::series::power;
    use crate::test_support::white_noise;

    #[test]
    fn a_line_is_found_in_noise_unless_the_model_has_it() {
        let mut x = white_noise(0, 4000);
        let still = vec![0.0; x.len()];
        assert!(line_share(&x, &still).0 < 0.02);
        x.iter_mut().enumerate().for_each(|(t, x)| *x += 1.5 * (0.7 * t as f64).sin());
        let (share, frequency) = line_share(&x, &still);
        let moving: Vec<f64> = (0..x.len()).map(|t| 3.0 * (0.7 * t as f64).cos()).collect();
        assert!(line_share(&x, &moving).0 < 0.02);
        assert!(share > 0.4 && (frequency - 0.7 / std::f64::consts::TAU).abs() < 1e-3, "{share} {frequency}");
    }

    #[test]
    fn narrow_band_noise_has_no_line() {
        let still = vec![0.0; 3000];
        let mut flagged = 0;
        for seed in 1..40 {
            let mut x = white_noise(seed, 3000);
            let band = 2.0 * 0.98 * 0.2f64.cos();
            (2..x.len()).for_each(|t| x[t] += band * x[t - 1] - 0.98 * 0.98 * x[t - 2]);
            let without = line_share(&x, &still).0;
            flagged += usize::from(without > 0.01);
            // A machine that goes on and off beside it is found.
            let size = power(&x).sqrt();
            let hum = |t: usize| if t % 800 < 400 { (0.9 * t as f64).sin() } else { 0.0 };
            x.iter_mut().enumerate().for_each(|(t, x)| *x += size * hum(t));
            let with = line_share(&x, &still).0;
            assert!(with - without > 0.05, "{seed} {with} {without}");
        }
        assert!(flagged < 5, "{flagged}");
    }
}
