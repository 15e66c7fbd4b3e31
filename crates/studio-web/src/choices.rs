use rosto_face::mirror_of;
use rosto_studio::{AnchorKind, Anchors, Details, Grip, Hold, Mirror, Operator, Reach, Settings};

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
    /// The grip on landmarks under these choices; `seed` chooses random anchors. What is in hand moves even if it is
    /// pinned.
    pub fn grip(&self, handles: Vec<u32>, seed: u64) -> Grip {
        let kind = match self.anchors {
            AnchorChoice::Random => AnchorKind::Random { seed },
            AnchorChoice::Oval => AnchorKind::Oval,
            AnchorChoice::PinsOnly | AnchorChoice::Explicit(_) => AnchorKind::PinsOnly,
        };
        let pins = match &self.anchors {
            AnchorChoice::Explicit(anchors) => anchors.clone(),
            _ => self.pins.iter().copied().filter(|&pin| !self.moves(&handles, pin)).collect(),
        };
        let settings = Settings {
            operator: self.operator,
            hold: self.hold,
            anchors: Anchors { kind, pins },
            reach: self.radius_mm.map_or(Reach::Whole, |radius_mm| Reach::Within { radius: radius_mm * M_PER_MM }),
            mirror: self.mirror,
            details: self.details,
        };
        Grip { handles, settings, ..Grip::default() }
    }

    /// Whether a landmark is a handle or, where the mirror takes part, a handle's partner.
    fn moves(&self, handles: &[u32], landmark: u32) -> bool {
        handles.contains(&landmark) || (self.mirror == Mirror::On && handles.contains(&mirror_of(landmark)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pin_gives_way_to_the_hand_that_takes_it() {
        let pins_for = |handle: u32, mirror: Mirror| {
            Choices { pins: vec![61, 152], mirror, ..Choices::default() }.grip(vec![handle], 1).settings.anchors.pins
        };
        assert_eq!(pins_for(61, Mirror::Off), [152]);
        assert_eq!(pins_for(291, Mirror::Off), [61, 152]);
        assert_eq!(pins_for(291, Mirror::On), [152]);
    }
}
