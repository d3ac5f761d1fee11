//! A part of an ensemble: a contiguous range of members. The sizes of parts differ by at most one.

use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

/// Part `number`, counted from 1, of `parts`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    number: u64,
    parts: u64,
}

impl Part {
    /// The members of the part, for an ensemble of this many members; `None` where there are fewer members than parts.
    pub fn of(self, members: u64) -> Option<RangeInclusive<u64>> {
        let end = |number: u64| (u128::from(number) * u128::from(members) / u128::from(self.parts)) as u64;
        (self.parts <= members).then(|| end(self.number - 1) + 1..=end(self.number))
    }
}

impl FromStr for Part {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers =
            text.split_once('/').and_then(|(number, parts)| Some((number.parse().ok()?, parts.parse().ok()?)));
        match numbers {
            Some((number, parts)) if 1 <= number && number <= parts => Ok(Part { number, parts }),
            _ => Err("a part and the number of all parts are accepted, from 1/1 on: 3/8".to_owned()),
        }
    }
}

/// Formats as `I-of-N`, for names of files; the alternate form `{:#}` gives `I/N`, the form of the option.
impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let between = if f.alternate() { "/" } else { "-of-" };
        write!(f, "{}{between}{}", self.number, self.parts)
    }
}

#[cfg(test)]
mod tests {
    use super::Part;

    #[test]
    fn parts_have_every_member_once() {
        for (members, parts) in [(10, 3), (7, 7), (1_000_000_007, 13)] {
            let mut next = 1;
            for number in 1..=parts {
                let own = Part { number, parts }.of(members).expect("there are enough");
                assert!(*own.start() == next && own.end() >= own.start(), "{own:?}");
                next = own.end() + 1;
            }
            assert_eq!(next, members + 1);
        }
        assert!(Part { number: 1, parts: 8 }.of(7).is_none());
        for wrong in ["0/3", "4/3", "3", "1/0", "a/b", "-1/2", "1/2/3"] {
            assert!(wrong.parse::<Part>().is_err(), "{wrong}");
        }
    }
}
