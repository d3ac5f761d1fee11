//! The sliders of Painleve and Klein, with contact on either side of the rough guide.

use super::alphabet::{angle, letter};
use claims::{Line, Page};
use mechanics::constrained::PointSystem;
use mechanics::constrained::State;
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::{Direction, Dry, Face, Mode, Touch, conditions};
use symbolic::Sym;
use systems::painleve_klein::PainleveKlein;

use Direction::Forwards;

pub fn claims(page: &mut Page) {
    page.section("Two masses on guides");
    let [m1, m2, l, f, x, p1, p2] = ["m1", "m2", "l", "f", "x", "P1", "P2"].map(letter);
    let (theta, circle) = angle("c", "s");
    let (c, s) = (theta.cos, theta.sin);
    let sliders = PainleveKlein { masses: [m1, m2], loads: [p1, p2], distance: l * s, length: l, friction: f };
    let at = State { time: Sym::ZERO, place: [x, Sym::ZERO, x + l * c, l * s], velocity: [Sym::ZERO; 4] };
    let Ok(dry) = Dry::<Sym, 2>::of(&sliders, &at, sliders.force(&at)) else { return };
    let smooth = Mode::Slip(Forwards, Face::Front);
    for (name, face) in [("pressed", Face::Front), ("pulled", Face::Back)] {
        let slug = name;
        let regime = [Mode::Slip(Forwards, face), smooth];
        let cramer = Cramer::of(&dry, &regime);
        let sign: Sym = face.sign();
        let total = m1 + m2;
        page.claim("sliders", slug, format!(r"Two masses on guides, sliding forwards with the rough guide {slug}, have the determinant below. For $0<\theta<\pi/2$ one face only can lose its sign, at $f m_2\tan\theta = m_1+m_2$"))
            .under(&circle)
            .holds([Line::formula(cramer.determinant, letter("det M"), c * (c * total + sign * f * m2 * s) / (m1 * m2 * total))]);
        let list = conditions(&dry, &[Touch::Slides(Forwards); 2], &regime);
        let Some((_, presses)) = list[0][0] else { continue };
        let slug = if face == Face::Front { "reaction-pressed" } else { "reaction-pulled" };
        let load = s * c * (p1 * m2 - p2 * m1) / (m1 * m2 * total);
        page.claim("sliders", slug, format!(r"If two masses on guides slide forwards with the rough guide {name}, its reaction times the determinant is minus that of the other face. The load alone decides the sign, so that one face is consistent where both determinants are positive, and both or none where one is negative. There is one motion for every load that presses if and only if $f m_2\tan\theta < m_1+m_2$"))
            .under(&circle)
            .holds([Line::formula(cramer.numerator(&presses), letter("N det M"), sign * load)]);
    }
}
