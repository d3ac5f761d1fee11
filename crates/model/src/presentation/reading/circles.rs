//! A sum of cosines and sines ("waves") in the shorter of two forms: multiple angles, or powers of cosines and sines of single angles.

use super::harmonic::Multiple;
use super::sum::Wave;
use field::Rational;
use num_traits::{One, Zero};
use std::collections::BTreeMap;

/// The trigonometric factor of a monomial: one cosine or sine, or a product of powers of cosines and sines of single angles.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Factor {
    Wave(Wave),
    /// (term, step, exponents of cosine and sine) for each angle, which is the step times the term.
    Powers(Vec<(u32, Multiple, [u32; 2])>),
}

impl Factor {
    /// Returns no power, or a single first power, as a wave.
    fn of(powers: Vec<(u32, Multiple, [u32; 2])>) -> Self {
        match powers[..] {
            [] => Factor::Wave(Wave::default()),
            [(atom, step, [1, 0])] => Factor::Wave(Wave { angle: vec![(atom, step)], is_sine: false }),
            [(atom, step, [0, 1])] => Factor::Wave(Wave { angle: vec![(atom, step)], is_sine: true }),
            _ => Factor::Powers(powers),
        }
    }
}

impl Factor {
    /// Returns the cosines and sines with their exponents; for each angle the sine comes first.
    pub fn waves(&self) -> Vec<(Wave, u32)> {
        match self {
            Factor::Wave(wave) if wave.angle.is_empty() => Vec::new(),
            Factor::Wave(wave) => vec![(wave.clone(), 1)],
            Factor::Powers(powers) => powers
                .iter()
                .flat_map(|&(atom, step, [cosine, sine])| {
                    let wave = |is_sine| Wave { angle: vec![(atom, step)], is_sine };
                    [(wave(true), sine), (wave(false), cosine)]
                })
                .filter(|(_, exponent)| *exponent > 0)
                .collect(),
        }
    }

    /// Reduces the exponent of a cosine or sine by one; `None` if it does not occur.
    pub fn without(&self, is_it: impl Fn(&Wave) -> bool) -> Option<Self> {
        let (found, _) = self.waves().into_iter().find(|(wave, _)| is_it(wave))?;
        match self {
            Factor::Wave(_) => Some(Factor::Wave(Wave::default())),
            Factor::Powers(powers) => {
                let mut powers = powers.clone();
                let own = powers.iter_mut().find(|(atom, step, _)| found.angle == [(*atom, *step)])?;
                own.2[usize::from(found.is_sine)] -= 1;
                powers.retain(|(_, _, exponents)| *exponents != [0, 0]);
                Some(Factor::of(powers))
            }
        }
    }
}

/// Angles with larger sums of multiples are not expanded.
const MOST_TURNS: i64 = 8;

/// Coefficients by the exponents of cosine and sine of each angle.
type Powers = BTreeMap<Vec<[u32; 2]>, Rational>;

/// Returns the shorter of the two forms.
pub(super) fn shorter(waves: &[(Wave, Rational)]) -> Vec<(Factor, Rational)> {
    let whole: Vec<(Factor, Rational)> =
        waves.iter().map(|(wave, coefficient)| (Factor::Wave(wave.clone()), *coefficient)).collect();
    let opened = opened(waves).unwrap_or_default();
    if opened.is_empty() || cost(&whole) < cost(&opened) { whole } else { opened }
}

/// Expands multiple angles by the addition theorems, then removes squares of sines, or squares of cosines, whichever is shorter; `None` for large
/// multiples.
fn opened(waves: &[(Wave, Rational)]) -> Option<Vec<(Factor, Rational)>> {
    let steps = steps(waves)?;
    let mut sum = Powers::new();
    for (wave, coefficient) in waves {
        let turns = |&(atom, multiple): &(u32, Multiple)| {
            let at = steps.iter().position(|(known, _)| *known == atom)?;
            Some((at, multiple.numerator * (steps[at].1.denominator / multiple.denominator)))
        };
        let turns: Vec<(usize, i64)> = wave.angle.iter().map(turns).collect::<Option<_>>()?;
        if turns.iter().map(|(_, times)| times.abs()).sum::<i64>() > MOST_TURNS {
            return None;
        }
        let unit = Powers::from([(vec![[0, 0]; steps.len()], Rational::one())]);
        let (mut cosine, mut sine) = (unit, Powers::new());
        for (at, times) in turns {
            for _ in 0..times.abs() {
                let sign = if times < 0 { -Rational::one() } else { Rational::one() };
                let (ahead, across) = (raised(&cosine, at, 0), raised(&sine, at, 1));
                let (up, along) = (raised(&sine, at, 0), raised(&cosine, at, 1));
                cosine = added(ahead, &across, -sign);
                sine = added(up, &along, sign);
            }
        }
        sum = added(sum, if wave.is_sine { &sine } else { &cosine }, *coefficient);
    }
    let named = |sum: &Powers| -> Vec<(Factor, Rational)> {
        let factor = |exponents: &Vec<[u32; 2]>| {
            let powers = steps.iter().zip(exponents).filter(|(_, exponents)| **exponents != [0, 0]);
            Factor::of(powers.map(|((atom, step), exponents)| (*atom, *step, *exponents)).collect())
        };
        sum.iter().map(|(exponents, coefficient)| (factor(exponents), *coefficient)).collect()
    };
    for at in 0..steps.len() {
        sum = reduced(&sum, at, 1);
    }
    let mut best = named(&sum);
    for at in 0..steps.len() {
        let other = reduced(&sum, at, 0);
        let form = named(&other);
        if cost(&form) < cost(&best) {
            (sum, best) = (other, form);
        }
    }
    Some(best)
}

/// Returns every term of the angles, with the step of which all its multiples are integer multiples.
fn steps(waves: &[(Wave, Rational)]) -> Option<Vec<(u32, Multiple)>> {
    let mut steps: Vec<(u32, Multiple)> = Vec::new();
    for (atom, multiple) in waves.iter().flat_map(|(wave, _)| &wave.angle) {
        let known = steps.iter_mut().find(|(known, _)| known == atom);
        match known {
            None => steps.push((*atom, Multiple { numerator: 1, denominator: multiple.denominator })),
            Some((_, step)) => {
                let shared = num_gcd(step.denominator, multiple.denominator);
                step.denominator = (step.denominator / shared).checked_mul(multiple.denominator)?;
            }
        }
    }
    Some(steps)
}

fn num_gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { num_gcd(b, a % b) }
}

fn raised(sum: &Powers, at: usize, which: usize) -> Powers {
    let raise = |(exponents, coefficient): (&Vec<[u32; 2]>, &Rational)| {
        let mut exponents = exponents.clone();
        exponents[at][which] += 1;
        (exponents, *coefficient)
    };
    sum.iter().map(raise).collect()
}

fn added(mut sum: Powers, other: &Powers, times: Rational) -> Powers {
    for (exponents, coefficient) in other {
        *sum.entry(exponents.clone()).or_insert_with(Rational::zero) += *coefficient * times;
    }
    sum.retain(|_, coefficient| !coefficient.is_zero());
    sum
}

/// Replaces squares of the sine (1) or the cosine (0) of an angle by one minus the square of the other.
fn reduced(sum: &Powers, at: usize, which: usize) -> Powers {
    let mut done = Powers::new();
    let mut open = sum.clone();
    while let Some((mut exponents, coefficient)) = open.pop_last() {
        if exponents[at][which] < 2 {
            done = added(done, &Powers::from([(exponents, coefficient)]), Rational::one());
            continue;
        }
        exponents[at][which] -= 2;
        open = added(open, &Powers::from([(exponents.clone(), coefficient)]), Rational::one());
        exponents[at][1 - which] += 2;
        open = added(open, &Powers::from([(exponents, coefficient)]), -Rational::one());
    }
    done
}

/// Returns the approximate number of printed characters.
fn cost(form: &[(Factor, Rational)]) -> usize {
    let of = |(factor, coefficient): &(Factor, Rational)| {
        let whole = coefficient.to_big().is_some_and(|big| big.denominator().is_one());
        let one = *coefficient == Rational::one() || -*coefficient == Rational::one();
        let number = if one { 0 } else { 2 + usize::from(!whole) };
        let angle = |multiple: &Multiple| usize::from(*multiple != Multiple { numerator: 1, denominator: 1 });
        let factor = match factor {
            Factor::Wave(wave) => {
                let inside = wave.angle.iter().map(|(_, multiple)| 1 + angle(multiple)).sum::<usize>();
                if wave.angle.is_empty() { 0 } else { 2 + inside }
            }
            Factor::Powers(powers) => powers
                .iter()
                .flat_map(|(_, step, exponents)| exponents.map(|exponent| (step, exponent)))
                .filter(|(_, exponent)| *exponent > 0)
                .map(|(step, exponent)| 3 + angle(step) + usize::from(exponent > 1))
                .sum(),
        };
        4 + number + factor
    };
    form.iter().map(of).sum()
}
