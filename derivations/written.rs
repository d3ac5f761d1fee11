//! A law as expressions of its state and time.

use integrators::Ode;
use symbolic::{Sym, apart};

/// Symbols for state and time, and the rates.
pub struct Written {
    pub state: Vec<Sym>,
    pub time: Sym,
    pub rates: Vec<Sym>,
}

/// What is read of a law that is written down apart from all other expressions: the same whatever was written before.
pub fn written<L: Ode<Sym> + Sync, R: Send>(law: &L, read: impl FnOnce(&Written) -> R + Send) -> R {
    apart(|| {
        let (state, time) = symbols(law.dimension());
        let mut rates = vec![Sym::ZERO; state.len()];
        law.rates(time, &state, &mut rates);
        read(&Written { state, time, rates })
    })
}

/// Of so many states, and of the time.
pub(crate) fn symbols(states: usize) -> (Vec<Sym>, Sym) {
    ((0..states).map(|i| Sym::symbol(&format!("y{i}"))).collect(), Sym::symbol("t"))
}
