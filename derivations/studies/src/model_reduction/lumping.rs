//! Exact lumping of windings with linearly dependent fluxes, found from the machine's laws.
//!
//! Windings with a common ratio r = R_k/L_k act on the rotor only through sum_k psi_k'(g) i_k. Let the fluxes chi_j,
//! chosen among theirs, span all of them: psi_k' = sum_j B_kj chi_j'. The combinations u = B^T i satisfy closed
//! equations,
//!
//!   u' = -r u - G chi' g' ,    G = B^T diag(1/L) B ,
//!
//! in an invariant subspace of the currents. Currents orthogonal to it do no work and decay as exp(-r t) without excitation: they
//! are unobservable. With G = K D K^T, K unit lower triangular, j = K^-1 u are the currents of windings with the fluxes
//! K^T chi, the inductances 1/D and the resistances r/D. All of these are rational in the data. Equality of torque and currents
//! is then decided over expressions, for all angles, slips and currents.

use super::currents::has_one_harmonic;
use super::elimination::{factored, inverse_of_unit, pivots, shares};
use field::{Base, Circle, Over, Rational, Scalar};
use motor::{Machine, RotorState, is_fed, torque_and_current_rates};
use symbolic::{Hypotheses, Sym, decide};

/// The number of harmonics of the fluxes that the sampled angles distinguish. With more harmonics the proof fails, so
/// that a wrong model is impossible.
const HARMONICS: i64 = 4;

/// The lumped windings of a machine, and the maps between its currents and theirs.
#[derive(Clone, Debug, PartialEq)]
pub struct Lumping {
    pub windings: Vec<Lump>,
    /// The matrix T of j = T i: a row for each lumped winding.
    pub down: Vec<Vec<Rational>>,
    /// The matrix U of i = U j + a decaying part: a row for each winding of the machine.
    pub up: Vec<Vec<Rational>>,
    /// The ratio r of each winding of the machine, 1/s.
    pub rates: Vec<Rational>,
}

/// A lumped winding.
#[derive(Clone, Debug, PartialEq)]
pub struct Lump {
    pub inductance: Rational,
    pub resistance: Rational,
    /// The terms of its flux in the fluxes of the machine's windings: (winding, factor).
    pub shares: Vec<(usize, Rational)>,
}

impl Lumping {
    /// The lumping of a machine with exact data; `None` where no winding is saved, the data are not exact, the proof
    /// fails, or a supply or sliding conductors act on the windings.
    pub fn of(machine: &(impl Machine<Sym> + Clone)) -> Option<Self> {
        if is_fed(machine) {
            return None;
        }
        let count = machine.windings();
        let constant = |value: Sym| value.as_constant().filter(|value| value.is_defined());
        let inductances = (0..count).map(|k| constant(machine.inductance(k))).collect::<Option<Vec<_>>>()?;
        let resistances = (0..count).map(|k| constant(machine.resistance(k))).collect::<Option<Vec<_>>>()?;
        let zero = Rational::int(0);
        if inductances.contains(&zero) {
            return None;
        }
        let rates: Vec<Rational> = resistances.iter().zip(&inductances).map(|(&r, &l)| r / l).collect();
        // values at sufficiently many angles determine the functions of the angle
        let angle = |n: i64| Circle::from_half_tangent(Sym::constant(Rational::new(n, 3)));
        let slopes = |k: usize| -> Option<Vec<Rational>> {
            let values = (-HARMONICS..=HARMONICS).map(|n| machine.linkage(k, angle(n).moving(Sym::int(1))).slope);
            values.map(constant).collect()
        };
        let slopes = (0..count).map(slopes).collect::<Option<Vec<_>>>()?;
        let mut found =
            Lumping { windings: Vec::new(), down: Vec::new(), up: vec![Vec::new(); count], rates: rates.clone() };
        for (place, &rate) in rates.iter().enumerate() {
            if rates[..place].contains(&rate) {
                continue;
            }
            let members: Vec<usize> = (0..count).filter(|&k| rates[k] == rate).collect();
            found.lump(&members, rate, &members.iter().map(|&k| slopes[k].clone()).collect::<Vec<_>>(), &inductances);
        }
        (found.windings.len() < count && found.is_exact(machine)).then_some(found)
    }

    /// Adds the lumped windings for those of one ratio r.
    fn lump(&mut self, members: &[usize], rate: Rational, slopes: &[Vec<Rational>], inductances: &[Rational]) {
        let zero = Rational::int(0);
        let pivots = pivots(slopes);
        let b = shares(slopes, &pivots);
        let m = pivots.len();
        let sum = |i: usize, j: usize| {
            let terms = members.iter().zip(&b).map(|(&k, row)| row[i] * row[j] / inductances[k]);
            terms.fold(zero, |sum, term| sum + term)
        };
        let g: Vec<Vec<Rational>> = (0..m).map(|i| (0..m).map(|j| sum(i, j)).collect()).collect();
        let (k, d) = factored(&g);
        let inverse = inverse_of_unit(&k);
        let count = self.up.len();
        for j in 0..m {
            // j = K^-1 B^T i
            let mut down = vec![zero; count];
            // i = diag(1/L) B K^-T D^-1 j
            for (place, &member) in members.iter().enumerate() {
                let along = (0..m).fold(zero, |sum, i| sum + inverse[j][i] * b[place][i]);
                down[member] = along;
            }
            for (row, up) in self.up.iter_mut().enumerate() {
                up.push(down[row] / (inductances[row] * d[j]));
            }
            self.down.push(down);
            let fluxes = (0..m).map(|i| (members[pivots[i]], k[i][j])).filter(|(_, share)| *share != zero);
            let (inductance, resistance) = (Rational::int(1) / d[j], rate / d[j]);
            self.windings.push(Lump { inductance, resistance, shares: fluxes.collect() });
        }
    }

    /// Whether the torque is equal and the lumped currents satisfy their own equations, for all angles, slips and
    /// currents.
    fn is_exact(&self, machine: &(impl Machine<Sym> + Clone)) -> bool {
        let lumped = Lumped { machine: machine.clone(), windings: self.over(Sym::constant) };
        let angle = Circle { cos: Sym::symbol("c"), sin: Sym::symbol("s") };
        let slip = Sym::symbol("slip");
        let currents: Vec<Sym> = (0..self.up.len()).map(|k| Sym::symbol(&format!("i{k}"))).collect();
        let down = |values: &[Sym]| -> Vec<Sym> {
            let row = |row: &Vec<Rational>| {
                row.iter().zip(values).fold(Sym::ZERO, |sum, (&share, &value)| sum + Sym::constant(share) * value)
            };
            self.down.iter().map(row).collect()
        };
        let mut rates = vec![Sym::ZERO; currents.len()];
        let torque = torque_and_current_rates(machine, angle, slip, &currents, &mut rates);
        let mut lumped_rates = vec![Sym::ZERO; self.windings.len()];
        let same = torque_and_current_rates(&lumped, angle, slip, &down(&currents), &mut lumped_rates);
        let hypotheses = Hypotheses::none().on_circle(angle);
        let equal = |a: Sym, b: Sym| decide(a - b, &hypotheses).is_zero();
        equal(torque, same) && down(&rates).iter().zip(&lumped_rates).all(|(&a, &b)| equal(a, b))
    }

    /// The windings with their data in another scalar type.
    pub fn over<P: Copy>(&self, number: impl Fn(Rational) -> P) -> Vec<Winding<P>> {
        let winding = |lump: &Lump| Winding {
            inductance: number(lump.inductance),
            resistance: number(lump.resistance),
            shares: lump.shares.iter().map(|&(k, share)| (k, number(share))).collect(),
        };
        self.windings.iter().map(winding).collect()
    }

    /// The lumped currents j = T i.
    pub fn lumped(&self, currents: &[f64]) -> Vec<f64> {
        let sum = |row: &Vec<Rational>| row.iter().zip(currents).map(|(share, i)| share.to_f64() * i).sum();
        self.down.iter().map(sum).collect()
    }

    /// The map from lumped currents to the machine's, for given currents of the machine at time zero.
    pub fn recovery(&self, start: &[f64]) -> Recovery {
        let numbers = |row: &Vec<Rational>| row.iter().map(|share| share.to_f64()).collect();
        let up: Vec<Vec<f64>> = self.up.iter().map(numbers).collect();
        let seen = self.lumped(start);
        let rest = start.iter().zip(&up).map(|(i, row)| i - dot(row, &seen)).collect();
        Recovery { up, rest, rates: numbers(&self.rates) }
    }
}

/// The machine's currents from the lumped ones: i = U j plus the unobservable part of the initial currents, which decays.
#[derive(Clone, Debug, PartialEq)]
pub struct Recovery {
    up: Vec<Vec<f64>>,
    rest: Vec<f64>,
    /// The decay rates, 1/s.
    rates: Vec<f64>,
}

impl Recovery {
    /// The currents i at a time, from j at that time.
    pub fn currents(&self, time: f64, lumped: &[f64]) -> impl Iterator<Item = f64> {
        let each = self.up.iter().zip(&self.rest).zip(&self.rates);
        each.map(move |((row, rest), rate)| match *rest {
            0.0 => dot(row, lumped),
            rest => dot(row, lumped) + rest * (-rate * time).exp(),
        })
    }
}

fn dot(row: &[f64], vector: &[f64]) -> f64 {
    row.iter().zip(vector).map(|(share, value)| share * value).sum()
}

/// A machine with other windings, whose fluxes are sums of its own.
#[derive(Clone, Debug)]
pub struct Lumped<P, M> {
    pub machine: M,
    pub windings: Vec<Winding<P>>,
}

/// A lumped winding with data in the machine's scalar type.
#[derive(Clone, Debug)]
pub struct Winding<P> {
    inductance: P,
    resistance: P,
    shares: Vec<(usize, P)>,
}

impl<P: Base, M: Machine<P>> Lumped<P, M> {
    /// A machine with its own windings.
    pub fn unchanged(machine: M) -> Self {
        let winding = |k: usize| Winding {
            inductance: machine.inductance(k),
            resistance: machine.resistance(k),
            shares: vec![(k, P::one())],
        };
        Lumped { windings: (0..machine.windings()).map(winding).collect(), machine }
    }
}

impl<P: Base, M: Machine<P>> Machine<P> for Lumped<P, M> {
    fn rotor(&self) -> RotorState {
        self.machine.rotor()
    }

    fn frame_speed(&self) -> P {
        self.machine.frame_speed()
    }

    fn windings(&self) -> usize {
        self.windings.len()
    }

    fn inductance(&self, winding: usize) -> P {
        self.windings[winding].inductance
    }

    fn resistance(&self, winding: usize) -> P {
        self.windings[winding].resistance
    }

    fn linkage<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> S {
        let shares = self.windings[winding].shares.iter();
        shares.fold(S::zero(), |sum, &(k, share)| sum + S::lift(share) * self.machine.linkage(k, angle))
    }

    fn field_energy<S: Over<P>>(&self, angle: Circle<S>) -> S {
        self.machine.field_energy(angle)
    }

    fn torque_law<S: Over<P>>(&self, slip: S, speed: S) -> S {
        self.machine.torque_law(slip, speed)
    }
}

/// A bound of the error of the torque, N m, along a motion with slips of at most `slip` (rad/s), where windings of
/// nearly equal ratios are lumped at the ratio r: |i_k - i_k at r| <= |1/r_k - 1/r| max|psi_k'| max|g'| / L_k, because
/// exp(-r_k t) - exp(-r t) has one sign, and each current acts with psi_k'. The currents start at zero. `steepest` is
/// max |psi_k'|.
pub fn merged_at_most(windings: &[(f64, f64, f64)], rate: f64, slip: f64) -> f64 {
    let off = |&(inductance, resistance, steepest): &(f64, f64, f64)| {
        (inductance / resistance - 1.0 / rate).abs() * steepest * steepest * slip / inductance
    };
    windings.iter().map(off).sum()
}

/// L_k, R_k and max |psi_k'| of each winding, for [`merged_at_most`]. `None` where a flux has more than one harmonic.
pub fn seen_windings<M: Machine<f64>>(machine: &M) -> Option<Vec<(f64, f64, f64)>> {
    let slope = |k: usize, angle: Circle<f64>| machine.linkage(k, angle.moving(1.0)).slope;
    let quarter = Circle { cos: 0.0, sin: 1.0 };
    let seen = |k: usize| {
        // psi' = A cos g + B sin g
        let steepest = slope(k, Circle::zero()).hypot(slope(k, quarter));
        has_one_harmonic(machine, k).then(|| (machine.inductance(k), machine.resistance(k), steepest))
    };
    (0..machine.windings()).map(seen).collect()
}
