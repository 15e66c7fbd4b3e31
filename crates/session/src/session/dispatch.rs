use rosto_studio::{Document, Switch};

use super::intent::Intent;
use super::{Result, Session};
use crate::EditOptions;
use crate::open_face::OpenFace;
use crate::strokes::Strokes;

impl Session {
    /// Passes an intent to its handler.
    pub(super) fn dispatch(&mut self, intent: Intent) -> Result {
        match intent {
            Intent::Open(incoming) => self.open(*incoming),
            Intent::Close => self.close(),
            Intent::RestorePreferences(text) => self.prefer(&text),
            Intent::Expert(is_expert) => Ok(self.set_expert(is_expert)),
            Intent::FileOptions(options) => self.set_file_options(options),
            Intent::Transparent(is_transparent) => Ok(self.set_transparent(is_transparent)),
            Intent::Report(report) => Ok(self.take_report(report)),
            Intent::SymmetryShare(share) => self.set_symmetry_share(share),
            Intent::Part(part) => Ok(self.set_shape_part(part)),
            Intent::Look(look) => self.set_look(look),
            Intent::StartTape => Ok(self.start_tape()),
            Intent::Mode(mode) => self.set_mode(mode),
            Intent::Select(selection) => self.select(selection),
            Intent::SelectAt(vertex) => self.select_at(vertex),
            Intent::SelectUnder(position_px) => self.select_under(position_px),
            Intent::Pin(switch) => self.pin_selected(switch),
            Intent::PinUnder(position_px) => self.toggle_pin_at(position_px),
            Intent::Preset(preset) => self.set_preset(preset),
            Intent::Operator(operator) => self.choose(EditOptions { operator, ..self.edit_options }),
            Intent::Constraint(constraint) => self.choose(EditOptions { constraint, ..self.edit_options }),
            Intent::Details(details) => self.choose(EditOptions { details, ..self.edit_options }),
            Intent::Anchors(anchors) => self.choose(EditOptions { anchors, ..self.edit_options }),
            Intent::Mirror(mirror) => self.choose(EditOptions { mirror, ..self.edit_options }),
            Intent::Nearby(switch) => self.choose(EditOptions { is_nearby: switch == Switch::On, ..self.edit_options }),
            Intent::Radius(radius_mm) => self.choose(self.edit_options.with_radius(radius_mm)?),
            Intent::Offset(offset_mm) => self.offset(offset_mm),
            Intent::Slide(slider, to_mm) => self.slide(slider, to_mm),
            Intent::Express(expression, to) => self.express(expression, to),
            Intent::Commit => self.finish(OpenFace::commit),
            Intent::Cancel => self.cancel(),
            Intent::Hover(position_px) => Ok(self.hover(position_px)),
            Intent::PointAt(landmark) => self.point_at(landmark),
            Intent::Press(position_px, pointer) => self.press(position_px, pointer),
            Intent::Drag(position_px, pace) => self.drag(position_px, pace),
            Intent::Along(axis) => self.drag_along(axis),
            Intent::Release => self.release(),
            Intent::Undo if self.card_px.is_some() => Ok(self.unmark_corner()),
            Intent::Undo if self.brush_px.is_some() => self.change_strokes(Strokes::undo),
            Intent::Redo if self.brush_px.is_some() => self.change_strokes(Strokes::redo),
            Intent::ClearStrokes => self.change_strokes(Strokes::clear),
            Intent::Undo => self.undo(),
            Intent::Redo => self.finish(|face, edit_options| face.change_history(edit_options, Document::redo)),
            Intent::Reset => self.reset(),
            Intent::ResetSelected => self.reset_selected(),
            Intent::ResetExpressions => self.reset_expressions(),
            Intent::Switch(index, switch) => self.switch(index, switch),
            Intent::Symmetrise(share) => self.symmetrise(share),
            Intent::Density(density) => self.set_density(density),
            Intent::PhotoLens(lens) => self.set_photo_lens(lens),
            Intent::MarkCard => self.mark_card(),
            Intent::ForgetCard => self.forget_card(),
            Intent::AddPhoto(photo) => self.change_photos(|face, edit_options| face.add_photo(*photo, edit_options)),
            Intent::RemovePhoto(photo) => {
                self.change_photos(|face, edit_options| face.remove_photo(photo, edit_options))
            }
            Intent::Triangulation(triangulation) => self.set_triangulation(triangulation),
            Intent::Scene(scene) => Ok(self.set_scene(scene)),
            Intent::FalloffBand(share) => self.set_falloff_band(share),
            Intent::SeenFrom(distance_m) => self.set_seen_from(distance_m),
            Intent::Brush(radius_px) => self.set_brush(radius_px),
            Intent::ShowDepth => self.show_depth(),
            Intent::TextureSource(texture_source) => Ok(self.set_texture_source(texture_source)),
            Intent::TextureSize(size) => Ok(self.set_texture_size(size)),
            seen => self.see(seen),
        }
    }
}
