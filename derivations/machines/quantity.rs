//! Parameters and states as named quantities with units.

use std::borrow::Cow;

/// A number: its name in files and formulas, its unit, what it means. The texts are of the program, or of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    pub name: Cow<'static, str>,
    pub unit: Cow<'static, str>,
    pub meaning: Cow<'static, str>,
    /// Whether it must be above zero to exist.
    pub positive: bool,
}

impl Quantity {
    /// One that may have any value.
    pub const fn any(name: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        let [name, unit, meaning] = [Cow::Borrowed(name), Cow::Borrowed(unit), Cow::Borrowed(meaning)];
        Quantity { name, unit, meaning, positive: false }
    }

    /// One that must be above zero.
    pub const fn positive(name: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        let [name, unit, meaning] = [Cow::Borrowed(name), Cow::Borrowed(unit), Cow::Borrowed(meaning)];
        Quantity { name, unit, meaning, positive: true }
    }
}

/// A struct of parameters over any field, each with its unit and meaning, and `> 0` where a file must give a positive one:
///
/// ```
/// derivations::quantities! {
///     /// A spring.
///     pub struct Spring {
///         /// stiffness
///         k: "N m" > 0,
///     }
/// }
/// let doubled = Spring { k: 1.5 }.map(|x| 2.0 * x);
/// assert_eq!(doubled.k, 3.0);
/// assert_eq!(Spring::<f64>::QUANTITIES[0].unit, "N m");
/// assert!(Spring::<f64>::QUANTITIES[0].positive);
/// ```
#[macro_export]
macro_rules! quantities {
    ($(#[$outer:meta])* pub struct $name:ident { $(#[doc = $meaning:literal] $field:ident : $unit:literal $(> $bound:literal)?),* $(,)? }) => {
        $(#[$outer])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<P> { $(#[doc = $meaning] pub $field: P),* }

        impl<P: Copy> $name<P> {
            /// The parameters in their order.
            pub const QUANTITIES: &'static [$crate::machines::Quantity] = &[
                $($crate::quantities!(@one $meaning, $field, $unit, $($bound)?)),*
            ];

            /// Reads every parameter from a source: a file of data, or names as symbols.
            pub fn read<E>(mut source: impl FnMut(&'static $crate::machines::Quantity) -> Result<P, E>) -> Result<Self, E> {
                Ok(Self { $($field: source(const {
                    &$crate::quantities!(@one $meaning, $field, $unit, $($bound)?)
                })?),* })
            }

            /// The same parameters in another field.
            #[inline(always)]
            pub fn map<T>(self, f: impl Fn(P) -> T) -> $name<T> {
                $name { $($field: f(self.$field)),* }
            }
        }
    };
    (@one $meaning:literal, $field:ident, $unit:literal, $($bound:literal)?) => {
        if stringify!($($bound)?).is_empty() {
            $crate::machines::Quantity::any(stringify!($field), $unit, $meaning.trim_ascii())
        } else {
            $crate::machines::Quantity::positive(stringify!($field), $unit, $meaning.trim_ascii())
        }
    };
}
