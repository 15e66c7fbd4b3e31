use rosto_studio::FaceSlider;

use super::build::{button, choice, group, slider};
use super::name::word;
use super::widget::{ChoiceLook, Control, GroupLook, Widget};
use super::{PER_CENT, Phrase};
use crate::open_face::MM_PER_M;
use crate::panel_state::SYMMETRY_SHARE;
use crate::{Intent, Range, Session, ShapePart};

/// Change of a ready-made slider per key press, in mm.
const STEP_MM: f64 = 0.1;

/// Range of the share by which a face is made symmetric, in per cent.
const SYMMETRY: Range = Range { min: 1.0, max: PER_CENT, step: 1.0, neutral: PER_CENT * SYMMETRY_SHARE };

/// The parts of the face, and the controls of the chosen one.
pub(super) fn section(session: &Session) -> Widget {
    let chosen = session.shape_part();
    let options = ShapePart::ALL.map(|part| part.id().to_owned()).into();
    let control = Control::Choice {
        name: "shape",
        options,
        expert: &[],
        chosen: Some(chosen.id().to_owned()),
        look: ChoiceLook::Icons,
    };
    let parts = choice("shape", control, |id| Some(Intent::Part(ShapePart::from_id(&id)?)));
    let controls = ShapePart::ALL.into_iter().filter(|part| !part.sliders().is_empty()).map(|part| {
        let sliders = part.sliders().iter().map(|slider| proportion(session, *slider)).collect();
        group(format!("shape.{}", part.id()), GroupLook::Stack, sliders).hidden(part != chosen)
    });
    let symmetry = symmetry(session).hidden(chosen != ShapePart::Face);
    group("section.face", GroupLook::Plain, [parts].into_iter().chain(controls).chain([symmetry]).collect()).on("shape")
}

fn symmetry(session: &Session) -> Widget {
    let share = session.symmetry_share();
    group(
        "symmetry",
        GroupLook::Stack,
        vec![
            slider("symmetrise", SYMMETRY, "%", PER_CENT * share, |share| Intent::SymmetryShare(share / PER_CENT)),
            button("symmetrise.apply", Intent::Symmetrise(share)),
        ],
    )
}

fn proportion(session: &Session, face_slider: FaceSlider) -> Widget {
    let value = session.face().map_or(0.0, |face| face.slider_mm(face_slider));
    slider(format!("slider.{}", face_slider.id()), range_mm(face_slider), "mm", value, move |to_mm| {
        Intent::Slide(face_slider, to_mm)
    })
}

/// Range of a ready-made slider.
fn range_mm(slider: FaceSlider) -> Range {
    let max = slider.range_m() * MM_PER_M;
    Range { min: -max, max, step: STEP_MM, neutral: 0.0 }
}

/// Speech after a commit of a ready-made slider.
pub(crate) fn slid(slider: FaceSlider, mm: f64) -> Phrase {
    Phrase::word("face.slid").with("name", word("slider", slider.id())).number("mm", mm, 1)
}
