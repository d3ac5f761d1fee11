//! Exact rational numbers as `Copy` values.

use crate::{Base, Over, Scalar};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;
use num_traits::{One, Zero};
use rustc_hash::FxHashMap;
use std::cell::RefCell;
use std::fmt;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

/// A fraction of integers of any size, in lowest terms. Division by zero gives [`Rational::UNDEFINED`], which
/// propagates through every operation and is not equal to anything, including itself.
///
/// Values whose numerator and denominator fit in 63 bits are stored directly. Larger ones are interned and live as long
/// as the program: exact points and counterexamples are few, and a `Copy` type can be used by all laws.
#[derive(Clone, Copy)]
pub struct Rational(Repr);

#[derive(Clone, Copy)]
enum Repr {
    Small { numerator: i64, denominator: i64 },
    Large(&'static RBig),
    Undefined,
}

use Repr::{Large, Small, Undefined};

/// An operation on two fractions [numerator, denominator] in machine integers; `None` on overflow.
type InPlace = fn([i128; 2], [i128; 2]) -> Option<(i128, i128)>;

impl Rational {
    /// The result of a division by zero.
    pub const UNDEFINED: Rational = Rational(Undefined);

    /// `numerator / denominator`; undefined where the denominator is zero.
    pub fn new(numerator: i64, denominator: i64) -> Self {
        Self::reduced(i128::from(numerator), i128::from(denominator))
    }

    /// The exact value of a float; undefined for infinities and NaN.
    pub fn exactly(value: f64) -> Self {
        RBig::try_from(value).map_or(Self::UNDEFINED, Self::from)
    }

    /// The shortest decimal that is read as this float: 1/10 for 0.1, not the binary fraction next to it. Undefined for
    /// infinities and NaN.
    pub fn decimal(value: f64) -> Self {
        if !value.is_finite() {
            return Self::UNDEFINED;
        }
        let text = format!("{value:e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let places = digits.split_once('.').map_or(0, |(_, fraction)| fraction.len());
        let (Ok(whole), Ok(exponent)) = (digits.replace('.', "").parse::<IBig>(), exponent.parse::<i64>()) else {
            return Self::UNDEFINED;
        };
        let shift = exponent - places as i64;
        // a float has at most a few hundred decimal places
        let power = UBig::from(10u8).pow(shift.unsigned_abs() as usize);
        match shift < 0 {
            true => Self::from(RBig::from_parts(whole, power)),
            false => Self::from(RBig::from(whole * IBig::from(power))),
        }
    }

    /// Whether the value is not [`Rational::UNDEFINED`].
    pub fn is_defined(self) -> bool {
        !matches!(self.0, Undefined)
    }

    /// The value with big integers; `None` where undefined.
    pub fn to_big(self) -> Option<RBig> {
        match self.0 {
            Small { numerator, denominator } => {
                Some(RBig::from_parts(IBig::from(numerator), UBig::from(denominator.unsigned_abs())))
            }
            Large(big) => Some(big.clone()),
            Undefined => None,
        }
    }

    /// The nearest `f64`; NaN where undefined. For display and plausibility checks only.
    pub fn to_f64(self) -> f64 {
        self.to_big().map_or(f64::NAN, |big| big.to_f64().value())
    }

    /// The sign: -1, 0 or 1; `None` where undefined.
    pub fn sign(self) -> Option<i32> {
        match self.0 {
            Small { numerator, .. } => Some(numerator.signum() as i32),
            Large(big) => Some(if *big.numerator() < IBig::ZERO { -1 } else { 1 }),
            Undefined => None,
        }
    }

    fn reduced(numerator: i128, denominator: i128) -> Self {
        if denominator == 0 {
            return Self::UNDEFINED;
        }
        let divisor = gcd(numerator.unsigned_abs(), denominator.unsigned_abs()) as i128;
        let sign = denominator.signum();
        let (n, d) = (sign * (numerator / divisor), sign * (denominator / divisor));
        match (i64::try_from(n), i64::try_from(d)) {
            (Ok(numerator), Ok(denominator)) => Rational(Small { numerator, denominator }),
            _ => Self::from(RBig::from_parts_signed(IBig::from(n), IBig::from(d))),
        }
    }

    fn combine(self, b: Self, small: InPlace, big: fn(RBig, RBig) -> RBig) -> Self {
        if let (Small { numerator: a, denominator: p }, Small { numerator: b, denominator: q }) = (self.0, b.0)
            && let Some((n, d)) = small([a.into(), p.into()], [b.into(), q.into()])
        {
            return Self::reduced(n, d);
        }
        match (self.to_big(), b.to_big()) {
            (Some(a), Some(b)) => Self::from(big(a, b)),
            _ => Self::UNDEFINED,
        }
    }
}

impl From<RBig> for Rational {
    fn from(value: RBig) -> Self {
        if let (Ok(numerator), Ok(denominator)) = (i64::try_from(value.numerator()), i64::try_from(value.denominator()))
        {
            return Rational(Small { numerator, denominator });
        }
        thread_local! {
            static LARGE: RefCell<FxHashMap<RBig, &'static RBig>> = RefCell::default();
        }
        LARGE.with_borrow_mut(|table| {
            if let Some(known) = table.get(&value) {
                return Rational(Large(known));
            }
            let kept: &'static RBig = Box::leak(Box::new(value.clone()));
            table.insert(value, kept);
            Rational(Large(kept))
        })
    }
}

/// The greatest common divisor by Euclid's algorithm; 1 for two zeros, so that the caller may divide by it.
fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

impl PartialEq for Rational {
    fn eq(&self, other: &Self) -> bool {
        match (self.0, other.0) {
            (Small { numerator: a, denominator: p }, Small { numerator: b, denominator: q }) => a == b && p == q,
            (Large(a), Large(b)) => a == b,
            _ => false,
        }
    }
}

impl Add for Rational {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        self.combine(
            b,
            |[a, p], [b, q]| Some((a.checked_mul(q)?.checked_add(b.checked_mul(p)?)?, p.checked_mul(q)?)),
            |a, b| a + b,
        )
    }
}

impl Sub for Rational {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for Rational {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        self.combine(b, |[a, p], [b, q]| Some((a.checked_mul(b)?, p.checked_mul(q)?)), |a, b| a * b)
    }
}

impl Div for Rational {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        if b.is_zero() {
            return Self::UNDEFINED;
        }
        self.combine(b, |[a, p], [b, q]| Some((a.checked_mul(q)?, p.checked_mul(b)?)), |a, b| a / b)
    }
}

/// In a field every remainder is zero.
impl Rem for Rational {
    type Output = Self;
    fn rem(self, b: Self) -> Self {
        if b.is_zero() { Self::UNDEFINED } else { Self::zero() }
    }
}

impl Neg for Rational {
    type Output = Self;
    fn neg(self) -> Self {
        match self.0 {
            Small { numerator, denominator } => Self::reduced(-i128::from(numerator), denominator.into()),
            Large(big) => Self::from(-big.clone()),
            Undefined => self,
        }
    }
}

macro_rules! assign {
    ($($op:ident $method:ident $sign:tt),*) => {$(
        impl $op for Rational {
            fn $method(&mut self, b: Self) {
                *self = *self $sign b;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /, RemAssign rem_assign %);

impl Zero for Rational {
    fn zero() -> Self {
        Rational(Small { numerator: 0, denominator: 1 })
    }

    fn is_zero(&self) -> bool {
        matches!(self.0, Small { numerator: 0, .. })
    }
}

impl One for Rational {
    fn one() -> Self {
        Rational(Small { numerator: 1, denominator: 1 })
    }
}

impl Scalar for Rational {
    const CALLS: bool = true;

    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::new(numerator, denominator)
    }
}

impl Base for Rational {}

impl Over<Rational> for Rational {
    fn lift(parameter: Rational) -> Self {
        parameter
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Small { numerator, denominator: 1 } => write!(f, "{numerator}"),
            Small { numerator, denominator } => write!(f, "{numerator}/{denominator}"),
            Large(big) => write!(f, "{big}"),
            Undefined => write!(f, "undefined"),
        }
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}
