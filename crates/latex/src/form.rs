//! A formula as it was read: every part with its place.

use field::Rational;
use std::ops::Range;

/// The statement of a formula: chains of sides, of which each is equivalent to the next.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    pub chains: Vec<Chain>,
}

/// Sides with the relations between neighbours; one side alone has none.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    pub sides: Vec<Term>,
    pub relations: Vec<Relation>,
}

/// A relation between two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    Equal,
    NotEqual,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
}

impl Relation {
    /// The sign as text.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Equal => "=",
            Self::NotEqual => "!=",
            Self::Less => "<",
            Self::LessOrEqual => "<=",
            Self::Greater => ">",
            Self::GreaterOrEqual => ">=",
        }
    }

    /// In LaTeX.
    pub fn latex(self) -> &'static str {
        match self {
            Self::Equal => "=",
            Self::NotEqual => r"\neq",
            Self::Less => "<",
            Self::LessOrEqual => r"\leq",
            Self::Greater => ">",
            Self::GreaterOrEqual => r"\geq",
        }
    }
}

/// A part of a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Bytes of the formula.
    pub span: Range<usize>,
    pub form: Form,
}

/// The kind of a part.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    Number(Rational),
    /// A letter, by its name in one spelling: see [`crate::letter_name`].
    Letter(String),
    /// The rate along the motion, of this order.
    Rate(Box<Term>, u32),
    /// The partial derivative of the first by the second.
    Partial(Box<Term>, Box<Term>),
    Negation(Box<Term>),
    Sum(Box<Term>, Box<Term>),
    Difference(Box<Term>, Box<Term>),
    /// Side by side, or with a dot.
    Product(Box<Term>, Box<Term>),
    /// With `\cdot`: of two vectors the scalar product.
    Dot(Box<Term>, Box<Term>),
    /// With `\times`: of two vectors the vector product.
    Cross(Box<Term>, Box<Term>),
    Quotient(Box<Term>, Box<Term>),
    Power(Box<Term>, i32),
    Root(Box<Term>),
    Function(Function, Box<Term>),
    Transposed(Box<Term>),
    /// Row after row.
    Matrix(Vec<Vec<Term>>),
}

/// A function that has a command of LaTeX.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Cot,
    Sec,
    Csc,
    Exp,
    Ln,
    Sinh,
    Cosh,
    Tanh,
}

impl Function {
    pub(crate) const ALL: [(&'static str, Function); 11] = [
        ("sin", Function::Sin),
        ("cos", Function::Cos),
        ("tan", Function::Tan),
        ("cot", Function::Cot),
        ("sec", Function::Sec),
        ("csc", Function::Csc),
        ("exp", Function::Exp),
        ("ln", Function::Ln),
        ("sinh", Function::Sinh),
        ("cosh", Function::Cosh),
        ("tanh", Function::Tanh),
    ];

    pub(crate) fn of_command(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, function)| function)
    }
}
