//! An enum as one table: its variants with the ids by which files, command lines and panels know them.

/// Declares an enum whose variants have ids: `Variant = "id"`.
///
/// The enum gets `ALL`, its variants in the order of the table; `id`, a variant's stable name for files, command lines and
/// panels; and `from_id`, the inverse of `id`. Words for people are looked up by the id, in any language.
///
/// ```
/// rosto_mesh::named! {
///     /// A primary colour.
///     #[derive(Debug, Clone, Copy, PartialEq)]
///     pub enum Primary {
///         /// Like blood.
///         Red = "red",
///         /// Like the sky.
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
            /// All of them, in the order of their definition.
            pub const ALL: [Self; [$($id),+].len()] = [$(Self::$variant),+];

            /// A stable name for files, command lines and panels.
            pub const fn id(self) -> &'static str {
                match self {
                    $(Self::$variant => $id,)+
                }
            }

            /// The one whose id this is.
            pub fn from_id(id: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|one| one.id() == id)
            }
        }
    };
}
