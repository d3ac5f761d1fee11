//! Classification of the systems' constraints by Frobenius' theorem.

use dalembert_derivations::systems::knife_edge::KnifeEdge;
use dalembert_derivations::theorems::principles::{cases, letter};
use field::{Analytic, Over};
use mechanics::constrained::classify::{Kind, Unclassified, classify};
use mechanics::constrained::{Constrained, Constraint, PointSystem, State};
use symbolic::{Sym, symbols};

#[test]
fn the_rod_and_the_ladder_are_holonomic() {
    assert_eq!(cases::rod().class().unwrap().to_string(), "holonomic: 2 geometric");
    assert_eq!(cases::ladder().class().unwrap().to_string(), "holonomic: 3 geometric");
}

#[test]
fn the_steered_rod_is_holonomic_in_disguise_on_its_guide_and_nonholonomic_off_it() {
    let guided = cases::steered_rod();
    let class = guided.class().unwrap();
    assert_eq!(class.to_string(), "holonomic in disguise: 2 geometric, 1 kinematic and integrable");
    assert_eq!(class.obstruction, None);

    let free = guided.system.0;
    let [x1, y1, theta] = symbols(["x1", "y1", "theta"]);
    let point = theta.circle();
    let place = [x1, y1, x1 + free.length * point.cos, y1 + free.length * point.sin];
    let class = classify::<_, 4, 2>(&free, letter("t"), place).unwrap();
    assert_eq!(class.to_string(), "nonholonomic: 1 geometric, 1 kinematic and not integrable");
    let obstruction = class.obstruction.expect("some bracket leaves the span");
    assert!(!obstruction.fields.contains(&0), "the time has no part in it: {obstruction:?}");
}

#[test]
fn the_disc_has_two_constraints_that_are_not_integrable() {
    let class = cases::disc().class().unwrap();
    assert_eq!(class.to_string(), "nonholonomic: 4 geometric, 2 kinematic and not integrable");
}

#[test]
fn the_knife_edge_is_nonholonomic_wherever_its_centre_is() {
    let sleigh = cases::knife_edge();
    assert_eq!(sleigh.class().unwrap().to_string(), "nonholonomic: 1 geometric, 1 kinematic and not integrable");
    let centred = KnifeEdge { offset: Sym::ZERO, ..sleigh.system };
    let class = classify::<_, 4, 2>(&centred, letter("t"), sleigh.motion().state.place).unwrap();
    assert_eq!(class.kind(), Kind::Nonholonomic);
}

#[test]
fn time_and_nonlinearity_are_seen() {
    assert_eq!(cases::swing().class().unwrap().to_string(), "holonomic: 1 geometric; rheonomic: constraint 1");
    assert_eq!(
        cases::prescribed_speed_point().class().unwrap().to_string(),
        "nonlinear in the velocities: 0 geometric; nonlinear: constraint 1; rheonomic: constraint 1"
    );
}

/// Pairs of constraints on four coordinates; theory gives the class of each.
#[derive(Clone, Copy, Debug)]
enum Pair {
    /// d(x y) = 0 and d(z + x y + t^2) = 0: both integrable.
    Integrable,
    /// dz = y dx and dw = z dx (Engel): the second one cannot be classified with single brackets.
    Engel,
    /// dz = y dx and dw = dt: one nonintegrable, one integrable.
    Mixed,
    /// x y = 1 and its time derivative.
    Repeated,
    /// x = t and x = 0.
    Contradictory,
    /// dz = y dt: it contains no dx and dy, and is not integrable.
    Driven,
    /// dz = t dx: integrable at each fixed instant, but not in space and time.
    Growing,
}

impl PointSystem<4> for Pair {
    type Given = Sym;

    fn masses<S: Over<Sym>>(&self) -> [S; 4] {
        [S::one(); 4]
    }

    fn force<S: Over<Sym>>(&self, _at: &State<S, 4>) -> [S; 4] {
        [S::zero(); 4]
    }
}

impl Constrained<4, 2> for Pair {
    fn constraints<S: Over<Sym>>(&self, at: &State<S, 4>) -> [Constraint<S>; 2] {
        use Constraint::{Geometric, Kinematic};
        let (t, [x, y, z, w], [dx, dy, dz, dw]) = (at.time, at.place, at.velocity);
        match self {
            Pair::Integrable => [Kinematic(x * dy + y * dx), Kinematic(dz + x * dy + y * dx + t + t)],
            Pair::Engel => [Kinematic(dz - y * dx), Kinematic(dw - z * dx)],
            Pair::Mixed => [Kinematic(dz - y * dx), Kinematic(dw - S::one())],
            Pair::Repeated => [Geometric(x * y - S::one()), Kinematic(x * dy + y * dx)],
            Pair::Contradictory => [Geometric(x - t), Geometric(x)],
            Pair::Driven => [Kinematic(dz - y), Geometric(w)],
            Pair::Growing => [Kinematic(dz - t * dx), Geometric(w)],
        }
    }
}

fn class_of(pair: Pair) -> Result<String, Unclassified> {
    let [x, y, z, w] = symbols(["x", "y", "z", "w"]);
    let place = match pair {
        Pair::Repeated => [x, Sym::ONE / x, z, w],
        _ => [x, y, z, w],
    };
    classify::<_, 4, 2>(&pair, letter("t"), place).map(|class| class.to_string())
}

#[test]
fn what_can_be_integrated_is_counted_however_deep_the_brackets_go() {
    let expected = [
        (Pair::Integrable, "holonomic in disguise: 0 geometric, 2 kinematic and integrable; rheonomic: constraint 2"),
        (Pair::Engel, "nonholonomic: 0 geometric, 2 kinematic and not integrable"),
        (Pair::Mixed, "nonholonomic: 0 geometric, 1 kinematic and integrable, 1 kinematic and not integrable"),
        (Pair::Repeated, "holonomic: 1 geometric; redundant: constraint 2"),
        (Pair::Driven, "nonholonomic: 1 geometric, 1 kinematic and not integrable"),
        (Pair::Growing, "nonholonomic: 1 geometric, 1 kinematic and not integrable; rheonomic: constraint 1"),
    ];
    for (pair, class) in expected {
        assert_eq!(class_of(pair).as_deref(), Ok(class), "{pair:?}");
    }
}

#[test]
fn constraints_that_leave_time_no_way_to_go_on_are_refused() {
    let refused = class_of(Pair::Contradictory).unwrap_err();
    assert_eq!(refused.to_string(), "constraint 2 contradicts those before it");
}
