//! The equations of a model with constraints before any elimination, as C code for solvers of differential-algebraic
//! equations.
//!
//! Let q be the coordinates, u the speeds, lambda the multipliers, J the rows of all constraints, and J_g those of the
//! position constraints:
//!
//!   index 1   q' - T u,               M u' + h - J^T lambda,   J u' + c
//!   index 2   q' - T u - J_g^T mu,    M u' + h - J^T lambda,   rates of all constraints,   constraints of positions
//!
//! The second form is that of Gear, Gupta and Leimkuhler. The inputs are the unknowns y, the time and y'; `slopes`
//! returns the nonzero entries of dF/dy and dF/dy'.

use field::{Over, Rational};
use model::equations::{Equations, Level};
use model::{Model, Trace};
use std::fmt::Write;
use symbolic::{Language, Sym, Tape, Untapeable, substitute_all};

/// The header `dae.h`; `None` for a model without constraints, or with switches or contacts.
pub fn header(model: &Model) -> Option<String> {
    if model.constraints.is_empty() || !model.switches.is_empty() || !model.contacts.is_empty() {
        return None;
    }
    symbolic::apart(|| {
        let trace = Trace::of(model);
        let equations = Equations::of(&trace);
        // a square system: the rates of coordinates describe freely rotating frames too
        let index1 = Residual::index1(&trace, &equations);
        let mut text = format!("#define NQ {}\n#define NU {}\n", trace.coordinates.len(), trace.speeds.len());
        text += &index1.source(&trace, "index1").ok()?;
        if equations.constraints.iter().all(|constraint| constraint.gains.is_none()) {
            text += &Residual::index2(&trace, &equations).source(&trace, "index2").ok()?;
        }
        Some(text)
    })
}

/// The function F(y, t, y').
struct Residual {
    unknowns: Vec<Sym>,
    rates: Vec<Sym>,
    is: Vec<Sym>,
}

impl Residual {
    fn index1(trace: &Trace<'_>, equations: &Equations) -> Self {
        let led = equations.constraints.iter().map(|one| product(&one.row, &trace.accelerations) + one.bias);
        let kinematics = moved(trace, &vec![Sym::ZERO; trace.coordinates.len()]);
        Residual::of(
            trace,
            equations,
            &[],
            kinematics.into_iter().chain(balance(trace, equations)).chain(led).collect(),
        )
    }

    fn index2(trace: &Trace<'_>, equations: &Equations) -> Self {
        let of_positions: Vec<_> = equations.constraints.iter().filter(|one| one.level == Level::Position).collect();
        let pushes: Vec<Sym> = (0..of_positions.len()).map(|k| Sym::symbol(&format!("mu {k}"))).collect();
        let pushed = |place: usize| {
            let slopes = of_positions.iter().zip(&pushes);
            slopes.fold(Sym::ZERO, |sum, (one, &mu)| sum + one.zero.diff(trace.coordinates[place]) * mu)
        };
        let pushed: Vec<Sym> = (0..trace.coordinates.len()).map(pushed).collect();
        let levels = equations.constraints.iter().map(|one| one.rate).chain(of_positions.iter().map(|one| one.zero));
        let is = moved(trace, &pushed).into_iter().chain(balance(trace, equations)).chain(levels).collect();
        Residual::of(trace, equations, &pushes, is)
    }

    fn of(trace: &Trace<'_>, equations: &Equations, pushes: &[Sym], is: Vec<Sym>) -> Self {
        let multipliers: Vec<Sym> =
            equations.constraints.iter().map(|one| one.multiplier).chain(pushes.to_vec()).collect();
        let rest = (0..multipliers.len()).map(|k| Sym::symbol(&format!("rate of multiplier {k}")));
        let rates = coordinate_rates(trace).into_iter().chain(trace.accelerations.clone()).chain(rest).collect();
        let unknowns = [&trace.coordinates[..], &trace.speeds, &multipliers].concat();
        Residual { unknowns, rates, is }
    }

    /// The C code of the function and its derivatives, with the values of the parameters.
    fn source(&self, trace: &Trace<'_>, name: &str) -> Result<String, Untapeable> {
        let inputs: Vec<Sym> = [&self.unknowns[..], &[trace.time], &self.rates].concat();
        let is = substitute_all(&self.is, &values(trace));
        let (mut places, mut slopes) = (Vec::new(), Vec::new());
        let n = self.unknowns.len();
        for (row, equation) in is.iter().enumerate() {
            for (column, &by) in self.unknowns.iter().chain(&self.rates).enumerate() {
                let slope = equation.diff(by);
                if slope != Sym::ZERO {
                    places.push((row, column));
                    slopes.push(slope);
                }
            }
        }
        let (residual, slopes) = (Tape::record(&inputs, &is)?, Tape::record(&inputs, &slopes)?);
        let mut text = String::new();
        let _ = writeln!(text, "enum {{ {name}_n = {n}, {name}_entries = {} }};", places.len());
        let list = |part: &dyn Fn(&(usize, usize)) -> usize| {
            places.iter().map(|place| part(place).to_string()).collect::<Vec<_>>().join(", ")
        };
        let _ = writeln!(text, "static const int {name}_rows[] = {{{}}};", list(&|place| place.0));
        let _ = writeln!(text, "static const int {name}_columns[] = {{{}}};", list(&|place| place.1));
        let sources = [(&residual, name.to_owned()), (&slopes, format!("{name}_slopes"))];
        sources.iter().for_each(|(tape, name)| text += &format!("{}\n", tape.source(Language::C, name)));
        let _ = writeln!(text, "#define HAS_{}", name.to_uppercase());
        Ok(text)
    }
}

fn product(row: &[Sym], column: &[Sym]) -> Sym {
    row.iter().zip(column).fold(Sym::ZERO, |sum, (&a, &b)| sum + a * b)
}

fn coordinate_rates(trace: &Trace<'_>) -> Vec<Sym> {
    (0..trace.coordinates.len()).map(|k| Sym::symbol(&format!("rate of coordinate {k}"))).collect()
}

/// The residual q' - T u minus the terms of the multipliers mu.
fn moved(trace: &Trace<'_>, pushed: &[Sym]) -> Vec<Sym> {
    let by_speeds = trace.position_rates.iter().zip(pushed);
    coordinate_rates(trace).into_iter().zip(by_speeds).map(|(rate, (&by, &push))| rate - by - push).collect()
}

/// The residual M u' + h - J^T lambda.
fn balance(trace: &Trace<'_>, equations: &Equations) -> Vec<Sym> {
    let inertia = equations.mass.iter().zip(&equations.bias).map(|(row, &h)| product(row, &trace.accelerations) + h);
    let reaction =
        |speed: usize| equations.constraints.iter().fold(Sym::ZERO, |sum, one| sum + one.row[speed] * one.multiplier);
    inertia.enumerate().map(|(speed, inertia)| inertia - reaction(speed)).collect()
}

fn values(trace: &Trace<'_>) -> Vec<(Sym, Sym)> {
    let given = trace.parameters.iter().zip(&trace.model.parameters);
    let given = given.filter_map(|(&letter, own)| Some((letter, Sym::lift(Rational::exactly(own.value?)))));
    given.chain([(trace.pi, Sym::lift(Rational::exactly(std::f64::consts::PI)))]).collect()
}
