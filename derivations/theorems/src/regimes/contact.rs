//! One contact with friction in an arbitrary system, with symbols for b and W.

use super::alphabet::letter;
use claims::{Condition, Line, Page};
use field::Scalar;
use mechanics::constrained::contacts::Sides;
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::{Condition as Margin, Direction, Dry, Face, Mode, Touch, conditions};
use symbolic::Sym;

use Condition::{Equal, Positive};
use Direction::{Backwards, Forwards};

const STICK: Mode = Mode::Stick(Face::Front);

pub fn claims(page: &mut Page) {
    page.section("One contact");
    let dry = arbitrary();
    moving(page, &dry);
    at_rest(page, &dry);
}

/// An arbitrary system with one one-sided contact.
fn arbitrary() -> Dry<Sym, 1> {
    let [nn, nt, tt] = ["Wnn", "Wnt", "Wtt"].map(letter);
    Dry {
        free: [[letter("bn"), letter("bt")]],
        response: [[[[nn, nt]], [[nt, tt]]]],
        friction: [letter("f")],
        sides: [Sides::One],
    }
}

fn slip(direction: Direction) -> Mode {
    Mode::Slip(direction, Face::Front)
}

/// The margin of an inequality that a contact regime requires, multiplied by the regime's determinant.
fn margin(dry: &Dry<Sym, 1>, mode: Mode, which: Margin) -> Sym {
    let cramer = Cramer::of(dry, &[mode]);
    let list = conditions(dry, &[Touch::Rest], &[mode]);
    let found = list.as_flattened().iter().flatten().find(|(name, _)| *name == which);
    found.map_or(Sym::UNDEFINED, |(_, form)| cramer.numerator(form))
}

fn determinant(dry: &Dry<Sym, 1>, mode: Mode) -> Sym {
    Cramer::of(dry, &[mode]).determinant
}

fn moving(page: &mut Page, dry: &Dry<Sym, 1>) {
    let [bn, nn, nt, f] = ["bn", "Wnn", "Wnt", "f"].map(letter);
    for (name, slug, direction) in [("D+", "forwards", Forwards), ("D-", "backwards", Backwards)] {
        page.claim(
            "contact-moving",
            slug,
            format!("One rough contact of any system has the determinant below for the slip {slug}"),
        )
        .holds([Line::formula(
            determinant(dry, slip(direction)),
            letter(name),
            nn - direction.sign::<Sym>() * f * nt,
        )]);
        page.claim("contact-moving", if direction == Forwards { "forwards-pressed" } else { "backwards-pressed" }, format!(r"One rough contact in the slip {slug} has $D_\pm N = -b_n$, while separation asks for $b_n\ge0$. So $D_\pm>0$ leaves one motion for every $b_n$; $D_\pm<0$ leaves two for $b_n>0$ and none for $b_n<0$; $D_\pm=0$ leaves none for $b_n<0$ and any $N\ge0$ for $b_n=0$"))
            .follows([Equal(margin(dry, slip(direction), Margin::Presses), -bn)]);
    }
}

fn at_rest(page: &mut Page, dry: &Dry<Sym, 1>) {
    let det = determinant(dry, STICK);
    let [nn, f, bn] = ["Wnn", "f", "bn"].map(letter);
    let limits = [(Forwards, Margin::HoldsBackwards), (Backwards, Margin::HoldsForwards)];
    let pairs =
        limits.map(|(direction, limit)| (margin(dry, STICK, limit), margin(dry, slip(direction), Margin::Departs)));
    page.claim("contact-rest", "either-or", r"One rough contact at rest has a margin of stick against a slip which, times $\det W$, is minus the margin of that slip's departure times its $D_\pm$. Where both determinants are positive, just one of the two is consistent, and at the tie they are one motion")
        .in_words()
        .follows(pairs.map(|(holds, departs)| Equal(holds, -departs)));
    let [plus, minus] = [Forwards, Backwards].map(|direction| determinant(dry, slip(direction)));
    let [(backwards, _), (forwards, _)] = pairs;
    page.claim("contact-rest", "one-at-most", r"One rough contact in stick has $\det W\,[(fN+T)D_- + (fN-T)D_+] = -2f\,b_n\det W$. With $D_\pm>0$ at most one limit of friction is passed under a pressing load ($b_n<0$), where regimes/contact-rest/either-or leaves one regime, and stick fails under a lifting one ($b_n>0$)")
        .in_words()
        .follows([Equal(backwards * minus + forwards * plus, -(Sym::int(2) * f * bn * det))]);
    page.claim(
        "contact-rest",
        "smooth",
        r"For one contact without friction both determinants $D_\pm$ are $W_{nn}$, which is positive",
    )
    .given([Positive(nn)])
    .by_signs([plus, minus].map(|d| Positive(d.substitute(&[(f, Sym::ZERO)]))));
}
