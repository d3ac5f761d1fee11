//! A sum of multiples of quantities and of their products, with constant coefficients.

use num_traits::Zero;
use std::collections::BTreeMap;
use symbolic::Sym;

/// A quantity, as the index of its definition.
pub(super) type Atom = usize;

/// The form constant + sum c_i x_i + sum c_ij x_i x_j.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Form {
    pub constant: Coefficient,
    pub linear: BTreeMap<Atom, Coefficient>,
    pub products: BTreeMap<(Atom, Atom), Coefficient>,
}

/// An expression in the parameters; zero by default.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Coefficient(pub Sym);

impl Default for Coefficient {
    fn default() -> Self {
        Coefficient(Sym::ZERO)
    }
}

impl Coefficient {
    fn is_zero(self) -> bool {
        self.0.is_zero()
    }
}

fn add<K: Ord>(terms: &mut BTreeMap<K, Coefficient>, key: K, more: Sym) {
    let entry = terms.entry(key).or_default();
    entry.0 += more;
}

impl Form {
    pub fn constant(value: Sym) -> Self {
        Form { constant: Coefficient(value), ..Form::default() }
    }

    pub fn atom(atom: Atom) -> Self {
        let mut form = Form::default();
        form.add_atom(atom, Sym::ONE);
        form
    }

    pub fn add_atom(&mut self, atom: Atom, coefficient: Sym) {
        add(&mut self.linear, atom, coefficient);
    }

    pub fn add_product(&mut self, a: Atom, b: Atom, coefficient: Sym) {
        add(&mut self.products, (a.min(b), a.max(b)), coefficient);
    }

    /// The constant, for a form without quantities.
    pub fn as_constant(&self) -> Option<Sym> {
        (self.linear.is_empty() && self.products.is_empty()).then_some(self.constant.0)
    }

    /// The quantity, for a form that consists of one quantity.
    pub fn as_atom(&self) -> Option<Atom> {
        let alone = self.constant.is_zero() && self.products.is_empty() && self.linear.len() == 1;
        self.linear.iter().next().filter(|(_, c)| alone && c.0 == Sym::ONE).map(|(&atom, _)| atom)
    }

    /// The number of terms, including the constant one.
    pub fn terms(&self) -> usize {
        usize::from(!self.constant.is_zero()) + self.linear.len() + self.products.len()
    }

    /// The form self + factor * other.
    pub fn plus(mut self, other: &Form, factor: Sym) -> Self {
        self.constant.0 += factor * other.constant.0;
        for (&atom, c) in &other.linear {
            self.add_atom(atom, factor * c.0);
        }
        for (&(a, b), c) in &other.products {
            self.add_product(a, b, factor * c.0);
        }
        self.linear.retain(|_, c| !c.is_zero());
        self.products.retain(|_, c| !c.is_zero());
        self
    }

    pub fn times(&self, factor: Sym) -> Self {
        Form::default().plus(self, factor)
    }

    /// The expanded product of two sums without products.
    pub fn multiplied_out(&self, other: &Form) -> Self {
        let mut product = other.times(self.constant.0);
        for (&a, c) in &self.linear {
            if !other.constant.is_zero() {
                product.add_atom(a, c.0 * other.constant.0);
            }
            for (&b, d) in &other.linear {
                product.add_product(a, b, c.0 * d.0);
            }
        }
        product
    }
}
