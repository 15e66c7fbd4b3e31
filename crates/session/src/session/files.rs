use rosto::FileOptions;
use rosto_export::{ExportOption, Solid};

use super::Session;
use crate::changed::Changed;
use crate::error::SessionError;
use crate::files::Report;

impl Session {
    /// Options of exported files, by their ids.
    pub fn file_options(&self) -> Vec<(&'static str, String)> {
        let FileOptions { base_colour, material, edits, expressions, eyes, units, solid, .. } = self.files.options;
        vec![
            (ExportOption::BaseColour.id(), base_colour.id().to_owned()),
            (ExportOption::TextureSize.id(), self.view().texture_size.id().to_owned()),
            (ExportOption::Material.id(), material.id().to_owned()),
            (ExportOption::Edits.id(), edits.id().to_owned()),
            (ExportOption::Expressions.id(), expressions.id().to_owned()),
            (ExportOption::Eyes.id(), eyes.id().to_owned()),
            (ExportOption::Units.id(), units.id().to_owned()),
            (ExportOption::Solid.id(), solid.to_string()),
        ]
    }

    /// Name of an exported mesh; with the number of its points unless it has the default density.
    pub fn file_name(&self, extension: &str) -> String {
        let stem = &self.files.stem;
        let points = self.face().map(|face| face.document().topology().vertex_count());
        match points.filter(|_| self.density() != rosto_studio::SMOOTH_DENSITY) {
            Some(points) => format!("{stem}-{points}.{extension}"),
            None => format!("{stem}.{extension}"),
        }
    }

    /// Sets the side of the whole-face texture, which depends on the pictures.
    pub fn set_texture_side_px(&mut self, side_px: Option<u32>) {
        self.files.texture_side_px = side_px;
    }

    /// Whether pictures have a transparent background.
    pub fn is_transparent(&self) -> bool {
        self.files.is_transparent
    }

    pub(crate) fn set_file_option(&mut self, option: ExportOption, value: &str) -> Result<Changed, SessionError> {
        let unknown = |_| SessionError::NoSuchWidget { id: option.id().to_owned() };
        self.files.options.set(option, value).map_err(unknown)?;
        match self.files.options.solid {
            Solid::Thickness { mm } => self.files.thickness_mm = mm,
            Solid::FlatBack { mm } => self.files.back_mm = mm,
            Solid::Surface => {}
        }
        Ok(Changed::Document)
    }

    pub(crate) fn set_transparent(&mut self, is_transparent: bool) -> Changed {
        self.files.is_transparent = is_transparent;
        Changed::View
    }

    /// Panels show a report; nothing else changes.
    pub(crate) fn take_report(&mut self, report: Report) -> Changed {
        self.files.take(report);
        Changed::View
    }
}
