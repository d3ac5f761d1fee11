//! A strip below a mechanism with the axes of the ground, the direction of gravity, and the scale.

use super::camera::{Camera, arrow};
use crate::svg::drawing::{Anchor, Drawing, WIDTH};
use crate::svg::number::{coordinate, significant};

/// The length of the axes in pixels; [`FALL`] is that of the arrow of gravity.
const AXIS: f64 = 24.0;
const FALL: f64 = 26.0;
/// The height of the strip in pixels; the axes and the arrow stand at [`AXES_AT`] and [`FALL_AT`] from its left end.
const HEIGHT: f64 = 84.0;
const AXES_AT: f64 = 46.0;
const FALL_AT: f64 = 118.0;

/// Draws the strip below the drawing.
pub(super) fn compass(
    drawing: &mut Drawing,
    camera: &Camera,
    (names, gravity): (&[String; 3], [f64; 3]),
    has_scale: bool,
) {
    let middle = drawing.height + 0.5 * HEIGHT;
    drawing.open("axes");
    for (axis, name) in names.iter().enumerate().filter(|(_, name)| !name.is_empty()) {
        let mut direction = [0.0; 3];
        direction[axis] = 1.0;
        let (along, down) = camera.share(direction);
        let length = along.hypot(down);
        if length < 0.1 {
            // this axis points to the viewer or away
            drawing.circle((AXES_AT, middle), 2.6, "axis-end");
            continue;
        }
        let end = (AXES_AT + AXIS * along, middle + AXIS * down);
        drawing.path(&arrow((AXES_AT, middle), end, 5.0), "axis");
        let beyond = (end.0 + 9.0 * along / length, end.1 + 9.0 * down / length + 4.5);
        drawing.text(beyond, Anchor::Middle, "small", name);
    }
    let (along, down) = camera.share(gravity);
    if along.hypot(down) > 0.1 {
        let from = (FALL_AT - 0.5 * FALL * along, middle - 0.5 * FALL * down);
        let to = (FALL_AT + 0.5 * FALL * along, middle + 0.5 * FALL * down);
        drawing.path(&arrow(from, to, 6.0), "axis");
        drawing.text((FALL_AT + 8.0, middle + 4.5), Anchor::Start, "small", "g");
    }
    if has_scale {
        scale(drawing, camera, middle + 8.0);
    }
    drawing.close();
    drawing.height += HEIGHT;
}

/// Draws a scale bar whose length is a round number of metres.
fn scale(drawing: &mut Drawing, camera: &Camera, y: f64) {
    let most = 90.0 / camera.scale;
    let power = 10_f64.powf(most.log10().floor());
    let round = [5.0, 2.0, 1.0].into_iter().map(|digit| digit * power).find(|length| *length <= most);
    let Some(length) = round.filter(|length| length.is_finite()) else { return };
    let right = WIDTH - 16.0;
    let left = right - length * camera.scale;
    let [from, to, at] = [left, right, y].map(coordinate);
    drawing.path(&format!("M{from} {at}m0-4v8m0-4H{to}m0-4v8"), "axis");
    drawing.text((0.5 * (left + right), y - 8.0), Anchor::Middle, "small", &metres(length));
}

/// A length in metres as text with a suitable unit.
fn metres(length: f64) -> String {
    let units = [(1e3, "km"), (1.0, "m"), (1e-3, "mm"), (1e-6, "µm")];
    // centimetres are read more easily than tens of millimetres
    let (of, unit) = units.into_iter().find(|(of, _)| length >= 0.999 * of).unwrap_or((1.0, "m"));
    if unit == "mm" && length >= 0.0099 {
        return format!("{} cm", significant(100.0 * length, 2));
    }
    format!("{} {unit}", significant(length / of, 2))
}

#[cfg(test)]
mod tests {
    use super::metres;

    #[test]
    fn lengths_have_the_unit_that_people_use() {
        let shown: Vec<String> = [2000.0, 5.0, 0.2, 0.05, 0.002, 2e-5].map(metres).into();
        assert_eq!(shown, ["2 km", "5 m", "20 cm", "5 cm", "2 mm", "20 µm"]);
    }
}
