//! Settings with named values. The panels, stored preferences and property tests read this table.

use rosto_export::TextureSize;
use rosto_face::Triangulation;
use rosto_stage::{Lens, Scene, ShadingMode};
use rosto_studio::{ConstraintKind, Details, Operator};

use crate::incoming::MAX_SHOWN_DENSITY;
use crate::{AnchorChoice, Intent, Preset, SelectionMode, Session, TextureSource};

rosto_mesh::named! {
    /// A setting with named values.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Choice {
        /// Kind of selection made by a click or a drag.
        SelectionMode = "selection",
        /// Preset of the edit settings.
        Preset = "preset",
        /// Discrete Laplacian.
        Operator = "operator",
        /// Whether handles and anchors are soft or hard constraints.
        Constraint = "constraint",
        /// Whether details rotate with the surface.
        Details = "details",
        /// Anchors in addition to the pins.
        Anchors = "anchors",
        /// Content of the stage.
        Scene = "scene",
        /// Colouring of the surface.
        Shading = "shading",
        /// Source of the texture.
        TextureSource = "texture-source",
        /// Size of the whole-face texture.
        TextureSize = "texture-size",
        /// Lens of the view.
        Lens = "lens",
        /// Triangulation of the landmarks.
        Triangulation = "triangulation",
        /// Subdivision level of the mesh.
        Density = "density",
    }
}

/// The available constraints; the soft one has the paper's weight.
const CONSTRAINTS: [(&str, ConstraintKind); 2] =
    [("exact", ConstraintKind::Hard), ("soft", ConstraintKind::Soft { weight: 1.0 })];

impl Choice {
    /// Ids of the values, in the order in which panels show them.
    pub fn values(self) -> Vec<String> {
        let owned = |ids: &[&str]| ids.iter().map(|&id| id.to_owned()).collect();
        match self {
            Self::SelectionMode => owned(&SelectionMode::ALL.map(SelectionMode::id)),
            Self::Preset => owned(&Preset::ALL.map(Preset::id)),
            Self::Operator => owned(&Operator::ALL.map(Operator::id)),
            Self::Constraint => owned(&CONSTRAINTS.map(|(id, _)| id)),
            Self::Details => owned(&Details::ALL.map(Details::id)),
            Self::Anchors => owned(&AnchorChoice::ALL.map(AnchorChoice::id)),
            Self::Scene => owned(&Scene::ALL.map(Scene::id)),
            Self::Shading => owned(&ShadingMode::ALL.map(ShadingMode::id)),
            Self::TextureSource => owned(&TextureSource::ALL.map(TextureSource::id)),
            Self::TextureSize => owned(&TextureSize::ALL.map(TextureSize::id)),
            Self::Lens => owned(&Lens::ALL.map(Lens::id)),
            Self::Triangulation => owned(&Triangulation::ALL.map(Triangulation::id)),
            Self::Density => (0..=MAX_SHOWN_DENSITY).map(|density| density.to_string()).collect(),
        }
    }

    /// Intent that selects the value with this id; `None` for an unknown id.
    pub fn intent(self, id: &str) -> Option<Intent> {
        Some(match self {
            Self::SelectionMode => Intent::Mode(SelectionMode::from_id(id)?),
            Self::Preset => Intent::Preset(Preset::from_id(id)?),
            Self::Operator => Intent::Operator(Operator::from_id(id)?),
            Self::Constraint => Intent::Constraint(CONSTRAINTS.into_iter().find(|(one, _)| *one == id)?.1),
            Self::Details => Intent::Details(Details::from_id(id)?),
            Self::Anchors => Intent::Anchors(AnchorChoice::from_id(id)?),
            Self::Scene => Intent::Scene(Scene::from_id(id)?),
            Self::Shading => Intent::Shading(ShadingMode::from_id(id)?),
            Self::TextureSource => Intent::TextureSource(TextureSource::from_id(id)?),
            Self::TextureSize => Intent::TextureSize(TextureSize::from_id(id)?),
            Self::Lens => Intent::Lens(Lens::from_id(id)?),
            Self::Triangulation => Intent::Triangulation(Triangulation::from_id(id)?),
            Self::Density => Intent::Density(id.parse().ok().filter(|density| *density <= MAX_SHOWN_DENSITY)?),
        })
    }
}

impl Session {
    /// Id of the current value; `None` if it is not an available one, such as when no preset matches.
    pub fn chosen(&self, choice: Choice) -> Option<String> {
        let (options, view) = (self.edit_options(), self.view());
        let id = match choice {
            Choice::SelectionMode => self.mode().id(),
            Choice::Preset => options.preset()?.id(),
            Choice::Operator => options.operator.id(),
            Choice::Constraint => CONSTRAINTS.into_iter().find(|(_, one)| *one == options.constraint)?.0,
            Choice::Details => options.details.id(),
            Choice::Anchors => options.anchors.id(),
            Choice::Scene => view.scene.id(),
            Choice::Shading => view.shading.id(),
            Choice::TextureSource => view.texture_source.id(),
            Choice::TextureSize => view.texture_size.id(),
            Choice::Lens => view.lens.id(),
            Choice::Triangulation => view.triangulation.id(),
            Choice::Density => return Some(view.density.to_string()),
        };
        Some(id.to_owned())
    }
}
