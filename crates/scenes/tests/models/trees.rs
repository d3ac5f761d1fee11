//! Accelerations by recursion over a tree of bodies, compared with those from the mass matrix.

use super::{all, end, open, parsed};
use dalembert_scenes::ModelScene;
use field::{DoubleDouble, Scalar};
use integrators::Method;
use model::Trace;
use model::equations::{Equations, has_tree, solved_over_tree, vanishes};
use symbolic::{Sym, apart, substitute_all};

/// Whether both derivations give equal accelerations and multipliers: proved for all values or, if the degree is too high, to 24 digits at three
/// points. `None` if the bodies are not a tree.
fn agree(scene: &ModelScene) -> Option<bool> {
    apart(|| {
        let trace = Trace::of(&scene.model);
        let (accelerations, multipliers) = solved_over_tree(&trace)?.ok()?;
        let (by_matrix, lambda) = Equations::of(&trace).solved().ok()?;
        let pairs = accelerations.iter().zip(&by_matrix).chain(multipliers.iter().zip(&lambda));
        let differences: Vec<Sym> = pairs.map(|(a, b)| *a - *b).collect();
        let differences = substitute_all(&differences, &of_length_one(&trace));
        Some(
            accelerations.len() == by_matrix.len() && differences.into_iter().all(|one| vanishes(one) || is_small(one)),
        )
    })
}

fn is_small(difference: Sym) -> bool {
    [0.3, 0.7, 1.1].into_iter().all(|least| {
        let letter = |name: &str| least + name.bytes().map(f64::from).sum::<f64>().sin().abs();
        let value = difference.evaluate_analytic(&|name: &str| Some(DoubleDouble::from(letter(name))));
        value.is_ok_and(|value| value.hi().abs() < 1e-24)
    })
}

/// Substitutes each quaternion of a free frame by one of length one, (1 - p^2, 2 p)/(1 + p^2).
fn of_length_one(trace: &Trace<'_>) -> Vec<(Sym, Sym)> {
    let quaternions = trace.coordinates[trace.model.coordinates.len()..].chunks_exact(4);
    let turns = quaternions.enumerate().flat_map(|(number, quaternion)| {
        let p: [Sym; 3] = std::array::from_fn(|axis| Sym::symbol(&format!("p{number}{axis}")));
        let square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
        let [real, twice] = [Sym::ONE - square, Sym::int(2)].map(|part| part / (Sym::ONE + square));
        let parts = [real, twice * p[0], twice * p[1], twice * p[2]];
        quaternion.iter().copied().zip(parts).collect::<Vec<_>>()
    });
    turns.collect()
}

#[test]
fn the_tree_of_every_system_gives_the_accelerations_of_its_mass_matrix() {
    let mut with_a_tree = Vec::new();
    for path in all() {
        let scene = open(&path);
        if let Some(agree) = agree(&scene) {
            assert!(agree, "{}", path.display());
            with_a_tree.push(path.file_stem().expect("a name").to_string_lossy().into_owned());
        }
    }
    for name in
        ["double_pendulum", "cart_with_two_links", "andrews_mechanism", "rolling_disc", "tumbling_body", "pleiades"]
    {
        assert!(with_a_tree.iter().any(|known| known == name), "{name} is not among {with_a_tree:?}");
    }
}

/// Links with joints of one to six degrees of freedom, absolute and relative angles, particles, frames without a body, two bodies on one frame, points
/// displaced in axes of the ground from a turning body, follower forces and torques.
const JOINTS: &str = "title = \"joints\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"2 kg\"\nl = \"0.7 m\"\nJ = \"0.3 kg m^2\"\nK = \"0.5 kg m^2\"\n\
    g = \"9.81 m/s^2\"\nk = \"11 N/m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\na = \"rad\"\nb = \"rad\"\nc = \"rad\"\nd = \"rad\"\ns = \"m\"\nh = \"m\"\n\
    [frames]\nF = \"N free\"\nA = \"F turned a about x\"\nB = \"A turned b about y\"\nC = \"N turned c about z\"\nD = \"N turned d about y\"\n\
    [points]\nP = \"O + x*N.x + y*N.y + z*N.z\"\nQ = \"P + l*F.x\"\nR = \"Q + l*B.z\"\nS = \"R + s*B.x\"\nT = \"S + l*C.y\"\nU = \"T + h*N.z\"\n\
    V = \"U + l*D.x\"\nW = \"R + l/2*B.y\"\n\
    [bodies]\nship = { frame = \"F\", centre = \"P\", mass = \"m\", inertia = { principal = [\"J\", \"K\", \"J\"] } }\n\
    boom = { frame = \"B\", centre = \"R\", mass = \"m/2\", inertia = { principal = [\"K\", \"J\", \"J\"] } }\n\
    jib = { frame = \"B\", centre = \"W\", mass = \"m/3\", inertia = { principal = [\"J\", \"J\", \"K\"] } }\n\
    trolley = { centre = \"S\", mass = \"m/4\" }\narm = { frame = \"C\", centre = \"T\", mass = \"m\", inertia = { principal = [\"J\", \"K\", \"K\"] } }\n\
    lift = { centre = \"U\", mass = \"m\" }\ntool = { frame = \"D\", centre = \"V\", mass = \"m/5\", inertia = { principal = [\"K\", \"K\", \"J\"] } }\n\
    [[force]]\nbetween = [\"ground at O\", \"tool at V\"]\nis = \"-k*distance(O, V)\"\n[[force]]\non = \"boom at R\"\nis = \"(3 N)*B.y\"\n\
    [[torque]]\nbetween = [\"ship\", \"boom\"]\nis = \"(2 N m)*cos(b)*A.x\"\n[[force]]\nalong = \"s\"\nis = \"-k*s\"\n\
    [[constraint]]\nzero = \"(V - O) . N.x - (1 m)\"\n[run]\nspan = \"1 s\"\n";

#[test]
fn joints_of_every_kind_stand_in_one_tree() {
    assert_eq!(agree(&parsed(JOINTS)), Some(true));
}

/// A chain of hinges about z and x in turn.
fn chain(links: usize) -> String {
    let [mut coordinates, mut frames, mut points, mut bodies] = [const { String::new() }; 4];
    let (mut frame, mut point) = ("N".to_owned(), "O".to_owned());
    for k in 1..=links {
        let axis = if k % 2 == 1 { "z" } else { "x" };
        coordinates += &format!("q{k} = \"rad\"\n");
        frames += &format!("F{k} = \"{frame} turned q{k} about {axis}\"\n");
        points += &format!("P{k} = \"{point} - (0.2 m)*F{k}.y\"\n");
        bodies += &format!(
            "b{k} = {{ frame = \"F{k}\", centre = \"{point} - (0.1 m)*F{k}.y\", mass = \"(1 kg)\", \
             inertia = {{ principal = [\"(0.01 kg m^2)\", \"(0.002 kg m^2)\", \"(0.01 kg m^2)\"] }} }}\n"
        );
        (frame, point) = (format!("F{k}"), format!("P{k}"));
    }
    format!(
        "title = \"chain\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\n{coordinates}[frames]\n{frames}[points]\n{points}\
         [bodies]\n{bodies}[start]\nq1 = \"0.3 rad\"\n[run]\nspan = \"0.1 s\"\n"
    )
}

/// Each further body of a chain adds an equal number of operations.
#[test]
fn the_length_of_accelerations_grows_as_the_bodies() {
    let length = |links: usize| {
        let scene = parsed(&chain(links));
        apart(|| {
            let (accelerations, _) =
                solved_over_tree(&Trace::of(&scene.model)).expect("it is a tree").expect("it is regular");
            Sym::operations_of(&accelerations)
        })
    };
    let [ten, twenty, forty] = [10, 20, 40].map(length);
    assert_eq!(forty - twenty, 2 * (twenty - ten), "{ten}, {twenty}, {forty}");
    assert!(forty < 25_000, "{forty}");
}

/// A hundred hinges, ten times as many as the mass matrix is eliminated symbolically for, run with methods of three kinds.
#[test]
fn a_chain_of_hundred_hinges_runs_by_every_kind_of_method() {
    let scene = parsed(&chain(100));
    let [explicit, others @ ..] =
        [Method::DormandPrince8, Method::Taylor, Method::GraggBulirschStoer].map(|method| end(&scene, method, 1e-10).0);
    for other in others {
        assert!(explicit.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-6 * (1.0 + a.abs())));
    }
}

/// An angle that moves two joints, and a ball on a plane without joints: their accelerations come from the mass matrix.
#[test]
fn what_is_no_tree_is_told() {
    let geared = JOINTS.replace("N turned d about y", "N turned d + c about y");
    assert_ne!(geared, JOINTS);
    let scene = parsed(&geared);
    assert!(!apart(|| has_tree(&Trace::of(&scene.model))));
}
