//! Exponential and logarithm for lanes of vector instructions.
//!
//! The functions have no branches and no calls, so that the compiler evaluates several numbers at once. Products and
//! sums are fused, which every processor does to the same bits: one without the instruction calls the C library.
//! They belong inside [`super::lanes::in_lanes`], where the instruction is known to the compiler. Reductions and coefficients are those of fdlibm (Sun
//! Microsystems, 1993: `e_log.c`, `e_exp.c`); the errors are below two units in the last place.

const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
/// Bits of the largest fraction below the root of two, which bounds the reduced argument of the logarithm.
const ROOT_2_BITS: u64 = 0x3FE6_A09E_667F_3BCD;
/// 2⁵² + 2⁵¹: added to a number, it leaves the nearest integer in the last bits.
const INTEGER_MAGIC: f64 = 6_755_399_441_055_744.0;
/// Coefficients of the logarithm, of the powers of s².
const LN_SERIES: [f64; 7] = [
    6.666_666_666_666_735e-1,
    3.999_999_999_940_942e-1,
    2.857_142_874_366_239e-1,
    2.222_219_843_214_978_4e-1,
    1.818_357_216_161_805e-1,
    1.531_383_769_920_937_3e-1,
    1.479_819_860_511_658_6e-1,
];
/// Coefficients of the exponential, of the powers of r².
const EXP_SERIES: [f64; 5] = [
    1.666_666_666_666_660_2e-1,
    -2.777_777_777_701_559_3e-3,
    6.613_756_321_437_934e-5,
    -1.653_390_220_546_525_2e-6,
    4.138_136_797_057_238_5e-8,
];
/// Argument beyond which the exponential is taken at the limit itself.
const EXP_LIMIT: f64 = 708.0;

/// Natural logarithm of a positive normal number.
#[inline(always)]
pub(crate) fn ln(x: f64) -> f64 {
    // x = 2^k (1 + f), with 1 + f between √½ and √2.
    let shifted = x.to_bits().wrapping_sub(ROOT_2_BITS);
    let exponent = (shifted as i64) >> 52;
    let fraction = f64::from_bits(x.to_bits().wrapping_sub((exponent as u64) << 52));
    let k = f64::from_bits((INTEGER_MAGIC.to_bits() as i64).wrapping_add(exponent) as u64) - INTEGER_MAGIC;
    let f = fraction - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let w = z * z;
    let even = w * w.mul_add(w.mul_add(LN_SERIES[5], LN_SERIES[3]), LN_SERIES[1]);
    let odd = z * w.mul_add(w.mul_add(w.mul_add(LN_SERIES[6], LN_SERIES[4]), LN_SERIES[2]), LN_SERIES[0]);
    let half_square = 0.5 * f * f;
    let correction = s.mul_add(half_square + (even + odd), k * LN_2_LOW);
    k.mul_add(LN_2_HIGH, -((half_square - correction) - f))
}

/// Exponential; arguments beyond ±708 count as ±708.
#[inline(always)]
pub(crate) fn exp(x: f64) -> f64 {
    let x = if x > EXP_LIMIT { EXP_LIMIT } else { x };
    let x = if x < -EXP_LIMIT { -EXP_LIMIT } else { x };
    let rounded = x.mul_add(std::f64::consts::LOG2_E, INTEGER_MAGIC);
    let k = rounded - INTEGER_MAGIC;
    let (high, low) = (k.mul_add(-LN_2_HIGH, x), k * LN_2_LOW);
    let r = high - low;
    let t = r * r;
    let [p1, p2, p3, p4, p5] = EXP_SERIES;
    let c = (-t).mul_add(t.mul_add(t.mul_add(t.mul_add(t.mul_add(p5, p4), p3), p2), p1), r);
    let y = 1.0 - ((low - (r * c) / (2.0 - c)) - high);
    f64::from_bits(y.to_bits().wrapping_add(rounded.to_bits() << 52))
}

/// Power of a non-negative normal number or zero, with a positive exponent.
#[inline(always)]
pub(crate) fn power(x: f64, exponent: f64) -> f64 {
    if x == 0.0 { 0.0 } else { exp(exponent * ln(x)) }
}

#[cfg(test)]
mod tests {
    use super::{exp, ln, power};

    #[test]
    fn they_agree_with_the_standard_library() {
        for i in 1..200_000 {
            let x = 1e-8 * 1.0002_f64.powi(i);
            assert!((ln(x) - x.ln()).abs() <= 4.5e-16 * x.ln().abs().max(1e-3), "ln {x}");
            let y = (f64::from(i) - 1e5) * 7e-3;
            assert!((exp(y) - y.exp()).abs() <= 4.5e-16 * y.exp(), "exp {y}");
            let r = 0.5 + 1e-4 * f64::from(i);
            let base = 0.2 + 1e-5 * f64::from(i);
            let exact = base.powf(r);
            assert!((power(base, r) - exact).abs() <= 5e-15 * exact, "{base} to {r}");
        }
        assert_eq!(power(0.0, 3.0), 0.0);
        assert_eq!(exp(0.0), 1.0);
        assert_eq!(ln(1.0), 0.0);
    }
}
