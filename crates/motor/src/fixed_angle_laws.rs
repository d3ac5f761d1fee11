//! The laws of a machine in the form needed by a kick: all laws of the angle together, and the torque at all stages
//! together.
//!
//! A [`Machine`](super::Machine) gives its laws one by one. The laws of a [`Motor`](super::Motor) are programs, whose
//! separate evaluation shares no intermediate results; [`Programs`] records them together, with the data as constants.
//! Laws with one harmonic of the angle need no program: they are [`Waves`]. The torque, which a kick evaluates at four
//! slips five times, is a [`Fraction`] of the slip.

use super::gauss4_scalar::STAGES;
use super::harmonics::{Harmonics, Waves};
use super::kick::{Law, laws_at, torque_at};
use super::{Machine, RotorState};
use field::{Analytic, Base, Circle, Over, Rational, Tangent};
use simulation::{Program, Running};
use symbolic::{Fraction, Sym};

/// The laws of a machine at a constant angle.
pub trait FixedAngleMachine<P: Base, S: Over<P>> {
    type Machine: Machine<P>;

    fn machine(&self) -> &Self::Machine;

    /// Passes psi_k(g) with its derivative to `each`, for each winding k. Returns -U'(g).
    fn at_angle(&self, angle: Circle<S>, each: impl FnMut(usize, Tangent<S>)) -> S;

    /// Passes psi_k(g) to `each`, for each winding k.
    fn linkages(&self, angle: Circle<S>, each: impl FnMut(usize, S));

    /// The torque m with its derivative at each of the slips.
    fn torques(&self, slips: &[S; STAGES]) -> [Tangent<S>; STAGES];
}

/// Evaluates the laws one by one.
impl<P: Base, S: Over<P>, M: Machine<P>> FixedAngleMachine<P, S> for M {
    type Machine = M;

    #[inline(always)]
    fn machine(&self) -> &M {
        self
    }

    #[inline(always)]
    fn at_angle(&self, angle: Circle<S>, each: impl FnMut(usize, Tangent<S>)) -> S {
        laws_at(self, angle, each)
    }

    #[inline(always)]
    fn linkages(&self, angle: Circle<S>, mut each: impl FnMut(usize, S)) {
        (0..self.windings()).for_each(|k| each(k, self.linkage(k, angle)));
    }

    #[inline(always)]
    fn torques(&self, slips: &[S; STAGES]) -> [Tangent<S>; STAGES] {
        slips.map(|slip| torque_at(self, slip))
    }
}

/// The laws of a machine for a kick, as programs.
#[derive(Clone, Debug)]
pub struct Programs {
    /// psi_k, -U', psi_k' as functions of the angle's cosine and sine; `None` where the laws do not depend on it.
    angle: Option<Program>,
    /// The flux laws if they have one harmonic; then `angle` is not needed.
    waves: Option<Waves>,
    /// The torque m as a fraction of the slip if it is nonlinear; `None` where that is longer than the law itself.
    torque: Option<Fraction<Rational>>,
}

impl Programs {
    /// Records the programs of a machine.
    pub fn of(machine: &(impl Machine<f64> + Sync)) -> Self {
        let angle = || {
            Program::of(2, |_, point| {
                let point = Circle { cos: point[0], sin: point[1] };
                let (mut values, mut slopes) = (Vec::new(), Vec::new());
                let force = laws_at(machine, point, |_, Tangent { value, slope, .. }| {
                    values.push(value);
                    slopes.push(slope);
                });
                values.push(force);
                [values, slopes].concat()
            })
        };
        let knows_angle = machine.rotor() == RotorState::AngleAndSpeed;
        let waves = knows_angle.then(|| Waves::of(machine)).flatten();
        let torque = || {
            let slip = Sym::symbol("slip");
            Fraction::record(torque_at(machine, slip).value, slip)
        };
        Programs {
            angle: (knows_angle && waves.is_none()).then(angle).flatten(),
            waves,
            torque: if Law::of(machine) == Law::Curved { torque() } else { None },
        }
    }
}

/// A machine with its programs over a scalar type, if they were recorded.
#[derive(Clone, Debug)]
pub struct Programmed<'a, S, M> {
    machine: &'a M,
    angle: Option<&'a Program>,
    waves: Option<Harmonics<S>>,
    torque: Option<Fraction<S>>,
}

/// Buffer sizes for up to three windings, for up to fifteen, and for the largest number that a scene may have.
const FEW: usize = 8;
const SOME: usize = 32;
const MANY: usize = 256;

impl<S: Running + Over<f64>, M: Machine<f64>> FixedAngleMachine<f64, S> for Programmed<'_, S, M> {
    type Machine = M;

    #[inline(always)]
    fn machine(&self) -> &M {
        self.machine
    }

    #[inline(always)]
    fn at_angle(&self, angle: Circle<S>, each: impl FnMut(usize, Tangent<S>)) -> S {
        if let Some(waves) = &self.waves {
            return waves.at_angle(angle, each);
        }
        let windings = self.machine.windings();
        match self.angle {
            Some(program) if windings < FEW / 2 => followed::<S, FEW>(program, windings, angle, each),
            Some(program) if windings < SOME / 2 => followed::<S, SOME>(program, windings, angle, each),
            Some(program) if windings < MANY / 2 => followed::<S, MANY>(program, windings, angle, each),
            _ => laws_at(self.machine, angle, each),
        }
    }

    #[inline(always)]
    fn linkages(&self, angle: Circle<S>, each: impl FnMut(usize, S)) {
        if let Some(waves) = &self.waves {
            return waves.linkages(angle, each);
        }
        let windings = self.machine.windings();
        match self.angle {
            Some(program) if windings < FEW / 2 => linked::<S, FEW>(program, windings, angle, each),
            Some(program) if windings < SOME / 2 => linked::<S, SOME>(program, windings, angle, each),
            Some(program) if windings < MANY / 2 => linked::<S, MANY>(program, windings, angle, each),
            _ => self.machine.linkages(angle, each),
        }
    }

    #[inline(always)]
    fn torques(&self, slips: &[S; STAGES]) -> [Tangent<S>; STAGES] {
        match &self.torque {
            Some(torque) => torque.moving(slips),
            None => self.machine.torques(slips),
        }
    }
}

impl<'a, S: Over<f64> + Analytic, M> Programmed<'a, S, M> {
    /// A machine whose laws are evaluated by `programs`. A law without a program, or every law if `programs` is `None`, is evaluated by the machine
    /// itself.
    pub fn new(machine: &'a M, programs: Option<&'a Programs>) -> Self {
        Programmed {
            machine,
            angle: programs.and_then(|all| all.angle.as_ref()),
            waves: programs.and_then(|all| all.waves.as_ref()).map(Waves::over),
            torque: programs.and_then(|all| all.torque.as_ref()).map(Fraction::over),
        }
    }
}

/// [`FixedAngleMachine::at_angle`] by a program, in buffers of N numbers.
#[inline]
fn followed<S: Running, const N: usize>(
    program: &Program,
    windings: usize,
    angle: Circle<S>,
    mut each: impl FnMut(usize, Tangent<S>),
) -> S {
    let mut values = [S::zero(); N];
    let values = &mut values[..2 * windings + 1];
    // the inputs are correct by construction
    program.run(S::zero(), &[angle.cos, angle.sin], values).unwrap_or(());
    let (linkages, rest) = values.split_at(windings);
    let (force, slopes) = rest.split_at(1);
    for (k, (value, slope)) in linkages.iter().zip(slopes).enumerate() {
        each(k, Tangent::moving(*value, *slope));
    }
    force[0]
}

/// [`FixedAngleMachine::linkages`] by a program, whose first values are the fluxes.
#[inline]
fn linked<S: Running, const N: usize>(
    program: &Program,
    windings: usize,
    angle: Circle<S>,
    mut each: impl FnMut(usize, S),
) {
    let mut values = [S::zero(); N];
    let values = &mut values[..2 * windings + 1];
    // the inputs are correct by construction
    program.run(S::zero(), &[angle.cos, angle.sin], values).unwrap_or(());
    values[..windings].iter().enumerate().for_each(|(k, value)| each(k, *value));
}
