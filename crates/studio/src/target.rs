use rosto_face::{LANDMARK_COUNT, Language, Region, landmark_name};

use crate::{Command, FaceSlider};

/// What a command works on, as people name it. Files hold the command alone: this is read from it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EditTarget {
    /// One landmark.
    Landmark(u32),
    /// One vertex of a denser mesh.
    Point {
        /// How often that mesh is subdivided: 1 or more.
        level: u32,
        /// Which of its vertices.
        vertex: u32,
    },
    /// All landmarks of a region, by one offset.
    Region(Region),
    /// A ready-made slider.
    Slider(FaceSlider),
    /// Other vertices: how many.
    Vertices(usize),
    /// Both sides of the face.
    Symmetry,
}

/// How much a command does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Amount {
    /// How far each handle is moved, in the document's unit; for a slider, with its sign.
    Distance(f64),
    /// Of the asymmetry, from 0 to 1.
    Share(f64),
}

impl EditTarget {
    /// The name in lower case, such as "nose tip" or "nose width". [`Document::name_of`](crate::Document::name_of) also
    /// says where a point is.
    pub fn name(self, language: Language) -> String {
        match (self, language) {
            (Self::Landmark(landmark), _) => landmark_name(landmark, language),
            (Self::Point { vertex, .. }, Language::English) => format!("point {}", grouped(vertex, ",")),
            (Self::Point { vertex, .. }, Language::Portuguese) => format!("ponto {}", grouped(vertex, ".")),
            (Self::Region(region), _) => region.name(language).to_owned(),
            (Self::Slider(slider), _) => slider.name(language).to_lowercase(),
            (Self::Vertices(count), Language::English) => format!("{count} points"),
            (Self::Vertices(count), Language::Portuguese) => format!("{count} pontos"),
            (Self::Symmetry, Language::English) => "symmetry".to_owned(),
            (Self::Symmetry, Language::Portuguese) => "simetria".to_owned(),
        }
    }
}

/// Every three digits, from the right, set apart.
fn grouped(number: u32, separator: &str) -> String {
    match number {
        0..1000 => number.to_string(),
        _ => format!("{}{separator}{:03}", grouped(number / 1000, separator), number % 1000),
    }
}

impl Command {
    /// What it works on.
    pub fn target(&self) -> EditTarget {
        let Self::Move { spec, offsets } = self else { return EditTarget::Symmetry };
        if let Some(slider) = FaceSlider::ALL.into_iter().find(|slider| slider.amount_m(self).is_some()) {
            return EditTarget::Slider(slider);
        }
        let as_one = spec.level == 0 && offsets.windows(2).all(|pair| pair[0] == pair[1]);
        let region = || Region::ALL.into_iter().find(|region| region.vertices() == spec.handles);
        match spec.handles[..] {
            [vertex] if as_one && (vertex as usize) < LANDMARK_COUNT => EditTarget::Landmark(vertex),
            [vertex] if spec.level > 0 => EditTarget::Point { level: spec.level, vertex },
            [_, _, ..] if as_one => region().map_or(EditTarget::Vertices(spec.handles.len()), EditTarget::Region),
            _ => EditTarget::Vertices(spec.handles.len()),
        }
    }

    /// How much it does.
    pub fn amount(&self) -> Amount {
        match self {
            &Self::Symmetrise { share } => Amount::Share(share),
            Self::Move { offsets, .. } => {
                let slid = FaceSlider::ALL.into_iter().find_map(|slider| slider.amount_m(self));
                let furthest = || offsets.iter().map(|offset| offset.length()).fold(0.0, f64::max);
                Amount::Distance(slid.unwrap_or_else(furthest))
            }
        }
    }
}
