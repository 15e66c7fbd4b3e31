use rosto_stage::{Mark, MarkKind, RenderSettings, Stage, Visibility};
use rosto_studio::{Mirror, RegionOfInfluence, Settings, Switch};

use crate::Selection;
use crate::open_face::OpenFace;
use crate::selection::Moving;

/// How strongly the response glows over the face while something moves.
const GLOW: f64 = 0.75;

/// Makes the stage show what is selected, pinned and pointed at, and what stays in place if that is asked for. Beside the
/// shape before, the face is all that is shown.
pub(crate) fn show(stage: &mut Stage, face: Option<&OpenFace>, anchors: Switch, pointed: Option<Selection>) {
    let RenderSettings { before, wipe, .. } = *stage.render_settings();
    let Some(face) = face.filter(|_| before == 0.0 && wipe.is_none()) else {
        stage.set_marks(Vec::new());
        stage.set_gizmo(None);
        return stage.set_hovered(None);
    };
    // A slider has its own handles and anchors, and shows by its glow alone.
    let selection = face.selection().filter(|_| !face.is_sliding());
    let anchors = if selection.is_some() && anchors == Switch::On { face.document().anchors() } else { &[] };
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
}

/// Makes the stage follow one tick of an edit: three numbers, unless details turn. While what is selected moves, its edit's
/// reach and the mirror's plane are drawn.
pub(crate) fn show_offset(stage: &mut Stage, face: Option<&OpenFace>) {
    let following = face.filter(|face| !face.turns_details());
    stage.set_offsets_m(following.map(OpenFace::influence_offsets_m).unwrap_or_default());
    // What an expression moves has no field of shares that could glow.
    let glows = face.is_some_and(|face| face.is_moving() && face.expression().is_none());
    let glow = if glows { GLOW } else { 0.0 };
    let settings = face.filter(|face| matches!(face.moving(), Moving::Selection { .. })).and_then(settings);
    let is_near = settings.is_some_and(|settings| settings.influence != RegionOfInfluence::Whole);
    let is_mirrored = settings.is_some_and(|settings| settings.mirror == Mirror::On);
    let rim = if is_near { Visibility::Shown } else { Visibility::Hidden };
    let mirror_plane = if is_mirrored { Visibility::Shown } else { Visibility::Hidden };
    let now = RenderSettings { glow, rim, mirror_plane, ..*stage.render_settings() };
    if *stage.render_settings() != now {
        *stage.render_settings_mut() = now;
    }
    stage.ask_for_a_frame();
}

fn settings(face: &OpenFace) -> Option<&Settings> {
    face.document().spec().map(|spec| &spec.settings)
}
