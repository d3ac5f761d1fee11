//! Speeds, accelerations and multipliers of another program in terms of a model.

use super::PeerEquations;
use super::reading::Vocabulary;
use crate::letters::rate;
use crate::motion::Motion;
use model::Trace;
use model::equations::{generic_pivots, generic_rank};
use symbolic::linear::solve;
use symbolic::{Hypotheses, Sym, decide};

/// The reason for which equations cannot be compared, and the accepted form.
type Refusal = (String, &'static str);

const LINEAR: &str = "kinematic equations that are linear in the speeds and determine them; `names` has the meaning of a speed without one";

/// The largest number of choices of equations that are tried to eliminate multipliers.
const MOST_CHOICES: usize = 64;

/// The equations of another program, in the symbols of the model and letters for its own unknowns.
pub(super) struct PeerRates {
    pub equations: Vec<Sym>,
    /// The constraints, in the symbols of the model.
    pub constraints: Vec<Sym>,
    /// The letters of accelerations; `multipliers` are those of multipliers.
    pub accelerations: Vec<Sym>,
    pub multipliers: Vec<Sym>,
    /// The speed whose rate each acceleration is, in the symbols of the model.
    pub speeds: Vec<Sym>,
    /// The letters of accelerations with their values in the symbols of the model.
    pub values: Vec<(Sym, Sym)>,
}

fn unknown(name: &str) -> Sym {
    Sym::symbol(&format!("other {name}"))
}

impl PeerRates {
    /// Reads the equations; `meaning` returns the value of a letter in the symbols of the model.
    ///
    /// # Errors
    /// A text cannot be read, or the equations do not determine the speeds; with the accepted form.
    pub fn of(peer: &PeerEquations, trace: &Trace<'_>, meaning: impl Fn(&str) -> Sym) -> Result<Self, Refusal> {
        let unread = |why: String| (why, "expressions of coordinates, rates and parameters");
        let mut words = Vocabulary::new(trace.time, trace.pi);
        for (name, _) in &peer.letters {
            let value = meaning(name);
            words.add(name, value);
            let mut next = value;
            for order in 1..=2 {
                let Ok(found) = rate(trace, next) else { break };
                words.add(&format!("{name}{}", "'".repeat(order)), found);
                next = found;
            }
        }
        let speeds: Vec<Sym> = peer.speeds.iter().map(|name| unknown(name)).collect();
        peer.speeds.iter().zip(&speeds).for_each(|(name, &letter)| words.add(name, letter));
        // abbreviations that contain speeds are read again once the speeds are known
        let mut of_kinematics = words.clone();
        for (name, text) in &peer.abbreviations {
            if let Ok(value) = of_kinematics.read(text) {
                of_kinematics.add(name, value);
            }
        }
        let kinematics = peer
            .kinematics
            .iter()
            .map(|text| of_kinematics.read(text).map_err(unread))
            .collect::<Result<Vec<Sym>, Refusal>>()?;
        let (found, others) = solved_speeds(&kinematics, &speeds)?;
        for (name, &value) in peer.speeds.iter().zip(&found) {
            words.add(name, value);
        }
        let (mut values, mut of_rates) = (Vec::new(), Vec::new());
        for name in &peer.accelerations {
            let speed = name.strip_suffix('\'').and_then(|of| words.get(of));
            let speed = speed.ok_or_else(|| unread(format!("`{name}` is no rate of a letter")))?;
            let value = rate(trace, speed).map_err(unread)?;
            values.push((unknown(name), value));
            words.add(name, unknown(name));
            of_rates.push(speed);
        }
        let multipliers: Vec<Sym> = peer.multipliers.iter().map(|name| unknown(name)).collect();
        peer.multipliers.iter().zip(&multipliers).for_each(|(name, &letter)| words.add(name, letter));
        for (name, text) in &peer.abbreviations {
            let value = words.read(text).map_err(unread)?;
            words.add(name, value);
        }
        let read = |text: &String| words.read(text).map_err(unread);
        let constraints = peer.constraints.iter().map(read).collect::<Result<Vec<Sym>, Refusal>>()?;
        let known: Vec<(Sym, Sym)> = speeds.iter().copied().zip(found).collect();
        let others = others.into_iter().map(|other| other.substitute(&known));
        Ok(PeerRates {
            equations: peer.equations.iter().map(|(_, text)| read(text)).collect::<Result<Vec<Sym>, Refusal>>()?,
            constraints: constraints.into_iter().chain(others).map(|zero| zero.substitute(&values)).collect(),
            accelerations: values.iter().map(|&(letter, _)| letter).collect(),
            multipliers,
            speeds: of_rates,
            values,
        })
    }
}

/// The speeds from the kinematic equations, and the equations that were not needed for them.
fn solved_speeds(kinematics: &[Sym], speeds: &[Sym]) -> Result<(Vec<Sym>, Vec<Sym>), Refusal> {
    if speeds.is_empty() {
        return Ok((Vec::new(), kinematics.to_vec()));
    }
    let at_rest: Vec<(Sym, Sym)> = speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
    let matrix: Vec<Vec<Sym>> =
        kinematics.iter().map(|row| speeds.iter().map(|&speed| row.diff(speed)).collect()).collect();
    if matrix.iter().flatten().any(|entry| entry.symbols_of().iter().any(|symbol| speeds.contains(symbol))) {
        return Err(("the kinematic equations are not linear in the speeds".to_owned(), LINEAR));
    }
    let pivots = generic_pivots(&matrix, &(0..speeds.len()).collect::<Vec<_>>());
    if pivots.len() < speeds.len() {
        return Err((format!("the kinematic equations determine {} of {} speeds", pivots.len(), speeds.len()), LINEAR));
    }
    let taken: Vec<usize> = pivots.iter().map(|&(row, _)| row).collect();
    let square: Vec<&[Sym]> = taken.iter().map(|&row| &matrix[row][..]).collect();
    let right: Vec<Sym> = taken.iter().map(|&row| -kinematics[row].substitute(&at_rest)).collect();
    let solution = solve(&square, &right, &Hypotheses::none())
        .map_err(|why| (format!("the kinematic equations are not solved: {why}"), LINEAR))?;
    let others = (0..kinematics.len()).filter(|row| !taken.contains(row)).map(|row| kinematics[row]).collect();
    Ok((solution.values(), others))
}

/// The equations after elimination of the multipliers, and the indices of the equations that were used for it. These are chosen such that
/// as few as possible of the others fail, and preferably agree with the model's equations.
pub(super) fn without_multipliers(
    rows: &[Sym],
    multipliers: &[Sym],
    along: &Motion<'_, '_>,
    differs: impl Fn(usize) -> bool,
) -> Result<(Vec<Sym>, Vec<usize>), Refusal> {
    if multipliers.is_empty() {
        return Ok((rows.to_vec(), Vec::new()));
    }
    let slopes: Vec<Vec<Sym>> =
        rows.iter().map(|row| multipliers.iter().map(|&z| along.reduced(row.diff(z))).collect()).collect();
    let order: Vec<usize> = (0..multipliers.len()).collect();
    let columns: Vec<usize> = generic_pivots(&slopes, &order).into_iter().map(|(_, column)| column).collect();
    // multipliers that the equations leave undetermined are set to zero
    let idle: Vec<(Sym, Sym)> = multipliers
        .iter()
        .enumerate()
        .filter(|(place, _)| !columns.contains(place))
        .map(|(_, &z)| (z, Sym::ZERO))
        .collect();
    let rows: Vec<Sym> = rows.iter().map(|row| row.substitute(&idle)).collect();
    let square = |taken: &[usize]| -> Vec<Vec<Sym>> {
        taken.iter().map(|&row| columns.iter().map(|&column| slopes[row][column]).collect()).collect()
    };
    let mut best: Option<(usize, Vec<Sym>, Vec<usize>)> = None;
    let mut all = choices(rows.len(), columns.len());
    all.retain(|taken| generic_rank(&square(taken)) == columns.len());
    all.sort_by_key(|taken| taken.iter().filter(|&&row| differs(row)).count());
    for taken in all.into_iter().take(MOST_CHOICES) {
        let at_rest: Vec<(Sym, Sym)> = columns.iter().map(|&column| (multipliers[column], Sym::ZERO)).collect();
        let right: Vec<Sym> = taken.iter().map(|&row| -rows[row].substitute(&at_rest)).collect();
        let Ok(solution) = solve(&square(&taken), &right, &Hypotheses::none()) else { continue };
        let values: Vec<(Sym, Sym)> =
            columns.iter().map(|&column| multipliers[column]).zip(solution.values()).collect();
        let left: Vec<Sym> = rows.iter().map(|row| row.substitute(&values)).collect();
        let is_wrong = |row: &&Sym| {
            let row = along.reduced(**row);
            generic_rank(&[vec![row]]) > 0 && !decide(row, &along.hypotheses).is_zero()
        };
        let wrong = left
            .iter()
            .enumerate()
            .filter(|(place, _)| !taken.contains(place))
            .map(|(_, row)| row)
            .filter(is_wrong)
            .count();
        if best.as_ref().is_none_or(|(least, ..)| wrong < *least) {
            best = Some((wrong, left, taken));
        }
        if wrong == 0 {
            break;
        }
    }
    let (_, left, taken) = best.ok_or_else(|| {
        ("the equations do not determine the multipliers".to_owned(), "multipliers that the equations determine")
    })?;
    Ok((left, taken))
}

/// All choices of `count` indices below `of`, those with large indices first, so that the first equations are used last.
fn choices(of: usize, count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let mut all = Vec::new();
    for last in (count - 1..of).rev() {
        for mut choice in choices(last, count - 1) {
            choice.push(last);
            all.push(choice);
            if all.len() >= 4 * MOST_CHOICES {
                return all;
            }
        }
    }
    all
}
