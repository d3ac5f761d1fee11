//! The fingerprint of an ensemble: a hash of all data that determine its members, and the program that computed them.
//!
//! Rows of one table belong together only if law, data, span, tolerance and seed are equal, and if the rounding is
//! equal: without fused multiply-add the last digits differ. The number of members and listed values are not part of
//! the fingerprint, so that an ensemble can be extended.

use super::EnsembleScene;
use super::run::MOST_STEPS;
use siphasher::sip::SipHasher24;
use std::fmt::{self, Display, Write};
use std::hash::Hasher;

/// The fingerprint, in the format `HASH:VERSION:PROCESSOR`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fingerprint {
    /// The hash of law, data, span, tolerance and seed.
    of_members: String,
    /// The version of the program, and the rounding of the processor.
    maker: String,
}

impl Fingerprint {
    /// The fingerprint of rows computed by this program on this machine.
    pub fn of(scene: &EnsembleScene) -> Self {
        let mut hash = Hashed(SipHasher24::new());
        let EnsembleScene { system, members: _, seed, varied } = scene;
        let (span, tolerance) = (system.run().span, system.run().tolerance);
        // writing to a hash cannot fail
        let _ = system.write_law(&mut hash);
        let _ = write!(hash, " {seed} {span:?} {tolerance:?} {MOST_STEPS} {}", system.name());
        for varied in varied {
            let _ = write!(hash, " {}", varied.distribution());
        }
        let rounds = if integrators::fuses() { "fused" } else { "unfused" };
        let (processor, system) = (std::env::consts::ARCH, std::env::consts::OS);
        let version = env!("CARGO_PKG_VERSION");
        Fingerprint {
            of_members: format!("h{:016x}", hash.0.finish()),
            maker: format!("{version}:{processor}-{system}-{rounds}"),
        }
    }

    /// The reason why a row with another fingerprint does not belong to this ensemble; `None` where it does.
    pub fn differs_from(&self, found: &str) -> Option<String> {
        if found == self.to_string() {
            return None;
        }
        Some(match found.split_once(':') {
            Some((of_members, maker)) if of_members == self.of_members => {
                format!("this row was computed by {maker}, whose last digits may differ from those of {}", self.maker)
            }
            _ => "another ensemble: its law, data, span, tolerance or seed differ from those of this scene".to_owned(),
        })
    }
}

impl Fingerprint {
    /// Whether a row with another fingerprint has equal law, data, span, tolerance and seed, on any machine.
    pub fn is_of_same_members(&self, found: &str) -> bool {
        found.split_once(':').is_some_and(|(of_members, _)| of_members == self.of_members)
    }
}

impl Display for Fingerprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.of_members, self.maker)
    }
}

/// Hashes a text while it is written.
struct Hashed(SipHasher24);

impl Write for Hashed {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write(text.as_bytes());
        Ok(())
    }
}
