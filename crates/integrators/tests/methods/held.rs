//! Laws with constraints: the drift is of the order of rounding, orders of convergence agree with theory, and failures
//! are named.

use crate::problems::{Growth, LooseRim, Rim, distance};
use dalembert_integrators::{
    Failure, Index2Dae, Index2DaeSystem, Index2Method, Method, Observer, Ode, Refusal, Span, System, Working,
    integrate_index2, integrate_projected,
};
use field::{Analytic, DoubleDouble, Over};

const SPAN: f64 = 2.0;

/// Every method, with this number of steps.
pub fn methods(steps: u32) -> [Index2Method; 8] {
    let radau = |stages| Index2Method::RadauIIA { stages, steps };
    let gauss = |stages| Index2Method::ProjectedGauss { stages, steps };
    [
        Index2Method::HalfExplicitEuler { steps },
        Index2Method::HalfExplicitRungeKutta4 { steps },
        radau(1),
        radau(2),
        radau(3),
        gauss(1),
        gauss(2),
        gauss(3),
    ]
}

/// An observer that records the largest constraint violation after any step.
struct Drift<'a, S>(&'a mut f64, std::marker::PhantomData<S>);

impl<S: Working> Observer<S> for Drift<'_, S>
where
    Rim: Index2Dae<S>,
{
    fn step(&mut self, time: f64, y: &[S]) {
        let mut g = [S::zero(); 2];
        Rim.constraints(S::lift(time), y, &mut g);
        *self.0 = g.iter().fold(*self.0, |drift, g| drift.max(g.approx().abs()));
    }
}

/// The error at the end, and the drift.
fn run<S: Working>(method: Index2Method, [start, end]: [f64; 2]) -> (f64, f64)
where
    Rim: Index2Dae<S>,
{
    let span = Span::new(start, end, &Rim::state::<S>(start));
    let mut drift = 0.0;
    let outcome = integrate_index2(&Rim, method, &span, &mut Drift::<S>(&mut drift, std::marker::PhantomData));
    assert!(outcome.reached(), "{method}: {:?}", outcome.failure());
    (distance(&outcome.state, &Rim::state::<S>(end)), drift)
}

#[test]
fn every_method_has_the_order_of_theory() {
    for (coarse, fine) in methods(200).into_iter().zip(methods(400)) {
        let [few, many] = [coarse, fine].map(|method| run::<DoubleDouble>(method, [0.0, SPAN]).0);
        let (measured, theory) = ((few / many).log2(), f64::from(coarse.order()));
        assert!((measured - theory).abs() < 0.1, "{coarse}: measured {measured:.2}, theory {theory}");
    }
}

#[test]
fn the_constraint_is_kept_to_rounding_in_place_and_velocity() {
    for method in methods(100) {
        let (_, drift) = run::<f64>(method, [0.0, SPAN]);
        assert!(drift < 2e-15, "{method}: {drift:.1e}");
        let (_, drift) = run::<DoubleDouble>(method, [0.0, SPAN]);
        assert!(drift < 1e-30, "{method}: {drift:.1e}");
    }
}

#[test]
fn a_run_backwards_has_the_same_orders() {
    for (coarse, fine) in methods(200).into_iter().zip(methods(400)) {
        let [few, many] = [coarse, fine].map(|method| run::<DoubleDouble>(method, [SPAN, 0.0]).0);
        let (measured, theory) = ((few / many).log2(), f64::from(coarse.order()));
        assert!((measured - theory).abs() < 0.1, "{coarse}: measured {measured:.2}, theory {theory}");
    }
}

#[test]
fn a_start_off_the_constraint_is_brought_onto_it_by_the_first_step() {
    for method in methods(100) {
        let mut start = Rim::state::<f64>(0.0);
        start[0] += 1e-3;
        let span = Span::new(0.0, SPAN, &start);
        let mut drift = 0.0;
        let outcome = integrate_index2(&Rim, method, &span, &mut Drift::<f64>(&mut drift, std::marker::PhantomData));
        assert!(outcome.reached() && drift < 2e-15, "{method}: {drift:.1e}");
    }
}

/// The law of the rim with columns that do not act on its constraint: no multiplier can satisfy it.
struct Loose;

impl<S: Over<f64> + Analytic> Index2Dae<S> for Loose {
    fn sizes(&self) -> (usize, usize) {
        (4, 2)
    }

    fn rates(&self, t: S, y: &[S], _: &[S], dy: &mut [S]) {
        Rim.rates(t, y, &[S::zero(); 2], dy);
    }

    fn parts(&self, t: S, y: &[S], dy: &mut [S], columns: &mut [S]) {
        Rim.parts(t, y, dy, columns);
        columns.fill(S::zero());
    }

    fn constraints(&self, t: S, y: &[S], g: &mut [S]) {
        Rim.constraints(t, y, g);
    }
}

impl Index2DaeSystem for Loose {}

#[test]
fn what_cannot_be_held_is_singular_by_name() {
    let span = Span::new(0.0, SPAN, &Rim::state::<f64>(0.0));
    for method in methods(10) {
        let failure = integrate_index2(&Loose, method, &span, &mut ()).failure();
        assert!(matches!(failure, Some(Failure::Singular { .. })), "{method}: {failure:?}");
    }
}

#[test]
fn data_that_no_method_could_use_are_refused() {
    let refusal =
        |method, state: &[f64]| match integrate_index2(&Rim, method, &Span::new(0.0, 1.0, state), &mut ()).failure() {
            Some(Failure::Refused(refusal)) => Some(refusal),
            _ => None,
        };
    let start = Rim::state::<f64>(0.0);
    let none = Index2Method::RadauIIA { stages: 0, steps: 10 };
    assert_eq!(refusal(none, &start), Some(Refusal::Stages { given: 0, least: 1, most: 20 }));
    for method in methods(0) {
        assert_eq!(refusal(method, &start), Some(Refusal::Steps { given: 0 }));
    }
    for method in methods(10) {
        assert_eq!(refusal(method, &start[..3]), Some(Refusal::Dimension { expected: 4, found: 3 }));
        assert_eq!(refusal(method, &[1.0, 0.0, f64::NAN, 1.0]), Some(Refusal::StateNotFinite { component: 2 }));
    }
}

#[test]
fn evaluations_are_counted_and_bounded() {
    for method in methods(50) {
        let span = Span::new(0.0, SPAN, &Rim::state::<f64>(0.0));
        let work = integrate_index2(&Rim, method, &span, &mut ()).work;
        assert!(work.steps == 50 && work.rates >= 50 && work.rates + work.constraints >= 100, "{method}: {work}");
        let span = span.with_evaluations(20);
        let failure = integrate_index2(&Rim, method, &span, &mut ()).failure();
        assert!(matches!(failure, Some(Failure::TooManyEvaluations { allowed: 20, .. })), "{method}: {failure:?}");
    }
}

/// The methods with a constant step, with their orders.
fn constant(steps: u32) -> [(Method, f64); 4] {
    [
        (Method::Euler { steps }, 1.0),
        (Method::RungeKutta4 { steps }, 4.0),
        (Method::BackwardEuler { steps }, 1.0),
        (Method::ImplicitMidpoint { steps }, 2.0),
    ]
}

#[test]
fn a_projected_run_has_its_order_and_stays_on_the_constraint() {
    let run = |method| {
        let span = Span::new(0.0, SPAN, &Rim::state::<DoubleDouble>(0.0));
        let mut drift = 0.0;
        let mut watch = Drift::<DoubleDouble>(&mut drift, std::marker::PhantomData);
        let outcome = integrate_projected(&LooseRim, &Rim, method, &span, &mut watch);
        assert!(outcome.reached(), "{method}: {:?}", outcome.failure());
        (distance(&outcome.state, &Rim::state::<DoubleDouble>(SPAN)), drift)
    };
    for ((coarse, theory), (fine, _)) in constant(200).into_iter().zip(constant(400)) {
        let ((few, _), (many, drift)) = (run(coarse), run(fine));
        let measured = (few / many).log2();
        assert!((measured - theory).abs() < 0.1, "{coarse}: measured {measured:.2}, theory {theory}");
        assert!(drift < 1e-30, "{fine}: {drift:.1e}");
    }
}

/// The variable x is constrained to sin t, and a is the area below it: y = (x, a), x' = z, a' = x, 0 = x - sin t.
struct Led;

impl Led {
    fn state(t: f64) -> [DoubleDouble; 2] {
        let point = DoubleDouble::from(t).circle();
        [point.sin, DoubleDouble::from(1.0) - point.cos]
    }
}

impl<S: Over<f64> + Analytic> Index2Dae<S> for Led {
    fn sizes(&self) -> (usize, usize) {
        (2, 1)
    }

    fn rates(&self, _t: S, y: &[S], z: &[S], dy: &mut [S]) {
        dy.copy_from_slice(&[z[0], y[0]]);
    }

    fn parts(&self, _t: S, y: &[S], dy: &mut [S], columns: &mut [S]) {
        dy.copy_from_slice(&[S::zero(), y[0]]);
        columns.copy_from_slice(&[S::one(), S::zero()]);
    }

    fn constraints(&self, t: S, y: &[S], g: &mut [S]) {
        g[0] = y[0] - t.circle().sin;
    }
}

impl Index2DaeSystem for Led {}

/// The area below x for x' = cos t, without a constraint.
struct Unled;

impl<S: Over<f64> + Analytic> Ode<S> for Unled {
    fn dimension(&self) -> usize {
        2
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        dy.copy_from_slice(&[t.circle().cos, y[0]]);
    }
}

impl System for Unled {}

#[test]
fn a_constraint_that_moves_is_met_where_it_is_at_the_end_of_the_step() {
    for [start, end] in [[0.0, SPAN], [SPAN, 0.5]] {
        let span = Span::new(start, end, &Led::state(start));
        let off =
            |state: &[DoubleDouble]| (distance(&state[..1], &Led::state(end)[..1]), distance(state, &Led::state(end)));
        for (coarse, fine) in methods(50).into_iter().zip(methods(100)) {
            let [(_, few), (drift, many)] =
                [coarse, fine].map(|method| off(&integrate_index2(&Led, method, &span, &mut ()).state));
            assert!(drift < 1e-30, "{fine}: {drift:.1e}");
            assert!((few / many).log2() > f64::from(coarse.order()) - 0.1, "{coarse}: {few:.1e} and {many:.1e}");
        }
        for (method, _) in constant(50) {
            let (drift, _) = off(&integrate_projected(&Unled, &Led, method, &span, &mut ()).state);
            assert!(drift < 1e-30, "{method}: {drift:.1e}");
        }
    }
}

#[test]
fn a_projected_run_is_refused_where_it_makes_no_sense() {
    let refusal = |failure| if let Some(Failure::Refused(refusal)) = failure { Some(refusal) } else { None };
    let span = Span::new(0.0, SPAN, &Rim::state::<f64>(0.0));
    let adaptive = integrate_projected(&LooseRim, &Rim, Method::DormandPrince5, &span, &mut ());
    assert_eq!(refusal(adaptive.failure()), Some(Refusal::FollowsTolerance));
    let none = integrate_projected(&LooseRim, &Rim, Method::Euler { steps: 0 }, &span, &mut ());
    assert_eq!(refusal(none.failure()), Some(Refusal::Steps { given: 0 }));
    let growth = Growth { rate: 1.0 };
    let three = Span::new(0.0, SPAN, &[1.0; 3]);
    let other = integrate_projected(&growth, &Rim, Method::Euler { steps: 5 }, &three, &mut ());
    assert_eq!(refusal(other.failure()), Some(Refusal::Dimension { expected: 4, found: 3 }));
}
