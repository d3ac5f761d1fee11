use super::{Instant, Sketch, SketchPart};

/// A bar that hangs from a pin on the ground, at given angles in degrees.
fn bar(angles: &[f64]) -> Sketch {
    let instant = |(number, angle): (usize, &f64)| {
        let (sin, cos) = angle.to_radians().sin_cos();
        let places = vec![[0.0; 3], [2.0 * sin, -2.0 * cos, 0.0]];
        Instant { time: number as f64, places, directions: Vec::new() }
    };
    Sketch {
        title: "A bar".into(),
        parts: vec![
            SketchPart::Support(0),
            SketchPart::Plate { corners: vec![0, 1], colour: 0 },
            SketchPart::Spring([0, 1]),
            SketchPart::Pin(0),
        ],
        names: vec![(1, "<P>".into())],
        instants: angles.iter().enumerate().map(instant).collect(),
        has_scale: true,
        ..Sketch::default()
    }
}

#[test]
fn a_still_has_every_part_and_name_and_moves_nothing() {
    let svg = bar(&[0.0]).svg();
    for shown in ["class=\"bar b0\"", "class=\"surface\"", "class=\"pin\"", ">&lt;P&gt;</text>", "A bar"] {
        assert!(svg.contains(shown), "{shown}: {svg}");
    }
    assert!(!svg.contains("<animate") && !svg.contains("NaN") && svg.ends_with("</svg>"));
}

#[test]
fn a_bar_that_swings_is_turned_as_a_whole_and_loops_without_a_script() {
    let svg = bar(&[0.0, 30.0, 60.0]).svg();
    assert!(
        svg.contains("type=\"rotate\" values=\"0;-30;-60\"") && svg.contains("repeatCount=\"indefinite\""),
        "{svg}"
    );
    assert!(!svg.contains("<script") && !svg.contains("attributeName=\"d\""), "{svg}");
    assert!(svg.contains("as quick as the motion"), "{svg}");
}

#[test]
fn nothing_and_places_that_are_no_numbers_are_pictures() {
    assert!(Sketch::default().svg().ends_with("</svg>"));
    let mut lost = bar(&[0.0]);
    lost.instants[0].places[1] = [f64::NAN; 3];
    assert!(lost.svg().ends_with("</svg>"));
    lost.parts.push(SketchPart::Rod([0, 99]));
    assert!(lost.svg().ends_with("</svg>"));
}

/// An instant of a disc about the origin that is turned by an angle in rad, with the directions of a spring, a dashpot and a torque.
fn sprung(turned: f64, torque: f64) -> Instant {
    let (sin, cos) = turned.sin_cos();
    let directions = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [cos, sin, 0.0], [0.0, 0.0, torque]];
    Instant { time: turned, places: vec![[0.0; 3], [1.0, 0.0, 0.0]], directions }
}

#[test]
fn a_spiral_winds_with_its_angle_and_a_torque_is_an_arc_in_its_sense() {
    let parts = vec![
        SketchPart::TorsionSpring { at: 0, axes: [0, 1, 2] },
        SketchPart::RotaryDashpot { at: 0, axes: [0, 1, 2] },
        SketchPart::Torque { at: 0, along: 3 },
    ];
    let sketch = |instants: Vec<Instant>| Sketch { parts: parts.clone(), instants, ..Sketch::default() };
    let path = |svg: &str, class: &str| {
        let (_, rest) = svg.split_once(&format!("class=\"{class}\" d=\"")).unwrap_or_else(|| panic!("{class}: {svg}"));
        rest.split('"').next().unwrap_or_default().to_owned()
    };
    let [here, wound, back] =
        [(0.0, 1.0), (0.5, 1.0), (0.0, -2.0)].map(|(turn, torque)| sketch(vec![sprung(turn, torque)]).svg());
    assert!(path(&here, "spring") != path(&wound, "spring") && path(&here, "spring") == path(&back, "spring"));
    assert!(path(&here, "force") == path(&wound, "force") && path(&here, "force") != path(&back, "force"));
    // the spiral continues to wind beyond half a turn
    let moving = sketch((0..60).map(|k| sprung(0.2 * f64::from(k), 1.0)).collect()).svg();
    assert!(moving.contains("class=\"spring\"") && moving.contains("attributeName=\"d\"") && !moving.contains("NaN"));
    // a torque that is zero at first has an arrow from the later instant on
    let later = sketch(vec![sprung(0.0, 0.0), sprung(0.1, 1.0)]).svg();
    assert!(later.contains("class=\"force\" d=\"\"") && later.contains("values=\"M0 0;M"), "{later}");
    // without a torque there is no arrow
    assert_eq!(sketch(vec![sprung(0.0, 0.0)]).svg().matches("class=\"force\"").count(), 0);
}
