use rosto_export::{ExportOption, Format};
use serde::Serialize;
use tsify::Tsify;

/// A file format, as an export panel offers it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct FormatFacts {
    /// Id, which is the file extension.
    pub id: &'static str,
    /// Media type.
    pub media_type: &'static str,
    /// Names of the file options that the format supports, as the worker's `FileOptions` has them.
    pub options: Vec<&'static str>,
    /// Whether it is a format for 3D printing, which contains a closed body.
    pub is_printed: bool,
    /// Whether it has no format-specific options, so that panels offer it as a plain button.
    pub is_plain: bool,
}

/// All file formats, in display order.
pub fn formats() -> Vec<FormatFacts> {
    Format::ALL.into_iter().map(FormatFacts::of).collect()
}

impl FormatFacts {
    fn of(format: Format) -> Self {
        let own = [ExportOption::Material, ExportOption::Units, ExportOption::Solid];
        let supported = ExportOption::ALL.into_iter().filter(|&option| format.supports(option));
        Self {
            id: format.id(),
            media_type: format.media_type(),
            options: supported.map(ExportOption::id).collect(),
            is_printed: format.supports(ExportOption::Solid),
            is_plain: !own.into_iter().any(|option| format.supports(option)),
        }
    }
}
