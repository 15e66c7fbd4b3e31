use super::build::{button, check, group, help, slider, text};
use super::widget::{GroupLook, Tone, Widget};
use super::{CM_PER_M, DISTANCE_CM, PER_CENT, Phrase};
use crate::{BRUSH_PX, FALLOFF_BAND, Intent, OpenFace, Range, Session};

/// Neutral viewing distance, in cm.
const SEEN_FROM_CM: f64 = 150.0;

/// The note about limited edits appears above this share of the photo's longer side.
const MIN_LIMIT_SHARE: f64 = 0.006;

/// The edited photo: viewing distance, falloff band and protecting brush.
pub(super) fn section(session: &Session) -> Widget {
    let face = session.face();
    let seen_from_m = face.map_or(f64::INFINITY, |face| face.seen_by().distance_m);
    let is_as_taken = face.is_none_or(|face| face.photo().seen_from_m().is_none());
    let band = Range {
        min: PER_CENT * FALLOFF_BAND.min,
        max: PER_CENT * FALLOFF_BAND.max,
        step: PER_CENT * FALLOFF_BAND.step,
        neutral: PER_CENT * FALLOFF_BAND.neutral,
    };
    let seen_from_cm = if seen_from_m.is_finite() { CM_PER_M * seen_from_m } else { DISTANCE_CM.max };
    let distance = Range { neutral: SEEN_FROM_CM, ..DISTANCE_CM };
    group(
        "section.in-photo",
        GroupLook::Section,
        vec![
            slider("in-photo.distance", distance, "cm", seen_from_cm, |cm| Intent::SeenFrom(Some(cm / CM_PER_M))),
            help("in-photo.distance.help"),
            button("in-photo.as-taken", Intent::SeenFrom(None)).enabled(!is_as_taken),
            slider("in-photo.ring", band, "%", PER_CENT * session.view().falloff_band, |share| {
                Intent::FalloffBand(share / PER_CENT)
            }),
            help("in-photo.ring.help"),
            limit(face),
            check("brush", session.brush_px().is_some(), |on| Intent::Brush(on.then_some(BRUSH_PX.neutral))),
            brush(session),
        ],
    )
    .on("shape")
}

/// How far the photo lags behind the edits to avoid folds.
fn limit(face: Option<&OpenFace>) -> Widget {
    let limited_px = face.map_or(0.0, |face| face.photo().limited_px());
    let longer_side_px = face.map_or(1, |face| face.model().photo_size_px().into_iter().max().unwrap_or(1));
    let is_visible = limited_px > MIN_LIMIT_SHARE * f64::from(longer_side_px);
    let phrase = is_visible.then(|| Phrase::word("in-photo.limited").number("px", limited_px, 0));
    text("in-photo.limit", phrase, Tone::Status)
}

fn brush(session: &Session) -> Widget {
    let face = session.face();
    let has_strokes = face.is_some_and(|face| face.photo().strokes().count() > 0);
    let can_redo = face.is_some_and(|face| face.photo().strokes().can_redo());
    let size_px = session.brush_px().unwrap_or(BRUSH_PX.neutral);
    group(
        "brush.tools",
        GroupLook::Stack,
        vec![
            help("brush.help"),
            slider("brush.size", BRUSH_PX, "px", size_px, |px| Intent::Brush(Some(px))),
            group(
                "brush.changes",
                GroupLook::Row,
                vec![
                    button("brush.undo", Intent::Undo).enabled(has_strokes),
                    button("brush.redo", Intent::Redo).enabled(can_redo),
                    button("brush.clear", Intent::ClearStrokes).enabled(has_strokes),
                ],
            ),
        ],
    )
    .hidden(session.brush_px().is_none())
}
