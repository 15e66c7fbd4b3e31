use std::fmt;

use rosto_face::{LANDMARK_COUNT, Region, landmark_id};

use crate::{Command, Expression, FaceSlider};

/// What a command works on. Files hold the command alone: this is read from it.
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
    /// An expression.
    Expression(Expression),
}

/// How much a command does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Amount {
    /// How far each handle is moved, in the document's unit; for a slider, with its sign.
    Distance(f64),
    /// Of the asymmetry, from 0 to 1.
    Share(f64),
    /// Of an expression, from −1 to 1.
    Weight(f64),
}

impl EditTarget {
    /// What kind of target it is, by the name that panels know it by.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Landmark(_) => "landmark",
            Self::Point { .. } => "point",
            Self::Region(_) => "region",
            Self::Slider(_) => "slider",
            Self::Vertices(_) => "vertices",
            Self::Symmetry => "symmetry",
            Self::Expression(_) => "expression",
        }
    }
}

/// The target's name in files, such as `nose-tip`, `nose-width` or `point-20000@3` for a vertex of the third subdivision.
impl fmt::Display for EditTarget {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Landmark(landmark) => out.write_str(&landmark_id(*landmark)),
            Self::Point { level, vertex } => write!(out, "point-{vertex}@{level}"),
            Self::Region(region) => out.write_str(region.id()),
            Self::Slider(slider) => out.write_str(slider.id()),
            Self::Vertices(count) => write!(out, "{count}-vertices"),
            Self::Symmetry => out.write_str("symmetry"),
            Self::Expression(expression) => out.write_str(expression.id()),
        }
    }
}

impl Command {
    /// What it works on.
    pub fn target(&self) -> EditTarget {
        let (spec, offsets) = match self {
            Self::Move { spec, offsets } => (spec, offsets),
            Self::Symmetrise { .. } => return EditTarget::Symmetry,
            Self::Express { expression, .. } => return EditTarget::Expression(*expression),
        };
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
            &Self::Express { weight, .. } => Amount::Weight(weight),
            Self::Move { offsets, .. } => {
                let slid = FaceSlider::ALL.into_iter().find_map(|slider| slider.amount_m(self));
                let furthest = || offsets.iter().map(|offset| offset.length()).fold(0.0, f64::max);
                Amount::Distance(slid.unwrap_or_else(furthest))
            }
        }
    }
}
