//! The linear motion near a stationary one, with exact data: its matrix by differentiation of the law.
//!
//! Written down once over symbols; at a motion the entries are enclosed. What structure explains is split off exactly:
//! * an integral I of the law f has I' f = 0 everywhere, so that I' A = 0 where f = 0: an eigenvalue 0 for each. These are
//!   v.v and x.v of every gyrostat, and the own momentum of a rotor that is left alone;
//! * without slip and currents, a winding k only enters through its share psi_k' i_k of the moment, and shares that fade at
//!   one rate R/L add up to one unknown: of n such windings n - 1 eigenvalues are exactly -R/L;
//!   Where a supply feeds them, currents are states of their own;
//! * where energy is kept the motion is Hamilton's on the surface of the integrals: with mu there is -mu.

use crate::machines::{Catalogued, ForMachine, Machine, RotorState, drive, is_fed, resting_currents};
use crate::scene::{MachineData, Scene, System};
use crate::stationary::motions::decimals;
use crate::stationary::motor::{Decimals, Motor, NoMotor};
use crate::systems::gyrostat::{Gyrostat, Motion};
use field::{Analytic, Circle, Rational, Scalar};
use mechanics::definite::solve;
use mechanics::discrete::{Mode, Place, Spectrum, characteristic};
use nalgebra::Vector3;
use symbolic::real::Enclosure;
use symbolic::{Hypotheses, Sym, coefficients, decide, normal, substitute_all};

/// The matrix of a scene's linear motion near any stationary one, over the symbols of its place.
#[derive(Debug)]
pub struct Linearised {
    matrix: Vec<Vec<Sym>>,
    /// The currents that a supply feeds there.
    resting: Vec<Sym>,
    /// w, v, cos g, sin g, g'
    symbols: Vec<Sym>,
    /// W, rad/s
    field_speed: Rational,
    /// Rates at which windings fade, each with the number of eigenvalues that are exactly minus that.
    pub idle: Vec<(Rational, usize)>,
    /// How many eigenvalues are zero because of integrals.
    pub integrals: usize,
    /// Whether energy is kept.
    pub symmetric: bool,
}

/// Where a stationary motion is.
#[derive(Clone, Debug)]
pub struct At {
    /// w, rad/s, and v
    pub angular_velocity: [Enclosure; 3],
    pub vertical: [Enclosure; 3],
    /// g as a point of the circle
    pub angle: [Enclosure; 2],
    /// phi', rad/s
    pub rotor_speed: Enclosure,
}

/// Why there is no linear motion.
#[derive(Clone, Debug, PartialEq)]
pub enum NoLinear {
    Motor(NoMotor),
    /// The rotor's windings do not know its angle.
    Windings,
    /// The bodies' inertia is not positive.
    Inertia,
    /// An entry is no fraction of polynomials.
    NotAlgebraic(Sym),
}

impl std::fmt::Display for NoLinear {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Motor(reason) => reason.fmt(f),
            Self::Windings => write!(f, "windings on a rotor whose angle is no state have no stationary currents"),
            Self::Inertia => write!(f, "the inertia of the bodies is not positive"),
            Self::NotAlgebraic(entry) => write!(f, "not a fraction of polynomials: {entry}"),
        }
    }
}

impl std::error::Error for NoLinear {}

impl Linearised {
    /// Of a scene; its data are the decimals that were written.
    ///
    /// # Errors
    /// [`NoLinear`].
    pub fn of(scene: &Scene, motor: &Motor) -> Result<Self, NoLinear> {
        let free = matches!(motor, Motor::Free);
        scene.machine.clone().apply(Linearise {
            system: &scene.system,
            data: &scene.machine_data,
            name: scene.machine.name(),
            free,
        })
    }

    /// det(mu - A) at a motion without the eigenvalues that structure explains, monic, coefficients from the constant upwards.
    /// `None` where an entry is not defined there, or where an integral is none: then the law is not the one it was
    /// thought to be.
    pub fn polynomial(&self, at: &At, bits: usize) -> Option<Vec<Enclosure>> {
        let places = self.places(at, bits)?;
        let row = |row: &Vec<Sym>| row.iter().map(|entry| value(*entry, &self.symbols, &places, bits)).collect();
        let matrix: Vec<Vec<Enclosure>> = self.matrix.iter().map(row).collect::<Option<_>>()?;
        let mut polynomial = characteristic(&matrix, bits)?;
        let rest = polynomial.split_off(self.integrals);
        polynomial.iter().all(|c| c.sign().is_none_or(|sign| sign == 0)).then_some(rest)
    }

    /// The values of the symbols at a motion.
    fn places(&self, at: &At, bits: usize) -> Option<Vec<Enclosure>> {
        let slip = &at.rotor_speed - &Enclosure::rational(self.field_speed, bits)?;
        Some([&at.angular_velocity[..], &at.vertical, &at.angle, &[slip]].concat())
    }

    /// The currents at a motion, A; empty where none flow.
    pub fn currents(&self, at: &At, bits: usize) -> Option<Vec<f64>> {
        let places = self.places(at, bits)?;
        self.resting.iter().map(|&i| value(i, &self.symbols, &places, bits).map(|i| i.to_f64())).collect()
    }

    /// The eigenvalues but for those of the integrals; those of idle windings come last.
    pub fn spectrum(&self, at: &At, bits: usize) -> Option<Spectrum> {
        let mut spectrum = Spectrum::of(&self.polynomial(at, bits)?, self.symmetric)?;
        for (rate, count) in &self.idle {
            spectrum.modes.push(Mode { place: Place::Real(Enclosure::rational(-*rate, bits)?), count: *count });
        }
        Some(spectrum)
    }
}

struct Linearise<'a> {
    system: &'a System,
    data: &'a MachineData,
    name: &'static str,
    free: bool,
}

/// Windings that fade at one rate.
struct Group {
    decay: Rational,
    /// What their moment gains by slip, psi_k'^2 / L_k summed up.
    strength: Sym,
    count: usize,
}

impl ForMachine for Linearise<'_> {
    type Output = Result<Linearised, NoLinear>;

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, _machine: M) -> Self::Output {
        let machine = M::read::<Sym, _>(&mut Decimals(self.data, self.name));
        let machine = machine.map_err(|reason| NoLinear::Motor(NoMotor::Data(reason)))?;
        let field_speed = machine.frame_speed();
        let field_speed = field_speed.as_constant().ok_or(NoLinear::NotAlgebraic(field_speed))?;
        let (g, slip, share) = (Sym::symbol("g"), Sym::symbol("s"), Sym::symbol("q"));
        let angle = if M::ROTOR == RotorState::AngleAndSpeed { g.circle() } else { Circle::zero() };
        let fed = is_fed(&machine);
        let groups = if fed { Vec::new() } else { windings(&machine, M::ROTOR, angle, slip)? };
        // currents that a supply feeds are states, which rest at the motion; the others are zero there
        let resting = if fed { resting_currents(&machine, angle, slip) } else { Some(Vec::new()) };
        let resting = resting.ok_or(NoLinear::Motor(NoMotor::NoRest))?;
        let own: Vec<Sym> = (0..resting.len()).map(|k| Sym::symbol(&format!("i{k}"))).collect();
        let currents = if fed { own.clone() } else { vec![Sym::ZERO; machine.windings()] };
        let mut of_currents = vec![Sym::ZERO; currents.len()];
        let moment = drive(&machine, angle, slip, &currents, &mut of_currents) + share;
        let rotor: &[Sym] = match M::ROTOR {
            RotorState::Prescribed => &[],
            RotorState::Speed => &[slip],
            RotorState::AngleAndSpeed => &[g, slip],
        };
        let (mut states, mut rates, acceleration) = match self.system {
            System::Gyrostat(bodies) => {
                let relative = if M::ROTOR == RotorState::Prescribed { Sym::ZERO } else { slip };
                let speed = relative + machine.frame_speed();
                carrier(&decimals(bodies), M::ROTOR, speed, moment)?
            }
            System::Bench { axial } => (Vec::new(), Vec::new(), moment / Sym::constant(Rational::decimal(*axial))),
        };
        let mut of_rotor = vec![Sym::ZERO; rotor.len()];
        M::ROTOR.write(slip, acceleration, &mut of_rotor);
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
            integrals: if matches!(self.system, System::Gyrostat(_)) { 2 } else { 0 } + usize::from(self.free),
            symmetric: keeps_energy(&machine, M::ROTOR),
        })
    }
}

fn vectors() -> [Vector3<Sym>; 2] {
    ["w", "v"].map(|stem| Vector3::from_fn(|i, _| Sym::symbol(&format!("{stem}{}", i + 1))))
}

/// Whether friction and windings take nothing, decided exactly.
fn keeps_energy(machine: &impl Machine<Sym>, rotor: RotorState) -> bool {
    let slip = Sym::symbol("s");
    let friction = machine.moment_law(slip, slip + machine.frame_speed());
    rotor == RotorState::Prescribed || machine.windings() == 0 && decide(friction, &Hypotheses::none()).is_zero()
}

/// The windings by the rates at which they fade, seen near zero currents.
fn windings(
    machine: &impl Machine<Sym>,
    rotor: RotorState,
    angle: Circle<Sym>,
    slip: Sym,
) -> Result<Vec<Group>, NoLinear> {
    let currents: Vec<Sym> = (0..machine.windings()).map(|k| Sym::symbol(&format!("i{k}"))).collect();
    if !currents.is_empty() && rotor != RotorState::AngleAndSpeed {
        return Err(NoLinear::Windings);
    }
    let mut rates = vec![Sym::ZERO; currents.len()];
    let moment = drive(machine, angle, slip, &currents, &mut rates);
    let mut groups: Vec<Group> = Vec::new();
    for (current, rate) in currents.iter().zip(rates) {
        let decay = -rate.diff(*current);
        let decay = decay.as_constant().ok_or(NoLinear::NotAlgebraic(decay))?;
        let strength = moment.diff(*current) * -rate.diff(slip);
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

/// (w, v), their rates, and phi'': from the theorem of angular momentum of the mass points.
fn carrier(
    bodies: &Gyrostat<Rational>,
    rotor: RotorState,
    rotor_speed: Sym,
    moment: Sym,
) -> Result<(Vec<Sym>, Vec<Sym>, Sym), NoLinear> {
    let zero = Rational::int(0);
    let column = |k: usize| {
        let one = |i: usize| if i == k { Rational::int(1) } else { zero };
        bodies.by_momentum(&Motion {
            angular_velocity: Vector3::zeros(),
            vertical: Vector3::zeros(),
            rotor_speed: zero,
            angular_acceleration: Vector3::new(one(0), one(1), one(2)),
            rotor_acceleration: one(3),
            moment: zero,
        })
    };
    let columns: [[Rational; 4]; 4] = std::array::from_fn(column);
    let [w, v] = vectors();
    let missing = bodies.by_momentum(&Motion {
        angular_velocity: w,
        vertical: v,
        rotor_speed,
        angular_acceleration: Vector3::zeros(),
        rotor_acceleration: Sym::ZERO,
        moment,
    });
    let solved = match rotor {
        // the rotor's own equation gives the moment that keeps its speed
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

/// The accelerations with which nothing is missing.
fn solved<const N: usize>(inverse: &[[Rational; N]; N], missing: &[Sym; N]) -> [Sym; N] {
    std::array::from_fn(|i| {
        let terms = inverse[i].iter().zip(missing);
        terms.fold(Sym::ZERO, |sum, (c, missing)| sum - Sym::constant(*c) * *missing)
    })
}

/// The derivatives of the rates, bordered by the windings' shares of the moment.
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

/// The value of a fraction of polynomials in the symbols; the windings' share of the moment is zero at the motion.
fn value(entry: Sym, symbols: &[Sym], places: &[Enclosure], bits: usize) -> Option<Enclosure> {
    let sum = |part: Sym| {
        let mut sum = Enclosure::integer(0, bits);
        for (exponents, c) in coefficients(part, symbols).ok()? {
            let mut term = Enclosure::rational(c.as_constant()?, bits)?;
            for (place, power) in places.iter().zip(exponents) {
                for _ in 0..power {
                    term = &term * place;
                }
            }
            sum = &sum + &term;
        }
        Some(sum)
    };
    sum(entry).or_else(|| {
        let form = normal(entry, &Hypotheses::none()).ok()?;
        sum(form.numerator())?.over(&sum(form.denominator())?)
    })
}
