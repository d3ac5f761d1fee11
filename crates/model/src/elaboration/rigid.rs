//! Stiff elements that a reduced model treats as rigid: the elongation of the spring, or the damped speed, is zero.
//!
//! A parameter k that tends to infinity, and multiplies a square in the potential energy or in Rayleigh's dissipation function, gives the constraint
//!
//!   V = k/2 g^2  ->  g = 0 .
//!
//! A generalised force Q_i = -k g g_i, with g_i in the ratio of the derivatives of g, gives the same constraint.

use super::loads::joule;
use super::reactions::transcribed;
use crate::equations::vanishes;
use crate::principles::loads::generalised;
use crate::{Constraint, Energies, Fault, Model, Trace, Zero};
use field::Rational;
use rustc_hash::FxHashMap;
use symbolic::{Dimension, Node, Sym, apart};

/// The expressions that vanish as a parameter tends to infinity.
#[derive(Default)]
struct Held {
    /// Elongations of springs, functions of positions.
    positions: Vec<Sym>,
    /// Speeds that a large coefficient of damping holds at zero.
    speeds: Vec<Sym>,
}

impl Model {
    /// Replaces parameters that tend to infinity by constraints.
    ///
    /// # Errors
    /// The parameter is not only the stiffness of a spring or the coefficient of a viscous force.
    pub(super) fn hold(&mut self, names: &[String]) -> Result<(), Vec<Fault>> {
        for name in names {
            let Some(place) = self.parameters.iter().position(|parameter| parameter.name == *name) else { continue };
            let parameter = self.parameters[place].clone();
            let found = apart(|| {
                let trace = Trace::of(self);
                let Held { positions, speeds } = held(self, &trace, place)?;
                let (arena, zeros) = transcribed(&trace, &[&positions[..], &speeds].concat())?;
                Some((arena, zeros, positions.len()))
            });
            let Some((arena, zeros, positions)) = found else {
                let title =
                    format!("`{name}` is not the stiffness of a spring or the coefficient of a viscous force alone");
                let accepted = "a parameter that stands once with a square in an energy, k*(x - y)^2/2, or with what a load is in \
                                proportion to, -k*(x - y)";
                return Err(vec![Fault::at(parameter.at.clone(), title, "it cannot grow without bound", accepted)]);
            };
            self.arena = arena;
            for (number, zero) in zeros.into_iter().enumerate() {
                let energy = if number < positions { joule() } else { joule() / Dimension::time() };
                self.constraints.push(Constraint {
                    name: None,
                    zero: Zero::Scalar(zero),
                    dimension: (energy / parameter.dimension).power(Rational::new(1, 2)),
                    gains: None,
                    gains_at: parameter.at.clone(),
                    at: parameter.at.clone(),
                });
            }
            self.absent.push(place);
        }
        Ok(())
    }
}

/// Returns the expressions that vanish as a parameter tends to infinity; `None` if the parameter has another effect too.
fn held(model: &Model, trace: &Trace<'_>, parameter: usize) -> Option<Held> {
    let letter = trace.parameters[parameter];
    if !vanishes(trace.kinetic_and_coenergy().diff(letter)) {
        return None;
    }
    let mut held = Held::default();
    let is_parameter = |sym: Sym| trace.parameters.contains(&sym) || sym.as_constant().is_some();
    let of_energy = |energy: Sym| -> Option<Vec<Sym>> {
        let by = energy.diff(letter);
        match vanishes(by) {
            true => Some(Vec::new()),
            false if by.symbols_of().contains(&letter) => None,
            false => squares(by, &is_parameter),
        }
    };
    held.positions = of_energy(trace.potential_energy())?;
    let Energies { dissipation, .. } = model.energies;
    held.speeds = of_energy(dissipation.map_or(Sym::ZERO, |id| trace.scalar(id)))?;
    let mut loads: Vec<Vec<Sym>> = loads_alone(model)
        .map(|alone| generalised(&Trace::of(&alone), false).into_iter().map(|force| force.diff(letter)).collect())
        .filter(|load: &Vec<Sym>| load.iter().any(|part| !vanishes(*part)))
        .collect();
    while let Some(load) = loads.first() {
        let (zero, of_it) = common_factors(load).into_iter().find_map(|zero| {
            // an action and its reaction may be separate loads
            let of_it: Vec<usize> = (0..loads.len()).filter(|&at| has_factor(&loads[at], zero)).collect();
            let sum: Vec<Sym> =
                (0..load.len()).map(|i| of_it.iter().fold(Sym::ZERO, |sum, &at| sum + loads[at][i])).collect();
            is_deflection(trace, zero, &sum, letter).then_some((zero, of_it))
        })?;
        let of_speeds = zero.symbols_of().iter().any(|symbol| trace.speeds.contains(symbol));
        if of_speeds {
            held.speeds.push(zero)
        } else {
            held.positions.push(zero)
        }
        let mut at = 0;
        loads.retain(|_| {
            at += 1;
            !of_it.contains(&(at - 1))
        });
    }
    let is_free = |zero: &Sym| {
        let letters = zero.symbols_of();
        trace.coordinates.iter().chain(&trace.speeds).any(|letter| letters.contains(letter))
    };
    let all = held.positions.iter().chain(&held.speeds);
    let is_any = all.clone().next().is_some();
    (is_any && all.clone().all(is_free)).then_some(held)
}

/// Returns one model for each load, with this load only and without dissipation.
fn loads_alone(model: &Model) -> impl Iterator<Item = Model> + '_ {
    let bare = move || {
        let mut bare = model.clone();
        (bare.forces, bare.torques, bare.generalised, bare.gravity) = (Vec::new(), Vec::new(), Vec::new(), None);
        bare.energies.dissipation = None;
        bare
    };
    let forces = model.forces.iter().map(move |force| Model { forces: vec![force.clone()], ..bare() });
    let torques = model.torques.iter().map(move |torque| Model { torques: vec![torque.clone()], ..bare() });
    let generalised = model.generalised.iter().map(move |force| Model { generalised: vec![*force], ..bare() });
    forces.chain(torques).chain(generalised)
}

/// Returns the square roots of the terms of a sum of squares with positive factors; `None` if the sum has another form.
fn squares(sum: Sym, is_parameter: &impl Fn(Sym) -> bool) -> Option<Vec<Sym>> {
    if let Node::Sum(a, b) = sum.node() {
        return Some([squares(a, is_parameter)?, squares(b, is_parameter)?].concat());
    }
    let mut root = Sym::ONE;
    for (base, power) in factors(sum) {
        match base.as_constant() {
            Some(value) if value.sign().is_none_or(|sign| sign < 0) && power % 2 != 0 => return None,
            Some(_) => {}
            None if base.symbols_of().into_iter().all(is_parameter) => {}
            None if power > 0 && power % 2 == 0 => root *= base.powi(power / 2),
            None => return None,
        }
    }
    (root != Sym::ONE).then(|| vec![root])
}

/// Returns the factors that all components of a load have in common.
fn common_factors(load: &[Sym]) -> Vec<Sym> {
    let mut acting = load.iter().filter(|part| !vanishes(**part));
    let mut common = acting.next().map_or_else(Vec::new, |first| factors(*first));
    for part in acting {
        let own = factors(*part);
        common.retain(|(base, _)| own.iter().any(|(other, _)| is_same(*other, *base)));
    }
    let is_zero_of_it = |(base, power): &(Sym, i32)| *power > 0 && base.as_constant().is_none();
    common.into_iter().filter(is_zero_of_it).map(|(base, _)| base).collect()
}

fn has_factor(load: &[Sym], zero: Sym) -> bool {
    common_factors(load).into_iter().any(|own| is_same(own, zero))
}

/// Returns whether two expressions are equal up to their sign.
fn is_same(one: Sym, other: Sym) -> bool {
    one == other || vanishes(one + other) || vanishes(one - other)
}

/// Returns whether a load is -c g g_i, with the derivatives g_i of a factor g and one constant c.
fn is_deflection(trace: &Trace<'_>, zero: Sym, load: &[Sym], letter: Sym) -> bool {
    let letters = zero.symbols_of();
    let of_speeds = trace.speeds.iter().any(|speed| letters.contains(speed));
    let slope = |i: usize| if of_speeds { trace.by_speed(zero, i) } else { trace.by_coordinate(zero, i) };
    let slopes: Vec<Sym> = (0..load.len()).map(slope).collect();
    let is_along = |i: usize, j: usize| vanishes((load[i] * slopes[j] - load[j] * slopes[i]) / zero);
    let Some(first) = (0..load.len()).find(|&i| !vanishes(slopes[i])) else { return false };
    let share = load[first] / (zero * slopes[first]);
    let is_number = || trace.coordinates.iter().chain(&trace.speeds).all(|letter| vanishes(share.diff(*letter)));
    !letters.contains(&letter) && is_number() && (0..load.len()).all(|i| (0..i).all(|j| is_along(i, j)))
}

/// Returns the factors of an expression with their powers, without expansion. For a sum these are the common factors of its terms.
fn factors(of: Sym) -> Vec<(Sym, i32)> {
    let mut found: FxHashMap<Sym, i32> = FxHashMap::default();
    let mut order: Vec<Sym> = Vec::new();
    let mut open = vec![(of, 1)];
    while let Some((part, power)) = open.pop() {
        match part.node() {
            Node::Product(a, b) => open.extend([(b, power), (a, power)]),
            Node::Quotient(a, b) => open.extend([(b, -power), (a, power)]),
            Node::Negation(a) => open.extend([(a, power), (-Sym::ONE, power)]),
            Node::Power(a, own) => open.push((a, power * own as i32)),
            node => {
                let common = match node {
                    Node::Sum(a, b) | Node::Difference(a, b) => {
                        let other = factors(b);
                        let mut common = factors(a);
                        common.retain(|(base, _)| {
                            base.as_constant().is_none() && other.iter().any(|(own, _)| own == base)
                        });
                        common.into_iter().map(|(base, _)| base).collect()
                    }
                    _ => Vec::new(),
                };
                for base in if common.is_empty() { vec![part] } else { common } {
                    let known = found.entry(base).or_insert_with(|| {
                        order.push(base);
                        0
                    });
                    *known += power;
                }
            }
        }
    }
    order.into_iter().map(|base| (base, found[&base])).collect()
}
