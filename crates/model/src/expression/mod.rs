//! Expressions as they are written: numbers with units, names, vectors and points, functions.
//!
//! | | |
//! |---|---|
//! | sums, products | `+ - * /` from the left, `^` with a whole number or a fraction in parentheses, parentheses |
//! | numbers | `3`, `0.25`, `1e-4`; with a unit in parentheses: `(20 mm)` |
//! | names | letters of any script, digits, `_`; `theta'` and `theta''` are the rates of `theta` |
//! | parts | `N.x`, an axis of a frame; `left.i`, an output of a drive |
//! | vectors | `a . b` with spaces, or `dot(a, b)`; `cross(a, b)`, `norm(a)`, `unit(a)`, `distance(P, Q)`; point minus point |
//! | motion | `velocity(P)`, `velocity(body at P)`, `velocity(P in B)`, `angular_velocity(B in N)`, `rate(e)`, `rate(v in B)` |
//! | choice | `if(t < (2 s), a, b)` with `<`, `>`, `<=`, `>=` |
//!
//! Two letters side by side are no product: `2x` and `a b` are refused, since a name may hold digits.

mod functions;
mod reader;
mod token;

pub(crate) use functions::usage;
pub use functions::{FUNCTIONS, NamedFunction};
pub use reader::read;
pub use token::is_name;

use std::fmt;
use std::ops::Range;

/// A part of an expression, by its place in the list of parts.
pub type Part = usize;

/// An expression as it was written: its parts, each after those that it is made of; the last one is the whole.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    pub parts: Vec<Form>,
    /// The bytes of each part.
    pub spans: Vec<Range<usize>>,
}

impl Expression {
    /// The part that is the whole expression.
    pub fn whole(&self) -> Part {
        self.parts.len() - 1
    }
}

/// A part of an expression, made of parts before it.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A decimal number, as written.
    Number(String),
    /// A number with its unit, as written.
    Quantity {
        number: String,
        unit: String,
    },
    Name(String),
    /// A part of something named: `N.x`.
    Member {
        of: String,
        name: String,
    },
    Negation(Part),
    Sum(Part, Part),
    Difference(Part, Part),
    Product(Part, Part),
    Quotient(Part, Part),
    /// The scalar product.
    Dot(Part, Part),
    /// A power with a rational exponent.
    Power(Part, Exponent),
    Call {
        function: String,
        arguments: Vec<Argument>,
    },
    Comparison(Relation, Part, Part),
}

/// An exponent: a fraction in lowest terms with a positive denominator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Exponent {
    pub numerator: i32,
    pub denominator: i32,
}

/// An argument of a function: `disc at P`, `v in B`, or an expression alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    pub value: Part,
    pub place: Option<(Preposition, String, Range<usize>)>,
}

/// The word between the two parts of an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preposition {
    /// The point of a body: `disc at P`.
    At,
    /// The frame from which a motion is seen: `P in B`.
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

/// The error of a text that is no expression, with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotExpression {
    /// The bytes of the text that cannot be read.
    pub span: Range<usize>,
    pub reason: Reason,
}

/// The fault of a text that is no expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The text ends, or another sign stands, where an operand must.
    Operand,
    /// Two operands without a sign between them.
    Operator,
    /// A number and a name side by side.
    Beside { number: String, name: String },
    /// Two sides of an equation.
    Equation,
    /// `**`
    Stars,
    /// `and` or `or` between comparisons.
    Connective,
    /// A letter that no expression has.
    Letter(char),
    /// A sign of a product that is not `*`.
    Product,
    /// A point that is neither of a decimal, nor of a part, nor a scalar product.
    Dot,
    /// A parenthesis without its partner.
    Parenthesis,
    /// An exponent that is no number from -64 to 64 with three decimals, and no fraction of two.
    Exponent,
    /// Parentheses deeper than so many.
    Depth { most: usize },
    /// A text of more bytes than so many.
    Long { most: usize },
    /// `at` or `in` without a name after it.
    Preposition,
    /// More than a name after `at`.
    Place,
    /// `in` outside of a relative motion.
    Seen,
    /// A constraint's name with spaces and without quotes.
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
            Self::Parenthesis => write!(f, "a parenthesis without its partner"),
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
