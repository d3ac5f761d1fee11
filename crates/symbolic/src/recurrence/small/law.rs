//! Right-hand sides of few quantities, as sums of these and of products of two of them.

use crate::Sym;
use crate::recurrence::build::{Builder, Definition};
use crate::recurrence::form::{Atom, Form};
use crate::recurrence::plan::Coefficients;

/// So many quantities, and so many products of them, still count as few.
const MOST_QUANTITIES: usize = 24;
const MOST_PRODUCTS: usize = 24;

/// A right-hand side of few quantities. Those that move are the states, time, circle points, and the sums of these that
/// are factors: a sum moves as its parts do, and then no order waits for it. After them come those that are solved for.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::recurrence) struct Law {
    pub moving: usize,
    pub solved: Vec<Solved>,
    /// The factors of each product.
    pub products: Vec<[usize; 2]>,
    /// row, coefficient
    pub constants: Vec<(usize, u32)>,
    /// row, quantity, coefficient
    pub linear: Vec<(usize, usize, u32)>,
    /// row, product, coefficient
    pub quadratic: Vec<(usize, usize, u32)>,
    pub coefficients: usize,
}

/// A quantity without a rate, by quantities before it.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::recurrence) enum Solved {
    /// constant + sum c x + sum c a b; coefficients by number, quantities and products with theirs.
    Sum { constant: Option<u32>, linear: Vec<(usize, u32)>, products: Vec<(usize, u32)> },
    /// r of = 1, which is a product with its number.
    Reciprocal { of: usize, product: usize },
    /// r r = of, not negative.
    Root { of: usize, product: usize },
}

/// The coefficients of a sum by number: of its constant, of quantities, of products.
type Terms = (Option<u32>, Vec<(usize, u32)>, Vec<(usize, u32)>);

/// What an atom of the builder has become.
#[derive(Clone, Copy)]
enum Role {
    Unused,
    Moving(usize),
    /// In order of solving.
    Solved(usize),
    Product(usize),
}

/// The law in the making: what is solved for has its final number only when all that moves is known.
#[derive(Default)]
struct Making {
    roles: Vec<Role>,
    solved: Vec<Solved>,
    products: Vec<[Role; 2]>,
    coefficients: Coefficients,
}

impl Making {
    /// A quantity that can be a factor; a product becomes one that is solved for.
    fn factor(&mut self, atom: Atom) -> Role {
        if let Role::Product(product) = self.roles[atom] {
            let one = self.coefficients.number(Sym::ONE);
            self.solved.push(Solved::Sum { constant: None, linear: Vec::new(), products: vec![(product, one)] });
            return Role::Solved(self.solved.len() - 1);
        }
        self.roles[atom]
    }
}

impl Law {
    /// With the expressions of its coefficients, and of what moves beside the states; `None` where there are too many
    /// quantities.
    pub fn of(builder: &Builder<'_>) -> Option<(Self, Vec<Sym>, Vec<Sym>)> {
        let used = builder.used();
        let (mut rows, mut points) = (builder.rates.clone(), builder.points.clone());
        let symbols = builder.equations.state.iter().chain(&builder.equations.time).chain(&builder.points);
        let symbols: Vec<Sym> = symbols.copied().collect();
        let mut making = Making { roles: (0..symbols.len()).map(Role::Moving).collect(), ..Making::default() };
        // which atoms a sum that is solved for is made of: their numbers come last
        let mut sums: Vec<(usize, &Form)> = Vec::new();
        for (definition, used) in builder.definitions.iter().zip(used).skip(symbols.len()) {
            let role = match definition {
                _ if !used => Role::Unused,
                Definition::State => return None,
                Definition::Sum(form) if form.linear.keys().all(|part| *part < symbols.len()) => {
                    let parts = || form.linear.iter().map(|(&part, c)| (part, c.0));
                    points.push(parts().fold(form.constant.0, |sum, (part, c)| sum + symbols[part] * c));
                    rows.push(parts().fold(Form::default(), |sum, (part, c)| sum.plus(&builder.rates[part], c)));
                    Role::Moving(rows.len() - 1)
                }
                Definition::Sum(form) => {
                    sums.push((making.solved.len(), form));
                    making.solved.push(Solved::Sum { constant: None, linear: Vec::new(), products: Vec::new() });
                    Role::Solved(making.solved.len() - 1)
                }
                Definition::Product(a, b) => {
                    let factors = [making.factor(*a), making.factor(*b)];
                    making.products.push(factors);
                    Role::Product(making.products.len() - 1)
                }
                Definition::Reciprocal(of) | Definition::Root(of) => {
                    let (of, number) = (making.factor(*of), making.solved.len());
                    let product = making.products.len();
                    let reciprocal = matches!(definition, Definition::Reciprocal(_));
                    making.products.push([Role::Solved(number), if reciprocal { of } else { Role::Solved(number) }]);
                    // of whom: put in below, where its number is known
                    let of = match of {
                        Role::Moving(number) => number,
                        Role::Solved(number) => MOST_QUANTITIES + number,
                        _ => return None,
                    };
                    making.solved.push(match reciprocal {
                        true => Solved::Reciprocal { of, product },
                        false => Solved::Root { of, product },
                    });
                    Role::Solved(number)
                }
            };
            making.roles.push(role);
        }
        let moving = rows.len();
        if moving + making.solved.len() > MOST_QUANTITIES || making.products.len() > MOST_PRODUCTS {
            return None;
        }
        if making.products.is_empty() {
            return None;
        }
        let Making { roles, mut solved, products, mut coefficients } = making;
        let quantity = |role: Role| match role {
            Role::Moving(number) => Some(number),
            Role::Solved(number) => Some(moving + number),
            Role::Unused | Role::Product(_) => None,
        };
        let both = |[a, b]: [Role; 2]| Some([quantity(a)?, quantity(b)?]);
        let mut law =
            Law { moving, products: products.into_iter().map(both).collect::<Option<_>>()?, ..Law::default() };
        let mut terms = |form: &Form| -> Option<Terms> {
            let constant = (form.constant.0 != Sym::ZERO).then(|| coefficients.number(form.constant.0));
            let (mut linear, mut products) = (Vec::new(), Vec::new());
            for (&atom, c) in &form.linear {
                let number = coefficients.number(c.0);
                match roles[atom] {
                    Role::Product(product) => products.push((product, number)),
                    role => linear.push((quantity(role)?, number)),
                }
            }
            Some((constant, linear, products))
        };
        for (row, form) in rows.iter().enumerate() {
            let (constant, linear, products) = terms(form)?;
            law.constants.extend(constant.map(|number| (row, number)));
            law.linear.extend(linear.into_iter().map(|(quantity, number)| (row, quantity, number)));
            law.quadratic.extend(products.into_iter().map(|(product, number)| (row, product, number)));
        }
        for (number, form) in sums {
            let (constant, linear, products) = terms(form)?;
            solved[number] = Solved::Sum { constant, linear, products };
        }
        for each in &mut solved {
            if let Solved::Reciprocal { of, .. } | Solved::Root { of, .. } = each
                && *of >= MOST_QUANTITIES
            {
                *of = *of - MOST_QUANTITIES + moving;
            }
        }
        law.solved = solved;
        law.coefficients = coefficients.all.len();
        Some((law, coefficients.all, points))
    }

    /// How many quantities there are.
    pub fn quantities(&self) -> usize {
        self.moving + self.solved.len()
    }
}
