//! The laws of a motor as straight-line programs over any scalar type.

use super::{Count, Datum, RotorState};
use crate::text::{ANGLE, SLIP, SPEED};
use field::{Analytic, Base, Circle, Over};
use reader::Quantity;
use std::fmt;
use symbolic::{Algebraic, Sym, Tape};

/// Numbers of registers: for usual laws, to save clearing, and for the longest.
const FEW: usize = 24;
const MANY: usize = 256;

/// The laws of a motor as functions of its data, as programs common to all scalar types.
#[derive(Clone, Debug)]
pub struct Laws {
    name: &'static str,
    data: Vec<Quantity>,
    counts: Vec<(Count, usize)>,
    rotor: RotorState,
    energy: Law,
    torque: Law,
    windings: Vec<Winding<Law, usize>>,
    /// Computes the numbers that depend on the data only: settled values, roots and angles in the laws, W, then L and R
    /// of each winding.
    alone: Tape,
    /// The index of W among the numbers.
    frame_speed: usize,
}

/// The laws of a motor as expressions in the names of its data and the symbols of the motion.
#[derive(Clone, Debug)]
pub struct Expressions {
    /// The variables of the rotor on which the laws depend.
    pub rotor: RotorState,
    /// The frame speed W, rad/s.
    pub frame_speed: Sym,
    /// The field energy U(g), J.
    pub energy: Sym,
    /// The torque m(g', phi'), N m.
    pub torque: Sym,
    pub windings: Vec<Winding<Sym, Sym>>,
    /// Symbols for values that depend on the data only, with their values: computed once, in the scalar type of the
    /// data.
    pub settled: Vec<(Sym, Sym)>,
}

/// The laws of one winding.
#[derive(Clone, Debug)]
pub struct Winding<F, N> {
    /// The name of the current i_k.
    pub current: String,
    /// The flux linkage psi_k(g), Wb.
    pub flux: F,
    /// The supply voltage v_k(g), V.
    pub supply: Option<F>,
    /// The coefficient c_k(i) of the motional voltage, V s.
    pub motional: Option<F>,
    /// The inductance L_k, H.
    pub inductance: N,
    /// The resistance R_k, ohm.
    pub resistance: N,
}

/// The error for a law that is too long for a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLong;

/// One law: a program whose inputs are some of the motor's numbers, then variables of the motion.
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
        // the inputs are complete by construction
        value.unwrap_or_else(S::zero)
    }
}

impl Expressions {
    /// All expressions that may depend on the motion.
    fn of_motion(&self) -> impl Iterator<Item = Sym> {
        let of_windings = self.windings.iter().flat_map(|each| [Some(each.flux), each.supply, each.motional]).flatten();
        [self.energy, self.torque].into_iter().chain(of_windings)
    }

    /// Whether an energy, a flux or a supply depends on the angle.
    pub fn know_angle(energy: Sym, windings: &[Winding<Sym, Sym>]) -> bool {
        let Circle { cos, sin } = Sym::symbol(ANGLE).circle();
        let of_angle = windings.iter().flat_map(|each| [Some(each.flux), each.supply]).flatten();
        of_angle.chain([energy]).flat_map(Sym::leaves_of).any(|leaf| leaf == cos || leaf == sin)
    }
}

impl Laws {
    /// Records laws from expressions in the names of the data.
    ///
    /// # Errors
    /// [`TooLong`] where a law exceeds the registers of a program.
    pub fn new(
        name: &'static str,
        data: Vec<Quantity>,
        counts: Vec<(Count, usize)>,
        expressions: &Expressions,
    ) -> Result<Self, TooLong> {
        let Expressions { rotor, frame_speed, energy, torque, windings, settled } = expressions;
        let given: Vec<Sym> = data.iter().map(|quantity| Sym::symbol(&quantity.name)).collect();
        let Circle { cos, sin } = Sym::symbol(ANGLE).circle();
        let (angle, speeds) = ([cos, sin], [SLIP, SPEED].map(Sym::symbol));
        let currents: Vec<Sym> = windings.iter().map(|winding| Sym::symbol(&winding.current)).collect();
        let mut letters: Vec<Sym> = given.iter().copied().chain(settled.iter().map(|(letter, _)| *letter)).collect();
        let mut alone: Vec<Sym> = settled.iter().map(|(_, value)| *value).collect();
        for leaf in expressions.of_motion().flat_map(Sym::leaves_of) {
            if leaf.symbol_name().is_none() && !angle.contains(&leaf) && !letters.contains(&leaf) {
                letters.push(leaf);
                alone.push(leaf);
            }
        }
        let frame_speed_at = given.len() + alone.len();
        alone.push(*frame_speed);
        let mut place = frame_speed_at + 1;
        let mut recorded = Vec::with_capacity(windings.len());
        for Winding { current, flux, supply, motional, inductance, resistance } in windings {
            alone.extend([*inductance, *resistance]);
            recorded.push(Winding {
                current: current.clone(),
                flux: Law::record(*flux, &angle, &letters)?,
                supply: supply.map(|law| Law::record(law, &angle, &letters)).transpose()?,
                motional: motional.map(|law| Law::record(law, &currents, &letters)).transpose()?,
                inductance: place,
                resistance: place + 1,
            });
            place += 2;
        }
        Ok(Laws {
            name,
            rotor: *rotor,
            energy: Law::record(*energy, &angle, &letters)?,
            torque: Law::record(*torque, &speeds, &letters)?,
            windings: recorded,
            alone: Tape::record(&given, &alone).map_err(|_| TooLong)?,
            frame_speed: frame_speed_at,
            data,
            counts,
        })
    }

    /// The name that scene files use.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// The data, in their order.
    pub fn data(&self) -> &[Quantity] {
        &self.data
    }

    /// The counts, such as the number of bars, for which the laws were recorded.
    pub fn counts(&self) -> &[(Count, usize)] {
        &self.counts
    }

    /// The variables of the rotor on which the laws depend.
    pub fn rotor(&self) -> RotorState {
        self.rotor
    }

    /// The data, followed by the numbers that depend on the data only.
    pub fn numbers<P: Datum>(&self, mut given: Vec<P>) -> Vec<P> {
        let mut alone = vec![P::zero(); self.alone.outputs()];
        self.alone.over().evaluate(&given, &mut alone);
        given.extend(alone);
        given
    }

    pub(super) fn frame_speed<P: Base>(&self, numbers: &[P]) -> P {
        numbers[self.frame_speed]
    }

    /// The number of windings.
    pub fn windings(&self) -> usize {
        self.windings.len()
    }

    pub(super) fn current(&self, winding: usize) -> String {
        self.windings[winding].current.clone()
    }

    /// The inductance L_k, H.
    pub fn inductance<P: Base>(&self, winding: usize, numbers: &[P]) -> P {
        numbers[self.windings[winding].inductance]
    }

    /// The resistance R_k, ohm.
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

    pub(super) fn torque<P: Base, S: Over<P>>(&self, slip: S, speed: S, numbers: &[P]) -> S {
        self.torque.value(&[slip, speed], numbers)
    }
}

impl fmt::Display for TooLong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "more than {MANY} steps and numbers")
    }
}

impl std::error::Error for TooLong {}
