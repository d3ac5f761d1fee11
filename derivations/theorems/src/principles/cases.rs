//! The systems for which the principles are compared.

use super::alphabet::{letter, letters};
use super::equal::Case;
use mechanics::constrained::contacts::{Closed, Sides};
use symbolic::Sym;
use systems::disc::Disc;
use systems::governor::{Gearing, Governor, Torque};
use systems::knife_edge::KnifeEdge;
use systems::ladder::{Ladder, LeaningLadder};
use systems::moving_pivot_pendulum::MovingPivotPendulum;
use systems::prescribed_speed_point::PrescribedSpeedPoint;
use systems::rod::{GuidedRod, Rod};
use systems::steered_rod::{GuidedSteeredRod, SteeredRod};

/// Painleve's rod on its guide.
pub fn rod() -> Case<GuidedRod<Sym>, 4, 2, 2, 2> {
    let [guided, free, length, gravity, friction] = letters(["m", "m1", "l", "g", "f"]);
    Case {
        entry: "rod",
        name: "Painlevé's rod",
        system: Closed(Rod { guided, free, length, gravity, friction, sides: Sides::Two }),
        at: (letter("t"), letters(["x", "θ"]), letters(["ẋ", "θ̇"])),
        dependent: [3, 1],
        friction: letters(["μx", "μθ"]),
        variations: letters(["δ1", "δ2"]),
    }
}

/// The steered rod on its guide.
pub fn steered_rod() -> Case<GuidedSteeredRod<Sym>, 4, 3, 2, 1> {
    let [guided, free, length, gravity, drive, friction] = letters(["m1", "m2", "l", "g", "X", "f"]);
    Case {
        entry: "steered-rod",
        name: "the steered rod",
        system: Closed(SteeredRod { guided, free, length, gravity, drive, friction, sides: Sides::Two }),
        at: (letter("t"), letters(["x", "θ"]), letters(["ẋ"])),
        dependent: [2, 3, 1],
        friction: letters(["μx"]),
        variations: letters(["δ1"]),
    }
}

/// The ladder on wall and floor.
pub fn ladder() -> Case<LeaningLadder<Sym>, 4, 3, 1, 1> {
    let [mass, inertia, half_length, gravity, f] = letters(["m", "J", "l", "g", "f"]);
    Case {
        entry: "ladder",
        name: "Appell's ladder",
        system: Closed(Ladder { mass, inertia, half_length, gravity, friction: [f, f] }),
        at: (letter("t"), letters(["α"]), letters(["α̇"])),
        dependent: [2, 0, 1],
        friction: letters(["μθ"]),
        variations: letters(["κ1"]),
    }
}

/// The disc that rolls on a plane.
pub fn disc() -> Case<Disc<Sym>, 9, 6, 5, 3> {
    let [mass, second_moment, radius, gravity] = letters(["m", "P", "a", "g"]);
    Case {
        entry: "disc",
        name: "the rolling disc",
        system: Disc { mass, second_moment, radius, gravity },
        at: (letter("t"), letters(["x", "y", "ψ", "θ", "φ"]), letters(["ψ̇", "θ̇", "φ̇"])),
        dependent: [3, 8, 6, 2, 0, 1],
        friction: letters(["μψ", "μθ", "μφ"]),
        variations: letters(["κ1", "κ2", "κ3"]),
    }
}

/// The disc with axes in space and in the disc such that psi = phi = 0 at this instant. There is no loss of generality,
/// since plane and disc are isotropic.
pub fn disc_in_axes() -> Case<Disc<Sym>, 9, 6, 5, 3> {
    let case = disc();
    let (time, [x, y, _, theta, _], p) = case.at;
    let name = r"the rolling disc, in axes with $\psi=\varphi=0$ at the instant";
    Case { name, at: (time, [x, y, Sym::ZERO, theta, Sym::ZERO], p), ..case }
}

/// The knife edge on a slope.
pub fn knife_edge() -> Case<KnifeEdge<Sym>, 4, 2, 3, 2> {
    let [mass, inertia, offset, slope] = letters(["m", "J", "d", "g"]);
    Case {
        entry: "knife-edge",
        name: "the knife edge",
        system: KnifeEdge { mass, inertia, offset, slope },
        at: (letter("t"), letters(["x", "y", "θ"]), letters(["v", "θ̇"])),
        dependent: [3, 1],
        friction: letters(["μx", "μθ"]),
        variations: letters(["δ1", "κ1"]),
    }
}

/// The friction governor with a drum; its wheel moves freely along the axle.
pub fn governor() -> Case<Governor<Sym>, 7, 5, 4, 2> {
    let [first, second, wheel, mass, drum, radius] = letters(["I1", "I2", "I3", "m", "l", "a"]);
    let [m1, m2, push] = letters(["M1", "M2", "X"]);
    Case {
        entry: "governor",
        name: "the friction governor",
        system: Governor {
            inertia: [first, second, wheel],
            mass,
            radius,
            gearing: Gearing::Drum { radius: drum },
            moments: [m1, m2].map(Torque::constant),
            push,
            lateral: Sym::ZERO,
        },
        at: (letter("t"), letters(["ψ", "θ", "φ", "r"]), letters(["θ̇", "ṙ"])),
        dependent: [0, 2, 4, 1, 5],
        friction: letters(["μθ", "μx"]),
        variations: letters(["κ1", "δ1"]),
    }
}

/// The friction governor between two discs; both lever arms depend on the position of the wheel.
pub fn governor_between_discs() -> Case<Governor<Sym>, 7, 5, 4, 2> {
    let case = governor();
    let gearing = Gearing::Discs { distance: letter("l") };
    Case {
        entry: "governor-discs",
        name: "the friction governor between two discs",
        system: Governor { gearing, ..case.system },
        ..case
    }
}

/// The pendulum with a moving pivot.
pub fn swing() -> Case<MovingPivotPendulum<Sym>, 2, 1, 1, 1> {
    let [mass, length, gravity, speed, acceleration] = letters(["m", "l", "g", "u", "b"]);
    Case {
        entry: "swing",
        name: "the pendulum with a moving pivot",
        system: MovingPivotPendulum { mass, length, gravity, speed, acceleration },
        at: (letter("t"), letters(["θ"]), letters(["θ̇"])),
        dependent: [1],
        friction: letters(["μθ"]),
        variations: letters(["δ1"]),
    }
}

/// The point with prescribed speed.
pub fn prescribed_speed_point() -> Case<PrescribedSpeedPoint<Sym>, 2, 1, 2, 1> {
    let [mass, gravity, speed, acceleration] = letters(["m", "g", "u", "b"]);
    Case {
        entry: "kept-speed",
        name: "the point of prescribed speed",
        system: PrescribedSpeedPoint { mass, gravity, speed, acceleration },
        at: (letter("t"), letters(["x", "y"]), letters(["χ"])),
        dependent: [0],
        friction: letters(["μχ"]),
        variations: letters(["δ1"]),
    }
}
