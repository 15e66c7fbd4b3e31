use rosto::FileOptions;
use rosto_export::{ExportOption, SOLID_MM, Solid};

use super::Session;
use crate::changed::Changed;
use crate::error::{SessionError, within};
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

    pub(super) fn set_file_options(&mut self, options: FileOptions) -> Result<Changed, SessionError> {
        let [min, max] = SOLID_MM;
        match options.solid {
            Solid::Thickness { mm } => self.files.thickness_mm = within("the thickness", mm, min, max)?,
            Solid::FlatBack { mm } => self.files.back_mm = within("the back", mm, min, max)?,
            Solid::Surface => {}
        }
        self.files.options = options;
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
