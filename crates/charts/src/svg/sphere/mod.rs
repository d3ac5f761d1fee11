//! Curves and points on the unit sphere in orthographic projection. On a page the reader can rotate the sphere.

mod circle;
mod scale;
mod strand;
mod view;

use super::drawing::{Anchor, Drawing, LINE, WIDTH, left_out};
use super::marker::Look;
use circle::Circle;
use scale::Scale;
use strand::Strand;
use view::View;

/// Directions in space, drawn as curves and marked points of the unit sphere.
#[derive(Clone, Debug, Default)]
pub struct Sphere {
    pub title: String,
    /// A description, as text.
    pub description: String,
    /// Data next to the picture: names and values, as texts.
    pub facts: Vec<(String, String)>,
    /// The quantity that colours the curves, as plain text with its unit.
    pub value: String,
    /// The names of the three axes, as plain text.
    pub axes: [String; 3],
    /// The length that the radius of the sphere stands for, where curves lie in space and not on the sphere; `None` for curves on the sphere.
    /// Parts farther than one and a half radii from the centre are left out.
    pub length: Option<f64>,
    pub curves: Vec<Curve>,
    pub marks: Vec<Mark>,
    /// The initial view: azimuth from the first axis, and elevation above the plane of the first two axes, in degrees.
    pub view: (f64, f64),
    /// The text below the picture.
    pub note: String,
}

/// A curve through directions, vectors of any length. Points may be sparse: they are joined by arcs of great circles.
#[derive(Clone, Debug, Default)]
pub struct Curve {
    pub name: String,
    /// The index of the colour, shared by curves of one class; values of such curves are shown as text only. Either all curves have a class or none.
    pub class: Option<usize>,
    pub points: Vec<CurvePoint>,
}

/// A direction, with the value of the colouring quantity there if there is one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CurvePoint {
    /// The direction, a vector of any length along the axes of the sphere.
    pub at: [f64; 3],
    pub value: Option<f64>,
}

/// A marked direction with its name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mark {
    pub name: String,
    /// The direction, a vector of any length along the axes of the sphere.
    pub at: [f64; 3],
    /// The note that is shown on hovering. Notes of hollow marks also stand below the picture, each once.
    pub note: String,
    /// Whether the mark is a ring: a direction on a curve that does not belong to the motions that the curve shows.
    pub hollow: bool,
}

pub(crate) const CENTRE: (f64, f64) = (0.5 * WIDTH, 232.0);
pub(crate) const RADIUS: f64 = 186.0;

impl Sphere {
    /// The picture as an SVG file, from the initial view.
    pub fn svg(&self) -> String {
        self.drawing().standalone(&self.title)
    }

    pub(crate) fn drawing(&self) -> Drawing {
        let (strands, dropped) = self.strands();
        let scale = self.scale();
        let view = View::new(self.view);
        let mut drawing = Drawing::default();
        drawing.circle(CENTRE, RADIUS, "ball");
        drawing.open("turning");
        for front in [false, true] {
            drawing.open(if front { "front" } else { "back" });
            let circles: String = Circle::graticule().map(|circle| circle.path(&view, front)).collect();
            drawing.path(&circles, "graticule");
            stubs().iter().chain(&strands).for_each(|strand| strand.draw(&mut drawing, &view, scale.as_ref(), front));
            for (name, axis) in self.axes.iter().zip(AXES) {
                let (x, y, depth) = view.place(axis.map(|x| 1.3 * x));
                if (depth >= 0.0) == front {
                    drawing.text((x, y + 5.0), Anchor::Middle, "axis-name", name);
                }
            }
            self.marks.iter().for_each(|mark| mark.draw(&mut drawing, &view, front));
            drawing.close();
        }
        drawing.close();
        drawing.circle(CENTRE, RADIUS, "limb");
        drawing.height = CENTRE.1 + RADIUS + 44.0;
        if let Some(scale) = &scale {
            scale.legend(&mut drawing, &self.value);
        }
        self.names(&mut drawing);
        self.holes(&mut drawing);
        let sentence = left_out(dropped, "not a direction");
        drawing.paragraph(&sentence, "small");
        drawing
    }

    /// The data of this sphere for the script of the page, as JSON.
    pub(crate) fn data(&self) -> String {
        let (strands, _) = self.strands();
        let strands: Vec<_> = strands.iter().map(Strand::json).collect();
        let marks: Vec<_> = self.marks.iter().filter_map(Mark::json).collect();
        let axes: Vec<_> = self.axes.iter().map(|name| quoted(name)).collect();
        let range = self.scale().map_or("null".to_owned(), |scale| scale.json());
        let (azimuth, height) = View::new(self.view).degrees();
        format!(
            "{{\"view\":[{azimuth},{height}],\"centre\":[{},{}],\"radius\":{RADIUS},\"range\":{range},\"value\":{},\
             \"length\":{},\"axes\":[{}],\"marks\":[{}],\"strands\":[{}]}}",
            CENTRE.0,
            CENTRE.1,
            quoted(&self.value),
            self.length.unwrap_or(1.0),
            axes.join(","),
            marks.join(","),
            strands.join(",")
        )
    }

    /// The data that all spheres of a page share: the graticule and the stubs of the axes, as JSON.
    pub(crate) fn shared_data() -> String {
        let strands: Vec<_> = strand::graticule().iter().chain(&stubs()).map(Strand::json).collect();
        format!("[{}]", strands.join(","))
    }

    /// The curves as strands, and the number of points that have no direction.
    fn strands(&self) -> (Vec<Strand>, usize) {
        let mut strands = Vec::new();
        let mut dropped = self.marks.iter().filter(|mark| strand::unit(mark.at).is_none()).count();
        for (position, curve) in self.curves.iter().enumerate() {
            let (curves, lost) = strand::curve(curve, curve.look(position), self.length);
            strands.extend(curves);
            dropped += lost;
        }
        (strands, dropped)
    }

    fn scale(&self) -> Option<Scale> {
        if self.curves.iter().any(|curve| curve.class.is_some()) {
            return None;
        }
        Scale::of(self.curves.iter().flat_map(|curve| curve.points.iter().filter_map(|point| point.value)))
    }

    /// Draws the legend of hollow marks; equal notes occur once.
    fn holes(&self, drawing: &mut Drawing) {
        let mut told: Vec<&str> = Vec::new();
        for mark in self.marks.iter().filter(|mark| mark.hollow && !mark.note.is_empty()) {
            if !told.contains(&mark.note.as_str()) {
                told.push(&mark.note);
                let y = drawing.height + 0.5 * LINE;
                drawing.circle((25.0, y), 5.0, "hole");
                drawing.text((50.0, y + 4.5), Anchor::Start, "small", &mark.note);
                drawing.height += LINE;
            }
        }
    }

    /// Draws the legend of curves that are, at least in part, not coloured by a value.
    fn names(&self, drawing: &mut Drawing) {
        let mut told: Vec<(String, &str)> = Vec::new();
        for (position, curve) in self.curves.iter().enumerate() {
            let entry = (strand::class(curve, curve.look(position)), curve.name.as_str());
            let plain = curve.class.is_some() || curve.points.iter().any(|point| point.value.is_none());
            if plain && !curve.name.is_empty() && !told.contains(&entry) {
                let y = drawing.height + 0.5 * LINE;
                drawing.line((8.0, y), (42.0, y), &entry.0);
                drawing.text((50.0, y + 4.5), Anchor::Start, "small", &curve.name);
                drawing.height += LINE;
                told.push(entry);
            }
        }
    }
}

pub(crate) const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl Curve {
    /// The colour and dashes of the curve, by its class if it has one, otherwise by its index.
    fn look(&self, position: usize) -> Look {
        Look::of(self.class.unwrap_or(position))
    }
}

impl Mark {
    /// Draws the mark with its name if it lies on the given side of the sphere.
    fn draw(&self, drawing: &mut Drawing, view: &View, front: bool) {
        let Some((x, y, depth)) = strand::unit(self.at).map(|at| view.place(at)) else { return };
        if (depth >= 0.0) != front {
            return;
        }
        let class = if self.hollow { "hole" } else { "dot" };
        let ring = format!("M{x:.1} {y:.1}m-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0z");
        drawing.path_with_tooltip(&ring, class, &self.told());
        drawing.text((x + 9.0, y - 6.0), Anchor::Start, "mark-name", &self.name);
    }

    fn told(&self) -> String {
        let parts: Vec<&str> = [&self.name, &self.note].into_iter().map(|s| &**s).filter(|s| !s.is_empty()).collect();
        parts.join(": ")
    }

    /// The JSON list `[x, y, z, name, note, hollow]`; `None` for the zero vector.
    fn json(&self) -> Option<String> {
        let at = strand::integers(strand::unit(self.at)?);
        Some(format!("[{at},{},{},{}]", quoted(&self.name), quoted(&self.told()), self.hollow))
    }
}

fn stubs() -> [Strand; 3] {
    AXES.map(strand::stub)
}

/// A text as a JSON string.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => out += &format!("\\u{:04x}", c as u32),
            c => out.push(c),
        }
    }
    out + "\""
}

/// A value in JSON with five significant digits; `null` where it is missing or not finite.
fn number(value: Option<f64>) -> String {
    match value {
        Some(value) if value.is_finite() => format!("{:e}", (format!("{value:.4e}")).parse::<f64>().unwrap_or(value)),
        _ => "null".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_that_is_no_direction_is_dropped_and_said() {
        let point = |x: f64| CurvePoint { at: [x, 0.0, 0.0], value: Some(1.0) };
        let curve = Curve { points: vec![point(0.0), point(f64::NAN), point(2.0)], ..Default::default() };
        let sphere = Sphere { curves: vec![curve], ..Default::default() };
        assert!(sphere.svg().contains("2 points left out: not a direction."));
        assert!(!sphere.data().contains("NaN"));
    }

    #[test]
    fn rings_are_explained_once() {
        let ring = |at| Mark { at, note: "no rotation".into(), hollow: true, ..Default::default() };
        let sphere = Sphere { marks: AXES.map(ring).into(), ..Default::default() };
        assert_eq!(sphere.svg().matches(">no rotation</text>").count(), 1);
        assert_eq!(sphere.data().matches("\"no rotation\",true]").count(), 3);
    }

    #[test]
    fn strings_of_the_data_are_quoted() {
        assert_eq!(quoted("a\"\\\n"), "\"a\\\"\\\\\\u000a\"");
    }

    #[test]
    fn an_empty_sphere_is_a_picture() {
        assert!(Sphere::default().svg().ends_with("</svg>"));
    }
}
