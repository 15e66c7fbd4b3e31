use glam::DVec3;
use rosto_face::{Language, Region, canonical_positions_m};
use rosto_studio::{FaceSlider, Subject};

use crate::names::landmark_label;

/// What the visitor has chosen to move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Selection {
    Landmark(u32),
    Region(Region),
}

/// An edit in progress.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) enum Moving {
    #[default]
    Nothing,
    /// What is selected, by an offset from where the last commit left it.
    Selection { offset_mm: DVec3 },
    /// A ready-made slider, by an amount from where the last commit left it.
    Slider { slider: FaceSlider, by_mm: f64 },
}

impl Selection {
    /// The landmarks that move together.
    pub fn handles(self) -> Vec<u32> {
        match self {
            Self::Landmark(landmark) => vec![landmark],
            Self::Region(region) => region.vertices(),
        }
    }

    /// The landmark that carries the gizmo and the name: that of a region is the one nearest to its middle.
    pub fn middle(self) -> u32 {
        match self {
            Self::Landmark(landmark) => landmark,
            Self::Region(region) => middle(&region.vertices()),
        }
    }

    pub fn subject(self) -> Subject {
        match self {
            Self::Landmark(landmark) => Subject::Landmark(landmark),
            Self::Region(region) => Subject::Region(region),
        }
    }
}

/// What the page calls a subject: landmarks bring their number along.
pub(crate) fn subject_label(subject: Subject, language: Language) -> String {
    match subject {
        Subject::Landmark(landmark) => landmark_label(landmark, language),
        other => other.name(language),
    }
}

fn middle(vertices: &[u32]) -> u32 {
    let canonical_m = canonical_positions_m();
    let place = |vertex: u32| canonical_m[vertex as usize];
    let centre = vertices.iter().map(|&vertex| place(vertex)).sum::<DVec3>() / vertices.len() as f64;
    let distance = |vertex: &u32| place(*vertex).distance(centre);
    vertices.iter().copied().min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or_default()
}
