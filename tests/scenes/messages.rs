//! Every mistake in a scene file is reported with its position and an accepted alternative.
//!
//! Each test first asserts the positions to which the message points, then compares the whole message with its
//! snapshot.

use dalembert_derivations::studies::scene::Scene;
use reader::{Family, SceneError};

const SOUND: &str = r#"title = "A gyrostat with a currentless synchronous motor"
system = "gyrostat"
gravity = "9.81 m/s^2"

[carrier]
mass = "1.5 kg"
centre = "0 0 60 mm"
inertia = "0.0096 0 0; 0 0.0102 0; 0 0 0.0034 kg m^2"

[rotor]
mass = "300 g"
centre = "0 0 60 mm"
axis = "0 0.6 0.8"
axial = "2.4e-4 kg m^2"
transverse = "1.5e-4 kg m^2"

[machine]
model = "synchronous"
field_speed = "150 rad/s"
b0 = "0.15 N m"
f = "1e-4 N m s"

[start]
angular_velocity = "0 0 0 rad/s"
vertical = "0 0 1"
rotor_angle = "20 deg"
rotor_speed = "150 rad/s"

[run]
span = "2 s"
samples = 100
tolerance = 1e-8
method = "dormand_prince_5"
outputs = ["slip"]
"#;

/// The valid scene with each of some texts replaced.
fn scene(edits: &[(&str, &str)]) -> String {
    edits.iter().fold(SOUND.to_owned(), |text, (from, to)| {
        assert_eq!(text.matches(from).count(), 1, "`{from}` must stand once in the scene");
        text.replace(from, to)
    })
}

/// Asserts that the marks are under these texts, in the order of the file, then compares the message.
fn refused(name: &str, text: &str, marked: &[&str]) {
    let error = Scene::parse("scene.toml", text).expect_err("the scene must be refused");
    let found: Vec<&str> = error.issues.iter().map(|issue| issue.span.clone().map_or("", |span| &text[span])).collect();
    assert_eq!(found, marked, "{error}");
    assert!(error.issues.iter().all(|issue| issue.help.is_some()) || name.contains("syntax"), "{error}");
    compare(name, &error);
}

fn compare(name: &str, error: &SceneError) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../../snapshots/scene_messages");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, error.to_string()));
}

/// One test per case: its name as a sentence, the edits of the valid scene, the marked texts.
macro_rules! refuses {
    ($($name:ident: [$(($from:literal, $to:literal)),+ $(,)?] => [$($marked:literal),* $(,)?];)*) => {$(
        #[test]
        fn $name() {
            refused(stringify!($name), &scene(&[$(($from, $to)),+]), &[$($marked),*]);
        }
    )*};
}

#[test]
fn the_sound_scene_is_accepted() {
    Scene::parse("scene.toml", SOUND).unwrap_or_else(|error| panic!("{error}"));
}

refuses! {
    // keys
    a_misspelt_key_names_the_one_that_was_meant: [("centre = \"0 0 60 mm\"\ninertia", "center = \"0 0 60 mm\"\ninertia")]
        => ["center"];
    an_unknown_key_lists_the_known_ones: [("[run]\n", "[run]\nwhatever = 3\n")] => ["whatever"];
    a_parameter_of_another_machine_is_unknown: [("b0 =", "k = \"1 N m s\"\nb0 =")] => ["k"];
    a_missing_key_is_told_with_an_example: [("mass = \"1.5 kg\"\n", "")] => ["[carrier]"];
    a_missing_table_is_told_once: [("[start]\nangular_velocity = \"0 0 0 rad/s\"\nvertical = \"0 0 1\"\nrotor_angle = \"20 deg\"\nrotor_speed = \"150 rad/s\"\n", "")]
        => [""];
    a_table_that_is_a_value_is_refused: [("[run]\nspan", "[other]\nspan"), ("gravity", "run = 3\ngravity")] => ["3", "other"];
    a_misspelt_table_names_the_one_that_was_meant: [("[carrier]", "[carier]")] => ["carier"];
    an_unknown_system_lists_the_known_ones: [("system = \"gyrostat\"", "system = \"gyroscope\"")] => ["\"gyroscope\""];
    an_unknown_machine_names_the_nearest: [("\"synchronous\"", "\"syncronous\"")] => ["\"syncronous\""];
    an_unknown_method_names_the_nearest: [("dormand_prince_5", "dormand_prince5")] => ["\"dormand_prince5\""];
    a_method_of_constant_step_needs_its_steps: [("dormand_prince_5", "runge_kutta_4")] => ["\"runge_kutta_4\""];
    an_output_that_is_no_state_lists_the_states: [("[\"slip\"]", "[\"slip\", \"i7\"]")] => ["\"i7\""];

    // types
    a_number_where_a_text_is_needed: [("title = \"A gyrostat with a currentless synchronous motor\"", "title = 7")] => ["7"];
    a_list_where_a_quantity_is_needed: [("span = \"2 s\"", "span = [2]")] => ["[2]"];
    a_boolean_where_a_vector_is_needed: [("axis = \"0 0.6 0.8\"", "axis = true")] => ["true"];
    a_fraction_where_a_count_is_needed: [("samples = 100", "samples = 1.5")] => ["1.5"];

    // units
    a_unit_of_something_else_says_both_dimensions: [("span = \"2 s\"", "span = \"2 kg\"")] => ["\"2 kg\""];
    a_unit_that_does_not_exist_names_the_nearest: [("300 g", "300 gr")] => ["\"300 gr\""];
    a_quantity_without_its_unit: [("mass = \"1.5 kg\"", "mass = 1.5")] => ["1.5"];
    hertz_is_ambiguous: [("field_speed = \"150 rad/s\"", "field_speed = \"25 Hz\"")] => ["\"25 Hz\""];
    what_follows_a_slash_is_ambiguous: [("f = \"1e-4 N m s\"", "f = \"1e-4 N m/rad s\"")] => ["\"1e-4 N m/rad s\""];
    a_broken_exponent_in_a_unit: [("axial = \"2.4e-4 kg m^2\"", "axial = \"2.4e-4 kg m^two\"")] => ["\"2.4e-4 kg m^two\""];
    a_unit_where_a_pure_number_is_needed: [("tolerance = 1e-8", "tolerance = \"1e-8 m\"")] => ["\"1e-8 m\""];

    // numbers
    nan_is_no_number: [("span = \"2 s\"", "span = \"nan s\"")] => ["\"nan s\""];
    nan_of_toml_is_no_number: [("tolerance = 1e-8", "tolerance = nan")] => ["nan"];
    infinity_is_no_number: [("b0 = \"0.15 N m\"", "b0 = \"inf N m\"")] => ["\"inf N m\""];
    a_number_beyond_double_precision: [("b0 = \"0.15 N m\"", "b0 = \"1e999 N m\"")] => ["\"1e999 N m\""];
    a_number_that_leaves_the_range_by_its_unit: [("b0 = \"0.15 N m\"", "b0 = \"1e308 kN m\"")] => ["\"1e308 kN m\""];
    words_where_a_number_is_needed: [("b0 = \"0.15 N m\"", "b0 = \"much\"")] => ["\"much\""];
    an_empty_quantity: [("b0 = \"0.15 N m\"", "b0 = \"\"")] => ["\"\""];
    two_components_where_three_are_needed: [("axis = \"0 0.6 0.8\"", "axis = \"0.6 0.8\"")] => ["\"0.6 0.8\""];
    a_tensor_with_a_row_too_few: [("inertia = \"0.0096 0 0; 0 0.0102 0; 0 0 0.0034 kg m^2\"", "inertia = \"0.0096 0 0; 0 0.0102 0 kg m^2\"")]
        => ["\"0.0096 0 0; 0 0.0102 0 kg m^2\""];

    // bodies that cannot exist
    an_axis_that_is_no_unit_vector: [("axis = \"0 0.6 0.8\"", "axis = \"0 1 2\"")] => ["\"0 1 2\""];
    a_vertical_that_is_no_unit_vector: [("vertical = \"0 0 1\"", "vertical = \"0 3 4\"")] => ["\"0 3 4\""];
    a_vertical_of_length_zero: [("vertical = \"0 0 1\"", "vertical = \"0 0 0\"")] => ["\"0 0 0\""];
    a_negative_mass: [("mass = \"1.5 kg\"", "mass = \"-1.5 kg\"")] => ["\"-1.5 kg\""];
    a_tensor_that_breaks_the_triangle_inequality: [("0.0096 0 0; 0 0.0102 0; 0 0 0.0034", "0.0096 0 0; 0 0.0102 0; 0 0 0.5")]
        => ["\"0.0096 0 0; 0 0.0102 0; 0 0 0.5 kg m^2\""];
    a_tensor_too_small_for_its_centre: [("centre = \"0 0 60 mm\"\ninertia", "centre = \"0 0 90 mm\"\ninertia")]
        => ["\"0.0096 0 0; 0 0.0102 0; 0 0 0.0034 kg m^2\""];
    a_tensor_that_is_not_symmetric: [("0.0096 0 0; 0 0.0102 0", "0.0096 0.001 0; 0 0.0102 0")]
        => ["\"0.0096 0.001 0; 0 0.0102 0; 0 0 0.0034 kg m^2\""];
    an_indefinite_tensor: [("0.0096 0 0; 0 0.0102 0", "-0.0096 0 0; 0 0.0102 0")]
        => ["\"-0.0096 0 0; 0 0.0102 0; 0 0 0.0034 kg m^2\""];
    a_rotor_flatter_than_a_disc: [("transverse = \"1.5e-4 kg m^2\"", "transverse = \"1.1e-4 kg m^2\"")] => ["\"2.4e-4 kg m^2\""];
    gravity_that_points_upwards: [("9.81 m/s^2", "-9.81 m/s^2")] => ["\"-9.81 m/s^2\""];

    // the run
    a_span_of_zero: [("span = \"2 s\"", "span = \"0 s\"")] => ["\"0 s\""];
    a_negative_span: [("span = \"2 s\"", "span = \"-2 s\"")] => ["\"-2 s\""];
    a_tolerance_of_zero: [("tolerance = 1e-8", "tolerance = 0")] => ["0"];
    a_negative_tolerance: [("tolerance = 1e-8", "tolerance = -1e-8")] => ["-1e-8"];
    a_tolerance_below_rounding: [("tolerance = 1e-8", "tolerance = 1e-20")] => ["1e-20"];
    no_samples: [("samples = 100", "samples = 0")] => ["0"];
    too_many_samples: [("samples = 100", "samples = 99999999999999999999999")] => ["99999999999999999999999"];
    currents_of_a_machine_without_windings: [("rotor_angle = \"20 deg\"", "currents = \"1 A\"")] => ["\"1 A\""];
    negative_friction_is_asked_for_by_name: [("f = \"1e-4 N m s\"", "f = \"-1e-4 N m s\"")] => ["\"-1e-4 N m s\""];
    a_word_that_nothing_can_be_asked_for_by: [("gravity = ", "allow = [\"negative resistence\", \"negative mass\"]\ngravity = ")]
        => ["\"negative resistence\"", "\"negative mass\""];
    mutual_inductance_of_a_listed_motor_is_refused_by_name: [("b0 =", "mutual_inductance = \"1 mH\"\nb0 =")] => ["mutual_inductance"];
    a_mass_beyond_all_numbers_is_the_one_that_is_told: [("mass = \"1.5 kg\"", "mass = \"1.5e300 kg\""), ("9.81 m/s^2", "9.81e10 m/s^2")]
        => ["\"1.5e300 kg\""];
    the_speed_of_a_machine_that_keeps_another: [
        ("model = \"synchronous\"\nfield_speed = \"150 rad/s\"\nb0 = \"0.15 N m\"\nf = \"1e-4 N m s\"", "model = \"constant_speed\"\nspeed = \"100 rad/s\""),
        ("outputs = [\"slip\"]", ""),
    ] => ["\"150 rad/s\""];

    // the file as a whole
    everything_that_is_wrong_is_told_at_once: [
        ("mass = \"1.5 kg\"", "mas = \"1.5 kg\""),
        ("b0 = \"0.15 N m\"", "b0 = \"0.15 N\""),
        ("vertical = \"0 0 1\"", "vertical = \"0 0 2\""),
        ("tolerance = 1e-8", "tolerance = 0"),
    ] => ["mas", "\"0.15 N\"", "\"0 0 2\"", "0"];
    a_fault_of_syntax_stands_alone: [("[rotor]", "[rotor")] => [""];
}

#[test]
fn a_damper_without_bars() {
    let windings = "model = \"multi_current\"\nfield_speed = \"150 rad/s\"\nb0 = \"0.15 N m\"\na1 = \"30 mWb\"\nl1 = \"30 mH\"\n\
                    r1 = \"1.2 ohm\"\na2 = \"8 mWb\"\nl2 = \"1.6 mH\"\nr2 = \"64 mohm\"\nmu = \"0 N m s\"\nf = \"0 N m s\"\nbars = 0";
    let old = "model = \"synchronous\"\nfield_speed = \"150 rad/s\"\nb0 = \"0.15 N m\"\nf = \"1e-4 N m s\"";
    refused("a_damper_without_bars", &scene(&[(old, windings)]), &["0"]);
}

#[test]
fn an_empty_file() {
    refused("an_empty_file", " \n", &[""]);
}

#[test]
fn a_missing_file() {
    compare("a_missing_file", &Scene::open("no_such_scene.toml".as_ref()).expect_err("there is no such file"));
}

#[test]
fn a_folder_is_no_scene() {
    compare("a_folder_is_no_scene", &Scene::open("scenes".as_ref()).expect_err("it is a folder"));
}

/// The valid scene's motor as text.
const WRITTEN: &str = r#"model = "text"
field_speed = "150 rad/s"
field_energy = "-b0*cos(g)"
torque_law = "-mu*g' - f*phi'"

[machine.parameters]
b0 = "0.15 N m"
mu = "1e-5 N m s"
f = "1e-4 N m s"
a1 = "30 mWb"
l1 = "30 mH"
r1 = "1.2 ohm"
t1 = "30 deg"

[[machine.winding]]
flux = "a1*cos(g + t1)"
inductance = "l1"
resistance = "r1"
"#;

/// The scene with a text motor, with each of some texts replaced.
fn written(edits: &[(&str, &str)]) -> String {
    let compiled = "model = \"synchronous\"\nfield_speed = \"150 rad/s\"\nb0 = \"0.15 N m\"\nf = \"1e-4 N m s\"\n";
    let text = scene(&[(compiled, WRITTEN)]);
    edits.iter().fold(text, |text, (from, to)| {
        assert_eq!(text.matches(from).count(), 1, "`{from}` must stand once in the scene");
        text.replace(from, to)
    })
}

#[test]
fn the_sound_motor_as_text_is_accepted() {
    Scene::parse("scene.toml", &written(&[])).unwrap_or_else(|error| panic!("{error}"));
}

/// One test per case for the scene with a text motor.
macro_rules! refuses_laws {
    ($($name:ident: [$(($from:literal, $to:literal)),+ $(,)?] => [$($marked:literal),* $(,)?];)*) => {$(
        #[test]
        fn $name() {
            refused(stringify!($name), &written(&[$(($from, $to)),+]), &[$($marked),*]);
        }
    )*};
}

refuses_laws! {
    a_letter_of_a_law_that_is_no_parameter_names_the_nearest: [("\"-b0*cos(g)\"", "\"-b*cos(g)\"")] => ["b"];
    a_term_of_another_dimension_is_marked_in_its_law: [("-mu*g' - f*phi'", "-mu*g' - b0*phi'")] => ["b0*phi'"];
    a_law_of_another_dimension_says_both: [("a1*cos(g + t1)", "b0*cos(g + t1)")] => ["\"b0*cos(g + t1)\""];
    an_angle_out_of_cosine_and_sine_is_no_law: [("\"-b0*cos(g)\"", "\"b0*g*g\"")] => ["g"];
    half_an_angle_is_no_law_of_the_circle: [("\"-b0*cos(g)\"", "\"-b0*cos(g/2)\"")] => ["cos(g/2)"];
    a_speed_in_an_energy_is_refused: [("\"-b0*cos(g)\"", "\"-b0*cos(g) + mu*g'\"")] => ["g'"];
    an_angle_in_the_torque_law_is_refused: [("-mu*g' - f*phi'", "-mu*g' - b0*sin(g)")] => ["g"];
    a_current_in_the_torque_law_is_refused: [("-mu*g' - f*phi'", "-f*phi' + a1*x")] => ["x"];
    a_current_in_a_supply_is_refused: [("resistance = \"r1\"", "resistance = \"r1\"\nsupply = \"-a1*x\"")] => ["x"];
    a_winding_that_saturates_is_refused: [("inductance = \"l1\"", "inductance = \"l1*x\"")] => ["x"];
    a_root_of_the_motion_is_refused: [("-mu*g' - f*phi'", "-mu*sqrt(g'*g') - f*phi'")] => ["sqrt(g'*g')"];
    an_angle_with_a_dimension_is_refused: [("a1*cos(g + t1)", "a1*cos(g + l1)")] => ["l1"];
    a_function_that_is_none_is_marked_in_its_law: [("\"-b0*cos(g)\"", "\"-b0*tan(g)\"")] => ["tan"];
    a_winding_that_knows_the_motion_is_refused: [("resistance = \"r1\"", "resistance = \"r1*cos(g)\"")] => ["g"];
    a_winding_without_its_parts_is_told_each: [("inductance = \"l1\"\nresistance = \"r1\"\n", "")]
        => ["[[machine.winding]]", "[[machine.winding]]"];
    a_motor_without_its_torque_law: [("torque_law = \"-mu*g' - f*phi'\"\n", "")] => ["[machine]"];
    a_parameter_that_takes_a_letter_of_the_motion: [("mu = \"1e-5 N m s\"", "mu = \"1e-5 N m s\"\n\"g'\" = \"1\"")] => ["\"g'\""];
    a_parameter_that_no_expression_can_name: [("mu = \"1e-5 N m s\"", "mu = \"1e-5 N m s\"\nk-2 = \"1\"")] => ["k-2"];
    a_parameter_of_an_unknown_unit: [("mu = \"1e-5 N m s\"", "mu = \"1e-5 N mm s\"\nk = \"1 hg\"")] => ["\"1 hg\""];
    an_inductance_that_is_not_positive: [("l1 = \"30 mH\"", "l1 = \"0 H\"")] => ["\"l1\""];
    a_number_of_too_many_digits_in_a_law: [("\"-b0*cos(g)\"", "\"-b0*cos(g)*0.12345678901234567890123\"")]
        => ["0.12345678901234567890123"];
    a_voltage_of_sliding_that_is_not_affine: [("resistance = \"r1\"", "resistance = \"r1\"\nmotional = \"a1 + l1*x*x\"")]
        => ["l1*x*x"];
    a_current_that_has_the_name_of_a_slip: [("resistance = \"r1\"", "resistance = \"r1\"\ncurrent = \"g'\"")] => ["\"g'\""];
    a_law_that_is_a_number: [("\"-b0*cos(g)\"", "7")] => ["7"];
    a_resistance_that_is_zero_is_asked_for_by_name: [("r1 = \"1.2 ohm\"", "r1 = \"0 ohm\"")] => ["\"r1\""];
    a_torque_that_drives_in_both_directions_is_negative_friction: [("f = \"1e-4 N m s\"", "f = \"-1e-4 N m s\"")]
        => ["\"-mu*g' - f*phi'\""];
    a_parameter_that_is_no_number_is_told_once: [("a1 = \"30 mWb\"", "a1 = \"nan Wb\""), ("resistance = \"r1\"", "resistance = \"r1\"\nmotional = \"a1\"")]
        => ["\"nan Wb\""];
    a_parameter_beyond_double_precision_is_told_once: [("b0 = \"0.15 N m\"", "b0 = 1e400")] => ["1e400"];
    a_parameter_of_another_unit_is_told_once: [
        ("l1 = \"30 mH\"", "l1 = \"30 mWb\""),
        ("resistance = \"r1\"\n", "resistance = \"r1\"\n\n[[machine.winding]]\ninductance = \"l1\"\nresistance = \"r1\"\n\n\
          [[machine.winding]]\ninductance = \"2*l1\"\nresistance = \"r1\"\n"),
    ] => ["\"l1\""];
    a_letter_that_many_laws_hold_is_told_once: [("field_energy = \"-b0*cos(g)\"\ntorque_law = \"-mu*g' - f*phi'\"", "field_energy = \"-b*cos(g)\"\ntorque_law = \"-f*phi' - b\"")]
        => ["b"];
    parameters_under_a_misspelt_heading_are_told_once: [("[machine.parameters]", "[machine.parameter]")] => ["parameter"];
    two_currents_of_one_name_are_told_as_such: [("resistance = \"r1\"\n", "resistance = \"r1\"\ncurrent = \"id\"\n\n[[machine.winding]]\n\
          inductance = \"l1\"\nresistance = \"r1\"\ncurrent = \"id\"\nmotional = \"a1 + l1*iq\"\n")] => ["\"id\"", "iq"];
    the_time_is_known_by_no_law: [("resistance = \"r1\"", "resistance = \"r1\"\nsupply = \"a1*cos(field_speed*t)\"")] => ["t"];
    a_multiple_of_the_angle_beyond_the_highest_tells_the_highest: [("\"-b0*cos(g)\"", "\"-b0*cos(40*g)\"")] => ["cos(40*g)"];
    mutual_inductance_is_refused_by_its_name: [("resistance = \"r1\"", "resistance = \"r1\"\nmutual = \"l1\"")] => ["mutual"];
    a_current_in_a_flux_is_mutual_inductance: [("a1*cos(g + t1)", "a1*cos(g) + l1*x")] => ["x"];
    the_rate_of_a_current_is_mutual_inductance: [("resistance = \"r1\"", "resistance = \"r1\"\nmotional = \"l1*x'\"")] => ["x'"];
    two_currents_in_one_motional_law_share_flux: [("resistance = \"r1\"\n", "resistance = \"r1\"\nmotional = \"2*l1*x + l1*i1\"\n\n\
          [[machine.winding]]\ninductance = \"l1\"\nresistance = \"r1\"\nmotional = \"l1*x - l1*i1\"\n")]
        => ["\"2*l1*x + l1*i1\""];
}

#[test]
fn a_binary_file_is_no_scene() {
    let path = std::env::temp_dir().join(format!("dalembert_binary_{}.toml", std::process::id()));
    std::fs::write(&path, [0x74, 0xff, 0x00, 0xfe]).expect("a temporary file can be written");
    let mut error = Scene::open(&path).expect_err("it is no text");
    std::fs::remove_file(&path).expect("it is there");
    error.path = "binary.toml".to_owned();
    compare("a_binary_file_is_no_scene", &error);
}

#[test]
fn a_text_in_which_nothing_stands() {
    refused(
        "a_text_in_which_nothing_stands",
        &scene(&[("\"gyrostat\"", "\" \""), ("\"dormand_prince_5\"", "\"\"")]),
        &["\" \""],
    );
}

#[test]
fn bodies_whose_moments_no_number_holds() {
    let text = scene(&[("mass = \"300 g\"\ncentre = \"0 0 60 mm\"", "mass = \"300 g\"\ncentre = \"1e300 0 0 m\"")]);
    refused("bodies_whose_moments_no_number_holds", &text, &["\"1e300 0 0 m\""]);
}

#[test]
fn windings_that_share_no_flux_may_say_so() {
    let two = "resistance = \"r1\"\nmotional = \"2*l1*x + l1*i1\"\n\n[[machine.winding]]\ninductance = \"l1\"\nresistance = \"r1\"\n";
    let asked = [("resistance = \"r1\"\n", two), ("gravity = ", "allow = [\"separate fluxes\"]\ngravity = ")];
    Scene::parse("scene.toml", &written(&asked)).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn a_title_stands_on_one_line() {
    let title = ("title = \"A gyrostat with a currentless synchronous motor\"", "title = \"two\\nlines\\r of it\"");
    let scene = Scene::parse("scene.toml", &scene(&[title])).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.title, "two lines of it");
}
