use rosto_stage::{Mark, MarkKind, RenderSettings, Stage, Visibility};
use rosto_studio::{Mirror, RegionOfInfluence, Settings, Switch};

use crate::Selection;
use crate::open_face::OpenFace;
use crate::selection::Moving;

/// Strength of the response's glow on the face during an edit.
const GLOW: f64 = 0.75;

/// Marks the selection, the pins, the hovered vertex and, if enabled, the anchors on the stage. In comparisons with the
/// original face, and without a face, there are no marks.
pub(crate) fn show(stage: &mut Stage, face: Option<&OpenFace>, anchors: Switch, pointed: Option<Selection>) {
    let RenderSettings { before, wipe, .. } = *stage.render_settings();
    let Some(face) = face.filter(|_| before == 0.0 && wipe.is_none()) else {
        stage.set_marks(Vec::new());
        stage.set_gizmo(None);
        return stage.set_hovered(None);
    };
    // A ready-made slider has its own handles and anchors; only its glow is shown.
    let selection = face.selection().filter(|_| !face.is_sliding());
    let anchors = if selection.is_some() && anchors == Switch::On { face.document().anchors() } else { &[] };
    let regions = selection.iter().chain(&pointed).filter_map(|selection| match selection {
        Selection::Region(region) => Some(region.vertices()),
        Selection::Landmark(_) | Selection::Point { .. } => None,
    });
    let region: Vec<u32> = regions.flatten().collect();
    let centre = selection.map(Selection::centre);
    let mark = |kind| move |&vertex: &u32| Mark { vertex, kind };
    let is_pin = |vertex: &u32| face.pins().contains(vertex);
    let is_shown = |vertex: &&u32| (**vertex as usize) < face.document().rest().len();
    let anchors = anchors.iter().filter(|anchor| !is_pin(anchor)).map(mark(MarkKind::Square));
    let pins = face.pins().iter().filter(is_shown).map(mark(MarkKind::Pin));
    let marks = anchors.chain(pins).chain(region.iter().map(mark(MarkKind::Speck)));
    stage.set_marks(marks.chain(centre.iter().map(mark(MarkKind::Ring))).collect());
    stage.set_gizmo(centre.filter(|_| face.refusal().is_none()));
}

/// Updates the stage for a tick: the offsets (unless details rotate), the glow and, while the selection moves, the rim
/// of the edit and the mirror plane.
pub(crate) fn show_offset(stage: &mut Stage, face: Option<&OpenFace>) {
    let following = face.filter(|face| !face.turns_details());
    stage.set_offsets_m(following.map(OpenFace::influence_offsets_m).unwrap_or_default());
    // An expression has no influence field to display as a glow.
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
    stage.request_frame();
}

fn settings(face: &OpenFace) -> Option<&Settings> {
    face.document().spec().map(|spec| &spec.settings)
}
