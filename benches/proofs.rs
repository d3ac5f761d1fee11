//! Seconds to derive and prove statements that a prover for mechanics must decide quickly: `cargo bench --bench
//! proofs`. `benches/peers/proofs.py` compares them with SymPy and FLINT; it requests one statement after the other
//! (`-- --answer`: symbols in, JSON out).
//!
//! Then the pages of the ledger are timed, once each.
//!
//! Every repetition builds its expressions anew, in a new thread and therefore in an empty expression graph.

use algebra::linear::determinant;
use claims::Judged;
use claims::Paper;
use claims::catalogue::papers;
use dalembert_derivations as _;
use dalembert_derivations::systems::gyrostat::{Carrier, Gyrostat, MotionInstant, Rotor};
use field::{Scalar, Tangent};
use mechanics::differentiate::along;
use mechanics::lagrange::lagrange;
use mechanics::rotation::{angular_velocity, euler, euler_forms, vertical};
use nalgebra::{Matrix3, Matrix4, Vector3};
use std::io::BufRead;
use std::time::Instant;
use symbolic::linear::solve;
use symbolic::{Hypotheses, Sym, decide, symbols};

/// A letter that names the statement, the statement in words, and a function for the seconds of each of its parts.
type Statement = (&'static str, &'static str, fn() -> Vec<f64>);

const STATEMENTS: [Statement; 7] = [
    ("a", "det A~ = A1* A2* A3* D", || vec![proving(reduced_inertia)]),
    ("b", "both forms agree, full tensors", || vec![proving(forms_agree)]),
    ("c", "w' of both forms, rational functions", || vec![proving(explicit_forms_agree)]),
    ("d", "det AB = det A det B, 4 x 4", || vec![proving(product_of_determinants)]),
    ("e", "Lagrange in Euler's angles: derived, shown to be the second form", || from_bodies().into()),
    ("f", "the same with A*, l, Ge free", || from_tensor().into()),
    ("g", "(F + 1)(F - 1) = F^2 - 1, F = (1 + x + y + z + t)^14", || vec![proving(dense_squares)]),
];

fn main() {
    if std::env::args().any(|argument| argument == "--answer") {
        for line in std::io::stdin().lock().lines().map_while(Result::ok) {
            let known = STATEMENTS.iter().find(|(letter, ..)| *letter == line.trim());
            println!("{:?}", known.map_or(Vec::new(), |(.., run)| afresh(*run)));
        }
        return;
    }
    for (letter, says, run) in STATEMENTS {
        let mut runs: Vec<Vec<f64>> = (0..15).map(|_| afresh(run)).collect();
        runs.sort_by(|a, b| a.iter().sum::<f64>().total_cmp(&b.iter().sum()));
        let parts: Vec<String> =
            runs[runs.len() / 2].iter().map(|seconds| format!("{:.3} ms", seconds * 1e3)).collect();
        println!("{letter}  {says}: {}", parts.join(" + "));
    }
    for paper in papers() {
        pages(paper);
    }
}

/// Prints the seconds to derive and prove a page of the ledger, including the cross-examination of each claim, and the
/// slowest claims.
fn pages(paper: &'static Paper) {
    let judging = move || {
        let start = Instant::now();
        let page = (paper.page)();
        let derived = start.elapsed().as_secs_f64();
        let mut clock = Instant::now();
        let mut lap = |claim: Judged| (std::mem::replace(&mut clock, Instant::now()).elapsed().as_secs_f64(), claim.id);
        let mut claims: Vec<(f64, String)> = page.judged(|_| true).map(&mut lap).collect();
        claims.sort_by(|a, b| b.0.total_cmp(&a.0));
        (derived, claims)
    };
    let (derived, claims) = std::thread::spawn(judging).join().expect("a page is judged");
    let judged: f64 = claims.iter().map(|(seconds, _)| seconds).sum();
    println!("{}: {} claims derived in {derived:.3} s, judged in {judged:.3} s; longest", paper.key, claims.len());
    for (seconds, id) in claims.iter().take(3) {
        println!("   {seconds:.3} s  {id}");
    }
}

fn afresh(run: fn() -> Vec<f64>) -> Vec<f64> {
    std::thread::spawn(run).join().expect("a true statement is proved")
}

/// The time to build the statement and to prove all its parts.
fn proving(statement: fn() -> Vec<Sym>) -> f64 {
    let start = Instant::now();
    prove(statement(), &Hypotheses::none());
    start.elapsed().as_secs_f64()
}

fn prove(parts: impl IntoIterator<Item = Sym>, under: &Hypotheses) {
    for part in parts {
        assert!(decide(part, under).is_zero(), "a true statement was not proved");
    }
}

fn vector(name: &str) -> Vector3<Sym> {
    Vector3::from_fn(|i, _| Sym::symbol(&format!("{name}{}", i + 1)))
}

fn tensor(name: &str) -> Matrix3<Sym> {
    Matrix3::from_fn(|i, j| Sym::symbol(&format!("{name}{}{}", i.min(j) + 1, i.max(j) + 1)))
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
struct Forms {
    inertia: Matrix3<Sym>,
    rotor: Sym,
    axis: Vector3<Sym>,
    speed: Vector3<Sym>,
    rotor_speed: Sym,
    weight: Vector3<Sym>,
    torque: Sym,
}

impl Forms {
    fn new() -> Self {
        let [rotor, rotor_speed, gamma, torque] = symbols(["Ap", "dphi", "Gamma", "M"]);
        Forms {
            inertia: tensor("A"),
            rotor,
            axis: vector("l"),
            speed: vector("omega"),
            rotor_speed,
            weight: vector("e").cross(&vector("nu")) * gamma,
            torque,
        }
    }

    fn whole_inertia(&self) -> Matrix3<Sym> {
        self.inertia + self.axis * self.axis.transpose() * self.rotor
    }

    /// A w' in the first form, which uses the rotor's speed relative to space.
    fn first_right(&self) -> Vector3<Sym> {
        let spin = self.rotor * (self.speed.dot(&self.axis) + self.rotor_speed);
        (self.inertia * self.speed + self.axis * spin).cross(&self.speed) + self.weight - self.axis * self.torque
    }

    /// A* w' + A' g'' l in the second form, which uses the rotor's speed relative to the body.
    fn second_right(&self) -> Vector3<Sym> {
        (self.whole_inertia() * self.speed + self.axis * (self.rotor * self.rotor_speed)).cross(&self.speed)
            + self.weight
    }
}

/// The residuals of (second form) - (first form) - l (rotor's equation), each of which must be zero.
fn forms_agree() -> Vec<Sym> {
    let body = Forms::new();
    let rate = vector("domega");
    let relative = Sym::symbol("ddg");
    let first = body.inertia * rate - body.first_right();
    let second = body.whole_inertia() * rate + body.axis * (body.rotor * relative) - body.second_right();
    let rotor = body.rotor * (body.axis.dot(&rate) + relative) - body.torque;
    (second - first - body.axis * rotor).iter().copied().collect()
}

/// The accelerations w' from the 3 x 3 system of the first form and from the 4 x 4 system of the second form.
fn explicit_forms_agree() -> Vec<Sym> {
    let body = Forms::new();
    let rows = |m: Matrix3<Sym>| -> Vec<Vec<Sym>> { m.row_iter().map(|row| row.iter().copied().collect()).collect() };
    let none = Hypotheses::none();
    let mut matrix = rows(body.whole_inertia());
    for (row, l) in matrix.iter_mut().zip(body.axis.iter()) {
        row.push(body.rotor * *l);
    }
    matrix.push(body.axis.iter().map(|l| body.rotor * *l).chain([body.rotor]).collect());
    let right: Vec<Sym> = body.second_right().iter().copied().chain([body.torque]).collect();
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

/// Two products of polynomials with 3060 terms each.
fn dense_squares() -> Vec<Sym> {
    let one = Sym::int(1);
    let power = symbols(["x", "y", "z", "t"]).into_iter().fold(one, |sum, x| sum + x).powi(14);
    vec![(power + one) * (power - one) - (power * power - one)]
}

/// Euler's angles and the rotor's angle, with their rates and accelerations.
struct Course {
    angles: [Sym; 4],
    rates: [Sym; 4],
    accelerations: [Sym; 4],
}

impl Course {
    fn new() -> Self {
        Course {
            angles: symbols(["psi", "theta", "phi", "rho"]),
            rates: symbols(["dpsi", "dtheta", "dphi", "drho"]),
            accelerations: symbols(["ddpsi", "ddtheta", "ddphi", "ddrho"]),
        }
    }

    /// The matrix W and the motion, with the carrier's angular velocity w = W q'.
    fn motion(&self, torque: Sym) -> (Matrix3<Sym>, MotionInstant<Sym>) {
        let [position, velocity, acceleration] =
            [self.angles, self.rates, self.accelerations].map(|[a, b, c, _]| [a, b, c]);
        let forms = euler_forms(along(position, velocity));
        let moving = forms * Vector3::from(along(velocity, acceleration));
        let motion = MotionInstant {
            angular_velocity: moving.map(|x| x.value),
            angular_acceleration: moving.map(|x| x.slope),
            vertical: vertical(&euler(position)),
            rotor_speed: self.rates[3],
            rotor_acceleration: self.accelerations[3],
            torque,
        };
        (forms.map(|x| x.value), motion)
    }
}

/// The second form's data in arbitrary axes.
struct Second {
    tensor: Matrix3<Sym>,
    axis: Vector3<Sym>,
    axial: Sym,
    weight: Vector3<Sym>,
}

impl Second {
    fn residuals(&self, m: &MotionInstant<Sym>) -> (Vector3<Sym>, Sym) {
        let (w, a) = (m.angular_velocity, m.angular_acceleration);
        let momentum = self.tensor * w + self.axis * (self.axial * m.rotor_speed);
        let gain = momentum.cross(&w) + self.weight.cross(&m.vertical);
        let carrier = self.tensor * a + self.axis * (self.axial * m.rotor_acceleration) - gain;
        (carrier, self.axial * (self.axis.dot(&a) + m.rotor_acceleration) - m.torque)
    }

    /// Compares the derived equations with W^T times the equations of the carrier and that of the rotor.
    fn prove(&self, derived: [Sym; 4], course: &Course, torque: Sym, under: &Hypotheses) {
        let (forms, motion) = course.motion(torque);
        let (carrier, rotor) = self.residuals(&motion);
        let carrier = forms.transpose() * carrier;
        prove((0..3).map(|i| derived[i] - carrier[i]).chain([derived[3] - rotor]), under);
    }
}

/// Seconds to derive Lagrange's equations from the bodies' data, all symbolic, and to prove that they are equivalent to
/// the second form.
fn from_bodies() -> [f64; 2] {
    let start = Instant::now();
    let [carrier_mass, mass, axial, transverse, gravity, torque] = symbols(["m0", "mr", "Ap", "Bp", "g", "M"]);
    let gyrostat = Gyrostat {
        carrier: Carrier { mass: carrier_mass, centre: vector("c"), inertia: tensor("A") },
        rotor: Rotor { mass, centre: vector("h"), axis: vector("l"), axial, transverse },
        gravity,
    };
    let course = Course::new();
    let derived = gyrostat.by_lagrange(course.angles, course.rates, course.accelerations, torque);
    let deriving = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let axis = gyrostat.rotor.axis;
    let unit = Hypotheses::none().unit_vector([axis.x, axis.y, axis.z]);
    Second { tensor: gyrostat.full_tensor(), axis, axial, weight: gyrostat.weight() }
        .prove(derived, &course, torque, &unit);
    [deriving, start.elapsed().as_secs_f64()]
}

/// Seconds for derivation and proof if the data are the tensor of all masses and the weight.
fn from_tensor() -> [f64; 2] {
    let start = Instant::now();
    let [axial, torque] = symbols(["Ap", "M"]);
    let second = Second { tensor: tensor("A"), axis: vector("l"), axial, weight: vector("c") };
    let course = Course::new();
    let energies = |[a, b, c, _]: [Tangent<Tangent<Sym>>; 4], [da, db, dc, speed]: [Tangent<Tangent<Sym>>; 4]| {
        let lift = |x: Sym| Tangent::fixed(Tangent::fixed(x));
        let turning = euler(along([a, b, c], [da, db, dc]));
        let w = angular_velocity(turning);
        let spin = lift(axial) * speed;
        let twice = w.dot(&(second.tensor.map(lift) * w)) + spin * speed;
        twice.half()
            + spin * w.dot(&second.axis.map(lift))
            + vertical(&turning.map(|x| x.value)).dot(&second.weight.map(lift))
    };
    let mut derived = lagrange(energies, course.angles, course.rates, course.accelerations);
    derived[3] -= torque;
    let deriving = start.elapsed().as_secs_f64();
    let start = Instant::now();
    second.prove(derived, &course, torque, &Hypotheses::none());
    [deriving, start.elapsed().as_secs_f64()]
}
