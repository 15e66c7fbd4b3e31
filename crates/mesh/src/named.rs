//! Enums with string ids.

/// An enum declared with [`named!`](crate::named!), for code that handles any of them.
pub trait Named: Copy + 'static {
    /// All variants, in declaration order.
    const ALL: &'static [Self];

    /// The stable id in files, on the command line and in panels.
    fn id(self) -> &'static str;

    /// The variant with this id.
    fn from_id(id: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|one| one.id() == id)
    }
}

/// Declares an enum whose variants have string ids: `Variant = "id"`.
///
/// The macro adds `ALL`, the variants in declaration order; `id`, the stable id of a variant in files, on the command
/// line and in panels; and `from_id`, its inverse. Translations are looked up by id. It also implements [`Named`].
///
/// ```
/// rosto_mesh::named! {
///     /// A primary colour.
///     #[derive(Debug, Clone, Copy, PartialEq)]
///     pub enum Primary {
///         /// Wavelengths around 650 nm.
///         Red = "red",
///         /// Wavelengths around 450 nm.
///         Blue = "blue",
///     }
/// }
/// assert_eq!(Primary::ALL.map(Primary::id), ["red", "blue"]);
/// assert_eq!(Primary::from_id("blue"), Some(Primary::Blue));
/// assert_eq!(Primary::from_id("green"), None);
/// ```
#[macro_export]
macro_rules! named {
    (
        $(#[$about:meta])*
        $public:vis enum $name:ident {
            $($(#[$about_variant:meta])* $variant:ident = $id:literal,)+
        }
    ) => {
        $(#[$about])*
        $public enum $name {
            $($(#[$about_variant])* $variant,)+
        }

        impl $name {
            /// All variants, in declaration order.
            pub const ALL: [Self; [$($id),+].len()] = [$(Self::$variant),+];

            /// The stable id in files, on the command line and in panels.
            pub const fn id(self) -> &'static str {
                match self {
                    $(Self::$variant => $id,)+
                }
            }

            /// The variant with this id.
            pub fn from_id(id: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|one| one.id() == id)
            }
        }

        impl $crate::Named for $name {
            const ALL: &'static [Self] = &Self::ALL;

            fn id(self) -> &'static str {
                self.id()
            }
        }
    };
}
