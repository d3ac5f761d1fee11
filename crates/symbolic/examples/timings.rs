//! The statements of `benches/against_sympy.py`, built and decided here: median seconds as JSON, each run in a fresh
//! thread and so in an empty expression graph.

use field::Scalar;
use nalgebra::{Matrix3, Matrix4, Vector3};
use std::time::Instant;
use symbolic::linear::{determinant, solve};
use symbolic::{Hypotheses, Sym, decide, symbols};

type Statement = fn() -> Vec<Sym>;

fn main() {
    let statements: [(&str, Statement, usize); 4] = [
        ("a: determinant of the reduced inertia", reduced_inertia, 201),
        ("b: both forms agree", forms_agree, 101),
        ("c: both explicit forms agree", explicit_forms_agree, 11),
        ("d: det(AB) = det A det B, 4 x 4", product_of_determinants, 31),
    ];
    let lines: Vec<String> = statements
        .into_iter()
        .map(|(name, statement, runs)| format!("  \"{name}\": {:.3e}", median(statement, runs)))
        .collect();
    println!("{{\n{}\n}}", lines.join(",\n"));
}

/// The median time to build the statement and to prove all of its parts.
fn median(statement: Statement, runs: usize) -> f64 {
    let run = move || {
        let start = Instant::now();
        let proved = statement().into_iter().all(|part| decide(part, &Hypotheses::none()).is_zero());
        let seconds = start.elapsed().as_secs_f64();
        assert!(proved, "a true statement was not proved");
        seconds
    };
    let mut times: Vec<f64> = (0..runs).filter_map(|_| std::thread::spawn(run).join().ok()).collect();
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(f64::NAN)
}

/// det(diag(A*) - A' l l^T) = A1* A2* A3* D with D = 1 - sum A' l_i^2 / A_i*.
fn reduced_inertia() -> Vec<Sym> {
    let diagonal = symbols(["A1s", "A2s", "A3s"]);
    let l = symbols(["l1", "l2", "l3"]);
    let rotor = Sym::symbol("Ap");
    let matrix: [[Sym; 3]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| if i == j { diagonal[i] - rotor * l[i] * l[i] } else { -(rotor * l[i] * l[j]) })
    });
    let d = (0..3).fold(Sym::int(1), |d, i| d - rotor * l[i] * l[i] / diagonal[i]);
    determinant(&matrix).map(|det| det - diagonal[0] * diagonal[1] * diagonal[2] * d).into_iter().collect()
}

/// A gyrostat with a rotor on a fixed axis l and full inertia tensors in common axes.
struct Gyrostat {
    inertia: Matrix3<Sym>,
    rotor: Sym,
    axis: Vector3<Sym>,
    speed: Vector3<Sym>,
    rotor_speed: Sym,
    weight: Vector3<Sym>,
    moment: Sym,
}

impl Gyrostat {
    fn new() -> Self {
        let vector = |names: [&str; 3]| Vector3::from(symbols(names));
        let [a11, a12, a13, a22, a23, a33] = symbols(["A11", "A12", "A13", "A22", "A23", "A33"]);
        let [rotor, rotor_speed, gamma, moment] = symbols(["Ap", "dphi", "Gamma", "M"]);
        let weight = vector(["e1", "e2", "e3"]).cross(&vector(["nu1", "nu2", "nu3"])) * gamma;
        Gyrostat {
            inertia: Matrix3::new(a11, a12, a13, a12, a22, a23, a13, a23, a33),
            rotor,
            axis: vector(["l1", "l2", "l3"]),
            speed: vector(["omega1", "omega2", "omega3"]),
            rotor_speed,
            weight,
            moment,
        }
    }

    fn whole_inertia(&self) -> Matrix3<Sym> {
        self.inertia + self.axis * self.axis.transpose() * self.rotor
    }

    /// A w' in the first form, which has the rotor's speed relative to space.
    fn first_right(&self) -> Vector3<Sym> {
        let spin = self.rotor * (self.speed.dot(&self.axis) + self.rotor_speed);
        (self.inertia * self.speed + self.axis * spin).cross(&self.speed) + self.weight - self.axis * self.moment
    }

    /// A* w' + A' g'' l in the second form, which has the rotor's speed relative to the body.
    fn second_right(&self) -> Vector3<Sym> {
        (self.whole_inertia() * self.speed + self.axis * (self.rotor * self.rotor_speed)).cross(&self.speed)
            + self.weight
    }
}

/// Second form - first form - l (rotor's equation) = 0 in every component.
fn forms_agree() -> Vec<Sym> {
    let body = Gyrostat::new();
    let rate = Vector3::from(symbols(["domega1", "domega2", "domega3"]));
    let relative = Sym::symbol("ddg");
    let first = body.inertia * rate - body.first_right();
    let second = body.whole_inertia() * rate + body.axis * (body.rotor * relative) - body.second_right();
    let rotor = body.rotor * (body.axis.dot(&rate) + relative) - body.moment;
    (second - first - body.axis * rotor).iter().copied().collect()
}

/// w' from the 3 x 3 system of the first form and from the 4 x 4 system of the second.
fn explicit_forms_agree() -> Vec<Sym> {
    let body = Gyrostat::new();
    let rows = |m: Matrix3<Sym>| -> Vec<Vec<Sym>> { m.row_iter().map(|row| row.iter().copied().collect()).collect() };
    let none = Hypotheses::none();
    let mut matrix = rows(body.whole_inertia());
    for (row, l) in matrix.iter_mut().zip(body.axis.iter()) {
        row.push(body.rotor * *l);
    }
    matrix.push(body.axis.iter().map(|l| body.rotor * *l).chain([body.rotor]).collect());
    let right: Vec<Sym> = body.second_right().iter().copied().chain([body.moment]).collect();
    let first = solve(&rows(body.inertia), body.first_right().as_slice(), &none);
    let second = solve(&matrix, &right, &none);
    match (first, second) {
        (Ok(first), Ok(second)) => first.values().into_iter().zip(second.values()).map(|(a, b)| a - b).collect(),
        _ => vec![Sym::UNDEFINED],
    }
}

fn product_of_determinants() -> Vec<Sym> {
    let entries = |name: &str| {
        let name = name.to_string();
        Matrix4::from_fn(|i, j| Sym::symbol(&format!("{name}{}{}", i + 1, j + 1)))
    };
    let det = |m: Matrix4<Sym>| {
        let rows: Vec<Vec<Sym>> = m.row_iter().map(|row| row.iter().copied().collect()).collect();
        determinant(&rows).unwrap_or(Sym::UNDEFINED)
    };
    let (a, b) = (entries("a"), entries("b"));
    vec![det(a * b) - det(a) * det(b)]
}
