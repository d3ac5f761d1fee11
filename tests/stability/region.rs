//! Maps of all motions over two data, compared with single scenes, exact columns, and the discriminant.

use dalembert_derivations::studies::scene::{Scene, Setup};
use dalembert_derivations::studies::stationary::energies::{Energies, Kept};
use dalembert_derivations::studies::stationary::motions::{Stationary, decimals};
use dalembert_derivations::studies::stationary::motor::MotorStates;
use dalembert_derivations::studies::stationary::stability::datum::Datum;
use dalembert_derivations::studies::stationary::stability::plane::{Cell, Plane};
use dalembert_derivations::studies::stationary::stability::reduced::Fate;
use dalembert_derivations::studies::stationary::stability::region::line::Link;
use dalembert_derivations::studies::stationary::stability::region::{
    Atlas, Border, Change, Class, Node, NodeMotions, Region,
};
use dalembert_derivations::systems::gyrostat::Gyrostat;
use field::{Rational, Scalar};
use mechanics::linear_stability::{derivative, resultant};
use nalgebra::Matrix3;
use reader::Family;
use std::path::Path;

fn scene(name: &str) -> Scene {
    Scene::open(&Path::new("scenes").join(name).with_extension("toml")).unwrap()
}

/// One column over the second datum.
fn column(scene: &Scene, names: [&str; 2], ranges: [[f64; 2]; 2], speed: f64, rows: usize) -> (Vec<Node>, Vec<Border>) {
    let [first, second] = names.map(|name| Datum::named(scene, name).unwrap());
    let region = Region::of(scene, [(&first, ranges[0]), (&second, ranges[1])], speed, [1, rows]).unwrap();
    let nodes = region.column(0).unwrap();
    let links = region.links(&nodes.iter().collect::<Vec<_>>(), 1).unwrap();
    (nodes, links.into_iter().flat_map(|link| link.borders).collect())
}

fn with_bodies(scene: &Scene, change: impl Fn(&mut Gyrostat<f64>)) -> Scene {
    let mut other = scene.clone();
    if let Setup::Gyrostat(bodies) = &mut other.system {
        change(bodies);
    }
    other
}

/// Asserts that a node's motions and verdicts equal those of the scene with its data, at the stable angles of the
/// motor.
fn as_alone(node: &Node, alone: &Scene, speed: f64) {
    let all = Stationary::of(alone).unwrap();
    let held: Vec<bool> = match &all.motor {
        MotorStates::InStep { angles, .. } => angles.iter().map(|angle| angle.slope < 0).collect(),
        _ => vec![true],
    };
    let answers = all.at_speed(speed).unwrap();
    let found: Vec<_> = answers.iter().flat_map(|answer| &answer.found).collect();
    assert_eq!(node.isolated().len(), found.len());
    for here in node.isolated() {
        let same = found.iter().find(|found| (found.direction - here.direction).norm() < 1e-12).unwrap();
        let verdicts = same.stability.iter().zip(&held).filter(|(_, held)| **held).map(|(judged, _)| judged.verdict);
        assert_eq!((vec![here.verdict], here.kind), (verdicts.collect(), same.kind));
    }
}

#[test]
fn nodes_are_judged_as_scenes_that_have_their_data() {
    let at = |name: &str, speed: f64, centre: f64| {
        let scene = scene(name);
        let ranges = [[speed - 1.0, speed + 1.0], [centre - 0.001, centre + 0.001]];
        let (nodes, _) = column(&scene, ["omega0", "carrier.centre.1"], ranges, 0.0, 1);
        assert_eq!(nodes[0].values, [speed, centre]);
        as_alone(&nodes[0], &with_bodies(&scene, |bodies| bodies.carrier.centre.x = centre), speed);
        nodes[0].isolated().len()
    };
    // a damper with all bars; an irrational speed; a rotor whose own momentum is conserved
    assert_eq!(
        [at("spin_up", 60.0, 0.004), at("asynchronous_drive", 40.0, -0.003), at("free_rotor", 7.0, 0.01)],
        [6, 4, 2]
    );
}

#[test]
fn a_verdict_is_bracketed_about_the_edge_that_is_known_exactly() {
    let scene = scene("closed_forms/upright_rotation");
    let (names, range) = (["omega0", "rotor_speed"], [-1800.0, 2100.0]);
    let (nodes, borders) = column(&scene, names, [[2.0, 4.0], range], 0.0, 61);
    for side in [1.0, -1.0] {
        let [first, second] = names.map(|name| Datum::named(&scene, name).unwrap());
        let plane = Plane::of(&scene, [&first, &second], 0.0, side > 0.0).unwrap();
        let Cell::Decided(exact) = plane.cell(3.0, range).unwrap() else { panic!("W is given") };
        let expected = |fate: Fate| match fate {
            Fate::ByEnergy => Class::Stable,
            Fate::ByGyroscopes => Class::Gyroscopic,
            _ => Class::Unstable,
        };
        let place = |node: &Node| node.isolated().iter().position(|here| here.direction.z == side).unwrap();
        for node in &nodes {
            assert_eq!(
                Class::from(node.isolated()[place(node)].verdict),
                expected(exact.at(node.values[1])),
                "{node:?}"
            );
        }
        let changes = exact.edges.iter().zip(exact.fates.windows(2)).filter(|(_, fates)| fates[0] != fates[1]);
        let changes: Vec<f64> = changes.map(|(edge, _)| edge.at).collect();
        let own = borders.iter().filter(|border| {
            let node = nodes.iter().rfind(|node| node.values[1] <= border.between[0][1]).unwrap();
            // where a tilt does not change the energy, a pair of motions branches off, and the number of motions
            // changes
            border.change != Change::PullOut && border.of == (0, place(node))
        });
        let brackets: Vec<[f64; 2]> = own.map(|border| border.between.map(|values| values[1])).collect();
        assert!(!changes.is_empty());
        let inside = |[low, high]: [f64; 2], edge: f64| low <= edge && edge <= high && high - low < 64.0 / 31.0;
        for edge in changes {
            assert!(brackets.iter().any(|bracket| inside(*bracket, edge)), "{edge} {brackets:?}");
        }
        for bracket in &brackets {
            assert!(exact.edges.iter().any(|edge| inside(*bracket, edge.at)), "{bracket:?}");
        }
    }
}

/// The discriminant of |adj(K - x) b|^2 - det(K - x)^2 at an angular velocity.
fn discriminant(energies: &Energies<Rational>, speed: Rational, kept: Rational) -> i32 {
    let (tensor, share) = energies.quadratic(Kept::RelativeSpeed);
    let (k, b) = (tensor * (speed * speed), share * (speed * kept) + energies.weight);
    let adjugate = |m: Matrix3<Rational>| mechanics::rotation::adjugate(&m);
    let (minors, one) = (adjugate(k), Rational::int(1));
    let numerator = [minors * b, k * b - b * k.trace(), b];
    let seen = [mechanics::rotation::determinant(&k), -minors.trace(), k.trace(), -one];
    let coefficient = |power: usize| {
        let pairs = |most: usize| (0..=most).filter(move |i| *i <= power && power - i <= most);
        let above = pairs(2).fold(Rational::int(0), |sum, i| sum + numerator[i].dot(&numerator[power - i]));
        pairs(3).fold(above, |sum, i| sum - seen[i] * seen[power - i])
    };
    let polynomial: Vec<Rational> = (0..=6).rev().map(coefficient).collect();
    resultant(&polynomial, &derivative(&polynomial), &one).sign().unwrap()
}

#[test]
fn motions_merge_where_the_discriminant_vanishes() {
    let scene = scene("constant_speed");
    let (_, borders) = column(&scene, ["rotor_speed", "omega0"], [[149.0, 151.0], [5.0, 65.0]], 0.0, 8);
    let Setup::Gyrostat(bodies) = &scene.system else { panic!("it has bodies") };
    let energies = Energies::of(&decimals(bodies));
    let mut folds: Vec<[f64; 2]> = borders
        .iter()
        .filter(|border| border.change == Change::Fold)
        .map(|border| border.between.map(|v| v[1]))
        .collect();
    // each border is found from both motions that merge
    assert_eq!(folds.len() % 2, 0);
    folds.dedup();
    assert!(!folds.is_empty());
    // the roots that `census` isolates by another elimination are the folds of the first kind
    let cuts: Vec<f64> =
        Stationary::of(&scene).unwrap().census()[0].as_ref().unwrap().stretches.iter().map(|s| s.to).collect();
    for border in borders.iter().filter(|border| border.change == Change::Fold) {
        let exactly = border.exactly.unwrap();
        assert!(
            cuts.contains(&exactly) && (border.between[0][1]..=border.between[1][1]).contains(&exactly),
            "{border:?}"
        );
    }
    for fold in folds {
        let [below, above] = fold.map(|w| discriminant(&energies, Rational::decimal(w), Rational::int(150)));
        assert_eq!(below * above, -1, "{fold:?}");
    }
}

#[test]
fn a_load_moves_no_axis_and_no_verdict_up_to_the_pull_out() {
    let scene = scene("spin_up");
    let [load, speed] = ["load", "omega0"].map(|name| Datum::named(&scene, name).unwrap());
    let region = Region::of(&scene, [(&load, [-0.08, 0.24]), (&speed, [5.0, 7.0])], 0.0, [2, 1]).unwrap();
    let [held, lost] = [0, 1].map(|k| region.column(k).unwrap().remove(0));
    assert_eq!((held.values[0], lost.values[0]), (0.0, 0.16));
    as_alone(&held, &scene, 6.0);
    assert!(matches!(lost.place, NodeMotions::PulledOut));
    let border = &region.links(&[&held, &lost], 0).unwrap()[0].borders[0];
    let [low, high] = border.between.map(|values| values[0]);
    // b0 - f W = 0.15 - 1e-4 150
    assert!(border.change == Change::PullOut && low <= 0.135 && 0.135 <= high && high - low < 0.006, "{border:?}");
    let atlas = Atlas::of(vec![vec![held], vec![lost]], vec![vec![]], vec![vec![], vec![]]);
    assert_eq!(atlas.branches.iter().map(|branch| branch.nodes).collect::<Vec<_>>(), [1, 1]);
}

#[test]
fn a_branch_that_folds_back_is_one_and_a_border_lies_on_the_motion_to_which_it_happens() {
    let (nodes, _) = column(&scene("free_rotor"), ["omega0", "gravity"], [[6.0, 8.0], [9.8, 9.82]], 0.0, 1);
    let [node] = &nodes[..] else { panic!("one row") };
    let joined = |borders| Link { joined: vec![[0, 0]], borders, lost: 0 };
    let border = Border { change: Change::Verdict, between: [node.values; 2], exactly: None, of: (1, 1) };
    // (0, 1) - (1, 1) - (1, 0): the second column is traversed downwards
    let rows = vec![vec![Link::default()], vec![joined(vec![])]];
    let upwards = vec![vec![Link::default()], vec![joined(vec![border])]];
    let atlas = Atlas::of(vec![vec![node.clone(); 2]; 2], rows, upwards);
    assert_eq!(atlas.branches[0].places, [[None, Some(0)], [Some(0), Some(0)]]);
    assert_eq!(atlas.branches.len(), 1 + 4 * node.isolated().len() - 3);
    let [(branch, _)] = &atlas.borders[..] else { panic!("one border") };
    assert_eq!(atlas.branches[*branch].places, [[None, None], [None, Some(1)]]);
}

#[test]
fn a_node_without_bodies_says_so_and_a_symmetric_one_that_motions_form_a_family() {
    let (nodes, _) = column(&scene("constant_speed"), ["omega0", "carrier.mass"], [[5.0, 7.0], [-3.0, 3.0]], 0.0, 2);
    assert!(matches!(nodes[0].place, NodeMotions::NoBodies) && nodes[1].isolated().len() >= 2);
    let top = scene("closed_forms/lagrange_top");
    let (nodes, _) = column(&top, ["omega0", "gravity"], [[19.0, 21.0], [9.8, 9.82]], 0.0, 1);
    let NodeMotions::Motions { families, .. } = &nodes[0].place else { panic!("{nodes:?}") };
    assert_eq!(families.len(), 1);
}

#[test]
fn an_irrational_speed_has_its_edges_beside_those_of_the_fraction_next_to_it() {
    let driven = scene("asynchronous_drive");
    let scene = Scene { system: scene("closed_forms/upright_rotation").system, ..driven };
    let Ok(MotorStates::Slipping { speeds, .. }) = MotorStates::of(&scene.machine) else { panic!("it slips") };
    let kept = speeds.iter().find(|slip| slip.slope < 0).unwrap().speed.clone();
    assert!(kept.as_rational().is_none());
    let datum = |name: &str| Datum::named(&scene, name).unwrap();
    let (first, own, second) = (datum("gravity"), datum("rotor_speed"), datum("carrier.centre.3"));
    let cell = |first: &Datum, value: f64| {
        let plane = Plane::of(&scene, [first, &second], 3.0, false).unwrap();
        match plane.cell(value, [-0.5, 0.5]).unwrap() {
            Cell::Decided(column) => column,
            Cell::PulledOut => panic!("the motor runs"),
        }
    };
    let Setup::Gyrostat(bodies) = &scene.system else { panic!("it has bodies") };
    let (irrational, beside) = (cell(&first, bodies.gravity), cell(&own, kept.to_f64()));
    assert_eq!(irrational.fates, beside.fates);
    assert!(!irrational.edges.is_empty());
    for (a, b) in irrational.edges.iter().zip(&beside.edges) {
        assert!((a.at - b.at).abs() < 1e-12 && a.neutral == b.neutral, "{a:?} {b:?}");
    }
}
