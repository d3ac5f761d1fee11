//! A synchronous motor under load: folds, slipping motions, and basins of attraction.

mod basin;
mod folds;
mod repeating;
mod slipping;

use dalembert_derivations::studies::scene::Scene;
use dalembert_derivations::studies::synchronism::loaded::Loaded;
use reader::Family;

fn scene(name: &str) -> Scene {
    Scene::open(std::path::Path::new(&format!("scenes/{name}.toml"))).expect("the scene is sound")
}

fn loaded(scene: &Scene) -> Loaded {
    Loaded::of(scene).expect("it follows its field")
}

/// The equation g'' = -damping (g' + 10) - sin g - load: a motor without currents in dimensionless form.
fn pendulum(damping: f64) -> Scene {
    let text = format!(
        r#"
        title = "A motor in its own units"
        description = "A pendulum with damping and a constant torque."
        system = "bench"
        rotor = {{ axial = "1 kg m^2" }}
        machine = {{ model = "synchronous", field_speed = "10 rad/s", b0 = "1 N m", f = "{damping:e} N m s" }}
        start = {{ rotor_angle = "0 rad", rotor_speed = "10 rad/s" }}
        run = {{ span = "1 s", samples = 1, tolerance = 1e-9, outputs = ["slip"] }}
        "#
    );
    Scene::parse("pendulum.toml", &text).unwrap_or_else(|error| panic!("{error}"))
}
