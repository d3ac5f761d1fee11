//! Relations between points that hold in all sampled states: fixed in the ground, fixed in a common frame, on a line, at a constant
//! distance.

use super::Wheel;
use super::figure::{Figure, Symbolic};
use model::{FrameId, Model};
use nalgebra::Vector3;

type Vector = Vector3<f64>;

/// Differences of lengths below this part of the size of the system are rounding errors.
const SAME: f64 = 1e-7;

/// A link: points that are fixed in a common frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// Indices of the points; of coincident points only the first.
    pub places: Vec<usize>,
    /// The index of a frame that turns with the link.
    pub frame: usize,
    /// Indices of the bodies that contain the link.
    pub bodies: Vec<usize>,
}

impl Link {
    /// The two ends of a link with two points; `None` for other links.
    pub(super) fn pair(&self) -> Option<[usize; 2]> {
        self.places.as_slice().try_into().ok()
    }
}

/// The structure of a system; for its fields see [`super::Geometry`].
#[derive(Debug, Default)]
pub(super) struct Structure {
    pub first: Vec<usize>,
    pub ground: Vec<usize>,
    pub links: Vec<Link>,
    pub slides: Vec<(usize, Vector)>,
    pub telescopes: Vec<[usize; 2]>,
    /// Pairs of points at a constant distance but in no common frame, such as points given by sines and cosines of an angle.
    pub rods: Vec<[usize; 2]>,
    pub plane: Option<Vector>,
    pub size: f64,
    /// For each frame, the first frame that does not rotate relative to it.
    pub turning: Vec<usize>,
}

impl Structure {
    /// The structure that all samples have.
    pub fn of(model: &Model, samples: &[Figure], symbolic: &Symbolic) -> Self {
        let size = size(samples);
        let near = if size > 0.0 { SAME * size } else { SAME };
        let places = symbolic.names.len();
        let first = firsts(samples, symbolic, near);
        let turning = turning_together(model, samples);
        let mut ground = Vec::new();
        let mut links: Vec<Link> = Vec::new();
        for frame in (0..model.frames.len()).filter(|frame| turning[*frame] == *frame) {
            for class in fixed_together(samples, frame, &first, near) {
                if frame == 0 && class.contains(&first[0]) {
                    ground = class;
                } else if class.len() > 1 {
                    links.push(Link { places: class, frame, bodies: Vec::new() });
                }
            }
        }
        name_bodies(model, &mut links, (&first, &turning));
        // points on an axis of rotation are fixed in two frames: links that are part of others are dropped
        let all = links.clone();
        let is_part = |(number, link): (usize, &Link)| {
            !all.iter().enumerate().any(|(other, larger)| {
                let within = link.places.iter().all(|place| larger.places.contains(place));
                let is_first = (link.places.len(), link.bodies.is_empty(), number).cmp(&(
                    larger.places.len(),
                    larger.bodies.is_empty(),
                    other,
                ));
                let is_less = link.places.len() < larger.places.len() || is_first.is_gt();
                other != number && within && is_less && link.bodies.iter().all(|body| larger.bodies.contains(body))
            })
        };
        let links = all.iter().enumerate().filter(|(number, link)| is_part((*number, link)));
        let links = links.map(|(_, link)| link.clone()).collect();
        let moving = (0..places).filter(|place| first[*place] == *place && !ground.contains(place));
        let slides =
            moving.filter_map(|place| Some((place, line_of(samples.iter().map(|at| at.places[place]), near)?)));
        let slides = slides.collect();
        let telescope = |(place, base): (usize, &Option<(usize, FrameId)>)| {
            let (from, frame) = (*base)?;
            let turned = turning[frame.0];
            let way = |at: &Figure| within(&at.frames[turned], at.places[place] - at.places[from]);
            let is_line = turned != 0
                && line_of(samples.iter().map(way), near).is_some()
                && line_of(samples.iter().map(way).chain([Vector::zeros()]), near).is_some();
            is_line.then_some([from, place])
        };
        let telescopes = symbolic.bases.iter().enumerate().filter_map(telescope).collect();
        let rod = |(place, base): (usize, &Option<(usize, FrameId)>)| {
            let ends = [first[(*base)?.0], first[place]];
            let distance = |at: &Figure| (at.places[ends[1]] - at.places[ends[0]]).norm();
            let start = distance(&samples[0]);
            let keeps = start > near && samples.iter().all(|at| (distance(at) - start).abs() <= near);
            let mut together = all.iter().map(|link| &link.places).chain([&ground]);
            (keeps && !together.any(|places| ends.iter().all(|end| places.contains(end)))).then_some(ends)
        };
        let rods = symbolic.bases.iter().enumerate().filter_map(rod).collect();
        let plane = plane(samples, near);
        Structure { first, ground, links, slides, telescopes, rods, plane, size, turning }
    }
}

/// Links without contact points of wheels, which are fixed in the wheel only for an instant.
pub(super) fn without_touched(links: Vec<Link>, wheels: &[Wheel], model: &Model, first: &[usize]) -> Vec<Link> {
    let touches = |link: &Link, place: usize| {
        wheels.iter().any(|wheel| {
            let centre = model.bodies[wheel.body].centre.map(|centre| first[centre.0]);
            first[wheel.point] == place && centre.is_some_and(|centre| link.places.contains(&centre))
        })
    };
    let kept = links.into_iter().map(|mut link| {
        let passing: Vec<usize> = link.places.iter().copied().filter(|place| touches(&link, *place)).collect();
        link.places.retain(|place| !passing.contains(place));
        link
    });
    kept.filter(|link| link.places.len() > 1).collect()
}

/// Assigns to each link the bodies that turn with its frame and have their centre among its points.
fn name_bodies(model: &Model, links: &mut [Link], (first, turning): (&[usize], &[usize])) {
    for (number, body) in model.bodies.iter().enumerate() {
        let turned = body.frame.map_or(0, |frame| turning[frame.0]);
        for link in links.iter_mut().filter(|link| link.frame == turned) {
            let is_there = match body.centre {
                Some(centre) => link.places.contains(&first[centre.0]),
                // a body without a centre turns about the origin
                None => link.places.contains(&first[0]),
            };
            if is_there {
                link.bodies.push(number);
            }
        }
    }
}

/// For each point, the first of the points that coincide with it in all samples; points with a name come first.
fn firsts(samples: &[Figure], symbolic: &Symbolic, near: f64) -> Vec<usize> {
    let count = symbolic.names.len();
    let mut first: Vec<usize> = (0..count).collect();
    let mut known: Vec<usize> = Vec::new();
    let named = (0..count).filter(|place| !symbolic.names[*place].is_empty());
    let others = (0..count).filter(|place| symbolic.names[*place].is_empty());
    for place in named.chain(others) {
        let is_one = |other: &&usize| samples.iter().all(|at| (at.places[place] - at.places[**other]).norm() <= near);
        match known.iter().find(is_one) {
            Some(other) => first[place] = *other,
            None => known.push(place),
        }
    }
    first
}

/// For each frame, the first frame that does not rotate relative to it in all samples.
fn turning_together(model: &Model, samples: &[Figure]) -> Vec<usize> {
    let mut first: Vec<usize> = (0..model.frames.len()).collect();
    for frame in 0..model.frames.len() {
        let beside = |other: usize, at: &Figure| at.frames[frame].map(|axis| within(&at.frames[other], axis));
        let keeps = |other: &usize| {
            let start = beside(*other, &samples[0]);
            let same = |at: &Figure| {
                beside(*other, at).iter().flatten().zip(start.iter().flatten()).all(|(a, b)| (a - b).abs() <= SAME)
            };
            first[*other] == *other && samples.iter().all(same)
        };
        if let Some(other) = (0..frame).find(keeps) {
            first[frame] = other;
        }
    }
    first
}

/// Classes of points whose differences are constant in the axes of a frame.
fn fixed_together(samples: &[Figure], frame: usize, first: &[usize], near: f64) -> Vec<Vec<usize>> {
    let inside: Vec<Vec<Vector>> =
        samples.iter().map(|at| at.places.iter().map(|place| within(&at.frames[frame], *place)).collect()).collect();
    let mut classes: Vec<Vec<usize>> = Vec::new();
    for place in (0..first.len()).filter(|place| first[*place] == *place) {
        let fits = |class: &&mut Vec<usize>| {
            let other = class[0];
            let start = inside[0][place] - inside[0][other];
            inside.iter().all(|at| (at[place] - at[other] - start).norm() <= near)
        };
        match classes.iter_mut().find(fits) {
            Some(class) => class.push(place),
            None => classes.push(vec![place]),
        }
    }
    classes
}

/// The unit vector of the line on which all points lie; `None` if they coincide or are not on one line.
fn line_of(points: impl Iterator<Item = Vector>, near: f64) -> Option<Vector> {
    let points: Vec<Vector> = points.collect();
    let start = *points.first()?;
    let ways: Vec<Vector> = points.iter().map(|point| *point - start).collect();
    let far = ways.iter().copied().max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
    let size = far.norm();
    if size <= 100.0 * near {
        return None;
    }
    let along = far / size;
    let off = |way: &Vector| {
        let share = way.dot(&along);
        (way - share * along).norm()
    };
    ways.iter().all(|way| off(way) <= near).then_some(along)
}

/// The unit normal of the plane in which all points move and about which all frames turn; `None` for a motion in space.
fn plane(samples: &[Figure], near: f64) -> Option<Vector> {
    let axes = samples.first()?.frames.first()?;
    let is_normal = |normal: &Vector| {
        let start = samples[0].places.first().map_or(0.0, |place| normal.dot(place));
        let is_flat = |at: &Figure| at.places.iter().all(|place| (normal.dot(place) - start).abs() <= near);
        // each frame either does not move or has an axis along the normal
        let rests = |frame: usize| {
            let axes = &samples[0].frames[frame];
            samples.iter().all(|at| at.frames[frame].iter().zip(axes).all(|(now, then)| (now - then).norm() <= SAME))
        };
        let is_axis =
            |frame: usize, axis: usize| samples.iter().all(|at| at.frames[frame][axis].dot(normal).abs() >= 1.0 - SAME);
        samples.iter().all(is_flat)
            && (0..samples[0].frames.len()).all(|frame| rests(frame) || (0..3).any(|axis| is_axis(frame, axis)))
    };
    // a motion on a line has several normals: z, which points to the reader, is preferred
    let known = [axes[2], axes[1], axes[0]].into_iter().find(is_normal);
    known.or_else(|| {
        // an inclined plane through three points
        let places: Vec<Vector> = samples.iter().flat_map(|at| at.places.iter().copied()).collect();
        let start = *places.first()?;
        let far = places.iter().map(|place| place - start).max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
        let widest = places.iter().map(|place| far.cross(&(place - start)));
        let widest = widest.max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
        let size = widest.norm();
        (size > 0.0).then(|| widest / size).filter(is_normal)
    })
}

/// The diagonal of the largest box around all points at one time, m.
fn size(samples: &[Figure]) -> f64 {
    let of = |at: &Figure| {
        let along = |k: usize| {
            let (low, high) = at
                .places
                .iter()
                .fold((f64::MAX, f64::MIN), |(low, high), place| (low.min(place[k]), high.max(place[k])));
            high - low
        };
        Vector3::new(along(0), along(1), along(2)).norm()
    };
    samples.iter().map(of).fold(0.0, f64::max)
}

/// The components of a vector along the axes of a frame.
pub(super) fn within(axes: &[Vector; 3], vector: Vector) -> Vector {
    Vector3::from(axes.map(|axis| axis.dot(&vector)))
}
