//! The systems with contacts that scene files name, with their coordinates and data.

use systems::climbed_ladder::ClimbedLadder;
use systems::ladder::Ladder;
use systems::rod::Rod;
use systems::slender_rod::SlenderRod;
use systems::steered_rod::SteeredRod;

/// A system with contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rough {
    Ladder(Ladder<f64>),
    ClimbedLadder(ClimbedLadder<f64>),
    SlenderRod(SlenderRod<f64>),
    Rod(Rod<f64>),
    SteeredRod(SteeredRod<f64>),
}

impl Rough {
    /// (name in scene files, what it is).
    pub const LIST: [(&'static str, &'static str); 5] = [
        ("ladder", "a rod between a rough wall and a rough floor"),
        ("climbed_ladder", "the same under a weight that is carried up"),
        ("slender_rod", "a rod with one end on a rough line"),
        ("painleve_rod", "two masses on a massless rod, one on a rough line"),
        ("steered_rod", "the same, its middle moving along the rod"),
    ];

    /// As in scene files.
    pub fn name(&self) -> &'static str {
        let place = match self {
            Self::Ladder(_) => 0,
            Self::ClimbedLadder(_) => 1,
            Self::SlenderRod(_) => 2,
            Self::Rod(_) => 3,
            Self::SteeredRod(_) => 4,
        };
        Self::LIST[place].0
    }

    /// The coordinates of the state: of a plane body its centre and direction, of two masses their places.
    pub fn coordinates(&self) -> [&'static str; 4] {
        match self {
            Self::Rod(_) | Self::SteeredRod(_) => ["x1", "y1", "x2", "y2"],
            _ => ["x", "y", "cos", "sin"],
        }
    }

    /// The scene's angle, rad, and its rate, at a state.
    pub fn angle(&self, place: &[f64], velocity: &[f64]) -> [f64; 2] {
        let direction = |v: &[f64]| match self {
            Self::Rod(_) | Self::SteeredRod(_) => [v[2] - v[0], v[3] - v[1]],
            _ => [v[2], v[3]],
        };
        let ([c, s], [dc, ds]) = (direction(place), direction(velocity));
        [s.atan2(c), (c * ds - s * dc) / (c * c + s * s)]
    }

    /// (name, unit, meaning, value) of the data.
    pub fn data(&self) -> Vec<(&'static str, &'static str, &'static str, f64)> {
        let ladder = |it: &Ladder<f64>| {
            vec![
                ("m", "kg", "mass", it.mass),
                ("J", "kg m^2", "moment of inertia about the centre", it.inertia),
                ("l", "m", "half of the length", it.half_length),
                ("g", "m/s^2", "acceleration of gravity", it.gravity),
                ("$f_A$", "", "friction of the wall", it.friction[0]),
                ("$f_B$", "", "friction of the floor", it.friction[1]),
            ]
        };
        match self {
            Self::Ladder(it) => ladder(it),
            Self::ClimbedLadder(it) => {
                let mut data = ladder(&it.ladder);
                data.push(("P", "N", "weight that is carried up", it.weight));
                data.push(("v", "m/s", "its speed along the ladder", it.speed));
                data
            }
            Self::SlenderRod(it) => vec![
                ("m", "kg", "mass", it.mass),
                ("J", "kg m^2", "moment of inertia about the centre", it.inertia),
                ("l", "m", "half of the length", it.half_length),
                ("g", "m/s^2", "acceleration of gravity", it.gravity),
                ("f", "", "friction", it.friction),
            ],
            Self::Rod(Rod { guided, free, length, gravity, friction, .. })
            | Self::SteeredRod(SteeredRod { guided, free, length, gravity, friction, .. }) => {
                let mut data = vec![
                    ("$m_1$", "kg", "mass on the guide", *guided),
                    ("$m_2$", "kg", "other mass", *free),
                    ("l", "m", "length of the rod", *length),
                    ("g", "m/s^2", "acceleration of gravity", *gravity),
                    ("f", "", "friction", *friction),
                ];
                if let Self::SteeredRod(rod) = self {
                    data.push(("X", "N", "force along the guide", rod.drive));
                }
                data
            }
        }
    }
}
