//! Order and step size of a series for a tolerance.

/// The order for a tolerance, within the limits of rounding.
///
/// The step size is proportional to tolerance^(1/p): with L = -ln(tolerance) the cheapest p for steps that cost b + p + c p^2 has
///
///   p^2 (1 + 2 c p) = L (b + p + c p^2) .
///
/// In `f64` the cost of a step beside its orders is that of about five orders, and eight terms of a product cost as much as one: b = 5, c
/// = 0.015, and p = 4 + 0.8 L is near to that for all L from 7 to 33. The order is never below 16: where a decay and not the tolerance
/// bounds the step, the step of a series grows with its order. Measured on eight scenes of motors at an error of 1e-3, order 16 takes 0.8
/// to 1.05 of the time of order 10; mechanisms were not timed. In double-double most orders are in `f64` (at most half are not), and the
/// same order is near to the cheapest for L up to 70.
pub fn taylor_order(tolerance: f64) -> usize {
    let order = 4.0 - 0.8 * tolerance.ln();
    (order.ceil() as usize).clamp(16, 60)
}

/// The longest step of a series of order p whose last two coefficients have these sizes, in units of the allowed error.
// without branches, and always inlined here and below: in lanes it is computed for all at once
#[inline(always)]
pub(crate) fn reach(order: usize, last: f64, one_before: f64) -> f64 {
    let p = order as f64;
    let reach = power_of_two(-(logarithm(last) * (1.0 / p)).max(logarithm(one_before) * (1.0 / (p - 1.0))));
    if last.max(one_before) < f64::MIN_POSITIVE { f64::INFINITY } else { reach }
}

/// log2 of a number that is not negative, to 3e-6: a step size need not be known better. Zero counts as the smallest
/// number.
#[inline(always)]
fn logarithm(x: f64) -> f64 {
    const FRACTION: u64 = (1 << 52) - 1;
    let exponent = f64::from((x.to_bits() >> 52) as i32 - 1023);
    let fraction = f64::from_bits((x.to_bits() & FRACTION) | 1.0_f64.to_bits());
    exponent + polynomial(fraction - 1.5, LOGARITHM)
}

/// 2^y, to 2e-6.
#[inline(always)]
fn power_of_two(y: f64) -> f64 {
    let y = y.clamp(-1000.0, 1000.0);
    let whole = y as i32;
    let scale = f64::from_bits(((1023 + whole) as u64) << 52);
    scale * polynomial(y - f64::from(whole), POWER)
}

/// log2(1.5 + x) for |x| < 1/2.
const LOGARITHM: [f64; 8] = [
    0.5849627591044444,
    0.9617965401665365,
    -0.3206318784567618,
    0.1425080240329688,
    -0.07059455402256631,
    0.03761046428219572,
    -0.0251101409525063,
    0.014440352491874364,
];
/// 2^x for |x| < 1.
const POWER: [f64; 8] = [
    0.9999999895646148,
    0.693147179757808,
    0.2402268408359096,
    0.05550413432974688,
    0.009616461222384132,
    0.0013332275843138675,
    0.00015669788598415835,
    1.545752248688359e-05,
];

/// sum c_k x^k, by halves that do not wait for each other.
#[inline(always)]
fn polynomial(x: f64, [a, b, c, d, e, f, g, h]: [f64; 8]) -> f64 {
    let square = x * x;
    let (low, high) = ((a + b * x) + (c + d * x) * square, (e + f * x) + (g + h * x) * square);
    low + high * (square * square)
}
