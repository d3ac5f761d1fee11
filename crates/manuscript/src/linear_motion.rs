//! The linear equations about a steady motion: matrices of inertia, damping and stiffness, and the characteristic polynomial.

use crate::determinant::determinant;
use crate::feedback::Feedback;
use crate::letters::Letters;
use crate::motion::Motion;
use crate::steady_motion::Resting;
use model::equations::Equations;
use symbolic::{Sym, coefficients, decide, normal};

/// The largest number of speeds of a system that is linearised.
const MOST_SPEEDS: usize = 4;

/// The matrices of the linear equations, by rows.
pub(crate) struct LinearMotion {
    /// Expressions that vanish along every motion, one for each coordinate.
    pub equations: Vec<Sym>,
    /// The indices of the coordinates that are constant; the others have constant speeds.
    pub resting: Vec<usize>,
    /// The matrix of the accelerations, n × n for n coordinates; `damping` is that of the speeds.
    pub inertia: Vec<Vec<Sym>>,
    pub damping: Vec<Vec<Sym>>,
    /// The stiffness matrix; its columns for coordinates with constant speeds are zero.
    pub stiffness: Vec<Vec<Sym>>,
}

/// The characteristic polynomial of the linear equations.
pub(crate) struct Characteristic {
    /// The unknown.
    pub root: Sym,
    /// The factor with which the determinant becomes a polynomial.
    pub scale: Sym,
    /// The coefficients by ascending powers, after division by the power of the zero roots.
    pub coefficients: Vec<Sym>,
    /// The number of zero roots.
    pub neutral: u32,
}

impl LinearMotion {
    /// Linearises about the motion on which the letters of a claim are constant, with the inputs that hypotheses prescribe.
    ///
    /// # Errors
    /// The reason for which there are no such equations, or for which they depend on time.
    pub fn of(
        resting: &Resting,
        letters: &Letters<'_, '_>,
        motion: &Motion<'_, '_>,
        feedback: &Feedback,
    ) -> Result<Self, String> {
        let trace = letters.trace;
        let Equations { mass, bias, constraints } = Equations::of(trace);
        let n = mass.len();
        if !constraints.is_empty() || n != trace.coordinates.len() {
            return Err("stability is decided of systems without constraints and without free frames".to_owned());
        }
        if n > MOST_SPEEDS {
            return Err(format!("stability is decided of up to {MOST_SPEEDS} coordinates, and this system has {n}"));
        }
        let Resting { coordinates, speeds } = resting;
        if let Some(free) = (0..n).find(|place| !coordinates.contains(place) && !speeds.contains(place)) {
            let name = &trace.coordinates[free];
            return Err(format!(
                "neither {name} nor its rate rests, so that the linear equations change with the time"
            ));
        }
        let rows = || Vec::with_capacity(n);
        let mut found = LinearMotion {
            equations: Vec::new(),
            resting: coordinates.clone(),
            inertia: rows(),
            damping: rows(),
            stiffness: rows(),
        };
        for (k, row) in mass.iter().enumerate() {
            let equation =
                row.iter().zip(&trace.accelerations).fold(bias[k], |sum, (&entry, &rate)| sum + entry * rate);
            let equation = feedback.put_in(equation);
            if !decide(motion.reduced(equation), &motion.hypotheses).is_zero() {
                return Err(format!(
                    "the equation of {} does not hold on this motion: its condition is missing in `given`",
                    trace.direction(k)
                ));
            }
            let of = |part: &dyn Fn(usize) -> Sym| (0..n).map(|j| motion.reduced(part(j))).collect::<Vec<Sym>>();
            let stiffness = of(&|j| trace.by_coordinate(equation, j));
            let moves = |j: &usize| !coordinates.contains(j) && !decide(stiffness[*j], &motion.hypotheses).is_zero();
            if let Some(j) = (0..n).find(moves) {
                return Err(format!("the linear equations know {} itself, which does not rest", trace.coordinates[j]));
            }
            found.inertia.push(of(&|j| trace.by_acceleration(equation, j)));
            found.damping.push(of(&|j| trace.by_speed(equation, j)));
            found.stiffness.push(stiffness);
            found.equations.push(equation);
        }
        Ok(found)
    }

    /// The characteristic polynomial.
    ///
    /// # Errors
    /// The polynomial has more zero roots than there are constant speeds, or the determinant is not a polynomial.
    pub fn characteristic(&self, motion: &Motion<'_, '_>) -> Result<Characteristic, String> {
        let n = self.equations.len();
        let s = Sym::symbol("root of the linear equations");
        let entry = |k: usize, j: usize| {
            let of_speed = self.inertia[k][j] * s + self.damping[k][j];
            if self.resting.contains(&j) { of_speed * s + self.stiffness[k][j] } else { of_speed }
        };
        let matrix: Vec<Vec<Sym>> = (0..n).map(|k| (0..n).map(|j| entry(k, j)).collect()).collect();
        let polynomial = normal(determinant(&matrix), &motion.hypotheses).map_err(|why| why.to_string())?;
        let terms = coefficients(polynomial.numerator(), &[s])
            .map_err(|_| "the characteristic polynomial was not formed".to_owned())?;
        let mut powers: Vec<(u32, Sym)> = terms.into_iter().map(|(exponents, value)| (exponents[0], value)).collect();
        powers.sort_by_key(|(power, _)| *power);
        let neutral = powers.first().map_or(0, |(power, _)| *power);
        // each constant speed causes one zero root, since there are steady motions with other speeds nearby
        if neutral as usize > n - self.resting.len() {
            return Err("the linear equations have a root zero beside those of speeds that stay as they are".to_owned());
        }
        let degree = powers.last().map_or(0, |(power, _)| *power) - neutral;
        let of = |power: u32| {
            powers.iter().find(|(known, _)| *known == power + neutral).map_or(Sym::ZERO, |(_, value)| *value)
        };
        let coefficients = (0..=degree).map(of).collect();
        Ok(Characteristic { root: s, scale: polynomial.denominator(), coefficients, neutral })
    }
}
