use glam::DVec2;
use rosto_face::LANDMARK_COUNT;
use rosto_stage::Pointer;
use rosto_studio::{SMOOTH_DENSITY, Switch};

use super::opening::prepare;
use super::{Result, Session};
use crate::gesture::Gesture;
use crate::{Changed, EditOptions, Preset, Selection, SelectionMode, SessionError};

/// Selection and edit settings.
impl Session {
    /// Sets the selection mode. The first switch to points of a dense mesh builds a factorisation.
    pub(super) fn set_mode(&mut self, mode: SelectionMode) -> Result {
        self.mode = mode;
        let Some(face) = &mut self.face else { return Ok(Changed::Document) };
        face.commit(&self.edit_options);
        prepare(face, mode, &self.edit_options, self.seeds.peek());
        let wanted = face.selection_in(mode);
        if wanted != face.selection() {
            self.gesture = Gesture::Idle;
            face.select(wanted, &self.edit_options, self.seeds.draw());
        }
        Ok(Changed::Document)
    }

    pub(super) fn select(&mut self, selection: Option<Selection>) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        let there = match selection {
            Some(Selection::Landmark(vertex)) => Some((vertex, LANDMARK_COUNT)),
            Some(Selection::Point { level, vertex }) => {
                let is_shown = level == face.document().density() && level > 0;
                Some((vertex, if is_shown { face.document().rest().len() } else { 0 }))
            }
            Some(Selection::Region(_)) | None => None,
        };
        if let Some((vertex, count)) = there.filter(|(vertex, count)| *vertex as usize >= *count) {
            return Err(SessionError::NoSuchVertex { vertex, count });
        }
        face.commit(&self.edit_options);
        face.select(selection, &self.edit_options, self.seeds.draw());
        self.gesture = Gesture::Idle;
        self.show_selected_part();
        Ok(Changed::Document)
    }

    /// Selects under the pointer; clears the selection outside the face.
    pub(super) fn select_under(&mut self, position_px: DVec2) -> Result {
        let hit = self.hit_at(position_px, Pointer::Fine);
        match hit.vertex {
            // The gizmo belongs to the selection.
            _ if hit.axis.is_some() => Ok(Changed::Nothing),
            Some(vertex) => self.select_at(vertex),
            None if self.face.is_some() => self.select(None),
            None => Ok(Changed::Nothing),
        }
    }

    pub(super) fn select_at(&mut self, vertex: u32) -> Result {
        let face = self.open_face()?;
        let selection = face.at(face.known(vertex, self.mode)?, self.mode);
        self.select(Some(selection))
    }

    pub(super) fn pin_selected(&mut self, switch: Switch) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        let handles = face.selection().ok_or(SessionError::NothingSelected)?.handles();
        face.pin(&handles, switch, &self.edit_options);
        Ok(Changed::Document)
    }

    pub(super) fn toggle_pin_at(&mut self, position_px: DVec2) -> Result {
        let vertex = self.hit_at(position_px, Pointer::Fine).vertex;
        let (Some(face), Some(vertex)) = (&mut self.face, vertex) else { return Ok(Changed::Nothing) };
        let switch = if face.pins().contains(&vertex) { Switch::Off } else { Switch::On };
        face.pin(&[vertex], switch, &self.edit_options);
        Ok(Changed::Document)
    }

    /// The paper edits landmarks only, so its preset shows the cage; the sculpting preset shows a smooth face.
    pub(super) fn set_preset(&mut self, preset: Preset) -> Result {
        let shown = self.density();
        let density = match preset {
            Preset::Paper => 0,
            Preset::Sculpt => shown.max(SMOOTH_DENSITY),
        };
        let changed = self.choose(preset.edit_options(self.edit_options.radius_mm))?;
        if density == shown { Ok(changed) } else { self.set_density(density) }
    }

    /// Changes the settings; an edit in progress continues with them.
    pub(super) fn choose(&mut self, edit_options: EditOptions) -> Result {
        self.edit_options = edit_options;
        if let Some(face) = &mut self.face {
            face.keep_prepared(&self.edit_options);
        }
        Ok(Changed::Document)
    }
}
