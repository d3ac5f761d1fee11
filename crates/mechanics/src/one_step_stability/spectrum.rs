//! The eigenvalues of a matrix in disjoint enclosures.

use algebra::complex::{Rectangle, zeros};
use algebra::real::Enclosure;

/// A real eigenvalue, or a conjugate pair, which behave alike under a step.
#[derive(Clone, Debug)]
pub struct Mode {
    pub place: HalfPlane,
    /// The number of eigenvalues: 2 for a conjugate pair.
    pub count: usize,
}

/// An eigenvalue, by the sign and exactness of its real part.
#[derive(Clone, Debug)]
pub enum HalfPlane {
    /// A real eigenvalue mu, not zero.
    Real(Enclosure),
    /// mu = i b with b > 0, and its conjugate; the real part vanishes by a theorem, not by a tolerance.
    Imaginary(Enclosure),
    /// mu = a + i b with a not zero and b > 0, and its conjugate.
    Pair(Rectangle),
}

/// The eigenvalues at a motion, without those that follow from its structure.
#[derive(Clone, Debug, Default)]
pub struct Spectrum {
    pub modes: Vec<Mode>,
}

impl Spectrum {
    /// The zeros of a monic polynomial, with coefficients from the constant upwards. With `symmetric` the motion
    /// conserves an energy: with mu also -mu is an eigenvalue, and the polynomial is taken as one in mu^2, whatever
    /// rounding errors its odd coefficients have.
    ///
    /// `None` where eigenvalues coincide, or a real part may vanish without that theorem.
    pub fn of(polynomial: &[Enclosure], symmetric: bool) -> Option<Self> {
        match symmetric {
            true => Self::of_squares(polynomial),
            false => Self::of_all(polynomial),
        }
    }

    fn of_all(polynomial: &[Enclosure]) -> Option<Self> {
        let mut modes = Vec::new();
        for zero in zeros(polynomial)? {
            let place = match (zero.real, zero.at.im.sign()?) {
                (true, _) => HalfPlane::Real(zero.at.re),
                (false, 1) => HalfPlane::Pair(zero.at),
                _ => continue,
            };
            modes.push(place.mode()?);
        }
        Some(Spectrum { modes })
    }

    /// The eigenvalues from the zeros s = mu^2.
    fn of_squares(polynomial: &[Enclosure]) -> Option<Self> {
        let even: Vec<Enclosure> = polynomial.iter().step_by(2).cloned().collect();
        let mut modes = Vec::new();
        for zero in zeros(&even)? {
            let Rectangle { re, im } = &zero.at;
            if zero.real {
                match re.sign()? {
                    1 => {
                        let root = re.sqrt()?;
                        modes.push(HalfPlane::Real(-&root).mode()?);
                        modes.push(HalfPlane::Real(root).mode()?);
                    }
                    _ => modes.push(HalfPlane::Imaginary((-re).sqrt()?).mode()?),
                }
            } else if im.sign()? > 0 {
                // (a + i b)^2 = s
                let size = zero.at.square().sqrt()?;
                let half = |twice: Enclosure| twice.over(&Enclosure::integer(2, twice.bits()))?.sqrt();
                let (a, b) = (half(&size + re)?, half(&size - re)?);
                modes.push(HalfPlane::Pair(Rectangle { re: -&a, im: b.clone() }).mode()?);
                modes.push(HalfPlane::Pair(Rectangle { re: a, im: b }).mode()?);
            }
        }
        Some(Spectrum { modes })
    }

    /// The numbers of eigenvalues with a positive and with a zero real part.
    pub fn growing(&self) -> [usize; 2] {
        let count = |sign: i32| self.modes.iter().filter(|mode| mode.place.sign() == sign).map(|mode| mode.count).sum();
        [count(1), count(0)]
    }
}

impl HalfPlane {
    /// The mode of an eigenvalue or a pair; `None` where the sign of the real part is not determined.
    fn mode(self) -> Option<Mode> {
        let count = match &self {
            HalfPlane::Real(mu) => mu.sign().filter(|sign| *sign != 0).map(|_| 1)?,
            HalfPlane::Imaginary(b) => b.sign().filter(|sign| *sign > 0).map(|_| 2)?,
            HalfPlane::Pair(mu) => mu.re.sign().filter(|sign| *sign != 0).map(|_| 2)?,
        };
        Some(Mode { place: self, count })
    }

    /// The eigenvalue with nonnegative imaginary part, rounded: (re, im), 1/s.
    pub fn point(&self) -> [f64; 2] {
        match self {
            HalfPlane::Real(mu) => [mu.to_f64(), 0.0],
            HalfPlane::Imaginary(b) => [0.0, b.to_f64()],
            HalfPlane::Pair(mu) => [mu.re.to_f64(), mu.im.to_f64()],
        }
    }

    /// The sign of the real part: -1 where the mode decays, 0 where its amplitude is constant, 1 where it grows.
    pub fn sign(&self) -> i32 {
        match self {
            HalfPlane::Real(mu) => mu.sign().unwrap_or(0),
            HalfPlane::Imaginary(_) => 0,
            HalfPlane::Pair(mu) => mu.re.sign().unwrap_or(0),
        }
    }
}
