//! A reader of LaTeX formulas over declared letters that refuses ambiguous formulas instead of guessing.
//!
//! # Overview
//! The crate is for programs that read the formulas of papers. The example reads a formula, and rejects a letter that is not declared.
//!
//! * [`letter_name`]: the normalised name of a letter, independent of braces and spaces;
//! * [`read`]: reads a formula into a [`Statement`], a syntax tree whose nodes know their positions; the error [`NotFormula`] of an ambiguous
//!   formula gives the accepted spellings;
//! * [`formulas`]: splits a display with several lines, or a formula with a double sign, into single formulas;
//! * [`value`]: evaluates a node of the tree with the values of the letters, which the trait [`Meaning`] supplies.
//!
//! | accepted | refused, since it has two readings |
//! |---|---|
//! | `\sin\theta\cos\theta`, `\sin(2\theta)`, `\cos^2\theta` | `\sin x y`, `\sin x^2`, `\sin^{-1} x` |
//! | `m(a + b)`, `2(a)`, `f\cdot(x)`; `f(q)`, `f'(q)` where `f(q)` is declared | `f(x)`, `f(x, y)` |
//! | `\frac12 m v^2`, `(1/2) m v^2`, `m/(2l)` | `1/2 m v^2`, `a/b/c` |
//! | `x^{10}`, `x_{12}` | `x^10`, `x_12` |
//!
//! ```
//! use dalembert_latex::{Form, letter_name, read};
//!
//! let known = ["m", r"\theta", "l_1"].map(letter_name);
//! let known = known.into_iter().collect::<Result<Vec<String>, _>>()?;
//! let statement = read(r"m l_1 \ddot{\theta} = 0", &known)?;
//! assert_eq!(statement.chains[0].sides.len(), 2);
//! assert!(read(r"m l_2 = 0", &known).is_err_and(|fault| fault.title.contains("l_{2}")));
//! assert!(matches!(read("m", &known)?.chains[0].sides[0].form, Form::Letter(_)));
//! # Ok::<(), dalembert_latex::NotFormula>(())
//! ```

mod display;
mod fault;
mod form;
mod name;
mod reader;
mod token;
mod value;

pub use display::{Displayed, formulas};
pub use fault::NotFormula;
pub use form::{Chain, Form, Function, Relation, Statement, Term};
pub use name::{declared_name, letter_name, plain_name};
pub use reader::read;
pub use value::{Meaning, NoValue, Value, value};
