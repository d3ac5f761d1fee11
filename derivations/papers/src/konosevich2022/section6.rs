//! Section 6: conditions under which steady states are motions.

use super::alphabet::{current, letter, number, one};
use super::gyrostats;
use super::letters::Letters;
use super::section3::{driven, excess_friction, friction, motor_with};
use claims::{Condition, Line, Page};
use field::Circle;
use machines::asynchronous::Asynchronous;
use machines::synchronous::Synchronous;
use mechanics::momentum::absolute_rate;
use motor::{Machine, torque_and_current_rates};
use num_traits::Zero;
use symbolic::{Hypotheses, Sym};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("6. Conditions of stationary motions");
    currents(page, s);
    angles(page, s);
    rotation_about_the_vertical(page, s);
    conditions(page, s);
    remarks(page, s);
}

/// Claims on (6.1): for g' = 0 and constant currents the equations of the windings reduce to R i = 0.
fn currents(page: &mut Page, s: &Letters) {
    let windings = [(letter("L1"), letter("R1"), letter("x")), (letter("L2"), letter("R2"), current(1))];
    let (_, rates) = driven(s.motor(1), s, &s.currents(1));
    let at_rest = [0, 1].map(|k| (windings[k].0 * rates[k]).substitute(&[(s.dgamma, Sym::ZERO)]));
    page.claim("eq6.1", "currents", r"With $R_1, R_2 > 0$ the constant currents of the excitation and of a bar at any angle vanish at $\dot\gamma = 0$. By (3.3) no winding's equation contains another winding's current, so that one bar stands for each, for every $n_2$")
        .given(windings.map(|(_, resistance, _)| Condition::Positive(resistance)))
        .given(at_rest.map(Condition::Zero))
        .by_combination([0, 1].map(|k| (Condition::Zero(windings[k].2), vec![k], vec![(k + 2, number(-1, 1))])));
    page.claim("section6-currents", "resistances", r"Both resistances are needed: with $R_1 = 0$ every constant current of the excitation satisfies its equation at $\dot\gamma = 0$, and with $R_2 = 0$ so does every constant current of a bar")
        .in_words()
        .follows([0, 1].map(|k| Condition::Zero(at_rest[k].substitute(&[(windings[k].1, Sym::ZERO)]))));
    let bars = 3;
    let (_, rates) = driven(s.motor(bars), s, &s.currents(bars));
    page.claim(
        "section6-currents",
        "apart",
        r"No winding's equation contains another winding's current, here with $n_2 = 3$ bars at any angles",
    )
    .in_words()
    .follows((0..=bars as usize).flat_map(|k| {
        let others = (0..=bars as usize).filter(move |&j| j != k);
        let rate = rates[k];
        let currents = s.currents(bars);
        others.map(move |j| Condition::Zero(rate.diff(currents[j])))
    }));
    page.claim("eq6.2", "state", r"A stationary state has constant $\omega^0, \nu^0, \gamma^0$, and zeros elsewhere")
        .defines([]);
}

/// Claims on (6.3) and the two families of angles.
fn angles(page: &mut Page, s: &Letters) {
    let bars = 3;
    let zeros = vec![Sym::zero(); 1 + bars as usize];
    let (moment, _) = driven(s.motor(bars), s, &zeros);
    let at_rest = moment.substitute(&[(s.dgamma, Sym::ZERO)]);
    let sine = s.angle().sin;
    page.claim(
        "eq6.3",
        "angle",
        r"$M = 0$ at rest without currents is $b_0\sin\gamma^0 + c_0 = 0$, with $c_0 = -M_2(\Omega)$",
    )
    .holds([Line::equation(-at_rest, s.b0 * sine - friction(s.omega_field), Sym::ZERO)]);
    page.claim("eq6.3", "rotor", "The rotor's equation (4.5), derived from the bodies, is $M = 0$ at a constant state")
        .in_words()
        .under(&s.unit_axis)
        .follows([Condition::Equal(
            s.in_axes_of_a_star().by_momentum(&s.stationary(s.omega_field, s.torque))[3],
            -s.torque,
        )]);

    // the two families as circle points: (C, -r) with the cosine C > 0, and its point at -pi minus the angle
    let (cosine, ratio) = (letter("C"), letter("r"));
    let first = Circle { cos: cosine, sin: -ratio };
    let half_turn = Circle { cos: number(-1, 1), sin: Sym::ZERO };
    let second = -half_turn - first;
    let on_circle = Condition::Zero(first.defect());
    let balance = |p: Circle<Sym>| s.b0 * p.sin + s.c0;
    page.claim(
        "section6-gamma",
        "families",
        r"$\gamma^{(0)} = -\arcsin r$ and $\gamma^{(1)} = -\pi-\gamma^{(0)}$, $r = c_0/b_0$, both satisfy (6.3)",
    )
    .in_words()
    .given([Condition::Zero(s.b0 * ratio - s.c0)])
    .by_combination([first, second].map(|p| (Condition::Zero(balance(p)), vec![], vec![(0, number(-1, 1))])));
    page.claim("section6-gamma", "ranges", r"If $0 < r < 1$, so that $C = \sqrt{1-r^2} > 0$, then $\gamma^{(0)}$ lies in the fourth quadrant and $\gamma^{(1)}$ in the third: $\cos\gamma^{(0)} > 0 > \sin\gamma^{(0)}$ and $\cos\gamma^{(1)} < 0$, $\sin\gamma^{(1)} < 0$")
        .in_words()
        .given([Condition::Positive(cosine), Condition::Positive(ratio)])
        .by_signs([first.cos, -first.sin, -second.cos, -second.sin].map(Condition::Positive));
    let any = Circle { cos: letter("c"), sin: letter("s") };
    page.claim(
        "section6-gamma",
        "no-others",
        r"A point $(c,s)$ of the circle with $b_0s + c_0 = 0$ has $(c-C)(c+C) = 0$, so that up to turns the families $\gamma^{(0)}$ and $\gamma^{(1)}$ are the only ones",
    )
    .given([Condition::NonZero(s.b0), Condition::Zero(s.b0 * ratio - s.c0), on_circle])
    .given([Condition::Zero(any.defect()), Condition::Zero(balance(any))])
    .note(r"At $c_0 = b_0$ both families become one ($C = 0$). Beyond it there is none: the motor loses synchronism.")
    .by_combination([(
        Condition::Zero((any.cos - cosine) * (any.cos + cosine)),
        vec![0, 0],
        vec![(1, s.b0 * ratio + s.c0), (2, -(s.b0 * s.b0)), (3, s.b0 * s.b0), (4, s.c0 - s.b0 * any.sin)],
    )]);
}

/// Claims on (6.4) and statement 1.
fn rotation_about_the_vertical(page: &mut Page, s: &Letters) {
    let (w, nu) = (s.w, s.nu);
    let turning = nu.cross(&w);
    page.claim(
        "eq6.4",
        "parallel",
        r"$\omega\times\nu = 0$ gives $\omega = \omega^0\nu$ with $\omega^0 = \omega\cdot\nu$",
    )
    .under(&s.unit_vertical)
    .given(turning.iter().map(|&x| Condition::Zero(x)))
    .by_combination((0..3).map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        // w - (w.nu) nu = (nu x w) x nu
        (Condition::Equal(w[i], w.dot(&nu) * nu[i]), vec![], vec![(j, nu[k]), (k, -nu[j])])
    }));
    page.claim("eq6.4", "sufficient", r"$\omega = \omega^0\nu$ gives $\dot\nu = \nu\times\omega = 0$")
        .in_words()
        .follows(nu.cross(&(nu * s.omega0)).iter().map(|&x| Condition::Zero(x)));
    let x = s.in_axes_of_a_star().angular_momentum(nu * s.omega0, s.omega_field)[0];
    page.claim("statement1", "rest-or-rotation", r"At $\omega = \omega^0\nu$ the weight has no power, $\omega\cdot(\Gamma e\times\nu) = 0$, and the vertical part of the angular momentum has no rate, $\nu\cdot(x\times\omega) = 0$. With $\omega^0 = 0$ the carrier rests, otherwise it turns about the vertical")
        .in_words()
        .under(&s.unit_axis)
        .follows([
            Condition::Zero((nu * s.omega0).dot(&(s.e.cross(&nu) * s.big_gamma))),
            // the precession of the momentum with w leaves only its vertical component constant
            Condition::Zero(x.cross(&(nu * s.omega0)).dot(&nu)),
        ]);
}

/// Claims on (6.5) from the bodies, statement 2 and remark 3.
fn conditions(page: &mut Page, s: &Letters) {
    let g = s.in_axes_of_a_star();
    let residual = g.by_momentum(&s.stationary(s.omega_field, Sym::ZERO));
    let printed = s.conditions();
    let still = absolute_rate(s.nu.map(field::Tangent::fixed), s.w);
    let bars = 3;
    let currents = s.currents(bars);
    let (_, rates) = driven(s.motor(bars), s, &currents);
    let windings = (0..=bars as usize).map(|k| {
        let (l, r) = if k == 0 { ("L1", "R1") } else { ("L2", "R2") };
        Condition::Equal(-(letter(l) * rates[k]).substitute(&[(s.dgamma, Sym::ZERO)]), letter(r) * currents[k])
    });
    page.claim("eq6.5", "relations", "The carrier's equations at a constant state are (6.5)")
        .reading("The third relation is damaged in the text at hand; cyclic permutation of the other two restores it.")
        .under(&s.unit_axis)
        .holds((0..3).map(|i| Line::equation(-residual[i], printed[i], Sym::ZERO)));
    page.claim("statement2", "conditions", r"At a constant state the residual of (5.2) is that of (6.5), the residual of (4.5) is $-M$ of (6.3), that of (4.6) at any constant $\omega$ is $\omega\times\nu$ of (6.4), and those of (4.7) are $R_1x$, $R_2i_n$ of (6.1), here with $n_2 = 3$. No further condition remains")
        .in_words()
        .under(&s.unit_axis)
        .follows(
            (0..3)
                .map(|i| Condition::Equal(residual[i], -printed[i]))
                .chain([Condition::Equal(g.by_momentum(&s.stationary(s.omega_field, s.torque))[3], -s.torque)])
                .chain((0..3).map(|i| Condition::Equal(still[i], s.w.cross(&s.nu)[i])))
                .chain(windings),
        );

    page.claim("remark3", "identity", r"$\nu\cdot(6.5) = 0$ holds identically")
        .follows([Condition::Zero(s.nu.dot(&printed))]);
    let zero = [Condition::Zero(printed.x), Condition::Zero(printed.y)];
    page.claim("remark3", "any-one", "Each of the three relations (6.5) follows from the other two")
        .given(zero)
        .given([Condition::Zero(s.nu.dot(&s.nu) - one())])
        .why(r"Where $\nu_3 = 0$ the third relation is independent of the first two.")
        .refuted([Condition::Zero(printed.z)], gyrostats::two_of_three().point(s));
    page.claim(
        "remark3",
        "where",
        r"The third relation of (6.5) follows from the other two where $\nu_3 \neq 0$. Cyclic permutation of the axes gives the other cases, and $|\nu| = 1$ implies that some $\nu_k \neq 0$",
    )
    .given(zero)
    .given([Condition::NonZero(s.nu.z)])
    .by_combination([(Condition::Zero(printed.z), vec![2], vec![(0, -s.nu.x), (1, -s.nu.y)])]);
    page.correct();
}

/// Claims on remarks 1 and 2: models without currents as special cases of that with currents.
fn remarks(page: &mut Page, s: &Letters) {
    let none = ["μ", "a1", "a2"].map(|name| (letter(name), Sym::ZERO));
    let bars = 3;
    let (many, _) = driven(motor_with(s, bars, &none), s, &s.currents(bars));
    let (single, _) = driven(Synchronous { field_speed: s.omega_field, b0: s.b0, f: Sym::zero() }, s, &[]);
    page.claim(
        "remark1",
        "synchronous",
        r"$\mu = a_1 = a_2 = 0$ in (3.4) gives the synchronous motor without currents, here from $n_2 = 3$",
    )
    .in_words()
    .follows([Condition::Equal(many, single)]);

    let all: Vec<_> = ["μ", "a1", "a2", "b0"].map(|name| (letter(name), Sym::ZERO)).to_vec();
    let (rest, _) = driven(motor_with(s, bars, &all), s, &s.currents(bars));
    let excess = rest - friction(s.omega_field);
    page.claim(
        "remark2",
        "formal",
        r"$\mu = a_1 = a_2 = b_0 = c_0 = 0$ in (3.4) leaves $M = \Delta M_2(\dot\gamma)$, a function of the speed alone, here from $n_2 = 3$",
    )
    .in_words()
    .follows([Condition::Equal(excess, excess_friction(s))]);
    // a linear asynchronous motor near its working speed
    let [k, f, working] = ["k", "f", "Ω′"].map(letter);
    let machine = Asynchronous { field_speed: s.omega_field, k, f };
    let slip = s.dgamma + working - machine.frame_speed();
    let moment = torque_and_current_rates(&machine, Circle::zero(), slip, &[], &mut []);
    page.claim(
        "remark2",
        "asynchronous",
        r"The moment of the linear asynchronous motor about $\Omega'$ is a function of the speed alone",
    )
    .under(&Hypotheses::none().given(working, k * s.omega_field / (k + f)))
    .holds([Line::formula(moment, s.torque, -((k + f) * s.dgamma))]);
    let by_momentum = s.in_axes_of_a_star().by_momentum(&s.stationary(working, Sym::ZERO));
    let printed = s.conditions().map(|x| x.substitute(&[(s.omega_field, working)]));
    page.claim(
        "remark2",
        "conditions",
        r"The stationary motions with an asynchronous motor satisfy (6.5) with $\Omega'$ in the place of $\Omega$",
    )
    .under(&s.unit_axis)
    .follows((0..3).map(|i| Condition::Equal(-by_momentum[i], printed[i])));
}
