//! The ladder at rest: for every friction there is a load under which it may either rest or slide.
//!
//! One load has two sets of reactions. Their difference (sliding minus rest) is the force that accelerates the ladder
//! and contains one free number P. For two of the four friction limits at rest the margin grows with the reactions; the
//! other two are the margins studied here. Sliding down follows from sliding up if wall and floor, cos and sin are
//! exchanged.

use super::alphabet::{angle, letter};
use super::ladder::{DOWN, UP, leaning, principal_minors};
use claims::{Condition, Line, Page};
use field::{Circle, Scalar};
use mechanics::regimes::{Direction, Form};
use symbolic::Sym;

use Condition::{Equal, Positive};

pub fn claims(page: &mut Page) {
    page.section("The ladder at rest");
    for case in [&SLIDES_UP, &SLIDES_DOWN] {
        case.reactions(page);
        case.margins(page);
        case.ambiguous(page);
        case.only(page);
    }
}

/// A direction of sliding, described from the contact whose friction is decisive: the wall for upwards, the floor for
/// downwards.
struct Case {
    way: [Direction; 2],
    decides: usize,
    /// The range of angles in which rest and sliding are both possible, in LaTeX.
    steep: &'static str,
    sense: &'static str,
    slugs: [&'static str; 4],
    margins: [&'static str; 2],
}

const SLIDES_UP: Case = Case {
    way: UP,
    decides: 0,
    steep: r"\tan\alpha > 1/f_A",
    sense: "up",
    slugs: ["reactions", "margin", "ambiguous", "only"],
    margins: ["fA NA + TA", "fB NB - TB"],
};

const SLIDES_DOWN: Case = Case {
    way: DOWN,
    decides: 1,
    steep: r"\tan\alpha < f_B",
    sense: "down",
    slugs: ["reactions-down", "margin-down", "ambiguous-down", "only-down"],
    margins: ["fB NB + TB", "fA NA - TA"],
};

/// The reactions (N, T) at the decisive contact and at the other one.
type Reactions = [[Sym; 2]; 2];

/// The data of the construction, with the decisive contact first.
struct Data {
    /// cos and sin of the angle from the line of the decisive contact.
    angle: Circle<Sym>,
    kappa: Sym,
    friction: [Sym; 2],
    /// P: the normal reaction at the decisive contact at rest, minus that in sliding.
    surplus: Sym,
    normal: [Sym; 2],
}

impl Data {
    /// The force m l epsilon that corresponds to the acceleration of sliding.
    fn force() -> Sym {
        let [m, l, eps] = ["m", "l", "eps"].map(letter);
        eps * m * l
    }

    /// The factor (kappa - 1) / (2 kappa).
    fn share(&self) -> Sym {
        (self.kappa - Sym::int(1)) / (Sym::int(2) * self.kappa)
    }

    /// The reactions of sliding: on the friction cones, opposite to the sliding velocity.
    fn sliding(&self) -> Reactions {
        let ([f1, f2], [n1, n2]) = (self.friction, self.normal);
        [[n1, -f1 * n1], [n2, f2 * n2]]
    }

    /// The reactions at rest: those of sliding minus the part that accelerates the ladder.
    fn resting(&self) -> Reactions {
        let (force, p, Circle { cos, sin }) = (Self::force(), self.surplus, self.angle);
        let [[n1, t1], [n2, t2]] = self.sliding();
        let fall = (force * self.share() - cos * p) / sin;
        [[n1 + p, t1 - force * sin + fall], [n2 - fall, t2 + force * cos - p]]
    }

    /// The margins of the friction limits at rest, in the direction opposite to sliding.
    fn margins(&self) -> [Sym; 2] {
        let ([f1, f2], [[n1, t1], [n2, t2]]) = (self.friction, self.resting());
        [f1 * n1 + t1, f2 * n2 - t2]
    }
}

impl Case {
    /// A pair reordered from (wall, floor) to (decisive, other), or back.
    fn ordered<T: Copy>(&self, [a, b]: [T; 2]) -> [T; 2] {
        if self.decides == 0 { [a, b] } else { [b, a] }
    }

    fn angle(&self, alpha: Circle<Sym>) -> Circle<Sym> {
        let [cos, sin] = self.ordered([alpha.cos, alpha.sin]);
        Circle { cos, sin }
    }

    /// The data with every symbol free.
    fn data(&self, alpha: Circle<Sym>) -> Data {
        let [fa, fb, na, nb, kappa, surplus] = ["fA", "fB", "nA", "nB", "kappa", "P"].map(letter);
        let (friction, normal) = (self.ordered([fa, fb]), self.ordered([na, nb]));
        Data { angle: self.angle(alpha), kappa, friction, surplus, normal }
    }

    fn reactions(&self, page: &mut Page) {
        let [l, eps] = ["l", "eps"].map(letter);
        let (alpha, circle) = angle("ca", "sa");
        let data = self.data(alpha);
        let Some(dry) = leaning(alpha, data.kappa, self.ordered(data.friction)) else { return };
        let [slides, rests] = [data.sliding(), data.resting()].map(|pair| self.ordered(pair));
        let turned = if self.decides == 0 { -eps } else { eps };
        let two = Sym::int(2);
        let motion = [Sym::ZERO, -(two * l * alpha.sin * turned), Sym::ZERO, two * l * alpha.cos * turned];
        let names = ["anA", "atA", "anB", "atB"].map(letter);
        let sense = self.sense;
        page.claim("ladder-rest", self.slugs[0], format!(r"For every number $P$ there are reactions of the ladder at rest and of its slide {sense}, on the limits of friction, whose difference turns it with $|\ddot\alpha| = \varepsilon$ and gives the contacts the normal and tangential accelerations below"))
            .under(&circle)
            .holds((0..4).map(|j| {
                let form = |reactions: &Reactions| Form { ..dry.acceleration(j / 2, j % 2) }.at(reactions);
                Line::formula(form(&slides) - form(&rests), names[j], motion[j])
            }));
    }

    fn margins(&self, page: &mut Page) {
        let (alpha, circle) = angle("ca", "sa");
        let data = self.data(alpha);
        let (force, p, h, Circle { cos, sin }) = (Data::force(), data.surplus, data.share(), data.angle);
        let [f1, f2] = data.friction;
        let printed =
            [p * (f1 * sin - cos) - force * (sin.powi(2) - h), p * (sin + f2 * cos) - force * (sin * cos + f2 * h)];
        let names = self.margins.map(letter);
        let steep = self.steep;
        page.claim(
            "ladder-rest",
            self.slugs[1],
            format!(
                r"The two limits of friction of the ladder at rest that the slide {} would pass have these margins for the reactions with the number $P$. For ${steep}$ both grow with $P$",
                self.sense
            ),
        )
        .under(&circle)
        .holds((0..2).map(|k| Line::formula(data.margins()[k], names[k], printed[k] / sin)));
    }

    /// The claims with tan = (1 + u / cos) / f at the decisive contact and kappa = 1 + v.
    fn ambiguous(&self, page: &mut Page) {
        let [m, l, eps, u, v] = ["m", "l", "eps", "u", "v"].map(letter);
        let (alpha, _) = angle("ca", "sa");
        let free = self.data(alpha);
        let ([_, f2], [n1, n2], Circle { cos, sin }) = (free.friction, free.normal, free.angle);
        let kappa = Sym::int(1) + v;
        let share = Data { kappa, ..self.data(alpha) }.share();
        let surplus = Data::force() * (cos + share / cos + sin.powi(2) / u);
        let normal = [n1, n2 + surplus / (Sym::int(2) * f2)];
        let data = Data { friction: [(cos + u) / sin, f2], kappa, surplus, normal, ..free };
        let [slides, rests] = [data.sliding(), data.resting()];
        let both = |[f, n, t]: [Sym; 3]| [n, f * n + t, f * n - t];
        let limits = (0..2).flat_map(|k| both([data.friction[k], rests[k][0], rests[k][1]]));
        let (wall, floor) = if self.decides == 0 { ("A", "B") } else { ("B", "A") };
        let (c, s) = if self.decides == 0 { (r"\cos\alpha", r"\sin\alpha") } else { (r"\sin\alpha", r"\cos\alpha") };
        let (steep, sense) = (self.steep, self.sense);
        page.claim("ladder-rest", self.slugs[2], format!(r"For ${steep}$, all friction $f_{floor}>0$ and every moment of inertia $ml^2/\kappa$, $\kappa>1$, one load lets the ladder stay, within all limits of friction, or slide {sense}. With $P = \varepsilon ml\,({c} + h/{c} + ({s})^2/u)$, $h = (\kappa-1)/(2\kappa)$, $u = f_{wall}\,{s} - {c} > 0$, and $n_{floor}$ larger by $P/(2f_{floor})$, all normal reactions and all margins are positive. Each $f_{wall}>0$ has such angles"))
            .given([m, l, eps, u, v, cos, sin, f2, n1, n2].map(Positive))
            .in_words()
            .by_signs(limits.chain(slides.map(|[normal, _]| normal)).map(Positive));
    }

    /// The claims by elimination of P.
    fn only(&self, page: &mut Page) {
        let (alpha, circle) = angle("ca", "sa");
        let data = self.data(alpha);
        let Some(dry) = leaning(alpha, data.kappa, self.ordered(data.friction)) else { return };
        let [.., both] = principal_minors(&dry, self.way);
        let ([f1, f2], Circle { cos, sin }) = (data.friction, data.angle);
        let [first, second] = data.margins();
        let m = letter("m");
        let sum = first * (sin + f2 * cos) + second * (cos - f1 * sin);
        let derived = -(sum * Sym::int(2) * data.kappa / (Data::force() * m.powi(2)));
        let (a, b) = if self.decides == 0 { ("A", "B") } else { ("B", "A") };
        let (c, s) = if self.decides == 0 { (r"\cos\alpha", r"\sin\alpha") } else { (r"\sin\alpha", r"\cos\alpha") };
        let flat = self.steep.replace('>', r"\le").replace('<', r"\ge");
        let sense = self.sense;
        page.claim("ladder-rest", self.slugs[3], format!(r"For the ladder at rest and its slide {sense}, the limits $f_{a}N_{a}+T_{a}$, $f_{b}N_{b}-T_{b}$ times $({s} + f_{b}{c})$, $({c} - f_{a}{s})$, added, are $-\varepsilon ml\,m^2/(2\kappa)$ times the determinant of the slide. If ${flat}$, both agree with one load only if that determinant is not positive"))
            .under(&circle)
            .in_words()
            .follows([Equal(both, derived)]);
    }
}
