use rosto_studio::{AnchorKind, Anchors, Details, Document, Grip, Hold, Mirror, Operator, Reach, Settings};

use crate::hand::Selection;

const M_PER_MM: f64 = 1e-3;

/// How edits are to spread; kept from one landmark, and one face, to the next.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Choices {
    pub operator: Operator,
    pub hold: Hold,
    pub anchors: AnchorChoice,
    pub pins: Vec<u32>,
    pub radius_mm: Option<f64>,
    pub mirror: Mirror,
    pub details: Details,
}

/// What stays in place beside the pins.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum AnchorChoice {
    /// Two random vertices, new for each selection.
    Random,
    /// The face's oval.
    Oval,
    /// Nothing.
    PinsOnly,
    /// These, and no pins, until another landmark is selected.
    Explicit(Vec<u32>),
}

impl Default for Choices {
    /// The paper's edit.
    fn default() -> Self {
        Self {
            operator: Operator::default(),
            hold: Hold::default(),
            anchors: AnchorChoice::Random,
            pins: Vec::new(),
            radius_mm: None,
            mirror: Mirror::Off,
            details: Details::default(),
        }
    }
}

impl Choices {
    /// The grip on what is selected under these choices; `seed` chooses random anchors. What is in hand moves even if it is
    /// pinned, and points of denser meshes cannot be held while landmarks move.
    pub fn grip(&self, selection: Selection, seed: u64, document: &Document) -> Grip {
        let (level, handles) = (selection.level(), selection.handles());
        let partner = |vertex: u32| document.partner(level, vertex);
        let can_mirror = partner(selection.middle()).is_some();
        let mirror = if can_mirror { self.mirror } else { Mirror::Off };
        let moves = |vertex: u32| {
            let partner = partner(vertex).filter(|_| mirror == Mirror::On);
            handles.contains(&vertex) || partner.is_some_and(|partner| handles.contains(&partner))
        };
        let is_there = |vertex: u32| document.vertex_count(level).is_some_and(|count| (vertex as usize) < count);
        let kind = match self.anchors {
            AnchorChoice::Random => AnchorKind::Random { seed },
            AnchorChoice::Oval => AnchorKind::Oval,
            AnchorChoice::PinsOnly | AnchorChoice::Explicit(_) => AnchorKind::PinsOnly,
        };
        let pins = match &self.anchors {
            AnchorChoice::Explicit(anchors) => anchors.clone(),
            _ => self.pins.iter().copied().filter(|&pin| is_there(pin) && !moves(pin)).collect(),
        };
        let settings = Settings {
            operator: self.operator,
            hold: self.hold,
            anchors: Anchors { kind, pins },
            reach: self.radius_mm.map_or(Reach::Whole, |radius_mm| Reach::Within { radius: radius_mm * M_PER_MM }),
            mirror,
            details: self.details,
        };
        Grip { level, handles, settings }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rosto_face::{Triangulation, canonical_positions_m};
    use rosto_studio::{Frame, Rest};

    #[test]
    fn a_pin_gives_way_to_the_hand_that_takes_it() {
        let rest = Rest::new(Triangulation::Canonical.topology(), canonical_positions_m(), Frame::Model);
        let document = Document::new(rest).unwrap();
        let pins_for = |handle: u32, mirror: Mirror| {
            let choices = Choices { pins: vec![61, 152, 9_000], mirror, ..Choices::default() };
            choices.grip(Selection::Landmark(handle), 1, &document).settings.anchors.pins
        };
        assert_eq!(pins_for(61, Mirror::Off), [152]);
        assert_eq!(pins_for(291, Mirror::Off), [61, 152]);
        assert_eq!(pins_for(291, Mirror::On), [152]);
    }
}
