//! Fuzz tests of whole files.

use super::texts::{BALL, EVERYTHING, MACHINE, MOTORS};
use super::{Drawn, changed};
use dalembert_scenes::conformance::conform;
use dalembert_scenes::regulator::regulated;
use dalembert_scenes::{ModelScene, regimes};
use simulation::{Choice, IvpScene};
use std::time::{Duration, Instant};

const TEXTS: [&str; 14] = [
    EVERYTHING,
    MACHINE,
    MOTORS,
    BALL,
    include_str!("../../../../scenes/models/cart_pole.toml"),
    include_str!("../../../../scenes/models/leaning_ladder.toml"),
    include_str!("../../../../scenes/models/geared_motor.toml"),
    include_str!("../../../../scenes/models/bouncing_ball.toml"),
    include_str!("../../../../scenes/models/dry_friction.toml"),
    include_str!("../../../../scenes/models/double_pendulum.toml"),
    include_str!("../../../../scenes/models/rolling_disc.toml"),
    include_str!("../../../../scenes/models/slider_crank.toml"),
    include_str!("../../../../scenes/models/cart_with_two_links.toml"),
    include_str!("../../../../scenes/models/chaplygin_sleigh.toml"),
];

/// The resident memory of the process in MB; `None` on systems that do not report it.
fn resident() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS"))?;
    line.split_whitespace().nth(1)?.parse::<f64>().ok().map(|kilobytes| kilobytes / 1024.0)
}

/// The longest time for one file, from text to the end of a run that is limited to a tenth of a second.
const LONGEST: Duration = Duration::from_secs(5);

#[test]
fn whatever_stands_in_a_file_it_is_read_or_refused_with_reasons() {
    let rounds = std::env::var("FUZZ_ROUNDS").ok().and_then(|rounds| rounds.parse().ok()).unwrap_or(4_000);
    let mut drawn = Drawn(36);
    let (mut read, mut refused, mut longest) = (0, 0, Duration::ZERO);
    for round in 0..rounds {
        if round % 10_000 == 0 && rounds > 10_000 {
            println!("{round}: {:?} MB, {read} read, {refused} refused, longest {longest:?}", resident());
        }
        let text = changed(TEXTS[round % TEXTS.len()], &mut drawn);
        let begin = Instant::now();
        match ModelScene::parse("scene.toml", &text) {
            Ok(scene) => {
                read += 1;
                assert!(scene.start.iter().all(|number| number.is_finite()), "{text}");
                let choice = Choice { samples: 4, allowed: Duration::from_millis(100), ..scene.run().choice() };
                let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
                assert!(trajectory.outcome.state.iter().all(|number| number.is_finite()), "{text}");
                if let Ok(found) = regimes((*scene.model).clone()) {
                    let values = found.regimes.iter().flat_map(|regime| &regime.margins).map(|margin| margin.value);
                    assert!(values.into_iter().all(f64::is_finite), "{text}");
                }
                assert_eq!(conform(&scene.model).len(), 7, "{text}");
                if let Ok(found) = regulated(&scene, Duration::from_millis(100)) {
                    let numbers = found.gains.iter().chain(found.value.iter()).chain([&found.predicted]);
                    assert!(numbers.copied().all(f64::is_finite), "{text}");
                }
            }
            Err(error) => {
                refused += 1;
                assert!(!error.issues.is_empty() && !error.to_string().is_empty(), "{text}");
            }
        }
        longest = longest.max(begin.elapsed());
        assert!(begin.elapsed() < LONGEST, "{:?}\n{text}", begin.elapsed());
    }
    println!("{rounds}: {:?} MB, {read} read, {refused} refused, longest {longest:?}", resident());
    assert!(read > 200 && refused > 200, "{read} {refused}");
}

/// Each model has different decimals with seventeen digits, in powers and products of hundreds of digits. Stored exactly, their constants would
/// take 6 KB for each model and never be freed.
#[test]
fn long_constants_leave_memory_flat() {
    let text = |k: usize| {
        let digits = format!("{:.16}", 1.2 + k as f64 * 1.234567891234567e-5);
        format!(
            "title = \"A mass\"\n[parameters]\nm = \"2 kg\"\n[coordinates]\nx = \"m\"\n\
             [bodies.b]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n\
             [[force]]\non = \"b\"\nis = \"(1 N)*({digits}^40 - {digits}^39*{digits})*N.x - (1 N)*(x/(1 m))*{digits}^23/{digits}^21*N.x\"\n\
             [start]\nx = \"1 m\"\n[run]\nspan = \"1 s\"\n"
        )
    };
    let (warm, all) = (200, 2_200);
    let mut before = None;
    for k in 0..all {
        if k == warm {
            before = resident();
        }
        let scene = ModelScene::parse("scene.toml", &text(k)).unwrap_or_else(|error| panic!("{error}"));
        let mut rates = [0.0; 2];
        integrators::Ode::<f64>::rates(&*scene.system, 0.0, &[1.0, 0.0], &mut rates);
        let digit = 1.2 + k as f64 * 1.234567891234567e-5;
        assert!((rates[1] + digit * digit / 2.0).abs() < 1e-11, "{k}: {rates:?}");
    }
    let (Some(before), Some(after)) = (before, resident()) else { return };
    let per_model = (after - before) * 1024.0 / (all - warm) as f64;
    println!("{per_model} KB a model");
    assert!(per_model < 1.5, "{per_model} KB a model stay");
}
