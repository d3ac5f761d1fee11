//! Section 2.2, additional results: Gauss' principle with friction that depends on the accelerations.

use super::alphabet::{exact, indexed, int, letter, letters, tidy};
use super::general::{Mixed, first_kind, mixed, with_friction};
use super::rod::RodLetters;
use claims::{Condition, Page};
use mechanics::constrained::gauss;
use symbolic::Sym;

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page, s: &RodLetters) {
    page.section("2.2. Gauss' principle and laws of friction");
    combined(page);
    of_the_guide(page, s);
}

type Four = [Sym; 4];

/// Claims on Painleve's friction, with mu_j a function of the accelerations.
fn combined(page: &mut Page) {
    let motion = mixed();
    let masses: Four = indexed("m#");
    let [p1, p2, mu1, mu2, change1, change2] = letters(["ṗ1", "ṗ2", "μ1", "μ2", "Δμ1", "Δμ2"]);
    let force = with_friction(motion.fields);
    let changed = force.map(|f| f.substitute(&[(mu1, mu1 + change1), (mu2, mu2 + change2)]));
    let displaced =
        |by: [Sym; 2]| -> Four { std::array::from_fn(|i| by[0] * motion.fields[0][i] + by[1] * motion.fields[1][i]) };
    // the work of R^n = m x'' - X - R^tau on the displacements of friction
    let works = |at: Four| {
        motion.fields.map(|field| (0..4).fold(Sym::ZERO, |sum, i| sum + (masses[i] * at[i] - force[i]) * field[i]))
    };
    let first = first_kind(&Mixed, &motion.state, force).acceleration;
    page.claim("section2.2-gauss", "ideal",r"At the accelerations (2.8) the forces of constraint do no work on the displacements of friction, $\sum R^n_\gamma\,\partial\dot x_\gamma/\partial p_j=0$ (four coordinates, one geometric and one nonlinear kinematic constraint)")
        .in_words()
        .follows(works(first).map(Zero));
    let at: Four = indexed("a#");
    let shift = displaced([p1, p2]);
    let moved: Four = std::array::from_fn(|i| at[i] + shift[i]);
    let excess = displaced([p1 - change1, p2 - change2]);
    let growth = Equal(
        gauss::constraint(masses, changed, moved) - gauss::constraint(masses, force, at),
        gauss::constraint(masses, [Sym::ZERO; 4], excess),
    );
    page.claim("section2.2-gauss", "law",r"Gauss' principle does not need friction to be held. Where $\mu_j$ becomes $\mu_j+\Delta\mu_j$ at the accelerations $\ddot x+\delta$, $\delta=\sum\dot p_j\partial\dot x/\partial p_j$, the function (2.21) grows by $\frac12\sum m(\delta-\sum\Delta\mu_j\,\partial\dot x/\partial p_j)^2$").in_words()
        .note("Where the growth is zero the other acceleration satisfies (2.8) with its own friction.")
        .given(works(at).map(Zero))
        .by_combination([(growth, vec![], vec![(0, p1 - change1), (1, p2 - change2)])]);
}

/// Claims on the tangential reaction of the guide.
fn of_the_guide(page: &mut Page, s: &RodLetters) {
    // the rod on the floor: the tangential reaction is f times the normal reaction from the accelerations by (1.39)
    let [_, ry] = s.contact_by(s.acceleration());
    let [lambda1, lambda] = s.multipliers(s.friction());
    let law = s.mu_by_law(int(1), lambda);
    let masses: Four = [s.m, s.m, s.m1, s.m1];
    let weights = s.given_force();
    let pushed = |tangential: Sym| -> Four { [weights[0] + tangential, weights[1], weights[2], weights[3]] };
    let constraint = gauss::constraint(masses, pushed(s.f * ry), s.acceleration());
    let held = letter("Rx");
    let frozen = gauss::constraint(masses, pushed(held), s.acceleration());
    let true_ones = {
        let normal = s.of_constraints(lambda1, lambda);
        let friction = s.friction();
        let at: Four = std::array::from_fn(|i| (weights[i] + normal[i] + friction[i]) / masses[i]);
        // x'' of M, and theta'' from the acceleration of M1 perpendicular to the rod
        let across = s.point.cos * at[3] - s.point.sin * (at[2] - at[0]);
        [(s.ddx, tidy(at[0])), (s.ddtheta, tidy(across / s.l))]
    };
    let along_motion = |slope: Sym| tidy(slope.substitute(&true_ones).substitute(&[(s.mu, tidy(law))]));
    let at = exact([
        ("m", 1, 1),
        ("m1", 1, 1),
        ("l", 1, 1),
        ("g", 1, 1),
        ("f", 1, 2),
        ("θ̇", 0, 1),
        ("cos θ", 3, 5),
        ("sin θ", 4, 5),
    ]);
    page.claim("section2.2-gauss", "held", "With the guide's tangential reaction $R_x$ as a force of fixed value in addition to the weights of the rod, (2.21) is stationary at the motion")
        .follows([s.ddx, s.ddtheta].map(|second| {
            let reaction = tidy(s.mobile() * law);
            Zero(along_motion(frozen.diff(second)).substitute(&[(held, reaction)]))
        }));
    page.claim("section2.2-gauss", "not-held",r"With $R_x=fR_y$ and $R_y$ by the accelerations (1.39), the function (2.21) need not be stationary at the motion of the rod that slides forward on a floor. In an example $\partial/\partial\ddot\theta$ of it differs from zero").note(r"Coulomb's force as a function of the accelerations must be held, or combined into $R^\tau$ first.").in_words()
        .given([Positive(s.m), Positive(s.m1), Positive(s.l), Positive(s.g), Positive(s.f)])
        .exists([NonZero(along_motion(constraint.diff(s.ddtheta)))], at);
}
