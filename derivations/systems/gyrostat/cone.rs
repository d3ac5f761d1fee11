//! The spherical line of the axes of rotation, traced for a picture.
//!
//! The sphere is cut into triangles (a cube blown up, each face a grid). Where the surface function changes its sign
//! along two edges of a triangle the line passes; each crossing is found by bisection, and pieces that share an edge are
//! joined. Branches closer together than a cell can be missed: this is a picture, not a count of motions.

use super::stationary::Stationary;
use nalgebra::Vector3;
use std::collections::HashMap;

/// A point of the line with its angular velocity, `None` where the denominator vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisPoint {
    pub direction: Vector3<f64>,
    /// rad/s
    pub speed: Option<f64>,
}

/// Cells along an edge of the cube.
const CELLS: i32 = 288;

/// A vertex of the grid on the cube [-CELLS, CELLS]^3.
type Vertex = [i32; 3];
/// Two vertices in order.
type Edge = (Vertex, Vertex);

impl Stationary<f64> {
    /// The pieces of the spherical line, each a connected run of points; a closed piece ends where it begins.
    pub fn spherical_line(&self) -> Vec<Vec<AxisPoint>> {
        let mut neighbours: HashMap<Edge, Vec<Edge>> = HashMap::new();
        for triangle in triangles() {
            let values = triangle.map(|vertex| self.surface(direction(vertex)));
            let crossed: Vec<Edge> = [(0, 1), (1, 2), (2, 0)]
                .into_iter()
                .filter(|&(i, j)| (values[i] >= 0.0) != (values[j] >= 0.0))
                .map(|(i, j)| ordered(triangle[i], triangle[j]))
                .collect();
            if let [a, b] = crossed[..] {
                neighbours.entry(a).or_default().push(b);
                neighbours.entry(b).or_default().push(a);
            }
        }
        let mut pieces = Vec::new();
        let mut edges: Vec<Edge> = neighbours.keys().copied().collect();
        edges.sort_unstable();
        for edge in edges {
            while let Some(next) = step(&mut neighbours, edge) {
                let mut piece = vec![edge, next];
                let mut last = next;
                while let Some(next) = step(&mut neighbours, last) {
                    piece.push(next);
                    last = next;
                }
                pieces.push(piece.into_iter().map(|edge| self.crossing(edge)).collect());
            }
        }
        pieces
    }

    /// Where the surface function vanishes on an edge.
    fn crossing(&self, (a, b): Edge) -> AxisPoint {
        let (mut low, mut high) = (direction(a), direction(b));
        let sign = self.surface(low) >= 0.0;
        for _ in 0..50 {
            let middle = (low + high).normalize();
            if (self.surface(middle) >= 0.0) == sign { low = middle } else { high = middle }
        }
        let direction = (low + high).normalize();
        let (numerator, denominator) = self.speed(direction);
        let speed = Some(numerator / denominator).filter(|speed| speed.is_finite());
        AxisPoint { direction, speed }
    }
}

/// Takes one connection from an edge, in both directions.
fn step(neighbours: &mut HashMap<Edge, Vec<Edge>>, from: Edge) -> Option<Edge> {
    let to = neighbours.get_mut(&from)?.pop()?;
    if let Some(back) = neighbours.get_mut(&to)
        && let Some(place) = back.iter().position(|edge| *edge == from)
    {
        back.swap_remove(place);
    }
    Some(to)
}

fn ordered(a: Vertex, b: Vertex) -> Edge {
    if a < b { (a, b) } else { (b, a) }
}

/// The direction of a vertex; the grid is a little off the symmetric place, where the line has its special points.
fn direction([x, y, z]: Vertex) -> Vector3<f64> {
    let even = |i: i32| (f64::from(i) / f64::from(CELLS) * std::f64::consts::FRAC_PI_4).tan();
    (Vector3::new(even(x), even(y), even(z)) + Vector3::new(1.0e-3, 1.7e-3, 2.3e-3)).normalize()
}

/// The triangles of all six faces.
fn triangles() -> impl Iterator<Item = [Vertex; 3]> {
    (0..3).flat_map(|axis| [-CELLS, CELLS].map(|side| (axis, side))).flat_map(|(axis, side)| {
        let place = move |u: i32, v: i32| {
            let mut vertex = [side; 3];
            vertex[(axis + 1) % 3] = u;
            vertex[(axis + 2) % 3] = v;
            vertex
        };
        (-CELLS..CELLS).step_by(2).flat_map(move |u| {
            (-CELLS..CELLS).step_by(2).flat_map(move |v| {
                [
                    [place(u, v), place(u + 2, v), place(u + 2, v + 2)],
                    [place(u, v), place(u + 2, v + 2), place(u, v + 2)],
                ]
            })
        })
    })
}
