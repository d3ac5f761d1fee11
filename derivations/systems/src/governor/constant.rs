//! The programme of the wheel under constant torques: rho' = eps (k1/rho + k2), solved in closed form.
//!
//! For k2 = 0, rho^2 = rho_0^2 + 2 eps k1 t. Otherwise y = 1 + k2 rho/k1 satisfies y - ln y = y_0 - ln y_0 + eps k2^2
//! t/k1. Hence y = -W(-y_0 exp(-y_0 - eps k2^2 t/k1)) with the branch of Lambert's W function that contains y_0. The
//! time of the end has a closed form too: if M2 drives the wheel to rho = 0, it reaches the axis in finite time and
//! with infinite speed.

/// The data eps, k1, k2 of rho' = eps (k1/rho + k2), and rho at t = 0; all are finite, and rho_0 > 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantTorques {
    pub epsilon: f64,
    pub of_second: f64,
    pub of_first: f64,
    pub start: f64,
}

/// The long-time behaviour of the programme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ProgrammeEnd {
    /// The wheel is at rest: k1 + k2 rho_0 = 0.
    Rest,
    /// The wheel reaches the axis of the second disc at this time, s, and the motion ends. Its speed there is infinite
    /// unless k1 = 0.
    ReachesAxis { time: f64 },
    /// The wheel tends to rho = -k1/k2 from either side: k1 > 0 > k2.
    TendsTo { distance: f64 },
    /// rho grows without bound: the wheel leaves the edge of any disc.
    Grows,
}

impl ConstantTorques {
    /// The time, s, at which the wheel passes rho, by quadrature; NaN if it never does.
    pub fn time(&self, rho: f64) -> f64 {
        let Self { epsilon, of_second, of_first, start } = *self;
        if of_first == 0.0 {
            return (rho - start) * (rho + start) / (2.0 * epsilon * of_second);
        }
        if of_second == 0.0 {
            return (rho - start) / (epsilon * of_first);
        }
        let ratio = (of_first * rho + of_second) / (of_first * start + of_second);
        if ratio < 0.0 {
            return f64::NAN;
        }
        (rho - start - of_second / of_first * ratio.ln()) / (epsilon * of_first)
    }

    /// The distance rho at an instant, in closed form; `None` after the end of the motion.
    pub fn distance(&self, time: f64) -> Option<f64> {
        let Self { epsilon, of_second, of_first, start } = *self;
        match self.course() {
            ProgrammeEnd::Rest => return Some(start),
            ProgrammeEnd::ReachesAxis { time: end } if time >= end => return None,
            _ => {}
        }
        if of_first == 0.0 {
            return Some((start * start + 2.0 * epsilon * of_second * time).sqrt());
        }
        if of_second == 0.0 {
            return Some(start + epsilon * of_first * time);
        }
        let scaled = 1.0 + of_first * start / of_second;
        let level = scaled - scaled.abs().ln() + epsilon * of_first * of_first * time / of_second;
        Some((same_branch(level, scaled) - 1.0) * of_second / of_first)
    }

    /// The long-time behaviour, which the signs of the data determine.
    pub fn course(&self) -> ProgrammeEnd {
        let Self { epsilon, of_second, of_first, start } = *self;
        let pull = epsilon * (of_second + of_first * start);
        if pull == 0.0 {
            ProgrammeEnd::Rest
        } else if of_first != 0.0 && epsilon * of_second > 0.0 && epsilon * of_first < 0.0 {
            ProgrammeEnd::TendsTo { distance: -of_second / of_first }
        } else if pull < 0.0 {
            ProgrammeEnd::ReachesAxis { time: self.time(0.0) }
        } else {
            ProgrammeEnd::Grows
        }
    }
}

/// The solution y of y - ln|y| = level that has the sign of `from` and lies on the same side of 1, by Newton's method;
/// it is a value of Lambert's W function.
fn same_branch(level: f64, from: f64) -> f64 {
    // initial guesses: near 1 for a positive y above 1, near exp(-level) between 0 and 1, between two bounds for a
    // negative y
    let mut y = if from > 1.0 {
        let height = (level - 1.0).max(0.0);
        1.0 + (2.0 * height).sqrt() + height
    } else if from > 0.0 {
        let height = (level - 1.0).max(0.0);
        if height < 1.0 { 1.0 - (2.0 * height).sqrt() + 2.0 * height / 3.0 } else { (-level).exp() }
    } else {
        -(-level).exp().min(level.abs() + 1.0)
    };
    for _ in 0..64 {
        // iterate on ln|y| where the curve is steep, so that y does not change its sign
        let step =
            if y > 1.0 { (y - y.ln() - level) / (1.0 - 1.0 / y) } else { (y - y.abs().ln() - level) * y / (y - 1.0) };
        let next = if y > 1.0 { (y - step).max(1.0) } else { y * (-step / y).exp() };
        if !next.is_finite() || (next - y).abs() <= f64::EPSILON * y.abs() {
            break;
        }
        y = next;
    }
    y
}
