use rosto::FileOptions;
use rosto_export::{DEPTH_MM, ExportOption, HEIGHT_MM, PrintHeight, SOLID_MM, Solid};
use rosto_stage::{Scene, Visibility};

use super::Session;
use crate::changed::Changed;
use crate::error::{SessionError, within};
use crate::files::Report;

impl Session {
    /// Options of exported files, by their ids.
    pub fn file_options(&self) -> Vec<(&'static str, String)> {
        let FileOptions { base_colour, material, edits, expressions, eyes, units, print, .. } = self.files.options;
        vec![
            (ExportOption::BaseColour.id(), base_colour.id().to_owned()),
            (ExportOption::TextureSize.id(), self.view().texture_size.id().to_owned()),
            (ExportOption::Material.id(), material.id().to_owned()),
            (ExportOption::Edits.id(), edits.id().to_owned()),
            (ExportOption::Expressions.id(), expressions.id().to_owned()),
            (ExportOption::Eyes.id(), eyes.id().to_owned()),
            (ExportOption::Units.id(), units.id().to_owned()),
            (ExportOption::Solid.id(), print.solid.to_string()),
            (ExportOption::Height.id(), print.height.to_string()),
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

    /// Shows the printed body in place of the 3D face, without marks and selection, or the face again. No effect while
    /// the photo or the live preview is displayed.
    pub fn show_print(&mut self, print: Visibility) {
        let is_busy = self.view.scene == Scene::Picture || self.live_preview.is_some();
        if self.view.print == print || (print == Visibility::Shown && (self.face.is_none() || is_busy)) {
            return;
        }
        self.view.print = print;
        self.hover(None);
        self.view.show_on(&mut self.stage, self.face.is_none());
        self.show_marks();
    }

    pub(super) fn set_file_options(&mut self, options: FileOptions) -> Result<Changed, SessionError> {
        if let PrintHeight::Mm(mm) = options.print.height {
            within("the height", mm, HEIGHT_MM[0], HEIGHT_MM[1])?;
        }
        match options.print.solid {
            Solid::Thickness { mm } => self.files.thickness_mm = within("the thickness", mm, SOLID_MM[0], SOLID_MM[1])?,
            Solid::FlatBack { depth_mm: Some(mm) } => {
                self.files.depth_mm = Some(within("the depth", mm, DEPTH_MM[0], DEPTH_MM[1])?);
            }
            Solid::FlatBack { depth_mm: None } | Solid::Surface => {}
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
