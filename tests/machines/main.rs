//! Motor models compared with first principles, without using the code of the models.

mod brushed;
mod conformance;
mod crossed_windings;
mod metered;
mod motors;
mod mutual_inductance;
mod permanent_magnet;
#[path = "../physical/mod.rs"]
mod physical;
mod text_motors;

use field::Rational;
use std::convert::Infallible;
use symbolic::{Hypotheses, Sym, decide};

/// The data of a machine as symbols of their names.
fn symbol(quantity: &'static reader::Quantity) -> Result<Sym, Infallible> {
    Ok(Sym::symbol(&quantity.name))
}

fn assert_equal(what: &str, left: Sym, right: Sym) {
    let decision = decide(left - right, &Hypotheses::none());
    assert!(decision.is_zero(), "{what}: {decision}");
}

fn number(n: i64, d: i64) -> Rational {
    Rational::new(n, d)
}
