//! Order and step size of a Taylor series for a tolerance.

/// Optimal order for a relative tolerance, from 16 to 60.
///
/// The step size is proportional to tolerance^(1/p). With L = -ln(tolerance), and with steps that cost b + p + c p^2,
/// the optimal order p solves
///
///   p^2 (1 + 2 c p) = L (b + p + c p^2) .
///
/// In `f64` a step costs as much as five orders in addition to its own, and eight terms of a product cost as much as
/// one order: b = 5, c = 0.015. The approximation p = 4 + 0.8 L is close to the optimum for L from 7 to 33. The order
/// is at least 16: where stability and not the tolerance limits the step, the step size grows with the order. For eight
/// scenes of motors with an error of 1e-3, order 16 takes 0.8 to 1.05 of the time of order 10. In double-double at
/// least half of the orders are computed in `f64`, and the formula is close to the optimum for L up to 70.
pub fn taylor_order(tolerance: f64) -> usize {
    let order = 4.0 - 0.8 * tolerance.ln();
    (order.ceil() as usize).clamp(16, 60)
}

/// The largest step size of a series of order p, from its last two coefficients in units of the allowed error. Inlined
/// and without branches: for a batch it is computed in all lanes at once.
#[inline(always)]
pub(crate) fn reach(order: usize, last: f64, one_before: f64) -> f64 {
    let p = order as f64;
    let reach = power_of_two(-(logarithm(last) * (1.0 / p)).max(logarithm(one_before) * (1.0 / (p - 1.0))));
    if last.max(one_before) < f64::MIN_POSITIVE { f64::INFINITY } else { reach }
}

/// log2 of a nonnegative number with an error of 3e-6, which suffices for a step size. Zero counts as the smallest
/// positive number.
#[inline(always)]
fn logarithm(x: f64) -> f64 {
    const FRACTION: u64 = (1 << 52) - 1;
    let exponent = f64::from((x.to_bits() >> 52) as i32 - 1023);
    let fraction = f64::from_bits((x.to_bits() & FRACTION) | 1.0_f64.to_bits());
    exponent + polynomial(fraction - 1.5, LOGARITHM)
}

/// 2^y with a relative error of 2e-6.
#[inline(always)]
fn power_of_two(y: f64) -> f64 {
    let y = y.clamp(-1000.0, 1000.0);
    let whole = y as i32;
    let scale = f64::from_bits(((1023 + whole) as u64) << 52);
    scale * polynomial(y - f64::from(whole), POWER)
}

/// The coefficients of log2(1.5 + x) for |x| < 1/2.
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
/// The coefficients of 2^x for |x| < 1.
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

/// The polynomial sum c_k x^k, as two halves that the processor evaluates in parallel.
#[inline(always)]
fn polynomial(x: f64, [a, b, c, d, e, f, g, h]: [f64; 8]) -> f64 {
    let square = x * x;
    let (low, high) = ((a + b * x) + (c + d * x) * square, (e + f * x) + (g + h * x) * square);
    low + high * (square * square)
}
