//! The Boltzmann-Hamel equations, with the components of each centre of mass's velocity, and of each angular velocity along the axes of the inertia tensor, as
//! quasi-velocities.
//!
//! With quasi-velocities w_r(q, u, t) and T(q, w, t), every coordinate has the equation
//!
//!   sum_r [ (dT/dw_r)' dw_r/du_i + (dT/dw_r) (d/dt dw_r/du_i - dw_r/dq_i) ] - dT/dq_i|w = Q_i .
//!
//! The factor of the momentum dT/dw_r is the transpositional relation d(delta pi_r)/dt - delta w_r per displacement of q_i. It
//! is nonzero because the w are not rates of coordinates. There may be more quasi-velocities than speeds.

use super::loads::generalised;
use crate::Trace;
use field::Rational;
use symbolic::{Sym, substitute_all};

/// Quasi-velocities as expressions and as symbols, and the kinetic energy as a function of the symbols.
struct Quasi {
    velocities: Vec<Sym>,
    symbols: Vec<Sym>,
    kinetic: Sym,
}

impl Quasi {
    fn of(trace: &Trace<'_>) -> Self {
        let half = Sym::constant(Rational::new(1, 2));
        let mut quasi = Quasi { velocities: Vec::new(), symbols: Vec::new(), kinetic: Sym::ZERO };
        for body in &trace.model.bodies {
            if let Some((mass, velocity, _)) = trace.carried(body) {
                let named = velocity.map(|component| quasi.named(component));
                quasi.kinetic += half * mass * trace.dot(named, named);
            }
            if let Some((inertia, turning)) = trace.turned(body) {
                let axes = trace.inertia_times(inertia, turning).frame;
                let components = trace.express(turning, axes);
                let named = crate::Vector { frame: axes, components }.map(|component| quasi.named(component));
                quasi.kinetic += half * trace.dot(named, trace.inertia_times(inertia, named));
            }
        }
        quasi
    }

    /// Returns a symbol for a component; zero stays zero.
    fn named(&mut self, component: Sym) -> Sym {
        if component == Sym::ZERO {
            return component;
        }
        // names of systems contain no spaces
        let symbol = Sym::symbol(&format!("quasi-velocity {}", self.symbols.len() + 1));
        self.velocities.push(component);
        self.symbols.push(symbol);
        symbol
    }
}

pub(super) fn residual(trace: &Trace<'_>) -> Vec<Sym> {
    let Quasi { velocities, symbols, kinetic } = Quasi::of(trace);
    let back: Vec<(Sym, Sym)> = symbols.iter().copied().zip(velocities.iter().copied()).collect();
    let by_symbols: Vec<Sym> = symbols.iter().map(|&symbol| kinetic.diff(symbol)).collect();
    let momenta = substitute_all(&by_symbols, &back);
    let rates: Vec<Sym> = momenta.iter().map(|&momentum| trace.rate_of(momentum)).collect();
    let forces = generalised(trace, true);
    let of = |i: usize| {
        let inertia = velocities.iter().zip(momenta.iter().zip(&rates)).map(|(&velocity, (&momentum, &rate))| {
            let displaced = trace.by_speed(velocity, i);
            let turned = trace.transposition(i, |j| trace.by_speed(velocity, j));
            let transposed = trace.rate_of(displaced) + turned - trace.by_coordinate(velocity, i);
            rate * displaced + momentum * transposed
        });
        let by_place = trace.by_coordinate(kinetic, i).substitute(&back);
        inertia.fold(-by_place, |sum, term| sum + term) - forces[i] + trace.induced(i)
    };
    (0..trace.speeds.len()).map(of).collect()
}
