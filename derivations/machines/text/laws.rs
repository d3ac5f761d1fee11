//! The laws of a written motor as straight-line programs over any field.

use super::super::{Datum, Quantity, RotorState};
use super::letters::{ANGLE, SLIP, SPEED};
use field::{Analytic, Base, Circle, Over};
use std::fmt;
use symbolic::{Algebraic, Sym, Tape};

/// Registers: of usual laws, whose clearing costs little, and of the longest.
const FEW: usize = 24;
const MANY: usize = 256;

/// W, which every motor has.
pub const FIELD_SPEED: Quantity = Quantity::any("field_speed", "rad/s", "speed of the stator's field");

/// The laws of a motor in terms of its parameters. Every field evaluates the same programs.
#[derive(Clone, Debug)]
pub struct Laws {
    parameters: Vec<Quantity>,
    energy: Law,
    moment: Law,
    windings: Vec<Winding<Law, usize>>,
    /// What is computed of the parameters alone: roots and angles in the laws, then L and R of each winding.
    alone: Tape,
    rotor: RotorState,
}

/// What is written of one winding.
#[derive(Clone, Debug)]
pub struct Winding<F, N> {
    /// The name of i_k.
    pub current: String,
    /// psi_k(g), Wb
    pub flux: F,
    /// v_k(g), V
    pub supply: Option<F>,
    /// c_k(i), V s
    pub motional: Option<F>,
    /// L_k, H
    pub inductance: N,
    /// R_k, ohm
    pub resistance: N,
}

/// A law that has more steps than any written by a person.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLong;

/// One law: a program whose inputs are some of the motor's numbers, then those of the motion.
#[derive(Clone, Debug, Default)]
struct Law {
    program: Algebraic,
    numbers: Vec<usize>,
}

impl Law {
    fn record(expression: Sym, motion: &[Sym], numbers: &[Sym]) -> Result<Self, TooLong> {
        let leaves = expression.leaves_of();
        let used: Vec<usize> = (0..numbers.len()).filter(|&k| leaves.contains(&numbers[k])).collect();
        let inputs: Vec<Sym> = used.iter().map(|&k| numbers[k]).chain(motion.iter().copied()).collect();
        let tape = Tape::record(&inputs, &[expression]).ok().and_then(|tape| tape.algebraic());
        let program = tape.filter(|program| program.registers() <= MANY).ok_or(TooLong)?;
        Ok(Law { program, numbers: used })
    }

    fn value<P: Base, S: Over<P>>(&self, motion: &[S], numbers: &[P]) -> S {
        let inputs = self.numbers.iter().map(|&k| S::lift(numbers[k])).chain(motion.iter().copied());
        let value = match self.program.registers() <= FEW {
            true => self.program.evaluate::<S, FEW>(inputs),
            false => self.program.evaluate::<S, MANY>(inputs),
        };
        // it has what it needs since it was recorded
        value.unwrap_or_else(S::zero)
    }
}

impl Laws {
    /// From expressions in the parameters' names, of which the first is the field's speed, and the letters of the motion.
    ///
    /// # Errors
    /// [`TooLong`].
    pub fn new(
        parameters: Vec<Quantity>,
        energy: Sym,
        moment: Sym,
        windings: &[Winding<Sym, Sym>],
    ) -> Result<Self, TooLong> {
        let given: Vec<Sym> = parameters.iter().map(|quantity| Sym::symbol(&quantity.name)).collect();
        let Circle { cos, sin } = Sym::symbol(ANGLE).circle();
        let (angle, speeds) = ([cos, sin], [SLIP, SPEED].map(Sym::symbol));
        let currents: Vec<Sym> = windings.iter().map(|winding| Sym::symbol(&winding.current)).collect();
        let of_windings = windings.iter().flat_map(|each| [Some(each.flux), each.supply, each.motional]).flatten();
        let mut alone: Vec<Sym> = Vec::new();
        for leaf in [energy, moment].into_iter().chain(of_windings).flat_map(Sym::leaves_of) {
            if leaf.symbol_name().is_none() && !angle.contains(&leaf) && !alone.contains(&leaf) {
                alone.push(leaf);
            }
        }
        let numbers: Vec<Sym> = given.iter().chain(&alone).copied().collect();
        let mut place = numbers.len();
        let mut recorded = Vec::new();
        for Winding { current, flux, supply, motional, inductance, resistance } in windings {
            alone.extend([*inductance, *resistance]);
            recorded.push(Winding {
                current: current.clone(),
                flux: Law::record(*flux, &angle, &numbers)?,
                supply: supply.map(|law| Law::record(law, &angle, &numbers)).transpose()?,
                motional: motional.map(|law| Law::record(law, &currents, &numbers)).transpose()?,
                inductance: place,
                resistance: place + 1,
            });
            place += 2;
        }
        let of_angle = windings.iter().flat_map(|each| [Some(each.flux), each.supply]).flatten();
        let knows_angle = of_angle.chain([energy]).flat_map(Sym::leaves_of).any(|leaf| angle.contains(&leaf));
        Ok(Laws {
            energy: Law::record(energy, &angle, &numbers)?,
            moment: Law::record(moment, &speeds, &numbers)?,
            windings: recorded,
            alone: Tape::record(&given, &alone).map_err(|_| TooLong)?,
            rotor: if knows_angle { RotorState::AngleAndSpeed } else { RotorState::Speed },
            parameters,
        })
    }

    /// The field's speed, then those of the file in its order.
    pub fn parameters(&self) -> &[Quantity] {
        &self.parameters
    }

    /// What the laws know of the rotor.
    pub fn rotor(&self) -> RotorState {
        self.rotor
    }

    /// The parameters, and what follows from them alone.
    pub fn numbers<P: Datum>(&self, mut given: Vec<P>) -> Vec<P> {
        let mut alone = vec![P::zero(); self.alone.outputs()];
        self.alone.over().evaluate(&given, &mut alone);
        given.extend(alone);
        given
    }

    pub(super) fn field_speed<P: Base>(&self, numbers: &[P]) -> P {
        numbers.first().copied().unwrap_or_else(P::zero)
    }

    pub(super) fn windings(&self) -> usize {
        self.windings.len()
    }

    pub(super) fn current(&self, winding: usize) -> String {
        self.windings[winding].current.clone()
    }

    /// L_k
    pub fn inductance<P: Base>(&self, winding: usize, numbers: &[P]) -> P {
        numbers[self.windings[winding].inductance]
    }

    /// R_k
    pub fn resistance<P: Base>(&self, winding: usize, numbers: &[P]) -> P {
        numbers[self.windings[winding].resistance]
    }

    pub(super) fn flux<P: Base, S: Over<P>>(&self, winding: usize, angle: Circle<S>, numbers: &[P]) -> S {
        self.windings[winding].flux.value(&[angle.cos, angle.sin], numbers)
    }

    pub(super) fn supply<P: Base, S: Over<P>>(&self, winding: usize, angle: Circle<S>, numbers: &[P]) -> Option<S> {
        self.windings[winding].supply.as_ref().map(|law| law.value(&[angle.cos, angle.sin], numbers))
    }

    pub(super) fn motional<P: Base, S: Over<P>>(&self, winding: usize, currents: &[S], numbers: &[P]) -> Option<S> {
        self.windings[winding].motional.as_ref().map(|law| law.value(currents, numbers))
    }

    pub(super) fn energy<P: Base, S: Over<P>>(&self, angle: Circle<S>, numbers: &[P]) -> S {
        self.energy.value(&[angle.cos, angle.sin], numbers)
    }

    pub(super) fn moment<P: Base, S: Over<P>>(&self, slip: S, speed: S, numbers: &[P]) -> S {
        self.moment.value(&[slip, speed], numbers)
    }
}

/// Of a rotor that is left alone.
impl Default for Laws {
    fn default() -> Self {
        Laws {
            parameters: vec![FIELD_SPEED],
            energy: Law::default(),
            moment: Law::default(),
            windings: Vec::new(),
            alone: Tape::default(),
            rotor: RotorState::Speed,
        }
    }
}

impl fmt::Display for TooLong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "more than {MANY} steps and numbers")
    }
}

impl std::error::Error for TooLong {}
