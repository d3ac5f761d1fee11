//! Expressions of the language: numbers with units, names, vectors and points, functions.
//!
//! | | |
//! |---|---|
//! | sums, products | `+ - * /` from the left, `^` with a number or a fraction in parentheses, parentheses |
//! | numbers | `3`, `0.25`, `1e-4`; with a unit in parentheses: `(20 mm)` |
//! | names | letters of any script, digits, `_`; `theta'` and `theta''` are the rates of `theta` |
//! | members | `N.x`, an axis of a frame; `left.i`, a quantity of a drive |
//! | vectors | `a . b` with spaces, or `dot(a, b)`; `cross(a, b)`, `norm(a)`, `unit(a)`, `distance(P, Q)`; point minus point |
//! | motion | `velocity(P)`, `velocity(body at P)`, `velocity(P in B)`, `angular_velocity(B in N)`, `rate(e)`, `rate(v in B)` |
//! | piecewise | `if(t < (2 s), a, b)` with `<`, `>`, `<=`, `>=` |
//!
//! A product needs its sign `*`: `2x` and `a b` are errors, since a name may contain digits.

mod functions;
mod reader;
mod token;

pub(crate) use functions::usage;
pub use functions::{FUNCTIONS, NamedFunction};
pub use reader::read;
pub use token::is_name;

use std::fmt;
use std::ops::Range;

/// The index of a node in [`Expression::parts`].
pub type Part = usize;

/// The syntax tree of an expression. Operands precede the operations on them; the last node is the whole expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    /// The nodes of the tree, operands before operations; the last one is the whole expression.
    pub parts: Vec<Form>,
    /// For each node the range of bytes in the text from which it was read.
    pub spans: Vec<Range<usize>>,
}

impl Expression {
    /// Returns the node of the whole expression.
    pub fn whole(&self) -> Part {
        self.parts.len() - 1
    }
}

/// A node of the syntax tree.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A decimal number, in the spelling of the text.
    Number(String),
    /// A number with its unit, in the spelling of the text.
    Quantity {
        number: String,
        unit: String,
    },
    Name(String),
    /// A member of a named item: `N.x`.
    Member {
        of: String,
        name: String,
    },
    Negation(Part),
    Sum(Part, Part),
    Difference(Part, Part),
    Product(Part, Part),
    Quotient(Part, Part),
    /// The scalar product of two vectors.
    Dot(Part, Part),
    /// A power with a rational exponent.
    Power(Part, Exponent),
    Call {
        function: String,
        arguments: Vec<Argument>,
    },
    Comparison(Relation, Part, Part),
}

/// A rational exponent in lowest terms, with a positive denominator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Exponent {
    pub numerator: i32,
    pub denominator: i32,
}

/// An argument of a function: an expression, optionally with a preposition as in `disc at P` and `v in B`.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    /// The node of the expression.
    pub value: Part,
    /// The preposition, the name after it, and the range of bytes of the name.
    pub place: Option<(Preposition, String, Range<usize>)>,
}

/// The preposition of an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preposition {
    /// A point of a body: `disc at P`.
    At,
    /// A frame of reference: `P in B`.
    In,
}

/// A comparison of two scalars.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
}

/// The error of a text that is not an expression, with its position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotExpression {
    /// The range of bytes that cannot be read.
    pub span: Range<usize>,
    pub reason: Reason,
}

/// The kinds of errors in an expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The text ends, or an operator occurs, where an operand is required.
    Operand,
    /// Two operands have no operator between them.
    Operator,
    /// A name follows a number: a product without `*`, or a unit without parentheses.
    Beside { number: String, name: String },
    /// The text contains an equals sign.
    Equation,
    /// The text contains `**`.
    Stars,
    /// Comparisons are joined by `and` or `or`.
    Connective,
    /// A character that does not occur in expressions.
    Letter(char),
    /// A product sign other than `*`.
    Product,
    /// A point that belongs neither to a number, nor to a member such as `N.x`, nor to a scalar product.
    Dot,
    /// A parenthesis without its partner.
    Parenthesis,
    /// An exponent that is neither a number from -64 to 64 with at most three decimals, nor a fraction of two such numbers.
    Exponent,
    /// Parentheses nested more than `most` levels deep.
    Depth { most: usize },
    /// The text has more than `most` bytes.
    Long { most: usize },
    /// No name follows `at` or `in`.
    Preposition,
    /// An expression other than a name follows `at`.
    Place,
    /// `in` occurs outside of an argument.
    Seen,
    /// The name of a constraint contains spaces and is not quoted.
    Quotes,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Operand => write!(f, "a number, a name, a function or a parenthesis is expected here"),
            Self::Operator => {
                write!(
                    f,
                    "an operator is expected here; products are written with *, numbers with units in parentheses: (20 mm), functions too: sin(a)"
                )
            }
            Self::Beside { number, name } => write!(
                f,
                "`{number}*{name}` is a product, `({number} {name})` a number with a unit, in parentheses of its own"
            ),
            Self::Equation => write!(f, "an expression has no equals sign: a equals b where `a - b` is zero"),
            Self::Stars => write!(f, "powers are written with ^"),
            Self::Connective => {
                write!(f, "one comparison stands in `if`; two are nested: if(a < b, if(c < d, x, y), y)")
            }
            Self::Letter(letter) => write!(f, "{letter:?} has no meaning here"),
            Self::Product => write!(
                f,
                "products are written with *, scalar products as `a . b` or dot(a, b), cross products as cross(a, b)"
            ),
            Self::Dot => write!(f, "a scalar product is written with a space on both sides: `a . b`"),
            Self::Parenthesis => write!(f, "this parenthesis is not closed"),
            Self::Exponent => {
                write!(f, "an exponent is a number from -64 to 64, x^2 or x^1.5, or a fraction in parentheses: x^(1/3)")
            }
            Self::Depth { most } => write!(f, "parentheses deeper than {most}"),
            Self::Long { most } => {
                write!(f, "an expression of more than {most} bytes; name parts of it under [definitions]")
            }
            Self::Place => {
                write!(
                    f,
                    "behind `at` stands the name of a point alone: K = \"G - r*N.z\" in [points], then velocity(ball at K)"
                )
            }
            Self::Seen => write!(f, "`in` and its frame stand within the parentheses: velocity(P in B), rate(v in B)"),
            Self::Quotes => write!(f, "a name with spaces stands in quotes: push = 'reaction(\"left wheel\")'"),
            Self::Preposition => write!(f, "a name is expected after `at` and `in`: velocity(disc at P)"),
        }
    }
}
