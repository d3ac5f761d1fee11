//! Ladders and rods: event times with every method, and the ends of their runs.

use super::{METHODS, close, edited, events, last, runs, stored};
use integrators::Method;

#[test]
fn a_ladder_that_is_pushed_up_stops_and_stays() {
    for method in METHODS {
        let trajectory = runs(&stored("models/leaning_ladder"), method, 1e-12);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        assert_eq!(events(&trajectory).len(), 1, "{method:?} {:?}", trajectory.passages);
        close(events(&trajectory)[0], 0.232775731406606, 1e-11);
        assert!(last(&trajectory, "alpha'").abs() < 1e-14);
        let then = trajectory.passages[1].then.as_deref();
        assert_eq!(then, Some("contact `wall` sticks, contact `floor` sticks"));
    }
}

/// The climber's weight makes the ladder slip; it leaves the wall, and its top hits the floor.
#[test]
fn a_ladder_under_a_climber_slides_sticks_slips_and_leaves_the_wall() {
    for method in METHODS {
        let trajectory = runs(&stored("friction/climbed_ladder"), method, 1e-13);
        let known = [0.042382079629856, 4.411256318066544, 5.187556598732373, 5.289275395539216];
        assert_eq!(events(&trajectory).len(), known.len(), "{method:?} {:?}", trajectory.passages);
        events(&trajectory).iter().zip(known).for_each(|(found, known)| close(*found, known, 2e-9));
        let then: Vec<&str> = trajectory.passages.iter().filter_map(|one| one.then.as_deref()).collect();
        let slides = "contact `wall` slides forwards, contact `floor` slides forwards, contact `top` is apart";
        let sticks = "contact `wall` sticks, contact `floor` sticks, contact `top` is apart";
        let left = "contact `wall` is apart, contact `floor` slides forwards, contact `top` is apart";
        assert_eq!(then, [slides, sticks, slides, left], "{method:?}");
        let end = trajectory.passages.last().expect("it is told");
        assert_eq!((end.what.as_str(), &end.then), ("contact `top` closes", &None));
        let left = trajectory.left.expect("an impact ends it");
        assert!(left.contains("an impact presses other contacts"), "{left}");
    }
}

/// Each event has a row: coordinates, speeds, and outputs by the law behind the event.
#[test]
fn a_steered_rod_slides_forwards_and_back_and_stays() {
    let trajectory = runs(&stored("friction/steered_rod"), Method::DormandPrince8, 1e-13);
    assert_eq!(trajectory.stopped(), None);
    let [stops, stays] = events(&trajectory)[..] else { panic!("{:?}", trajectory.passages) };
    close(stops, 0.584190153291911, 1e-11);
    close(stays, 1.489414424306977, 1e-11);
    // normal reaction and friction while sliding forwards, backwards, and sticking
    let reactions =
        [[-47.905208614068, -9.581041722813], [-30.184183650015, 6.036836730003], [-38.967520871566, -3.258502128935]];
    for (passage, [normal, tangential]) in trajectory.passages.iter().zip(reactions) {
        let shown = |name: &str| passage.row[trajectory.column(name).expect("an output")];
        close(shown("N_guide"), normal, 1e-9);
        close(shown("T_guide"), tangential, 1e-9);
    }
}

#[test]
fn a_rod_is_retarded_evenly_until_it_stays() {
    let trajectory = runs(&stored("failures/stopping_rod"), Method::DormandPrince8, 1e-10);
    assert_eq!((trajectory.stopped(), events(&trajectory).len()), (None, 1));
    close(last(&trajectory, "T_guide"), -1.0, 1e-12);
}

/// x - l/2 ln tan(theta/2) is constant; it is computable as long as theta is not too small.
#[test]
fn a_rod_without_friction_straightens() {
    let text = edited("failures/straightening_rod", &[("span", "1 s")]);
    let trajectory = runs(&text, Method::DormandPrince8, 1e-12);
    assert_eq!((trajectory.stopped(), events(&trajectory).len()), (None, 0));
    let kept = |x: f64, theta: f64| x - 0.75 * (0.5 * theta).tan().ln();
    close(kept(last(&trajectory, "x"), last(&trajectory, "theta")), kept(0.0, 150_f64.to_radians()), 1e-5);
}
