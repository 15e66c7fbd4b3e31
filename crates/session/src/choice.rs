//! What is chosen among named things, and how: panels are filled, stored preferences are read and the session's own tests
//! are drawn from this table.

use rosto_export::TextureSize;
use rosto_face::Triangulation;
use rosto_stage::{Lens, Scene, ShadingMode};
use rosto_studio::{ConstraintKind, Details, Operator};

use crate::incoming::DENSEST_SHOWN;
use crate::{AnchorChoice, Intent, Preset, SelectionMode, Session, TextureSource};

rosto_mesh::named! {
    /// Something that is chosen among named things.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Choice {
        /// What a click or a drag selects.
        SelectionMode = "selection",
        /// Choices that go together.
        Preset = "preset",
        /// The Laplacian.
        Operator = "operator",
        /// Whether handles and anchors are soft or hard constraints.
        Constraint = "constraint",
        /// Whether details turn with the surface.
        Details = "details",
        /// What stays in place beside the pins.
        Anchors = "anchors",
        /// What is on the stage.
        Scene = "scene",
        /// How the surface is coloured.
        Shading = "shading",
        /// Which picture is laid on the face.
        TextureSource = "texture-source",
        /// How large the texture of the whole face is.
        TextureSize = "texture-size",
        /// From how far away the face is seen.
        Lens = "lens",
        /// How the landmarks are joined.
        Triangulation = "triangulation",
        /// How often the mesh is subdivided.
        Density = "density",
    }
}

/// The constraints that are offered; the soft one has the paper's weight.
const CONSTRAINTS: [(&str, ConstraintKind); 2] =
    [("exact", ConstraintKind::Hard), ("soft", ConstraintKind::Soft { weight: 1.0 })];

impl Choice {
    /// The ids of what there is to choose from, in the order that panels show them in.
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
            Self::Density => (0..=DENSEST_SHOWN).map(|density| density.to_string()).collect(),
        }
    }

    /// The intent to choose what has this id; none if nothing has it.
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
            Self::Density => Intent::Density(id.parse().ok().filter(|density| *density <= DENSEST_SHOWN)?),
        })
    }
}

impl Session {
    /// The id of what is chosen now; none where no offered one is, such as no preset.
    pub fn chosen(&self, choice: Choice) -> Option<String> {
        let (choices, view) = (self.choices(), self.view());
        let id = match choice {
            Choice::SelectionMode => self.mode().id(),
            Choice::Preset => choices.preset()?.id(),
            Choice::Operator => choices.operator.id(),
            Choice::Constraint => CONSTRAINTS.into_iter().find(|(_, one)| *one == choices.constraint)?.0,
            Choice::Details => choices.details.id(),
            Choice::Anchors => choices.anchors.id(),
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
