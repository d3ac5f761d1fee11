//! The order in which sums and products are computed.

use super::build::{Builder, Definition, Part, Reduction};
use super::form::Form;
use algebra::linear::Pattern;
use rustc_hash::FxHashMap;
use symbolic::Sym;

/// A quantity in the plan, by its place.
pub(super) type Slot = u32;

/// The operations of each order: the stages, then the rates.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Plan {
    /// The number of states. Their places come first, then time (if used), then the circle points.
    pub states: usize,
    pub time: bool,
    /// The number of places with a rate.
    pub moving: usize,
    pub stages: Vec<Stage>,
    /// The rates: row i is the rate of place i.
    pub rates: Sums,
    /// The number of coefficients in the sums.
    pub coefficients: usize,
}

/// A stage: sums of results of earlier stages, then products, which may use these sums.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Stage {
    pub sums: Sums,
    /// The place of each sum.
    pub sum_places: Vec<Slot>,
    pub products: Vec<Product>,
    pub quotients: Vec<Quotient>,
    pub roots: Vec<(Slot, Slot)>,
    pub linear: Option<LinearEquations>,
}

/// Linear equations, whose entries are quantities of earlier stages.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LinearEquations {
    pub pattern: Pattern,
    pub entries: Vec<Quantity>,
    pub right: Vec<Quantity>,
    pub unknowns: Vec<Slot>,
}

/// An entry of linear equations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Quantity {
    /// A constant: the index of a coefficient.
    Fixed(u32),
    Moving(Slot),
}

/// The product place = a b.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Product {
    pub place: Slot,
    pub a: Slot,
    pub b: Slot,
}

/// The quotient place = above / below; without a numerator the reciprocal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Quotient {
    pub place: Slot,
    pub above: Option<Slot>,
    pub below: Slot,
}

/// Sums, row by row: constants and multiples of places, with the indices of their coefficients.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Sums {
    pub rows: usize,
    pub constants: Vec<(u32, u32)>,
    /// The terms, as (row, place, index of the coefficient).
    pub terms: Vec<(u32, Slot, u32)>,
}

/// The distinct coefficients.
#[derive(Default)]
pub(super) struct Coefficients {
    pub all: Vec<Sym>,
    known: FxHashMap<Sym, u32>,
}

impl Coefficients {
    pub fn number(&mut self, coefficient: Sym) -> u32 {
        let next = self.all.len() as u32;
        let number = *self.known.entry(coefficient).or_insert(next);
        if number == next {
            self.all.push(coefficient);
        }
        number
    }
}

impl LinearEquations {
    fn of(reduction: &Reduction<'_>, coefficients: &mut Coefficients) -> Self {
        let Reduction { solve, entries, right, first } = reduction;
        let mut quantities = |parts: &[Part]| -> Vec<Quantity> {
            let quantity = |part: &Part| match *part {
                Part::Fixed(constant) => Quantity::Fixed(coefficients.number(constant)),
                Part::Moving(atom) => Quantity::Moving(atom as Slot),
            };
            parts.iter().map(quantity).collect()
        };
        LinearEquations {
            pattern: solve.pattern.clone(),
            entries: quantities(entries),
            right: quantities(right),
            unknowns: (0..solve.unknowns.len()).map(|number| (first + number) as Slot).collect(),
        }
    }
}

impl Stage {
    /// The places computed by the stage.
    pub fn places(&self) -> impl Iterator<Item = Slot> {
        let products = self.products.iter().map(|product| product.place);
        let quotients = self.quotients.iter().map(|quotient| quotient.place);
        let implicit = quotients.chain(self.roots.iter().map(|(place, _)| *place));
        let unknowns = self.linear.iter().flat_map(|linear| linear.unknowns.iter().copied());
        self.sum_places.iter().copied().chain(products).chain(implicit).chain(unknowns)
    }
}

impl Sums {
    fn push(&mut self, form: &Form, coefficients: &mut Coefficients) {
        let row = self.rows as u32;
        if form.constant.0 != Sym::ZERO {
            self.constants.push((row, coefficients.number(form.constant.0)));
        }
        let terms = form.linear.iter().map(|(&atom, c)| (row, atom as Slot, coefficients.number(c.0)));
        self.terms.extend(terms);
        self.rows += 1;
    }
}

impl Plan {
    /// The plan, and the expressions of its coefficients.
    pub fn new(builder: &Builder<'_>) -> (Plan, Vec<Sym>) {
        let mut coefficients = Coefficients::default();
        let mut stages: Vec<Stage> = Vec::new();
        // the stage before which a quantity is available
        let mut ready = vec![0usize; builder.definitions.len()];
        let used = builder.used();
        for (atom, definition) in builder.definitions.iter().enumerate().filter(|(atom, _)| used[*atom]) {
            let place = atom as Slot;
            let after = |atoms: &[usize]| atoms.iter().map(|&atom| ready[atom]).max().unwrap_or(0);
            let parts = |reduction: &Reduction<'_>| {
                let atoms = reduction.entries.iter().chain(&reduction.right).filter_map(|part| match part {
                    Part::Moving(atom) => Some(ready[*atom]),
                    Part::Fixed(_) => None,
                });
                atoms.max().unwrap_or(0)
            };
            let stage = match definition {
                Definition::State => continue,
                Definition::Sum(form) => form.linear.keys().map(|&part| ready[part]).max().unwrap_or(0),
                Definition::Product(a, b) => after(&[*a, *b]),
                Definition::Quotient(None, a) | Definition::Root(a) => after(&[*a]),
                Definition::Quotient(Some(a), b) => after(&[*a, *b]),
                Definition::Unknown => builder.reduction.as_ref().map_or(0, parts),
            };
            if stage >= stages.len() {
                stages.resize(stage + 1, Stage::default());
            }
            let here = &mut stages[stage];
            match definition {
                Definition::State => {}
                Definition::Sum(form) => {
                    here.sums.push(form, &mut coefficients);
                    here.sum_places.push(place);
                }
                Definition::Product(a, b) => {
                    here.products.push(Product { place, a: *a as Slot, b: *b as Slot });
                }
                Definition::Quotient(above, below) => {
                    let above = above.map(|above| above as Slot);
                    here.quotients.push(Quotient { place, above, below: *below as Slot });
                }
                Definition::Root(a) => here.roots.push((place, *a as Slot)),
                // the first unknown stands for all of them
                Definition::Unknown => {
                    let first = builder.reduction.as_ref().filter(|reduction| reduction.first == atom);
                    here.linear =
                        first.map(|reduction| LinearEquations::of(reduction, &mut coefficients)).or(here.linear.take());
                }
            }
            // a sum is available to the products of its own stage
            ready[atom] = if matches!(definition, Definition::Sum(_)) { stage } else { stage + 1 };
        }
        let mut rates = Sums::default();
        builder.rates.iter().for_each(|rate| rates.push(rate, &mut coefficients));
        let plan = Plan {
            states: builder.states(),
            time: builder.has_time(),
            moving: rates.rows,
            stages,
            rates,
            coefficients: coefficients.all.len(),
        };
        (plan, coefficients.all)
    }

    /// The number of products of two series.
    pub fn products(&self) -> usize {
        self.stages.iter().map(|stage| stage.products.len() + stage.quotients.len() + stage.roots.len()).sum()
    }

    /// The total number of terms of all sums.
    pub fn terms(&self) -> usize {
        self.stages.iter().map(|stage| &stage.sums).chain([&self.rates]).map(|sums| sums.terms.len()).sum()
    }
}
