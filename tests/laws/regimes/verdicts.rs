//! Helpers of the tests: the verdict on a state, and the name of a regime.

use field::{Over, Rational};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::{Consistency, Mode, Ordered, posed, verdict};

pub fn q(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator, denominator)
}

pub fn decide<Q, S, const N: usize, const C: usize, const K: usize>(system: &Q, at: &State<S, N>) -> Consistency<S, K>
where
    Q: Contacts<N, C, K>,
    S: Over<Q::Given> + Ordered,
{
    let (dry, touches) = posed(system, at).expect("the state is admitted");
    verdict(&dry, &touches)
}

pub fn name<S, const K: usize>(verdict: &Consistency<S, K>) -> (&'static str, Option<[Mode; K]>) {
    match verdict {
        Consistency::Unique(found) => ("unique", Some(found.regime)),
        Consistency::None => ("none", None),
        Consistency::Several(a, _) => ("several", Some(a.regime)),
        Consistency::Continuum(found) => ("continuum", Some(found.regime)),
        Consistency::Undefined => ("undefined", None),
    }
}
