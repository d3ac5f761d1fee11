//! Every scalar type satisfies the axioms of a field and the identities of the circle: exactly if it is exact,
//! otherwise up to a few units of its rounding.

use field::laws::{analytic_laws, circle_laws, field_laws};
use field::{Analytic, Batch, Circle, DoubleDouble, Over, Rational, Scalar, Tangent};
use num_dual::{Dual, Dual2, DualSVec, HyperDual};
use num_traits::{One, Zero};
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestCaseError};
use symbolic::{Hypotheses, Sym, symbols};

fn fixed(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, rng_seed: RngSeed::Fixed(1743), failure_persistence: None, ..ProptestConfig::default() }
}

/// A scalar type with rounding, with up to four derivatives.
trait Rounded: Scalar {
    /// The distance from 1 to the next larger number.
    const EPSILON: f64 = f64::EPSILON;

    /// A number from a value and derivatives (or low-order digits).
    fn from_parts(parts: [f64; 5]) -> Self;

    /// The absolute value of the largest component.
    fn size(self) -> f64;
}

fn largest(parts: impl IntoIterator<Item = f64>) -> f64 {
    parts.into_iter().map(f64::abs).fold(0.0, f64::max)
}

impl Rounded for f64 {
    fn from_parts([value, ..]: [f64; 5]) -> Self {
        value
    }
    fn size(self) -> f64 {
        self.abs()
    }
}

impl Rounded for DoubleDouble {
    const EPSILON: f64 = f64::EPSILON * f64::EPSILON / 2.0;

    fn from_parts([value, low, ..]: [f64; 5]) -> Self {
        DoubleDouble::from(value) + DoubleDouble::from(low * f64::EPSILON)
    }
    fn size(self) -> f64 {
        self.hi().abs()
    }
}

impl<const FUSED: bool> Rounded for Batch<5, FUSED> {
    fn from_parts(parts: [f64; 5]) -> Self {
        // away from zero, like the values of the other types
        Batch(parts.map(|part| part + 1.0_f64.copysign(part)))
    }
    fn size(self) -> f64 {
        largest(self.0)
    }
}

impl Rounded for Dual<f64> {
    fn from_parts([value, d, ..]: [f64; 5]) -> Self {
        Dual::new(value, d)
    }
    fn size(self) -> f64 {
        largest([self.re, self.eps])
    }
}

impl Rounded for Dual2<f64> {
    fn from_parts([value, d, dd, ..]: [f64; 5]) -> Self {
        Dual2::new(value, d, dd)
    }
    fn size(self) -> f64 {
        largest([self.re, self.v1, self.v2])
    }
}

impl Rounded for HyperDual<f64> {
    fn from_parts([value, d, e, de, _]: [f64; 5]) -> Self {
        HyperDual::new(value, d, e, de)
    }
    fn size(self) -> f64 {
        largest([self.re, self.eps1, self.eps2, self.eps1eps2])
    }
}

impl Rounded for DualSVec<f64, 4> {
    fn from_parts([value, slopes @ ..]: [f64; 5]) -> Self {
        DualSVec::new(value, num_dual::Derivative::some(slopes.into()))
    }
    fn size(self) -> f64 {
        let slopes = self.eps.unwrap_generic(nalgebra::Const::<4>, nalgebra::Const::<1>);
        largest(slopes.iter().copied().chain([self.re]))
    }
}

impl<S: Rounded> Rounded for Tangent<S> {
    const EPSILON: f64 = S::EPSILON;

    fn from_parts([value, d, e, de, _]: [f64; 5]) -> Self {
        let part = |value, slope| S::from_parts([value, slope, 0.0, 0.0, 0.0]);
        Tangent::moving(part(value, e), part(d, de))
    }
    fn size(self) -> f64 {
        largest([self.value.size(), self.slope.size()])
    }
}

/// A value of absolute value between 1 and 2, and derivatives of absolute value up to 1.
fn number() -> impl Strategy<Value = [f64; 5]> {
    let d = || -1.0..1.0f64;
    ([d(), d(), d(), d()], 1.0..2.0f64, any::<bool>())
        .prop_map(|([d, e, de, f], size, negative)| [if negative { -size } else { size }, d, e, de, f])
}

/// For such numbers no intermediate term exceeds 2^9, second derivatives included. Hence 2^12 units correspond to a few
/// roundings of the largest term.
fn agree<S: Rounded>(laws: Vec<(&str, S, S)>) -> Result<(), TestCaseError> {
    for (law, left, right) in laws {
        let off = (left - right).size() / S::EPSILON;
        prop_assert!(off <= 4096.0, "{law}: {left:?} and {right:?} differ by {off} units of rounding");
    }
    Ok(())
}

macro_rules! to_rounding {
    ($($test:ident: $field:ty;)*) => {
        proptest! {
            #![proptest_config(fixed(256))]
            $(
                #[test]
                fn $test(numbers in [number(), number(), number()]) {
                    let [a, b, c] = numbers.map(<$field>::from_parts);
                    agree(field_laws(a, b, c))?;
                    agree(circle_laws(a, b))?;
                    agree(analytic_laws(a * a, b * b))?;
                }
            )*
        }
    };
}

to_rounding! {
    double_precision_is_a_field_to_rounding: f64;
    double_double_is_a_field_to_its_own_rounding: DoubleDouble;
    lanes_are_a_field_to_rounding: Batch<5>;
    lanes_that_round_a_product_and_a_sum_once_are_a_field_to_rounding: Batch<5, true>;
    tangents_of_lanes_are_a_field_to_rounding: Tangent<Batch<5>>;
    dual_numbers_are_a_field_to_rounding: Dual<f64>;
    second_order_dual_numbers_are_a_field_to_rounding: Dual2<f64>;
    hyper_dual_numbers_are_a_field_to_rounding: HyperDual<f64>;
    dual_vectors_are_a_field_to_rounding: DualSVec<f64, 4>;
    tangents_are_a_field_to_rounding: Tangent<f64>;
    tangents_of_tangents_are_a_field_to_rounding: Tangent<Tangent<f64>>;
    tangents_of_double_double_are_a_field_to_its_rounding: Tangent<DoubleDouble>;
}

/// Fractions that fit into machine integers, and some that do not: up to four digits of magnitude 2^62 in numerator and
/// denominator.
fn rational() -> impl Strategy<Value = Rational> {
    let small = (-60..60i64, 1..60i64).prop_map(|(n, d)| Rational::new(n, d));
    let digits = || prop::collection::vec(1 << 61..i64::MAX, 0..4);
    let product = |digits: Vec<i64>| digits.into_iter().fold(Rational::one(), |product, n| product * Rational::int(n));
    let large = (digits(), digits(), any::<bool>())
        .prop_map(move |(n, d, negative)| product(n) / product(d) * Rational::int(if negative { -1 } else { 1 }));
    prop_oneof![small, large].prop_filter("different from zero", |x| !x.is_zero())
}

fn tangent() -> impl Strategy<Value = Tangent<Rational>> {
    (rational(), rational()).prop_map(|(value, slope)| Tangent::moving(value, slope))
}

fn exactly<S: Scalar>(laws: Vec<(&str, S, S)>) -> Result<(), TestCaseError> {
    for (law, left, right) in laws {
        prop_assert!(left == right, "{law}: {left:?} and {right:?}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(fixed(256))]

    #[test]
    fn rationals_of_any_size_are_a_field_exactly(a in rational(), b in rational(), c in rational()) {
        exactly(field_laws(a, b, c))?;
        exactly(circle_laws(a, b))?;
    }

    #[test]
    fn tangents_of_rationals_are_a_field_exactly(a in tangent(), b in tangent(), c in tangent()) {
        exactly(field_laws(a, b, c))?;
        exactly(circle_laws(a, b))?;
    }

    #[test]
    fn nested_tangents_of_rationals_are_a_field_exactly(numbers in [tangent(), tangent(), tangent()], d in tangent()) {
        let [a, b, c] = numbers.map(|value| Tangent::moving(value, d * value + d));
        exactly(field_laws(a, b, c))?;
        exactly(circle_laws(a, b))?;
    }

    #[test]
    fn a_rational_has_the_sign_and_nearly_the_value_of_its_double(a in rational(), b in rational()) {
        let (sum, product) = ((a + b).to_f64(), (a * b).to_f64());
        prop_assert!((sum - (a.to_f64() + b.to_f64())).abs() <= 4.0 * f64::EPSILON * (a.to_f64().abs() + b.to_f64().abs()));
        prop_assert!((product - a.to_f64() * b.to_f64()).abs() <= 4.0 * f64::EPSILON * product.abs());
        prop_assert_eq!(a.sign(), Some(a.to_f64().signum() as i32));
    }

    #[test]
    fn division_by_zero_is_undefined_and_absorbs_everything(a in rational()) {
        let undefined = a / Rational::zero();
        let with_it = [
            undefined, -undefined, undefined + a, a + undefined, undefined - a, a - undefined, undefined * a,
            a * undefined, undefined / a, a / undefined, undefined * Rational::zero(), Rational::zero() / undefined,
            undefined - undefined, a % Rational::zero(), undefined.half(), undefined.squared(),
        ];
        for result in with_it {
            prop_assert!(!result.is_defined());
            prop_assert!(result != result && result != a && !result.is_zero() && result.to_f64().is_nan());
            prop_assert!(result.sign().is_none() && result.to_big().is_none());
        }
        prop_assert!(!Rational::new(1, 0).is_defined() && !Rational::UNDEFINED.is_defined());
    }
}

proptest! {
    #![proptest_config(fixed(24))]

    #[test]
    fn expressions_are_a_field_by_their_normal_form(n in [1..9i64, 1..9, 1..9, 1..9, 1..9, 1..9]) {
        let [x, y, z] = symbols(["x", "y", "z"]);
        let n = n.map(Sym::int);
        let (a, b, c) = (n[0] * x + n[1] * y, (n[2] * y - z) / (n[3] + x * x), n[4] * z + n[5] / x);
        let none = Hypotheses::none();
        for (law, left, right) in field_laws(a, b, c).into_iter().chain(circle_laws(a, n[0] * z)) {
            prop_assert!(none.equal(left, right).is_zero(), "{law}: {left} and {right}");
        }
        let moving = |value: Sym, slope: Sym| Tangent::moving(value, slope);
        for (law, left, right) in field_laws(moving(a, y), moving(b, n[1] * x), moving(c, z - x)) {
            prop_assert!(none.equal(left.value, right.value).is_zero(), "{law}");
            prop_assert!(none.equal(left.slope, right.slope).is_zero(), "{law}: {} and {}", left.slope, right.slope);
        }
    }
}

#[test]
fn exact_parts_of_a_turn_are_the_parts_of_a_turn() {
    for whole in [1, 2, 3, 4, 6, 8, 12, 24] {
        for part in 0..=2 * whole {
            let (exact, near) = (Circle::<f64>::exact_turn(part, whole).expect("24 parts"), Circle::turn(part, whole));
            assert!((exact.cos - near.cos).abs() < 1e-15 * f64::from(part + 1), "{part}/{whole}: {exact:?} {near:?}");
            assert!((exact.sin - near.sin).abs() < 1e-15 * f64::from(part + 1), "{part}/{whole}: {exact:?} {near:?}");
        }
    }
    assert_eq!(Circle::<f64>::exact_turn(1, 5), None);
    assert_eq!(Circle::<f64>::exact_turn(1, 0), None);
}

/// The identities of the circle do not determine the derivative of a point with respect to its angle.
#[test]
fn a_point_turns_at_the_rate_of_its_angle() {
    let angle = Tangent::moving(0.7, 3.0).circle();
    assert!((angle.cos.slope + 3.0 * 0.7f64.sin()).abs() < 1e-15);
    assert!((angle.sin.slope - 3.0 * 0.7f64.cos()).abs() < 1e-15);
}

/// Functions of one variable angle with constant data, for every operation, each with the operands in both orders.
fn of_one_angle<T: Over<Rational>>(angle: Circle<T>, [p, q]: [Rational; 2]) -> Vec<T> {
    let (Circle { cos, sin }, [p, q], four) = (angle, [p, q].map(T::lift), T::int(4));
    let rest = [p + q, p - q, p * q, p / four, -p, T::zero(), T::one(), p.and_product(p, q), p % four];
    let moving = [sin + cos, sin - cos, sin * cos, sin / (cos + four), -sin, sin.less_product(sin, cos)];
    let both = [p + cos, cos + p, p - cos, cos - p, p * cos, cos * p, p / (cos + four), cos / four];
    let sums = [p.and_product(q, cos), p.less_product(sin, q), cos.and_product(p, q), sin.less_product(cos, p)];
    rest.into_iter().chain(moving).chain(both).chain(sums).collect()
}

proptest! {
    #![proptest_config(fixed(64))]
    #[test]
    fn what_is_known_to_rest_is_left_out_and_nothing_else(t in rational(), p in rational(), q in rational()) {
        let angle = Circle::from_half_tangent(t);
        let all = of_one_angle(angle.moving(Rational::one()), [p, q]);
        for (all, known) in all.into_iter().zip(of_one_angle(angle.varied(), [p, q])) {
            prop_assert_eq!((all.value, all.slope), (known.value, known.slope));
        }
    }
}

/// Comparison with double-double, also near multiples of a quarter turn, where cancellation is strong.
#[test]
fn cosine_and_sine_are_off_by_less_than_a_unit_of_the_last_place() {
    let many = (-4000..4000).map(|n| f64::from(n) * 0.39 + 1e-9 * f64::from(n * n));
    let quarters = (1..600_000).step_by(59).map(|n| f64::from(n) * std::f64::consts::FRAC_PI_2);
    for angle in many.chain(quarters).chain([1e6, -1e6, 1e-300, f64::MIN_POSITIVE]) {
        let exact = DoubleDouble::from(angle).circle();
        let (single, fused) = (angle.circle(), Batch::<1, true>([angle]).circle());
        let numbers = [
            (single.cos, exact.cos),
            (single.sin, exact.sin),
            (fused.cos.0[0], exact.cos),
            (fused.sin.0[0], exact.sin),
        ];
        for (number, exact) in numbers {
            let off = (DoubleDouble::from(number) - exact).hi().abs();
            assert!(off <= 0.8 * f64::EPSILON * exact.hi().abs(), "{angle}: {number:e} is off by {off:e}");
        }
    }
}

/// The identities of the circle would also hold for another unit of angle.
#[test]
fn every_lane_has_its_own_angle_be_it_near_far_or_undefined() {
    let near = (-4000..4000).map(|n| f64::from(n) * 0.39 + 1e-9 * f64::from(n * n));
    let angles: Vec<f64> = near.chain([1e6, -1e6, 1.1e6, -3e9, 1e300, 0.0, 1e-300, f64::MIN_POSITIVE]).collect();
    for four in angles.chunks_exact(4) {
        let angles = std::array::from_fn(|lane| four[lane]);
        let point = Batch::<4, false>(angles).circle();
        let fused = Batch::<4, true>(angles).circle();
        for (lane, angle) in four.iter().enumerate() {
            let (sin, cos) = angle.sin_cos();
            for (s, c) in [(point.sin.0[lane], point.cos.0[lane]), (fused.sin.0[lane], fused.cos.0[lane])] {
                let off = (s - sin).abs().max((c - cos).abs());
                assert!(off <= f64::EPSILON, "{angle}: {off:e}");
            }
        }
    }
    let point = Batch::<3, false>([0.5, f64::NAN, f64::INFINITY]).circle();
    assert!(
        point.sin.0[0] == Batch::<1, false>([0.5]).circle().sin.0[0]
            && point.cos.0[1].is_nan()
            && point.sin.0[2].is_nan()
    );
}
