use std::fmt::Display;

use glam::DVec3;
use pyo3::prelude::*;
use rosto::{Anchors, Command, Expression, FaceSlider, Region};

use crate::error::refused;

pub const M_PER_MM: f64 = 1.0 / 1000.0;

/// An edit: the Python class of the same name.
#[derive(FromPyObject)]
pub enum Edit {
    Vertex { vertex: u32, level: u32, offset_mm: [f64; 3], anchors: Vec<u32> },
    Region { region: String, offset_mm: [f64; 3] },
    Slider { slider: String, amount_mm: f64 },
    Expression { expression: String, weight: f64 },
    Symmetrise { share: f64 },
}

impl Edit {
    /// Whether the options of the mesh determine the edit's settings.
    pub fn is_move(&self) -> bool {
        matches!(self, Self::Vertex { .. } | Self::Region { .. })
    }

    /// The command in metres. Moves without anchors have default settings.
    pub fn command(self) -> PyResult<Command> {
        Ok(match self {
            Self::Vertex { vertex, level, offset_mm, anchors } => {
                let mut command = Command::move_vertex(level, vertex, DVec3::from(offset_mm) * M_PER_MM);
                if let (Command::Move { spec, .. }, false) = (&mut command, anchors.is_empty()) {
                    spec.settings.anchors = Anchors::explicit(anchors);
                }
                command
            }
            Self::Region { region, offset_mm } => {
                let region = chosen("region", &region, Region::ALL, Region::id)?;
                Command::move_region(region, DVec3::from(offset_mm) * M_PER_MM)
            }
            Self::Slider { slider, amount_mm } => {
                chosen("slider", &slider, FaceSlider::ALL, FaceSlider::id)?.command(amount_mm / 1000.0)
            }
            Self::Expression { expression, weight } => {
                let expression = chosen("expression", &expression, Expression::ALL, Expression::id)?;
                Command::Express { expression, weight: share("weight", weight)? }
            }
            Self::Symmetrise { share: of } => Command::Symmetrise { share: share("share", of)? },
        })
    }
}

/// Returns the choice with this id.
pub fn chosen<T: Copy, const N: usize>(
    name: &'static str,
    id: &str,
    all: [T; N],
    id_of: fn(T) -> &'static str,
) -> PyResult<T> {
    let found = all.into_iter().find(|one| id_of(*one) == id);
    found.ok_or_else(|| refused(rosto::Error::unknown(name, id, &all.map(id_of))))
}

/// Checks that a number is a share.
fn share(name: impl Display, number: f64) -> PyResult<f64> {
    match (0.0..=1.0).contains(&number) {
        true => Ok(number),
        false => Err(refused(format!("{name}: {number} is not from 0 to 1"))),
    }
}
