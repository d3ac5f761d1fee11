//! A rod with one contact with friction: the critical coefficient of friction and its minimum.

use super::alphabet::{angle, letter};
use claims::{Condition, Line, Page};
use field::{Circle, Scalar};
use mechanics::constrained::State;
use mechanics::constrained::contacts::{Contacts, Sides};
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::{Direction, Dry, Face, Mode};
use studies::regimes::critical;
use symbolic::{Hypotheses, Sym};
use systems::rod::Rod;
use systems::slender_rod::SlenderRod;

use Condition::Equal;
use Direction::{Backwards, Forwards};

pub fn claims(page: &mut Page) {
    page.section("Rods with one contact");
    painleve(page);
    rod(page);
    uniform(page);
}

/// The determinant of a sliding regime, for the system at rest in a position; it does not depend on velocities and
/// forces.
pub fn slip_determinant<Q: Contacts<4, 1, 1, Given = Sym>>(system: &Q, place: [Sym; 4], direction: Direction) -> Sym {
    let zeros = [Sym::ZERO; 4];
    let at = State { time: Sym::ZERO, place, velocity: zeros };
    let dry = Dry::<Sym, 1>::of(system, &at, zeros);
    dry.map_or(Sym::UNDEFINED, |dry| Cramer::of(&dry, &[Mode::Slip(direction, Face::Front)]).determinant)
}

/// The coefficient of friction at which a determinant, affine in it, is zero.
fn critical_friction(determinant: impl Fn(Sym) -> Sym) -> Sym {
    let smooth = determinant(Sym::ZERO);
    smooth / (smooth - determinant(Sym::ONE))
}

/// Two mass points, the first on the guide.
fn painleve(page: &mut Page) {
    let [m, m1, l, g, f, x, k] = ["m", "m1", "l", "g", "f", "x", "k"].map(letter);
    let (theta, circle) = angle("c", "s");
    let (c, s) = (theta.cos, theta.sin);
    let rod = Rod { guided: m, free: m1, length: l, gravity: g, friction: f, sides: Sides::One };
    let place = [x, Sym::ZERO, x + l * c, l * s];
    for (slug, name, direction) in [("forwards", "D+", Forwards), ("backwards", "D-", Backwards)] {
        let printed = (m + m1 * c.powi(2) - direction.sign::<Sym>() * f * m1 * s * c) / (m * (m + m1));
        page.claim("painleve-rod", slug, format!(r"The rod of two mass points has the determinant below for the slip {slug}. For $0<\theta<\pi/2$ only that forwards can fail to be positive"))
            .under(&circle)
            .holds([Line::formula(slip_determinant(&rod, place, direction), letter(name), printed)]);
    }
    let critical = critical::two_masses(k, theta);
    let derived =
        critical_friction(|friction| slip_determinant(&Rod { friction, guided: k * m1, ..rod }, place, Forwards));
    page.claim("painleve-rod", "critical", "For the rod of two mass points, $k = m/m_1$, the determinant of the slip forwards vanishes at the critical friction $f_*$")
        .under(&circle)
        .holds([Line::formula(derived, letter("f*"), critical)]);
    let room = ((k + Sym::int(1)) * c.powi(2) - k * s.powi(2)) / (s * c);
    page.claim("painleve-rod", "minimum", r"For the rod of two mass points, $k = m/m_1$, $f_*^2 - 4k(k+1)$ is a square, so that the least critical friction is $2\sqrt{k(k+1)}$, at $\tan^2\theta = (k+1)/k$ and nowhere else")
        .under(&circle)
        .follows([Equal(critical.powi(2) - Sym::int(4) * k * (k + Sym::int(1)), room.powi(2))]);
}

/// A rod of mass m with the moment of inertia J = m l^2 / kappa about its centre of mass.
fn with_inertia(kappa: Sym, friction: Sym) -> SlenderRod<Sym> {
    let [m, l, g] = ["m", "l", "g"].map(letter);
    SlenderRod { mass: m, inertia: m * l.powi(2) / kappa, half_length: l, gravity: g, friction }
}

fn standing(theta: Circle<Sym>) -> [Sym; 4] {
    let [x, l] = ["x", "l"].map(letter);
    [x + l * theta.cos, l * theta.sin, theta.cos, theta.sin]
}

fn rod(page: &mut Page) {
    let [m, f, kappa] = ["m", "f", "kappa"].map(letter);
    let (theta, circle) = angle("c", "s");
    let (c, s) = (theta.cos, theta.sin);
    for (slug, name, direction) in [("forwards", "D+", Forwards), ("backwards", "D-", Backwards)] {
        let printed = (Sym::int(1) + kappa * c.powi(2) + direction.sign::<Sym>() * f * kappa * s * c) / m;
        page.claim("rod", slug, format!(r"A rod of moment of inertia $ml^2/\kappa$ about its centre, its lower end on the line at an angle $0<\theta<\pi/2$, has the determinant below for the slip {slug}. That backwards can vanish"))
            .under(&circle)
            .holds([Line::formula(slip_determinant(&with_inertia(kappa, f), standing(theta), direction), letter(name), printed)]);
    }
    let derived =
        critical_friction(|friction| slip_determinant(&with_inertia(kappa, friction), standing(theta), Backwards));
    page.claim(
        "rod",
        "critical",
        r"For a rod of moment of inertia $ml^2/\kappa$ about its centre the slip backwards is critical at this friction",
    )
    .under(&circle)
    .holds([Line::formula(derived, letter("f*"), critical::rod(kappa, theta))]);
    let square = critical::rod(kappa, theta).powi(2) - Sym::int(4) * (kappa + Sym::int(1)) / kappa.powi(2);
    let room = ((kappa + Sym::int(1)) * c.powi(2) - s.powi(2)) / (kappa * s * c);
    page.claim("rod", "minimum", r"For a rod of moment of inertia $ml^2/\kappa$ about its centre $f_*^2 - 4(\kappa+1)/\kappa^2$ is a square, so that the least critical friction is $2\sqrt{\kappa+1}/\kappa$, at $\tan^2\theta = \kappa+1$ and nowhere else")
        .under(&circle)
        .follows([Equal(square, room.powi(2))]);
}

/// The uniform rod, J = m l^2 / 3.
fn uniform(page: &mut Page) {
    let c = letter("c");
    let three = Sym::int(3);
    let at = |slope: i64| {
        let theta = Circle { cos: c, sin: Sym::int(slope) * c };
        (theta, Hypotheses::none().rule(c, 2, Sym::ratio(1, 1 + slope * slope)))
    };
    for (slug, says, slope, value) in [
        (
            "least",
            r"For the uniform rod the critical friction at $\tan\theta = 2$, where it is least, is $4/3$",
            2,
            Sym::ratio(4, 3),
        ),
        (
            "45-degrees",
            r"For the uniform rod the critical friction at $\theta = 45^\circ$ is $5/3$",
            1,
            Sym::ratio(5, 3),
        ),
    ] {
        let (theta, rules) = at(slope);
        let derived =
            critical_friction(|friction| slip_determinant(&with_inertia(three, friction), standing(theta), Backwards));
        page.claim("uniform-rod", slug, says).under(&rules).holds([Line::formula(derived, letter("f*"), value)]);
    }
}
