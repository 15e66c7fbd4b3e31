//! Bytes of an observation, which files, the database and the worker's answers store.

use proptest::prelude::*;
use rosto_face::*;

/// Number of landmarks with the irises.
const WITH_IRISES: usize = 478;

fn lens() -> impl Strategy<Value = PhotoLens> {
    prop_oneof![
        Just(PhotoLens::Estimated),
        Just(PhotoLens::Parallel),
        (5.0..=2000.0).prop_map(PhotoLens::Exif),
        (5.0..=2000.0).prop_map(PhotoLens::Given),
        (0.1..=20.0).prop_map(PhotoLens::Distance),
    ]
}

prop_compose! {
    fn observation()(count in prop_oneof![Just(LANDMARK_COUNT), Just(WITH_IRISES)])(
        noise_m in prop::collection::vec(prop::array::uniform3(-0.002..=0.002), count),
        at in prop::array::uniform2(-3.0..=3.0),
        turn in 0.0..std::f64::consts::TAU,
        faces_per_width in 0.1..=100.0,
        photo_size_px in prop::array::uniform2(100u32..=10_000),
        colours_srgb in prop::collection::vec(any::<[u8; 3]>(), LANDMARK_COUNT),
        found_lens in lens(),
        lens in lens(),
    ) -> Observation {
        let canonical_m = canonical_positions_m();
        let aspect = f64::from(photo_size_px[0]) / f64::from(photo_size_px[1]);
        let landmarks = noise_m.into_iter().enumerate().map(|(index, noise_m)| {
            let known_m = canonical_m[index.min(LANDMARK_COUNT - 1)] + glam::DVec3::from(noise_m);
            let glam::DVec3 { x, y, z } = glam::DMat3::from_rotation_z(turn) * known_m / faces_per_width;
            [at[0] + x, (at[1] - y) * aspect, -z].map(|at| at as f32)
        });
        let landmarks = landmarks.collect();
        Observation { landmarks, photo_size_px, colours_srgb, found_lens, lens, card: None, picture: None }
    }
}

/// The canonical face in a square photo.
fn canonical() -> Observation {
    let landmark = |p: glam::DVec3| [0.5 + 3.0 * p.x, 0.5 - 3.0 * p.y, -3.0 * p.z].map(|at| at as f32);
    Observation {
        landmarks: canonical_positions_m().into_iter().map(landmark).collect(),
        photo_size_px: [300, 300],
        colours_srgb: vec![[180, 120, 90]; LANDMARK_COUNT],
        found_lens: PhotoLens::Exif(26.0),
        card: None,
        lens: PhotoLens::Distance(0.35),
        picture: None,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn each_observation_reads_back_from_its_bytes(observation in observation()) {
        prop_assert_eq!(Observation::from_bytes(&observation.to_bytes()), Ok(observation));
    }

    #[test]
    fn truncated_and_surplus_bytes_are_refused(observation in observation(), share in 0.0..1.0, extra in 1usize..40) {
        let bytes = observation.to_bytes();
        let kept = (bytes.len() as f64 * share) as usize;
        prop_assert_eq!(Observation::from_bytes(&bytes[..kept]), Err(FaceError::Record { bytes: kept }));
        let longer = [bytes, vec![0; extra]].concat();
        prop_assert_eq!(Observation::from_bytes(&longer), Err(FaceError::Record { bytes: longer.len() }));
    }

    #[test]
    fn arbitrary_bytes_do_not_panic(noise in prop::collection::vec(any::<u8>(), 0..8000)) {
        let _ = Observation::from_bytes(&noise);
        let versioned = [&[1], noise.as_slice()].concat();
        let _ = Observation::from_bytes(&versioned);
    }

    /// A changed byte gives an error, or an observation that was checked.
    #[test]
    fn damaged_bytes_give_a_checked_observation_or_an_error(at in any::<prop::sample::Index>(), byte in any::<u8>()) {
        let mut bytes = canonical().to_bytes();
        let at = at.index(bytes.len());
        bytes[at] = byte;
        if let Ok(observation) = Observation::from_bytes(&bytes) {
            prop_assert!(observation.checked().is_ok());
        }
    }
}

#[test]
fn another_version_is_refused_by_its_number() {
    let mut bytes = canonical().to_bytes();
    bytes[0] = 2;
    assert_eq!(Observation::from_bytes(&bytes), Err(FaceError::RecordVersion { found: 2, known: 1 }));
}

#[test]
fn the_picture_is_not_in_the_bytes() {
    let picture = Some(Photo::from_rgb(1, 1, vec![9, 9, 9]).unwrap());
    let with_picture = Observation { picture, ..canonical() };
    assert_eq!(Observation::from_bytes(&with_picture.to_bytes()), Ok(canonical()));
}

#[test]
fn implausible_landmarks_are_refused() {
    let refused = |change: fn(&mut Observation)| {
        let mut observation = canonical();
        change(&mut observation);
        Observation::from_bytes(&observation.to_bytes()).unwrap_err()
    };
    assert_eq!(refused(|of| of.landmarks[7][1] = f32::NAN), FaceError::NotFinite { landmark: 7 });
    assert_eq!(refused(|of| of.landmarks[7][1] = 1e6), FaceError::Implausible);
    assert_eq!(refused(|of| of.landmarks.fill([0.5; 3])), FaceError::Degenerate);
    let shrunk = |of: &mut Observation| of.landmarks.as_flattened_mut().iter_mut().for_each(|number| *number *= 1e-7);
    assert_eq!(refused(shrunk), FaceError::Implausible);
    let far = |of: &mut Observation| of.landmarks[7][1] = 200.0;
    assert!(matches!(refused(far), FaceError::NotAFace { deviation_mm, .. } if deviation_mm > 1000.0));
    assert_eq!(refused(|of| of.photo_size_px = [0, 300]), FaceError::EmptyPicture { width: 0, height: 300 });
}

/// A deterministic number in -0.5..0.5.
fn hashed(index: usize) -> f32 {
    ((index as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40) as f32 / (1 << 24) as f32 - 0.5
}

#[test]
fn landmarks_that_cannot_be_a_face_are_refused() {
    let refused = |landmark: &dyn Fn(usize, [f32; 3]) -> [f32; 3]| {
        let mut observation = canonical();
        let changed = observation.landmarks.iter().enumerate().map(|(index, &at)| landmark(index, at));
        observation.landmarks = changed.collect();
        observation.checked().unwrap_err()
    };
    let random = |index: usize, _| [0, 1, 2].map(|axis| 0.5 + hashed(3 * index + axis));
    let shuffled = |index: usize, _| canonical().landmarks[(index * 101) % LANDMARK_COUNT];
    let mirrored = |_, [x, y, z]: [f32; 3]| [1.0 - x, y, z];
    let inside_out = |_, [x, y, z]: [f32; 3]| [x, y, -z];
    let collapsed =
        |index: usize, [x, y, z]: [f32; 3]| if index.is_multiple_of(2) { [x, y, z] } else { [0.5, 0.5, 0.0] };
    for change in [&random as &dyn Fn(usize, [f32; 3]) -> [f32; 3], &shuffled, &mirrored, &inside_out, &collapsed] {
        let refusal = refused(change);
        assert!(matches!(refusal, FaceError::NotAFace { .. }), "{refusal}");
    }
    let rough = |index: usize, at: [f32; 3]| [0, 1, 2].map(|axis| at[axis] + 0.15 * hashed(3 * index + axis));
    let refusal = refused(&rough);
    assert!(
        matches!(refusal, FaceError::Folded { inside_out_per_cent, .. } if inside_out_per_cent > 25.0),
        "{refusal}"
    );
}

/// A margin of three: real faces deviate by up to 9 mm.
#[test]
fn strange_faces_are_accepted() {
    for (width, height, depth) in [(2.0, 1.0, 1.0), (1.0, 2.0, 1.0), (1.0, 1.0, 2.0), (1.0, 1.0, 0.1), (0.6, 1.0, 1.0)]
    {
        let mut observation = canonical();
        for [x, y, z] in &mut observation.landmarks {
            [*x, *y, *z] = [0.5 + (*x - 0.5) * width, 0.5 + (*y - 0.5) * height, *z * depth];
        }
        assert_eq!(observation.clone().checked(), Ok(observation), "{width} {height} {depth}");
    }
}

#[test]
fn the_chosen_lens_does_not_replace_the_found_one() {
    let found = Observation { lens: PhotoLens::Exif(26.0), ..canonical() };
    let chosen = found.clone().with_lens(PhotoLens::Given(50.0));
    assert_eq!((chosen.found_lens, chosen.lens), (PhotoLens::Exif(26.0), PhotoLens::Given(50.0)));
    let face = FaceModel::new(chosen.clone(), Triangulation::Canonical).unwrap();
    let again = face.with_lens(PhotoLens::Distance(0.5)).unwrap();
    assert_eq!((again.photos()[0].found_lens, again.lens()), (PhotoLens::Exif(26.0), PhotoLens::Distance(0.5)));
}

#[test]
fn a_stretched_face_is_less_likely_one() {
    let Observation { landmarks, photo_size_px, .. } = canonical();
    let stretched = |times: f32| landmarks.iter().map(|&[x, y, z]| [x, 0.5 + times * (y - 0.5), z]).collect::<Vec<_>>();
    let [same, taller, twice] =
        [1.0, 1.5, 2.0].map(|times| likeness(&stretched(times), photo_size_px).expect("no landmark is refused"));
    assert_eq!(same, 1.0);
    assert!(same > taller && taller > twice && twice < 0.1, "{same} {taller} {twice}");
    assert_eq!(likeness(&landmarks[1..], photo_size_px), None);
}
