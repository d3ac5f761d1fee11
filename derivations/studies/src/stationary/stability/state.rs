//! Steady motions, the layout of states, and states near steady motions along deviations.

use field::{Base, Circle, Over, Scalar, Tangent};
use motor::{Machine, RotorState, steady_currents};
use nalgebra::Vector3;

/// A steady motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StationaryState<S> {
    /// w0, rad/s
    pub speed: S,
    /// v
    pub vertical: Vector3<S>,
    /// W = phi', rad/s; a machine with an angle is synchronous
    pub rotor_speed: S,
    /// g
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

    /// The number of states.
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

/// A state in the form that the laws take.
pub struct State<S> {
    pub w: Vector3<S>,
    pub v: Vector3<S>,
    pub rotor_speed: S,
    pub slip: S,
    pub angle: Circle<S>,
    pub currents: Vec<S>,
}

impl<S: Scalar> StationaryState<S> {
    /// The motion with coordinates of zero derivative.
    pub(super) fn fixed(&self) -> StationaryState<Tangent<S>> {
        let StationaryState { speed, vertical, rotor_speed, angle } = self;
        StationaryState {
            speed: Tangent::fixed(*speed),
            vertical: vertical.map(Tangent::fixed),
            rotor_speed: Tangent::fixed(*rotor_speed),
            angle: angle.map(Tangent::fixed),
        }
    }

    /// The state along a deviation with these derivatives, the currents from their steady values. (Without steady values
    /// from zero, which the residuals then show to be no steady motion.)
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

/// A state with derivatives in one direction, differentiated in another.
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
