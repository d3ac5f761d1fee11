//! Eight shapes of marker, eight patterns of dashes, eight colours: a series is known by any one of them.

use super::{drawing::Drawing, number::coordinate};

const SHAPES: usize = 8;

/// How the series at this position is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Look {
    /// Chooses colour and dashes: class `s0` to `s7`.
    style: usize,
    shape: usize,
}

impl Look {
    /// Repeats after 64 series: each round of colours takes other shapes.
    pub fn of(position: usize) -> Self {
        Look { style: position % SHAPES, shape: (position + position / SHAPES) % SHAPES }
    }

    pub fn class(self) -> String {
        format!("s{}", self.style)
    }

    /// The marker about a point; `r` is about half its width.
    pub fn marker(self, drawing: &mut Drawing, (x, y): (f64, f64), r: f64, tooltip: &str) {
        let (shape, open) = outline(self.shape, r);
        let class = if open { "mark open" } else { "mark" };
        drawing.path_with_tooltip(&format!("M{} {}{shape}", coordinate(x), coordinate(y)), class, tooltip);
    }
}

/// A relative path from the centre, and whether it is lines only.
fn outline(shape: usize, r: f64) -> (String, bool) {
    let n = coordinate;
    let (small, big) = (r * 0.9, r * 1.25);
    match shape {
        0 => (format!("m{} 0a{r} {r} 0 1 0 {} 0a{r} {r} 0 1 0 {} 0z", n(-r), n(2.0 * r), n(-2.0 * r), r = n(r)), false),
        1 => (format!("m{0} {0}h{1}v{1}h{2}z", n(-small), n(2.0 * small), n(-2.0 * small)), false),
        2 => (format!("m0 {}l{} {}h{}z", n(-big), n(big), n(2.0 * r), n(-2.0 * big)), false),
        3 => (format!("m0 {}l{1} {1}l{2} {1}l{2} {2}z", n(-1.4 * r), n(1.4 * r), n(-1.4 * r)), false),
        4 => (format!("m0 {}l{} {}h{}z", n(big), n(big), n(-2.0 * r), n(-2.0 * big)), false),
        5 => (format!("m{} 0h{}m{} {}v{}", n(-big), n(2.0 * big), n(-big), n(-big), n(2.0 * big)), true),
        6 => (format!("m{0} {0}l{1} {1}m{2} 0l{1} {2}", n(-r), n(2.0 * r), n(-2.0 * r)), true),
        _ => (
            format!("m{} {}l{} {}h{}l{} {}z", n(-r), n(-0.6 * r), n(r), n(1.9 * r), n(0.0), n(r), n(-1.9 * r))
                + &format!("m{} {}h{}", n(0.0), n(0.0), n(2.0 * r)),
            false,
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_of_64_series_look_alike() {
        let looks: Vec<_> = (0..64).map(Look::of).collect();
        assert!((0..64).all(|i| (0..i).all(|j| looks[i] != looks[j])));
    }
}
