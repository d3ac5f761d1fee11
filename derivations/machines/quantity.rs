//! Parameters of machines as named quantities with units.

/// A parameter: its name in files and formulas, its unit, what it means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    pub name: &'static str,
    pub unit: &'static str,
    pub meaning: &'static str,
}

/// A struct of parameters over any field, each with its unit and meaning:
///
/// ```
/// derivations::quantities! {
///     /// A spring.
///     pub struct Spring {
///         /// stiffness
///         k: "N m",
///     }
/// }
/// let doubled = Spring { k: 1.5 }.map(|x| 2.0 * x);
/// assert_eq!((doubled.k, Spring::<f64>::QUANTITIES[0].unit), (3.0, "N m"));
/// ```
#[macro_export]
macro_rules! quantities {
    ($(#[$outer:meta])* pub struct $name:ident { $(#[doc = $meaning:literal] $field:ident : $unit:literal),* $(,)? }) => {
        $(#[$outer])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<P> { $(#[doc = $meaning] pub $field: P),* }

        impl<P: Copy> $name<P> {
            /// The parameters in their order.
            pub const QUANTITIES: &'static [$crate::machines::Quantity] = &[
                $($crate::machines::Quantity { name: stringify!($field), unit: $unit, meaning: $meaning.trim_ascii() }),*
            ];

            /// Reads every parameter from a source: a file of data, or names as symbols.
            pub fn read<E>(mut source: impl FnMut(&'static $crate::machines::Quantity) -> Result<P, E>) -> Result<Self, E> {
                Ok(Self { $($field: source(const {
                    &$crate::machines::Quantity { name: stringify!($field), unit: $unit, meaning: $meaning.trim_ascii() }
                })?),* })
            }

            /// The same parameters in another field.
            pub fn map<T>(self, f: impl Fn(P) -> T) -> $name<T> {
                $name { $($field: f(self.$field)),* }
            }
        }
    };
}
