//! The band of failures above the plot: one row for each method, with the failures of all its formulations.

use super::super::{
    axis::Axis,
    drawing::{Anchor, Drawing},
    number::tolerance,
};
use super::{
    LEFT, Method, RIGHT, Work, positive,
    series::{Looks, SMALL},
};

/// All series of one method.
pub(super) struct Family<'a> {
    name: &'a str,
    /// The series with their indices in the chart.
    series: Vec<(usize, &'a Method)>,
}

/// The methods of which at least one run failed, in the order of the chart.
pub(super) fn families(series: &[Method]) -> Vec<Family<'_>> {
    let mut families: Vec<Family> = Vec::new();
    for (at, method) in series.iter().enumerate() {
        let name = method.family();
        match families.iter_mut().find(|family| family.name == name) {
            Some(family) => family.series.push((at, method)),
            None => families.push(Family { name, series: vec![(at, method)] }),
        }
    }
    families.retain(|family| family.series.iter().any(|(_, method)| !method.failures.is_empty()));
    families
}

/// Draws the markers of a method's failures with its name. Failures of unknown work are drawn at the left end.
pub(super) fn draw(drawing: &mut Drawing, family: &Family, looks: &Looks, work: Work, x: &Axis, height: f64) {
    let (mut taken, mut unknown) = (vec![LEFT, RIGHT], 0);
    for (at, method) in &family.series {
        let look = looks.series[*at];
        let mut places = Vec::new();
        drawing.open(&look.class());
        for failure in &method.failures {
            let known = positive(failure.work);
            let at = if known { x.place(failure.work) } else { LEFT + 10.0 + 12.0 * f64::from(unknown) };
            unknown += i32::from(!known);
            taken.push(at);
            places.push((at, height));
            if method.quiet {
                continue;
            }
            let spent = if known { format!("after {}", work.amount(failure.work)) } else { "work unknown".to_owned() };
            let (name, given) = (&method.name, tolerance(failure.tolerance));
            let tooltip = format!("{name} fails at tolerance {given}, {spent}: {}", failure.reason);
            look.marker(drawing, (at, height), 4.0, &tooltip);
        }
        if method.quiet {
            look.markers(drawing, &places, SMALL, &format!("{} fails", method.family()));
        }
        drawing.close();
    }
    let failed: usize = family.series.iter().map(|(_, method)| method.failures.len()).sum();
    let all: usize = family.series.iter().map(|(_, method)| method.failures.len() + method.points.len()).sum();
    let label = format!("{}: {failed} of {all}", family.name);
    let (anchor, start) = free(taken, 6.9 * label.chars().count() as f64 + 14.0);
    drawing.text((start, height + 4.5), anchor, "small said", &label);
}

/// The anchor and position of a label of this width in a row of marks: after the last mark, before the first, or in the widest gap.
fn free(mut marks: Vec<f64>, width: f64) -> (Anchor, f64) {
    marks.sort_by(f64::total_cmp);
    let gaps: Vec<(f64, f64)> = marks.windows(2).map(|pair| (pair[0], pair[1])).collect();
    let fits = |(from, to): &(f64, f64)| to - from > width;
    match (gaps.last(), gaps.first()) {
        (Some(last), _) if fits(last) => (Anchor::Start, last.0 + 11.0),
        (_, Some(first)) if fits(first) => (Anchor::End, first.1 - 11.0),
        _ => {
            let widest = gaps.iter().max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)));
            (Anchor::Middle, widest.map_or(0.5 * (LEFT + RIGHT), |gap| 0.5 * (gap.0 + gap.1)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_of_a_failing_method_covers_none_of_its_marks() {
        assert!(matches!(free(vec![LEFT, RIGHT, 100.0], 120.0), (Anchor::Start, x) if x == 111.0));
        assert!(matches!(free(vec![LEFT, RIGHT, 400.0], 120.0), (Anchor::End, x) if x == 389.0));
        assert!(matches!(free(vec![LEFT, RIGHT, 100.0, 500.0], 120.0), (Anchor::Middle, x) if x == 300.0));
    }
}
