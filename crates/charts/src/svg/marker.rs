//! The appearance of series: twelve colours, twelve shapes of markers and twelve patterns of dashes.

use super::{
    drawing::Drawing,
    number::{Tenths, coordinate, tenths},
};

const STYLES: usize = 12;

/// The appearance of a series: its colour, the shape of its markers, its dashes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Look {
    /// The index of the CSS class for colour and dashes, `s0` to `s11`; `None` for grey.
    style: Option<usize>,
    /// The index of the shape, from 0 to 11.
    shape: usize,
    /// The index of the CSS class of other dashes, `d0` to `d11`; `None` for the dashes of `style`.
    dashes: Option<usize>,
}

/// The way in which a marker is painted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Paint {
    Full,
    /// Outlined, and filled with the colour of the background.
    Hollow,
    /// Open lines without a fill.
    Lines,
    /// The round cap of a line of zero length, the shortest way to write a circle.
    Dot,
    /// The square cap of a line of zero length.
    Block,
}

impl Look {
    /// The appearance of the series at this index. Appearances repeat after 144 series: colours repeat after twelve, with other shapes.
    pub fn of(position: usize) -> Self {
        Look { style: Some(position % STYLES), shape: (position + position / STYLES) % STYLES, dashes: None }
    }

    /// The appearance of a series in grey.
    pub fn quiet() -> Self {
        Look { style: None, shape: 0, dashes: None }
    }

    /// The appearance with the shape and the dashes of these kinds, where they are given.
    pub fn of_kind(self, shape: Option<usize>, dashes: Option<usize>) -> Self {
        let dashes = dashes.map_or(self.dashes, |kind| Some(kind % STYLES));
        Look { shape: shape.map_or(self.shape, |kind| kind % STYLES), dashes, ..self }
    }

    /// The path of a marker and the way in which it is painted. Grey markers are many and small; a circle or square is a cap of a line.
    fn drawn(self, r: f64) -> (String, Paint) {
        match (self.style, self.shape) {
            (None, 0) => ("h0".to_owned(), Paint::Dot),
            (None, 1) => ("h0".to_owned(), Paint::Block),
            _ => outline(self.shape, r),
        }
    }

    pub fn class(self) -> String {
        let colour = self.style.map_or_else(|| "quiet".to_owned(), |style| format!("s{style}"));
        self.dashes.map_or_else(|| colour.clone(), |dashes| format!("{colour} d{dashes}"))
    }

    /// Draws a marker about a point; `r` is about half its width in pixels.
    pub fn marker(self, drawing: &mut Drawing, place: (f64, f64), r: f64, tooltip: &str) {
        self.markers(drawing, &[place], r, tooltip);
    }

    /// Draws markers about several points, as one path.
    pub fn markers(self, drawing: &mut Drawing, places: &[(f64, f64)], r: f64, tooltip: &str) {
        let (shape, paint) = self.drawn(r);
        let class = match paint {
            Paint::Dot => "mark dot",
            Paint::Block => "mark block",
            Paint::Full => "mark",
            Paint::Hollow => "mark hollow",
            Paint::Lines => "mark open",
        };
        let all = repeated(&shape, places);
        if !all.is_empty() {
            drawing.path_with_tooltip(&all, class, tooltip);
        }
    }
}

/// The path of a shape repeated about several centres, with relative coordinates.
fn repeated(shape: &str, places: &[(f64, f64)]) -> String {
    let begins = shape.strip_prefix('m').map_or(0, |rest| rest.find(char::is_alphabetic).map_or(0, |at| at + 1));
    let (comes_back, mut pen) = (shape.ends_with('z') || shape == "h0", None);
    let mut path = String::new();
    for (x, y) in places.iter().map(|(x, y)| (tenths(*x).0, tenths(*y).0)) {
        path += &match pen {
            Some((from_x, from_y)) if comes_back => {
                let [dx, dy] = [x - from_x, y - from_y].map(|way| Tenths(way).to_string_tenths());
                format!("m{dx} {dy}{}", &shape[begins..])
            }
            _ => format!("M{} {}{shape}", Tenths(x).to_string_tenths(), Tenths(y).to_string_tenths()),
        };
        pen = Some((x, y));
    }
    path
}

/// The path of a marker relative to its centre.
fn outline(shape: usize, r: f64) -> (String, Paint) {
    let n = coordinate;
    let (small, big) = (r * 0.9, r * 1.25);
    let (thin, wide) = (r * 0.8, r * 1.15);
    match shape {
        0 => (circle(r), Paint::Full),
        1 => (square(small), Paint::Full),
        2 => (triangle(big, 1.0), Paint::Full),
        3 => (diamond(1.4 * r), Paint::Full),
        4 => (triangle(big, -1.0), Paint::Full),
        5 => (format!("m{} 0h{}m{} {}v{}", n(-big), n(2.0 * big), n(-big), n(-big), n(2.0 * big)), Paint::Lines),
        6 => (format!("m{0} {0}l{1} {1}m{2} 0l{1} {2}", n(-r), n(2.0 * r), n(-2.0 * r)), Paint::Lines),
        7 => (circle(r), Paint::Hollow),
        8 => (square(thin), Paint::Hollow),
        9 => (triangle(wide, 1.0), Paint::Hollow),
        10 => (diamond(1.25 * r), Paint::Hollow),
        _ => (triangle(wide, -1.0), Paint::Hollow),
    }
}

/// The path of a circle: one arc from the top that ends a tenth of a pixel from its start. Two half circles would be twice as long.
fn circle(r: f64) -> String {
    let n = coordinate;
    format!("m0 {}a{r} {r} 0 1 0 .1 0z", n(-r), r = n(r))
}

fn square(half: f64) -> String {
    let n = coordinate;
    format!("m{0}{0}h{1}v{1}h{2}z", n(-half), n(2.0 * half), n(-2.0 * half))
}

/// The path of a triangle that points up for the sign 1 and down for the sign -1.
fn triangle(half: f64, sign: f64) -> String {
    let n = coordinate;
    format!("m0 {}l{} {}h{}z", n(-sign * half), n(half), n(sign * 1.75 * half), n(-2.0 * half))
}

fn diamond(half: f64) -> String {
    let n = coordinate;
    format!("m0 {}l{1} {1}l{2} {1}l{2} {2}z", n(-half), n(half), n(-half))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shape_that_closes_is_repeated_from_its_beginning() {
        assert_eq!(repeated("m-2-2h4v4h-4z", &[(10.0, 10.0), (13.5, 9.0)]), "M10 10m-2-2h4v4h-4zm3.5 -1h4v4h-4z");
        assert_eq!(repeated("h0", &[(1.0, 2.0), (1.0, 4.0)]), "M1 2h0m0 2h0");
        assert_eq!(repeated("m-1 0h2", &[(1.0, 2.0), (2.0, 2.0)]), "M1 2m-1 0h2M2 2m-1 0h2");
    }

    #[test]
    fn no_two_of_144_series_look_alike() {
        let looks: Vec<_> = (0..144).map(Look::of).collect();
        assert!((0..144).all(|i| (0..i).all(|j| looks[i] != looks[j])));
    }
}
