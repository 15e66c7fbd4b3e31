use glam::DVec2;
use rosto_face::CardCorners;
use rosto_stage::Scene;

use super::{Result, Session};
use crate::Changed;
use crate::gesture::Gesture;

/// Radius of a mark of a corner, in CSS px.
const MARK_PX: f64 = 7.0;

/// Measuring the face by a bank card in its photo.
impl Session {
    /// Shows the photo, in which the next four presses mark the corners of a card.
    pub(super) fn mark_card(&mut self) -> Result {
        self.open_face()?;
        if self.view.scene != Scene::Picture {
            self.set_scene(Scene::Picture);
        }
        self.brush_px = None;
        self.card_px = Some(Vec::new());
        self.hover(None);
        Ok(Changed::Document)
    }

    /// Measures the face without a card.
    pub(super) fn forget_card(&mut self) -> Result {
        self.card_px = None;
        self.set_card(None)
    }

    /// Marks a corner; the fourth one measures the face. If the corners are not a card's, marking starts again.
    pub(super) fn mark_corner(&mut self, position_px: DVec2) -> Result {
        self.gesture = Gesture::Idle;
        let (Some(corner_px), Some(marked_px)) = (self.stage.picture_px(position_px), &mut self.card_px) else {
            return Ok(Changed::Nothing);
        };
        marked_px.push(corner_px);
        let [width, height] = self.open_face()?.model().photo_size_px().map(f64::from);
        let marked = self.card_px.iter().flatten().map(|corner_px| [corner_px.x / width, corner_px.y / height]);
        let Ok(corners) = CardCorners::try_from(marked.collect::<Vec<_>>()) else { return Ok(Changed::Document) };
        self.card_px = Some(Vec::new());
        let changed = self.set_card(Some(corners))?;
        self.card_px = None;
        Ok(changed)
    }

    /// Removes the last mark.
    pub(super) fn unmark_corner(&mut self) -> Changed {
        self.card_px.as_mut().and_then(Vec::pop).map_or(Changed::Nothing, |_| Changed::Document)
    }

    fn set_card(&mut self, card: Option<CardCorners>) -> Result {
        if self.open_face()?.model().card() == card {
            return Ok(Changed::Document);
        }
        self.change_photos(|face, edit_options| face.set_card(card, edit_options))
    }

    /// Number of marked corners, while a card is being marked.
    pub(crate) fn marked_corners(&self) -> Option<usize> {
        self.card_px.as_ref().map(Vec::len)
    }

    /// Radius of the circle under the pointer on the photo, in CSS px: the brush, or the mark of a corner.
    pub fn pointer_radius_px(&self) -> Option<f64> {
        if self.card_px.is_some() { Some(MARK_PX) } else { self.brush_px }
    }

    /// Centres and radii of the marked corners, in px of the canvas.
    pub(super) fn marks_on_canvas(&self) -> impl Iterator<Item = [f64; 3]> {
        let radius_px = MARK_PX * self.stage.pixel_ratio();
        let centres = self.card_px.iter().flatten().filter_map(|&corner_px| self.stage.canvas_px(corner_px));
        centres.map(move |centre| [centre.x, centre.y, radius_px])
    }
}
