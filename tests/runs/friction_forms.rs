//! Sliding with friction by every form of the equations, from one state over an interval without events: in Cartesian
//! coordinates by Lagrange's equations of the first kind and by the contact regimes; in a chart by Lagrange's equations
//! of the second kind and by Appell's; and by the papers' printed equations after correction.

use claims::{Claim, Line, Statement};
use dalembert_derivations::papers::manglieva2022;
use dalembert_derivations::systems::ladder::Ladder;
use dalembert_derivations::systems::rod::Rod;
use dalembert_derivations::systems::steered_rod::SteeredRod;
use field::{Analytic, Over, Rational, Scalar};
use integrators::{Method, Ode, Span, System as Law, Tolerance, integrate};
use mechanics::constrained::contacts::{Closed, Contacts, Sides};
use mechanics::constrained::motion::{Motion, velocity};
use mechanics::constrained::multipliers::multipliers;
use mechanics::constrained::{Charted, Constrained, State, appell, second_kind};
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::{Consistency, Direction, Dry, Face, Mode, Seen, Touch, verdict};
use symbolic::{Sym, Tape};

const G: f64 = 9.81;
const END: f64 = 0.1;

/// A system with all contacts closed and sliding; the directions are 1 (forwards) and -1 (backwards).
#[derive(Clone, Copy)]
struct Sliding<Q, const C: usize, const K: usize> {
    closed: Closed<Q, C, K>,
    ways: [f64; K],
}

impl<Q, const C: usize, const K: usize> Sliding<Q, C, K> {
    /// The given force together with the friction of the normal reactions. These depend on the friction in turn, so
    /// that a linear system is solved.
    fn force<S, const D: usize>(&self, at: &State<S, 4>) -> [S; 4]
    where
        Q: Contacts<4, C, K, Given = f64>,
        Closed<Q, C, K>: Constrained<4, D, Given = f64>,
        S: Over<f64>,
    {
        use mechanics::constrained::PointSystem;
        let given: [S; 4] = self.closed.force(at);
        let seen = Seen::of(&self.closed.0, at, given).expect("regular");
        let with = |normal: [S; K]| -> [S; 4] {
            std::array::from_fn(|i| {
                (0..K).fold(given[i], |sum, k| {
                    sum - S::lift(self.ways[k]) * seen.dry.friction[k] * normal[k] * seen.directions[k][1][i]
                })
            })
        };
        let normal = |force| -> [S; K] {
            let found = multipliers::<_, S, 4, D>(&self.closed, at, force).expect("regular").multipliers;
            std::array::from_fn(|k| found[C + k])
        };
        let free = normal(with([S::zero(); K]));
        let columns: [[S; K]; K] = std::array::from_fn(|j| {
            let unit = std::array::from_fn(|k| if k == j { S::one() } else { S::zero() });
            let moved = normal(with(unit));
            std::array::from_fn(|k| unit[k] - (moved[k] - free[k]))
        });
        with(cramer(columns, free))
    }
}

/// The solution of one or two linear equations, given by columns.
fn cramer<S: Scalar, const K: usize>(columns: [[S; K]; K], right: [S; K]) -> [S; K] {
    if K == 1 {
        return [right[0] / columns[0][0]; K];
    }
    let det = |a: [S; K], b: [S; K]| a[0] * b[1] - a[1] * b[0];
    let whole = det(columns[0], columns[1]);
    std::array::from_fn(|k| if k == 0 { det(right, columns[1]) / whole } else { det(columns[0], right) / whole })
}

/// Lagrange's equations of the first kind, m x'' = X + R + lambda df/dx, in all coordinates.
struct FirstKind<Q, const C: usize, const K: usize, const D: usize>(Sliding<Q, C, K>);

impl<Q, S, const C: usize, const K: usize, const D: usize> Ode<S> for FirstKind<Q, C, K, D>
where
    Q: Contacts<4, C, K, Given = f64>,
    S: Over<f64> + Analytic,
{
    fn dimension(&self) -> usize {
        8
    }

    fn rates(&self, time: S, y: &[S], dy: &mut [S]) {
        let at = State { time, place: std::array::from_fn(|i| y[i]), velocity: std::array::from_fn(|i| y[4 + i]) };
        let force = self.0.force::<S, D>(&at);
        let found = multipliers::<_, S, 4, D>(&self.0.closed, &at, force).expect("regular");
        dy[..4].copy_from_slice(&at.velocity);
        dy[4..].copy_from_slice(&found.acceleration);
    }
}

impl<Q: Contacts<4, C, K, Given = f64>, const C: usize, const K: usize, const D: usize> Law for FirstKind<Q, C, K, D> {}

/// The equations of the regime in which every contact slides in its direction.
struct InRegime<Q, const C: usize, const K: usize>(Sliding<Q, C, K>);

impl<Q: Contacts<4, C, K, Given = f64>, const C: usize, const K: usize> InRegime<Q, C, K> {
    fn directions(&self) -> [Direction; K] {
        self.0.ways.map(|way| if way > 0.0 { Direction::Forwards } else { Direction::Backwards })
    }

    /// Whether this regime is the only possible motion at a state.
    fn is_the_motion(&self, at: &State<f64, 4>) -> bool {
        let system = &self.0.closed.0;
        let dry = Dry::of(system, at, system.force(at)).expect("regular");
        let found = verdict(&dry, &self.directions().map(Touch::Slides));
        matches!(found, Consistency::Unique(found) if found.regime == self.regime())
    }

    fn regime(&self) -> [Mode; K] {
        self.directions().map(|direction| Mode::Slip(direction, Face::Front))
    }
}

impl<Q, S, const C: usize, const K: usize> Ode<S> for InRegime<Q, C, K>
where
    Q: Contacts<4, C, K, Given = f64>,
    S: Over<f64> + Analytic,
{
    fn dimension(&self) -> usize {
        8
    }

    fn rates(&self, time: S, y: &[S], dy: &mut [S]) {
        let at = State { time, place: std::array::from_fn(|i| y[i]), velocity: std::array::from_fn(|i| y[4 + i]) };
        let system = &self.0.closed.0;
        let seen = Seen::<S, 4, K>::of::<_, C>(system, &at, system.force(&at)).expect("regular");
        dy[..4].copy_from_slice(&at.velocity);
        dy[4..].copy_from_slice(&seen.acceleration(&Cramer::of(&seen.dry, &self.regime()).reactions()));
    }
}

impl<Q: Contacts<4, C, K, Given = f64>, const C: usize, const K: usize> Law for InRegime<Q, C, K> {}

/// The sliding motion in the chart (q, p), by Lagrange's equations of the second kind or by Appell's.
struct InChart<Q, const C: usize, const K: usize, const D: usize, const A: usize, const R: usize> {
    sliding: Sliding<Q, C, K>,
    appell: bool,
}

impl<Q, S, const C: usize, const K: usize, const D: usize, const A: usize, const R: usize> Ode<S>
    for InChart<Q, C, K, D, A, R>
where
    Q: Contacts<4, C, K, Given = f64> + Charted<4, A, R>,
    S: Over<f64> + Analytic,
{
    fn dimension(&self) -> usize {
        A + R
    }

    fn rates(&self, time: S, y: &[S], dy: &mut [S]) {
        let (q, p): ([S; A], [S; R]) = (std::array::from_fn(|i| y[i]), std::array::from_fn(|i| y[A + i]));
        let closed = &self.sliding.closed;
        let motion = Motion::at(closed, time, q, p);
        let force = self.sliding.force::<S, D>(&motion.state);
        let rates = match self.appell {
            true => appell::rates(closed, &motion, force),
            false => second_kind::rates(closed, (time, q, p), force),
        };
        dy[..A].copy_from_slice(&closed.rates(time, q, p));
        dy[A..].copy_from_slice(&rates.expect("regular"));
    }
}

impl<Q, const C: usize, const K: usize, const D: usize, const A: usize, const R: usize> Law
    for InChart<Q, C, K, D, A, R>
where
    Q: Contacts<4, C, K, Given = f64> + Charted<4, A, R>,
{
}

/// Equations as printed in a paper, as a first-order system for the coordinates and their rates, evaluated by a tape of
/// the printed expressions.
struct Printed(Tape);

impl<S: Analytic> Ode<S> for Printed {
    fn dimension(&self) -> usize {
        self.0.outputs()
    }

    fn rates(&self, _time: S, y: &[S], dy: &mut [S]) {
        self.0.over().evaluate(y, dy);
    }
}

impl Law for Printed {}

impl Printed {
    /// The accelerations, solved in sequence from equations that are linear in them.
    fn new(state: &[&str], accelerations: &[&str], equations: Vec<Line>, data: &[(&str, i64, i64)]) -> Self {
        let data: Vec<(Sym, Sym)> =
            data.iter().map(|(name, n, d)| (Sym::symbol(name), Sym::constant(Rational::new(*n, *d)))).collect();
        let mut known: Vec<(Sym, Sym)> = Vec::new();
        for (name, line) in accelerations.iter().zip(equations) {
            let unknown = Sym::symbol(name);
            let open = (line.left - line.right).substitute(&data).substitute(&known);
            known.push((unknown, -(open.substitute(&[(unknown, Sym::ZERO)]) / open.diff(unknown))));
        }
        let letters: Vec<Sym> = state.iter().map(|name| Sym::symbol(name)).collect();
        let half = letters.len() / 2;
        let rates: Vec<Sym> =
            letters[half..].iter().copied().chain(known.into_iter().map(|(_, value)| value)).collect();
        Printed(Tape::record(&letters, &rates).expect("printed equations can be taped"))
    }
}

/// The equation of a claim of the paper; for a refuted claim, its correction.
fn equation(id: &str) -> Line {
    let page = (manglieva2022::PAPER.page)();
    let of = |claim: &Claim| match &claim.statement {
        Statement::Equations { lines, .. } if claim.id == id => lines.first().copied(),
        _ => None,
    };
    let all = page.claims().iter().flat_map(|claim| std::iter::once(claim).chain(claim.correction.as_deref()));
    all.filter_map(of).next().unwrap_or_else(|| panic!("{id} is no equation"))
}

fn follow(law: &dyn Law, start: &[f64]) -> Vec<f64> {
    let span = Span::new(0.0, END, start);
    let outcome = integrate(law, Method::DormandPrince8, &Tolerance::both(1e-14), &span, &mut ());
    assert!(outcome.reached(), "{outcome:?}");
    outcome.state
}

fn close(found: &[f64], expected: &[f64], what: &str) {
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < 1e-10, "{what}: {found:?} but {expected:?}");
    }
}

/// Runs all forms of a system and asserts that they agree, and that redundant coordinates satisfy the constraints.
/// Returns the final Cartesian state.
fn agree<Q, const C: usize, const K: usize, const D: usize, const A: usize, const R: usize>(
    system: Q,
    ways: [f64; K],
    q: [f64; A],
    p: [f64; R],
) -> Vec<f64>
where
    Q: Contacts<4, C, K, Given = f64> + Charted<4, A, R> + Copy,
{
    let sliding = Sliding { closed: Closed(system), ways };
    let cartesian = |q: [f64; A], p: [f64; R]| -> Vec<f64> {
        [sliding.closed.place(0.0, q), velocity(&sliding.closed, 0.0, q, p)].concat()
    };
    let start = cartesian(q, p);
    let first = follow(&FirstKind::<Q, C, K, D>(sliding), &start);
    for appell in [false, true] {
        let last = follow(&InChart::<Q, C, K, D, A, R> { sliding, appell }, &[&q[..], &p[..]].concat());
        let (q, p) = (std::array::from_fn(|i| last[i]), std::array::from_fn(|i| last[A + i]));
        close(&cartesian(q, p), &first, if appell { "Appell" } else { "second kind" });
    }
    let at = |y: &[f64]| State {
        time: 0.0,
        place: std::array::from_fn(|i| y[i]),
        velocity: std::array::from_fn(|i| y[4 + i]),
    };
    let in_regime = InRegime(sliding);
    let last = follow(&in_regime, &start);
    assert!([&start, &last].into_iter().all(|y| in_regime.is_the_motion(&at(y))), "an event in the stretch");
    close(&last, &first, "regimes");
    let constraints: [_; D] = sliding.closed.constraints(&at(&first));
    assert!(constraints.iter().all(|constraint| constraint.value().abs() < 1e-12), "drift {constraints:?}");
    first
}

/// The initial state x, theta, x', theta'.
const ROD: [f64; 4] = [0.0, 1.0, 2.0, 0.5];

fn rod_as_printed(lines: [Line; 2]) -> Printed {
    let data = [("m", 2, 1), ("m1", 1, 1), ("l", 3, 2), ("g", 981, 100), ("f", 1, 4), ("ε", 1, 1)];
    Printed::new(&["x", "θ", "ẋ", "θ̇"], &["ẍ", "θ̈"], lines.into(), &data)
}

#[test]
fn the_rod_slides_alike_in_every_form() {
    let rod = Rod { guided: 2.0, free: 1.0, length: 1.5, gravity: G, friction: 0.25, sides: Sides::Two };
    let last = agree::<_, 1, 1, 2, 2, 2>(rod, [1.0], [ROD[0], ROD[1]], [ROD[2], ROD[3]]);
    let lines = ["manglieva2022/eq1.29/sliding-corrected", "manglieva2022/eq1.29/turning-corrected"].map(equation);
    let y = follow(&rod_as_printed(lines), &ROD);
    let (sin, cos) = y[1].sin_cos();
    let expected = [y[0], 0.0, y[0] + 1.5 * cos, 1.5 * sin, y[2], 0.0, y[2] - 1.5 * y[3] * sin, 1.5 * y[3] * cos];
    close(&expected, &last, "(1.29) as corrected");
}

/// The comparison is sensitive: the equation as printed gives a different motion.
#[test]
fn the_refuted_equation_of_the_rod_slides_differently() {
    let lines = ["manglieva2022/eq1.29/sliding", "manglieva2022/eq1.29/turning-corrected"].map(equation);
    let right = ["manglieva2022/eq1.29/sliding-corrected", "manglieva2022/eq1.29/turning-corrected"].map(equation);
    let [wrong, right] = [lines, right].map(|lines| follow(&rod_as_printed(lines), &ROD));
    assert!((wrong[2] - right[2]).abs() > 1e-2, "{wrong:?} {right:?}");
}

#[test]
fn the_steered_rod_slides_alike_in_every_form() {
    let (m, l, friction) = ([2.0, 3.0], 1.5, 0.2);
    let rod = SteeredRod { guided: m[0], free: m[1], length: l, gravity: G, drive: 4.0, friction, sides: Sides::Two };
    let (theta, speed) = (1.0_f64, 2.0);
    let last = agree::<_, 2, 1, 3, 2, 1>(rod, [1.0], [0.0, theta], [speed]);
    let data = [("m1", 2, 1), ("m2", 3, 1), ("l", 3, 2), ("g", 981, 100), ("f", 1, 5), ("ε", 1, 1), ("X", 4, 1)];
    let printed = Printed::new(&["θ", "θ̇"], &["θ̈"], vec![equation("manglieva2022/eq1.98/motion")], &data);
    let y = follow(&printed, &[theta, 2.0 * speed * theta.sin() / l]);
    let now = (last[3] - last[1]).atan2(last[2] - last[0]);
    close(&[y[0], y[1] * l / (2.0 * y[0].sin())], &[now, last[4]], "(1.98)");
}

#[test]
fn the_ladder_slides_alike_in_every_form() {
    let ladder = Ladder { mass: 2.0, inertia: 1.5, half_length: 1.25, gravity: G, friction: [0.2, 0.3] };
    let (alpha, spin) = (0.9, 0.5);
    let last = agree::<_, 1, 2, 3, 1, 1>(ladder, [-1.0, 1.0], [alpha], [spin]);
    let data = [("m", 2, 1), ("J", 3, 2), ("l", 5, 4), ("g", 981, 100), ("fA", 1, 5), ("fB", 3, 10)];
    let printed = Printed::new(&["α", "α̇"], &["α̈"], vec![equation("manglieva2022/eq1.106/motion")], &data);
    let y = follow(&printed, &[alpha, spin]);
    close(&[y[0], y[1]], &[last[3].atan2(last[2]), last[2] * last[7] - last[3] * last[6]], "(1.106)");
}
