//! Motors of the catalogue, and motors with laws as text, in a drive: each is compared with its compiled law.

use super::{close, last, runs};
use dalembert_scenes::ModelScene;
use field::Circle;
use integrators::Ode;
use motor::{Machine, Motor, catalogue, torque_and_current_rates};
use reader::Quantity;

const INERTIA: f64 = 0.01;

/// A scene of a rotor with the data of a motor.
fn scene(motor: &Motor) -> String {
    let unit = |quantity: &Quantity| if quantity.unit == "1" { String::new() } else { format!(" {}", quantity.unit) };
    let number = |(quantity, value): (&Quantity, f64)| format!("{} = \"{value:?}{}\"\n", quantity.name, unit(quantity));
    let counts = motor.laws().counts().iter().map(|(count, number)| format!("{} = {number}\n", count.name));
    let data: String = motor.data().map(number).chain(counts).collect();
    with_data(motor.name(), &data)
}

/// A scene of a rotor with motor data as text.
fn with_data(model: &str, data: &str) -> String {
    format!(
        "title = \"rotor\"\n[coordinates]\ntheta = \"rad\"\n[[drive]]\nname = \"motor\"\nturns = \"theta\"\ninertia = \"({INERTIA} kg m^2)\"\n\
         [drive.machine]\nmodel = \"{model}\"\n{data}[outputs]\nM = \"motor.torque\"\n[run]\nspan = \"0.1 s\"\ntolerance = 1e-10\n"
    )
}

fn sampled(model: &str) -> Motor {
    let mut number = 0;
    let value = |quantity: &Quantity| {
        number += 1;
        match &*quantity.name {
            "pole_pairs" => 2.0,
            _ => 0.3 + 0.125 * f64::from(number),
        }
    };
    catalogue::sampled(model, value, 3).unwrap_or_else(|| panic!("{model}"))
}

/// The torque and the rates of currents by the compiled law, at an angle to the field and a slip.
fn own_law(motor: &Motor, angle: f64, slip: f64, currents: &[f64]) -> (f64, Vec<f64>) {
    let mut rates = vec![0.0; motor.windings()];
    let (sin, cos) = angle.sin_cos();
    let moment = torque_and_current_rates(motor, Circle { cos, sin }, slip, &currents[..motor.windings()], &mut rates);
    (moment, rates)
}

#[test]
fn every_motor_of_the_program_has_its_own_law_in_a_drive() {
    for model in catalogue::entries().into_iter().map(|entry| entry.name) {
        let motor = sampled(model);
        let text = scene(&motor);
        if motor.prescribed_speed().is_some() {
            let said = ModelScene::parse("scene.toml", &text).expect_err("it is a constraint").to_string();
            assert!(said.contains("keeps the speed of its rotor"), "{said}");
            continue;
        }
        let scene = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{model}: {error}"));
        let (time, theta, speed) = (0.37, 0.7, 1.9);
        let currents: Vec<f64> =
            (0..scene.start.len() / 2 - 1).map(|place| 0.4 - 0.3 * f64::from(place as u32)).collect();
        let field_speed = motor.frame_speed();
        let (moment, rates) = own_law(&motor, theta - field_speed * time, speed - field_speed, &currents);
        let state = [&[theta], &vec![0.0; currents.len()][..], &[speed], &currents].concat();
        let mut found = vec![0.0; state.len()];
        Ode::<f64>::rates(&*scene.system, time, &state, &mut found);
        let accelerations = &found[state.len() / 2..];
        close(accelerations[0], moment / INERTIA, 1e-12 * (1.0 + moment.abs() / INERTIA));
        assert_eq!(rates.len(), currents.len(), "{model}");
        for (found, known) in accelerations[1..].iter().zip(&rates) {
            close(*found, *known, 1e-12 * (1.0 + known.abs()));
        }
    }
}

/// Final speed of a brushed motor: U k/(R f + k^2).
#[test]
fn a_motor_in_its_own_letters_runs_in_a_gear() {
    let data = "[drive.machine]\nmodel = \"text\"\nfield_speed = \"0 rad/s\"\ntorque_law = \"-f*phi'\"\n[drive.machine.parameters]\n\
                v = \"24 V\"\nk = \"45 mWb\"\nl = \"2 mH\"\nr = \"0.6 ohm\"\nf = \"0.1 mN m s\"\n\
                [[drive.machine.winding]]\ncurrent = \"ia\"\ninductance = \"l\"\nresistance = \"r\"\nsupply = \"v\"\nmotional = \"k\"\n";
    let text = format!(
        "title = \"gear\"\n[coordinates]\ntheta = \"rad\"\n[bodies.load]\nturns = \"theta\"\ninertia = \"(0.02 kg m^2)\"\n\
         [[drive]]\nname = \"motor\"\nturns = \"theta\"\nratio = \"10\"\ninertia = \"(1e-4 kg m^2)\"\n{data}\
         [outputs]\ni = \"motor.ia\"\nw = \"motor.speed\"\n[run]\nspan = \"4 s\"\n"
    );
    let trajectory = runs(&text);
    let speed = 24.0 * 0.045 / (0.6 * 1e-4 + 0.045 * 0.045);
    close(last(&trajectory, "w"), speed, 1e-7 * speed);
    close(last(&trajectory, "i"), 1e-4 * speed / 0.045, 1e-6);
}

/// The motor is fixed to a carriage that can turn: the torques on rotor and carriage are opposite.
#[test]
fn a_motor_of_the_program_turns_one_body_against_another() {
    let text = scene(&sampled("multi_current"))
        .replacen("theta = \"rad\"\n", "theta = \"rad\"\nhousing = \"rad\"\n", 1)
        .replacen("[[drive]]", "[frames]\nH = \"N turned housing about z\"\nR = \"N turned theta about z\"\n[bodies.housing]\nframe = \"H\"\ninertia = \"(0.03 kg m^2)\"\n[bodies.shaft]\nframe = \"R\"\ninertia = \"(0.005 kg m^2)\"\n[[drive]]", 1)
        .replacen("turns = \"theta\"", "between = [\"housing\", \"shaft\"]", 1)
        .replacen("[run]", "[start]\n\"theta'\" = \"2 rad/s\"\n[run]", 1)
        .replacen("[bodies.housing]\nframe", "[bodies.base]\nframe", 1)
        .replacen("[\"housing\",", "[\"base\",", 1);
    let trajectory = runs(&text);
    let momentum = 0.03 * last(&trajectory, "housing'") + (0.005 + INERTIA) * last(&trajectory, "theta'");
    close(momentum, 2.0 * (0.005 + INERTIA), 1e-9);
    assert!(last(&trajectory, "housing'").abs() > 1e-3);
}

/// A reaction wheel in a free body, about each axis and in either order of the bodies: the total angular momentum is conserved.
#[test]
fn a_reaction_wheel_turns_a_satellite_and_keeps_the_angular_momentum() {
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let along = |own: usize, moment: &str, w: &str| match own == axis {
            true => format!("(({moment}) + (0.002 kg m^2))*F.{w} + (0.002 kg m^2)*s'"),
            false => format!("({moment})*F.{w}"),
        };
        let moments = ["0.4 kg m^2", "0.5 kg m^2", "0.6 kg m^2"];
        let momenta: Vec<String> = moments
            .iter()
            .zip(["wx", "wy", "wz"])
            .enumerate()
            .map(|(own, (moment, w))| along(own, moment, w))
            .collect();
        let text = format!(
            "title = \"satellite\"\n[coordinates]\ns = \"rad\"\n[frames]\nF = \"N free\"\nW = \"F turned s about {name}\"\n\
             [bodies.satellite]\nframe = \"F\"\ninertia = {{ principal = [\"(0.4 kg m^2)\", \"(0.5 kg m^2)\", \"(0.6 kg m^2)\"] }}\n\
             [[drive]]\nname = \"wheel\"\nbetween = [\"satellite\", \"W\"]\ninertia = \"(0.002 kg m^2)\"\n\
             torque = \"(0.05 N m) - (1e-4 N m s)*wheel.speed\"\n\
             [outputs]\nH = \"sqrt(({})^2 + ({})^2 + ({})^2)\"\n\
             [start]\n\"F.wx\" = \"0.1 rad/s\"\n\"F.wy\" = \"0.3 rad/s\"\n\"F.wz\" = \"-0.2 rad/s\"\n[run]\nspan = \"3 s\"\n",
            momenta[0], momenta[1], momenta[2]
        );
        let trajectory = runs(&text);
        let squares = [0.402_f64, 0.502, 0.602].iter().zip([0.4, 0.5, 0.6]).enumerate();
        let at_start: f64 = squares
            .map(|(own, (with_wheel, alone))| if own == axis { *with_wheel } else { alone })
            .zip([0.1, 0.3, -0.2])
            .map(|(moment, speed): (f64, f64)| (moment * speed).powi(2))
            .sum();
        close(last(&trajectory, "H"), at_start.sqrt(), 1e-12);
        assert!(last(&trajectory, "s'").abs() > 10.0);
    }
}

/// The motor is fixed to the wheel and turns the satellite: its speed is that of the satellite relative to the wheel.
#[test]
fn a_motor_may_sit_on_what_turns() {
    let turned = |between: &str| {
        runs(&format!(
            "title = \"satellite\"\n[coordinates]\ns = \"rad\"\n[frames]\nF = \"N free\"\nW = \"F turned s about y\"\n\
             [bodies.satellite]\nframe = \"F\"\ninertia = {{ principal = [\"(1 kg m^2)\", \"(1 kg m^2)\", \"(1 kg m^2)\"] }}\n\
             [bodies.wheel]\nframe = \"W\"\ninertia = {{ principal = [\"(0.1 kg m^2)\", \"(0.1 kg m^2)\", \"(0.1 kg m^2)\"] }}\n\
             [[drive]]\nname = \"motor\"\nbetween = {between}\ntorque = \"(0.2 N m)\"\n\
             [outputs]\nw = \"motor.speed\"\n[run]\nspan = \"1 s\"\n"
        ))
    };
    // two bodies of 1 and 0.1 kg m^2, accelerated from rest by 0.2 N m
    let relative = 0.2 + 2.0;
    let (from_satellite, from_wheel) = (turned("[\"satellite\", \"wheel\"]"), turned("[\"wheel\", \"satellite\"]"));
    for trajectory in [&from_satellite, &from_wheel] {
        close(last(trajectory, "w"), relative, 1e-11);
    }
    close(last(&from_satellite, "s'"), relative, 1e-11);
    close(last(&from_wheel, "s'"), -relative, 1e-11);
}

#[test]
fn a_motor_without_inductance_and_without_supply_is_no_fault() {
    let drive = "inertia = \"(1 kg m^2)\"\n[[drive.winding]]\ninductance = \"(0 H)\"\nresistance = \"(1 ohm)\"\nmotional = \"(1 V s)\"\n";
    let text = format!(
        "title = \"brake\"\n[coordinates]\ntheta = \"rad\"\n[[drive]]\nname = \"motor\"\nturns = \"theta\"\n{drive}\
         [start]\n\"theta'\" = \"2 rad/s\"\n[run]\nspan = \"1 s\"\n"
    );
    // J w' = -k^2 w/R
    close(last(&runs(&text), "theta'"), 2.0 * (-1.0_f64).exp(), 1e-11);
}

#[test]
fn a_motor_that_turns_by_an_angle_inside_a_body_is_warned_of() {
    let text = "title = \"satellite\"\n[coordinates]\ns = \"rad\"\n[frames]\nF = \"N free\"\nW = \"F turned s about x\"\n\
                [bodies.satellite]\nframe = \"F\"\ninertia = { principal = [\"(1 kg m^2)\", \"(1 kg m^2)\", \"(1 kg m^2)\"] }\n\
                [[drive]]\nturns = \"s\"\ninertia = \"(1 kg m^2)\"\ntorque = \"(1 N m)\"\n[run]\nspan = \"1 s\"\n";
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let told: Vec<&str> = scene.model.warnings.iter().map(|warning| warning.title.as_str()).collect();
    assert_eq!(told, ["this motor sits on the ground, and turns by the angle of `W` in `F`"]);
}

#[test]
fn a_drive_has_one_motor() {
    let brushed = sampled("brushed");
    let text = scene(&brushed).replacen("[outputs]", "[[drive.winding]]\ninductance = \"(1 H)\"\n[outputs]", 1);
    let said = ModelScene::parse("scene.toml", &text).expect_err("two motors").to_string();
    assert!(said.contains("windings of its own, or a machine"), "{said}");
    let text = scene(&brushed).replacen("model = \"brushed\"", "model = \"brush\"", 1);
    let said = ModelScene::parse("scene.toml", &text).expect_err("unknown").to_string();
    assert!(said.contains("is `brushed` meant?"), "{said}");
}

/// There is one message, which lists only motors that a drive can have.
#[test]
fn a_machine_that_no_drive_has_is_refused_by_name() {
    for (model, messages) in [
        ("constant_speed", ["keeps the speed of its rotor under every load", "[[constraint]]"]),
        ("brush", ["unknown machine `brush`", "is `brushed` meant? Known: free_rotor, asynchronous"]),
    ] {
        let said = ModelScene::parse("scene.toml", &with_data(model, "")).expect_err(model);
        assert_eq!(said.issues.len(), 1, "{said}");
        let said = said.to_string();
        assert!(
            messages.iter().all(|message| said.contains(message)) && !said.contains("Known: constant_speed"),
            "{said}"
        );
    }
}
