//! Exact stability intervals of splittings into kick and drift for the oscillator q'' = -k q.
//!
//! In the variables (q, h q') a step depends only on kappa = h^2 k. Its determinant is one, hence its powers are
//! bounded if its trace is between -2 and 2. The trace is a polynomial in kappa with the coefficients of the
//! integrator's composition.

use algebra::real::{Polynomial, Root};
use field::{Rational, Scalar};
use integrators::Splitting;
use symbolic::{Sym, univariate};

/// The matrix of a step.
pub fn step(splitting: Splitting, kappa: Sym) -> [[Sym; 2]; 2] {
    let schedule = splitting.schedule::<f64>(2);
    let start = [[Sym::int(1), Sym::ZERO], [Sym::ZERO, Sym::int(1)]];
    schedule.into_iter().fold(start, |[q, v], (piece, share)| {
        let share = Sym::constant(Rational::exactly(share));
        match piece {
            0 => [q, [v[0] - share * kappa * q[0], v[1] - share * kappa * q[1]]],
            _ => [[q[0] + share * v[0], q[1] + share * v[1]], v],
        }
    })
}

/// The trace of a step: coefficients of the powers of kappa from the constant upwards; `None` if the composition has a
/// coefficient that is not a number.
pub fn trace(splitting: Splitting) -> Option<Vec<Rational>> {
    let kappa = Sym::symbol("κ");
    let [[first, _], [_, second]] = step(splitting, kappa);
    univariate(first + second, kappa).ok()
}

/// The kappa > 0 with |trace| = 2, ascending, and whether |trace| < 2 before, between and after them.
pub fn bounds(splitting: Splitting) -> Option<(Vec<Root>, Vec<bool>)> {
    let trace = trace(splitting)?;
    let shifted = |by: i64| {
        let mut shifted = trace.clone();
        shifted[0] += Rational::int(by);
        Polynomial::from_rationals(&shifted)
    };
    let (above, below) = (shifted(-2)?, shifted(2)?);
    let product = &above * &below;
    let zero = Polynomial::from_integers([0, 1]);
    let cuts: Vec<Root> = product.real_roots().into_iter().filter(|root| root.sign_of(&zero) > 0).collect();
    let ends: Vec<Rational> = cuts.iter().map(|cut| cut.bounds()[1]).collect();
    let starts = cuts.iter().map(|cut| cut.bounds()[0]).chain(ends.last().map(|end| *end + Rational::int(2)));
    let mut before = Rational::int(0);
    let mut inside = Vec::new();
    for (place, start) in starts.enumerate() {
        let probe = Root::rational((before + start) / Rational::int(2))?;
        inside.push(probe.sign_of(&product) < 0);
        before = ends.get(place).copied().unwrap_or(start);
    }
    Some((cuts, inside))
}
