//! Section 1.3, task 2: the ladder's motion, (1.101)-(1.107).

use super::alphabet::{exact, int, letter, letters, tidy};
use super::ladder::LadderLetters;
use claims::{Condition, Line, Page};
use mechanics::constrained::multipliers::multipliers;
use mechanics::constrained::{PointSystem, kinetic_energy};
use symbolic::Sym;

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page, s: &LadderLetters) {
    page.section("1.3. Task 2, the ladder's motion");
    friction(page, s);
    reactions(page, s);
    normal_reactions_and_friction(page, s);
    equation(page, s);
}

fn friction(page: &mut Page, s: &LadderLetters) {
    let (c, sin, l) = (s.point.cos, s.point.sin, s.l);
    let motion = s.motion();
    let half = int(1) / int(2);
    page.claim(
        "eq1.101",
        "kinetic-energy",
        "The velocity of the centre of mass and the kinetic energy are those of (1.101)",
    )
    .holds([
        Line::formula(motion.state.velocity[0], letter("ẋ"), l * c * s.dalpha),
        Line::formula(motion.state.velocity[1], letter("ẏ"), -l * sin * s.dalpha),
        Line::formula(
            kinetic_energy(s.ladder.masses(), motion.state.velocity),
            letter("T"),
            half * (s.m * l.powi(2) + s.inertia) * s.dalpha.powi(2),
        ),
    ]);
    let [at_a, at_b, turned] = letters(["RAτ", "RBτ", "δα"]);
    let [work] = motion.generalised(s.reactions([Sym::ZERO; 2], [at_a, at_b]));
    page.claim(
        "eq1.101",
        "work",
        "The work of friction, counted upwards at $A$ and towards $O$ at $B$, is that of (1.101)",
    )
    .holds([Line::formula(work * turned, letter("δAτ"), -int(2) * l * (at_a * sin + at_b * c) * turned)]);
    page.claim("eq1.102", "generalised-force", "The generalised force of friction is (1.102)").holds([Line::formula(
        work,
        letter("Qτ"),
        -int(2) * l * (at_a * sin + at_b * c),
    )]);
    let positive = [Positive(l), Positive(at_a), Positive(at_b), Positive(sin), Positive(c)];
    page.claim(
        "eq1.102",
        "initial-motion",r"Friction of the printed directions brakes the motion that the problem names, $B$ approaching $O$: $\dot\alpha<0$",
    ).why(r"The printed directions of friction are those of a ladder that slides down, $B$ moving away from $O$.")
    .given(positive)
    .given([Positive(-s.dalpha)])
    .refuted(
        [Positive(tidy(-(work * s.dalpha)))],
        exact([("l", 1, 1), ("RAτ", 1, 1), ("RBτ", 1, 1), ("sin α", 3, 5), ("cos α", 4, 5), ("α̇", -1, 1)]),
    );
    let [cos, sine, speed] = letters(["cos", "sin", "v"]);
    let renamed = [(c, cos), (sin, sine), (s.dalpha, speed / l)];
    page.claim(
        "eq1.102",
        "initial-motion-corrected",r"Friction of the printed directions brakes a ladder that slides down, $\dot\alpha=v/l>0$, with $\alpha$ in the first quadrant",
    )
    .given([Positive(l), Positive(at_a), Positive(at_b), Positive(sine), Positive(cos), Positive(speed)])
    .by_signs([Positive(tidy(-(work * s.dalpha)).substitute(&renamed))]);
    page.correct();
    let [push_a, push_b] = letters(["RAn", "RBn"]);
    page.claim(
        "eq1.103",
        "coulomb",
        r"(1.103) is Coulomb's law for sliding down, $\dot\alpha>0$, while both reactions push",
    )
    .defines([
        Line::equation(Sym::ZERO, at_a, s.at_wall * push_a),
        Line::equation(Sym::ZERO, at_b, s.at_floor * push_b),
    ]);
}

fn reactions(page: &mut Page, s: &LadderLetters) {
    let (c, sin, l, m, g) = (s.point.cos, s.point.sin, s.l, s.m, s.g);
    let [push_a, push_b, at_a, at_b] = letters(["RAn", "RBn", "RAτ", "RBτ"]);
    let [ddx, ddy, ..] = s.turning();
    let [name_x, name_y] = letters(["ẍG", "ÿG"]);
    let named = [name_x, name_y, Sym::ZERO, Sym::ZERO];
    let (by_x, by_y) = (l * c * s.ddalpha - l * sin * s.dalpha.powi(2), -l * (sin * s.ddalpha + c * s.dalpha.powi(2)));
    page.claim("eq1.104", "acceleration", "The acceleration of the centre is that of (1.104)")
        .holds([Line::formula(ddx, name_x, by_x), Line::formula(ddy, name_y, by_y)]);
    let missing = s.newton(s.turning(), s.reactions([push_a, push_b], [at_a, at_b]));
    page.claim(
        "eq1.104",
        "centre",
        "The theorem of the centre of mass, with the acceleration of the centre, is (1.104)",
    )
    .holds([
        Line::equation(missing[0], m * by_x, push_a - at_b),
        Line::equation(missing[1], m * by_y, push_b + at_a - m * g),
    ]);
    let (wall, floor) = (s.at_wall, s.at_floor);
    let both = int(1) + wall * floor;
    let [by_x, by_y] = s.normal_reactions_at(named);
    page.claim(
        "eq1.105",
        "by-centre",
        "The normal reactions, expressed by the acceleration of the centre, are (1.105)",
    )
    .reading(r"The text names $R^\tau$; $R^n$ is read, since the formulas are the normal reactions.")
    .holds([
        Line::formula(by_x, push_a, m * (name_x + floor * (name_y + g)) / both),
        Line::formula(by_y, push_b, m * (name_y - wall * name_x + g) / both),
    ]);
    let [derived_a, derived_b] = s.normal_reactions();
    let (turn, spin) = (s.ddalpha, s.dalpha.powi(2));
    page.claim("eq1.105", "by-angle", "The normal reactions, expressed by the angle, are (1.105)").holds([
        Line::formula(derived_b, push_b, -(m / both * (l * (sin + wall * c) * turn + l * (c - wall * sin) * spin - g))),
        Line::formula(
            derived_a,
            push_a,
            m / both * ((-floor * sin + c) * l * turn - l * (floor * c + sin) * spin + floor * g),
        ),
    ]);
}

/// Claims on the statement on Appell's conclusion in the introduction of the task.
fn normal_reactions_and_friction(page: &mut Page, s: &LadderLetters) {
    let [derived_a, _] = s.normal_reactions();
    let at_rest = derived_a.substitute(&[(s.dalpha, Sym::ZERO), (s.ddalpha, s.acceleration())]);
    let still = tidy(s.uniform(tidy(at_rest.substitute(&[(s.dalpha, Sym::ZERO)]))));
    let f = letter("f");
    let smooth = tidy(still.substitute(&[(f, Sym::ZERO)]));
    page.claim("eq1.105", "unjustified",r#"As printed, "a normal reaction that depends on friction is not justified". Then $R_A^n$ of the uniform ladder that begins to slide would be the one without friction"#).why(r"By (1.105) the normal reactions of rough walls depend on $f$. Only the multipliers of the constraints do not; they are not normal reactions.")
        .given([Positive(s.m), Positive(s.g), Positive(f)])
        .refuted([Equal(still, smooth)], exact([
            ("m", 1, 1), ("g", 1, 1), ("f", 1, 5), ("sin α", 4, 5), ("cos α", 3, 5),
        ]));
    let p = letter("μ1");
    let masses: [Sym; 4] = s.ladder.masses();
    let state = s.motion().state;
    let weight: [Sym; 4] = s.ladder.force(&state);
    let field = s.motion().fields[0];
    let force = std::array::from_fn(|i| weight[i] + masses[i] * p / s.l * field[i]);
    let free = multipliers(&s.ladder, &state, force).map_or([Sym::UNDEFINED; 3], |reaction| reaction.multipliers);
    page.claim(
        "eq1.105",
        "unjustified-corrected",
        r"The multipliers of rigidity, wall and floor do not depend on friction $m_k\delta\vec r_k$ of any size",
    )
    .follows(free.map(|multiplier| Zero(multiplier.diff(p))));
    page.correct();
}

fn equation(page: &mut Page, s: &LadderLetters) {
    let (c, sin, l, m, g) = (s.point.cos, s.point.sin, s.l, s.m, s.g);
    let (wall, floor) = (s.at_wall, s.at_floor);
    let (turn, spin) = (s.ddalpha, s.dalpha.powi(2));
    let both = int(1) + wall * floor;
    let two = int(2);
    let [push_a, push_b] = s.normal_reactions();
    let [work] = s.motion().generalised(s.reactions([Sym::ZERO; 2], [wall * push_a, floor * push_b]));
    page.claim("eq1.106", "friction", "The generalised force of friction, expressed by the angle, is that of (1.106)")
        .holds([Line::formula(
            work,
            letter("Qτ"),
            -(two * m / both
                * (l.powi(2) * ((wall - floor) * sin * c - wall * floor) * turn
                    - l.powi(2) * (wall * sin.powi(2) + floor * c.powi(2)) * spin))
                - two * m * l / both * (wall * sin + c) * floor * g,
        )]);
    let weight: [Sym; 4] = s.ladder.force(&s.motion().state);
    let [fall] = s.motion().generalised(weight);
    page.claim("eq1.106", "weight", "The generalised force of the weight is that of (1.106)").holds([Line::formula(
        fall,
        letter("Q"),
        m * g * l * sin,
    )]);
    let balance = s.balance();
    page.claim("eq1.106", "motion", "The equation of motion of the ladder with friction is that of (1.106)").holds([
        Line::equation(
            balance,
            (m * l.powi(2) + s.inertia + two * l.powi(2) * m / both * ((wall - floor) * sin * c - wall * floor)) * turn,
            two * m * l.powi(2) / both * (wall * sin.powi(2) + floor * c.powi(2)) * spin
                - two * m * l / both * (wall * sin + c) * floor * g
                + m * g * l * sin,
        ),
    ]);
    let f = letter("f");
    let equal = balance.substitute(&[(wall, f), (floor, f)]);
    let both = int(1) + f.powi(2);
    page.claim("eq1.107", "equal-friction", "The equation of motion of the ladder with $f_A=f_B=f$ is (1.107)").holds(
        [Line::equation(
            equal,
            (m * l.powi(2) + s.inertia - two * l.powi(2) * m / both * f.powi(2)) * turn,
            two * m * l.powi(2) / both * f * spin - two * m * l / both * (f * sin + c) * f * g + m * g * l * sin,
        )],
    );
    let [third] = [m * l.powi(2) / int(3)];
    page.claim("eq1.107", "denominator",r"The coefficient of $\ddot\alpha$ for the uniform ladder is $\frac23ml^2(2-f^2)/(1+f^2)$, which vanishes at $f^2=2$ alone").in_words()
        .given([NonZero(both)])
        .follows([Equal(
            equal.diff(turn).substitute(&[(s.inertia, third)]),
            two / int(3) * m * l.powi(2) * (two - f.powi(2)) / both,
        )]);
}
