//! Reduced models of a text model, each named by the neglected elements.
//!
//! | in the name | neglected | exact if |
//! |---|---|---|
//! | `without k` | the element whose parameter is k: k = 0 | the element has no effect along the run |
//! | `rigid k` | the elongation of the spring of stiffness k, or the motion in the damper of coefficient k: zero | k is infinite |
//! | `quasi-steady x` | the rate of x: x has the value for which its rate vanishes | x relaxes instantaneously |
//! | `fixed x` | the equation of x: x keeps its initial value, without a constraint force | its rate vanishes |
//! | `unfollowed x` | the equation of x | no output and no other rate depends on x |
//! | `equal x=y` | the equation of x, which equals y | x and y have equal initial values and rates |
//! | `linear` | all nonlinear terms: the law is linearised about zero | the law is linear |
//!
//! Parts are joined by semicolons, names within a part by commas: `quasi-steady i1,i2; unfollowed phi`. A run accepts
//! such a name: [`SimplifiedScene`].

mod balance;
pub(super) mod candidates;
pub(super) mod linear_error;
mod reduced_law;
mod scene;

pub use scene::SimplifiedScene;

use std::fmt;

/// The elements that a reduced model neglects, by the names of parameters and of states.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Simplification {
    /// Parameters that are zero.
    pub without: Vec<String>,
    /// Parameters of springs and dampers that tend to infinity.
    pub rigid: Vec<String>,
    /// States whose rates are set to zero; for a coordinate also its speed is zero.
    pub quasi_steady: Vec<String>,
    /// States that keep their initial values.
    pub fixed: Vec<String>,
    /// States on which no output and no other rate depends.
    pub unfollowed: Vec<String>,
    /// Pairs `x=y`: a state, and the retained state that it equals.
    pub equal: Vec<String>,
    /// Whether the law is linearised about the zero of all states.
    pub linear: bool,
}

/// The keywords followed by names of parameters or states.
const KINDS: [&str; 6] = ["without", "rigid", "quasi-steady", "fixed", "unfollowed", "equal"];
/// The keyword without names.
const LINEAR: &str = "linear";

impl Simplification {
    /// Parses the name of a simplification.
    ///
    /// # Errors
    /// The part that is not understood, with the accepted forms.
    pub fn parse(name: &str) -> Result<Self, String> {
        let mut found = Simplification::default();
        for part in name.split(';').map(str::trim) {
            if part == LINEAR {
                found.linear = true;
                continue;
            }
            let (kind, names) = part.split_once(' ').unwrap_or((part, ""));
            let names: Vec<String> =
                names.split(',').map(str::trim).filter(|name| !name.is_empty()).map(str::to_owned).collect();
            let lists = found.lists_mut();
            let list = match KINDS.iter().position(|known| *known == kind) {
                Some(place) if !names.is_empty() => &mut *lists[place].1,
                _ => {
                    return Err(format!(
                        "`{part}` names no smaller model. With parameters: \"without P\", \"rigid P\"; with states: \"quasi-steady X\", \"fixed X\", \
                         \"unfollowed X\", \"equal X=Y\"; without a name: \"linear\". Several names are separated by commas, several parts by \
                         semicolons"
                    ));
                }
            };
            list.extend(names);
        }
        Ok(found)
    }

    /// Whether the model has a law of its own, and not only other parameter values.
    pub fn has_own_law(&self) -> bool {
        self.linear || self.lists().iter().skip(2).any(|(_, names)| !names.is_empty())
    }

    /// The combination of both simplifications.
    #[must_use]
    pub fn and(&self, other: &Self) -> Self {
        let mut both = self.clone();
        for ((_, list), (_, more)) in both.lists_mut().into_iter().zip(other.lists()) {
            list.extend(more.iter().filter(|name| !list.contains(name)).cloned().collect::<Vec<_>>());
        }
        both.linear |= other.linear;
        both
    }

    fn lists(&self) -> [(&'static str, &Vec<String>); 6] {
        let [without, rigid, quasi_steady, fixed, unfollowed, equal] = KINDS;
        [
            (without, &self.without),
            (rigid, &self.rigid),
            (quasi_steady, &self.quasi_steady),
            (fixed, &self.fixed),
            (unfollowed, &self.unfollowed),
            (equal, &self.equal),
        ]
    }

    fn lists_mut(&mut self) -> [(&'static str, &mut Vec<String>); 6] {
        let [without, rigid, quasi_steady, fixed, unfollowed, equal] = KINDS;
        [
            (without, &mut self.without),
            (rigid, &mut self.rigid),
            (quasi_steady, &mut self.quasi_steady),
            (fixed, &mut self.fixed),
            (unfollowed, &mut self.unfollowed),
            (equal, &mut self.equal),
        ]
    }

    /// The neglected elements, in words, compared with the scene's own model.
    pub fn dropped(&self) -> String {
        let words = [
            "the elements of these parameters: ",
            "the stretch of springs, and the motion in dampers, of these parameters: ",
            "transients, each has the value at which its equation balances: ",
            "motions, each keeps its value at the start: ",
            "equations that nothing asked for depends on: ",
            "equations of states that are others all along: ",
        ];
        let said = words.iter().zip(self.lists()).filter(|(_, (_, names))| !names.is_empty());
        let said = said.map(|(words, (_, names))| format!("{words}{}", names.join(", ")));
        let linear = self.linear.then(|| "all that is not linear in the states, about their zero".to_owned());
        said.chain(linear).collect::<Vec<_>>().join("; ")
    }
}

impl fmt::Display for Simplification {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = self.lists().into_iter().filter(|(_, names)| !names.is_empty());
        let parts = parts.map(|(kind, names)| format!("{kind} {}", names.join(",")));
        let parts: Vec<String> = parts.chain(self.linear.then(|| LINEAR.to_owned())).collect();
        write!(f, "{}", parts.join("; "))
    }
}

#[cfg(test)]
mod tests {
    use super::Simplification;

    #[test]
    fn a_name_is_read_back_and_what_is_none_is_refused_with_what_is_accepted() {
        for name in
            ["without mu", "quasi-steady i1,i2; unfollowed phi", "without a,b; fixed x,x'", "equal b=a,b'=a'; linear"]
        {
            assert_eq!(Simplification::parse(name).expect("a name").to_string(), name);
        }
        for name in ["", "without", "slow x", "quasi-steady ,"] {
            assert!(Simplification::parse(name).expect_err("none").contains("without a name: \"linear\""), "{name}");
        }
    }
}
