//! Flux laws with one harmonic of the angle, as most motors have: a flux with its derivative costs four products.

use super::Machine;
use field::{Analytic, Circle, Over, Scalar, Tangent};
use symbolic::{Sym, Tape, substitute_all};

/// The coefficients of all fluxes psi_k = a cos g + b sin g + c, then those of U, as a program without inputs.
#[derive(Clone, Debug)]
pub struct Waves(Tape);

/// The coefficients over a scalar type.
#[derive(Clone, Debug)]
pub struct Harmonics<S> {
    windings: Vec<Wave<S>>,
    field: Wave<S>,
}

#[derive(Clone, Copy, Debug)]
struct Wave<S> {
    cos: S,
    sin: S,
    rest: S,
}

impl Waves {
    /// The harmonic laws of a machine; `None` where a flux or the energy has more than one harmonic.
    pub fn of(machine: &impl Machine<f64>) -> Option<Self> {
        let point = Circle { cos: Sym::symbol("c"), sin: Sym::symbol("s") };
        let still = [(point.cos, Sym::ZERO), (point.sin, Sym::ZERO)];
        let laws = (0..machine.windings()).map(|k| machine.linkage(k, point)).chain([machine.field_energy(point)]);
        let coefficients = |law: Sym| [law.diff(point.cos), law.diff(point.sin), substitute_all(&[law], &still)[0]];
        let all: Vec<Sym> = laws.flat_map(coefficients).collect();
        let constant = all.iter().all(|coefficient| coefficient.leaves_of().is_empty());
        Tape::record(&[], &all).ok().filter(|_| constant).map(Waves)
    }

    /// The coefficients over a scalar type.
    pub fn over<S: Analytic>(&self) -> Harmonics<S> {
        let mut values = vec![S::zero(); self.0.outputs()];
        self.0.over().evaluate(&[], &mut values);
        let mut waves = values.chunks_exact(3).map(|wave| Wave { cos: wave[0], sin: wave[1], rest: wave[2] });
        let still = Wave { cos: S::zero(), sin: S::zero(), rest: S::zero() };
        let field = waves.next_back().unwrap_or(still);
        Harmonics { windings: waves.collect(), field }
    }
}

impl<S: Over<f64>> Harmonics<S> {
    /// Passes psi_k(g) with its derivative to `each`, for each winding k. Returns -U'(g).
    #[inline(always)]
    pub fn at_angle(&self, angle: Circle<S>, mut each: impl FnMut(usize, Tangent<S>)) -> S {
        let windings = self.windings.iter().enumerate();
        windings.for_each(|(k, wave)| each(k, Tangent::moving(wave.value(angle), wave.slope(angle))));
        -self.field.slope(angle)
    }

    /// Passes psi_k(g) to `each`, for each winding k.
    #[inline(always)]
    pub fn linkages(&self, angle: Circle<S>, mut each: impl FnMut(usize, S)) {
        self.windings.iter().enumerate().for_each(|(k, wave)| each(k, wave.value(angle)));
    }
}

impl<S: Scalar> Wave<S> {
    #[inline(always)]
    fn value(&self, angle: Circle<S>) -> S {
        self.rest.and_product(self.cos, angle.cos).and_product(self.sin, angle.sin)
    }

    #[inline(always)]
    fn slope(&self, angle: Circle<S>) -> S {
        (self.sin * angle.cos).less_product(self.cos, angle.sin)
    }
}
