//! The time of an animated picture: real time, or time slowed down or sped up by a round factor.

use super::Instant;
use crate::svg::drawing::{Anchor, Drawing, LINE, WIDTH};
use crate::svg::number::{coordinate, significant};

/// The least and the largest duration of an animation, in seconds.
const SEEN: (f64, f64) = (2.0, 20.0);

/// The relation between the time of the motion and the time of the animation.
pub(super) struct Timeline {
    /// The times of the first and of the last instant of the motion, in seconds.
    span: (f64, f64),
    /// The duration of the animation, in seconds.
    seconds: f64,
    /// The factor by which the animation is slower than the motion.
    slowed: f64,
    /// The factor by which the animation is faster than the motion.
    quickened: f64,
    /// The attribute `keyTimes` of unevenly spaced instants, as fractions of the duration; empty for evenly spaced ones.
    key_times: String,
}

impl Timeline {
    pub fn of(instants: &[Instant]) -> Self {
        let time = |instant: Option<&Instant>| instant.map_or(0.0, |instant| instant.time);
        let span = (time(instants.first()), time(instants.last()));
        let length = span.1 - span.0;
        let (mut slowed, mut quickened) = (1.0, 1.0);
        if length > 0.0 && length < SEEN.0 {
            slowed = round(SEEN.0 / length);
        } else if length > SEEN.1 {
            quickened = round(length / SEEN.1);
        }
        let shares: Vec<f64> = instants.iter().map(|instant| (instant.time - span.0) / length).collect();
        let even = |(number, share): (usize, &f64)| (share * (instants.len() - 1) as f64 - number as f64).abs() < 0.01;
        let key_times = match shares.iter().enumerate().all(even) || length <= 0.0 {
            true => String::new(),
            false => {
                format!(" keyTimes=\"{}\"", shares.iter().map(|share| written(*share)).collect::<Vec<_>>().join(";"))
            }
        };
        Timeline { span, seconds: length * slowed / quickened, slowed, quickened, key_times }
    }

    fn moves(&self) -> bool {
        self.seconds > 0.0
    }

    /// The SVG element that animates an attribute through these values, one per instant; empty for a still picture.
    pub fn values(&self, attribute: &str, values: &[String]) -> String {
        match self.moves() {
            false => String::new(),
            true => {
                // a browser refuses a list with an empty path; an arrow of length zero becomes a point
                let value = |value: &String| if value.is_empty() { "M0 0".to_owned() } else { value.clone() };
                let values: Vec<String> = values.iter().map(value).collect();
                let (values, key_times) = (values.join(";"), &self.key_times);
                format!("<animate attributeName=\"{attribute}\" values=\"{values}\"{key_times}{}/>", self.runs())
            }
        }
    }

    /// The SVG element that animates a transformation through these values; rotations and scalings are appended to the translation.
    pub fn transform(&self, kind: &str, values: &[String]) -> String {
        if !self.moves() {
            return String::new();
        }
        let behind = if kind == "translate" { "" } else { " additive=\"sum\"" };
        let (values, runs) = (values.join(";"), format!("{}{}", self.key_times, self.runs()));
        format!("<animateTransform attributeName=\"transform\" type=\"{kind}\" values=\"{values}\"{behind}{runs}/>")
    }

    fn runs(&self) -> String {
        format!(" dur=\"{}s\" repeatCount=\"indefinite\"", significant(self.seconds, 4))
    }

    /// Draws a bar that shows the progress of time, with the times of its ends and the speed of the animation.
    pub fn draw(&self, drawing: &mut Drawing) {
        if !self.moves() {
            return;
        }
        let (left, right, y) = (8.0, WIDTH - 8.0, drawing.height + 8.0);
        drawing.line((left, y), (right, y), "axis faint");
        let ends = [left, right].map(|x| format!("{} {}", coordinate(x), coordinate(y))).to_vec();
        let start = format!(" transform=\"translate({})\"", ends[0]);
        // the bar has two values, at its ends, between which time is uniform
        let evenly = Timeline { key_times: String::new(), ..*self };
        drawing.path_with("M0-5V5", "now", &start, &evenly.transform("translate", &ends));
        let second = |time: f64| format!("{} s", significant(time, 3));
        drawing.text((left, y + LINE + 2.0), Anchor::Start, "small", &second(self.span.0));
        drawing.text((right, y + LINE + 2.0), Anchor::End, "small", &second(self.span.1));
        drawing.text((0.5 * (left + right), y + LINE + 2.0), Anchor::Middle, "small", &self.pace());
        drawing.height = y + LINE + 8.0;
    }

    fn pace(&self) -> String {
        match (self.slowed, self.quickened) {
            (slowed, _) if slowed > 1.0 => format!("{} times slower than the motion", significant(slowed, 3)),
            (_, quickened) if quickened > 1.0 => format!("{} times quicker than the motion", significant(quickened, 3)),
            _ => "as quick as the motion".to_owned(),
        }
    }
}

/// A fraction between 0 and 1 with at most four decimals.
fn written(share: f64) -> String {
    let text = format!("{:.4}", share.clamp(0.0, 1.0));
    let text = text.trim_end_matches('0').trim_end_matches('.');
    text.strip_prefix('0').filter(|rest| !rest.is_empty()).unwrap_or(text).to_owned()
}

/// The smallest of 1, 2, 5, 10, 20, ... that is at least `least`.
fn round(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|digit| digit * power).find(|factor| *factor >= least).unwrap_or(least)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn timeline(end: f64) -> Timeline {
        Timeline::of(&[0.0, end].map(|time| Instant { time, ..Instant::default() }))
    }

    #[test]
    fn short_motions_are_slowed_and_long_ones_quickened() {
        let paces: Vec<(f64, String)> =
            [0.03, 5.0, 300.0].map(timeline).iter().map(|time| (time.seconds, time.pace())).collect();
        assert_eq!(paces[0], (3.0, "100 times slower than the motion".into()));
        assert_eq!(paces[1], (5.0, "as quick as the motion".into()));
        assert_eq!(paces[2], (15.0, "20 times quicker than the motion".into()));
    }

    #[test]
    fn instants_that_are_not_even_have_their_times() {
        let values = ["a", "b", "c"].map(String::from);
        let uneven = Timeline::of(&[1.0, 1.5, 5.0].map(|time| Instant { time, ..Instant::default() }));
        assert!(uneven.values("d", &values).contains("values=\"a;b;c\" keyTimes=\"0;.125;1\""));
        let even = Timeline::of(&[1.0, 3.0, 5.0].map(|time| Instant { time, ..Instant::default() }));
        assert!(!even.values("d", &values).contains("keyTimes"));
    }

    #[test]
    fn one_instant_moves_nothing() {
        assert_eq!(timeline(0.0).values("d", &["M0 0".into()]), "");
    }
}
