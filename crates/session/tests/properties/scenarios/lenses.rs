use glam::{DQuat, DVec2, DVec3};
use rosto_face::{Observation, crowded_landmarks};
use rosto_session::{Changed, Intent, Pace, Selection, Session};
use rosto_stage::{Axis, Lens, NamedView, Pointer, Visibility};

use super::{act, displacement_mm, face, position_px, positions, select};
use crate::faces::{detected, found, open, session};
use crate::invariants::seen;

const NOSE_TIP: u32 = 4;
/// Landmarks visible from the front with each lens: nose, brows, mouth, chin.
const VISIBLE: [u32; 7] = [4, 9, 105, 334, 61, 291, 199];

fn with(lens: Lens) -> Session {
    let mut session = session();
    act(&mut session, Intent::Expert(true));
    act(&mut session, Intent::Backdrop(Visibility::Hidden));
    act(&mut session, Intent::Lens(lens));
    session.stage_mut().advance(0.0);
    session
}

/// A face turned and tilted to the camera.
fn turned() -> Observation {
    let turn = DQuat::from_euler(glam::EulerRot::ZYX, 0.4, -0.3, 0.2);
    let usual = detected();
    let landmarks = usual.landmarks.iter().map(|place| {
        let [x, y, z] = place.map(f64::from);
        let place = turn * DVec3::new(x - 0.5, 0.5 - y, -z);
        [0.45 + place.x, 0.55 - place.y, -place.z].map(|coordinate| coordinate as f32)
    });
    Observation { landmarks: landmarks.collect(), ..usual }
}

#[test]
fn mesh_and_photo_coincide_in_the_photos_lens() {
    for photo in [detected(), turned()] {
        let [width, height] = photo.photo_size_px.map(f64::from);
        let photo_px = |[x, y, _]: [f32; 3]| DVec2::new(f64::from(x) * width, f64::from(y) * height);
        let in_photo: Vec<DVec2> = photo.landmarks.iter().map(|&landmark| photo_px(landmark)).collect();
        let mut session = with(Lens::Portrait);
        open(&mut session, found(photo));
        let off_px = |session: &Session| {
            let on_view = |landmark: usize| position_px(session, landmark as u32);
            let along = |landmark: usize| (in_photo[landmark] - in_photo[1], on_view(landmark) - on_view(1));
            let (a, b) = along(10);
            let scale = a.dot(b) / a.length_squared();
            (0..468)
                .filter(|landmark| !crowded_landmarks().contains(&(*landmark as u32)))
                .map(|landmark| {
                    let (a, b) = along(landmark);
                    (a * scale).distance(b)
                })
                .fold(0.0, f64::max)
        };
        assert!(off_px(&session) > 5.0, "a portrait lens gives another picture");
        act(&mut session, Intent::Lens(Lens::AsTaken));
        session.stage_mut().advance(0.0);
        assert!(off_px(&session) < 1e-3, "{} px", off_px(&session));
        act(&mut session, Intent::Orbit(DVec2::splat(40.0)));
        session.stage_mut().advance(0.0);
        assert!(off_px(&session) > 5.0);
        act(&mut session, Intent::GoTo(NamedView::Reset));
        session.stage_mut().advance(0.0);
        assert!(off_px(&session) < 1e-3, "{} px", off_px(&session));
    }
}

#[test]
fn hovering_and_dragging_work_with_each_lens() {
    let motion_px = DVec2::new(12.0, -20.0);
    for lens in Lens::ALL {
        for landmark in VISIBLE {
            let mut session = with(lens);
            let (place, before) = (position_px(&session, landmark), positions(&session));
            act(&mut session, Intent::Hover(Some(place)));
            assert_eq!(session.hovered().vertex, Some(landmark), "{lens:?}");
            act(&mut session, Intent::Press(place, Pointer::Fine));
            act(&mut session, Intent::Drag(place + motion_px, Pace::Usual));
            assert_eq!(face(&session).selection(), Some(Selection::Landmark(landmark)));
            let lies_in_plane = displacement_mm(&session, &before, landmark).x == 0.0;
            let wanted_px = if lies_in_plane { motion_px * DVec2::Y } else { motion_px };
            let moved_px = position_px(&session, landmark) - place;
            assert!(moved_px.distance(wanted_px) < 1.0, "{lens:?}, {landmark}: {moved_px}");
        }
    }
}

#[test]
fn gizmo_axes_are_grabbed_with_each_lens() {
    for lens in Lens::ALL {
        let mut session = with(lens);
        act(&mut session, Intent::Orbit(DVec2::new(90.0, 60.0)));
        session.stage_mut().advance(0.0);
        select(&mut session, Selection::Landmark(NOSE_TIP));
        let tip_m = positions(&session)[NOSE_TIP as usize];
        for axis in Axis::ALL {
            let camera = session.stage().camera();
            let on_arm = camera.project(tip_m + axis.direction() * 45.0 * camera.m_per_px_at(tip_m)).unwrap();
            act(&mut session, Intent::Hover(Some(on_arm)));
            assert_eq!(session.hovered().axis, Some(axis), "{lens:?}");
        }
    }
}

#[test]
fn a_lens_changes_only_the_view() {
    let mut session = session();
    for lens in Lens::ALL.into_iter().rev() {
        let edits = |session: &_| {
            (face(session).document().history().clone(), positions(session), face(session).rows().to_vec())
        };
        let before = edits(&session);
        assert_eq!(act(&mut session, Intent::Lens(lens)), Changed::View);
        assert!(edits(&session) == before, "a lens is not an entry");
        assert_eq!(session.stage().camera().lens(), lens);
        let seen_before = seen(&session);
        act(&mut session, Intent::Undo);
        assert_eq!(seen(&session), seen_before);
        open(&mut session, found(detected()));
        assert_eq!(session.stage().camera().lens(), lens, "the lens persists");
    }
}
