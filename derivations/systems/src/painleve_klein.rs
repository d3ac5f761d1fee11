//! The sliders of Painleve and Klein: two masses on parallel guides, connected by a massless rod; one guide is rough.
//!
//! The coordinates are (x1, y1, x2, y2) with the masses (m1, m1, m2, m2); the guides are y = 0 and y = h. The forces P1
//! and P2 act along the guides. For the rod's angle theta to the guides sin theta = h/l; of the geometry only tan theta
//! occurs in the equations.

use field::{Base, Over};
use mechanics::constrained::contacts::{Contact, Contacts, Sides};
use mechanics::constrained::{Constrained, Constraint, PointSystem, State};

/// The data of the sliders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PainleveKlein<P> {
    /// The masses m1 on the rough guide and m2 on the smooth one, kg.
    pub masses: [P; 2],
    /// The forces P1 and P2, N.
    pub loads: [P; 2],
    /// The distance h of the guides, m.
    pub distance: P,
    /// The length l of the rod, m.
    pub length: P,
    /// The coefficient of friction f of the first guide.
    pub friction: P,
}

impl<P: Base> PointSystem<4> for PainleveKlein<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 4] {
        let [m1, m2] = self.masses.map(S::lift);
        [m1, m1, m2, m2]
    }

    fn force<S: Over<P>>(&self, _at: &State<S, 4>) -> [S; 4] {
        let [p1, p2] = self.loads.map(S::lift);
        [p1, S::zero(), p2, S::zero()]
    }
}

impl<P: Base> Constrained<4, 1> for PainleveKlein<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 4>) -> [Constraint<S>; 1] {
        let [x1, y1, x2, y2] = at.place;
        let length = S::lift(self.length);
        [Constraint::Geometric(((x2 - x1).squared() + (y2 - y1).squared() - length.squared()).half())]
    }
}

impl<P: Base> Contacts<4, 1, 2> for PainleveKlein<P> {
    fn contacts<S: Over<P>>(&self, _time: S, [x1, y1, x2, y2]: [S; 4]) -> [Contact<S>; 2] {
        let guide = |gap, along, friction| Contact { gap, along, friction, sides: Sides::Two };
        [guide(y1, x1, S::lift(self.friction)), guide(y2 - S::lift(self.distance), x2, S::zero())]
    }
}
