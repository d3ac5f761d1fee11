//! A law as symbolic expressions of its state and time.

use integrators::Ode;
use symbolic::{Sym, apart};

/// The symbols of state and time, and the rates as expressions.
#[derive(Clone, Debug)]
pub struct TracedOde {
    pub state: Vec<Sym>,
    pub time: Sym,
    pub rates: Vec<Sym>,
}

/// Evaluates a law symbolically and passes the result to `read`, in a separate expression store.
pub fn traced<R: Send>(law: &(impl Ode<Sym> + Sync + ?Sized), read: impl FnOnce(&TracedOde) -> R + Send) -> R {
    apart(|| {
        let (state, time) = symbols(law.dimension());
        let mut rates = vec![Sym::ZERO; state.len()];
        law.rates(time, &state, &mut rates);
        read(&TracedOde { state, time, rates })
    })
}

/// The symbols of `states` states, and of the time.
pub(crate) fn symbols(states: usize) -> (Vec<Sym>, Sym) {
    ((0..states).map(|i| Sym::symbol(&format!("y{i}"))).collect(), Sym::symbol("t"))
}
