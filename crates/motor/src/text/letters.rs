//! The symbols and operations allowed in the expressions of a motor, with reasons for the rejection of others.

use symbolic::{Dimension, HIGHEST_MULTIPLE, Node, Reason, Sym, Vocabulary, dimension};

/// The angle g from the stator's field to the rotor.
pub const ANGLE: &str = "g";
/// The slip g'.
pub const SLIP: &str = "g'";
/// The speed phi' relative to the stator.
pub const SPEED: &str = "phi'";

/// The accepted form of a motional voltage.
const AFFINE: &str = "affine in the currents: a constant, and constant multiples of them";

/// The phrase for mutual induction, which the laws do not support.
pub const INDUCED: &str = "no winding induces in another: M di/dt stands in no law";

/// The largest number of digits of numerator and denominator of a number.
const DIGITS: i32 = 18;

/// The variables of the motion that an expression may contain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KnownMotion {
    /// None: parameters only.
    Rest,
    /// The angle, by its cosine and sine.
    Angle,
    /// The slip and the speed.
    Speeds,
    /// The currents of the windings.
    Currents,
}

/// Whether a name is reserved for a variable of the motion or a function.
pub fn is_taken(name: &str) -> bool {
    [ANGLE, SLIP, SPEED, "cos", "sin", "sqrt"].contains(&name)
}

/// The symbols of one expression: parameters with their dimensions, and the variables of the motion that it may
/// contain.
#[derive(Clone, Debug)]
pub struct Letters<'a> {
    pub parameters: &'a [(String, Dimension)],
    /// The currents of every winding, by name.
    pub currents: &'a [String],
    pub motion: KnownMotion,
}

impl Letters<'_> {
    /// The dimension of an expression; `None` for zero, which has any dimension.
    ///
    /// # Errors
    /// Terms of different dimensions, or an angle that is not a pure number.
    pub fn dimension(&self, expression: Sym) -> Result<Option<Dimension>, Reason> {
        let of = |name: &str| match name {
            ANGLE => Some(Dimension::none()),
            SLIP | SPEED => Some(Dimension::none() / Dimension::time()),
            _ if self.is_current(name) => Some(Dimension::current()),
            _ => self.parameters.iter().find(|(known, _)| known == name).map(|(_, dimension)| *dimension),
        };
        dimension(expression, &of).map_err(|mismatch| Reason::Refused(mismatch.to_string()))
    }

    /// All allowed symbols, for messages.
    pub fn known(&self) -> String {
        let motion = match self.motion {
            KnownMotion::Rest => Vec::new(),
            KnownMotion::Angle => vec!["cos(g), sin(g) of the angle g to the field".to_owned()],
            KnownMotion::Speeds => vec!["the slip g'".to_owned(), "the speed phi'".to_owned()],
            KnownMotion::Currents => self.currents.to_vec(),
        };
        let names = motion.into_iter().chain(self.parameters.iter().map(|(name, _)| name.clone()));
        let mut known: Vec<String> = Vec::new();
        for name in names {
            if !known.contains(&name) {
                known.push(name);
            }
        }
        known.join(", ")
    }

    /// The reason why no law has this symbol of textbooks; `None` for other names.
    fn never_known(&self, name: &str) -> Option<String> {
        let rate = name.trim_end_matches(['\'', '\u{2032}', '\u{2033}']);
        match name {
            "t" | "time" => Some(
                "the laws of a motor as text do not depend on time: a field of constant speed is described by the angle g to the field, as in \
                 `supply = \"v*cos(g)\"`"
                    .to_owned(),
            ),
            "phi" => Some("no law knows the angle phi itself: laws know g, the angle from the field to the rotor".to_owned()),
            _ if rate != name && self.is_current(rate) => Some(format!("`{name}` is the rate of a current, and {INDUCED}")),
            _ => None,
        }
    }

    fn is_current(&self, name: &str) -> bool {
        self.currents.iter().any(|current| current == name)
    }

    fn moves(&self, leaf: Sym) -> bool {
        let moving = |symbol: &Sym| {
            symbol.symbol_name().is_some_and(|name| [ANGLE, SLIP, SPEED].contains(&&*name) || self.is_current(&name))
        };
        leaf.symbols_of().iter().any(moving)
    }
}

impl Vocabulary for Letters<'_> {
    fn name(&self, name: &str, in_angle: bool) -> Result<Sym, Reason> {
        let refused = |why: &str| Err(Reason::Refused(why.to_owned()));
        match (name, self.motion) {
            (ANGLE, KnownMotion::Angle) if in_angle => Ok(Sym::symbol(name)),
            (ANGLE, KnownMotion::Angle) => {
                refused("the angle stands in cos and sin alone: a whole turn changes no law")
            }
            (SLIP | SPEED, KnownMotion::Speeds) => Ok(Sym::symbol(name)),
            (ANGLE | SLIP | SPEED, KnownMotion::Rest) => refused("the data of a winding do not know the motion"),
            (ANGLE, _) => refused(
                "a torque that depends on the angle comes from `field_energy` or from fluxes, else energy is lost",
            ),
            (SLIP | SPEED, _) => refused(
                "a law of the angle or the currents does not depend on speeds, which are accepted in `torque_law`",
            ),
            (_, KnownMotion::Currents) if self.is_current(name) => Ok(Sym::symbol(name)),
            (_, KnownMotion::Rest) if self.is_current(name) => {
                refused(&format!("the data of a winding do not know the currents: nothing saturates, and {INDUCED}"))
            }
            (_, KnownMotion::Angle) if self.is_current(name) => {
                refused(&format!("no law of the angle knows a current: inductances are constant, and {INDUCED}"))
            }
            (_, KnownMotion::Speeds) if self.is_current(name) => {
                refused("a torque that depends on currents follows from `flux` and `motional`, else energy is lost")
            }
            _ if self.parameters.iter().any(|(known, _)| known == name) => Ok(Sym::symbol(name)),
            _ => Err(self.never_known(name).map_or_else(|| Reason::Name(name.to_owned()), Reason::Refused)),
        }
    }

    fn judge(&self, part: Sym) -> Result<(), Reason> {
        self.dimension(part)?;
        let refused = |why: String| Err(Reason::Refused(why));
        if let Some(value) = part.as_constant() {
            let small = value
                .to_big()
                .is_some_and(|big| i64::try_from(big.numerator()).is_ok() && i64::try_from(big.denominator()).is_ok());
            if !small {
                return refused(format!("a number in a law has at most {DIGITS} digits above and below the line"));
            }
        }
        let slides = |side: Sym| self.motion == KnownMotion::Currents && self.moves(side);
        match part.node() {
            Node::Product(a, b) if slides(a) && slides(b) => return refused(AFFINE.to_owned()),
            Node::Quotient(_, divisor) if slides(divisor) => return refused(AFFINE.to_owned()),
            Node::Power(base, _) if slides(base) => return refused(AFFINE.to_owned()),
            _ => {}
        }
        for leaf in part.leaves_of().into_iter().filter(|leaf| self.moves(*leaf)) {
            match leaf.node() {
                Node::Cos(angle) | Node::Sin(angle) if angle.symbol_name().as_deref() != Some(ANGLE) => {
                    return refused(format!(
                        "the angle enters by whole multiples up to {HIGHEST_MULTIPLE}, as in cos(2*g + a)"
                    ));
                }
                Node::Root(_) => {
                    return refused("roots are of parameters alone: a law is a fraction of polynomials".to_owned());
                }
                _ => {}
            }
        }
        Ok(())
    }
}
