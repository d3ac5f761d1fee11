//! Arithmetic operators of expressions. They simplify only constants, 0, 1, -1 and x - x.
//!
//! Denominators are assumed to differ from zero, as everywhere in the workbench: 0/x is 0 unless x is the constant 0. The normal form simplifies
//! further.

use crate::Sym;
use crate::graph::Node;
use field::Rational;
use num_traits::Zero;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

fn folded(a: Sym, b: Sym, operation: fn(Rational, Rational) -> Rational) -> Option<Sym> {
    if a == Sym::UNDEFINED || b == Sym::UNDEFINED {
        return Some(Sym::UNDEFINED);
    }
    Some(Sym::constant(operation(a.as_constant()?, b.as_constant()?)))
}

impl Add for Sym {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        if self.is_zero() {
            return b;
        }
        if b.is_zero() {
            return self;
        }
        folded(self, b, |a, b| a + b).unwrap_or_else(|| Sym::from_node(Node::Sum(self, b)))
    }
}

impl Sub for Sym {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        if b.is_zero() {
            return self;
        }
        if self.is_zero() {
            return -b;
        }
        if let Some(constant) = folded(self, b, |a, b| a - b) {
            return constant;
        }
        if self == b { Sym::ZERO } else { Sym::from_node(Node::Difference(self, b)) }
    }
}

impl Mul for Sym {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        if let Some(constant) = folded(self, b, |a, b| a * b) {
            return constant;
        }
        match (self, b) {
            (Sym::ZERO, _) | (_, Sym::ZERO) => Sym::ZERO,
            (Sym::ONE, x) | (x, Sym::ONE) => x,
            (Sym::MINUS_ONE, x) | (x, Sym::MINUS_ONE) => -x,
            _ => Sym::from_node(Node::Product(self, b)),
        }
    }
}

impl Div for Sym {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        if let Some(constant) = folded(self, b, |a, b| a / b) {
            return constant;
        }
        match (self, b) {
            (_, Sym::ZERO) => Sym::UNDEFINED,
            (Sym::ZERO, _) => Sym::ZERO,
            (_, Sym::ONE) => self,
            (_, Sym::MINUS_ONE) => -self,
            _ => Sym::from_node(Node::Quotient(self, b)),
        }
    }
}

/// The remainder of a division in a field is zero. nalgebra and num-traits require this operator.
impl Rem for Sym {
    type Output = Self;
    fn rem(self, b: Self) -> Self {
        if b.is_zero() || b == Sym::UNDEFINED || self == Sym::UNDEFINED { Sym::UNDEFINED } else { Sym::ZERO }
    }
}

impl Neg for Sym {
    type Output = Self;
    fn neg(self) -> Self {
        match self.node() {
            Node::Constant(_) => folded(Sym::ZERO, self, |a, b| a - b).unwrap_or(self),
            Node::Negation(inside) => inside,
            _ => Sym::from_node(Node::Negation(self)),
        }
    }
}

macro_rules! assign {
    ($($op:ident $method:ident $sign:tt),*) => {$(
        impl $op for Sym {
            fn $method(&mut self, b: Self) {
                *self = *self $sign b;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /, RemAssign rem_assign %);
