//! Exact points that satisfy constraints which determine the square of a coordinate, such as x² + y² = l².

use crate::motion::Motion;
use crate::polynomial_factors::square_root;
use field::Analytic;
use symbolic::{Hypotheses, Sym, coefficients, normal, univariate};

/// A coordinate whose square is determined by a constraint.
struct Circle {
    coordinate: Sym,
    /// The constraint, an expression that is zero.
    zero: Sym,
    rational: Option<RationalPoint>,
}

/// A rational parametrisation of a circle by `number`: of another coordinate `other` (with its expression), and of the coordinate itself, `own`.
struct RationalPoint {
    number: Sym,
    other: (Sym, Sym),
    own: Sym,
}

/// All coordinates of a motion whose squares are determined by constraints.
pub(crate) struct Circles(Vec<Circle>);

impl Circles {
    pub fn of(motion: &Motion<'_, '_>) -> Self {
        let of = |&(coordinate, zero): &(Sym, Sym)| {
            let zero = motion.reduced(zero);
            Circle { coordinate, zero, rational: RationalPoint::of(coordinate, zero) }
        };
        Circles(motion.squares.iter().map(of).collect())
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The constraints, as expressions that are zero.
    pub fn zeros(&self) -> impl Iterator<Item = Sym> {
        self.0.iter().map(|circle| circle.zero)
    }

    /// Whether a letter is one of these coordinates.
    pub fn gives(&self, letter: Sym) -> bool {
        self.0.iter().any(|circle| circle.coordinate == letter)
    }

    /// The point extended by the values of these coordinates; `None` if they are not rational.
    pub fn completed(&self, point: Vec<(Sym, Sym)>) -> Option<Vec<(Sym, Sym)>> {
        self.0
            .iter()
            .try_fold(point, |point, circle| circle.as_drawn(&point).or_else(|| circle.by_rational_point(point)))
    }
}

impl Circle {
    /// The point extended by the coordinate, with all other letters unchanged; `None` if the coordinate is not rational.
    fn as_drawn(&self, point: &[(Sym, Sym)]) -> Option<Vec<(Sym, Sym)>> {
        let left = normal(self.zero.substitute(point), &Hypotheses::none()).ok()?.numerator();
        let dense = univariate(left, self.coordinate).ok()?;
        let &[constant, _, leading] = &dense[..] else { return None };
        let value = number(Sym::constant(-constant / leading).sqrt())?;
        Some([point, &[(self.coordinate, value)]].concat())
    }

    /// The point extended by the coordinate, with another coordinate moved such that both are rational.
    fn by_rational_point(&self, mut point: Vec<(Sym, Sym)>) -> Option<Vec<(Sym, Sym)>> {
        let RationalPoint { number: letter, other: (other, value), own } = self.rational.as_ref()?;
        let drawn = point.iter().position(|(known, _)| known == other)?;
        let with_number = [&point[..], &[(*letter, point[drawn].1)]].concat();
        let [other, own] = [*value, *own].map(|of| number(of.substitute(&with_number)));
        point[drawn].1 = other?;
        point.push((self.coordinate, own?));
        Some(point)
    }
}

impl RationalPoint {
    /// The parametrisation of a circle whose radius is a letter and whose centre is at zero or at another coordinate.
    fn of(coordinate: Sym, zero: Sym) -> Option<Self> {
        let letters: Vec<Sym> = zero.symbols_of().into_iter().filter(|letter| *letter != coordinate).collect();
        let is_squared = |letter: &&Sym| {
            let terms = coefficients(zero, &[**letter]).unwrap_or_default();
            terms.iter().any(|(powers, factor)| powers[0] == 2 && factor.as_constant().is_some())
        };
        let squared: Vec<Sym> = letters.iter().filter(is_squared).copied().collect();
        let number = Sym::symbol("number of the circle");
        let sine = (number + number) / (Sym::ONE + number * number);
        let centres = || std::iter::once(Sym::ZERO).chain(letters.iter().copied());
        let ways = squared.iter().flat_map(|&other| squared.iter().map(move |&radius| (other, radius)));
        ways.filter(|(other, radius)| other != radius).find_map(|(other, radius)| {
            centres().filter(|centre| *centre != other && *centre != radius).find_map(|centre| {
                let value = centre + radius * sine;
                let own = root_of(zero.substitute(&[(other, value)]), coordinate)?;
                Some(RationalPoint { number, other: (other, value), own })
            })
        })
    }
}

/// The square root of -c/a for an equation a x² + c = 0, if it is a quotient of polynomials.
fn root_of(zero: Sym, letter: Sym) -> Option<Sym> {
    let form = |of: Sym| normal(of, &Hypotheses::none()).ok();
    let terms = coefficients(form(zero)?.numerator(), &[letter]).ok()?;
    let of = |power: u32| terms.iter().find(|(powers, _)| powers[0] == power).map_or(Sym::ZERO, |(_, value)| *value);
    let square = form((Sym::ZERO - of(0)) / of(2))?;
    let root = square_root(form(square.numerator() * square.denominator())?.to_sym())?;
    (of(1) == Sym::ZERO).then(|| root / square.denominator())
}

/// The value of an expression if it is a rational number.
fn number(expression: Sym) -> Option<Sym> {
    let value = normal(expression, &Hypotheses::none()).ok()?.to_sym();
    value.as_constant().filter(|value| value.is_defined()).map(|_| value)
}
