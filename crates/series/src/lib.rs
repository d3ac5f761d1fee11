//! Taylor series of the solutions of y' = f(t, y), computed by sums and Cauchy products.
//!
//! For integration with long steps and many digits. The operations of a law are recorded once over symbolic
//! expressions. The series can then be computed in `f64`, double-double, dual numbers and batches, for any values of
//! the parameters.
//!
//! The series of a linear combination is the combination of the series. The series of a product is Cauchy's product,
//! (a b)_k = sum_j a_j b_(k-j). All other operations are reduced to these two. Cosine c and sine s of an angle a become
//! states with c' = -a' s, s' = a' c. A quotient q = a/b solves (q b)_k = a_k, and a square root r of a solves
//! (r r)_k = a_k, each for the last term of the product.
//!
//! The unknowns of linear equations are computed order by order with one LU factorisation of the matrix: see
//! [`algebra::linear`].
//!
//! The cost of a series is the number of products times the square of its order, plus the number of terms of the sums
//! times the order. Three rules reduce this cost: sums are not split; products of sums are expanded if their parts are
//! needed elsewhere (slip cos, slip sin); terms with a common factor are collected. Seven currents, each with the field
//! at its own angle, then need two products.
//!
//! ```
//! use dalembert_series::{Equations, Recurrence};
//! use symbolic::{Sym, symbols};
//!
//! // y' = y, through 1: the exponential series
//! let [y] = symbols(["y"]);
//! let equations = Equations { state: &[y], time: None, parameters: &[], rates: &[y], solve: None };
//! let recurrence = Recurrence::record(&equations)?;
//! let mut expansion = recurrence.expansion::<f64, 8, 256>(&[], 4).expect("one quantity has room");
//! expansion.expand(&[1.0], 0.0);
//! let coefficients: Vec<f64> = (0..=4).map(|k| expansion.coefficients(k)[0]).collect();
//! assert_eq!(coefficients, [1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0]);
//! # Ok::<(), symbolic::Untapeable>(())
//! ```

mod batch;
mod build;
mod collect;
mod expand;
mod form;
mod fused;
mod identities;
mod layout;
mod linear_equations;
mod order;
#[cfg(target_arch = "x86_64")]
mod permuting;
mod pick;
mod plan;
mod points;
#[cfg_attr(not(target_arch = "x86_64"), expect(dead_code, reason = "no other processor runs these kernels"))]
mod small;
mod stages;
mod stored;
mod sum;

pub use batch::BatchExpansion;
pub use expand::Expansion;
pub use fused::Fused;

use build::Builder;
use plan::Plan;
use small::Law;
use symbolic::linear::Solve;
use symbolic::{Sym, Tape, Untapeable};

/// The equations y' = f(t, y; parameters) as symbolic expressions.
#[derive(Clone, Copy, Debug)]
pub struct Equations<'a> {
    pub state: &'a [Sym],
    /// The symbol of time, if the rates depend on it.
    pub time: Option<Sym>,
    /// Symbols that are constant during a run.
    pub parameters: &'a [Sym],
    /// The rate of each state.
    pub rates: &'a [Sym],
    /// Linear equations whose unknowns may occur in the rates.
    pub solve: Option<&'a Solve>,
}

/// The right-hand side as sums and products. It is independent of the expression graph, can be sent to other threads,
/// and is valid for all values of the parameters: see [`Recurrence::expansion`].
#[derive(Clone, Debug)]
pub struct Recurrence {
    plan: Plan,
    /// Computes the coefficients of the sums from the parameters.
    coefficients: Tape,
    /// Computes the circle points from state, time and parameters.
    points: Tape,
    /// The reduction to a small law, if it is small.
    small: Option<Reduced>,
}

/// A small right-hand side.
#[derive(Clone, Debug)]
struct Reduced {
    law: Law,
    /// Computes its coefficients from the parameters.
    coefficients: Tape,
}

/// The cost above which equations are not expanded.
const MOST_MULTIPLIED_OUT: usize = 4_000;

impl Recurrence {
    /// Reduces the equations to sums and products.
    ///
    /// # Errors
    /// [`Untapeable`] for a symbol that is neither state nor time nor parameter, an arbitrary function, a division by
    /// the constant zero, or a number of rates different from that of the states.
    pub fn record(equations: &Equations<'_>) -> Result<Self, Untapeable> {
        if equations.rates.len() != equations.state.len() {
            return Err(Untapeable::Shape { rates: equations.rates.len(), states: equations.state.len() });
        }
        let mut best: Option<(usize, Builder<'_>)> = None;
        for multiplied_out in [1, 2, 6] {
            // expansion would increase the cost of long sums of products
            if best.as_ref().is_some_and(|(least, _)| *least > MOST_MULTIPLIED_OUT) {
                break;
            }
            let builder = Builder::run(equations, multiplied_out)?;
            let cost = builder.cost();
            if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                best = Some((cost, builder));
            }
        }
        let Some((_, builder)) = best else { return Err(Untapeable::Undefined) };
        builder.finish()
    }

    /// The number of states.
    pub fn states(&self) -> usize {
        self.plan.states
    }

    /// The number of columns of an expansion in groups of `W`.
    pub fn columns<const W: usize>(&self) -> usize {
        layout::width(&self.plan, W)
    }

    /// The number of products of two series, and the total number of terms of all sums.
    pub fn size(&self) -> (usize, usize) {
        (self.plan.products(), self.plan.terms())
    }
}
