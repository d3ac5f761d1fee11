//! Section 4: constraints, Lagrange's equations with multipliers, violations and their prescribed law, (5)-(10).

use super::alphabet::{dot, exact, indexed, int, letter, letters};
use super::general::{General, instant, led};
use claims::{Condition, Line, Page};
use field::Tangent;
use mechanics::constrained::multipliers::{Reaction, multipliers as lagrange};
use mechanics::constrained::programmed::{Linear, programmed, violation};
use mechanics::constrained::rates::{jacobian, rates};
use mechanics::constrained::{Constrained, Constraint, PointSystem, State};
use mechanics::differentiate::{fixed, gradient};
use symbolic::Sym;
use systems::prescribed_speed_point::PrescribedSpeedPoint;

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page) {
    page.section("4. Constraints and multipliers");
    constraints(page);
    multipliers(page);
    programme(page);
    page.section("4. What multipliers from the differentiated constraint do");
    instability(page);
}

/// Claims on (5), (6).
fn constraints(page: &mut Page) {
    let at = instant();
    let [geometric, _] = violation(&General, &at).rate;
    let printed = dot(indexed("f#"), at.velocity) + letter("ft");
    page.claim("eq5", "rate", r"(5) is $\dot f=\frac{\partial f}{\partial q^s}\dot q^s+\frac{\partial f}{\partial t}$, for a constraint that is arbitrary to the second order")
        .holds([Line::formula(geometric, letter("ḟ"), printed)]);
    page.claim("eq6", "kinematic", r"(6) are constraints on the velocities, $\dot f^\rho(q,\dot q,t)=0$, linear in them or not. The claims have one, $\varphi(q,\dot q,t)=0$, arbitrary to the first order, in the velocities to the second")
        .note("The dot on $f^\\rho$ says that these stand together with the rates of (5). $f^\\rho$ itself does not exist where they are not integrable.")
        .defines([]);
}

/// Claims on (7), (8).
fn multipliers(page: &mut Page) {
    let displacement: [Sym; 3] = indexed("δq#");
    let [row, across] = jacobian(&General, &instant());
    let missing: [Sym; 3] = indexed("R#");
    // virtual displacements, by solving the constraints for the first two components
    let minor = row[0] * across[1] - row[1] * across[0];
    let lambda = [missing[0] * across[1] - missing[1] * across[0], missing[1] * row[0] - missing[0] * row[1]];
    let free = [row[1] * across[2] - row[2] * across[1], row[2] * across[0] - row[0] * across[2], minor];
    page.claim("eq7", "multipliers", r"By d'Alembert's and Lagrange's principle, forces $R_i$ of constraint that do no work on any displacement with $\frac{\partial\dot f^\kappa}{\partial\dot q^i}\delta q^i=0$ are $\lambda_\kappa\frac{\partial\dot f^\kappa}{\partial\dot q^i}$, here with three coordinates, one geometric and one kinematic constraint")
        .in_words()
        .given([NonZero(minor), Zero(dot(missing, free))])
        .by_combination((0..3).map(|i| {
            let of = lambda[0] * row[i] + lambda[1] * across[i];
            (Equal(missing[i], of / minor), vec![0], if i == 2 { vec![(1, int(1))] } else { vec![] })
        }));
    page.claim("eq7", "displacements", r"Every displacement that a geometric and a kinematic constraint of three coordinates allow is a multiple of the vector product of their two rows, here where $\delta q^3$ is free").in_words()
        .given([Zero(dot(row, displacement)), Zero(dot(across, displacement)), NonZero(minor)])
        .by_combination((0..2).map(|i| {
            let (a, b) = if i == 0 { (across[1], -row[1]) } else { (-across[0], row[0]) };
            (Equal(displacement[i], displacement[2] * free[i] / minor), vec![2], vec![(0, a), (1, b)])
        }));
    let by_velocity = gradient(
        |v| {
            let constraints: [Constraint<Tangent<Sym>>; 2] = General.constraints(&State {
                time: Tangent::fixed(Sym::ZERO),
                place: fixed([Sym::ZERO; 3]),
                velocity: v,
            });
            constraints[0].value()
        },
        instant().velocity,
    );
    let (l, r1) = (letter("λ"), letter("R1"));
    page.claim("eq7", "reaction", r"$R_i=\lambda\frac{\partial f^\kappa}{\partial\dot q^i}$ of (7) is the reaction of a geometric constraint too")
        .why("A geometric $f(q,t)$ does not contain $\\dot q$: the dot of $\\dot f^\\kappa$ is missing.")
        .reading("The index of $\\lambda_\\kappa$ is missing in the text, and the dot of $\\dot f^\\kappa$ also in $df^\\kappa/dt=0$ below.")
        .fails([Line::formula(l * row[0], r1, l * by_velocity[0])]);
    let first_rate = gradient(
        |v| {
            let place = std::array::from_fn(|i| Tangent::moving(Tangent::fixed(Sym::ZERO), v[i]));
            let time = Tangent::variable(Tangent::fixed(Sym::ZERO));
            let velocity = fixed(v);
            let constraints: [Constraint<Tangent<Tangent<Sym>>>; 2] =
                General.constraints(&State { time, place, velocity });
            constraints[0].value().slope
        },
        instant().velocity,
    );
    page.claim(
        "eq7",
        "reaction-corrected",
        r"The reaction is $\lambda\frac{\partial\dot f^\kappa}{\partial\dot q^i}$ with $\dot f^\kappa$ from (5), for $\frac{\partial\dot f}{\partial\dot q^i}=\frac{\partial f}{\partial q^i}$",
    )
    .in_words()
    .follows((0..3).map(|i| Equal(first_rate[i], row[i])));
    page.correct();
    page.claim("eq8", "initial", "(8) are the initial coordinates and velocities, which need not satisfy (5) and (6). Their residuals are the first values of the parameters (9)")
        .defines([]);
}

/// Claims on (9), (10).
fn programme(page: &mut Page) {
    let at = instant();
    let found = violation(&General, &at);
    let [rows, across] = jacobian(&General, &at);
    page.claim("eq9", "parameters", r"(9) introduces the parameters $y=f(q,t)$, $\dot y=\dot f$ of a geometric constraint and $\dot y=\varphi$ of a kinematic one, which are values and rates of the violated constraints")
        .defines([
            Line::formula(found.value[0], letter("y"), letter("f")),
            Line::formula(found.rate[0], letter("ẏ"), letter("ḟ")),
        ]);
    let wanted = indexed("Y#");
    let reaction = led(wanted);
    let moved = rates(&General, &at, reaction.acceleration);
    page.claim("eq10", "exact", r"For every $Y$ there are multipliers with which (10), $\ddot y=Y$, $\dot\varphi=Y$, holds exactly, off the constraints too, wherever $\det JM^{-1}J^T\ne0$. Masses and forces are arbitrary, with one geometric and one kinematic constraint arbitrary to the second order")
        .in_words()
        .follows((0..2).map(|k| Equal(moved[k], wanted[k])));
    let masses: [Sym; 3] = General.masses();
    let forced: [Sym; 3] = General.force(&at);
    page.claim(
        "eq10",
        "reactions",
        r"The accelerations of eq10/exact are those of the given forces together with $\lambda_\kappa\frac{\partial\dot f^\kappa}{\partial\dot q^i}$",
    )
    .in_words()
    .follows((0..3).map(|i| {
        let push = reaction.multipliers[0] * rows[i] + reaction.multipliers[1] * across[i];
        Equal(masses[i] * reaction.acceleration[i], forced[i] + push)
    }));
    let law = Linear {
        damping: [letters(["k₂₂", "k₂₃"]), letters(["k₃₂", "k₃₃"])],
        stiffness: [letters(["k₁₂", "k₁₃"]), letters(["κ₂₁", "κ₂₂"])],
    };
    let undefined = Reaction { acceleration: [Sym::UNDEFINED; 3], multipliers: [Sym::UNDEFINED; 2] };
    let stabilised = programmed(&General, &law, &at, forced).unwrap_or(undefined);
    // on the constraints: f = 0, f' = 0, phi = 0, as values of these symbols
    let [f, ft, phi] = letters(["f", "ft", "ϕ"]);
    let kept = [(f, Sym::ZERO), (ft, ft - found.rate[0]), (phi, phi - found.rate[1])];
    page.claim("eq10", "trivial", r"With $Y=-c\dot y-ky$ and any matrices, the multipliers are Lagrange's wherever both constraints and the rate of the geometric one are kept. A motion that begins there is that of Lagrange's equations")
        .in_words()
        .follows((0..2).map(|k| {
            let lagrange = led([Sym::ZERO; 2]).multipliers[k];
            Equal(stabilised.multipliers[k].substitute(&kept), lagrange.substitute(&kept))
        }));
}

/// Claims on the drift of violations.
fn instability(page: &mut Page) {
    let at = instant();
    let moved = rates(&General, &at, led([Sym::ZERO; 2]).acceleration);
    page.claim("section5-instability", "rates", r"With multipliers from the differentiated constraints, $\ddot f=0$ and $\dot\varphi=0$, the rates off the constraints are exactly $\ddot y=0$, $\dot\varphi=0$, hence $y=y_0+\dot y_0t$ and $\varphi=\varphi_0$")
        .in_words()
        .follows(moved.map(Zero));
    let [dy0, b, t] = letters(["ẏ₀", "b", "t"]);
    let drifted = dy0 * t;
    let reached = drifted.substitute(&[(t, b / dy0)]);
    page.claim("section5-instability", "geometric", r"A geometric constraint is unstable. The error $y=\dot y_0t$ has the rate $\ddot y$ that multipliers from $\ddot f=0$ leave, and reaches any bound $b>0$ at the time $b/\dot y_0$, for every $\dot y_0>0$")
        .in_words()
        .given([Positive(b), Positive(dy0)])
        .follows([Equal(drifted.diff(t).diff(t), moved[0]), Equal(reached, b)]);
    let [mass, gravity, speed, u, v] = letters(["m", "g", "v0", "q̇1", "q̇2"]);
    let point = PrescribedSpeedPoint { mass, gravity, speed, acceleration: Sym::ZERO };
    let at = State { time: Sym::ZERO, place: [Sym::ZERO; 2], velocity: [u, v] };
    let kept = lagrange(&point, &at, point.force(&at)).map_or([Sym::UNDEFINED; 2], |reaction| reaction.acceleration);
    let [rate]: [Sym; 1] = rates(&point, &at, kept);
    let [error]: [Sym; 1] = violation(&point, &at).rate;
    page.claim("section5-instability", "kinematic", r"Multipliers from $\dot\varphi=0$ make a kinematic constraint unstable: where $\varphi\ne0$, $|\varphi|$ grows, $\varphi\dot\varphi>0$. The point that keeps its speed is judged, $\varphi=\frac12(\dot q_1^2+\dot q_2^2-v_0^2)$")
        .in_words()
        .given([NonZero(error)])
        .why(r"Multipliers from $\dot\varphi=0$ keep $\varphi$ as it is; only a method of integration adds errors to it, step by step.")
        .refuted(
            [Positive(error * rate)],
            exact([("m", 1, 1), ("g", 1, 1), ("v0", 1, 1), ("q̇1", 2, 1), ("q̇2", 1, 1)]),
        );
    page.claim(
        "section5-instability",
        "kinematic-corrected",
        r"The error of a kinematic constraint stays as it is, stable but not asymptotically stable: $\dot\varphi=0$ for every velocity, place and force",
    )
    .in_words()
    .follows([Zero(moved[1])]);
    page.correct();
    euler(page);
}

/// Claims on one step of Euler's method on a circle: the error of the method.
fn euler(page: &mut Page) {
    let [x, y, u, v, h] = letters(["x₁", "x₂", "q̇1", "q̇2", "h"]);
    // f = (x^2 + y^2 - rho^2)/2 without forces: x'' = lambda x with x.x'' = -v^2 and x.x' = 0
    let f = |x: Sym, y: Sym| (x * x + y * y) / int(2);
    let square = u * u + v * v;
    let lambda = -(square / (x * x + y * y));
    let (after, moved) = ((x + h * u, y + h * v), (u + h * lambda * x, v + h * lambda * y));
    page.claim("section5-instability", "euler", r"For a point on a circle with multipliers from $\ddot f=0$, and with $\dot f=0$, each step of Euler's method adds $\frac12h^2v^2$ to $f=\frac12(x^2+y^2-\rho^2)$ and nothing to $\dot f$. The sum over a time $t$, about $\frac12thv^2$ while $v$ changes little, is an estimate and not proved")
        .in_words()
        .given([Zero(x * u + y * v)])
        .by_combination([
            (Equal(f(after.0, after.1) - f(x, y), h * h * square / int(2)), vec![], vec![(0, h)]),
            (
                Zero(after.0 * moved.0 + after.1 * moved.1),
                vec![],
                vec![(0, int(1) + h * h * lambda)],
            ),
        ]);
}
