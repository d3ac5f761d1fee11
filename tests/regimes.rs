//! Every consistent regime of rough contacts: textbook values, exactly.

use derivations::regimes::maps::{Kind, maps};
use derivations::systems::ladder::Ladder;
use derivations::systems::painleve_klein::Sliders;
use derivations::systems::rod::Rod;
use derivations::systems::slender_rod::SlenderRod;
use field::{Circle, Over, Rational};
use mechanics::constrained::contacts::{Contact, Contacts, Sides};
use mechanics::constrained::{Constrained, Constraint, State, System};
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::mode::modes;
use mechanics::regimes::{
    Condition, Direction, Dry, Face, Found, Mode, Ordered, Seen, Sizes, Touch, Unfit, Verdict, conditions, consistent,
    touches, verdict,
};
use num_traits::Zero;
use std::collections::HashSet;

use Direction::{Backwards, Forwards};

fn q(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator, denominator)
}

/// What the contacts know of a state, under the system's own force.
fn seen<Q, S, const N: usize, const C: usize, const K: usize>(system: &Q, at: &State<S, N>) -> (Dry<S, K>, [Touch; K])
where
    Q: Contacts<N, C, K>,
    S: Over<Q::Given> + Ordered,
{
    let dry = Dry::of(system, at, system.force(at)).expect("the constraints are independent");
    (dry, touches(system, at, Sizes::of(at)).expect("the state is admitted"))
}

fn decide<Q, S, const N: usize, const C: usize, const K: usize>(system: &Q, at: &State<S, N>) -> Verdict<S, K>
where
    Q: Contacts<N, C, K>,
    S: Over<Q::Given> + Ordered,
{
    let (dry, touches) = seen(system, at);
    verdict(&dry, &touches)
}

/// The sliders with tan theta = 4/3 and m1 = m2 = P2 = 1, moving forwards.
fn sliders(tangent_times_friction: Rational, load: i64) -> Verdict<Rational, 2> {
    let system = Sliders {
        masses: [q(1, 1), q(1, 1)],
        loads: [q(load, 1), q(1, 1)],
        distance: q(4, 1),
        length: q(5, 1),
        friction: tangent_times_friction * q(3, 4),
    };
    let place = [q(0, 1), q(0, 1), q(3, 1), q(4, 1)];
    decide(&system, &State { time: q(0, 1), place, velocity: [q(1, 1), q(0, 1), q(1, 1), q(0, 1)] })
}

#[test]
fn the_sliders_have_two_accelerations_or_none() {
    let Verdict::Several(a, b) = sliders(q(3, 1), 2) else { panic!("two accelerations") };
    let mut found = [a.motion[0][1], b.motion[0][1]];
    found.sort_by(|a, b| (*a - *b).sign().unwrap_or(0).cmp(&0));
    assert_eq!(found, [q(0, 1), q(6, 5)]);
    assert_eq!(sliders(q(3, 1), 0), Verdict::None);
}

#[test]
fn the_sliders_are_unique_below_the_critical_friction() {
    for load in -20..=20 {
        assert!(matches!(sliders(q(19, 10), load), Verdict::Unique(_)), "load {load}");
    }
}

#[test]
fn at_the_critical_friction_one_load_gives_a_continuum() {
    // (m1 + m2 - f m2 tan theta) x'' = P1 + P2 - f P2 tan theta is 0 = 0
    assert!(matches!(sliders(q(2, 1), 1), Verdict::Continuum(_)));
    assert_eq!(sliders(q(2, 1), 0), Verdict::None);
}

/// A uniform slender rod with m = l = g = 1 whose end slides backwards, the rod leaning forwards and turning.
fn slender_rod(friction: Rational, angle: Circle<Rational>, spin: Rational) -> Verdict<Rational, 1> {
    let one = q(1, 1);
    let rod = SlenderRod { mass: one, inertia: q(1, 3), half_length: one, gravity: one, friction };
    let velocity = [-one - spin * angle.sin, spin * angle.cos, -spin * angle.sin, spin * angle.cos];
    decide(&rod, &State { time: q(0, 1), place: [angle.cos, angle.sin, angle.cos, angle.sin], velocity })
}

#[test]
fn the_slender_rod_is_unique_up_to_its_critical_friction() {
    // tan theta = 4/3: (1 + 3 cos^2) / (3 sin cos) = 13/9
    let angle = Circle { cos: q(3, 5), sin: q(4, 5) };
    let (slow, fast) = (q(0, 1), q(2, 1));
    for spin in [slow, fast] {
        assert!(matches!(slender_rod(q(129, 90), angle, spin), Verdict::Unique(_)));
    }
    // beyond: falling slowly none, lifted by its rotation two; between them, at g = l sin theta' ^2, only the tie
    assert_eq!(slender_rod(q(131, 90), angle, slow), Verdict::None);
    assert!(matches!(slender_rod(q(131, 90), angle, fast), Verdict::Several(..)));
    assert_eq!(slender_rod(q(13, 9), angle, slow), Verdict::None);
}

#[test]
fn painleves_rod_slides_as_newtons_laws_for_its_two_points_say() {
    let (m, m1, l, g, f) = (q(2, 1), q(3, 1), q(1, 1), q(10, 1), q(1, 4));
    let rod = Rod { guided: m, free: m1, length: l, gravity: g, friction: f, sides: Sides::Two };
    let (c, s) = (q(3, 5), q(4, 5));
    for direction in Direction::ALL {
        let speed = direction.sign();
        let velocity = [speed, q(0, 1), speed, q(0, 1)];
        let at = State { time: q(0, 1), place: [q(0, 1), q(0, 1), c, s], velocity };
        let Verdict::Unique(found) = decide(&rod, &at) else { panic!("one motion") };
        // R_x = -(direction) f N, N = (m + m1) g - m1 l theta'' c, l theta'' = x'' s + g c
        let against = -f * speed;
        let weight = (m + m1) * g - m1 * g * c * c;
        let right = m1 * g * s * c + against * weight;
        assert_eq!(found.motion[0][1], right / (m + m1 * c * c + against * m1 * s * c));
    }
}

/// A bead of mass 1 on a rough dome of radius 1, g = 10, f = 1/2.
struct Dome;

impl System<2> for Dome {
    type Given = Rational;

    fn masses<S: Over<Rational>>(&self) -> [S; 2] {
        [S::one(); 2]
    }

    fn force<S: Over<Rational>>(&self, _at: &State<S, 2>) -> [S; 2] {
        [S::zero(), S::int(-10)]
    }
}

impl Constrained<2, 0> for Dome {
    fn constraints<S: Over<Rational>>(&self, _at: &State<S, 2>) -> [Constraint<S>; 0] {
        []
    }
}

impl Contacts<2, 0, 1> for Dome {
    fn contacts<S: Over<Rational>>(&self, _time: S, [x, y]: [S; 2]) -> [Contact<S>; 1] {
        let gap = (x.squared() + y.squared() - S::one()).half();
        // near the top
        [Contact { gap, along: x / y, friction: S::ratio(1, 2), sides: Sides::One }]
    }
}

#[test]
fn a_bead_leaves_the_top_of_a_dome_when_it_is_too_fast() {
    let over_the_top = |speed| {
        let at = State { time: q(0, 1), place: [q(0, 1), q(1, 1)], velocity: [q(speed, 1), q(0, 1)] };
        let Verdict::Unique(found) = decide(&Dome, &at) else { panic!("one motion") };
        found
    };
    // N = m (g - v^2/R)
    assert_eq!(over_the_top(3).reactions, [[q(1, 1), q(-1, 2)]]);
    let fast = over_the_top(4);
    assert_eq!((fast.regime, fast.motion), ([Mode::Apart], [[q(6, 1), q(0, 1)]]));
}

#[test]
fn a_contact_that_closes_with_a_velocity_is_an_impact() {
    let one = q(1, 1);
    let rod = SlenderRod { mass: one, inertia: q(1, 3), half_length: one, gravity: one, friction: one };
    let place = [q(3, 5), q(4, 5), q(3, 5), q(4, 5)];
    let falling = State { time: q(0, 1), place, velocity: [q(0, 1), q(-1, 1), q(0, 1), q(0, 1)] };
    assert_eq!(touches::<_, _, 4, 1, 1>(&rod, &falling, Sizes::of(&falling)), Err(Unfit::Impact { contact: 0 }));
    let rising = State { velocity: [q(0, 1), q(1, 1), q(0, 1), q(0, 1)], ..falling };
    assert_eq!(touches::<_, _, 4, 1, 1>(&rod, &rising, Sizes::of(&rising)), Ok([Touch::Open]));
    let below = State { place: [q(3, 5), q(3, 5), q(3, 5), q(4, 5)], ..falling };
    assert_eq!(touches::<_, _, 4, 1, 1>(&rod, &below, Sizes::of(&below)), Err(Unfit::Penetrates { contact: 0 }));
}

/// The uniform ladder with m = l = 1, g = 10.
fn ladder(friction: Rational) -> Ladder<Rational> {
    let one = q(1, 1);
    Ladder { mass: one, inertia: q(1, 3), half_length: one, gravity: q(10, 1), friction: [friction; 2] }
}

/// On wall and floor with the angle from the wall to the ladder, turning.
fn leaning(angle: Circle<Rational>, spin: Rational) -> State<Rational, 4> {
    let (c, s) = (angle.cos, angle.sin);
    State { time: q(0, 1), place: [s, c, c, s], velocity: [spin * c, -spin * s, -spin * s, spin * c] }
}

#[test]
fn a_steep_ladder_on_rough_ground_stays_with_undetermined_reactions() {
    let steep = leaning(Circle { cos: q(12, 13), sin: q(5, 13) }, q(0, 1));
    let Verdict::Unique(found) = decide(&ladder(q(1, 2)), &steep) else { panic!("one motion") };
    assert_eq!(found.regime, [Mode::Stick(Face::Front); 2]);
    assert!(found.motion.as_flattened().iter().all(Rational::is_zero));
    assert!(!found.determined);
}

/// With both cones around the line of its ends nothing bounds the push along it.
#[test]
fn a_ladder_that_is_wedged_has_reactions_without_bound() {
    let wedged = leaning(Circle { cos: q(3, 5), sin: q(4, 5) }, q(0, 1));
    let Verdict::Unique(found) = decide(&ladder(q(2, 1)), &wedged) else { panic!("one motion") };
    assert_eq!(found.regime, [Mode::Stick(Face::Front); 2]);
    assert!(!found.determined);
}

#[test]
fn a_flat_ladder_on_smooth_ground_falls_as_the_closed_form_says() {
    let angle = Circle { cos: q(3, 5), sin: q(4, 5) };
    let Verdict::Unique(found) = decide(&ladder(q(0, 1)), &leaning(angle, q(0, 1))) else { panic!("one motion") };
    // (m l^2 + J) alpha'' = m g l sin alpha, and the floor's point has x = 2 l sin alpha
    let turning = q(10, 1) * angle.sin / q(4, 3);
    assert_eq!(found.motion[1][1], q(2, 1) * angle.cos * turning);
}

/// Whether reactions and accelerations obey the laws of contact and friction, without a word about regimes.
fn lawful<const K: usize>(dry: &Dry<Rational, K>, touches: &[Touch; K], found: &Found<Rational, K>) -> bool {
    let sign = |x: Rational| x.sign().expect("every value is defined");
    (0..K).all(|k| {
        let ([normal, tangential], [gap, along]) = (found.reactions[k], found.motion[k]);
        let limit = dry.friction[k] * normal.size() - tangential.size();
        let open = normal.is_zero() && tangential.is_zero();
        let normal_law = match (touches[k], dry.sides[k]) {
            (Touch::Open, _) => open,
            (_, Sides::Two) => gap.is_zero(),
            (_, Sides::One) => sign(normal) >= 0 && sign(gap) >= 0 && (normal * gap).is_zero(),
        };
        let friction_law = match touches[k] {
            Touch::Open => true,
            Touch::Slides(direction) => limit.is_zero() && sign(tangential * direction.sign()) <= 0,
            Touch::Rest if normal.is_zero() => open,
            Touch::Rest => sign(limit) >= 0 && (along.is_zero() || limit.is_zero() && sign(tangential * along) <= 0),
        };
        normal_law && friction_law
    })
}

/// Small rationals without a clock.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> Rational {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        q(((self.0 >> 33) % 41) as i64 - 20, 7)
    }
}

#[test]
fn what_is_found_obeys_the_laws_and_floats_agree() {
    let mut numbers = Numbers(1);
    let (mut none, mut several) = (0, 0);
    for case in 0..400 {
        let angle = Circle::from_half_tangent(q(1 + case % 11, 12));
        let spin = if case % 3 == 0 { q(0, 1) } else { numbers.next() };
        let (mut system, at) = (ladder(numbers.next().size()), leaning(angle, spin));
        system.friction[1] = numbers.next().size();
        let load = std::array::from_fn(|_| numbers.next());
        let dry = Dry::<_, 2>::of(&system, &at, load).expect("one constraint");
        let touch = touches(&system, &at, Sizes::of(&at)).expect("on wall and floor");
        consistent(&dry, &touch, |found| assert!(lawful(&dry, &touch, &found), "case {case}: {found:?}"));
        let exact = verdict(&dry, &touch);
        none += u32::from(exact == Verdict::None);
        several += u32::from(matches!(exact, Verdict::Several(..)));
        let f = system.friction.map(Rational::to_f64);
        let rounded = Ladder { mass: 1.0, inertia: 1.0 / 3.0, half_length: 1.0, gravity: 10.0, friction: f };
        let place = at.place.map(Rational::to_f64);
        let near = State { time: 0.0, place, velocity: at.velocity.map(Rational::to_f64) };
        let dry = Dry::<_, 2>::of(&rounded, &near, load.map(Rational::to_f64)).expect("one constraint");
        let rounded = verdict(&dry, &touches(&rounded, &near, Sizes::of(&near)).expect("on wall and floor"));
        assert_eq!(name(&exact), name(&rounded), "case {case}: {exact:?} but {rounded:?}");
    }
    assert!(none > 0 && several > 0, "{none} without a motion, {several} with several");
}

fn name<S, const K: usize>(verdict: &Verdict<S, K>) -> (&'static str, Option<[Mode; K]>) {
    match verdict {
        Verdict::Unique(found) => ("unique", Some(found.regime)),
        Verdict::None => ("none", None),
        Verdict::Several(a, _) => ("several", Some(a.regime)),
        Verdict::Continuum(found) => ("continuum", Some(found.regime)),
        Verdict::Undefined => ("undefined", None),
    }
}

#[test]
fn cramers_rule_and_elimination_agree() {
    let (dry, touches) = seen(&ladder(q(1, 3)), &leaning(Circle { cos: q(3, 5), sin: q(4, 5) }, q(1, 2)));
    let mut regular = 0;
    consistent(&dry, &touches, |found| {
        let cramer = Cramer::of(&dry, &found.regime);
        assert_eq!(cramer.reactions(), found.reactions);
        for (condition, form) in conditions(&dry, &touches, &found.regime).iter().flatten().flatten() {
            assert!(cramer.value(form).sign() >= Some(0), "{condition}");
        }
        regular += 1;
    });
    assert_eq!(regular, 1);
}

#[test]
fn a_tie_is_told_and_counted_as_one_motion() {
    // a rod hanging straight above its end, pushed just to the limit of friction
    let one = q(1, 1);
    let rod = SlenderRod { mass: one, inertia: q(1, 3), half_length: one, gravity: one, friction: q(1, 2) };
    let still = [q(0, 1); 4];
    let at = State { time: q(0, 1), place: [q(0, 1), one, q(0, 1), one], velocity: still };
    // W is diag(1, 4): a push of 2 at the centre asks for T = -1/2 = -f N
    let dry = Dry::<_, 1>::of(&rod, &at, [q(2, 1), -one, q(0, 1), q(0, 1)]).expect("one constraint");
    let mut names = Vec::new();
    consistent(&dry, &[Touch::Rest], |found| names.push((found.regime[0], found.tie)));
    let stick = (Mode::Stick(Face::Front), Some((0, Condition::HoldsBackwards)));
    let slip = (Mode::Slip(Forwards, Face::Front), Some((0, Condition::Departs)));
    assert_eq!(names, [stick, slip]);
    let Verdict::Unique(found) = verdict(&dry, &[Touch::Rest]) else { panic!("one motion under two names") };
    assert_eq!(found.motion, [[q(0, 1); 2]]);
}

#[test]
fn a_smooth_guide_has_no_stick() {
    let count = |friction| modes(Touch::Rest, Sides::Two, friction).count();
    assert_eq!((count(q(0, 1)), count(q(1, 1))), (2, 6));
    assert_eq!(modes(Touch::Slides(Backwards), Sides::One, q(0, 1)).count(), 2);
}

#[test]
fn infinite_forces_have_no_verdict() {
    let rod = SlenderRod { mass: 1.0, inertia: 1.0, half_length: 1.0, gravity: 1.0, friction: 1.0 };
    let at = State { time: 0.0, place: [0.0, 1.0, 0.0, 1.0], velocity: [0.0; 4] };
    let dry = Dry::<f64, 1>::of(&rod, &at, [f64::INFINITY, 0.0, 0.0, 0.0]).expect("one constraint");
    assert_eq!(verdict(&dry, &[Touch::Rest]), Verdict::Undefined);
}

#[test]
fn decisions_alone_find_the_critical_curves() {
    let mut shown = HashSet::new();
    for map in maps() {
        assert!(map.distance < 1e-9, "{}: {:.1e}", map.title, map.distance);
        let (_, least, name) = map.least;
        let lowest = map.curve.iter().map(|(_, f)| *f).fold(f64::INFINITY, f64::min);
        assert!(lowest >= least && lowest < 1.001 * least, "{name}: {lowest}");
        shown.extend(map.rows.into_iter().flatten().map(Kind::name));
    }
    assert_eq!(shown.len(), Kind::ALL.len(), "{shown:?}");
}

#[test]
fn a_ladder_at_rest_may_stay_or_slide_up_under_one_load() {
    // f = 1/2 and tan alpha = 12/5 > 1/f; reactions as in the claim regimes/ladder-rest/reactions, at one limit of rest
    let (f, at) = (q(1, 2), leaning(Circle { cos: q(5, 13), sin: q(12, 13) }, q(0, 1)));
    let system = ladder(f);
    let (wall, floor, against) = (q(100, 1) + q(263, 39), q(100, 1) + q(191, 78), q(91, 12));
    let reactions = [[wall, -f * wall], [floor, f * (floor - against) - f * against]];
    let zero = [q(0, 1); 4];
    let seen = Seen::<_, 4, 2>::of(&system, &at, zero).expect("one constraint");
    let mut load = zero;
    for (reaction, direction) in reactions.as_flattened().iter().zip(seen.directions.as_flattened()) {
        (0..4).for_each(|i| load[i] -= *reaction * direction[i]);
    }
    let dry = Dry::of(&system, &at, load).expect("one constraint");
    let mut found = Vec::new();
    consistent(&dry, &[Touch::Rest; 2], |regime| found.push((regime.regime, regime.motion[0][1])));
    // at the floor's limit the same rest has other names
    found.dedup_by_key(|(_, motion)| *motion);
    let up = [Mode::Slip(Forwards, Face::Front), Mode::Slip(Backwards, Face::Front)];
    assert_eq!(found, [([Mode::Stick(Face::Front); 2], q(0, 1)), (up, q(24, 13))]);
}

/// The construction of the claims regimes/ladder-rest/ambiguous and ambiguous-down, epsilon = 1, also beyond f^2 = 2.
#[test]
fn whatever_the_friction_some_load_lets_a_ladder_at_rest_stay_or_slide() {
    let (one, third) = (q(1, 1), q(1, 3));
    for (f, turn) in [(q(1, 2), q(2, 3)), (q(1, 1), q(3, 5)), (q(3, 2), q(1, 2)), (q(3, 1), q(2, 5))] {
        let steep = Circle::from_half_tangent(turn);
        for up in [true, false] {
            // from the contact that decides: the wall for up, the floor for down
            let ordered = |[a, b]: [[Rational; 2]; 2]| if up { [a, b] } else { [b, a] };
            let Circle { cos: c, sin: s } = steep;
            let at = leaning(if up { steep } else { Circle { cos: s, sin: c } }, q(0, 1));
            let u = f * s - c;
            assert_eq!(u.sign(), Some(1));
            let p = c + third / c + s * s / u;
            let (n1, n2, fall) = (q(10, 1), q(10, 1) + p / (f + f), (third - c * p) / s);
            let reactions = ordered([[n1 + p, -f * n1 - s + fall], [n2 - fall, f * n2 + c - p]]);
            let system = ladder(f);
            let seen = Seen::<_, 4, 2>::of(&system, &at, [q(0, 1); 4]).expect("one constraint");
            let mut load = [q(0, 1); 4];
            for (reaction, direction) in reactions.as_flattened().iter().zip(seen.directions.as_flattened()) {
                (0..4).for_each(|i| load[i] -= *reaction * direction[i]);
            }
            let dry = Dry::of(&system, &at, load).expect("one constraint");
            let mut motions = Vec::new();
            consistent(&dry, &[Touch::Rest; 2], |regime| motions.push(regime.motion.map(|pair| pair[1])));
            let slide = if up { [one + one, -one - one] } else { [-one - one, one + one] };
            let slide = [slide[0] * at.place[3], slide[1] * at.place[2]];
            assert!(motions.contains(&[q(0, 1); 2]) && motions.contains(&slide), "f = {f}: {motions:?}");
        }
    }
}

#[test]
fn the_ladders_own_weight_leaves_no_motion_or_two_beyond_four_thirds() {
    let angle = Circle { cos: q(15, 17), sin: q(8, 17) };
    for (friction, slow, fast) in [(q(27, 20), "none", "several"), (q(13, 10), "unique", "unique")] {
        let verdict = |spin| name(&decide(&ladder(friction), &leaning(angle, spin))).0;
        assert_eq!([verdict(q(1, 10)), verdict(q(5, 1))], [slow, fast], "f = {friction}");
    }
}

#[test]
fn at_rest_its_own_weight_leaves_the_ladder_one_motion() {
    for angle in (1..40).map(|k| Circle::from_half_tangent(q(k, 41))) {
        for friction in (0..12).map(|k| q(k, 4)) {
            let found = decide(&ladder(friction), &leaning(angle, q(0, 1)));
            assert_eq!(name(&found).0, "unique", "f = {friction} at {angle:?}");
        }
    }
}
