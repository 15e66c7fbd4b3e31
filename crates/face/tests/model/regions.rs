//! Consistency of regions and names.

use std::collections::BTreeSet;

use rosto_face::*;

#[test]
fn mirrored_regions_contain_mirrored_landmarks() {
    for region in Region::ALL {
        let mirrored: BTreeSet<u32> = region.vertices().into_iter().map(mirror_of).collect();
        assert_eq!(mirrored.into_iter().collect::<Vec<_>>(), region.mirrored().vertices(), "{region:?}");
        assert_eq!(region.mirrored().mirrored(), region);
    }
}

#[test]
fn regions_are_connected_on_the_canonical_mesh() {
    let topology = Triangulation::Canonical.topology();
    for region in Region::ALL {
        let members: BTreeSet<u32> = region.vertices().into_iter().collect();
        let first = *members.first().unwrap();
        let (mut reached, mut open) = (BTreeSet::from([first]), vec![first]);
        while let Some(vertex) = open.pop() {
            open.extend(topology.neighbours(vertex).iter().filter(|&v| members.contains(v) && reached.insert(*v)));
        }
        assert_eq!(reached, members, "{region:?}");
    }
}

#[test]
fn regions_are_located_as_named() {
    let centre_m = |region: Region| {
        let vertices = region.vertices();
        let positions = canonical_positions_m();
        vertices.iter().map(|&v| positions[v as usize]).sum::<glam::DVec3>() / vertices.len() as f64
    };
    assert!(centre_m(Region::Forehead).y > centre_m(Region::LeftBrow).y);
    assert!(centre_m(Region::LeftBrow).y > centre_m(Region::LeftUpperEyelid).y);
    assert!(centre_m(Region::LeftUpperEyelid).y > centre_m(Region::LeftLowerEyelid).y);
    assert!(centre_m(Region::UpperLip).y > centre_m(Region::LowerLip).y);
    assert!(centre_m(Region::LowerLip).y > centre_m(Region::Chin).y);
    assert!(centre_m(Region::NoseTip).z > centre_m(Region::NoseBridge).z);
    assert!(centre_m(Region::LeftEye).x > 0.0 && centre_m(Region::RightEye).x < 0.0);
    assert!(Region::Nose.vertices().contains(&4) && Region::Lips.vertices().contains(&61));
}

#[test]
fn region_ids_are_unique_and_round_trip() {
    let ids: BTreeSet<&str> = Region::ALL.iter().map(|region| region.id()).collect();
    assert_eq!(ids.len(), Region::ALL.len());
    assert!(Region::ALL.iter().all(|&region| Region::from_id(region.id()) == Some(region)));
}

#[test]
fn landmark_ids_are_unique() {
    let ids: BTreeSet<String> = (0..LANDMARK_COUNT as u32).map(landmark_id).collect();
    assert_eq!(ids.len(), LANDMARK_COUNT);
}

#[test]
fn known_landmarks_have_anatomical_ids() {
    for (landmark, id) in [
        (1, "nose-tip"),
        (61, "right-mouth-corner"),
        (291, "left-mouth-corner"),
        (234, "right-face-edge-at-the-ear"),
        (101, "right-cheek-101"),
    ] {
        assert_eq!(landmark_id(landmark), id);
    }
    assert_eq!((part_id(1), part_id(425)), ("nose-tip".to_owned(), "left-cheek".to_owned()));
    let has_anatomical_name = |landmark: &u32| !landmark_id(*landmark).ends_with(|last: char| last.is_ascii_digit());
    assert!((0..LANDMARK_COUNT as u32).filter(has_anatomical_name).count() >= 80);
    assert!(MIDLINE.iter().all(has_anatomical_name));
}

#[test]
fn containing_regions_are_sorted_by_size() {
    assert_eq!(Region::containing(1), [Region::NoseTip, Region::Nose]);
    for landmark in 0..468 {
        let regions = Region::containing(landmark);
        assert!(regions.is_sorted_by_key(|region| region.vertices().len()));
        assert!(regions.iter().all(|region| region.vertices().contains(&landmark)));
    }
}
