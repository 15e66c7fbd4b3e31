use rosto_stage::{Mark, MarkKind, MirrorPlane, Stage};
use rosto_studio::Mirror;

use crate::open_face::OpenFace;
use crate::{Choices, Selection};

/// How strongly the response glows over the face while something moves.
const GLOW: f64 = 0.75;

/// Makes the stage show what is selected, held, pinned and pointed at.
pub(crate) fn show(stage: &mut Stage, face: Option<&OpenFace>, choices: &Choices, pointed: Option<Selection>) {
    let Some(face) = face else {
        stage.set_marks(Vec::new());
        stage.set_gizmo(None);
        stage.set_hovered(None);
        return show_plane(stage, MirrorPlane::Hidden);
    };
    // A slider has its own handles and anchors, and shows by its glow alone.
    let selection = face.selection().filter(|_| face.slider().is_none());
    let anchors = if selection.is_some() { face.document().anchors() } else { &[] };
    let regions = selection.iter().chain(&pointed).filter_map(|selection| match selection {
        Selection::Region(region) => Some(region.vertices()),
        Selection::Landmark(_) | Selection::Point { .. } => None,
    });
    let region: Vec<u32> = regions.flatten().collect();
    let middle = selection.map(Selection::middle);
    let mark = |kind| move |&vertex: &u32| Mark { vertex, kind };
    let is_pin = |vertex: &u32| face.pins().contains(vertex);
    let is_shown = |vertex: &&u32| (**vertex as usize) < face.document().rest().len();
    let anchors = anchors.iter().filter(|anchor| !is_pin(anchor)).map(mark(MarkKind::Square));
    let pins = face.pins().iter().filter(is_shown).map(mark(MarkKind::Pin));
    let marks = anchors.chain(pins).chain(region.iter().map(mark(MarkKind::Speck)));
    stage.set_marks(marks.chain(middle.iter().map(mark(MarkKind::Ring))).collect());
    stage.set_gizmo(middle.filter(|_| face.refusal().is_none()));
    let is_mirrored = middle.is_some() && choices.mirror == Mirror::On && face.can_mirror();
    show_plane(stage, if is_mirrored { MirrorPlane::Shown } else { MirrorPlane::Hidden });
}

fn show_plane(stage: &mut Stage, mirror_plane: MirrorPlane) {
    if stage.render_settings().mirror_plane != mirror_plane {
        stage.render_settings_mut().mirror_plane = mirror_plane;
    }
}

/// Makes the stage follow one tick of an edit: three numbers, unless details turn.
pub(crate) fn show_offset(stage: &mut Stage, face: Option<&OpenFace>) {
    let following = face.filter(|face| !face.turns_details());
    stage.set_offsets_m(following.map(OpenFace::influence_offsets_m).unwrap_or_default());
    let glow = if face.is_some_and(OpenFace::is_moving) { GLOW } else { 0.0 };
    if stage.render_settings().glow != glow {
        stage.render_settings_mut().glow = glow;
    }
    stage.ask_for_a_frame();
}
