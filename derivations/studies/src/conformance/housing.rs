//! Checks of a motor in a moving housing, and in the limit of an infinitely heavy one.

use super::instant::{Doubt, Instant, bench_state, vanish};
use super::verdict_of;
use claims::finding::PropertyVerdict;
use field::Tangent;
use motor::{Bench, Machine, RotorState, torque_and_current_rates};
use nalgebra::Vector3;
use symbolic::{Decision, Hypotheses, Sym, decide, normal};
use systems::gyrostat::driven::Driven;
use systems::gyrostat::forms::{FirstForm, Form};

fn three(name: &str) -> Vector3<Sym> {
    Vector3::from_fn(|k, _| Sym::symbol(&format!("{name} {}", k + 1)))
}

/// The motor in a gyrostat with the given principal moments of A; the other data are symbols.
fn driven<M: Machine<Sym> + Clone>(machine: &M, moments: Vector3<Sym>) -> Driven<Sym, FirstForm<Sym>, M> {
    let form = FirstForm::new(moments, three("axis l"), Sym::symbol("the moment A'"), three("weight Ge"));
    Driven::new(form, machine.clone())
}

/// Checks that the motor does not change the angular momentum about the vertical, and changes the rotor's momentum by
/// its torque M only.
pub(super) fn momentum(machine: &(impl Machine<Sym> + Clone), at: &Instant) -> PropertyVerdict {
    let law = driven(machine, three("moment A"));
    let (w, v) = (three("velocity w"), three("vertical v"));
    let mut y: Vec<Sym> = w.iter().chain(&v).copied().collect();
    y.extend(bench_state(machine));
    let mut dy = vec![Sym::ZERO; y.len()];
    law.rates(&y, &mut dy);
    let moving: Vec<_> = y.iter().zip(&dy).map(|(&y, &dy)| Tangent::moving(y, dy)).collect();
    let mut residuals = vec![("the momentum about the vertical".to_owned(), vertical(&law, &moving))];
    if !at.kept {
        let known = machine.rotor();
        let (rotor, currents) = y[6..].split_at(known.dimension());
        let (angle, slip) = known.angle_and_slip(rotor);
        let torque = torque_and_current_rates(machine, angle, slip, currents, &mut vec![Sym::ZERO; currents.len()]);
        let along = Vector3::from_fn(|k, _| dy[k]).dot(&three("axis l"));
        let spin = Sym::symbol("the moment A'") * (along + dy[6 + known.dimension() - 1]);
        residuals.push(("the rotor's own momentum".to_owned(), spin - torque));
    }
    verdict_of(vanish(residuals), "what the rotor gets of momentum about its axis the housing gives, and no more")
}

fn vertical(law: &Driven<Sym, FirstForm<Sym>, impl Machine<Sym>>, moving: &[Tangent<Sym>]) -> Sym {
    let known = law.machine.rotor();
    let speed = match known {
        RotorState::Prescribed => Tangent::fixed(law.machine.frame_speed()),
        RotorState::Speed | RotorState::AngleAndSpeed => {
            moving[6 + known.dimension() - 1] + Tangent::fixed(law.machine.frame_speed())
        }
    };
    let vector = |from: usize| Vector3::from_fn(|k, _| moving[from + k]);
    law.form.momentum(vector(0), speed).dot(&vector(3)).slope
}

/// Checks the limit of infinite moments of inertia of the housing: a housing at rest stays at rest, and the motor runs
/// as on the bench.
pub(super) fn bench(machine: &(impl Machine<Sym> + Clone)) -> PropertyVerdict {
    let own = bench_state(machine);
    if own.is_empty() {
        return PropertyVerdict::DoesNotApply("a kept rotor without windings has no state of its own".to_owned());
    }
    let small = Sym::symbol("1 over A");
    let law = driven(machine, Vector3::repeat(Sym::ONE / small));
    let still = std::iter::repeat_n(Sym::ZERO, 3);
    let y: Vec<Sym> = still.chain(three("vertical v").iter().copied()).chain(own.iter().copied()).collect();
    let mut dy = vec![Sym::ZERO; y.len()];
    law.rates(&y, &mut dy);
    let mut alone = vec![Sym::ZERO; own.len()];
    Bench { machine: machine.clone(), axial: Sym::symbol("the moment A'") }.rates(&own, &mut alone);
    let turning = dy[..3].iter().map(|&rate| ("the housing's turning".to_owned(), rate));
    let running = dy[6..].iter().zip(alone).enumerate().map(|(k, (&rate, alone))| (format!("rate {k}"), rate - alone));
    let proof = turning.chain(running).try_for_each(|(what, rate)| match tends_to_zero(rate, small) {
        Some(true) => Ok(()),
        Some(false) => Err(Doubt::Off(format!("{what} differs from the bench's"))),
        None => Err(Doubt::Open(format!("the limit of {what} less the bench's is not known"))),
    });
    verdict_of(proof, "in a housing too heavy to turn it runs as on the bench")
}

/// Whether an expression tends to zero with a variable; `None` if undecided.
fn tends_to_zero(expression: Sym, variable: Sym) -> Option<bool> {
    let form = normal(expression, &Hypotheses::none()).ok()?;
    let end = [(variable, Sym::ZERO)];
    let [above, below] = [form.numerator(), form.denominator()].map(|part| part.substitute(&end));
    match (decide(above, &Hypotheses::none()), decide(below, &Hypotheses::none())) {
        (Decision::GaveUp(_), _) | (_, Decision::GaveUp(_)) => None,
        (above, below) => Some(above.is_zero() && below.is_nonzero()),
    }
}
