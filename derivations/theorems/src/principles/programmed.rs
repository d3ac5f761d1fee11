//! Programmed constraints: multipliers for which the violations y of the constraints satisfy y'' = Y, compared with
//! Lagrange's multipliers.
//!
//! The theorem concerns symbolic masses, rows and rates. For each system it is shown that the second derivatives of its
//! constraints are affine in the accelerations, with these rows, on and off the constraints.

use super::alphabet::{letter, letters};
use super::any::{AnySystem, dot, numbered};
use super::cases;
use claims::{Condition, Page};
use mechanics::constrained::multipliers::{Reaction, leading_to};
use mechanics::constrained::programmed::{Linear, Violation, programmed, violation};
use mechanics::constrained::rates::{jacobian, rates};
use mechanics::constrained::{Constrained, PointSystem, State, gauss};
use symbolic::Sym;

use Condition::{Equal, Zero};

pub fn claims(page: &mut Page) {
    page.section("Programmed constraints");
    let mut exact = Vec::new();
    exact.extend(led::<2, 1>().into_iter().chain(led::<3, 1>()).chain(led::<3, 2>()).chain(led::<4, 2>()));
    page.claim("programmed", "exact", r"With $JM^{-1}J^T\lambda = Y-(\text{rates at }M^{-1}X)$ the violations satisfy $\ddot y=Y$ ($\dot\varphi=Y$ for a kinematic constraint) exactly, for all masses, rows and $Y$, $(N,C)=(2,1),(3,1),(3,2),(4,2)$; $\lambda-\lambda^{(0)}$, the excess over Lagrange's, is $(JM^{-1}J^T)^{-1}Y$")
        .in_words()
        .follows(exact);
    least::<3, 1>(page, "least-3-1");
    least::<4, 2>(page, "least-4-2");
    affine(page);
    off_constraints(page);
    linear(page);
    drift(page);
}

/// The conditions that the second derivatives of the constraints are Y, and that (J M^-1 J^T)(lambda - lambda_0) = Y.
fn led<const N: usize, const C: usize>() -> Vec<Condition> {
    let any = AnySystem::<N, C>::new();
    let (force, wanted): ([Sym; N], [Sym; C]) = (numbered("X"), numbered("Y1"));
    let at = anywhere();
    let lagrange = any.under(force).multipliers;
    let reaction = or_undefined(&any, &at, force, wanted);
    let found = rates(&any, &at, reaction.acceleration);
    let excess: [Sym; C] = std::array::from_fn(|k| reaction.multipliers[k] - lagrange[k]);
    let pushed = any.matrix().map(|row| dot(row, excess));
    (0..C).flat_map(|k| [Equal(found[k], wanted[k]), Equal(pushed[k], wanted[k])]).collect()
}

fn anywhere<const N: usize>() -> State<Sym, N> {
    State { time: letter("t"), place: [Sym::ZERO; N], velocity: [Sym::ZERO; N] }
}

fn or_undefined<Q: Constrained<N, C, Given = Sym>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<Sym, N>,
    force: [Sym; N],
    wanted: [Sym; C],
) -> Reaction<Sym, N, C> {
    let undefined = Reaction { acceleration: [Sym::UNDEFINED; N], multipliers: [Sym::UNDEFINED; C] };
    leading_to(system, at, force, wanted).unwrap_or(undefined)
}

/// Gauss' principle: these accelerations minimise the constraint among all accelerations with the same second
/// derivatives Y.
fn least<const N: usize, const C: usize>(page: &mut Page, slug: &'static str) {
    let any = AnySystem::<N, C>::new();
    let (force, wanted, shift): ([Sym; N], [Sym; C], [Sym; N]) = (numbered("X"), numbered("Y1"), numbered("δ"));
    let first = or_undefined(&any, &anywhere(), force, wanted);
    let moved = std::array::from_fn(|i| first.acceleration[i] + shift[i]);
    let growth = gauss::constraint(any.masses, force, moved) - gauss::constraint(any.masses, force, first.acceleration);
    let square = mechanics::constrained::kinetic_energy(any.masses, shift);
    page.claim("programmed", slug, format!(r"Among all accelerations with $\ddot y=Y$ that by $J^T\lambda$ has the least constraint $Z$ (Gauss), since $Z(\ddot x+\delta)-Z(\ddot x)=\frac12\sum m\delta^2$ for every $\delta$ with $J\delta=0$; $(N,C)=({N},{C})$"))
        .in_words()
        .given(any.along_rows(shift).map(Zero))
        .by_combination([(Equal(growth, square), vec![], first.multipliers.into_iter().enumerate().collect())]);
}

/// States of the rod, the steered rod, the ladder and the disc at which the constraints are not satisfied.
struct Places {
    four: State<Sym, 4>,
    ladder: State<Sym, 4>,
    disc: State<Sym, 9>,
}

fn places() -> Places {
    let time = letter("t");
    Places {
        four: State { time, place: numbered("x"), velocity: numbered("ẋ") },
        ladder: State {
            time, place: letters(["x1", "x2", "c", "s"]), velocity: letters(["ẋ1", "ẋ2", "ċ", "ṡ"])
        },
        disc: State {
            time,
            place: letters(["x1", "x2", "x3", "e1", "e2", "e3", "n1", "n2", "n3"]),
            velocity: letters(["ẋ1", "ẋ2", "ẋ3", "ė1", "ė2", "ė3", "ṅ1", "ṅ2", "ṅ3"]),
        },
    }
}

/// The condition rates(x'') - rates(0) = J x''.
fn affine_at<Q: Constrained<N, C, Given = Sym>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<Sym, N>,
    acceleration: [Sym; N],
) -> impl Iterator<Item = Condition> {
    let (with, without) = (rates(system, at, acceleration), rates(system, at, [Sym::ZERO; N]));
    let rows = jacobian(system, at);
    (0..C).map(move |k| Equal(with[k] - without[k], dot(rows[k], acceleration)))
}

fn affine(page: &mut Page) {
    let at = places();
    let lengths: [Sym; 4] = numbered("ẍ");
    let ladder = letters(["ẍ1", "ẍ2", "c̈", "s̈"]);
    let disc = letters(["ẍ1", "ẍ2", "ẍ3", "ë1", "ë2", "ë3", "n̈1", "n̈2", "n̈3"]);
    page.claim("programmed", "affine", r"The rates of the constraints of the rod, the steered rod, the ladder and the rolling disc are $J\ddot x$ and what does not contain $\ddot x$, on the constraints or off them, so that principles/programmed/exact applies wherever the rows are independent")
        .in_words()
        .follows(
            affine_at::<_, 4, 2>(&cases::rod().system, &at.four, lengths)
                .chain(affine_at::<_, 4, 3>(&cases::steered_rod().system, &at.four, lengths))
                .chain(affine_at::<_, 4, 3>(&cases::ladder().system, &at.ladder, ladder))
                .chain(affine_at::<_, 9, 6>(&cases::disc().system, &at.disc, disc)),
        );
}

/// The condition y'' = Y at a state where the constraints are not satisfied.
fn led_at<Q: Constrained<N, C, Given = Sym>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<Sym, N>,
    wanted: [Sym; C],
) -> impl Iterator<Item = Condition> {
    let reaction = or_undefined(system, at, system.force(at), wanted);
    let found = rates(system, at, reaction.acceleration);
    (0..C).map(move |k| Equal(found[k], wanted[k]))
}

fn off_constraints(page: &mut Page) {
    let at = places();
    page.claim("programmed", "systems", r"Painlevé's rod, the steered rod (one kinematic constraint) and the ladder have violations with $\ddot y=Y$, $\dot\varphi=Y$ for every $Y$, at any place and velocity, constraints kept or not")
        .in_words()
        .follows(
            led_at(&cases::rod().system, &at.four, letters(["Y21", "Y11"]))
                .chain(led_at(&cases::steered_rod().system, &at.four, letters(["Y21", "Y22", "Y11"])))
                .chain(led_at(&cases::ladder().system, &at.ladder, letters(["Y01", "Y11", "Y12"]))),
        );
}

/// Baumgarte's law, and the law that treats the violations as a system with energies.
fn linear(page: &mut Page) {
    let case = cases::steered_rod();
    let at = places().four;
    let [alpha, beta] = letters(["κ", "ω"]);
    let law: Linear<Sym, 3> = Linear::baumgarte(alpha, beta);
    let found = programmed(&case.system, &law, &at, case.system.force(&at));
    let acceleration = found.map_or([Sym::UNDEFINED; 4], |reaction| reaction.acceleration);
    let (moved, y): ([Sym; 3], Violation<Sym, 3>) =
        (rates(&case.system, &at, acceleration), violation(&case.system, &at));
    let two = alpha + alpha;
    page.claim("programmed", "baumgarte", r"Baumgarte's stabilisation is the law $Y=-2\kappa\dot y-\omega^2y$, for a kinematic constraint $Y=-2\kappa\varphi$. The steered rod's violations obey $\ddot y+2\kappa\dot y+\omega^2y=0$ and $\dot\varphi+2\kappa\varphi=0$ exactly")
        .in_words()
        .follows([
            Zero(moved[0] + two * y.rate[0] + beta * beta * y.value[0]),
            Zero(moved[1] + two * y.rate[1]),
            Zero(moved[2] + two * y.rate[2] + beta * beta * y.value[2]),
        ]);
    let any = AnySystem::<3, 2>::new();
    let square = |stem: &str| [[1, 2], [2, 3]].map(|row| row.map(|k| letter(&format!("{stem}{k}"))));
    let (a, c, k) = (square("a"), square("γ"), square("k"));
    let at = State { velocity: numbered("ẋ"), ..anywhere() };
    let law = Linear::of_energies(a, c, k);
    let found = law.map(|law| programmed(&any, &law, &at, numbered("X")));
    let acceleration = found.map_or([Sym::UNDEFINED; 3], |r| r.map_or([Sym::UNDEFINED; 3], |r| r.acceleration));
    let (moved, y) = (rates(&any, &at, acceleration), violation(&any, &at));
    page.claim("programmed", "energies", r"For violations $y$ with an inertia $a$ and a friction $\gamma$, symmetric and not diagonal, $a\ddot y+\gamma\dot y=0$ holds as it is written for the kinematic constraints of any system, $(N,C)=(3,2)$")
        .in_words()
        .follows((0..2).map(|row| Zero(dot(a[row], moved) + dot(c[row], y.rate))));
}

/// Lagrange's multipliers where the constraints are not satisfied.
fn drift(page: &mut Page) {
    let at = places();
    let rod = cases::rod().system;
    page.claim("programmed", "drift", r"Lagrange's multipliers are the law $Y=0$: off the constraints of the rod they leave $\ddot y=0$, $y=y_0+\dot y_0t$, and off those of the steered rod $\dot\varphi=0$ besides. A geometric constraint drifts away linearly, a kinematic one keeps its error")
        .in_words()
        .follows(led_at(&rod, &at.four, [Sym::ZERO; 2]).chain(led_at(
            &cases::steered_rod().system,
            &at.four,
            [Sym::ZERO; 3],
        )));
}
