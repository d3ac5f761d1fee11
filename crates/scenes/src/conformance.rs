//! What every system that is text should do: its routes agree, energy goes where forces send it, loads act in pairs and ask for no
//! observer, what comes with the speeds takes energy, and inertia resists.

use crate::inductances::impossible_inductances;
use crate::letters::Letters;
use crate::readiness::start_of;
use crate::{admissible::impossible, row_units::unit_of};
use derivations::conformance::{Finding, Verdict};
use field::Rational;
use model::principles::Principle;
use model::{Agreement, Model, Pairs, Trace, agreement, forces_without_potential, statements};
use num_traits::Zero;
use symbolic::{Sym, Tape, apart};

/// States at which the power of speeds is looked at.
const STATES: usize = 2_000;

/// Part of the sum of sizes that counts as rounding.
const ROUNDING: f64 = 1e-11;

/// Every check of a model, inputs without a value at zero.
pub fn conform(model: &Model) -> Vec<Finding> {
    let mut model = model.clone();
    model.close_inputs();
    let model = &model;
    let dimensions = Verdict::Proved("the units of all expressions agree, as they were read".to_owned());
    [
        ("principles", apart(|| principles(model))),
        ("power", apart(|| power(model))),
        ("passivity", passivity(model)),
        ("pairs", apart(|| pairs(model))),
        ("frame", apart(|| frame(model))),
        ("inertia", inertia(model)),
        ("dimensions", dimensions),
    ]
    .into_iter()
    .map(|(check, verdict)| Finding { check, verdict })
    .collect()
}

/// The verdict of an agreement, with what it says of.
fn verdict(found: &Agreement, says: &str) -> Verdict {
    match found {
        Agreement::Proved { .. } | Agreement::Theorem { .. } => Verdict::Proved(says.to_owned()),
        Agreement::Identified { .. } | Agreement::Tested { .. } => Verdict::Tested(format!("{says}: {found}")),
        Agreement::Refuted { .. } => Verdict::Fails(format!("{says}: {found}")),
        Agreement::Undecided { .. } => Verdict::Undecided(format!("{says}: {found}")),
    }
}

/// Energies and virtual displacements beside bodies with the loads of their joints.
fn principles(model: &Model) -> Verdict {
    let trace = Trace::of(model);
    match agreement(&trace, Principle::Lagrange, Principle::NewtonEuler) {
        Ok(found) => verdict(&found, "Lagrange's equations are those of the bodies with the loads of their joints"),
        Err(why) => Verdict::DoesNotApply(why.to_string()),
    }
}

fn power(model: &Model) -> Verdict {
    let trace = Trace::of(model);
    match statements(&trace).into_iter().find(|one| one.subject == "energy") {
        Some(energy) => verdict(&energy.agreement, &energy.says),
        None => Verdict::DoesNotApply("it has no energy".to_owned()),
    }
}

fn pairs(model: &Model) -> Verdict {
    let Pairs { between, from_outside, .. } = Pairs::of(model);
    let along = match model.generalised.len() {
        0 => String::new(),
        1 => "; one acts along a coordinate: on what it reacts is not said".to_owned(),
        several => format!("; {several} act along coordinates: on what they react is not said"),
    };
    let alone = match from_outside.as_slice() {
        [] => String::new(),
        some => format!("; from outside: {}", some.join(", ")),
    };
    match between + from_outside.len() {
        0 if along.is_empty() => Verdict::DoesNotApply("no load acts on a body".to_owned()),
        _ => Verdict::Proved(format!("{between} loads act between two bodies, equal and opposite{alone}{along}")),
    }
}

fn frame(model: &Model) -> Verdict {
    let Pairs { between, observed, .. } = Pairs::of(model);
    match (between, observed.as_slice()) {
        (0, _) => Verdict::DoesNotApply("no load acts between two bodies".to_owned()),
        (_, []) => {
            Verdict::Proved("an observer who moves and turns steadily sees the same loads between bodies".to_owned())
        }
        (_, some) => Verdict::Fails(format!(
            "{} changes for an observer who moves or turns: it holds a velocity beside the ground, not beside the other body",
            some.join(", ")
        )),
    }
}

fn inertia(model: &Model) -> Verdict {
    if let Some(issue) = impossible(model).into_iter().next() {
        return Verdict::Fails(issue.title);
    }
    let Ok(start) = start_of(model) else {
        return Verdict::DoesNotApply("it has no start: parameters or coordinates are open".to_owned());
    };
    match impossible_inductances(model, &start) {
        Some(issue) => Verdict::Fails(issue.title),
        None => {
            Verdict::Tested("masses, moments of inertia and inductances are those of bodies and windings".to_owned())
        }
    }
}

/// Whether the forces that come with the speeds take energy: exactly where their power is a quadratic form, else at many states.
fn passivity(model: &Model) -> Verdict {
    if model.parameters.iter().any(|parameter| parameter.value.is_none()) {
        return Verdict::DoesNotApply("some parameters have no value".to_owned());
    }
    apart(|| {
        let trace = Trace::of(model);
        let forces = forces_without_potential(&trace);
        let held: Vec<Sym> = forces.iter().flat_map(|force| force.symbols_of()).collect();
        let chooses = trace.switches.iter().any(|switch| held.contains(switch));
        if !chooses && !trace.speeds.iter().any(|speed| held.contains(speed)) {
            let rubs = model.contacts.iter().any(|contact| contact.friction.is_some());
            let beside = if rubs { ", beside friction in contacts" } else { "" };
            return Verdict::Proved(format!("no force changes with the speeds{beside}"));
        }
        match (!chooses).then(|| quadratic(&trace, &forces)).flatten().map(is_never_positive) {
            Some(true) => Verdict::Proved(
                "what comes with the speeds takes energy, for any positions and speeds and for these data".to_owned(),
            ),
            _ => sampled(&trace, &forces),
        }
    })
}

/// sum (Q(q, u) - Q(q, 0)) u as a quadratic form with constant coefficients.
fn quadratic(trace: &Trace<'_>, forces: &[Sym]) -> Option<Vec<Vec<Rational>>> {
    let state: Vec<Sym> = trace.coordinates.iter().chain(&trace.speeds).copied().collect();
    let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
    let still = symbolic::substitute_all(forces, &at_rest);
    let terms = forces.iter().zip(still).zip(&trace.speeds);
    let power = terms.fold(Sym::ZERO, |sum, ((&force, still), &speed)| sum + (force - still) * speed);
    let power = Letters::with_data(trace.time, &state).put_into(trace, &[power])[0];
    let form: Vec<Vec<Sym>> = trace
        .speeds
        .iter()
        .map(|&one| trace.speeds.iter().map(|&other| power.diff(one).diff(other)).collect())
        .collect();
    let constant = |entry: &Sym| {
        let decided = symbolic::decide(*entry, &symbolic::Hypotheses::none());
        entry.as_constant().or_else(|| decided.is_zero().then(Rational::zero))
    };
    let numbers = form.iter().map(|row| row.iter().map(constant).collect()).collect::<Option<Vec<Vec<Rational>>>>()?;
    let again = (0..form.len()).fold(Sym::ZERO, |sum, i| {
        (0..form.len()).fold(sum, |sum, j| sum + Sym::constant(numbers[i][j]) * trace.speeds[i] * trace.speeds[j])
    });
    let rest = power + power - again;
    symbolic::decide(rest, &symbolic::Hypotheses::none()).is_zero().then_some(numbers)
}

/// Whether a form is positive nowhere, by its pivots.
fn is_never_positive(mut form: Vec<Vec<Rational>>) -> bool {
    let sign = |number: Rational| number.sign().unwrap_or(1);
    let mut open: Vec<usize> = (0..form.len()).collect();
    while let Some(&pivot) = open.iter().find(|&&place| sign(form[place][place]) != 0) {
        if sign(form[pivot][pivot]) > 0 {
            return false;
        }
        open.retain(|&place| place != pivot);
        let own = form[pivot].clone();
        for &row in &open {
            let factor = form[row][pivot] / own[pivot];
            for &column in &open {
                let less = factor * own[column];
                form[row][column] -= less;
            }
        }
    }
    // where the diagonal is zero the rest must be
    open.iter().all(|&row| open.iter().all(|&column| sign(form[row][column]) == 0))
}

/// Looks for a state at which the power is positive.
fn sampled(trace: &Trace<'_>, forces: &[Sym]) -> Verdict {
    let model = trace.model;
    let places = model.positions() + model.speeds();
    let named =
        |letter: &str, count: usize| (0..count).map(|i| Sym::symbol(&format!("{letter}{i}"))).collect::<Vec<_>>();
    let (state, time, cases) = (named("y", places), Sym::symbol("t"), named("s", model.switches.len()));
    let conditions: Vec<Sym> = model.switches.iter().map(|condition| trace.scalar(*condition)).collect();
    let all = Letters::with_data(time, &state).put_into(trace, &[&conditions[..], forces].concat());
    let cases_known: Vec<(Sym, Sym)> = trace.switches.iter().copied().zip(cases.iter().copied()).collect();
    let all = symbolic::substitute_all(&all, &cases_known);
    let inputs = [&state[..], &[time], &cases].concat();
    let Ok(tape) = Tape::record(&inputs, &all) else {
        return Verdict::Undecided("the power has no values".to_owned());
    };
    let start = start_of(model).unwrap_or_else(|_| model.start_state());
    let mut drawn = Drawn(1);
    let (mut seen, mut values) = (0, vec![0.0; all.len()]);
    // conditions may ask for those before them; one that is at zero has either side
    let mut forces_at = |point: &[f64], time: f64| -> Vec<f64> {
        let mut numbers = [point, &[time], &vec![0.5; cases.len()]].concat();
        for _ in 0..=cases.len() {
            tape.over::<f64>().evaluate(&numbers, &mut values);
            for (case, condition) in numbers[places + 1..].iter_mut().zip(&values) {
                *case = if *condition == 0.0 { 0.5 } else { f64::from(u8::from(*condition > 0.0)) };
            }
        }
        values[cases.len()..].to_vec()
    };
    for _ in 0..STATES {
        let size = 10_f64.powf(drawn.number() * 3.0);
        let positions = start[..model.positions()].iter();
        let mut point: Vec<f64> = positions.map(|place| place + (1.0 + place.abs()) * drawn.number()).collect();
        let speeds: Vec<f64> = (0..model.speeds()).map(|_| size * drawn.number()).collect();
        point.resize(places, 0.0);
        let time = drawn.number().abs();
        let still = forces_at(&point, time);
        point[model.positions()..].copy_from_slice(&speeds);
        let moving = forces_at(&point, time);
        let terms: Vec<f64> =
            moving.iter().zip(&still).zip(&speeds).map(|((moving, still), speed)| (moving - still) * speed).collect();
        let sizes: f64 =
            moving.iter().zip(&still).zip(&speeds).map(|((a, b), speed)| ((a.abs() + b.abs()) * speed).abs()).sum();
        let sum: f64 = terms.iter().sum();
        if !sum.is_finite() {
            continue;
        }
        seen += 1;
        if sum > ROUNDING * sizes && sum > 0.0 {
            return Verdict::Fails(gives(model, &point, sum));
        }
    }
    match seen {
        0 => Verdict::Undecided("the power has a value at no state that was tried".to_owned()),
        _ => Verdict::Tested(format!("at {seen} states what comes with the speeds takes energy")),
    }
}

fn gives(model: &Model, point: &[f64], power: f64) -> String {
    let names = model.state_names().into_iter().map(|(name, _)| name).zip(point);
    let shown =
        names.skip(model.positions()).map(|(name, value)| format!("{name} = {value:.4} {}", unit_of(model, &name)));
    let shown: Vec<String> = shown.take(4).collect();
    format!(
        "forces that come with the speeds give {power:.4} W at {}: a supply by the speed, or a wrong sign",
        shown.join(", ")
    )
}

/// Numbers between -1 and 1 that are the same in every run (splitmix64).
struct Drawn(u64);

impl Drawn {
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        2.0 * (bits >> 11) as f64 / (1_u64 << 53) as f64 - 1.0
    }
}
