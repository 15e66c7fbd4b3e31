/// Structs with read-only fields in JavaScript: `field as jsName: Type` renames a field, and `hidden` fields are not
/// exported.
macro_rules! readable {
    (
        $(#[$about:meta])*
        pub struct $name:ident {
            $($(#[$field_about:meta])* $field:ident $(as $js_name:ident)?: $type:ty,)*
        } $(hidden { $($(#[$hidden_about:meta])* $hidden:ident: $hidden_type:ty,)* })?
    ) => {
        $(#[$about])*
        #[wasm_bindgen(getter_with_clone, inspectable)]
        #[derive(Debug, Clone, PartialEq)]
        pub struct $name {
            $($(#[$field_about])* #[wasm_bindgen(readonly $(, js_name = $js_name)?)] pub $field: $type,)*
            $($($(#[$hidden_about])* $hidden: $hidden_type,)*)?
        }
    };
}

pub(crate) use readable;
