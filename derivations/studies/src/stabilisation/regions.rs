//! Measured maps of the gains for which the violation of a mechanism's constraint decays, with the exact stability
//! region.

use super::law::{Stabilised, state};
use super::schemes::{Scheme, inside_unit_circle};
use integrators::{Observer, Span, Tolerance, integrate};
use mechanics::constrained::energies::Kinematics;
use systems::crank_slider::CrankSlider;

/// The mechanism on which gains and treatments are measured: SI units.
pub const MECHANISM: CrankSlider<f64> = CrankSlider { inertia: 1.0, mass: 1.0, crank: 0.5, rod: 1.2, weight: 5.0 };

/// The behaviour of a violation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// Below a millionth of its initial size after ten steps.
    Gone,
    /// Below a thousandth after ten steps.
    Fast,
    /// Slower decay: the last hundred steps have a smaller maximum than an earlier hundred.
    Decays,
    Grows,
}

impl Fate {
    /// All behaviours, in the order of a legend.
    pub const ALL: [Fate; 4] = [Fate::Gone, Fate::Fast, Fate::Decays, Fate::Grows];

    /// The text in a legend.
    pub fn name(self) -> &'static str {
        match self {
            Fate::Gone => "measured: below a millionth after ten steps",
            Fate::Fast => "measured: below a thousandth after ten steps",
            Fate::Decays => "measured: decays",
            Fate::Grows => "measured: grows",
        }
    }
}

/// The plane of the gains (h b, h^2 k) for one method.
#[derive(Clone, Debug)]
pub struct Map {
    pub scheme: Scheme,
    /// The upper ends of the axes h b and h^2 k.
    pub most: (f64, f64),
    /// Rows from the lowest h^2 k, each over all h b, at the centres of the cells.
    pub rows: Vec<Vec<Fate>>,
    /// The exact boundary of the stability region, in pieces.
    pub edges: Vec<Vec<(f64, f64)>>,
    /// The best gains, if they are inside the map.
    pub best: Option<(f64, f64)>,
    /// The number of cells whose measured behaviour contradicts the exact condition at their centre.
    pub mistaken: usize,
}

/// The step size, s: so short that the mechanism hardly moves while a violation grows or decays.
const STEP: f64 = 2e-7;
/// The growth factor of a violation at which a run is stopped: beyond it the mechanism's response is not linear.
const LOST: f64 = 300.0;
/// The initial displacement of the slider, m.
const OFF: f64 = 1e-4;
/// The violation by a step's own error, relative to the initial violation.
const FLOOR: f64 = 1e-5;

/// The largest gains h b and h^2 k of a map: the stability region of an explicit method, a wide range of backward
/// Euler.
fn most(scheme: Scheme) -> (f64, f64) {
    match scheme {
        Scheme::Euler => (5.0, 5.0),
        Scheme::RungeKutta4 => (6.0, 12.0),
        Scheme::ImplicitMidpoint => (12.0, 12.0),
        Scheme::BackwardEuler => (60.0, 900.0),
    }
}

/// Whether the violation decays by theory.
pub fn decays(scheme: Scheme, beta: f64, kappa: f64) -> bool {
    scheme.transition(beta, kappa).is_ok_and(|matrix| inside_unit_circle(matrix).into_iter().all(|s| s > 0.0))
}

/// The map of a method with given numbers of columns and rows.
pub fn map(scheme: Scheme, columns: usize, rows: usize) -> Map {
    let most = most(scheme);
    let middle = |k: usize, of: usize, most: f64| most * (k as f64 + 0.5) / of as f64;
    let at = |r: usize, c: usize| (middle(c, columns, most.0), middle(r, rows, most.1));
    let cells = |r: usize| (0..columns).map(move |c| at(r, c));
    let measured: Vec<Vec<Fate>> =
        (0..rows).map(|r| cells(r).map(|(beta, kappa)| fate(scheme, beta, kappa)).collect()).collect();
    let told = (0..rows).flat_map(cells).zip(measured.iter().flatten());
    let mistaken =
        told.filter(|((beta, kappa), fate)| decays(scheme, *beta, *kappa) == (**fate == Fate::Grows)).count();
    let best = scheme.best().filter(|best| best.0 < most.0 && best.1 < most.1);
    Map { scheme, most, rows: measured, edges: edges(scheme, most), best, mistaken }
}

/// The behaviour of a violation with the gains (h b, h^2 k), by a run of the mechanism from a violated constraint.
pub fn fate(scheme: Scheme, beta: f64, kappa: f64) -> Fate {
    let law = Stabilised { system: &MECHANISM, damping: beta / STEP, stiffness: kappa / (STEP * STEP) };
    let (angle, spin) = (0.7, 6.0);
    let place = MECHANISM.slider(angle);
    let still = Kinematics::of(&MECHANISM, &state::<f64, 2>(0.0, &[angle, place, spin, 0.0]));
    let start = [angle, place + OFF, spin, -still.rate[0] / still.rows[0][1]];
    let mut watched = Watched { first: size(&start), sizes: [0.0; STEPS], count: 0 };
    let span = Span::new(0.0, STEP * STEPS as f64, &start);
    let outcome = integrate(&law, scheme.method(STEPS as u32), &Tolerance::both(1e-9), &span, &mut watched);
    let seen = &watched.sizes[..watched.count];
    // maxima over windows, because the size of a violation that rotates in the plane of (f, h f') is not monotonic
    let most = |window: std::ops::Range<usize>| seen[window].iter().copied().fold(0.0, f64::max);
    let gone = seen.last().is_some_and(|last| *last < FLOOR);
    if !gone && (!outcome.reached() || most(STEPS - WINDOW..STEPS) >= most(WINDOW..2 * WINDOW)) {
        return Fate::Grows;
    }
    match seen.get(9) {
        Some(ten) if *ten > 1e-3 => Fate::Decays,
        Some(ten) if *ten > 1e-6 => Fate::Fast,
        _ => Fate::Gone,
    }
}

/// The number of steps of a run, and of each window over which the size of the violation is compared.
const STEPS: usize = 400;
const WINDOW: usize = 100;

/// The size of the violation after each step, relative to the initial one.
struct Watched {
    first: f64,
    sizes: [f64; STEPS],
    count: usize,
}

impl Observer<f64> for Watched {
    fn step(&mut self, _time: f64, y: &[f64]) {
        if let Some(seen) = self.sizes.get_mut(self.count) {
            *seen = size(y) / self.first;
            self.count += 1;
        }
    }

    fn enough(&self) -> bool {
        self.count >= 10 && !(FLOOR..LOST).contains(&self.sizes[self.count - 1])
    }
}

/// The size of (f, h f').
fn size(y: &[f64]) -> f64 {
    let found = Kinematics::of(&MECHANISM, &state::<f64, 2>(0.0, y));
    found.value[0].hypot(STEP * found.rate[0])
}

/// The exact boundary: for each beta the values of kappa, joined into the uppermost curve, the next one and so on.
fn edges(scheme: Scheme, most: (f64, f64)) -> Vec<Vec<(f64, f64)>> {
    const FINE: usize = 600;
    let mut pieces: Vec<Vec<(f64, f64)>> = Vec::new();
    for column in 1..FINE {
        let beta = most.0 * column as f64 / FINE as f64;
        let place = |row: usize| most.1 * (row as f64 + 0.5) / FINE as f64;
        let inside = |row: usize| decays(scheme, beta, place(row));
        // from above, because the upper curve continues where a lower one begins
        for (number, row) in (1..FINE).rev().filter(|row| inside(*row) != inside(row - 1)).enumerate() {
            let (mut low, mut high) = (place(row - 1), place(row));
            let below = decays(scheme, beta, low);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if decays(scheme, beta, middle) == below { low = middle } else { high = middle }
            }
            pieces.resize_with(pieces.len().max(number + 1), Vec::new);
            pieces[number].push((beta, low));
        }
    }
    pieces
}
