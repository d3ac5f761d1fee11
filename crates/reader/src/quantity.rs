//! Names, units, meanings and bounds of parameters and states.

use super::bound::Bound;
use std::borrow::Cow;

/// The description of a number: its name in files and formulas, its unit, its meaning. The text is part of the program or comes from a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    pub name: Cow<'static, str>,
    pub unit: Cow<'static, str>,
    pub meaning: Cow<'static, str>,
    /// The values that a file may give in the unit above.
    pub bound: Bound,
}

impl Quantity {
    /// Creates a quantity that may have any value.
    pub const fn any(name: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        Self::within(name, unit, meaning, Bound::Any)
    }

    /// Creates a quantity with a bound.
    pub const fn within(name: &'static str, unit: &'static str, meaning: &'static str, bound: Bound) -> Self {
        let [name, unit, meaning] = [Cow::Borrowed(name), Cow::Borrowed(unit), Cow::Borrowed(meaning)];
        Quantity { name, unit, meaning, bound }
    }
}

/// Defines a struct of parameters over any field `P`. Each parameter has a meaning (its doc comment), a unit, and optionally a bound:
/// `> 0`, `>= 0`, `!= 0`, `in resistance`, `in friction` (see [`Bound`](crate::Bound)).
///
/// ```
/// use dalembert_reader::Bound;
/// dalembert_reader::quantities! {
///     /// A spring.
///     pub struct Spring {
///         /// stiffness
///         k: "N m" > 0,
///         /// friction
///         f: "N m s" in friction,
///     }
/// }
/// let doubled = Spring { k: 1.5, f: 0.0 }.map(|x| 2.0 * x);
/// assert_eq!(doubled.k, 3.0);
/// assert_eq!(Spring::<f64>::QUANTITIES[0].unit, "N m");
/// assert_eq!(Spring::<f64>::QUANTITIES[0].bound, Bound::Positive);
/// assert_eq!(Spring::<f64>::QUANTITIES[1].bound, Bound::Friction);
/// ```
#[macro_export]
macro_rules! quantities {
    ($(#[$outer:meta])* pub struct $name:ident {
        $(#[doc = $meaning:literal] $field:ident : $unit:literal
            $(> $above:tt)? $(>= $least:tt)? $(!= $other:tt)? $(in $kind:ident)?),* $(,)?
    }) => {
        $(#[$outer])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<P> { $(#[doc = $meaning] pub $field: P),* }

        impl<P: Copy> $name<P> {
            /// The parameters in their order.
            pub const QUANTITIES: &'static [$crate::Quantity] = &[
                $($crate::quantities!(@one $meaning, $field, $unit, $(> $above)? $(>= $least)? $(!= $other)? $(in $kind)?)),*
            ];

            /// Reads every parameter from a source: a file of data, or names as symbols.
            pub fn read<E>(mut source: impl FnMut(&'static $crate::Quantity) -> Result<P, E>) -> Result<Self, E> {
                Ok(Self { $($field: source(const {
                    &$crate::quantities!(@one $meaning, $field, $unit, $(> $above)? $(>= $least)? $(!= $other)? $(in $kind)?)
                })?),* })
            }

            /// Applies a function to every parameter, for example a conversion to another scalar type.
            #[inline(always)]
            pub fn map<T>(self, f: impl Fn(P) -> T) -> $name<T> {
                $name { $($field: f(self.$field)),* }
            }
        }
    };
    (@one $meaning:literal, $field:ident, $unit:literal, $($bound:tt)*) => {
        $crate::Quantity::within(
            stringify!($field),
            $unit,
            $meaning.trim_ascii(),
            $crate::quantities!(@bound $($bound)*),
        )
    };
    (@bound) => { $crate::Bound::Any };
    (@bound > 0) => { $crate::Bound::Positive };
    (@bound >= 0) => { $crate::Bound::NotNegative };
    (@bound != 0) => { $crate::Bound::NotZero };
    (@bound in resistance) => { $crate::Bound::Resistance };
    (@bound in friction) => { $crate::Bound::Friction };
}
