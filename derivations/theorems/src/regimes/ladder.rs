//! The ladder in motion: the coefficient of friction up to which its motion is unique.

use super::alphabet::{angle, letter};
use claims::{Condition, Line, Page, Point};
use field::{Circle, Rational, Scalar};
use mechanics::constrained::State;
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::{Direction, Dry, Face, Mode};
use studies::regimes::critical;
use symbolic::Sym;
use systems::ladder::Ladder;

use Condition::{Equal, Positive};
use Direction::{Backwards, Forwards};

/// Sliding down: A moves backwards along the wall, B forwards along the floor.
pub const DOWN: [Direction; 2] = [Backwards, Forwards];
pub const UP: [Direction; 2] = [Forwards, Backwards];

pub fn claims(page: &mut Page) {
    page.section("The ladder in motion");
    minors(page);
    moving(page);
}

/// The ladder of mass m and moment of inertia m l^2 / kappa on wall and floor, without load.
pub fn leaning(alpha: Circle<Sym>, kappa: Sym, friction: [Sym; 2]) -> Option<Dry<Sym, 2>> {
    let [m, l, g] = ["m", "l", "g"].map(letter);
    let ladder = Ladder { mass: m, inertia: m * l.powi(2) / kappa, half_length: l, gravity: g, friction };
    let zeros = [Sym::ZERO; 4];
    let place = [l * alpha.sin, l * alpha.cos, alpha.cos, alpha.sin];
    Dry::of(&ladder, &State { time: Sym::ZERO, place, velocity: zeros }, zeros).ok()
}

/// The principal minors for a pair of sliding directions: wall only, floor only, both.
pub fn principal_minors(dry: &Dry<Sym, 2>, [wall, floor]: [Direction; 2]) -> [Sym; 3] {
    let (a, b) = (Mode::Slip(wall, Face::Front), Mode::Slip(floor, Face::Front));
    [[a, Mode::Apart], [Mode::Apart, b], [a, b]].map(|regime| Cramer::of(dry, &regime).determinant)
}

fn minors(page: &mut Page) {
    let [m, kappa, fa, fb] = ["m", "kappa", "fA", "fB"].map(letter);
    let (alpha, circle) = angle("ca", "sa");
    let (c, s) = (alpha.cos, alpha.sin);
    let Some(dry) = leaning(alpha, kappa, [fa, fb]) else { return };
    let one = Sym::int(1);
    for (slug, way, sign) in [("down", DOWN, one), ("up", UP, -one)] {
        let derived = principal_minors(&dry, way);
        let both = one + kappa + sign * Sym::int(2) * kappa * s * c * (fa - fb) + (one - kappa) * fa * fb;
        let printed = [
            (one + kappa * c.powi(2) + sign * fa * kappa * s * c) / m,
            (one + kappa * s.powi(2) - sign * fb * kappa * s * c) / m,
            both / m.powi(2),
        ];
        let names = ["M11", "M22", "det M"].map(letter);
        page.claim("ladder-minors", slug, format!(r"The ladder with the moment of inertia $ml^2/\kappa$, sliding {slug}, has the principal minors below of $M$ in $a_n = b_n + MN$. By the theorem of Samelson, Thrall and Wesler (1958), which is cited and not proved here, the motion is determined under every load if and only if all of them are positive"))
            .under(&circle)
            .holds((0..3).map(|i| Line::formula(derived[i], names[i], printed[i])));
    }
    page.claim("ladder-minors", "single", r"The minor of the floor alone is zero at $f_* = (1+\kappa\sin^2\alpha)/(\kappa\sin\alpha\cos\alpha)$, and $f_*^2 - 4(\kappa+1)/\kappa^2$ is a square that vanishes at one angle. For $f_B<2\sqrt{\kappa+1}/\kappa$ that minor of the ladder sliding down is positive at every angle $0<\alpha<\pi/2$, but not for greater $f_B$. The wall's minor when sliding up has $\pi/2-\alpha$ for $\alpha$")
        .in_words()
        .under(&circle)
        .follows([Equal(
            critical::rod(kappa, Circle { cos: s, sin: c }).powi(2) - Sym::int(4) * (kappa + one) / kappa.powi(2),
            (((kappa + one) * s.powi(2) - c.powi(2)) / (kappa * s * c)).powi(2),
        )]);
}

fn moving(page: &mut Page) {
    let [m, l, f, fa, u, v] = ["m", "l", "f", "fA", "u", "v"].map(letter);
    let (alpha, circle) = angle("ca", "sa");
    let (c, s) = (alpha.cos, alpha.sin);
    let uniform = |friction| leaning(alpha, Sym::int(3), friction);
    let Some(equal) = uniform([f, f]) else { return };
    let two = Sym::int(2);
    for (slug, sense, way) in [("determinant-down", "down", DOWN), ("determinant-up", "up", UP)] {
        page.claim("ladder-moving", slug, format!("For the uniform ladder with equal friction, sliding {sense}, the determinant of both slips is positive if and only if $f^2<2$, at every angle"))
            .under(&circle)
            .holds([Line::formula(principal_minors(&equal, way)[2], letter("det M"), two * (two - f.powi(2)) / m.powi(2))]);
    }
    let floor = principal_minors(&equal, DOWN)[1];
    let q = Rational::new;
    let point = Point::of([(f, q(27, 20)), (c, q(15, 17)), (s, q(8, 17)), (m, q(1, 1)), (l, q(1, 1))]);
    page.claim("ladder-moving", "root-two", r"All principal minors of the uniform ladder with $f^2<2$ on wall and floor are positive while it slides down, the floor's among them")
        .under(&circle)
        .given([Positive(two - f.powi(2)), Positive(f), Positive(s), Positive(c), Positive(m)])
        .why("The determinant of both slips is positive for $f^2<2$, but the floor's own minor is negative at steep enough friction. At this state, without rotation, the ladder's own weight leaves no motion. If the rotation is fast enough to lift the ladder, there are two motions.")
        .refuted([Positive(floor)], point);
    // f = 4 / (3 (1 + u)), which is less than 4/3
    let below = Sym::ratio(4, 3) / (Sym::int(1) + u);
    let Some(dry) = uniform([below, below]) else { return };
    let derived = principal_minors(&dry, DOWN);
    let (one, names) = (Sym::int(1), ["M11", "M22", "det M"].map(letter));
    let printed = [
        (one + Sym::int(3) * c.powi(2)) / m + Sym::int(4) * s * c / (m * (one + u)),
        ((c - two * s).powi(2) + u * (c.powi(2) + Sym::int(4) * s.powi(2))) / (m * (one + u)),
        two * (two - Sym::ratio(16, 9) / (one + u).powi(2)) / m.powi(2),
    ];
    page.claim("ladder-moving", "four-thirds", r"All principal minors of the uniform ladder with $f = \frac43/(1+u)$, $u>0$, that is $f<4/3$ on wall and floor, are positive while it slides down")
        .under(&circle)
        .holds((0..3).map(|i| Line::formula(derived[i], names[i], printed[i])));
    page.correct();
    // unequal friction: sin cos is at most 1/2, and the larger coefficient is 4/3 - v
    let larger = Sym::ratio(4, 3) - v;
    let room = Sym::int(4) - Sym::int(3) * (larger - fa) - two * fa * larger;
    page.claim("ladder-moving", "unequal", r"For the uniform ladder sliding down with $0<f_A\le f_B = 4/3 - v$, $v>0$, the bound $4 - 3(f_B-f_A) - 2f_Af_B = f_A/3 + v(3+2f_A)$ of $m^2\det M$ (regimes/ladder-moving/bound) is positive")
        .given([Positive(fa), Positive(v)])
        .by_signs([Positive(room)]);
    let Some(dry) = uniform([fa, larger]) else { return };
    let excess = Sym::int(3) * (larger - fa) * (s - c).powi(2);
    page.claim(
        "ladder-moving",
        "bound",
        r"For the uniform ladder sliding down with $f_B=4/3-v$, $m^2\det M$ exceeds $4 - 3(f_B-f_A) - 2f_Af_B$ by $3(f_B-f_A)(\sin\alpha-\cos\alpha)^2$",
    )
    .under(&circle)
    .holds([Line::formula(principal_minors(&dry, DOWN)[2], letter("det M"), (room + excess) / m.powi(2))]);
}
