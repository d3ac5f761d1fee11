//! Reduction of an expression graph to sums and products.

use super::collect::{Uses, common_factor, parts_of_one, whole_sums};
use super::form::{Atom, Form};
use super::plan::Plan;
use super::small::Law;
use super::{Equations, Recurrence, Reduced};
use rustc_hash::{FxHashMap, FxHashSet};
use symbolic::linear::Solve;
use symbolic::{Node, Sym, Tape, Untapeable};

/// The definition of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Definition {
    /// A quantity given by its rate: a state, time, a coordinate of a circle point, or an elementary function.
    State,
    /// A sum of a constant and multiples of quantities.
    Sum(Form),
    Product(Atom, Atom),
    /// The quotient of a quantity, or of one, by another.
    Quotient(Option<Atom>, Atom),
    Root(Atom),
    /// An unknown of the linear equations.
    Unknown,
}

/// Linear equations whose entries and right-hand sides are constants or quantities.
pub(super) struct Reduction<'a> {
    pub solve: &'a Solve,
    pub entries: Vec<Part>,
    pub right: Vec<Part>,
    /// The first unknown; the others follow.
    pub first: Atom,
}

/// An entry of linear equations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Part {
    /// A constant, as an expression.
    Fixed(Sym),
    Moving(Atom),
}

/// The sums and products under construction.
pub(super) struct Builder<'a> {
    pub equations: &'a Equations<'a>,
    pub definitions: Vec<Definition>,
    /// The rate of each state, as a sum.
    pub rates: Vec<Form>,
    pub forms: FxHashMap<Sym, Form>,
    /// The expressions that occur in a single larger expression only.
    parts: FxHashSet<Sym>,
    known_sums: FxHashMap<Vec<(Atom, Sym)>, Atom>,
    known: FxHashMap<(u8, Atom, Atom), Atom>,
    /// The circle points and elementary functions among the states, as expressions.
    pub points: Vec<Sym>,
    /// The cosines among the states; the sine of each follows it.
    pub circles: Vec<Atom>,
    pub reduction: Option<Reduction<'a>>,
    /// The largest number of terms to which a product of sums is expanded.
    multiplied_out: usize,
    /// The number of terms written by expansions so far.
    written: usize,
    /// The uses of products: counted in a first pass, read in a second.
    uses: Uses,
    gathers: bool,
}

/// The number of terms after which nothing is expanded any more, against unlimited growth of long sums.
const MOST_WRITTEN: usize = 20_000;

impl<'a> Builder<'a> {
    /// Builds twice: the first pass counts the uses of products.
    pub fn run(equations: &'a Equations<'a>, multiplied_out: usize) -> Result<Self, Untapeable> {
        let mut counting = Builder::new(equations, multiplied_out, Uses::default(), false);
        counting.build()?;
        let mut builder = Builder::new(equations, multiplied_out, counting.uses, true);
        builder.build()?;
        builder.merge_quotients();
        Ok(builder)
    }

    fn new(equations: &'a Equations<'a>, multiplied_out: usize, uses: Uses, gathers: bool) -> Self {
        let states = equations.state.len() + usize::from(equations.time.is_some());
        let mut forms = FxHashMap::default();
        for (atom, &symbol) in equations.state.iter().chain(&equations.time).enumerate() {
            forms.insert(symbol, Form::atom(atom));
        }
        for &parameter in equations.parameters {
            forms.insert(parameter, Form::constant(parameter));
        }
        Builder {
            equations,
            definitions: vec![Definition::State; states],
            rates: Vec::new(),
            forms,
            parts: FxHashSet::default(),
            known_sums: FxHashMap::default(),
            known: FxHashMap::default(),
            points: Vec::new(),
            circles: Vec::new(),
            reduction: None,
            multiplied_out,
            written: 0,
            uses,
            gathers,
        }
    }

    fn build(&mut self) -> Result<(), Untapeable> {
        let mut rates = self.equations.rates.to_vec();
        rates.extend(self.equations.time.map(|_| Sym::ONE));
        // circle points and elementary functions are states: their rates follow, and may introduce further ones
        let solved = self.equations.solve.map(Solve::expressions).unwrap_or_default();
        self.admit_points(&mut rates, &solved);
        if let Some(solve) = self.equations.solve {
            self.reduce(solve, &solved)?;
        }
        self.read(&rates)?;
        for rate in rates {
            let form = self.forms[&rate].clone();
            let form = self.resolved(form);
            self.rates.push(form);
        }
        Ok(())
    }

    /// The linear equations, whose unknowns are quantities from here on.
    fn reduce(&mut self, solve: &'a Solve, solved: &[Sym]) -> Result<(), Untapeable> {
        self.read(solved)?;
        let mut parts: Vec<Part> = Vec::with_capacity(solved.len());
        for expression in solved {
            let form = self.forms[expression].clone();
            parts.push(match form.as_constant() {
                Some(constant) => Part::Fixed(constant),
                None => Part::Moving(self.quantity(form)),
            });
        }
        let right = parts.split_off(solve.entries.len());
        let first = self.definitions.len();
        for (number, &unknown) in solve.unknowns.iter().enumerate() {
            self.definitions.push(Definition::Unknown);
            self.forms.insert(unknown, Form::atom(first + number));
        }
        self.reduction = Some(Reduction { solve, entries: parts, right, first });
        Ok(())
    }

    fn read(&mut self, rates: &[Sym]) -> Result<(), Untapeable> {
        let order = Sym::reached(rates, |each, _| !self.forms.contains_key(&each));
        let whole = whole_sums(&order, rates);
        self.parts = parts_of_one(&order, rates);
        for each in order {
            if !self.forms.contains_key(&each) {
                let form = self.form(each)?;
                let form = self.on_circles(form);
                let form = if self.gathers && whole.contains(&each) { self.gathered(form) } else { form };
                self.forms.insert(each, form);
            }
        }
        Ok(())
    }

    fn form(&mut self, each: Sym) -> Result<Form, Untapeable> {
        // an expression of constants is one coefficient; one whose parts only cancel to a constant is not
        let fixed = each.node().children().all(|child| self.forms[&child].as_constant() == Some(child));
        Ok(match each.node() {
            Node::Constant(_) if each == Sym::UNDEFINED => return Err(Untapeable::Undefined),
            Node::Symbol(_) => return Err(Untapeable::Unbound(each.to_string())),
            Node::Function(..) => return Err(Untapeable::Function(each.to_string())),
            _ if fixed => Form::constant(each),
            Node::Sum(a, b) => self.sum(a, b),
            Node::Difference(a, b) => self.taken(a).plus(&self.forms[&b], -Sym::ONE),
            Node::Negation(a) => self.forms[&a].times(-Sym::ONE),
            Node::Product(a, b) => self.product(self.forms[&a].clone(), self.forms[&b].clone()),
            Node::Power(a, n) => {
                let base = self.forms[&a].clone();
                let squared = |builder: &mut Self, form: Form| builder.product(form.clone(), form);
                (0..n.ilog2()).rev().fold(base.clone(), |power, bit| {
                    let power = squared(self, power);
                    if n >> bit & 1 == 1 { self.product(power, base.clone()) } else { power }
                })
            }
            Node::Quotient(a, b) => {
                let (above, below) = (self.forms[&a].clone(), self.forms[&b].clone());
                match below.as_constant() {
                    Some(constant) => above.times(Sym::ONE / constant),
                    None => {
                        let divisor = self.quantity(below);
                        let reciprocal = self.intern(1, divisor, divisor, Definition::Quotient(None, divisor));
                        self.product(above, Form::atom(reciprocal))
                    }
                }
            }
            Node::Root(a) => {
                let square = self.quantity(self.forms[&a].clone());
                Form::atom(self.intern(2, square, square, Definition::Root(square)))
            }
            // constants have no children; circle points and elementary functions that depend on the state are states
            // already
            Node::Constant(_) | Node::Cos(_) | Node::Sin(_) | Node::Elementary(..) => {
                return Err(Untapeable::Function(each.to_string()));
            }
        })
    }

    /// The sum of two forms. The shorter one is added to the longer one, so that the parts of long sums are added once.
    fn sum(&mut self, a: Sym, b: Sym) -> Form {
        let (long, short) = if self.forms[&a].terms() < self.forms[&b].terms() { (b, a) } else { (a, b) };
        self.taken(long).plus(&self.forms[&short], Sym::ONE)
    }

    /// The form of a part: itself if it has no other use, otherwise a copy.
    fn taken(&mut self, part: Sym) -> Form {
        let own = if self.parts.contains(&part) { self.forms.remove(&part) } else { None };
        own.unwrap_or_else(|| self.forms[&part].clone())
    }

    fn product(&mut self, a: Form, b: Form) -> Form {
        if let Some(factor) = a.as_constant() {
            return b.times(factor);
        }
        if let Some(factor) = b.as_constant() {
            return a.times(factor);
        }
        let (a, b) = (self.resolved(a), self.resolved(b));
        let terms = a.terms() * b.terms();
        let is_short = terms <= self.multiplied_out || a.terms().min(b.terms()) == 1 && self.multiplied_out > 1;
        if is_short && self.written + terms <= MOST_WRITTEN {
            self.written += terms;
            let product = a.multiplied_out(&b);
            if !self.gathers {
                product.products.keys().for_each(|&pair| *self.uses.entry(pair).or_default() += 1);
            }
            return product;
        }
        let (a, b) = (self.quantity(a), self.quantity(b));
        Form::atom(self.product_of(a, b))
    }

    fn product_of(&mut self, a: Atom, b: Atom) -> Atom {
        let (a, b) = (a.min(b), a.max(b));
        self.intern(0, a, b, Definition::Product(a, b))
    }

    /// The form with each product as a quantity.
    fn resolved(&mut self, mut form: Form) -> Form {
        for ((a, b), c) in std::mem::take(&mut form.products) {
            let product = self.product_of(a, b);
            form.add_atom(product, c.0);
        }
        form
    }

    /// The form with products collected by common factors.
    fn gathered(&mut self, mut form: Form) -> Form {
        while let Some((factor, sum)) = common_factor(&form, &self.uses) {
            form.products.retain(|&(a, b), _| {
                let partner = if a == factor { b } else { a };
                !((a == factor || b == factor) && sum.linear.contains_key(&partner))
            });
            let sum = self.quantity(sum);
            let product = self.product_of(factor, sum);
            form.add_atom(product, Sym::ONE);
        }
        form
    }

    /// The form as one quantity.
    fn quantity(&mut self, form: Form) -> Atom {
        let form = self.resolved(form);
        if let Some(atom) = form.as_atom() {
            return atom;
        }
        let mut key: Vec<(Atom, Sym)> = form.linear.iter().map(|(&atom, c)| (atom, c.0)).collect();
        key.push((Atom::MAX, form.constant.0));
        let next = self.definitions.len();
        let atom = *self.known_sums.entry(key).or_insert(next);
        if atom == next {
            self.definitions.push(Definition::Sum(form));
        }
        atom
    }

    fn intern(&mut self, kind: u8, a: Atom, b: Atom, definition: Definition) -> Atom {
        let next = self.definitions.len();
        let atom = *self.known.entry((kind, a, b)).or_insert(next);
        if atom == next {
            self.definitions.push(definition);
        }
        atom
    }

    /// The approximate number of operations of a series of typical order.
    pub fn cost(&self) -> usize {
        let of = |definition: &Definition| match definition {
            Definition::State => 0,
            Definition::Sum(form) => 4 + form.terms(),
            Definition::Product(..) => 8,
            Definition::Quotient(..) | Definition::Root(_) => 24,
            // its cost does not depend on the reduction
            Definition::Unknown => 0,
        };
        let used = self.used();
        let definitions = self.definitions.iter().zip(&used).filter(|(_, used)| **used).map(|(each, _)| of(each));
        definitions.sum::<usize>() + self.rates.iter().map(Form::terms).sum::<usize>()
    }

    /// Whether a rate depends on each quantity.
    pub fn used(&self) -> Vec<bool> {
        let mut used = vec![false; self.definitions.len()];
        self.rates.iter().flat_map(|rate| rate.linear.keys()).for_each(|&atom| used[atom] = true);
        if let Some(Reduction { entries, right, .. }) = &self.reduction {
            let moving = entries.iter().chain(right).filter_map(|part| match part {
                Part::Moving(atom) => Some(*atom),
                Part::Fixed(_) => None,
            });
            moving.for_each(|atom| used[atom] = true);
        }
        for atom in (0..self.definitions.len()).rev() {
            match &self.definitions[atom] {
                Definition::State | Definition::Unknown => used[atom] = true,
                _ if !used[atom] => {}
                Definition::Sum(form) => form.linear.keys().for_each(|&part| used[part] = true),
                Definition::Product(a, b) => (used[*a], used[*b]) = (true, true),
                Definition::Quotient(above, below) => above.iter().chain([below]).for_each(|&part| used[part] = true),
                Definition::Root(a) => used[*a] = true,
            }
        }
        used
    }

    /// The recurrence, with the tapes for its coefficients and circle points.
    pub fn finish(self) -> Result<Recurrence, Untapeable> {
        let (plan, coefficients) = Plan::new(&self);
        let Equations { state, time, parameters, .. } = *self.equations;
        let inputs: Vec<Sym> = state.iter().chain(&time).chain(parameters).copied().collect();
        let small = Law::of(&self).map(|(law, coefficients)| -> Result<Reduced, Untapeable> {
            Ok(Reduced { law, coefficients: Tape::record(parameters, &coefficients)? })
        });
        Ok(Recurrence {
            plan,
            coefficients: Tape::record(parameters, &coefficients)?,
            points: Tape::record(&inputs, &self.points)?,
            small: small.transpose()?,
        })
    }

    pub fn states(&self) -> usize {
        self.equations.state.len()
    }

    pub fn has_time(&self) -> bool {
        self.equations.time.is_some()
    }
}
