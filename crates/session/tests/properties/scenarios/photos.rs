//! Further photos of an open face.

use glam::{DQuat, DVec3};
use rosto::SavedFace;
use rosto_export::TextureSize;
use rosto_face::{FaceError, MAX_PHOTOS, Observation, PhotoLens, Turn};
use rosto_session::{Changed, Intent, Selection, SessionError};
use rosto_studio::Switch;

use super::{act, face, positions, select};
use crate::faces::{detected, found, open, saved, session};

/// The head turned to its left by an angle, as seen by a distant camera.
fn turned(by_deg: f64) -> Observation {
    let turn = DQuat::from_rotation_y(by_deg.to_radians());
    let usual = detected();
    let landmarks = usual.landmarks.iter().map(|place| {
        let [x, y, z] = place.map(f64::from);
        let place = turn * DVec3::new(x - 0.5, 0.5 - y, -z);
        [0.5 + place.x, 0.5 - place.y, -place.z].map(|coordinate| coordinate as f32)
    });
    Observation { landmarks: landmarks.collect(), ..usual }
}

fn add(by_deg: f64) -> Intent {
    Intent::AddPhoto(Box::new(turned(by_deg)))
}

/// A face opened with further photos.
fn with_further(further: Vec<Observation>) -> SavedFace {
    SavedFace { photos: [vec![detected()], further].concat(), edits: None }
}

#[test]
fn adding_and_removing_photos_retains_edits() {
    let mut session = session();
    let alone = positions(&session);
    select(&mut session, Selection::Landmark(4));
    act(&mut session, Intent::Offset(DVec3::new(0.0, 0.0, 5.0)));
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

fn session_of(face: SavedFace) -> rosto_session::Session {
    let mut session = session();
    open(&mut session, face);
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
    let mut session = session_of(found(turned(30.0)));
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
    let nowhere = Observation { landmarks: vec![[0.5; 3]; 468], ..turned(0.0) };
    let reason = FaceError::InPhoto { photo: 2, reason: Box::new(FaceError::Degenerate) };
    assert_eq!(refused(Intent::AddPhoto(Box::new(nowhere))), reason.into());
    let missing = SessionError::NoSuchPhoto { photo: 2, count: 2 };
    assert_eq!(refused(Intent::RemovePhoto(2)), missing);
    let mut full = session_of(with_further(vec![turned(30.0); MAX_PHOTOS - 1]));
    let most = FaceError::PhotoCount { found: MAX_PHOTOS + 1, most: MAX_PHOTOS };
    assert_eq!(full.apply(add(-30.0)), Err(most.into()));
    let mut alone = session_of(found(detected()));
    let last = FaceError::PhotoCount { found: 0, most: MAX_PHOTOS };
    assert_eq!(alone.apply(Intent::RemovePhoto(0)), Err(last.into()));
}

#[test]
fn the_found_lens_survives_another_choice_and_saving() {
    let mut session = session_of(found(Observation { found_lens: PhotoLens::Exif(26.0), ..detected() }));
    act(&mut session, Intent::PhotoLens(PhotoLens::Distance(0.4)));
    let again = session_of(saved(&session));
    let lenses = (face(&again).found_lens(), face(&again).model().lens());
    assert_eq!(lenses, (PhotoLens::Exif(26.0), PhotoLens::Distance(0.4)));
    assert_eq!(positions(&again), positions(&session), "to the last bit");
}

#[test]
fn a_texture_is_wanted_for_each_change_of_photos_lens_and_size() {
    let mut session = session();
    let mut wanted = vec![session.texture_wanted().unwrap()];
    let another_size = TextureSize::ALL.into_iter().find(|size| *size != TextureSize::default()).unwrap();
    let changes = [
        add(30.0),
        Intent::RemovePhoto(1),
        Intent::PhotoLens(PhotoLens::Distance(0.4)),
        Intent::TextureSize(another_size),
        Intent::Open(Box::new(found(detected()))),
    ];
    for change in changes {
        let is_size = matches!(change, Intent::TextureSize(_));
        let earlier = wanted[wanted.len() - 1];
        assert_eq!(session.take_texture(earlier), Changed::Mesh);
        assert_eq!((session.texture_wanted(), session.shows_texture()), (None, true));
        act(&mut session, change);
        assert_eq!(session.shows_texture(), is_size, "another size is shown until the new texture arrives");
        let next = session.texture_wanted().unwrap();
        assert!(!wanted.contains(&next));
        assert_eq!(session.take_texture(earlier), Changed::Nothing);
        wanted.push(next);
    }
    act(&mut session, Intent::Close);
    assert_eq!((session.texture_wanted(), session.shows_texture()), (None, false));
}
