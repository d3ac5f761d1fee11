//! Steady motions, the layout of state vectors, and states displaced from a steady motion.

use field::{Base, Circle, Over, Scalar, Tangent};
use motor::{Machine, RotorState, steady_currents};
use nalgebra::Vector3;

/// A steady motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StationaryState<S> {
    /// The angular velocity w0, rad/s.
    pub speed: S,
    /// The unit vector v of the vertical.
    pub vertical: Vector3<S>,
    /// The rotor's relative speed W = phi', rad/s; if the machine's law contains an angle, it is synchronous and
    /// rotates at W.
    pub rotor_speed: S,
    /// The angle g of the machine.
    pub angle: Circle<S>,
}

/// The layout of a state vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    pub rotor: RotorState,
    pub windings: usize,
}

impl Layout {
    /// The layout for a machine.
    pub fn of<P: Base>(machine: &impl Machine<P>) -> Self {
        Layout { rotor: machine.rotor(), windings: machine.windings() }
    }

    /// The number of components of the state.
    pub fn size(self) -> usize {
        6 + self.rotor.dimension() + self.windings
    }

    pub(super) fn angle(self) -> Option<usize> {
        (self.rotor == RotorState::AngleAndSpeed).then_some(6)
    }

    pub(super) fn slip(self) -> Option<usize> {
        self.rotor.dimension().checked_sub(1).map(|last| 6 + last)
    }
}

/// A state as the arguments of the laws.
pub struct State<S> {
    pub w: Vector3<S>,
    pub v: Vector3<S>,
    pub rotor_speed: S,
    pub slip: S,
    pub angle: Circle<S>,
    pub currents: Vec<S>,
}

impl<S: Scalar> StationaryState<S> {
    /// The motion with all derivatives equal to zero.
    pub(super) fn fixed(&self) -> StationaryState<Tangent<S>> {
        let StationaryState { speed, vertical, rotor_speed, angle } = self;
        StationaryState {
            speed: Tangent::fixed(*speed),
            vertical: vertical.map(Tangent::fixed),
            rotor_speed: Tangent::fixed(*rotor_speed),
            angle: angle.map(Tangent::fixed),
        }
    }

    /// The state whose coordinates have these derivatives; the currents are measured from their steady values. (If the
    /// machine has no steady currents, they are measured from zero; the residuals then show that this is no steady
    /// motion.)
    pub(super) fn state<P: Base, M: Machine<P>>(&self, machine: &M, slopes: &[S]) -> State<Tangent<S>>
    where
        S: Over<P>,
    {
        let layout = Layout::of(machine);
        let slope = |place: Option<usize>| place.map_or(S::zero(), |place| slopes[place]);
        let vector = |from: usize| Vector3::from_fn(|i, _| slopes[from + i]);
        let moving = |value: Vector3<S>, slope: Vector3<S>| value.zip_map(&slope, Tangent::moving);
        let in_step = layout.angle().is_some();
        let slip = if in_step { S::zero() } else { self.rotor_speed - S::lift(machine.frame_speed()) };
        let first = layout.size() - layout.windings;
        let resting = steady_currents(machine, self.angle, slip);
        let resting = resting.unwrap_or_else(|| vec![S::zero(); layout.windings]);
        State {
            w: moving(self.vertical * self.speed, vector(0)),
            v: moving(self.vertical, vector(3)),
            rotor_speed: Tangent::moving(self.rotor_speed, slope(layout.slip())),
            slip: Tangent::moving(slip, slope(layout.slip())),
            angle: self.angle.moving(slope(layout.angle())),
            currents: resting.into_iter().zip(&slopes[first..]).map(|(i, &slope)| Tangent::moving(i, slope)).collect(),
        }
    }
}

/// A state with derivatives in one direction, differentiated once more in another.
pub(super) fn twice_moved<P: Base, S: Over<P>, M: Machine<P>>(
    inner: &State<Tangent<S>>,
    place: &StationaryState<Tangent<S>>,
    machine: &M,
    slopes: &[S],
) -> State<Tangent<Tangent<S>>> {
    let layout = Layout::of(machine);
    let outer: Vec<Tangent<S>> = slopes.iter().map(|&slope| Tangent::fixed(slope)).collect();
    let outer = place.state(machine, &outer);
    let add = |a: Tangent<S>, b: Tangent<Tangent<S>>| Tangent::moving(a, b.slope);
    State {
        w: inner.w.zip_map(&outer.w, add),
        v: inner.v.zip_map(&outer.v, add),
        rotor_speed: add(inner.rotor_speed, outer.rotor_speed),
        slip: add(inner.slip, outer.slip),
        angle: inner.angle.moving(layout.angle().map_or(Tangent::fixed(S::zero()), |at| Tangent::fixed(slopes[at]))),
        currents: inner.currents.iter().zip(outer.currents).map(|(&a, b)| add(a, b)).collect(),
    }
}
