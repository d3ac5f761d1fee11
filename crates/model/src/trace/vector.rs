//! Vectors with components along the axes of frames, and the tree of frames.

use super::rotation::Rotation;
use crate::FrameId;
use field::Circle;
use symbolic::Sym;

/// A vector with components along the axes of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector {
    /// The frame of the components.
    pub frame: FrameId,
    /// The components along its axes x, y, z.
    pub components: [Sym; 3],
}

impl Vector {
    /// The zero vector.
    pub const ZERO: Vector = Vector { frame: FrameId::GROUND, components: [Sym::ZERO; 3] };

    /// Returns the unit vector along the axis 0, 1 or 2 (x, y, z) of a frame.
    pub fn axis(frame: FrameId, axis: usize) -> Self {
        let mut components = [Sym::ZERO; 3];
        components[axis] = Sym::ONE;
        Vector { frame, components }
    }

    /// Applies a function to each component.
    pub fn map(self, f: impl FnMut(Sym) -> Sym) -> Self {
        Vector { components: self.components.map(f), ..self }
    }

    /// Returns whether every component is the constant zero.
    pub fn is_zero(self) -> bool {
        self.components == [Sym::ZERO; 3]
    }
}

/// A frame in the tree.
struct Link {
    parent: FrameId,
    depth: usize,
    rotation: Rotation,
    /// The angular velocity relative to the ground, along the frame's own axes.
    turning: Vector,
}

/// The tree of frames.
#[derive(Default)]
pub(crate) struct Frames {
    links: Vec<Link>,
}

impl Frames {
    /// Creates a tree whose first frame has the given angular velocity, along its own axes.
    pub fn turning_at(turning: Vector) -> Self {
        let mut frames = Frames::default();
        frames.push(None);
        frames.links[0].turning = turning;
        frames
    }

    pub fn count(&self) -> usize {
        self.links.len()
    }

    /// Adds a frame: its parent, its rotation, and its angular velocity relative to the parent along its own axes; `None` for the ground.
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

    /// Returns the angular velocity of a frame relative to the ground, along its own axes.
    pub fn turning(&self, frame: FrameId) -> Vector {
        self.links[frame.0].turning
    }

    /// Returns a vector with components along the axes of another frame.
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

    /// Returns the nearest common ancestor of two frames.
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

    /// Returns the frame along whose axes two vectors are combined: the lower frame if it rotates in the other one by angles, otherwise the nearest
    /// common ancestor. Conversion into a free frame and back would multiply a vector by R R^T, which is not simplified.
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

    /// Returns the sum of two vectors.
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

    /// Returns the scalar product of two vectors.
    pub fn dot(&self, a: Vector, b: Vector) -> Sym {
        if a.is_zero() || b.is_zero() {
            return Sym::ZERO;
        }
        let (_, a, b) = self.both(a, b);
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    /// Returns the vector product of two vectors.
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
