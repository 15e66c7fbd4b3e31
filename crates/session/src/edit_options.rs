use rosto_studio::{
    AnchorKind, Anchors, ConstraintKind, Details, Document, EditSpec, Mirror, Operator, RegionOfInfluence, Settings,
};

use crate::Selection;
use crate::error::{SessionError, within};
use crate::range::Range;

const M_PER_MM: f64 = 1e-3;

/// Range of the influence radius, in mm.
pub const RADIUS_MM: Range = Range { min: 5.0, max: 120.0, step: 1.0, neutral: 25.0 };

/// Range of the offset sliders of the selection, in mm. A drag can go further.
pub const SLIDER_MM: Range = Range { min: -40.0, max: 40.0, step: 0.1, neutral: 0.0 };

/// Settings of edits; they persist across selections and faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EditOptions {
    /// Discrete Laplacian.
    pub operator: Operator,
    /// How firmly handles and anchors are held.
    pub constraint: ConstraintKind,
    /// Anchors in addition to the pins.
    pub anchors: AnchorChoice,
    /// Whether edits are limited to the influence radius.
    pub is_nearby: bool,
    /// Influence radius, along the surface at rest.
    pub radius_mm: f64,
    /// Whether edits are mirrored to the other side.
    pub mirror: Mirror,
    /// Whether details rotate with the surface.
    pub details: Details,
}

rosto_mesh::named! {
    /// Anchors in addition to the pins.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum AnchorChoice {
        /// Two random vertices, drawn for each selection.
        Random = "random",
        /// The face's oval.
        Oval = "oval",
        /// None.
        PinsOnly = "pins",
    }
}

rosto_mesh::named! {
    /// A named set of edit settings.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Preset {
        /// Settings for sculpting: the point follows the pointer exactly, its surroundings follow on both sides, and
        /// the outline stays unless the selection is on it.
        Sculpt = "sculpt",
        /// The paper's edit.
        Paper = "paper",
    }
}

impl Preset {
    /// The preset's settings, with `radius_mm` for later use.
    pub fn edit_options(self, radius_mm: f64) -> EditOptions {
        let paper = EditOptions {
            operator: Operator::default(),
            constraint: ConstraintKind::default(),
            anchors: AnchorChoice::Random,
            is_nearby: false,
            radius_mm,
            mirror: Mirror::Off,
            details: Details::default(),
        };
        match self {
            Self::Paper => paper,
            Self::Sculpt => EditOptions {
                operator: Operator::Cotangent,
                constraint: ConstraintKind::Hard,
                anchors: AnchorChoice::Oval,
                is_nearby: true,
                mirror: Mirror::On,
                ..paper
            },
        }
    }
}

impl Default for EditOptions {
    fn default() -> Self {
        Preset::Sculpt.edit_options(RADIUS_MM.neutral)
    }
}

impl EditOptions {
    /// The preset with these settings, if there is one.
    pub fn preset(&self) -> Option<Preset> {
        Preset::ALL.into_iter().find(|preset| preset.edit_options(self.radius_mm) == *self)
    }

    /// Returns the settings with edits limited to the given influence radius.
    ///
    /// # Errors
    /// [`SessionError::OutOfRange`] outside [`RADIUS_MM`].
    pub fn with_radius(self, radius_mm: f64) -> Result<Self, SessionError> {
        let radius_mm = within("the radius in mm", radius_mm, RADIUS_MM.min, RADIUS_MM.max)?;
        Ok(Self { is_nearby: true, radius_mm, ..self })
    }

    /// Spec for a selection; `seed` selects random anchors. Selected vertices move even if they are pinned. Pins that
    /// do not exist at the selection's level are ignored.
    pub(crate) fn spec(&self, selection: Selection, pins: &[u32], seed: u64, document: &Document) -> EditSpec {
        let (level, handles) = (selection.level(), selection.handles());
        let partner = |vertex: u32| document.partner(level, vertex);
        let can_mirror = partner(selection.centre()).is_some();
        let mirror = if can_mirror { self.mirror } else { Mirror::Off };
        let moves = |vertex: u32| {
            let partner = partner(vertex).filter(|_| mirror == Mirror::On);
            handles.contains(&vertex) || partner.is_some_and(|partner| handles.contains(&partner))
        };
        let is_there = |vertex: u32| document.vertex_count(level).is_some_and(|count| (vertex as usize) < count);
        // With a fixed outline, moving one of its points alone would leave a spike, so its surroundings move too.
        let takes_outline = self.is_nearby && handles.iter().any(|&handle| document.is_on_oval(level, handle));
        let kind = match self.anchors {
            AnchorChoice::Random => AnchorKind::Random { seed },
            AnchorChoice::Oval if takes_outline => AnchorKind::Outside { radius: self.radius_mm * M_PER_MM },
            AnchorChoice::Oval => AnchorKind::Oval,
            AnchorChoice::PinsOnly => AnchorKind::PinsOnly,
        };
        let pins = pins.iter().copied().filter(|&pin| is_there(pin) && !moves(pin)).collect();
        let influence = match self.is_nearby {
            true => RegionOfInfluence::Within { radius: self.radius_mm * M_PER_MM },
            false => RegionOfInfluence::Whole,
        };
        let anchors = Anchors { kind, pins };
        let settings = Settings {
            operator: self.operator,
            constraint: self.constraint,
            anchors,
            influence,
            mirror,
            details: self.details,
        };
        EditSpec { level, handles, settings }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rosto_face::{Triangulation, canonical_positions_m};
    use rosto_studio::{CoordinateFrame, Rest};

    #[test]
    fn moving_a_pinned_vertex_releases_its_pin() {
        let rest =
            Rest::of_landmarks(Triangulation::Canonical.topology(), canonical_positions_m(), CoordinateFrame::Model);
        let document = Document::new(rest).unwrap();
        let pins_for = |handle: u32, mirror: Mirror| {
            let edit_options = EditOptions { mirror, ..EditOptions::default() };
            edit_options.spec(Selection::Landmark(handle), &[61, 152, 9_000], 1, &document).settings.anchors.pins
        };
        assert_eq!(pins_for(61, Mirror::Off), [152]);
        assert_eq!(pins_for(291, Mirror::Off), [61, 152]);
        assert_eq!(pins_for(291, Mirror::On), [152]);
    }

    #[test]
    fn presets_are_recognised_at_any_radius() {
        for preset in Preset::ALL {
            let edit_options = preset.edit_options(33.0);
            assert_eq!(edit_options.preset(), Some(preset));
            assert_eq!(EditOptions { is_nearby: !edit_options.is_nearby, ..edit_options }.preset(), None);
        }
        assert_eq!(EditOptions::default().preset(), Some(Preset::Sculpt));
    }
}
