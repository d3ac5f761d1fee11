//! Exact lumping of windings, and the error of lumping windings with different time constants.

use super::{ladder, scene};
use dalembert_derivations::studies::model_reduction::currents::Current;
use dalembert_derivations::studies::model_reduction::lumping::{merged_at_most, seen_windings};
use dalembert_derivations::studies::model_reduction::{Lumped, Lumping};
use field::{Analytic, Base, Circle, Over, Rational, Scalar, Tangent};
use integrators::{Method, Ode, Record, Span, System, Tolerance, integrate};
use motor::{Bench, Machine, RotorState, torque_and_current_rates};
use symbolic::Sym;

/// Bars with arbitrary data: half-angle tangents of their positions, a, L, R.
#[derive(Clone)]
struct Bars<P> {
    field_speed: P,
    each: Vec<(Circle<P>, P, P, P)>,
}

impl<P: Base> Machine<P> for Bars<P> {
    fn rotor(&self) -> RotorState {
        RotorState::AngleAndSpeed
    }

    fn frame_speed(&self) -> P {
        self.field_speed
    }

    fn windings(&self) -> usize {
        self.each.len()
    }

    fn inductance(&self, k: usize) -> P {
        self.each[k].2
    }

    fn resistance(&self, k: usize) -> P {
        self.each[k].3
    }

    fn linkage<S: Over<P>>(&self, k: usize, angle: Circle<S>) -> S {
        let (bar, flux, ..) = self.each[k];
        S::lift(flux) * (angle + bar.map(S::lift)).sin
    }

    fn torque_law<S: Over<P>>(&self, slip: S, _speed: S) -> S {
        -slip * S::ratio(1, 1000)
    }
}

/// The data (half-angle tangent, a, L, R) of each bar, in hundredths.
fn bars<P: Base>(data: &[[i64; 4]], number: impl Fn(Rational) -> P + Copy) -> Bars<P> {
    let hundredths = |n: i64| number(Rational::new(n, 100));
    let each = |&[t, a, l, r]: &[i64; 4]| {
        let bar = Circle::from_half_tangent(Rational::new(t, 100)).map(number);
        (bar, hundredths(a), hundredths(l), hundredths(r))
    };
    Bars { field_speed: number(Rational::int(20)), each: data.iter().map(each).collect() }
}

const ONE_RATIO: [[i64; 4]; 5] =
    [[10, 30, 2, 20], [55, 20, 3, 30], [-130, 40, 5, 50], [700, 10, 1, 10], [-31, 25, 4, 40]];

/// A motor on a bench, to be integrated.
struct On<M>(Bench<f64, M>);

impl<S: Over<f64> + Analytic, M: Machine<f64>> Ode<S> for On<M> {
    fn dimension(&self) -> usize {
        self.0.dimension()
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        self.0.rates(y, dy);
    }
}

impl<M: Machine<f64>> System for On<M> {}

fn run<M: Machine<f64> + Clone>(machine: &M, start: &[f64]) -> Record<f64> {
    let system = On(Bench { machine: machine.clone(), axial: 0.01 });
    let mut record = Record::new();
    let span = Span::new(0.0, 1.0, start).with_even_outputs(10);
    assert!(integrate(&system, Method::DormandPrince8, &Tolerance::both(1e-12), &span, &mut record).reached());
    record
}

#[test]
fn bars_of_one_ratio_at_any_angles_come_to_two_windings_and_every_current_comes_back() {
    let lumping = Lumping::of(&bars(&ONE_RATIO, Sym::constant)).expect("it is exact");
    assert_eq!(lumping.windings.len(), 2);
    let machine = bars(&ONE_RATIO, Rational::to_f64);
    let lumped = Lumped { machine: machine.clone(), windings: lumping.over(Rational::to_f64) };
    // currents that no field induces: a part of them can only decay
    let currents = [1.0, -2.0, 0.5, 3.0, -1.5];
    let all = run(&machine, &[&[0.3, -12.0], &currents[..]].concat());
    let two = run(&lumped, &[&[0.3, -12.0], &lumping.lumped(&currents)[..]].concat());
    let recovery = lumping.recovery(&currents);
    for ((time, all), two) in all.times.iter().zip(&all.states).zip(&two.states) {
        let back: Vec<f64> = two[..2].iter().copied().chain(recovery.currents(*time, &two[2..])).collect();
        for (a, b) in all.iter().zip(&back) {
            assert!((a - b).abs() < 1e-9, "at {time}: {all:?} {back:?}");
        }
    }
}

#[test]
fn windings_of_two_ratios_stay_two_families() {
    let mut data = ONE_RATIO.to_vec();
    data.extend(ONE_RATIO.map(|[t, a, l, r]| [t + 7, a, l, 2 * r]));
    assert_eq!(Lumping::of(&bars(&data, Sym::constant)).expect("it is exact").windings.len(), 4);
    assert!(Lumping::of(&bars(&[ONE_RATIO[0], [55, 20, 3, 31]], Sym::constant)).is_none());
    // bars on one line are equivalent to one winding
    let line = [[50, 30, 2, 20], [50, 20, 3, 30], [-200, 10, 1, 10]];
    assert_eq!(Lumping::of(&bars(&line, Sym::constant)).expect("it is exact").windings.len(), 1);
}

/// In spin_up the excitation winding has the same ratio R/L as the damper, 40/s, and is lumped with it; in stiff_damper
/// it has not.
#[test]
fn the_scenes_damper_and_excitation_are_lumped_by_their_ratios() {
    for (name, own, lumped) in [("spin_up", 9, 2), ("bench", 9, 2), ("stiff_damper", 9, 3)] {
        let found = ladder(&scene(name)).lumping.expect("it is exact");
        assert_eq!((found.up.len(), found.windings.len()), (own, lumped), "{name}");
    }
}

#[test]
fn what_is_said_to_be_proved_for_all_data_stands_in_the_ledger() {
    use dalembert_derivations::studies::model_reduction::Loss;
    let ladder = ladder(&scene("spin_up"));
    let cited = ladder.models.iter().filter_map(|reduced| match reduced.loss {
        Loss::Nothing { claim } => claim,
        _ => None,
    });
    let page = (dalembert_derivations::papers::konosevich2022::PAPER.page)();
    let mut count = 0;
    for claim in cited {
        count += 1;
        assert!(page.claims().iter().any(|known| known.id == claim), "{claim}");
    }
    assert_eq!(count, 1);
}

/// The circuit equations: L i' + R i = -psi' s for one model, R i = -psi' s for the other.
#[test]
fn the_currents_that_stand_for_others_obey_their_circuits_at_constant_slip() {
    let machine = bars(&ONE_RATIO, Rational::to_f64);
    for (angle, slip) in [(0.4, 3.0), (-1.3, -40.0), (2.5, 0.2)] {
        for k in 0..machine.windings() {
            let place = angle.circle().moving(slip);
            let now = |kind: Current| kind.of(&machine, k, place, Tangent::fixed(slip));
            let induced = -machine.linkage(k, place).slope;
            let (l, r) = (machine.inductance(k), machine.resistance(k));
            let steady = now(Current::AtPresentSlip);
            assert!((l * steady.slope + r * steady.value - induced).abs() < 1e-12 * (1.0 + slip.abs()));
            assert!((r * now(Current::Resistive).value - induced).abs() < 1e-12 * (1.0 + slip.abs()));
        }
    }
}

/// All bars along the motion of one motor, and the bars lumped to one ratio R/L along this motion.
struct SameWay {
    bars: Bars<f64>,
    merged: Bars<f64>,
}

impl<S: Over<f64> + Analytic> Ode<S> for SameWay {
    fn dimension(&self) -> usize {
        2 + 2 * self.bars.windings()
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        let n = self.bars.windings();
        let (angle, slip) = (y[0].circle(), y[1]);
        let moment = torque_and_current_rates(&self.bars, angle, slip, &y[2..2 + n], &mut dy[2..2 + n]);
        torque_and_current_rates(&self.merged, angle, slip, &y[2 + n..], &mut dy[2 + n..]);
        (dy[0], dy[1]) = (slip, moment / S::lift(0.01));
    }
}

impl System for SameWay {}

#[test]
fn merging_unlike_ratios_costs_less_than_the_bound() {
    let data = [[10, 30, 2, 19], [55, 20, 3, 31], [-130, 40, 5, 52], [700, 10, 1, 10]];
    let unlike = bars(&data, Rational::to_f64);
    assert!(Lumping::of(&bars(&data, Sym::constant)).is_none(), "four ratios: nothing is exact");
    let merged = bars(&data.map(|[t, a, l, _]| [t, a, l, 10 * l]), Rational::to_f64);
    let system = SameWay { bars: unlike.clone(), merged: merged.clone() };
    let mut record = Record::new();
    let start = [&[0.3, -15.0][..], &[0.0; 8]].concat();
    let span = Span::new(0.0, 1.0, &start).with_even_outputs(400);
    assert!(integrate(&system, Method::DormandPrince8, &Tolerance::both(1e-10), &span, &mut record).reached());
    let (mut off, mut fastest) = (0.0_f64, 15.0_f64);
    for y in &record.states {
        let angle = y[0].circle();
        let moment = |machine: &Bars<f64>, currents: &[f64]| {
            torque_and_current_rates(machine, angle, y[1], currents, &mut [0.0; 4])
        };
        off = off.max((moment(&unlike, &y[2..6]) - moment(&merged, &y[6..])).abs());
        fastest = fastest.max(y[1].abs());
    }
    let bound = merged_at_most(&seen_windings(&unlike).expect("one harmonic"), 10.0, fastest);
    assert!(off > 0.0 && off <= bound, "{off} {bound}");
    assert!(bound < 30.0 * off, "a bound that says something: {off} {bound}");
}
