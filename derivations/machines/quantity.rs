//! Parameters and states as named quantities with units.

/// A number: its name in files and formulas, its unit, what it means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    pub name: &'static str,
    pub unit: &'static str,
    pub meaning: &'static str,
    /// Whether it must be above zero to exist.
    pub positive: bool,
}

impl Quantity {
    /// One that may have any value.
    pub const fn any(name: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        Quantity { name, unit, meaning, positive: false }
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
/// assert_eq!((doubled.k, Spring::<f64>::QUANTITIES[0].unit), (3.0, "N m"));
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
        $crate::machines::Quantity {
            name: stringify!($field),
            unit: $unit,
            meaning: $meaning.trim_ascii(),
            positive: !stringify!($($bound)?).is_empty(),
        }
    };
}
