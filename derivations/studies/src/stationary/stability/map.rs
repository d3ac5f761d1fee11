//! Stability maps, over two data, of the rotation about an axis that contains rotor and weight.
//!
//! At one value of the first datum two polynomials in the second decide: b, and a^2 - 4 b (`reduced`), obtained by
//! evaluating the law with the datum as an unknown. Their real roots are isolated, and the verdict is constant between
//! two adjacent roots: every column of the map is exact, including the boundaries.

use super::reduced::{Fate, Reduced};
use crate::stationary::energies::Energies;
use algebra::real::{Field, Number, Polynomial, Root};
use field::{Rational, Scalar};
use nalgebra::Vector3;
use symbolic::{Hypotheses, NotPolynomial, Sym, coefficients, normal, univariate};

/// A gyrostat whose rotor and weight lie along one principal axis of A*, with the end of the axis that points down.
#[derive(Clone, Copy, Debug)]
pub struct OneAxis<S: Scalar = Rational> {
    energies: Energies<S>,
    vertical: Vector3<S>,
}

/// A column of the map: the boundaries in the second datum, ascending, and the verdicts between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The boundaries; there is one verdict more than boundaries.
    pub edges: Vec<Edge>,
    pub fates: Vec<Fate>,
}

/// A zero of a deciding polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// The value of the second datum.
    pub at: f64,
    /// True for b = 0, where a tilt costs no energy; otherwise two pairs of eigenvalues meet.
    pub neutral: bool,
}

impl OneAxis {
    /// The gyrostat; `None` where rotor, weight and a principal axis are not parallel. `hanging`: the weight points
    /// down.
    pub fn of(energies: &Energies<Rational>, hanging: bool) -> Option<Self> {
        let down = energies.weight.iter().find_map(|g| g.sign().filter(|sign| *sign != 0))? > 0;
        Self::about(energies, down == hanging)
    }

    /// The column of all rotor speeds at one angular velocity, rad/s.
    pub fn column(&self, speed: Rational) -> Column {
        let unknown = Sym::symbol("W");
        let written = OneAxis { energies: self.energies.written(), vertical: self.vertical.map(Sym::constant) };
        let over = written.motion(Sym::constant(speed), unknown);
        let motion = |rotor_speed: Rational| Some(self.motion(speed, rotor_speed));
        let column = Column::of(&over, unknown, [f64::NEG_INFINITY, f64::INFINITY], &motion);
        column.ok().flatten().unwrap_or(Column { edges: Vec::new(), fates: vec![Fate::Edge] })
    }
}

impl<S: Scalar> OneAxis<S> {
    /// The rotation about the axis itself, or its opposite, for any direction of the weight. Expressions must be in
    /// normal form: the test for zero is structural.
    pub fn about(energies: &Energies<S>, along: bool) -> Option<Self> {
        let axis = (0..3).find(|i| !energies.mixed[*i].is_zero())?;
        let alone = |v: &Vector3<S>| (0..3).all(|j| j == axis || v[j].is_zero());
        let row: Vector3<S> = energies.tensor.column(axis).into();
        let agrees = alone(&row) && alone(&energies.mixed) && alone(&energies.weight);
        let side = S::int(if along { 1 } else { -1 });
        let vertical = Vector3::from_fn(|j, _| if j == axis { side } else { S::zero() });
        agrees.then_some(OneAxis { energies: *energies, vertical })
    }

    /// The motion with these speeds.
    pub fn motion(&self, speed: S, rotor_speed: S) -> Reduced<S> {
        Reduced::kept(&self.energies, speed, self.vertical, rotor_speed)
    }
}

impl Column {
    /// The column over the second datum, an unknown in the reduced motion `over`, within a range; `motion` gives the
    /// motion at its values. `None` where there is no motion.
    ///
    /// # Errors
    /// [`NotPolynomial`] where b or a^2 - 4 b is not polynomial in the unknown.
    pub fn of(
        over: &Reduced<Sym>,
        unknown: Sym,
        range: [f64; 2],
        motion: &dyn Fn(Rational) -> Option<Reduced<Rational>>,
    ) -> Result<Option<Self>, NotPolynomial> {
        let roots = |decisive: Sym| -> Result<Vec<Root>, NotPolynomial> {
            let form = normal(decisive, &Hypotheses::none()).map_err(|_| NotPolynomial(decisive))?;
            let polynomial = Polynomial::from_rationals(&univariate(form.to_sym(), unknown)?).unwrap_or_default();
            Ok(polynomial.real_roots())
        };
        // the data are defined, and so are all signs
        let fate = |at: Rational| Some(Fate::of(&motion(at)?, |x: Rational| x.sign().unwrap_or(0)));
        Column::cut(over, range, &roots, &fate)
    }

    /// The column where the rotor's speed is an irrational number, a second unknown of `over`: coefficients and signs
    /// are computed in its number field.
    ///
    /// # Errors
    /// [`NotPolynomial`] where b or a^2 - 4 b is not polynomial in the unknowns.
    pub fn with_kept(
        over: &Reduced<Sym>,
        unknowns: [Sym; 2],
        kept: &Root,
        range: [f64; 2],
    ) -> Result<Option<Self>, NotPolynomial> {
        let parts = over.deciding().map(|decisive| OverKept::of(decisive, unknowns));
        let [a, b, apart, trace] = parts;
        let deciding = [a?, b?, apart?, trace?];
        let roots = |decisive: Sym| -> Result<Vec<Root>, NotPolynomial> {
            let polynomial = OverKept::of(decisive, unknowns)?.over_field(kept);
            Ok(polynomial.ok_or(NotPolynomial(decisive))?.real_roots())
        };
        let fate = |at: Rational| {
            let signs: Option<Vec<i32>> = deciding.iter().map(|part| part.sign(at, kept)).collect();
            Some(Fate::by_signs(signs?.try_into().ok()?))
        };
        Column::cut(over, range, &roots, &fate)
    }

    fn cut(
        over: &Reduced<Sym>,
        [low, high]: [f64; 2],
        roots: &dyn Fn(Sym) -> Result<Vec<Root>, NotPolynomial>,
        fate: &dyn Fn(Rational) -> Option<Fate>,
    ) -> Result<Option<Self>, NotPolynomial> {
        let [_, _, apart, _] = over.deciding();
        let [_, _, neutral] = over.polynomial();
        let edges = |decisive: Sym, neutral: bool| -> Result<Vec<Edge>, NotPolynomial> {
            let all = roots(decisive)?.into_iter().map(|root| Edge { at: root.to_f64(), neutral });
            Ok(all.filter(|edge| low < edge.at && edge.at < high).collect())
        };
        let mut edges = [edges(neutral, true)?, edges(apart, false)?].concat();
        edges.sort_by(|a, b| a.at.total_cmp(&b.at));
        let ends = [&[low], &edges.iter().map(|edge| edge.at).collect::<Vec<_>>()[..], &[high]].concat();
        let between = |pair: &[f64]| match (pair[0].is_finite(), pair[1].is_finite()) {
            (true, true) => 0.5 * (pair[0] + pair[1]),
            (true, false) => pair[0] + pair[0].abs() + 1.0,
            (false, true) => pair[1] - pair[1].abs() - 1.0,
            (false, false) => 0.0,
        };
        let fates: Option<Vec<Fate>> = ends.windows(2).map(|pair| fate(Rational::decimal(between(pair)))).collect();
        Ok(fates.map(|fates| Column { edges, fates }))
    }

    /// The verdict at a value that is no boundary.
    pub fn at(&self, value: f64) -> Fate {
        let below = self.edges.iter().filter(|edge| edge.at < value).count();
        self.fates.get(below).copied().unwrap_or(Fate::Edge)
    }
}

/// A rational function of the second datum and the rotor's speed, as terms (powers, coefficient).
struct OverKept {
    numerator: Vec<([usize; 2], Rational)>,
    denominator: Vec<([usize; 2], Rational)>,
}

impl OverKept {
    fn of(decisive: Sym, unknowns: [Sym; 2]) -> Result<Self, NotPolynomial> {
        let form = normal(decisive, &Hypotheses::none()).map_err(|_| NotPolynomial(decisive))?;
        let terms = |part: Sym| -> Result<Vec<([usize; 2], Rational)>, NotPolynomial> {
            let of = |(powers, c): (Vec<u32>, Sym)| {
                let value = c.as_constant().ok_or(NotPolynomial(c))?;
                Ok(([powers[0] as usize, powers[1] as usize], value))
            };
            coefficients(part, &unknowns)?.into_iter().map(of).collect()
        };
        let [numerator, denominator] = [terms(form.numerator())?, terms(form.denominator())?];
        Ok(OverKept { numerator, denominator })
    }

    /// The numerator with coefficients in the number field of t = a W; all terms are multiplied by one power of a.
    fn over_field(&self, kept: &Root) -> Option<Polynomial> {
        let (generator, lead) = Field::of(kept)?;
        let values: Vec<Rational> = self.numerator.iter().map(|(_, value)| *value).collect();
        let (whole, _) = Number::over_common(&values)?;
        let most = self.numerator.iter().map(|([_, power], _)| *power).max().unwrap_or(0);
        let degree = self.numerator.iter().map(|([power, _], _)| *power).max().unwrap_or(0);
        let power = |base: &Number, n: usize| (0..n).fold(Number::from(1), |power, _| &power * base);
        let mut dense = vec![Number::zero(); degree + 1];
        for (([of_datum, of_speed], _), c) in self.numerator.iter().zip(&whole) {
            let term = &(c * &power(&generator, *of_speed)) * &power(&lead, most - of_speed);
            dense[*of_datum] = &dense[*of_datum] + &term;
        }
        Some(Polynomial::new(dense))
    }

    /// The sign at a value of the datum; `None` where the function is undefined there.
    fn sign(&self, at: Rational, kept: &Root) -> Option<i32> {
        let sign = |terms: &[([usize; 2], Rational)]| {
            let mut dense = vec![Rational::int(0); 1 + terms.iter().map(|([_, power], _)| *power).max().unwrap_or(0)];
            for ([of_datum, of_speed], value) in terms {
                dense[*of_speed] += (0..*of_datum).fold(*value, |term, _| term * at);
            }
            Some(kept.sign_of(&Polynomial::from_rationals(&dense)?))
        };
        let (above, below) = (sign(&self.numerator)?, sign(&self.denominator)?);
        (below != 0).then_some(above * below)
    }
}
