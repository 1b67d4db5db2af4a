//! Math functions, in expressions and as commands `tcl::mathfunc::…`.

use num_bigint::BigInt;
use num_traits::{FromPrimitive as _, Signed as _, ToPrimitive as _};

use super::super::command::Call;
use super::super::core::Core;
use super::super::error::Exception;
use super::super::number::{Number, big_to_f64};
use super::super::value::Value;
use super::arith::{big, compare_numbers, domain_error};

type Real = fn(f64) -> f64;

/// Functions of one real number.
const REAL: [(&str, Real); 15] = [
    ("acos", f64::acos),
    ("asin", f64::asin),
    ("atan", f64::atan),
    ("ceil", f64::ceil),
    ("cos", f64::cos),
    ("cosh", f64::cosh),
    ("exp", f64::exp),
    ("floor", f64::floor),
    ("log", f64::ln),
    ("log10", f64::log10),
    ("sin", f64::sin),
    ("sinh", f64::sinh),
    ("sqrt", f64::sqrt),
    ("tan", f64::tan),
    ("tanh", f64::tanh),
];

type Real2 = fn(f64, f64) -> f64;

/// Functions of two.
const REAL2: [(&str, Real2); 4] =
    [("atan2", f64::atan2), ("fmod", |x, y| x % y), ("hypot", f64::hypot), ("pow", f64::powf)];

/// The others, with the least and greatest number of arguments.
const OTHER: [(&str, usize, usize); 12] = [
    ("abs", 1, 1),
    ("bool", 1, 1),
    ("double", 1, 1),
    ("entier", 1, 1),
    ("int", 1, 1),
    ("isqrt", 1, 1),
    ("max", 1, usize::MAX),
    ("min", 1, usize::MAX),
    ("rand", 0, 0),
    ("round", 1, 1),
    ("srand", 1, 1),
    ("wide", 1, 1),
];

/// The names of all functions.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    REAL.iter().map(|f| f.0).chain(REAL2.iter().map(|f| f.0)).chain(OTHER.iter().map(|f| f.0))
}

/// A function that gives a number for numbers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Known {
    /// Its result is checked at once.
    Real(Real),
    Real2(Real2),
    Root,
    Abs,
    Double,
    Int,
    Max,
    Min,
    Round,
}

/// The function that a name means, if it is one of these.
pub(super) fn known(name: &str) -> Option<Known> {
    let other = match name {
        "sqrt" => Known::Root,
        "abs" => Known::Abs,
        "double" => Known::Double,
        "int" => Known::Int,
        "max" => Known::Max,
        "min" => Known::Min,
        "round" => Known::Round,
        _ => {
            let real = REAL.iter().find(|f| f.0 == name).map(|f| Known::Real(f.1));
            return real.or_else(|| REAL2.iter().find(|f| f.0 == name).map(|f| Known::Real2(f.1)));
        }
    };
    Some(other)
}

/// The command behind each of `tcl::mathfunc::…`.
pub(crate) fn command(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let name = call.name();
    let name = name.rsplit("::").next().unwrap_or_default();
    let value = self::call(core, name, call.args())?;
    Ok(match value.number() {
        Some(Number::Double(d)) => core.double(d),
        _ => value,
    })
}

/// Call a function.
pub(crate) fn call(core: &mut Core, name: &str, args: &[Value]) -> Result<Value, Exception> {
    let count = |least: usize, most: usize| match args.len() {
        n if n < least => Err(wrong_count("not enough", name)),
        n if n > most => Err(wrong_count("too many", name)),
        _ => Ok(()),
    };
    if let Some((_, f)) = REAL.iter().find(|f| f.0 == name) {
        count(1, 1)?;
        let [x] = args else { return Err(wrong_count("not enough", name)) };
        // Of these the square root alone may be no number, which is told when it is used, or at the end.
        return Ok(Value::from(match (x.number(), name) {
            (Some(Number::Big(b)), "floor" | "ceil") => round_big(&b, name == "ceil"),
            (_, "sqrt") => f(real(x)?),
            _ => return finite(f(real(x)?)),
        }));
    }
    if let Some((_, f)) = REAL2.iter().find(|f| f.0 == name) {
        count(2, 2)?;
        let [x, y] = args else { return Err(wrong_count("not enough", name)) };
        return finite(f(real(x)?, real(y)?));
    }
    let Some((_, least, most)) = OTHER.iter().find(|f| f.0 == name) else {
        return Err(Exception::error(format!("unknown math function \"{name}\"")));
    };
    count(*least, *most)?;
    match (name, args) {
        ("rand", _) => Ok(Value::from(core.next_random())),
        ("max" | "min", args) => extreme(args, name == "max"),
        (_, [x]) => one(core, name, x),
        _ => Err(wrong_count("not enough", name)),
    }
}

fn wrong_count(what: &str, name: &str) -> Exception {
    if matches!(name, "max" | "min") {
        return Exception::error(format!("{what} arguments to math function \"{name}\""));
    }
    Exception::coded(format!("{what} arguments for math function \"{name}\""), &["TCL", "WRONGARGS"])
}

/// The nearest double not above an integer, or not below it.
fn round_big(big: &BigInt, up: bool) -> f64 {
    let near = big_to_f64(big);
    match BigInt::from_f64(near) {
        Some(whole) if up && whole < *big => near.next_up(),
        Some(whole) if !up && whole > *big => near.next_down(),
        _ => near,
    }
}

pub(super) fn finite(d: f64) -> Result<Value, Exception> {
    if d.is_nan() { Err(domain_error()) } else { Ok(Value::from(d)) }
}

fn real(value: &Value) -> Result<f64, Exception> {
    value.to_f64()
}

fn one(core: &mut Core, name: &str, x: &Value) -> Result<Value, Exception> {
    match name {
        "abs" => Ok(match number(x)? {
            Number::Double(d) => Value::from(d.abs()),
            Number::Int(i) if i != i64::MIN => Value::from(i.abs()),
            n => Value::from(big(&n).abs()),
        }),
        "bool" => x.to_bool().map(Value::from),
        "double" => real(x).map(Value::from),
        "entier" => whole(x).map(Value::from),
        "int" | "wide" => {
            let whole = whole(x)?;
            // The low 64 bits, as in C.
            let low = whole.to_i64().unwrap_or_else(|| {
                let mask = BigInt::from(u64::MAX);
                (whole & mask).to_u64().unwrap_or_default() as i64
            });
            Ok(Value::from(low))
        }
        "isqrt" => {
            let whole = whole(x)?;
            if whole.is_negative() {
                let text = "square root of negative argument";
                return Err(Exception::coded(text, &["ARITH", "DOMAIN", "domain error: argument not in valid range"]));
            }
            Ok(Value::from(whole.sqrt()))
        }
        "round" => match number(x)? {
            Number::Double(d) => from_double(d.round()).map(Value::from),
            n => Ok(n.into()),
        },
        _ => {
            let seed = match x.to_integer()? {
                Number::Int(i) => i,
                n => (big(&n) & BigInt::from(u32::MAX)).to_i64().unwrap_or_default(),
            };
            Ok(Value::from(core.seed_random(seed)))
        }
    }
}

fn number(x: &Value) -> Result<Number, Exception> {
    match x.number() {
        Some(Number::Double(d)) if d.is_nan() => real(x).map(Number::Double),
        Some(n) => Ok(n),
        None => Err(x.not_a("number")),
    }
}

/// Without the fraction.
fn whole(x: &Value) -> Result<BigInt, Exception> {
    match x.number() {
        Some(Number::Double(d)) if !d.is_nan() => from_double(d.trunc()),
        Some(Number::Double(_)) => Err(real(x).err().unwrap_or_else(domain_error)),
        Some(n) => Ok(big(&n)),
        None => Err(x.not_a("number")),
    }
}

fn from_double(d: f64) -> Result<BigInt, Exception> {
    BigInt::from_f64(d).ok_or_else(|| {
        let text = "integer value too large to represent";
        Exception::coded(text, &["ARITH", "IOVERFLOW", text])
    })
}

fn extreme(args: &[Value], greatest: bool) -> Result<Value, Exception> {
    let mut best: Option<Number> = None;
    for arg in args {
        let n = number(arg).map_err(|_| {
            Exception::error(match arg.number() {
                Some(_) => "floating point value is Not a Number".to_owned(),
                None => format!("expected floating-point number but got \"{arg}\""),
            })
        })?;
        let better = match &best {
            None => true,
            Some(b) => {
                let order = compare_numbers(&n, b);
                order.is_some_and(|o| if greatest { o.is_gt() } else { o.is_lt() })
            }
        };
        if better {
            best = Some(n);
        }
    }
    Ok(best.map(Value::from).unwrap_or_default())
}

/// Seed of `rand` without `srand`. Tcl takes the clock, but a run must be repeatable.
const FIRST_SEED: i64 = 20_240_101;

impl Core {
    fn seed_random(&mut self, seed: i64) -> f64 {
        let seed = seed & 0x7fff_ffff;
        self.seed = Some(if seed == 0 || seed == 0x7fff_ffff { seed ^ 123_459_876 } else { seed });
        self.next_random()
    }

    /// The "minimal standard" generator of Park and Miller, as Tcl has it.
    fn next_random(&mut self) -> f64 {
        let (a, m, q, r) = (16807, 2_147_483_647_i64, 127_773, 2836);
        let old = self.seed.unwrap_or(FIRST_SEED);
        let quotient = old / q;
        let mut seed = a * (old - quotient * q) - r * quotient;
        if seed < 0 {
            seed += m;
        }
        self.seed = Some(seed);
        seed as f64 * (1.0 / m as f64)
    }
}
