//! The equations that hold along every motion of a model: accelerations and multipliers from its equations, speeds and positions from its
//! constraints, and hypotheses.

use crate::half_turn::is_half_turn;
use crate::letters::circle;
use model::Trace;
use model::equations::{Characteristics, Equation, Equations, Level, Singular, constraints_of, solved};
use symbolic::{Hypotheses, Node, Sym, coefficients, decide, normal, substitute_all};

/// Symbols with the values that replace them.
#[derive(Clone)]
pub(crate) struct Round {
    pub values: Vec<(Sym, Sym)>,
    /// Expressions that vanish, are linear in the symbols and determine the values; `None` for values from the equations of motion.
    pub by: Option<Vec<Sym>>,
}

/// The equations along a motion, as rounds of replacements that are applied one after the other, and rewriting rules.
#[derive(Clone)]
pub(crate) struct Motion<'t, 'm> {
    pub trace: &'t Trace<'m>,
    pub hypotheses: Hypotheses,
    pub rounds: Vec<Round>,
    /// Coordinates whose squares are rewritten, with the constraints that determine the squares.
    pub squares: Vec<(Sym, Sym)>,
    /// Constraints that could not be solved; a point may violate them.
    pub open: Vec<String>,
    /// The divisors that hypotheses introduced.
    pub divisors: Vec<Sym>,
    /// The expressions that vanish by constraints and hypotheses.
    pub held: Vec<Sym>,
    /// The constraints of positions.
    positions: Vec<Sym>,
    /// The number of rounds before the first hypothesis.
    pub before_hypotheses: Option<usize>,
}

impl<'t, 'm> Motion<'t, 'm> {
    /// All motions that the constraints allow, with arbitrary accelerations.
    pub fn by_constraints(trace: &'t Trace<'m>) -> Self {
        let mut motion = Motion::without_anything(trace);
        motion.keep(&constraints_of(trace));
        motion.turn_freely();
        motion
    }

    /// The motions on which some rates vanish; solving the constraints for dependent rates may then need no divisor.
    pub fn at_rest(trace: &'t Trace<'m>, rates: &[(Sym, Sym)]) -> Self {
        let mut motion = Motion::without_anything(trace);
        motion.set(rates.to_vec());
        motion.keep(&constraints_of(trace));
        motion.turn_freely();
        motion.held.extend(rates.iter().map(|&(rate, _)| rate));
        motion.set(rates.to_vec());
        motion
    }

    /// The motions by the equations of motion, with all positions and speeds that the constraints allow.
    ///
    /// # Errors
    /// The reason for which the equations of motion cannot be solved.
    pub fn by_equations(trace: &'t Trace<'m>) -> Result<Self, String> {
        let constraints = constraints_of(trace);
        let mut motion = Motion::without_anything(trace);
        let (accelerations, multipliers) = solved(trace).map_err(|why| {
            let why = match why {
                Singular::Massless { coordinate } => format!("no inertia resists {}", trace.direction(coordinate)),
                redundant @ Singular::Redundant { .. } => redundant.to_string(),
            };
            format!("the equations of motion have no solution by elimination: {why}")
        })?;
        let letters = constraints.iter().map(|one| one.multiplier);
        let of_accelerations = trace.accelerations.iter().copied().zip(accelerations);
        motion.rounds.push(Round { values: of_accelerations.chain(letters.zip(multipliers)).collect(), by: None });
        motion.keep(&constraints);
        motion.turn_freely();
        Ok(motion)
    }

    /// Arbitrary motions, without equations of motion and constraints.
    pub fn without_anything(trace: &'t Trace<'m>) -> Self {
        Motion {
            trace,
            hypotheses: Hypotheses::none(),
            rounds: Vec::new(),
            squares: Vec::new(),
            open: Vec::new(),
            divisors: Vec::new(),
            held: Vec::new(),
            positions: Vec::new(),
            before_hypotheses: None,
        }
    }

    /// Adds the rules that quaternions of free frames have length one.
    fn turn_freely(&mut self) {
        self.hypotheses = self.with_free_frames(self.hypotheses.clone());
    }

    /// Hypotheses with the rules that quaternions of free frames have length one.
    pub fn with_free_frames(&self, hypotheses: Hypotheses) -> Hypotheses {
        let plain = self.trace.model.coordinates.len();
        let quaternions = self.trace.coordinates[plain..].chunks_exact(4);
        quaternions.fold(hypotheses, |all, parts| all.unit_vector([parts[0], parts[1], parts[2], parts[3]]))
    }

    fn keep(&mut self, constraints: &[Equation]) {
        // the residual of a stabilised constraint need not vanish
        let constraints: Vec<Equation> = constraints.iter().filter(|one| one.gains.is_none()).cloned().collect();
        if constraints.is_empty() {
            return;
        }
        self.held.extend(constraints.iter().flat_map(|one| [one.zero, one.rate]));
        let characteristics = Characteristics::of(self.trace, &constraints);
        match characteristics.motion(self.trace, &constraints) {
            Ok(known) => {
                let rates = constraints.iter().map(|one| one.rate).collect();
                let accelerated = constraints.iter().map(|one| accelerated(self.trace, one)).collect();
                // the values of accelerations contain no dependent speeds
                self.rounds.push(Round { values: known.speeds, by: Some(rates) });
                self.rounds.push(Round { values: known.accelerations, by: Some(accelerated) });
            }
            Err(place) => {
                self.open.push(format!("{}, which is not linear in the speeds", constraints[place].title(place)))
            }
        }
        for (place, constraint) in constraints.iter().enumerate().filter(|(_, one)| one.level == Level::Position) {
            self.positions.push(constraint.zero);
            if !self.solve_position(constraint.zero) {
                self.open.push(format!("{}, which no coordinate and no parameter solves", constraint.title(place)));
            }
        }
    }

    /// Solves a constraint for a coordinate or its square, otherwise for a parameter, which then depends on the free positions.
    fn solve_position(&mut self, zero: Sym) -> bool {
        let zero = self.reduced(zero);
        for &coordinate in &self.trace.coordinates {
            let Ok(terms) = coefficients(zero, &[coordinate]) else { continue };
            let of = |power: u32| terms.iter().find(|(exponents, _)| exponents[0] == power).map(|(_, value)| *value);
            let moves = |value: Sym| self.trace.coordinates.iter().any(|each| value.symbols_of().contains(each));
            let highest = terms.first().map_or(0, |(exponents, _)| exponents[0]);
            match (highest, of(highest)) {
                (1, Some(factor)) if !moves(factor) => {
                    let value = -of(0).unwrap_or(Sym::ZERO) / factor;
                    self.give((coordinate, value), zero);
                    return true;
                }
                _ if self.solve_square(zero, coordinate) => return true,
                _ => {}
            }
        }
        let Some(Solution { symbol, value, divisor }) =
            self.trace.parameters.iter().find_map(|&parameter| linear(zero, parameter))
        else {
            return self.trace.parameters.iter().any(|&parameter| self.solve_square(zero, parameter));
        };
        self.divisors.push(divisor);
        self.give((symbol, value), zero);
        true
    }

    /// Adds a replacement of a symbol that follows from an expression that vanishes.
    fn give(&mut self, known: (Sym, Sym), zero: Sym) {
        self.rounds.push(Round { values: vec![known], by: Some(vec![zero]) });
    }

    /// Solves an equation for the square of a symbol, if the symbol occurs only as this square with a numerical factor.
    fn solve_square(&mut self, zero: Sym, symbol: Sym) -> bool {
        let Ok(terms) = coefficients(zero, &[symbol]) else { return false };
        let of = |power: u32| terms.iter().find(|(exponents, _)| exponents[0] == power).map(|(_, value)| *value);
        let is_square = terms.iter().all(|(exponents, _)| matches!(exponents[0], 0 | 2));
        let Some(factor) = of(2).filter(|factor| is_square && factor.as_constant().is_some()) else { return false };
        let with = self.hypotheses.clone().rule(symbol, 2, -of(0).unwrap_or(Sym::ZERO) / factor);
        let is_taken = with.check().is_ok();
        if is_taken {
            self.hypotheses = with;
            self.squares.push((symbol, zero));
        }
        is_taken
    }

    /// The coordinates, speeds and parameters that were replaced.
    pub fn replaced(&self) -> Vec<Sym> {
        let trace = self.trace;
        let known = [&trace.coordinates, &trace.speeds, &trace.parameters];
        let all = self.rounds.iter().flat_map(|round| &round.values).map(|&(symbol, _)| symbol);
        all.filter(|symbol| known.iter().any(|list| list.contains(symbol))).collect()
    }

    /// An expression after all replacements and rules.
    pub fn reduced(&self, expression: Sym) -> Sym {
        let found = self.rounds.iter().fold(expression, |now, round| substitute_all(&[now], &round.values)[0]);
        self.with_circles(found)
    }

    /// An expression in which cosines and sines of angles with π have their exact values.
    fn with_circles(&self, expression: Sym) -> Sym {
        let pi = self.trace.pi;
        let of = |leaf: Sym| match leaf.node() {
            Node::Cos(angle) if angle.symbols_of().contains(&pi) => Some((leaf, circle(angle, pi).0)),
            Node::Sin(angle) if angle.symbols_of().contains(&pi) => Some((leaf, circle(angle, pi).1)),
            _ => None,
        };
        let known: Vec<(Sym, Sym)> = expression.leaves_of().into_iter().filter_map(of).collect();
        if known.is_empty() { expression } else { expression.substitute(&known) }
    }

    /// Assumes that an expression vanishes, and solves this equation for a symbol, preferably for `first`.
    ///
    /// # Errors
    /// The equation cannot be solved for any symbol, or no point satisfies it.
    pub fn assume(&mut self, zero: Sym, first: Option<Sym>) -> Result<(), String> {
        self.held.push(zero);
        self.before_hypotheses.get_or_insert(self.rounds.len());
        let zero = self.reduced(zero);
        if decide(zero, &self.hypotheses).is_zero() {
            return Ok(());
        }
        // since π is transcendental, such an expression cannot vanish
        if zero.symbols_of().into_iter().all(is_half_turn) {
            return Err("this hypothesis contradicts the ones before it, or the model".to_owned());
        }
        match solution(self.trace, zero, first) {
            Some(Solution { symbol, value, divisor }) => {
                // the expression is a fraction, and its numerator was solved
                let own = normal(zero, &Hypotheses::none()).map_or(Sym::ONE, |form| form.denominator());
                let below = [own, divisor].into_iter();
                for divisor in below.filter(|divisor| divisor.as_constant().is_none()) {
                    if !self.divisors.contains(&divisor) {
                        self.divisors.push(divisor);
                    }
                }
                self.give((symbol, value), zero);
                self.keep_positions()
            }
            None => {
                Err("this hypothesis is linear in none of its letters, so that none is given by the others".to_owned())
            }
        }
    }

    /// Solves the constraints of positions again, after a hypothesis has determined a letter for which they were solved.
    fn keep_positions(&mut self) -> Result<(), String> {
        self.hypotheses = Hypotheses::none();
        self.squares.clear();
        self.turn_freely();
        for zero in self.positions.clone() {
            let left = self.reduced(zero);
            if left.as_constant().is_some_and(|value| value.sign() != Some(0)) {
                return Err("this hypothesis contradicts the constraints, or makes them divide by zero".to_owned());
            }
            if !decide(left, &self.hypotheses).is_zero() && !self.solve_position(zero) {
                self.open.push("a constraint, which no letter solves beside the hypotheses".to_owned());
            }
        }
        Ok(())
    }

    /// Adds a round, a simultaneous replacement after all earlier ones. Each pair is a symbol and the expression that replaces it.
    pub fn set(&mut self, values: Vec<(Sym, Sym)>) {
        let by = values.iter().map(|&(symbol, value)| symbol - value).collect();
        self.rounds.push(Round { values, by: Some(by) });
    }

    /// A symbol in an expression that the motion does not determine: a reaction of a contact, or a condition.
    pub fn undetermined(&self, expression: Sym) -> Option<Sym> {
        let trace = self.trace;
        let known = [&trace.parameters, &trace.coordinates, &trace.speeds, &trace.accelerations];
        let inputs: Vec<Sym> = trace.model.inputs.iter().map(|input| Sym::symbol(&input.name)).collect();
        let is_known = |symbol: &Sym| {
            known.into_iter().any(|list| list.contains(symbol))
                || inputs.contains(symbol)
                || *symbol == trace.time
                || *symbol == trace.pi
        };
        expression.symbols_of().into_iter().find(|symbol| !is_known(symbol))
    }
}

/// A constraint between accelerations, as an expression that vanishes.
fn accelerated(trace: &Trace<'_>, one: &Equation) -> Sym {
    one.row.iter().zip(&trace.accelerations).fold(one.bias, |sum, (&slope, &rate)| sum + slope * rate)
}

/// The equations of motion with the reactions of constraints, then the constraints between accelerations, as expressions that vanish.
pub(crate) fn equations_of_motion(trace: &Trace<'_>) -> Vec<Sym> {
    let Equations { mass, bias, constraints } = Equations::of(trace);
    let of_row = |(k, row): (usize, &Vec<Sym>)| {
        let inertia = row.iter().zip(&trace.accelerations).fold(bias[k], |sum, (&entry, &rate)| sum + entry * rate);
        constraints.iter().fold(inertia, |sum, one| sum - one.row[k] * one.multiplier)
    };
    let rows = mass.iter().enumerate().map(of_row);
    rows.chain(constraints.iter().map(|one| accelerated(trace, one))).collect()
}

/// The value of a symbol in terms of the others.
pub(crate) struct Solution {
    pub symbol: Sym,
    pub value: Sym,
    /// The divisor in the value.
    pub divisor: Sym,
}

/// The solution of an equation for a symbol in which it is linear.
fn linear(zero: Sym, symbol: Sym) -> Option<Solution> {
    let terms = coefficients(zero, &[symbol]).ok()?;
    let of = |power: u32| terms.iter().find(|(exponents, _)| exponents[0] == power).map(|(_, value)| *value);
    let divisor = of(1).filter(|_| terms.iter().all(|(exponents, _)| exponents[0] <= 1))?;
    let vanishes = decide(divisor, &Hypotheses::none()).is_zero();
    (!vanishes).then(|| Solution { symbol, value: -of(0).unwrap_or(Sym::ZERO) / divisor, divisor })
}

/// The solution of an equation for a symbol in which it is linear: preferably for `first`, then for a symbol with a numerical factor, then for one with a
/// constant factor.
pub(crate) fn solution(trace: &Trace<'_>, zero: Sym, first: Option<Sym>) -> Option<Solution> {
    // a fraction vanishes where its numerator does
    let zero = normal(zero, &Hypotheses::none()).map_or(zero, |form| form.numerator());
    let by = |symbol: Sym| linear(zero, symbol);
    let is_letter = |symbol: &Sym| symbol.symbol_name().is_some() && !is_half_turn(*symbol);
    if let Some(found) = first.filter(is_letter).and_then(by) {
        return Some(found);
    }
    let moves = |divisor: Sym| {
        let symbols = divisor.symbols_of();
        trace.coordinates.iter().chain(&trace.speeds).any(|each| symbols.contains(each))
    };
    let mut all: Vec<Solution> = zero.symbols_of().into_iter().filter(is_letter).filter_map(by).collect();
    all.sort_by_key(|found| (moves(found.divisor), Sym::operations_of(&[found.divisor])));
    all.into_iter().next()
}
