//! Vectors in the axes of frames, and the tree of frames.

use super::rotation::Rotation;
use crate::FrameId;
use field::Circle;
use symbolic::Sym;

/// A vector by its components along the axes of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector {
    pub frame: FrameId,
    pub components: [Sym; 3],
}

impl Vector {
    pub const ZERO: Vector = Vector { frame: FrameId::GROUND, components: [Sym::ZERO; 3] };

    /// A unit vector of a frame.
    pub fn axis(frame: FrameId, axis: usize) -> Self {
        let mut components = [Sym::ZERO; 3];
        components[axis] = Sym::ONE;
        Vector { frame, components }
    }

    /// The same frame with other components.
    pub fn map(self, f: impl FnMut(Sym) -> Sym) -> Self {
        Vector { components: self.components.map(f), ..self }
    }

    /// Whether every component is the constant zero.
    pub fn is_zero(self) -> bool {
        self.components == [Sym::ZERO; 3]
    }
}

/// A frame among the others.
struct Link {
    parent: FrameId,
    depth: usize,
    rotation: Rotation,
    /// The angular velocity of the frame beside the ground, in its own axes.
    turning: Vector,
}

/// The tree of frames.
#[derive(Default)]
pub(crate) struct Frames {
    links: Vec<Link>,
}

impl Frames {
    /// A first frame that turns at any angular velocity, by its components in its own axes.
    pub fn turning_at(turning: Vector) -> Self {
        let mut frames = Frames::default();
        frames.push(None);
        frames.links[0].turning = turning;
        frames
    }

    pub fn count(&self) -> usize {
        self.links.len()
    }

    /// The next frame: its parent, its turn, and its angular velocity in the parent along its own axes; none for the ground.
    pub fn push(&mut self, turned: Option<(FrameId, Rotation, [Sym; 3])>) {
        let frame = FrameId(self.links.len());
        let Some((parent, rotation, rate)) = turned else {
            let rotation = Rotation::About { axis: 2, angle: Circle::zero() };
            self.links.push(Link { parent: frame, depth: 0, rotation, turning: Vector::ZERO });
            return;
        };
        let depth = self.links[parent.0].depth + 1;
        self.links.push(Link { parent, depth, rotation, turning: Vector::ZERO });
        let carried = self.express(self.turning(parent), frame);
        self.links[frame.0].turning = self.sum(carried, Vector { frame, components: rate });
    }

    /// The angular velocity of a frame beside the ground, in its own axes.
    pub fn turning(&self, frame: FrameId) -> Vector {
        self.links[frame.0].turning
    }

    /// A vector in the axes of another frame.
    pub fn express(&self, vector: Vector, to: FrameId) -> Vector {
        if vector.frame == to {
            return vector;
        }
        if vector.is_zero() {
            return Vector { frame: to, ..vector };
        }
        let common = self.common(vector.frame, to);
        let mut components = vector.components;
        let mut at = vector.frame;
        while at != common {
            let link = &self.links[at.0];
            components = link.rotation.to_parent(components);
            at = link.parent;
        }
        let mut down = Vec::new();
        let mut at = to;
        while at != common {
            down.push(at);
            at = self.links[at.0].parent;
        }
        for frame in down.into_iter().rev() {
            let link = &self.links[frame.0];
            components = link.rotation.into_frame(components);
        }
        Vector { frame: to, components }
    }

    /// The last frame that both turn in.
    fn common(&self, mut a: FrameId, mut b: FrameId) -> FrameId {
        while a != b {
            let (deep, other) = (self.links[a.0].depth, self.links[b.0].depth);
            if deep >= other {
                a = self.links[a.0].parent;
            }
            if other >= deep {
                b = self.links[b.0].parent;
            }
        }
        a
    }

    /// The frame in whose axes two vectors are put together: the lower of the two where one turns in the other by angles, else the
    /// last that both turn in. Into a free frame and back a vector would be multiplied by R R^T, which nothing reduces.
    fn together(&self, a: FrameId, b: FrameId) -> FrameId {
        let common = self.common(a, b);
        let lower = if common == a { b } else { a };
        let way = std::iter::successors(Some(lower), |frame| Some(self.links[frame.0].parent));
        let is_free = |frame: FrameId| matches!(self.links[frame.0].rotation, Rotation::Matrix(_));
        let is_above = common == a || common == b;
        if is_above && !way.take_while(|frame| *frame != common).any(is_free) { lower } else { common }
    }

    fn both(&self, a: Vector, b: Vector) -> (FrameId, [Sym; 3], [Sym; 3]) {
        let frame = self.together(a.frame, b.frame);
        (frame, self.express(a, frame).components, self.express(b, frame).components)
    }

    /// The sum of two vectors.
    pub fn sum(&self, a: Vector, b: Vector) -> Vector {
        if a.is_zero() {
            return b;
        }
        if b.is_zero() {
            return a;
        }
        let (frame, a, b) = self.both(a, b);
        Vector { frame, components: std::array::from_fn(|i| a[i] + b[i]) }
    }

    /// The scalar product.
    pub fn dot(&self, a: Vector, b: Vector) -> Sym {
        if a.is_zero() || b.is_zero() {
            return Sym::ZERO;
        }
        let (_, a, b) = self.both(a, b);
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    /// The vector product.
    pub fn cross(&self, a: Vector, b: Vector) -> Vector {
        if a.is_zero() || b.is_zero() {
            return Vector::ZERO;
        }
        let (frame, a, b) = self.both(a, b);
        let component = |i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            a[j] * b[k] - a[k] * b[j]
        };
        Vector { frame, components: std::array::from_fn(component) }
    }
}
