//! The symbolic matrix of the linearised motion near any steady one, by differentiation of the law.

use super::linear::{Linearised, NoLinear};
use crate::scene::Setup;
use crate::stationary::motions::decimals;
use crate::stationary::motor::NoMotor;
use field::{Analytic, Circle, Rational, Scalar};
use mechanics::definite::solve;
use motor::{Machine, Motor, RotorState, is_fed, steady_currents, torque_and_current_rates};
use nalgebra::Vector3;
use symbolic::{Hypotheses, Sym, decide, substitute_all};
use systems::gyrostat::{Gyrostat, MotionInstant};

/// Windings with equal decay rates R/L.
struct Group {
    decay: Rational,
    /// The sum of psi_k'^2 / L_k: the dependence of the rate of their torque on the slip.
    strength: Sym,
    count: usize,
}

/// The linearisation for a motor in a system. `free`: the motor exerts no torque, and the rotor's own momentum is an integral.
pub(super) fn linearised(system: &Setup, motor: &Motor, free: bool) -> Result<Linearised, NoLinear> {
    let machine = motor.decimals();
    let known = machine.rotor();
    let field_speed = machine.frame_speed();
    let field_speed = field_speed.as_constant().ok_or(NoLinear::NotAlgebraic(field_speed))?;
    let (g, slip, share) = (Sym::symbol("g"), Sym::symbol("s"), Sym::symbol("q"));
    let angle = if known == RotorState::AngleAndSpeed { g.circle() } else { Circle::zero() };
    let fed = is_fed(&machine);
    let groups = if fed { Vec::new() } else { windings(&machine, angle, slip)? };
    // with a supply the currents are states with steady values at the motion; otherwise they are zero there
    let resting = if fed { steady_currents(&machine, angle, slip) } else { Some(Vec::new()) };
    let resting = resting.ok_or(NoLinear::Motor(NoMotor::NoRest))?;
    let own: Vec<Sym> = (0..resting.len()).map(|k| Sym::symbol(&format!("i{k}"))).collect();
    let currents = if fed { own.clone() } else { vec![Sym::ZERO; machine.windings()] };
    let mut of_currents = vec![Sym::ZERO; currents.len()];
    let torque = torque_and_current_rates(&machine, angle, slip, &currents, &mut of_currents) + share;
    let rotor: &[Sym] = match known {
        RotorState::Prescribed => &[],
        RotorState::Speed => &[slip],
        RotorState::AngleAndSpeed => &[g, slip],
    };
    let (mut states, mut rates, acceleration) = match system {
        Setup::Gyrostat(bodies) => {
            let relative = if known == RotorState::Prescribed { Sym::ZERO } else { slip };
            let speed = relative + machine.frame_speed();
            carrier(&decimals(bodies), known, speed, torque)?
        }
        Setup::Bench { axial } => (Vec::new(), Vec::new(), torque / Sym::constant(Rational::decimal(*axial))),
    };
    let mut of_rotor = vec![Sym::ZERO; rotor.len()];
    known.write(slip, acceleration, &mut of_rotor);
    states.extend(rotor.iter().chain(&own));
    rates.extend(of_rotor.into_iter().chain(of_currents.into_iter().take(own.len())));
    let at_rest: Vec<(Sym, Sym)> = own.into_iter().zip(resting.iter().copied()).collect();
    let matrix = matrix(&states, &rates, share, slip, &groups);
    let [w, v] = vectors();
    let point = g.circle();
    Ok(Linearised {
        matrix: matrix.iter().map(|row| substitute_all(row, &at_rest)).collect(),
        resting,
        symbols: [w.as_slice(), v.as_slice(), &[point.cos, point.sin, slip]].concat(),
        field_speed,
        idle: groups.iter().filter(|group| group.count > 1).map(|group| (group.decay, group.count - 1)).collect(),
        integrals: if matches!(system, Setup::Gyrostat(_)) { 2 } else { 0 } + usize::from(free),
        symmetric: keeps_energy(&machine),
    })
}

fn vectors() -> [Vector3<Sym>; 2] {
    ["w", "v"].map(|stem| Vector3::from_fn(|i, _| Sym::symbol(&format!("{stem}{}", i + 1))))
}

/// Whether friction and windings dissipate nothing, decided exactly.
pub(super) fn keeps_energy(machine: &impl Machine<Sym>) -> bool {
    let slip = Sym::symbol("s");
    let friction = machine.torque_law(slip, slip + machine.frame_speed());
    machine.rotor() == RotorState::Prescribed
        || machine.windings() == 0 && decide(friction, &Hypotheses::none()).is_zero()
}

/// The windings grouped by their decay rates, linearised at zero currents.
fn windings(machine: &impl Machine<Sym>, angle: Circle<Sym>, slip: Sym) -> Result<Vec<Group>, NoLinear> {
    let currents: Vec<Sym> = (0..machine.windings()).map(|k| Sym::symbol(&format!("i{k}"))).collect();
    if !currents.is_empty() && machine.rotor() != RotorState::AngleAndSpeed {
        return Err(NoLinear::Windings);
    }
    let mut rates = vec![Sym::ZERO; currents.len()];
    let torque = torque_and_current_rates(machine, angle, slip, &currents, &mut rates);
    let mut groups: Vec<Group> = Vec::new();
    for (current, rate) in currents.iter().zip(rates) {
        let decay = -rate.diff(*current);
        let decay = decay.as_constant().ok_or(NoLinear::NotAlgebraic(decay))?;
        let strength = torque.diff(*current) * -rate.diff(slip);
        match groups.iter_mut().find(|group| group.decay == decay) {
            Some(group) => {
                group.strength += strength;
                group.count += 1;
            }
            None => groups.push(Group { decay, strength, count: 1 }),
        }
    }
    Ok(groups)
}

/// (w, v), their rates, and phi'', from the theorem of angular momentum for the mass points.
fn carrier(
    bodies: &Gyrostat<Rational>,
    rotor: RotorState,
    rotor_speed: Sym,
    torque: Sym,
) -> Result<(Vec<Sym>, Vec<Sym>, Sym), NoLinear> {
    let zero = Rational::int(0);
    let column = |k: usize| {
        let one = |i: usize| if i == k { Rational::int(1) } else { zero };
        bodies.by_momentum(&MotionInstant {
            angular_velocity: Vector3::zeros(),
            vertical: Vector3::zeros(),
            rotor_speed: zero,
            angular_acceleration: Vector3::new(one(0), one(1), one(2)),
            rotor_acceleration: one(3),
            torque: zero,
        })
    };
    let columns: [[Rational; 4]; 4] = std::array::from_fn(column);
    let [w, v] = vectors();
    let missing = bodies.by_momentum(&MotionInstant {
        angular_velocity: w,
        vertical: v,
        rotor_speed,
        angular_acceleration: Vector3::zeros(),
        rotor_acceleration: Sym::ZERO,
        torque,
    });
    let solved = match rotor {
        // the rotor's own equation gives the torque that maintains its speed
        RotorState::Prescribed => {
            let inverse = inverse(std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i])))?;
            let [x, y, z] = solved(&inverse, &[missing[0], missing[1], missing[2]]);
            [x, y, z, Sym::ZERO]
        }
        _ => solved(&inverse(std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i])))?, &missing),
    };
    let turning = v.cross(&w);
    let rates = solved[..3].iter().copied().chain(turning.iter().copied()).collect();
    Ok((w.iter().chain(&v).copied().collect(), rates, solved[3]))
}

fn inverse<const N: usize>(matrix: [[Rational; N]; N]) -> Result<[[Rational; N]; N], NoLinear> {
    let mut columns = [[Rational::int(0); N]; N];
    for (k, column) in columns.iter_mut().enumerate() {
        let unit = std::array::from_fn(|i| Rational::int(i64::from(i == k)));
        *column = solve(matrix, unit).map_err(|_| NoLinear::Inertia)?;
    }
    Ok(std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i])))
}

/// The accelerations for which the residuals vanish.
fn solved<const N: usize>(inverse: &[[Rational; N]; N], missing: &[Sym; N]) -> [Sym; N] {
    std::array::from_fn(|i| {
        let terms = inverse[i].iter().zip(missing);
        terms.fold(Sym::ZERO, |sum, (c, missing)| sum - Sym::constant(*c) * *missing)
    })
}

/// The Jacobian of the rates, bordered by the torque contributions of the windings.
fn matrix(states: &[Sym], rates: &[Sym], share: Sym, slip: Sym, groups: &[Group]) -> Vec<Vec<Sym>> {
    let of_rate = |rate: &Sym| {
        let own = states.iter().map(|state| rate.diff(*state));
        own.chain(std::iter::repeat_n(rate.diff(share), groups.len())).collect()
    };
    let of_group = |(k, group): (usize, &Group)| {
        let by_state = states.iter().map(|state| if *state == slip { -group.strength } else { Sym::ZERO });
        let by_group = (0..groups.len()).map(|j| if j == k { Sym::constant(-group.decay) } else { Sym::ZERO });
        by_state.chain(by_group).collect()
    };
    rates.iter().map(of_rate).chain(groups.iter().enumerate().map(of_group)).collect()
}
