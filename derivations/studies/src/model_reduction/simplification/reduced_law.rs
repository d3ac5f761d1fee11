//! The law of the states that a simplification retains.

use super::Simplification;
use super::balance::balanced;
use crate::model_reduction::reduced_model::Lower;
use field::Over;
use integrators::Ode;
use simulation::SymbolicLaw;
use std::sync::Arc;
use symbolic::{Hypotheses, Sym, apart, decide, substitute_all};

/// The role of a state in a reduced model.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Role {
    Followed,
    Fixed(f64),
    /// The speed of a quasi-steady coordinate: zero.
    Resting,
    /// An algebraic state, whose value makes the rate of the state with this index vanish.
    Balancing(usize),
    /// A state equal to a retained one.
    Same(usize),
}

/// The roles of all states.
#[derive(Clone, Debug)]
struct Roles(Vec<Role>);

/// The law of the retained states and the lift to all states, from the names of the states and the initial state.
///
/// # Errors
/// A name of no state, or the reason why there is no such law.
pub(super) fn lower(
    written: &Arc<dyn SymbolicLaw>,
    names: &[String],
    start: &[f64],
    simplification: &Simplification,
) -> Result<Lower, String> {
    let place = |name: &String| {
        let place = names.iter().position(|known| known == name);
        place.ok_or_else(|| format!("no state is called `{name}`; known: {}", names.join(", ")))
    };
    let linear: Arc<dyn SymbolicLaw> = Arc::new(LinearLaw(Arc::clone(written)));
    let written = if simplification.linear { &linear } else { written };
    let mut roles = Roles(vec![Role::Followed; start.len()]);
    for pair in &simplification.equal {
        let (one, other) = pair.split_once('=').ok_or_else(|| format!("`{pair}` is no pair of states such as b=a"))?;
        let [one, other] = [place(&one.trim().to_owned())?, place(&other.trim().to_owned())?];
        roles.0[one] = Role::Same(other);
    }
    for name in simplification.fixed.iter().chain(&simplification.unfollowed) {
        let at = place(name)?;
        roles.0[at] = Role::Fixed(start[at]);
    }
    for name in &simplification.quasi_steady {
        let at = place(name)?;
        let speed = speed_of(&**written, at);
        match speed {
            // a coordinate makes the rate of its speed vanish, and its speed is zero
            Some(speed) => {
                roles.0[at] = Role::Balancing(speed);
                roles.0[speed] = Role::Resting;
            }
            None => roles.0[at] = Role::Balancing(at),
        }
    }
    for name in &simplification.fixed {
        let at = place(name)?;
        if let Some(speed) = speed_of(&**written, at).filter(|speed| !matches!(roles.0[*speed], Role::Fixed(_))) {
            return Err(format!("{name} moves at the speed {}: both are fixed, or neither", names[speed]));
        }
    }
    let unequal = |role: &Role| matches!(role, Role::Same(other) if roles.0[*other] != Role::Followed);
    if let Some(at) = roles.0.iter().position(unequal) {
        return Err(format!("{} is equal to a state that is not followed itself", names[at]));
    }
    roles.check_exact(&**written, names, start, simplification)?;
    if simplification.linear && !has_values_at_zero(&**written) {
        return Err("its equations have no values where all states are zero".to_owned());
    }
    let has_balance = apart(|| {
        let time = Sym::symbol("t");
        let z: Vec<Sym> = (0..roles.followed().count()).map(|i| Sym::symbol(&format!("z{i}"))).collect();
        roles.lifted(&**written, time, &z).is_some()
    });
    if !has_balance {
        let names = simplification.quasi_steady.join(", ");
        return Err(format!("the equations of {names} are not linear in them, or do not determine them"));
    }
    if roles.followed().next().is_none() {
        return Err("no state is left to be followed".to_owned());
    }
    let (lifting, following) = (roles.clone(), roles.clone());
    let (of_lift, of_rates) = (Arc::clone(written), Arc::clone(written));
    let undefined = |states: usize| vec![Sym::UNDEFINED; states];
    let lift =
        move |time: Sym, z: &[Sym]| lifting.lifted(&*of_lift, time, z).unwrap_or_else(|| undefined(lifting.0.len()));
    let rates = move |time: Sym, z: &[Sym]| {
        let y = following.lifted(&*of_rates, time, z).unwrap_or_else(|| undefined(following.0.len()));
        let mut all = vec![Sym::ZERO; y.len()];
        of_rates.rates(time, &y, &mut all);
        following.followed().map(|place| all[place]).collect()
    };
    let kept: Vec<usize> = roles.followed().collect();
    Ok(Lower { dimension: kept.len(), lift: Arc::new(lift), rates: Arc::new(rates), kept: Some(kept) })
}

/// The state that is the rate of a coordinate, if its rate is a single state.
fn speed_of(written: &dyn SymbolicLaw, coordinate: usize) -> Option<usize> {
    simulation::traced(written, |traced| {
        let rate = traced.rates[coordinate];
        traced.state.iter().position(|state| *state == rate)
    })
}

impl Roles {
    /// Checks the exact parts: no retained rate depends on an unfollowed state, and states declared equal are equal at
    /// the start and later.
    fn check_exact(
        &self,
        written: &dyn SymbolicLaw,
        names: &[String],
        start: &[f64],
        simplification: &Simplification,
    ) -> Result<(), String> {
        let is_unfollowed = |at: usize| simplification.unfollowed.contains(&names[at]);
        simulation::traced(written, |traced| {
            for (at, rate) in traced.rates.iter().enumerate().filter(|(at, _)| !is_unfollowed(*at)) {
                // the rate of a fixed state, or of one equal to another, is not needed
                if matches!(self.0[at], Role::Fixed(_) | Role::Same(_)) {
                    continue;
                }
                let used = rate.symbols_of();
                if let Some(other) = (0..names.len()).find(|&j| is_unfollowed(j) && used.contains(&traced.state[j])) {
                    return Err(format!(
                        "the rate of {} depends on {}, which must be followed",
                        names[at], names[other]
                    ));
                }
            }
            let pairs = || {
                self.0.iter().enumerate().filter_map(|(at, role)| match role {
                    Role::Same(other) => Some((at, *other)),
                    _ => None,
                })
            };
            let same: Vec<(Sym, Sym)> = pairs().map(|(one, other)| (traced.state[one], traced.state[other])).collect();
            for (one, other) in pairs() {
                if start[one] != start[other] {
                    return Err(format!(
                        "{} and {} do not start alike: {} and {}",
                        names[one], names[other], start[one], start[other]
                    ));
                }
                let apart = (traced.rates[one] - traced.rates[other]).substitute(&same);
                if !decide(apart, &Hypotheses::none()).is_zero() {
                    return Err(format!("the rates of {} and {} are not alike", names[one], names[other]));
                }
            }
            Ok(())
        })
    }

    fn followed(&self) -> impl Iterator<Item = usize> {
        self.0.iter().enumerate().filter(|(_, role)| **role == Role::Followed).map(|(place, _)| place)
    }

    /// All states as functions of the retained ones; `None` where the equations of quasi-steady states cannot be
    /// solved.
    fn lifted(&self, written: &dyn SymbolicLaw, time: Sym, z: &[Sym]) -> Option<Vec<Sym>> {
        let mut followed = z.iter();
        let mut y: Vec<Sym> = Vec::with_capacity(self.0.len());
        let (mut unknowns, mut rows) = (Vec::new(), Vec::new());
        for role in &self.0 {
            y.push(match role {
                Role::Followed => *followed.next()?,
                Role::Fixed(value) => Sym::lift(*value),
                // replaced below
                Role::Resting | Role::Same(_) => Sym::ZERO,
                Role::Balancing(row) => {
                    let unknown = Sym::symbol(&format!("balance{}", unknowns.len()));
                    unknowns.push(unknown);
                    rows.push(*row);
                    unknown
                }
            });
        }
        for (at, role) in self.0.iter().enumerate() {
            if let Role::Same(other) = role {
                y[at] = y[*other];
            }
        }
        if unknowns.is_empty() {
            return Some(y);
        }
        let mut rates = vec![Sym::ZERO; y.len()];
        written.rates(time, &y, &mut rates);
        let rates: Vec<Sym> = rows.into_iter().map(|row| rates[row]).collect();
        let values: Vec<(Sym, Sym)> = unknowns.iter().copied().zip(balanced(&rates, &unknowns)?).collect();
        Some(substitute_all(&y, &values))
    }
}

/// Whether all rates of a law are defined.
fn has_values_at_zero(law: &dyn SymbolicLaw) -> bool {
    simulation::traced(law, |traced| !traced.rates.contains(&Sym::UNDEFINED))
}

/// A law linearised about the zero of all states: F(t, 0) + F_y(t, 0) y.
struct LinearLaw(Arc<dyn SymbolicLaw>);

impl Ode<Sym> for LinearLaw {
    fn dimension(&self) -> usize {
        self.0.dimension()
    }

    fn rates(&self, t: Sym, y: &[Sym], dy: &mut [Sym]) {
        let letters: Vec<Sym> = (0..y.len()).map(|i| Sym::symbol(&format!("state{i}"))).collect();
        self.0.rates(t, &letters, dy);
        let zeros: Vec<(Sym, Sym)> = letters.iter().map(|letter| (*letter, Sym::ZERO)).collect();
        for rate in dy {
            let slopes: Vec<Sym> = letters.iter().map(|letter| rate.diff(*letter)).collect();
            let at_zero = substitute_all(&[&[*rate], &slopes[..]].concat(), &zeros);
            *rate = at_zero[1..].iter().zip(y).fold(at_zero[0], |sum, (slope, y)| sum + *slope * *y);
        }
    }
}
