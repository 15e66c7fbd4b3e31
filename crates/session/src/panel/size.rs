use rosto_face::{Camera, LANDMARK_COUNT, Length, Measure, PhotoLens, ScaleSource};
use rosto_studio::EditTarget;

use super::build::{button, group, slider, text};
use super::name::word;
use super::widget::{Control, GroupLook, Tone, Widget};
use super::{CM_PER_M, DISTANCE_CM, Phrase};
use crate::open_face::MM_PER_M;
use crate::panel_state::Tape;
use crate::{Intent, OpenFace, Session};

/// How the photo was taken, the size of the face, and a measuring tape.
pub(super) fn section(session: &Session) -> Widget {
    let widgets = session.face().map_or_else(Vec::new, |face| widgets(session, face));
    group("section.size", GroupLook::Section, widgets).on("view")
}

fn widgets(session: &Session, face: &OpenFace) -> Vec<Widget> {
    let (camera, scale, cage) = (face.model().camera(), face.model().scale(), face.document().cage());
    let pose = camera.pose();
    let distance_cm = camera.distance_m.is_finite().then_some(CM_PER_M * camera.distance_m);
    let measure = |measure: Measure| {
        let length = measure.length(cage, scale);
        let value = length.map_or_else(
            || Phrase::word("measure.withheld"),
            |length| shown(MM_PER_M * length.length_m, MM_PER_M * length.within_m()),
        );
        (word("measure", measure.id()), value)
    };
    let degrees = |phrase: Phrase, name, angle: f64| phrase.number(name, angle, 0);
    let turn = degrees(Phrase::word("size.pose"), "yaw", pose.yaw_deg);
    let turn = degrees(degrees(turn, "pitch", pose.pitch_deg), "roll", pose.roll_deg);
    let source = match scale.source {
        ScaleSource::Card => "size.by-card",
        ScaleSource::Irises => "size.by-irises",
        ScaleSource::Canonical => "size.canonical",
    };
    let marking = session.marked_corners().map(|count| Phrase::word("card.next").with("n", (count + 1).to_string()));
    let shown_cm = distance_cm.unwrap_or(DISTANCE_CM.neutral).min(DISTANCE_CM.max);
    let found = face.found_lens();
    vec![
        text("size.camera", Some(taken_from(camera)), Tone::Help),
        slider("size.distance", DISTANCE_CM, "cm", shown_cm, |cm| {
            Intent::PhotoLens(PhotoLens::Distance(cm / CM_PER_M))
        }),
        button("size.known", Intent::PhotoLens(found)),
        text("size.pose", Some(turn), Tone::Help),
        Widget::new("size.measures", Control::Facts { rows: Measure::ALL.map(measure).into() }),
        text("size.source", Some(Phrase::word(source)), Tone::Help),
        button("card.mark", Intent::MarkCard),
        text("card.help", Some(marking.unwrap_or_else(|| Phrase::word("card.help"))), Tone::Status),
        button("card.forget", Intent::ForgetCard)
            .hidden(face.model().card().is_none() && session.marked_corners().is_none()),
        button("tape.start", Intent::StartTape),
        text("tape.result", Some(tape(session, scale.error)), Tone::Status),
    ]
}

/// Distance of the camera with its 90 % interval.
fn taken_from(camera: &Camera) -> Phrase {
    if !camera.distance_m.is_finite() {
        return Phrase::word("size.parallel");
    }
    let key = match camera.lens {
        PhotoLens::Distance(_) => "size.as-given",
        PhotoLens::Estimated => "size.by-face",
        _ => "size.by-lens-data",
    };
    let [nearest_m, farthest_m] = camera.distance_interval_m;
    let ends = [("distance", camera.distance_m), ("nearest", nearest_m), ("farthest", farthest_m)];
    ends.into_iter().fold(Phrase::word(key), |phrase, (name, m)| phrase.number(name, (CM_PER_M * m).round(), 0))
}

/// Distance from the start of the tape to the selection.
fn tape(session: &Session, error: f64) -> Phrase {
    let Some(Tape { from, measured }) = session.tape() else { return Phrase::word("tape.help") };
    let name = |vertex| vertex_name(session, vertex);
    match measured {
        None => Phrase::word("tape.next").with("from", name(from)),
        Some((to, [straight_mm, along_mm])) => {
            let result = Phrase::word("tape.result").with("from", name(from)).with("to", name(to));
            result.with("straight", length(straight_mm, error)).with("along", length(along_mm, error))
        }
    }
}

/// A length along the face with half of its 95 % interval.
fn length(mm: f64, error: f64) -> Phrase {
    let length = Length { length_m: mm / MM_PER_M, error };
    shown(mm, MM_PER_M * length.within_m())
}

fn shown(mm: f64, within_mm: f64) -> Phrase {
    Phrase::word("amount.mm.about").number("mm", mm, 0).number("error", within_mm.max(1.0), 0)
}

/// Name of a vertex, or its number if it is not a landmark.
fn vertex_name(session: &Session, vertex: u32) -> Phrase {
    match vertex {
        landmark if (landmark as usize) < LANDMARK_COUNT => session.name_of(EditTarget::Landmark(landmark)),
        other => Phrase::word("target.point").with("n", other.to_string()),
    }
}
