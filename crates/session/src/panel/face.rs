use rosto_studio::FaceSlider;

use super::build::{button, group, slider};
use super::name::word;
use super::widget::{GroupLook, Widget};
use super::{PER_CENT, Phrase};
use crate::open_face::MM_PER_M;
use crate::panel_state::SYMMETRY_SHARE;
use crate::{Intent, Range, Session};

/// Change of a ready-made slider per key press, in mm.
const STEP_MM: f64 = 0.1;

/// Range of the share by which a face is made symmetric, in per cent.
const SYMMETRY: Range = Range { min: 1.0, max: PER_CENT, step: 1.0, neutral: PER_CENT * SYMMETRY_SHARE };

/// The ready-made sliders, and symmetry.
pub(super) fn section(session: &Session) -> Widget {
    let sliders = FaceSlider::ALL.map(|slider| proportion(session, slider)).into();
    let share = session.symmetry_share();
    group(
        "section.face",
        GroupLook::Section,
        vec![
            group("face.sliders", GroupLook::Stack, sliders),
            group(
                "symmetry",
                GroupLook::Stack,
                vec![
                    slider("symmetrise", SYMMETRY, "%", PER_CENT * share, |share| {
                        Intent::SymmetryShare(share / PER_CENT)
                    }),
                    button("symmetrise.apply", Intent::Symmetrise(share)),
                ],
            ),
        ],
    )
    .on("shape")
    .open()
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
