//! Evaluation of a formula with the values of its letters.

use crate::form::{Form, Function, Term};
use field::{Analytic, Elementary};
use std::ops::Range;
use symbolic::{Sym, substitute_all};

/// A scalar or a matrix; a vector is a matrix with one column.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Scalar(Sym),
    /// The entries by rows.
    Matrix(Vec<Vec<Sym>>),
}

/// The values of a formula's letters, and the operations that depend on the mechanical system: time derivatives and partial derivatives.
pub trait Meaning {
    /// Returns the value of a declared letter, given by its normalised name; `None` if the letter has no value.
    fn letter(&self, name: &str) -> Option<Value>;

    /// Returns the time derivative of an expression along the motion.
    ///
    /// # Errors
    /// The expression has no time derivative; the text gives the reason.
    fn rate(&self, of: Sym) -> Result<Sym, String>;

    /// Returns the partial derivative of an expression with respect to a letter or to the rate of a letter.
    ///
    /// # Errors
    /// The derivative is not defined; the text gives the reason.
    fn partial(&self, of: Sym, by: Sym) -> Result<Sym, String>;

    /// Returns cosine and sine of an angle in radians.
    fn circle(&self, angle: Sym) -> (Sym, Sym) {
        let point = angle.circle();
        (point.cos, point.sin)
    }
}

/// The reason why a part of a formula has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoValue {
    /// The range of bytes in the formula.
    pub span: Range<usize>,
    /// The reason as a sentence.
    pub why: String,
}

/// Returns the value of a node of the syntax tree.
///
/// # Errors
/// A letter has no value, a derivative is not defined, or the shapes of operands do not match. The error gives the range of the failing part.
pub fn value(term: &Term, meaning: &impl Meaning) -> Result<Value, NoValue> {
    let fault = |why: String| NoValue { span: term.span.clone(), why };
    let scalar = |part: &Term, what: &str| match value(part, meaning)? {
        Value::Scalar(scalar) => Ok(scalar),
        Value::Matrix(_) => Err(NoValue {
            span: part.span.clone(),
            why: format!("{what} is a vector or a matrix, and must be a scalar"),
        }),
    };
    let one = |part: &Term, of: &dyn Fn(Sym) -> Result<Sym, String>| match value(part, meaning)? {
        Value::Scalar(scalar) => of(scalar).map(Value::Scalar).map_err(fault),
        Value::Matrix(rows) => {
            let row = |row: Vec<Sym>| row.into_iter().map(of).collect::<Result<Vec<Sym>, String>>();
            rows.into_iter().map(row).collect::<Result<Vec<_>, _>>().map(Value::Matrix).map_err(fault)
        }
    };
    let two =
        |left: &Term, right: &Term, of: &dyn Fn(Sym, Sym) -> Sym| match (value(left, meaning)?, value(right, meaning)?)
        {
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(of(a, b))),
            (Value::Matrix(a), Value::Matrix(b)) if shape(&a) == shape(&b) => Ok(Value::Matrix(
                a.into_iter().zip(b).map(|(a, b)| a.into_iter().zip(b).map(|(a, b)| of(a, b)).collect()).collect(),
            )),
            (a, b) => Err(fault(format!("{} and {} cannot be added", told(&a), told(&b)))),
        };
    match &term.form {
        Form::Number(number) => Ok(Value::Scalar(Sym::constant(*number))),
        Form::Letter(name) => meaning.letter(name).ok_or_else(|| fault(format!("`{name}` has no meaning"))),
        Form::Rate(of, order) => {
            let mut found = value(of, meaning)?;
            for _ in 0..*order {
                let rate = |scalar: Sym| meaning.rate(scalar).map_err(fault);
                found = match found {
                    Value::Scalar(scalar) => Value::Scalar(rate(scalar)?),
                    Value::Matrix(rows) => Value::Matrix(
                        rows.into_iter().map(|row| row.into_iter().map(rate).collect()).collect::<Result<_, _>>()?,
                    ),
                };
            }
            Ok(found)
        }
        Form::Partial(of, by) => {
            let by = scalar(by, "the letter of a partial derivative")?;
            one(of, &|of| meaning.partial(of, by))
        }
        Form::Negation(of) => one(of, &|of| Ok(-of)),
        Form::Sum(a, b) => two(a, b, &|a, b| a + b),
        Form::Difference(a, b) => two(a, b, &|a, b| a - b),
        Form::Product(a, b) => product(value(a, meaning)?, value(b, meaning)?).map_err(fault),
        Form::Dot(a, b) => match (value(a, meaning)?, value(b, meaning)?) {
            (Value::Matrix(a), Value::Matrix(b)) if is_vector(&a) && shape(&a) == shape(&b) => Ok(Value::Scalar(
                a.iter().zip(&b).map(|(a, b)| a[0] * b[0]).reduce(|sum, each| sum + each).unwrap_or(Sym::ZERO),
            )),
            (a, b) => product(a, b).map_err(fault),
        },
        Form::Cross(a, b) => match (value(a, meaning)?, value(b, meaning)?) {
            (Value::Matrix(a), Value::Matrix(b)) if shape(&a) == (3, 1) && shape(&b) == (3, 1) => {
                let of = |i: usize, j: usize| a[i][0] * b[j][0] - a[j][0] * b[i][0];
                Ok(Value::Matrix(vec![vec![of(1, 2)], vec![of(2, 0)], vec![of(0, 1)]]))
            }
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(a * b)),
            (a, b) => Err(fault(format!("{} and {} have no vector product", told(&a), told(&b)))),
        },
        Form::Quotient(above, below) => {
            let below = scalar(below, "a denominator")?;
            one(above, &|above| Ok(above / below))
        }
        Form::Power(of, exponent) => match value(of, meaning)? {
            Value::Scalar(base) if *exponent == 0 && base == Sym::ZERO => {
                Err(fault("zero to the power zero has no value".to_owned()))
            }
            Value::Scalar(base) => Ok(Value::Scalar(base.powi(*exponent))),
            Value::Matrix(rows) if is_vector(&rows) && *exponent == 2 => {
                Err(fault("the square of a vector is written as a scalar product".to_owned()))
            }
            matrix @ Value::Matrix(_) => Err(fault(format!("{} has no power here", told(&matrix)))),
        },
        Form::Root(of) => {
            let of = scalar(of, "a radicand")?;
            Ok(Value::Scalar(of.sqrt()))
        }
        Form::Function(function, argument) => {
            let argument = scalar(argument, "an argument")?;
            Ok(Value::Scalar(applied(*function, argument, meaning)))
        }
        Form::Transposed(of) => match value(of, meaning)? {
            Value::Matrix(rows) => {
                let (_, columns) = shape(&rows);
                Ok(Value::Matrix((0..columns).map(|j| rows.iter().map(|row| row[j]).collect()).collect()))
            }
            Value::Scalar(_) => Err(fault("a scalar is not transposed: is T an exponent here?".to_owned())),
        },
        Form::Matrix(rows) => {
            let row = |row: &Vec<Term>| {
                row.iter().map(|entry| scalar(entry, "an entry of a matrix")).collect::<Result<Vec<Sym>, _>>()
            };
            Ok(Value::Matrix(rows.iter().map(row).collect::<Result<_, _>>()?))
        }
    }
}

fn applied(function: Function, argument: Sym, meaning: &impl Meaning) -> Sym {
    let (cos, sin) = match function {
        Function::Sin | Function::Cos | Function::Tan | Function::Cot | Function::Sec | Function::Csc => {
            meaning.circle(argument)
        }
        _ => (Sym::ONE, Sym::ZERO),
    };
    let exp = |argument: Sym| argument.elementary(Elementary::Exp, argument);
    let half = Sym::ONE / (Sym::ONE + Sym::ONE);
    match function {
        Function::Sin => sin,
        Function::Cos => cos,
        Function::Tan => sin / cos,
        Function::Cot => cos / sin,
        Function::Sec => Sym::ONE / cos,
        Function::Csc => Sym::ONE / sin,
        Function::Exp => exp(argument),
        Function::Ln => argument.elementary(Elementary::Ln, argument),
        Function::Sinh => half * (exp(argument) - Sym::ONE / exp(argument)),
        Function::Cosh => half * (exp(argument) + Sym::ONE / exp(argument)),
        Function::Tanh => argument.elementary(Elementary::Tanh, argument),
    }
}

/// Returns the product of a scalar with any value, or of two matrices of matching shapes. A 1 x 1 result is a scalar.
fn product(left: Value, right: Value) -> Result<Value, String> {
    Ok(match (left, right) {
        (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(a * b),
        (Value::Scalar(a), Value::Matrix(rows)) => {
            Value::Matrix(rows.into_iter().map(|row| row.into_iter().map(|entry| a * entry).collect()).collect())
        }
        (Value::Matrix(rows), Value::Scalar(b)) => {
            Value::Matrix(rows.into_iter().map(|row| row.into_iter().map(|entry| entry * b).collect()).collect())
        }
        (Value::Matrix(a), Value::Matrix(b)) if shape(&a).1 == shape(&b).0 => {
            let entry = |row: &Vec<Sym>, j: usize| {
                row.iter().zip(&b).map(|(a, b)| *a * b[j]).reduce(|sum, each| sum + each).unwrap_or(Sym::ZERO)
            };
            let rows: Vec<Vec<Sym>> = a.iter().map(|row| (0..shape(&b).1).map(|j| entry(row, j)).collect()).collect();
            match shape(&rows) {
                (1, 1) => Value::Scalar(rows[0][0]),
                _ => Value::Matrix(rows),
            }
        }
        (a, b) => return Err(format!("{} and {} side by side have no product", told(&a), told(&b))),
    })
}

fn shape(rows: &[Vec<Sym>]) -> (usize, usize) {
    (rows.len(), rows.first().map_or(0, Vec::len))
}

fn is_vector(rows: &[Vec<Sym>]) -> bool {
    shape(rows).1 == 1
}

fn told(value: &Value) -> String {
    match value {
        Value::Scalar(_) => "a scalar".to_owned(),
        Value::Matrix(rows) => {
            let (rows, columns) = shape(rows);
            if columns == 1 {
                format!("a vector of {rows} components")
            } else {
                format!("a matrix of {rows} by {columns}")
            }
        }
    }
}

impl Value {
    /// Returns all entries by rows.
    pub fn entries(&self) -> Vec<Sym> {
        match self {
            Self::Scalar(scalar) => vec![*scalar],
            Self::Matrix(rows) => rows.concat(),
        }
    }

    /// Returns the value with letters replaced: each pair is (letter, replacement).
    #[must_use]
    pub fn substituted(&self, replacements: &[(Sym, Sym)]) -> Value {
        match self {
            Self::Scalar(scalar) => Self::Scalar(scalar.substitute(replacements)),
            Self::Matrix(rows) => Self::Matrix(rows.iter().map(|row| substitute_all(row, replacements)).collect()),
        }
    }
}
