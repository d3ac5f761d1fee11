//! The sub-flows of a motor on its bench near its steady angle: symbolic derivatives of the flows.
//!
//! The integrator's flows are evaluated over tangents of expressions. Windings with equal decay rates act through one
//! unknown, q = sum psi_k' c_k / L_k. The deviations (g, p, q_1, q_2, ..) therefore form an invariant space, which is
//! verified exactly; all other deviations of the fluxes decay. If the state is an equilibrium of every sub-flow, the
//! linearised step is the product of these matrices.

use super::multipliers::Matrix;
use super::symbolic_linearisation::keeps_energy;
use algebra::real::{Ordered, TaylorModel};
use field::{Analytic, Circle, Over, Rational, Scalar, Tangent};
use motor::{BenchFlows, Kick, Law, Machine, Motor, Point, RotorState, Rule, has_known_flow};
use num_traits::Zero;
use std::cell::RefCell;
use symbolic::{Formulas, Hypotheses, Sym, decide, normal};

/// The derivative of a flow at the equilibrium.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    size: usize,
    /// The entries as functions of cos g, sin g, the time t, and the decays.
    entries: Formulas,
    /// The rates (a, b), 1/s, of each quotient (exp(-a t) - exp(-b t))/((b - a) t).
    decays: Vec<[Rational; 2]>,
}

impl Piece {
    /// The matrix of the flow over a time, s, at an angle given by its cosine and sine.
    pub fn over(&self, angle: &[TaylorModel; 2], length: &TaylorModel) -> Option<Matrix> {
        let decay = |[a, b]: &[Rational; 2]| {
            let part = |rate: &Rational| Some(length.times(&length.fraction(*rate)?));
            TaylorModel::between_decays(&part(a)?, &part(b)?)
        };
        let mut unknowns = vec![angle[0], angle[1], *length];
        unknowns.extend(self.decays.iter().map(decay).collect::<Option<Vec<_>>>()?);
        let entries = self.entries.values(&unknowns, length)?;
        Some(entries.chunks(self.size).map(<[TaylorModel]>::to_vec).collect())
    }
}

/// The kick and the drift of a motor with an angle and a torque linear in the slip, on a bench with the moment of
/// inertia A' (kg m^2), and whether the motor has no dissipation; `None` for other motors.
pub(super) fn pieces(motor: &Motor, axial: f64) -> Option<([Piece; 2], bool)> {
    let machine = motor.decimals();
    let slip = Sym::symbol("s");
    let bend = machine.torque_law(slip, slip + machine.frame_speed()).diff(slip).diff(slip);
    let linear = decide(bend, &Hypotheses::none()).is_zero();
    if !(linear && machine.rotor() == RotorState::AngleAndSpeed && has_known_flow(&machine)) {
        return None;
    }
    let near = Near::of(&machine, Sym::constant(Rational::decimal(axial)))?;
    let t = Sym::symbol("t");
    let flows = BenchFlows { axial: Tangent::fixed(near.axial), frame_speed: Tangent::lift(machine.frame_speed()) };
    let decays: RefCell<Vec<([Rational; 2], Sym)>> = RefCell::default();
    // a rate that is no constant fraction has no decay here
    let quotient = |a: Tangent<Sym>, b: Tangent<Sym>| {
        let rate = |x: Tangent<Sym>| constant(x.value.diff(t)).unwrap_or(Rational::UNDEFINED);
        let (rates, mut known) = ([rate(a), rate(b)], decays.borrow_mut());
        let found = known.iter().find(|(other, _)| *other == rates).map(|(_, symbol)| *symbol);
        Tangent::fixed(found.unwrap_or_else(|| {
            let symbol = Sym::symbol(&format!("E{}", known.len()));
            known.push((rates, symbol));
            symbol
        }))
    };
    // a linear torque needs no collocation
    let rule = Rule { nodes: [Tangent::zero(); 4], weights: [Tangent::zero(); 4], matrix: [[Tangent::zero(); 4]; 4] };
    let kick = Kick::new(&machine, Law::Linear, Tangent::fixed(t), flows.compliance(), quotient, rule);
    let pushed = near.matrix(|point| {
        flows.push(&machine, &kick, point);
    })?;
    let drifted = near.matrix(|point| flows.drift(Tangent::fixed(t), point))?;
    let pieces = [piece(&pushed, t, &decays.into_inner())?, piece(&drifted, t, &[])?];
    Some((pieces, keeps_energy(&machine)))
}

/// The equilibrium, and the data of deviations from it.
struct Near {
    axial: Sym,
    /// g, p and the fluxes at the equilibrium.
    rest: Point<Sym>,
    /// The coefficient of each flux in the unknown of its group, psi_k'/L_k, by group.
    shares: Vec<Vec<Sym>>,
    /// sum psi_k'^2/L_k of each group, and psi_k'.
    strengths: Vec<Sym>,
    slopes: Vec<Sym>,
}

impl Near {
    fn of(machine: &impl Machine<Sym>, axial: Sym) -> Option<Self> {
        let angle = Sym::symbol("g");
        let linked: Vec<Tangent<Sym>> =
            (0..machine.windings()).map(|k| machine.linkage(k, angle.circle().moving(Sym::int(1)))).collect();
        let mut rates: Vec<Rational> = Vec::new();
        let mut shares: Vec<Vec<Sym>> = Vec::new();
        let mut strengths: Vec<Sym> = Vec::new();
        for (k, psi) in linked.iter().enumerate() {
            // a winding without resistance would not decay
            let rate = constant(machine.resistance(k) / machine.inductance(k)).filter(|rate| rate.sign() == Some(1))?;
            let group = rates.iter().position(|known| *known == rate).unwrap_or_else(|| {
                rates.push(rate);
                shares.push(vec![Sym::ZERO; linked.len()]);
                strengths.push(Sym::ZERO);
                rates.len() - 1
            });
            shares[group][k] = psi.slope / machine.inductance(k);
            strengths[group] += psi.slope * shares[group][k];
        }
        let fluxes = linked.iter().map(|psi| psi.value).collect();
        let rest = Point { angle, momentum: axial * machine.frame_speed(), fluxes };
        Some(Near { axial, rest, shares, strengths, slopes: linked.iter().map(|psi| psi.slope).collect() })
    }

    /// The matrix of a flow for deviations, row by row; `None` where a flux acts other than through q.
    fn matrix(&self, flow: impl Fn(&mut Point<Tangent<Sym>>)) -> Option<Vec<Vec<Sym>>> {
        let after = |moved: &Point<Sym>| {
            let each = self.rest.fluxes.iter().zip(&moved.fluxes).map(|(value, slope)| Tangent::moving(*value, *slope));
            let mut point = Point {
                angle: Tangent::moving(self.rest.angle, moved.angle),
                momentum: Tangent::moving(self.rest.momentum, moved.momentum),
                fluxes: each.collect(),
            };
            flow(&mut point);
            let of = |shares: &Vec<Sym>| {
                shares.iter().zip(&point.fluxes).fold(Sym::ZERO, |sum, (share, flux)| sum + *share * flux.slope)
            };
            [point.angle.slope, point.momentum.slope].into_iter().chain(self.shares.iter().map(of)).collect::<Vec<_>>()
        };
        let unit = |k: usize| {
            let one = |place: usize| if place == k { Sym::int(1) } else { Sym::ZERO };
            let fluxes = (0..self.slopes.len()).map(|place| one(place + 2)).collect();
            Point { angle: one(0), momentum: one(1), fluxes }
        };
        let mut columns = vec![after(&unit(0)), after(&unit(1))];
        for (group, strength) in self.strengths.iter().enumerate() {
            // q = 1, distributed over the windings by their slopes
            let of = |(share, slope): (&Sym, &Sym)| if share.is_zero() { Sym::ZERO } else { *slope / *strength };
            let fluxes = self.shares[group].iter().zip(&self.slopes).map(of).collect();
            let column = after(&Point { angle: Sym::ZERO, momentum: Sym::ZERO, fluxes });
            for (k, share) in self.shares[group].iter().enumerate().filter(|(_, share)| !share.is_zero()) {
                let single = after(&unit(k + 2));
                let same =
                    single.iter().zip(&column).all(|(a, b)| decide(*a - *share * *b, &Hypotheses::none()).is_zero());
                same.then_some(())?;
            }
            columns.push(column);
        }
        Some((0..columns.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect())
    }
}

fn constant(expression: Sym) -> Option<Rational> {
    normal(expression, &Hypotheses::none()).ok()?.to_sym().as_constant()
}

fn piece(matrix: &[Vec<Sym>], t: Sym, decays: &[([Rational; 2], Sym)]) -> Option<Piece> {
    let Circle { cos, sin } = Sym::symbol("g").circle();
    let [c, s] = ["c", "s"].map(Sym::symbol);
    let entry =
        |entry: &Sym| Some(normal(*entry, &Hypotheses::none()).ok()?.to_sym().substitute(&[(cos, c), (sin, s)]));
    let entries: Vec<Sym> = matrix.iter().flatten().map(entry).collect::<Option<_>>()?;
    let unknowns: Vec<Sym> = [c, s, t].into_iter().chain(decays.iter().map(|(_, decay)| *decay)).collect();
    let entries = Formulas::of(&entries, &unknowns).ok()?;
    Some(Piece { size: matrix.len(), entries, decays: decays.iter().map(|(rates, _)| *rates).collect() })
}
