//! Power balance and passivity of a motor.

use super::instant::{Instant, vanish};
use super::verdict_of;
use crate::stationary::motor::{Fraction, NoMotor};
use algebra::real::Root;
use claims::finding::PropertyVerdict;
use field::{Analytic, Circle, Rational, Scalar, Tangent};
use motor::{Machine, RotorState, electrical_power, joule_heat, motional_torque, stored_energy};
use symbolic::{Decision, Hypotheses, Sym, decide};

/// Checks M phi' + d/dt (U + sum 1/2 L i^2) = W dK/dg + phi' m + sum v i - sum R i^2, with the rate of the stored
/// energy along the motion.
pub(super) fn balance(machine: &impl Machine<Sym>, at: &Instant) -> PropertyVerdict {
    if at.kept {
        return PropertyVerdict::DoesNotApply("the speed is prescribed and does not depend on the torque".to_owned());
    }
    let moving: Vec<_> = at.currents.iter().zip(&at.rates).map(|(&i, &rate)| Tangent::moving(i, rate)).collect();
    let stored = stored_energy(machine, at.angle.moving(at.slip), &moving).slope;
    let varied = at.angle.moving(Sym::ONE);
    let pull = at
        .currents
        .iter()
        .enumerate()
        .fold(-machine.field_energy(varied).slope, |sum, (k, &i)| sum + i * machine.linkage(k, varied).slope);
    let given = machine.frame_speed() * pull
        + at.speed * machine.torque_law(at.slip, at.speed)
        + electrical_power(machine, at.angle, &at.currents)
        - joule_heat(machine, &at.currents);
    let proof = vanish([("the power balance".to_owned(), at.torque * at.speed + stored - given)]);
    verdict_of(proof, "shaft and store get what field, friction and supplies give, less heat")
}

/// Checks passivity: whether the motor delivers no energy of its own. In the field's frame it is passive if without a
/// supply E - W p + c0 g, c0 = -m(0, W), never increases; in the housing's frame, if nothing depends on the field's
/// angle, if E never increases.
pub(super) fn passivity(machine: &impl Machine<Sym>, written: &impl Machine<Sym>) -> PropertyVerdict {
    if machine.rotor() == RotorState::Prescribed {
        return PropertyVerdict::DoesNotApply("whatever keeps the speed gives what that takes".to_owned());
    }
    for k in 0..machine.windings() {
        if sign(machine.resistance(k)) == Some(-1) {
            return PropertyVerdict::Fails(format!(
                "winding {} gives: its resistance is negative",
                machine.current_name(k)
            ));
        }
        if sign(machine.inductance(k)) != Some(1) {
            let name = machine.current_name(k);
            return PropertyVerdict::Fails(format!("winding {name} stores no energy: its inductance is not positive"));
        }
    }
    let supply = (0..machine.windings()).any(|k| machine.supply(k, Circle::<Sym>::zero()).is_some());
    let beyond = if supply { "; beyond that it takes what its supplies put in" } else { "" };
    match from_field(machine) {
        Ok(()) => {
            PropertyVerdict::Proved(format!("seen from the field it gives nothing: E - W p + c0 g never grows{beyond}"))
        }
        Err(reason) => match from_housing(machine) {
            Ok(()) => PropertyVerdict::Proved(format!("seen from the housing it gives nothing: E never grows{beyond}")),
            Err(Gives::Unknown(why)) => PropertyVerdict::Undecided(why.to_string()),
            Err(_) => reason.judged(written),
        },
    }
}

/// d/dt (E - W p + c0 g) = (m - m(0, W)) g' - heat - W sum c_k i_k.
fn from_field(machine: &impl Machine<Sym>) -> Result<(), Gives> {
    let currents = currents(machine);
    let slid = machine.frame_speed() * motional_torque(machine, &currents);
    if !vanishes(slid)? {
        return Err(Gives::Sliding);
    }
    let (frame_speed, slip) = (machine.frame_speed(), Sym::symbol("the slip"));
    let torque = machine.torque_law(slip, slip + frame_speed);
    takes((torque - machine.torque_law(Sym::ZERO, frame_speed)) * slip, slip)
}

/// dE/dt = m phi' - heat, where nothing depends on the angle to the field.
fn from_housing(machine: &impl Machine<Sym>) -> Result<(), Gives> {
    let varied = Sym::symbol("the angle").circle().moving(Sym::ONE);
    let fluxes = (0..machine.windings()).map(|k| machine.linkage(k, varied).slope);
    for slope in fluxes.chain([machine.field_energy(varied).slope]) {
        if !vanishes(slope)? {
            return Err(Gives::Field);
        }
    }
    let slip = Sym::symbol("the slip");
    let speed = slip + machine.frame_speed();
    takes(machine.torque_law(slip, speed) * speed, slip)
}

/// The source of energy of a motor that is not passive.
enum Gives {
    /// Sliding conductors.
    Sliding,
    /// The rotating field.
    Field,
    /// The torque m, below or above synchronous speed.
    Torque { below: bool },
    /// Undecided: the torque is not a rational function.
    Unknown(NoMotor),
}

impl Gives {
    fn judged<M: Machine<Sym>>(&self, machine: &M) -> PropertyVerdict {
        PropertyVerdict::Fails(match self {
            Gives::Sliding => "conductors that slide under a turning field give W sum c i".to_owned(),
            Gives::Field => "the field turns, and gives W dK/dg".to_owned(),
            Gives::Torque { below } => {
                let side = if *below { "below" } else { "above" };
                let torque = machine.torque_law(Sym::symbol("g'"), Sym::symbol("phi'"));
                format!("the torque m gives {side} synchronism: {torque}")
            }
            Gives::Unknown(reason) => return PropertyVerdict::Undecided(reason.to_string()),
        })
    }
}

/// Ok if the power is positive for no slip.
fn takes(power: Sym, slip: Sym) -> Result<(), Gives> {
    let power = Fraction::of(power, slip).map_err(Gives::Unknown)?;
    positive(&power).map_or(Ok(()), |gives| Err(Gives::Torque { below: gives.sign() == Some(-1) }))
}

fn currents(machine: &impl Machine<Sym>) -> Vec<Sym> {
    (0..machine.windings()).map(|k| Sym::symbol(&format!("current {k}"))).collect()
}

fn vanishes(expression: Sym) -> Result<bool, Gives> {
    match decide(expression, &Hypotheses::none()) {
        Decision::GaveUp(reason) => Err(Gives::Unknown(NoMotor::NotAlgebraic(reason))),
        decision => Ok(decision.is_zero()),
    }
}

/// The sign of a constant expression; `None` for others.
fn sign(value: Sym) -> Option<i32> {
    value.as_constant().and_then(Rational::sign)
}

/// A rational point at which a fraction is positive, found by its sign at one point between adjacent roots and poles.
fn positive(fraction: &Fraction) -> Option<Rational> {
    let whole = &fraction.numerator * &fraction.denominator;
    let mut roots = whole.real_roots();
    roots.sort_by(Root::compare);
    let one = Rational::int(1);
    let bounds: Vec<[Rational; 2]> = roots.iter().map(Root::bounds).collect();
    let first = bounds.first().map_or(one, |[below, _]| *below - one);
    let last = bounds.last().map_or(one, |[_, above]| *above + one);
    let between = bounds.windows(2).map(|pair| (pair[0][1] + pair[1][0]).half());
    [first, last].into_iter().chain(between).find(|&at| {
        let sign = Root::rational(at).map_or(0, |at| at.sign_of(&whole));
        sign > 0
    })
}
