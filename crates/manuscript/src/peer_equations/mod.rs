//! Comparison of equations of motion from another program with those of a model.
//!
//! The letters of the other program have meanings in the model. Its equations are equivalent to those of the model if four conditions hold: each of them
//! is satisfied by the model's accelerations, its constraints hold wherever the model's do, it determines all accelerations, and both have
//! equal numbers of degrees of freedom. The choice of its speeds, and of linear combinations of its equations, is arbitrary.

mod differences;
mod finding;
mod rates;
mod reading;

pub use differences::TermDifference;
pub use finding::{PeerEquation, PeerFinding};

use crate::equation::{Outcome, vanishes};
use crate::motion::Motion;
use crate::verdict::allowed;
use claims::Verdict;
use differences::Projected;
use finding::{Freedom, divisors, judged, untold, whole};
use model::equations::{Characteristics, constraints_of, generic_rank};
use model::{Entry, Text, Trace};
use rates::{PeerRates, without_multipliers};
use reader::SceneError;
use scenes::SystemText;
use symbolic::{Identity, Sym, identified};

/// Equations of motion of another program, as texts in the language of models, without units.
#[derive(Clone, Debug, Default)]
pub struct PeerEquations {
    /// Letters with their meanings in the model: coordinates, parameters, inputs. Primes denote rates of a letter.
    pub letters: Vec<(String, String)>,
    /// Speeds that are not rates of coordinates; the kinematic equations determine them.
    pub speeds: Vec<String>,
    /// The accelerations in the equations, `q''` or `u'`.
    pub accelerations: Vec<String>,
    /// The names of the multipliers of constraints in the equations.
    pub multipliers: Vec<String>,
    /// Abbreviations with their expressions, in terms of letters and earlier abbreviations.
    pub abbreviations: Vec<(String, String)>,
    /// Kinematic equations: expressions that vanish and are linear in the speeds; they relate rates of coordinates to speeds.
    pub kinematics: Vec<String>,
    /// Constraints between speeds or coordinates: expressions that vanish.
    pub constraints: Vec<String>,
    /// Equations of motion with names: expressions that vanish and are linear in accelerations and multipliers.
    pub equations: Vec<(String, String)>,
}

const ON_CONSTRAINTS: &str = "its left side on the constraints of the model";
const BESIDE_OURS: &str = "its difference to the model's equation along the same speed";
const ALONG_MOTIONS: &str = "its left side, with the model's accelerations put in,";

impl PeerEquations {
    /// Compares the equations with those of a system.
    ///
    /// # Errors
    /// The system or the meaning of a letter is faulty, or the equations cannot be compared.
    pub fn compared(&self, system: &SystemText) -> Result<PeerFinding, SceneError> {
        // the system is read alone first, so that its faults are not reported as faults of letters
        system.for_judgement()?;
        let offset = system.text.len() + 1;
        let (mut written, mut outputs) = (String::new(), Vec::new());
        for (name, meaning) in &self.letters {
            let at = offset + written.len() + name.len() + 3;
            outputs.push(Entry { name: Text::at(output_name(name), at), value: Text::at(meaning.clone(), at) });
            written += &format!("{name} = {meaning}\n");
        }
        let model = system.for_judgement_with(outputs).map_err(|mut error| {
            for issue in &mut error.issues {
                issue.title = issue.title.replace("the output `letter ", "the letter `").replace("`letter ", "`");
                issue.span =
                    issue.span.clone().map(|span| span.start.saturating_sub(offset)..span.end.saturating_sub(offset));
            }
            SceneError { path: "meanings of letters".to_owned(), text: written.clone(), issues: error.issues }
        })?;
        symbolic::apart(|| {
            let trace = Trace::of(&model);
            self.beside(&trace).map_err(|(why, accepted)| SceneError::whole(&system.name, why, accepted))
        })
    }

    fn beside(&self, trace: &Trace<'_>) -> Result<PeerFinding, (String, &'static str)> {
        let meaning = |name: &str| {
            let output = trace.model.outputs.iter().find(|output| output.name == output_name(name));
            output.map_or(Sym::ZERO, |output| trace.scalar(output.is))
        };
        let along = Motion::by_equations(trace)
            .map_err(|why| (why, "a system whose accelerations follow from its equations"))?;
        let held = Motion::by_constraints(trace);
        let rates = PeerRates::of(self, trace, meaning)?;
        let constraints = constraints_of(trace);
        let free = Characteristics::of(trace, &constraints);
        let unknowns = [&rates.accelerations[..], &rates.multipliers].concat();
        // the matrix of accelerations and multipliers, under the constraints
        let by =
            |row: Sym, unknowns: &[Sym]| -> Vec<Sym> { unknowns.iter().map(|&z| held.reduced(row.diff(z))).collect() };
        let rank = |rows: Vec<Vec<Sym>>| if rows.iter().all(Vec::is_empty) { 0 } else { generic_rank(&rows) };
        let matrix: Vec<Vec<Sym>> = rates.equations.iter().map(|&row| by(row, &unknowns)).collect();
        let is_linear = |entry: &Sym| entry.symbols_of().iter().all(|symbol| !unknowns.contains(symbol));
        if !matrix.iter().flatten().all(is_linear) {
            return Err((
                "an equation is not linear in the accelerations".to_owned(),
                "equations that are linear in accelerations and multipliers",
            ));
        }
        // a repeated constraint leaves multipliers undetermined, but no acceleration
        let of_multipliers = rates.equations.iter().map(|&row| by(row, &rates.multipliers)).collect();
        let determined = rank(matrix) - rank(of_multipliers) == rates.accelerations.len();
        // the derivatives of their speeds along the independent directions of the model
        let directions = free.directions(trace.speeds.len());
        let by_direction = |speed: Sym| -> Vec<Sym> {
            let along = |direction: &Vec<Sym>| {
                direction.iter().enumerate().fold(Sym::ZERO, |sum, (k, &part)| match part {
                    Sym::ZERO => sum,
                    part => sum + trace.by_speed(speed, k) * part,
                })
            };
            directions.iter().map(|direction| held.reduced(along(direction))).collect()
        };
        let slopes: Vec<Vec<Sym>> = rates.speeds.iter().map(|&speed| by_direction(speed)).collect();
        let freedom = directions.len();
        if generic_rank(&slopes) < freedom {
            return Err((untold(trace, &free, &slopes), "coordinates that determine the motion of the model"));
        }
        let rows: Vec<Sym> = rates.equations.iter().map(|row| row.substitute(&rates.values)).collect();
        let without_multipliers_in = |row: Sym| rates.multipliers.iter().all(|z| !row.symbols_of().contains(z));
        let vanishes_there = |row: Sym| matches!(vanishes(&held, row, &[]), Outcome::Zero(_) | Outcome::Identified(_));
        let is_constraint = |row: Sym| {
            let reduced = held.reduced(row);
            // roots that are written differently have one value in an identity test alone
            let is_identity = || matches!(identified(&[reduced]), Identity::Identified { .. });
            reduced == Sym::ZERO || (generic_rank(&[vec![reduced]]) == 0 && vanishes_there(row)) || is_identity()
        };
        // by their own letters, which the rows no longer hold
        let accelerations_of = |&row: &usize| by(rates.equations[row], &rates.accelerations);
        // degrees of freedom, and rows without multipliers that are no constraints
        let split = |is_constraint: &dyn Fn(Sym) -> bool| {
            let free = (0..rows.len()).filter(|&row| without_multipliers_in(rows[row]));
            let (differentiated, others): (Vec<usize>, Vec<usize>) = free.partition(|&row| is_constraint(rows[row]));
            let held_by = rank(differentiated.iter().map(accelerations_of).collect());
            (rates.accelerations.len().saturating_sub(held_by), others)
        };
        let (mut theirs, mut others) = split(&is_constraint);
        // the product of a constraint and a factor vanishes by a normal form on the constraints, which takes longer
        if theirs > freedom {
            (theirs, others) = split(&|row| is_constraint(row) || vanishes_there(row));
        }
        // a row that was not decided may be a constraint as well
        let is_open = |row: &&usize| !matches!(vanishes(&held, rows[**row], &[]), Outcome::NonZero(_));
        let open = if theirs > freedom { others.iter().filter(is_open).count() } else { 0 };
        let projected = Projected { trace, held: &held, free: &free, slopes: &slopes };

        let mut requires: Vec<Sym> = along.divisors.clone();
        let mut found = Vec::new();
        for (place, constraint) in rates.constraints.iter().enumerate() {
            let name = format!("constraint {}", place + 1);
            found.push(judged(name, *constraint, [&held, &along], ON_CONSTRAINTS, Vec::new, &mut requires));
        }
        let idle: Vec<(Sym, Sym)> = rates.multipliers.iter().map(|&z| (z, Sym::ZERO)).collect();
        let names: Vec<&String> = self.equations.iter().map(|(name, _)| name).collect();
        // terms are compared without reactions; an equation that differs should not determine a multiplier
        let of_rows: Vec<Vec<TermDifference>> = match rates.multipliers.is_empty() {
            true => Vec::new(),
            false => {
                let sides = |(place, row): (usize, &Sym)| {
                    projected.sides_without_reactions(row.substitute(&idle), place, &rates.speeds)
                };
                let terms = |sides: Option<[Sym; 2]>| sides.map_or_else(Vec::new, |sides| projected.differences(sides));
                rows.iter().enumerate().map(sides).map(terms).collect()
            }
        };
        let differs = |place: usize| of_rows.get(place).is_some_and(|terms| !terms.is_empty());
        let (left, used) = without_multipliers(&rows, &rates.multipliers, &along, differs)?;
        for (place, row) in left.iter().enumerate().filter(|(place, _)| !used.contains(place)) {
            let sides = rates.multipliers.is_empty().then(|| projected.sides(*row, place)).flatten();
            // the side of the model vanishes along motions; a difference without accelerations is simpler
            let rest = sides.and_then(|sides| projected.without_accelerations(sides, &mut requires));
            let (zero, motion, is) = match (rest, sides) {
                (Some(rest), _) => (rest, &held, BESIDE_OURS),
                (None, Some([theirs, ours])) => (theirs - ours, &along, ALONG_MOTIONS),
                (None, None) => (*row, &along, ALONG_MOTIONS),
            };
            let terms = || match sides {
                Some(sides) => projected.differences(sides),
                None => of_rows.get(place).cloned().unwrap_or_default(),
            };
            found.push(judged(names[place].clone(), zero, [motion, &along], is, terms, &mut requires));
        }
        let used: Vec<&str> = used.iter().map(|&place| names[place].as_str()).collect();
        let (verdict, mut sentence) = whole(&found, determined, Freedom { theirs, open, ours: freedom });
        if matches!(verdict, Verdict::Proved | Verdict::Identified) {
            sentence += &format!("; {}", allowed(trace, true));
        }
        if !used.is_empty() {
            sentence += &format!("; the multipliers were found from {}", used.join(", "));
        }
        Ok(PeerFinding { verdict, sentence, equations: found, requires: divisors(&requires) })
    }
}

fn output_name(letter: &str) -> String {
    format!("letter {letter}")
}
