//! A law as expressions of its state and time.

use integrators::Ode;
use symbolic::{Sym, apart};

/// Symbols for state and time, and the rates.
#[derive(Clone, Debug)]
pub struct TracedOde {
    pub state: Vec<Sym>,
    pub time: Sym,
    pub rates: Vec<Sym>,
}

/// Reads a law that is written down apart from all other expressions: independent of earlier ones.
pub fn traced<R: Send>(law: &(impl Ode<Sym> + Sync + ?Sized), read: impl FnOnce(&TracedOde) -> R + Send) -> R {
    apart(|| {
        let (state, time) = symbols(law.dimension());
        let mut rates = vec![Sym::ZERO; state.len()];
        law.rates(time, &state, &mut rates);
        read(&TracedOde { state, time, rates })
    })
}

/// Symbols of so many states, and of the time.
pub(crate) fn symbols(states: usize) -> (Vec<Sym>, Sym) {
    ((0..states).map(|i| Sym::symbol(&format!("y{i}"))).collect(), Sym::symbol("t"))
}
