use rosto_studio::{
    AnchorKind, Anchors, ConstraintKind, Details, Document, EditSpec, Mirror, Operator, RegionOfInfluence, Settings,
};

use crate::Selection;
use crate::error::{SessionError, within};

const M_PER_MM: f64 = 1e-3;

/// How far an edit may be told to reach, in mm.
pub const RADIUS_MM: Range = Range { least: 5.0, most: 120.0, step: 1.0, usual: 25.0 };

/// What the sliders of what is selected go through, in mm. A drag may go further.
pub const SLIDER_MM: Range = Range { least: -40.0, most: 40.0, step: 0.1, usual: 0.0 };

/// What a slider goes through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Its lower end.
    pub least: f64,
    /// Its upper end.
    pub most: f64,
    /// What one key press changes.
    pub step: f64,
    /// Where it stands at first.
    pub usual: f64,
}

/// How edits are to spread; kept from one selection, and one face, to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Choices {
    /// The Laplacian.
    pub operator: Operator,
    /// How firmly handles and anchors are held.
    pub constraint: ConstraintKind,
    /// What stays in place beside the pins.
    pub anchors: AnchorChoice,
    /// Whether the edit reaches no further than the radius.
    pub is_nearby: bool,
    /// How far that is, along the surface at rest.
    pub radius_mm: f64,
    /// Whether the other side follows.
    pub mirror: Mirror,
    /// Whether details turn with the surface.
    pub details: Details,
}

rosto_mesh::named! {
    /// What stays in place beside the pins.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum AnchorChoice {
        /// Two random vertices, new for each selection.
        Random = "random",
        /// The face's oval.
        Oval = "oval",
        /// Nothing.
        PinsOnly = "pins",
    }
}

rosto_mesh::named! {
    /// Choices that go together.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Preset {
        /// What a hand expects: the point goes where it is put, what is near it follows on both sides, and the outline stays
        /// unless it is what is taken.
        Sculpt = "sculpt",
        /// The paper's edit.
        Paper = "paper",
    }
}

impl Preset {
    /// The choices; the radius is left as it is, for when it is asked for.
    pub fn choices(self, radius_mm: f64) -> Choices {
        let paper = Choices {
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
            Self::Sculpt => Choices {
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

impl Default for Choices {
    fn default() -> Self {
        Preset::Sculpt.choices(RADIUS_MM.usual)
    }
}

impl Choices {
    /// The preset that these are, if they are one.
    pub fn preset(&self) -> Option<Preset> {
        Preset::ALL.into_iter().find(|preset| preset.choices(self.radius_mm) == *self)
    }

    /// With another radius, which edits reach no further than.
    ///
    /// # Errors
    /// [`SessionError::OutOfRange`] beyond [`RADIUS_MM`].
    pub fn with_radius(self, radius_mm: f64) -> Result<Self, SessionError> {
        let radius_mm = within("the radius in mm", radius_mm, RADIUS_MM.least, RADIUS_MM.most)?;
        Ok(Self { is_nearby: true, radius_mm, ..self })
    }

    /// The spec on what is selected; `seed` chooses random anchors. What is selected moves even if it is pinned, and points
    /// of denser meshes cannot be held while landmarks move.
    pub(crate) fn spec(&self, selection: Selection, pins: &[u32], seed: u64, document: &Document) -> EditSpec {
        let (level, handles) = (selection.level(), selection.handles());
        let partner = |vertex: u32| document.partner(level, vertex);
        let can_mirror = partner(selection.middle()).is_some();
        let mirror = if can_mirror { self.mirror } else { Mirror::Off };
        let moves = |vertex: u32| {
            let partner = partner(vertex).filter(|_| mirror == Mirror::On);
            handles.contains(&vertex) || partner.is_some_and(|partner| handles.contains(&partner))
        };
        let is_there = |vertex: u32| document.vertex_count(level).is_some_and(|count| (vertex as usize) < count);
        // Taken from between its neighbours, a point of the outline would be a spike: what is near it comes along.
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
    fn a_pin_gives_way_to_the_hand_that_takes_it() {
        let rest = Rest::new(Triangulation::Canonical.topology(), canonical_positions_m(), CoordinateFrame::Model);
        let document = Document::new(rest).unwrap();
        let pins_for = |handle: u32, mirror: Mirror| {
            let choices = Choices { mirror, ..Choices::default() };
            choices.spec(Selection::Landmark(handle), &[61, 152, 9_000], 1, &document).settings.anchors.pins
        };
        assert_eq!(pins_for(61, Mirror::Off), [152]);
        assert_eq!(pins_for(291, Mirror::Off), [61, 152]);
        assert_eq!(pins_for(291, Mirror::On), [152]);
    }

    #[test]
    fn a_preset_is_known_by_its_choices_whatever_the_radius() {
        for preset in Preset::ALL {
            let choices = preset.choices(33.0);
            assert_eq!(choices.preset(), Some(preset));
            assert_eq!(Choices { is_nearby: !choices.is_nearby, ..choices }.preset(), None);
        }
        assert_eq!(Choices::default().preset(), Some(Preset::Sculpt));
    }
}
