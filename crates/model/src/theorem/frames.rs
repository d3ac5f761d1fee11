//! Lemmas on frames: if the angular velocity of a frame has the required properties, so has that of a frame that rotates in it.

use super::Equations;
use super::directions::{TestDirections, equal, in_axes};
use crate::FrameId;
use crate::trace::{Frames, FreeFrame, Rotation, Vector};
use field::Analytic;
use symbolic::Sym;

const CHILD: FrameId = FrameId(1);

/// A frame that rotates by an angle about an axis of its parent.
pub(super) fn turned_by_an_angle() -> Equations {
    let about = |axis: usize| {
        let mut any = TestDirections::any();
        let (parent, angle) = (any.turning("w"), any.function("angle"));
        let mut rate = [Sym::ZERO; 3];
        rate[axis] = any.rate(angle);
        let rotation = Rotation::About { axis, angle: angle.circle() };
        carried(&mut any, &child_of(parent, rotation, rate))
    };
    (0..3).flat_map(about).collect()
}

/// A free frame, along rotations about its own axes; its parent does not depend on these.
pub(super) fn turned_freely() -> Equations {
    let free = FreeFrame::named("free");
    let mut any = TestDirections::along(free.speeds, free.accelerations, Sym::ONE);
    let displacements = free.displacements();
    let of_quaternion =
        |k: usize, part: Sym| displacements[k].iter().find(|(own, _)| *own == part).map(|found| found.1);
    let rates = free.quaternion.into_iter().zip(free.rates());
    for (part, rate) in rates.chain(free.turned(free.speeds)) {
        any.changes(part, rate, std::array::from_fn(|k| of_quaternion(k, part).unwrap_or(Sym::ZERO)));
    }
    let parent: [Sym; 3] = std::array::from_fn(|part| {
        let letter = Sym::symbol(&format!("w {}", part + 1));
        any.changes(letter, Sym::symbol(&format!("w' {}", part + 1)), [Sym::ZERO; 3]);
        letter
    });
    let parts = free.quaternion.into_iter().chain(free.cosines.into_iter().flatten());
    let commuting: Equations = parts.flat_map(|part| any.commute(part)).collect();
    let frames = child_of(in_axes(parent), Rotation::Matrix(free.cosines), free.speeds);
    commuting.into_iter().chain(carried(&mut any, &frames)).collect()
}

/// A free frame whose parent moves along the directions, at speeds that do not depend on them.
pub(super) fn turned_in_one_that_turns_freely() -> Equations {
    let free = FreeFrame::named("free");
    let mut any = TestDirections::any();
    let parent = any.turning("w");
    let speeds = free.speeds.into_iter().zip(free.accelerations);
    for (part, rate) in free.turned(free.speeds).chain(speeds) {
        any.changes(part, rate, [Sym::ZERO; 3]);
    }
    let frames = child_of(parent, Rotation::Matrix(free.cosines), free.speeds);
    carried(&mut any, &frames)
}

/// Returns a frame with an arbitrary angular velocity, and one that rotates in it.
fn child_of(parent: Vector, rotation: Rotation, rate: [Sym; 3]) -> Frames {
    let mut frames = Frames::turning_at(parent);
    frames.push(Some((FrameId::GROUND, rotation, rate)));
    frames
}

/// The required properties ([`TestDirections::turning`]) for the child frame. Rates and products of vectors are equal in both axes.
fn carried(any: &mut TestDirections, frames: &Frames) -> Equations {
    let [a, b] = ["a", "b"].map(|name| {
        let components = std::array::from_fn(|part| any.free(&format!("{name} {}", part + 1)));
        in_axes(components)
    });
    let child = frames.turning(CHILD);
    let by_speed = |j: usize| any.vector_by_speed(child, j);
    let turned = (0..3).flat_map(|k| {
        let slope = by_speed(k);
        let across = frames.cross(child, slope);
        let rates: [(Sym, Sym); 3] = std::array::from_fn(|part| {
            let transposed = any.transposed(k, |j| by_speed(j).components[part]);
            let found = any.rate(slope.components[part]) + transposed + across.components[part];
            (any.by_place(child.components[part], k), found)
        });
        let by_acceleration = child.map(|component| any.by_acceleration(any.rate(component), k));
        rates.into_iter().chain(equal(by_acceleration, slope))
    });
    let rate = |vector: Vector| {
        frames.sum(vector.map(|part| any.rate(part)), frames.cross(frames.turning(vector.frame), vector))
    };
    let displaced = |vector: Vector, k: usize| {
        let turning = any.vector_by_speed(frames.turning(vector.frame), k);
        frames.sum(vector.map(|part| any.by_place(part, k)), frames.cross(turning, vector))
    };
    let in_child = |vector: Vector| frames.express(vector, CHILD);
    let same_rates = (0..3)
        .flat_map(|k| equal(in_child(displaced(a, k)), displaced(in_child(a), k)))
        .chain(equal(in_child(rate(a)), rate(in_child(a))));
    let product = frames.dot(a, b);
    let crossed = in_child(frames.cross(a, b));
    let same_products = equal(crossed, frames.cross(in_child(a), in_child(b))).into_iter().chain([
        (product, frames.dot(in_child(a), in_child(b))),
        (any.rate(product), frames.dot(rate(a), b) + frames.dot(a, rate(b))),
        (any.by_place(product, 0), frames.dot(displaced(a, 0), b) + frames.dot(a, displaced(b, 0))),
    ]);
    turned.chain(same_rates).chain(same_products).collect()
}
