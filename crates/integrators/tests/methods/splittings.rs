//! Compositions of two and of three flows for a law about which nothing else is known: orders, and named refusals.

use crate::problems::{Drive, Kepler, distance};
use dalembert_integrators::{
    Composed, End, Failure, Method, Ode, Pieces, Real, Record, Refusal, Span, Splitting, System, Tolerance, Working,
    compose, integrate, integrate_in,
};
use field::{DoubleDouble, Over};

/// Kepler's problem split into two parts, the attraction and the motion along straight lines; or into three, with the
/// attraction in two parts.
struct Parted {
    kepler: Kepler,
    pieces: usize,
}

impl<S> Ode<S> for Parted
where
    S: field::Scalar,
    Kepler: Ode<S>,
{
    fn dimension(&self) -> usize {
        self.kepler.dimension()
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        self.kepler.rates(t, y, dy);
    }
}

struct Parts(usize);

impl<S: Real + Over<f64>> Pieces<S> for Parts
where
    Kepler: Ode<S>,
{
    type Point = [S; 4];
    type Substep = S;

    fn pieces(&self) -> usize {
        self.0
    }

    fn enter(&self, y: &[S]) -> [S; 4] {
        [y[0], y[1], y[2], y[3]]
    }

    fn leave(&self, point: &[S; 4], y: &mut [S]) {
        y.copy_from_slice(point);
    }

    fn substep(&self, piece: usize, length: S) -> S {
        // with three parts the attraction is divided into two unequal ones
        match (self.0, piece) {
            (3, 0) => length * S::ratio(1, 3),
            (3, 2) => length * S::ratio(2, 3),
            _ => length,
        }
    }

    fn flow(&self, piece: usize, length: &S, point: &mut [S; 4]) -> bool {
        let mut rates = [S::zero(); 4];
        Kepler { eccentricity: 0.3 }.rates(S::zero(), point, &mut rates);
        let moved = if piece == 1 { 0..2 } else { 2..4 };
        moved.for_each(|k| point[k] += *length * rates[k]);
        true
    }
}

impl System for Parted {
    fn composed(&self, splitting: Splitting) -> Option<Box<dyn Composed<f64> + '_>> {
        Some(compose(Parts(self.pieces), splitting))
    }

    fn composed_exact(&self, splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>> {
        Some(compose(Parts(self.pieces), splitting))
    }
}

/// The error at t = 5 for a number of steps.
fn error<S: Working>(pieces: usize, splitting: Splitting, steps: u32) -> f64 {
    let law = Parted { kepler: Kepler { eccentricity: 0.3 }, pieces };
    let span = Span::new(0.0, 5.0, &law.kepler.state::<S>(0.0));
    let method = Method::Split { splitting, steps };
    let outcome = integrate_in(&law, method, &Tolerance::both(1e-9), &span, &mut ());
    assert!(outcome.reached() && outcome.work.steps == u64::from(steps), "{:?}", outcome.end);
    assert_eq!(outcome.work.rates, u64::from(steps) * splitting.stages());
    distance(&outcome.state, &law.kepler.state::<S>(5.0))
}

#[test]
fn compositions_of_two_and_of_three_flows_have_their_order() {
    for pieces in [2, 3] {
        for (splitting, steps) in Splitting::ALL.into_iter().zip([1000, 200, 100]) {
            let order = (error::<f64>(pieces, splitting, steps) / error::<f64>(pieces, splitting, 2 * steps)).log2();
            let theory = f64::from(splitting.order());
            assert!((order - theory).abs() < 0.3, "{splitting:?} of {pieces} pieces: {order:.2}");
        }
    }
}

/// The coefficients are given to 25 digits: the error decreases with the order far below double precision.
#[test]
fn order_8_holds_down_to_19_digits() {
    for pieces in [2, 3] {
        let error = |steps| error::<DoubleDouble>(pieces, Splitting::KahanLi8, steps);
        let (coarse, fine) = (error(2000), error(4000));
        let order = (coarse / fine).log2();
        assert!(fine < 1e-19 && (order - 8.0).abs() < 0.1, "{pieces} pieces: {coarse:.1e} {fine:.1e} {order:.2}");
    }
}

#[test]
fn a_system_without_pieces_is_refused_by_name() {
    let span = Span::new(0.0, 5.0, &[0.5]);
    let method = |steps| Method::Split { splitting: Splitting::Strang, steps };
    let end = |method| integrate(&Drive, method, &Tolerance::both(1e-9), &span, &mut ()).end;
    assert_eq!(end(method(10)), End::Stopped(Failure::Refused(Refusal::NoPieces)));
    assert_eq!(end(method(0)), End::Stopped(Failure::Refused(Refusal::Steps { given: 0 })));
}

/// Let chi_h = exp(h X_1 + h^2 X_2 + ..); its adjoint has the same odd X_q. A step contains no odd X_q below its order
/// if the sums of the q-th powers of its substeps are zero, up to the digits in which these are given.
#[test]
fn the_odd_powers_of_the_shares_below_the_order_sum_to_zero() {
    for splitting in Splitting::ALL {
        let shares = splitting.coefficients::<f64>();
        for power in (3..splitting.order() as i32).step_by(2) {
            let sum: f64 = shares.iter().map(|share| share.powi(power)).sum();
            assert!(sum.abs() < 1e-14, "{splitting:?}, power {power}: {sum:e}");
        }
    }
}

#[test]
fn the_piece_of_the_friction_goes_back_by_a_sixth_of_a_step_at_most() {
    for splitting in Splitting::ALL {
        assert!(splitting.most_negative_substep() < 1.0 / 6.0, "{splitting:?}: {}", splitting.most_negative_substep());
    }
}

/// If outputs do not divide into whole steps, only the step size changes.
#[test]
fn steps_land_on_outputs_at_any_time() {
    let law = Parted { kepler: Kepler { eccentricity: 0.3 }, pieces: 2 };
    let span = Span::new(0.0, 5.0, &law.kepler.state::<f64>(0.0)).with_outputs(&[0.1, 1.7, 5.0]);
    let method = Method::Split { splitting: Splitting::KahanLi8, steps: 160 };
    let mut record = Record::new();
    let outcome = integrate(&law, method, &Tolerance::both(1e-9), &span, &mut record);
    assert!(outcome.reached(), "{:?}", outcome.end);
    for (time, state) in record.times.iter().zip(&record.states) {
        let error = distance(state, &law.kepler.state::<f64>(*time));
        assert!(error < 1e-8, "at {time}: {error:e}");
    }
}
