//! Modes from numerical eigenvalues; the thresholds of step sizes are exact for these numbers.

use algebra::complex::Rectangle;
use algebra::real::Enclosure;
use mechanics::one_step_stability::{HalfPlane, Mode};

/// The precision of the thresholds, bits.
const BITS: usize = 128;

/// Eigenvalues and real parts below this fraction of the largest are rounding.
const ROUNDING: f64 = 1e-9;

/// The modes of the nonzero eigenvalues, given by real and imaginary parts in 1/s, and the number of zero ones. If the
/// energy is conserved, eigenvalues come in pairs mu, -mu: real parts of the size of rounding are then zero.
///
/// # Errors
/// A real part that vanishes without a known reason, or a NaN.
pub fn modes(eigenvalues: &[[f64; 2]], keeps_energy: bool) -> Result<(Vec<Mode>, usize), String> {
    let largest = eigenvalues.iter().map(|[re, im]| re.hypot(*im)).fold(0.0, f64::max);
    let is_zero = |[re, im]: &[f64; 2]| re.hypot(*im) <= ROUNDING * largest;
    let number = |value: f64| Enclosure::float(value, BITS).ok_or("an eigenvalue is no number".to_owned());
    let mut modes = Vec::new();
    // one of each conjugate pair
    for [re, im] in eigenvalues.iter().filter(|value| !is_zero(value) && value[1] >= 0.0).copied() {
        let place = match (im == 0.0, re.abs() <= ROUNDING * largest) {
            (true, _) => HalfPlane::Real(number(re)?),
            (false, true) if keeps_energy => HalfPlane::Imaginary(number(im)?),
            (false, true) => {
                return Err(format!("a real part is zero without a known reason, at the imaginary part {im} 1/s"));
            }
            (false, false) => HalfPlane::Pair(Rectangle { re: number(re)?, im: number(im)? }),
        };
        modes.push(Mode { place, count: if im == 0.0 { 1 } else { 2 } });
    }
    Ok((modes, eigenvalues.iter().filter(|value| is_zero(value)).count()))
}

#[cfg(test)]
mod tests {
    use super::super::chart::rows;
    use super::modes;
    use mechanics::one_step_stability::Judgement;

    /// The largest step size, s, up to which each method preserves stability and instability.
    fn correct(eigenvalues: &[[f64; 2]], keeps_energy: bool) -> Vec<(String, Result<Option<f64>, Judgement>)> {
        let (modes, _) = modes(eigenvalues, keeps_energy).expect("they have modes");
        let most =
            |steps: &mechanics::one_step_stability::Steps| steps.correct().map(|most| most.map(|most| most.to_f64()));
        rows(&modes)
            .into_iter()
            .map(|row| (row.method.to_string(), most(&row.steps.expect("they are apart"))))
            .collect()
    }

    #[test]
    fn thresholds_are_those_of_the_methods_in_closed_form() {
        // a decaying mode with a zero eigenvalue, and an oscillator
        let fading = correct(&[[-3.0, 0.0], [0.0, 0.0]], false);
        let of = |all: &[(String, Result<Option<f64>, Judgement>)], name: &str| {
            all.iter().find(|(own, _)| own == name).map(|(_, most)| *most).expect("it is there")
        };
        let Ok(Some(euler)) = of(&fading, "Euler") else { panic!("{fading:?}") };
        assert!((euler - 2.0 / 3.0).abs() < 1e-15);
        assert_eq!(of(&fading, "backward Euler"), Ok(None));
        let oscillating = correct(&[[1e-15, 2.0], [1e-15, -2.0]], true);
        assert_eq!(of(&oscillating, "Euler"), Err(Judgement::Invents));
        assert_eq!(of(&oscillating, "backward Euler"), Err(Judgement::Damps));
        assert_eq!(of(&oscillating, "implicit midpoint"), Ok(None));
        assert!(modes(&[[1e-15, 2.0], [1e-15, -2.0]], false).is_err());
    }
}
