//! Changing the photo's distance while the face is open.

use glam::DVec3;
use rosto_face::{Measure, PhotoLens};
use rosto_session::{Changed, Intent, Session, SessionError};

use crate::faces::{bits, session};

fn positions(session: &Session) -> Vec<DVec3> {
    session.face().unwrap().document().positions().to_vec()
}

fn nose_moved() -> Session {
    let mut session = session();
    session.apply(Intent::SelectAt(1)).unwrap();
    session.apply(Intent::Offset(DVec3::new(0.0, 0.0, 5.0))).unwrap();
    session.apply(Intent::Commit).unwrap();
    session
}

#[test]
fn another_lens_rebuilds_the_model_and_is_reversible() {
    let mut session = nose_moved();
    let before = positions(&session);
    assert_eq!(session.apply(Intent::PhotoLens(PhotoLens::Distance(0.3))), Ok(Changed::Mesh));
    let face = session.face().unwrap();
    let (edited, found) = (face.document().positions(), face.document().rest());
    assert!((edited[1].z - found[1].z - 0.005).abs() < 2e-4, "the edit of the nose is reapplied");
    let width = |positions: &[DVec3]| Measure::FaceWidth.of(positions);
    assert!(width(found) > 1.02 * width(&before), "perspective had made the parts behind the nose smaller");
    assert!((face.model().camera().distance_m - 0.3).abs() < 0.003);
    assert_eq!(session.state().entry_count, 1);
    session.apply(Intent::PhotoLens(PhotoLens::Parallel)).unwrap();
    assert_eq!(bits(&positions(&session)), bits(&before));
}

#[test]
fn another_lens_commits_the_edit_in_progress() {
    let mut session = session();
    session.apply(Intent::SelectAt(1)).unwrap();
    session.apply(Intent::Offset(DVec3::new(0.0, 3.0, 0.0))).unwrap();
    let selection = session.face().unwrap().selection();
    session.apply(Intent::PhotoLens(PhotoLens::Given(50.0))).unwrap();
    let state = session.state();
    assert_eq!((state.entry_count, session.face().unwrap().selection()), (1, selection));
    session.apply(Intent::Undo).unwrap();
    let face = session.face().unwrap();
    assert_eq!(bits(face.document().positions()), bits(face.document().rest()));
}

#[test]
fn invalid_lenses_and_a_missing_face_are_refused() {
    let mut session = nose_moved();
    let before = bits(&positions(&session));
    assert!(session.apply(Intent::PhotoLens(PhotoLens::Distance(f64::NAN))).is_err());
    assert_eq!(bits(&positions(&session)), before);
    session.apply(Intent::Close).unwrap();
    assert_eq!(session.apply(Intent::PhotoLens(PhotoLens::Estimated)), Err(SessionError::NoFace));
}

#[test]
fn distances_are_measured_straight_and_along_the_surface() {
    let session = session();
    let face = session.face().unwrap();
    let [straight, along] = face.measured_mm(61, 291).unwrap();
    let positions = face.document().positions();
    assert!((straight - positions[61].distance(positions[291]) * 1000.0).abs() < 1e-9);
    assert!(along > 1.02 * straight && along < 1.6 * straight, "{straight} {along}");
    let [there, back] = [face.measured_mm(4, 234).unwrap(), face.measured_mm(234, 4).unwrap()];
    assert_eq!(there[0], back[0]);
    assert!((there[1] / back[1] - 1.0).abs() < 0.1, "{there:?} {back:?}");
    assert!(face.measured_mm(0, 7_257).is_err());
}
