//! Settings with named values. The intent `{ [id of the setting]: id of the value }` chooses a value.

use rosto_export::TextureSize;
use rosto_face::Triangulation;
use rosto_stage::{Lens, Scene, ShadingMode};
use rosto_studio::{Details, Operator};

use crate::message::value::CONSTRAINTS;
use crate::saved::MAX_SHOWN_DENSITY;
use crate::{AnchorChoice, Intent, OpenFace, Preset, SelectionMode, Session, TextureSource};

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
}

impl Intent {
    /// Sets a setting to the value with an id; `None` if there is no such value.
    pub(crate) fn choosing(choice: Choice, id: &str) -> Option<Self> {
        Some(match choice {
            Choice::SelectionMode => Self::Mode(SelectionMode::from_id(id)?),
            Choice::Preset => Self::Preset(Preset::from_id(id)?),
            Choice::Operator => Self::Operator(Operator::from_id(id)?),
            Choice::Constraint => Self::Constraint(CONSTRAINTS.into_iter().find(|(one, _)| *one == id)?.1),
            Choice::Details => Self::Details(Details::from_id(id)?),
            Choice::Anchors => Self::Anchors(AnchorChoice::from_id(id)?),
            Choice::Scene => Self::Scene(Scene::from_id(id)?),
            Choice::Shading => Self::Shading(ShadingMode::from_id(id)?),
            Choice::TextureSource => Self::TextureSource(TextureSource::from_id(id)?),
            Choice::TextureSize => Self::TextureSize(TextureSize::from_id(id)?),
            Choice::Lens => Self::Lens(Lens::from_id(id)?),
            Choice::Triangulation => Self::Triangulation(Triangulation::from_id(id)?),
            Choice::Density => Self::Density(id.parse().ok().filter(|density| *density <= MAX_SHOWN_DENSITY)?),
        })
    }
}

impl Session {
    /// Id of the current value; `None` if it is not an available one, such as when no preset matches.
    pub fn chosen(&self, choice: Choice) -> Option<String> {
        let (options, view, settings) = (self.edit_options(), self.view(), self.stage().render_settings());
        let id = match choice {
            Choice::SelectionMode => self.mode().id(),
            Choice::Preset => options.preset()?.id(),
            Choice::Operator => options.operator.id(),
            Choice::Constraint => CONSTRAINTS.into_iter().find(|(_, one)| *one == options.constraint)?.0,
            Choice::Details => options.details.id(),
            Choice::Anchors => options.anchors.id(),
            Choice::Scene => view.scene.id(),
            Choice::Shading => settings.shading.id(),
            Choice::TextureSource => view.texture_source.id(),
            Choice::TextureSize => view.texture_size.id(),
            Choice::Lens => self.stage().camera().lens().id(),
            Choice::Triangulation => self.face().map_or(view.triangulation, OpenFace::triangulation).id(),
            Choice::Density => return Some(self.density().to_string()),
        };
        Some(id.to_owned())
    }
}
