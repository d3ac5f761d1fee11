//! Right-hand sides of second degree: y' = c + L y + sum_p w_p a_p b_p, where every factor is one of few moving quantities.

use crate::Sym;
use crate::recurrence::build::{Builder, Definition};
use crate::recurrence::form::Form;
use crate::recurrence::plan::Coefficients;

/// So many quantities, and so many products of them, still count as few.
const MOST_MOVING: usize = 16;
const MOST_PRODUCTS: usize = 24;

/// A right-hand side of second degree. The moving quantities are the states, time, circle points, and the sums of these that
/// are factors: a sum moves as its parts do, and then no order waits for it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::recurrence) struct SecondDegree {
    pub moving: usize,
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

/// What an atom of the builder has become.
#[derive(Clone, Copy)]
enum Role {
    Unused,
    Moving(usize),
    Product(usize),
}

impl SecondDegree {
    /// With the expressions of its coefficients, and of what moves beside the states; `None` where the right-hand side is of
    /// another kind or has too many quantities.
    pub fn of(builder: &Builder<'_>) -> Option<(Self, Vec<Sym>, Vec<Sym>)> {
        let used = builder.used();
        let (mut rows, mut points) = (builder.rates.clone(), builder.points.clone());
        let symbols = builder.equations.state.iter().chain(&builder.equations.time).chain(&builder.points);
        let symbols: Vec<Sym> = symbols.copied().collect();
        let mut roles: Vec<Role> = (0..symbols.len()).map(Role::Moving).collect();
        let mut products = Vec::new();
        for (definition, used) in builder.definitions.iter().zip(used).skip(symbols.len()) {
            roles.push(match definition {
                _ if !used => Role::Unused,
                Definition::Sum(form) => {
                    let parts = || form.linear.iter().map(|(&part, c)| Some((*symbols.get(part)?, part, c.0)));
                    let parts: Vec<(Sym, usize, Sym)> = parts().collect::<Option<_>>()?;
                    points.push(parts.iter().fold(form.constant.0, |sum, &(symbol, _, c)| sum + symbol * c));
                    let rate = |sum: Form, &(_, part, c): &(Sym, usize, Sym)| sum.plus(&builder.rates[part], c);
                    rows.push(parts.iter().fold(Form::default(), rate));
                    Role::Moving(rows.len() - 1)
                }
                Definition::Product(a, b) => {
                    let (Role::Moving(a), Role::Moving(b)) = (roles[*a], roles[*b]) else { return None };
                    products.push([a, b]);
                    Role::Product(products.len() - 1)
                }
                Definition::State | Definition::Reciprocal(_) | Definition::Root(_) => return None,
            });
        }
        if rows.len() > MOST_MOVING || products.len() > MOST_PRODUCTS || products.is_empty() {
            return None;
        }
        let mut coefficients = Coefficients::default();
        let mut degree = SecondDegree { moving: rows.len(), products, ..SecondDegree::default() };
        for (row, form) in rows.iter().enumerate() {
            if form.constant.0 != Sym::ZERO {
                degree.constants.push((row, coefficients.number(form.constant.0)));
            }
            for (&atom, c) in &form.linear {
                let coefficient = coefficients.number(c.0);
                match roles[atom] {
                    Role::Moving(quantity) => degree.linear.push((row, quantity, coefficient)),
                    Role::Product(product) => degree.quadratic.push((row, product, coefficient)),
                    Role::Unused => return None,
                }
            }
        }
        degree.coefficients = coefficients.all.len();
        Some((degree, coefficients.all, points))
    }
}
