use std::fmt;

use rosto_face::{LANDMARK_COUNT, Region, landmark_id};

use crate::{Command, Expression, FaceSlider};

/// The object that a command edits. It is derived from the command and not stored in files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EditTarget {
    /// One landmark.
    Landmark(u32),
    /// One vertex of a denser mesh.
    Point {
        /// Subdivision level of that mesh, from 1.
        level: u32,
        /// The vertex.
        vertex: u32,
    },
    /// The landmarks of a region, moved by one offset.
    Region(Region),
    /// A ready-made slider.
    Slider(FaceSlider),
    /// Any other set of vertices, by their number.
    Vertices(usize),
    /// Both sides of the face.
    Symmetry,
    /// An expression.
    Expression(Expression),
}

/// Size of a command's change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Amount {
    /// Length of the longest offset, in the document's unit; signed for a slider.
    Distance(f64),
    /// Share of the asymmetry that is removed, 0..=1.
    Share(f64),
    /// Weight of an expression, −1..=1.
    Weight(f64),
}

impl EditTarget {
    /// Kind of target, as an id for panels.
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

/// The target's id in files, such as `nose-tip`, `nose-width` or `point-20000@3` for a vertex of the third subdivision.
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
    /// The object that the command edits.
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

    /// Size of the change.
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
