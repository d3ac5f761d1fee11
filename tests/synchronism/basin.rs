//! Which starts come into step.

use super::{pendulum, scene};
use derivations::synchronism::basin::{Share, Starts, shares};

const STARTS: Starts = Starts { angles: 6, slips: 5, slip: [-5.0, 0.0] };

fn told(all: &[Share]) -> Vec<(usize, usize, usize)> {
    all.iter().map(|share| (share.in_step, share.slipping, share.undecided())).collect()
}

#[test]
fn below_the_pull_in_all_starts_come_into_step_beyond_the_pull_out_none_between_them_some() {
    let scene = pendulum(0.2);
    // pull-in at a drag of 0.253, of which friction takes 2
    let loads = [0.1, 0.24, 0.27, 0.4, 0.6, 1.02].map(|drag| drag - 2.0);
    let found = shares(&scene, &loads, STARTS, 150.0).expect("a motor");
    println!("{:?}", told(&found));
    assert!(found[..2].iter().all(|share| share.in_step == share.starts), "{:?}", told(&found));
    assert!(found[2..5].iter().all(|share| share.in_step > 0 && share.slipping > 0), "{:?}", told(&found));
    assert!(found[5].slipping == found[5].starts, "{:?}", told(&found));
    assert!(found.iter().all(|share| share.undecided() == 0 && share.starts == 30));
    assert!(found.windows(2).all(|pair| pair[0].in_step >= pair[1].in_step));
}

#[test]
fn the_same_motor_with_all_its_bars_and_with_its_equivalent_windings_has_the_same_shares() {
    let mut scene = scene("bench");
    let starts = Starts { slip: [-150.0, 0.0], ..STARTS };
    let loads = [0.0, 0.04, 0.08, 0.12];
    let all = shares(&scene, &loads, starts, 3.0).expect("a motor");
    scene.machine = scene.machine_data.machine("equivalent_windings").expect("its data are complete");
    let lumped = shares(&scene, &loads, starts, 3.0).expect("a motor");
    println!("{:?}", all);
    assert_eq!(all, lumped);
    assert_eq!(lumped, shares(&scene, &loads, starts, 3.0).expect("a motor"));
}

#[test]
fn in_a_gyrostat_the_motor_comes_into_step_as_on_the_bench_but_for_a_lighter_rotor() {
    let starts = Starts { angles: 4, slips: 3, slip: [-150.0, 0.0] };
    let loads = [0.0, 0.06, 0.12];
    for name in ["bench", "spin_up"] {
        let found = shares(&scene(name), &loads, starts, 3.0).expect("a motor");
        println!("{name} {:?}", found);
    }
}
