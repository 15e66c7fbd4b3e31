//! Further photos of an open face.

use glam::{DQuat, DVec3};
use rosto_face::{FaceError, MAX_PHOTOS, PhotoLens, Turn};
use rosto_session::{Changed, FurtherPhoto, Incoming, Intent, Selection, SessionError};
use rosto_studio::Switch;

use super::{act, face, positions, select};
use crate::faces::{detected, open, session};

/// The head turned to its left by an angle, as seen by a distant camera.
fn turned(by_deg: f64) -> FurtherPhoto {
    let turn = DQuat::from_rotation_y(by_deg.to_radians());
    let usual = detected();
    let landmarks = usual.landmarks.iter().map(|place| {
        let [x, y, z] = place.map(f64::from);
        let place = turn * DVec3::new(x - 0.5, 0.5 - y, -z);
        [0.5 + place.x, 0.5 - place.y, -place.z].map(|coordinate| coordinate as f32)
    });
    FurtherPhoto {
        landmarks: landmarks.collect(),
        photo_size_px: usual.photo_size_px,
        colours_srgb: usual.colours_srgb,
        picture: usual.picture,
        lens: PhotoLens::Parallel,
    }
}

fn add(by_deg: f64) -> Intent {
    Intent::AddPhoto(Box::new(turned(by_deg)))
}

/// A face opened with further photos.
fn with_further(further: Vec<FurtherPhoto>) -> Incoming {
    Incoming { further, ..detected() }
}

#[test]
fn adding_and_removing_photos_retains_edits() {
    let mut session = session();
    let alone = positions(&session);
    select(&mut session, Selection::Landmark(4));
    act(&mut session, Intent::Preview(DVec3::new(0.0, 0.0, 5.0)));
    act(&mut session, Intent::Commit);
    let edited = positions(&session);
    assert_eq!(face(&session).missing_turns(), [Turn::Left, Turn::Right]);
    assert_eq!(act(&mut session, add(30.0)), Changed::Mesh);
    assert_eq!(face(&session).missing_turns(), [Turn::Right]);
    act(&mut session, add(-30.0));
    assert_eq!(face(&session).missing_turns(), []);
    let facts = face(&session).photos();
    assert_eq!(
        facts.iter().map(|of| of.turn).collect::<Vec<_>>(),
        [Some(Turn::Front), Some(Turn::Left), Some(Turn::Right)]
    );
    assert!(facts[0].leads && facts.iter().all(|of| of.adds));
    assert_eq!(face(&session).document().history().entries().len(), 1);
    // The edits can be undone and equal those of a face opened with all photos.
    let together = positions(&session);
    act(&mut session, Intent::Undo);
    let mut opened = session_of(with_further(vec![turned(30.0), turned(-30.0)]));
    assert_eq!(positions(&session), positions(&opened), "to the last bit");
    act(&mut session, Intent::Redo);
    assert_eq!(positions(&session), together);
    for photo in [1, 1] {
        act(&mut session, Intent::RemovePhoto(photo));
    }
    assert_eq!(positions(&session), edited, "to the last bit");
    act(&mut session, Intent::Switch(0, Switch::Off));
    assert_eq!(positions(&session), alone);
    act(&mut opened, Intent::Close);
}

fn session_of(incoming: Incoming) -> rosto_session::Session {
    let mut session = session();
    open(&mut session, incoming);
    session
}

#[test]
fn a_photo_of_an_existing_turn_adds_nothing() {
    let mut session = session();
    act(&mut session, add(30.0));
    act(&mut session, add(35.0));
    assert_eq!(face(&session).photos().iter().map(|of| of.adds).collect::<Vec<_>>(), [true, true, false]);
}

#[test]
fn the_frontal_photo_leads() {
    let mut session = session_of(Incoming { landmarks: turned(30.0).landmarks, ..detected() });
    act(&mut session, Intent::SeenFrom(Some(1.0)));
    act(&mut session, add(0.0));
    assert_eq!(face(&session).photos().iter().map(|of| of.leads).collect::<Vec<_>>(), [false, true]);
    assert_eq!(face(&session).model().landmarks(), detected().landmarks);
    assert_eq!(face(&session).photo().seen_from_m(), None, "the distance belongs to another photo");
    act(&mut session, Intent::RemovePhoto(1));
    assert!(face(&session).photos()[0].yaw_deg > 20.0);
    assert_eq!(face(&session).photo().seen_from_m(), Some(1.0), "the distance is restored with its photo");
    act(&mut session, add(0.0));
    assert_eq!(face(&session).photo().seen_from_m(), None);
}

#[test]
fn invalid_photo_changes_are_refused() {
    let mut session = session();
    act(&mut session, add(30.0));
    let before = positions(&session);
    let mut refused = |intent: Intent| {
        let refusal = session.apply(intent).unwrap_err();
        assert_eq!(positions(&session), before);
        assert_eq!(face(&session).photos().len(), 2);
        refusal
    };
    let nowhere = FurtherPhoto { landmarks: vec![[0.5; 3]; 468], ..turned(0.0) };
    let reason = FaceError::InPhoto { photo: 2, reason: Box::new(FaceError::Degenerate) };
    assert_eq!(refused(Intent::AddPhoto(Box::new(nowhere))), reason.into());
    let missing = SessionError::NoSuchPhoto { photo: 2, count: 2 };
    assert_eq!(refused(Intent::RemovePhoto(2)), missing);
    let mut full = session_of(with_further(vec![turned(30.0); MAX_PHOTOS - 1]));
    let most = FaceError::PhotoCount { found: MAX_PHOTOS + 1, most: MAX_PHOTOS };
    assert_eq!(full.apply(add(-30.0)), Err(most.into()));
    let mut alone = session_of(detected());
    let last = FaceError::PhotoCount { found: 0, most: MAX_PHOTOS };
    assert_eq!(alone.apply(Intent::RemovePhoto(0)), Err(last.into()));
}
