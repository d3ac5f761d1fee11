//! The syntax tree of a formula.

use field::Rational;
use std::ops::Range;

/// A statement: one chain of sides, or several chains that are stated to be equivalent (`\iff`).
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    pub chains: Vec<Chain>,
}

/// Sides with a relation between each two neighbours, such as `a = b < c`. A single side has no relation.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    pub sides: Vec<Term>,
    /// The relations, one fewer than sides.
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
    /// Returns the sign of the relation as plain text.
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

    /// Returns the sign of the relation in LaTeX.
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

/// A node of the syntax tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// The range of bytes in the formula.
    pub span: Range<usize>,
    pub form: Form,
}

/// The kind of a node.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    Number(Rational),
    /// A letter, by its normalised name: see [`crate::letter_name`].
    Letter(String),
    /// The time derivative along the motion, of the given order.
    Rate(Box<Term>, u32),
    /// The partial derivative of the first term with respect to the second.
    Partial(Box<Term>, Box<Term>),
    Negation(Box<Term>),
    Sum(Box<Term>, Box<Term>),
    Difference(Box<Term>, Box<Term>),
    /// A product written without a sign.
    Product(Box<Term>, Box<Term>),
    /// A product with `\cdot`: the scalar product if both factors are vectors.
    Dot(Box<Term>, Box<Term>),
    /// A product with `\times`: the vector product if both factors are vectors.
    Cross(Box<Term>, Box<Term>),
    Quotient(Box<Term>, Box<Term>),
    Power(Box<Term>, i32),
    Root(Box<Term>),
    Function(Function, Box<Term>),
    Transposed(Box<Term>),
    /// The rows of a matrix.
    Matrix(Vec<Vec<Term>>),
}

/// A function with a command of its own in LaTeX.
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
