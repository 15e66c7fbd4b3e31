use glam::DVec3;
use rosto_face::{MIDLINE, Region, Triangulation, mirror_of};
use rosto_laplacian::LaplacianError;
use rosto_session::{AnchorChoice, Intent, Selection, SelectionMode, Session, SessionError};
use rosto_studio::{ConstraintKind, EditTarget, EntryStatus, Mirror, StudioError, Switch};

use super::{act, displacement_mm, face, move_by, position_px, positions, select, select_points, state};
use crate::faces::{SIZE_PX, session};
use crate::invariants::check;

const NOSE_TIP: u32 = 1;
const CHIN: u32 = 199;

fn selection(session: &Session) -> Option<Selection> {
    face(session).selection()
}

#[test]
fn a_region_moves_on_both_sides() {
    let mut session = session();
    let brow = Selection::Region(Region::LeftBrow);
    select(&mut session, brow);
    let before = positions(&session);
    let offset_mm = DVec3::new(1.0, 2.0, 0.5);
    move_by(&mut session, offset_mm);
    for vertex in brow.handles() {
        assert!(displacement_mm(&session, &before, vertex).distance(offset_mm) < 1e-9);
        let mirrored = DVec3::new(-offset_mm.x, offset_mm.y, offset_mm.z);
        assert!(displacement_mm(&session, &before, mirror_of(vertex)).distance(mirrored) < 1e-9);
    }
    let entries = face(&session).document().history().entries();
    assert_eq!((selection(&session), entries.len(), entries[0].label.as_str()), (Some(brow), 1, "left-brow"));
    assert!(face(&session).committed_mm().distance(offset_mm) < 1e-9);
}

#[test]
fn repeated_selection_takes_the_next_larger_region() {
    let mut session = session();
    act(&mut session, Intent::Mode(SelectionMode::Region));
    let mut seen = Vec::new();
    for _ in 0..4 {
        act(&mut session, Intent::SelectAt(NOSE_TIP));
        seen.push(selection(&session).unwrap());
    }
    let [tip, nose] = [Region::NoseTip, Region::Nose].map(Selection::Region);
    assert_eq!(seen, [tip, nose, tip, nose]);
}

#[test]
fn the_selection_follows_the_mode() {
    let mut session = session();
    act(&mut session, Intent::Mode(SelectionMode::Region));
    assert_eq!(selection(&session), None);
    act(&mut session, Intent::Mode(SelectionMode::Landmark));
    select(&mut session, Selection::Landmark(4));
    act(&mut session, Intent::Mode(SelectionMode::Region));
    let region = Selection::Region(Region::containing(4)[0]);
    assert_eq!(selection(&session), Some(region));
    assert!(face(&session).holds(4) && !face(&session).holds(152));
    act(&mut session, Intent::Mode(SelectionMode::Region));
    assert_eq!(selection(&session), Some(region));
    act(&mut session, Intent::Mode(SelectionMode::Landmark));
    assert_eq!(selection(&session), Some(Selection::Landmark(region.centre())));
}

#[test]
fn only_selections_with_edits_in_force_can_be_reset() {
    let mut session = session();
    let [nose, lips] = [Region::Nose, Region::Lips].map(Selection::Region);
    assert_eq!(session.apply(Intent::ResetSelected), Err(SessionError::NothingSelected));
    select(&mut session, nose);
    let before = positions(&session);
    move_by(&mut session, DVec3::Z * 2.0);
    assert!(face(&session).can_reset_selection());
    select(&mut session, lips);
    assert!(!face(&session).can_reset_selection());
    select(&mut session, nose);
    act(&mut session, Intent::ResetSelected);
    assert!(!face(&session).can_reset_selection());
    assert_eq!(positions(&session), before);
}

#[test]
fn symmetric_selections_leave_the_mirror_only_sideways() {
    let mut session = session();
    let one_sided = [Selection::Landmark(61), Selection::Region(Region::LeftBrow)];
    let whole = [Selection::Landmark(NOSE_TIP), Selection::Region(Region::Nose)];
    for (selections, in_plane) in [(one_sided, false), (whole, true)] {
        for selection in selections {
            act(&mut session, Intent::Mirror(Mirror::On));
            select(&mut session, selection);
            assert_eq!(face(&session).lies_in_plane(session.edit_options()), in_plane, "{selection:?}");
            let before = positions(&session);
            act(&mut session, Intent::Offset(DVec3::new(0.0, 2.0, 1.0)));
            let sideways = |vertex: u32| {
                displacement_mm(&session, &before, vertex).x + displacement_mm(&session, &before, mirror_of(vertex)).x
            };
            assert!((0..468).all(|vertex| sideways(vertex).abs() < 1e-9), "{selection:?} moves both sides alike");
            act(&mut session, Intent::Offset(DVec3::X));
            let displacement_mm = displacement_mm(&session, &before, selection.centre());
            assert!(displacement_mm.distance(DVec3::X) < 1e-9, "{selection:?} moves by {displacement_mm} mm");
            assert_eq!(state(&session).leaves_plane, in_plane);
            act(&mut session, Intent::Cancel);
            assert!(!state(&session).leaves_plane);
            act(&mut session, Intent::Mirror(Mirror::Off));
            assert!(!face(&session).lies_in_plane(session.edit_options()));
        }
    }
}

#[test]
fn symmetric_selections_reach_their_reported_share() {
    let mut session = session();
    act(&mut session, Intent::Constraint(ConstraintKind::Soft { weight: 1.0 }));
    assert_eq!((session.edit_options().anchors, session.edit_options().mirror), (AnchorChoice::Oval, Mirror::On));
    let landmarks = MIDLINE.into_iter().map(Selection::Landmark);
    for selection in landmarks.chain([Region::Nose, Region::Lips, Region::Chin].map(Selection::Region)) {
        select(&mut session, selection);
        let before = positions(&session);
        act(&mut session, Intent::Offset(DVec3::Y));
        let (reach, moved) = (session.tick().share_reached, displacement_mm(&session, &before, selection.centre()).y);
        assert!((reach - moved).abs() < 1e-9, "{selection:?}: a share of {reach}, but it moves by {moved}");
        // Other handles of a region can move a vertex slightly beyond its offset.
        let is_alone = matches!(selection, Selection::Landmark(_));
        assert!(reach > 0.2 && (reach < 1.0 || !is_alone), "{selection:?}: {reach}");
        act(&mut session, Intent::Cancel);
    }
}

#[test]
fn a_selection_without_anchors_cannot_move_until_a_pin_is_set() {
    let mut session = session();
    act(&mut session, Intent::Anchors(AnchorChoice::PinsOnly));
    select(&mut session, Selection::Landmark(NOSE_TIP));
    let refusal = face(&session).refusal().cloned();
    assert!(matches!(refusal, Some(StudioError::Laplacian(LaplacianError::Unanchored { .. }))), "{refusal:?}");
    let before = positions(&session);
    act(&mut session, Intent::Offset(DVec3::Z * 5.0));
    assert_eq!((positions(&session), session.tick().is_editing), (before.clone(), false));
    act(&mut session, Intent::Commit);
    assert_eq!(state(&session).entry_count, 0);
    let chin = position_px(&session, CHIN);
    act(&mut session, Intent::PinUnder(chin));
    assert_eq!((face(&session).refusal().cloned(), state(&session).anchors), (None, vec![CHIN]));
    act(&mut session, Intent::Offset(DVec3::Z * 5.0));
    assert!((displacement_mm(&session, &before, NOSE_TIP).z - 5.0).abs() < 1e-9);
    assert!(displacement_mm(&session, &before, CHIN).length() < 1e-9);
}

#[test]
fn hovering_works_at_another_density_without_anchors() {
    let mut session = session();
    let middle = (glam::UVec2::from(SIZE_PX).as_dvec2()) / 2.0;
    for mode in [SelectionMode::Landmark, SelectionMode::Point] {
        act(&mut session, Intent::Mode(mode));
        act(&mut session, Intent::Anchors(AnchorChoice::PinsOnly));
        select(&mut session, Selection::Landmark(NOSE_TIP));
        for density in [2, 0, 1, 3, 0] {
            act(&mut session, Intent::Hover(Some(middle)));
            act(&mut session, Intent::Density(density));
            assert!(face(&session).refusal().cloned().is_some(), "no anchor is set");
            act(&mut session, Intent::Hover(Some(middle)));
            let under = session.hovered().vertex.unwrap();
            assert!((under as usize) < session.state().selectable, "{under} at {density}");
            check(&session).unwrap();
        }
    }
    select(&mut session, Selection::Landmark(CHIN));
    act(&mut session, Intent::Pin(Switch::On));
    select(&mut session, Selection::Landmark(NOSE_TIP));
    act(&mut session, Intent::Density(1));
    assert_eq!(face(&session).refusal().cloned(), None);
}

/// Distance of the selection from a position at rest, in metres.
fn away_m(session: &Session, position_m: DVec3) -> f64 {
    face(session).document().rest()[face(session).selected().unwrap() as usize].distance(position_m)
}

#[test]
fn point_mode_selects_landmarks_at_density_0_and_vertices_above() {
    let mut session = session();
    select_points(&mut session, 0);
    act(&mut session, Intent::SelectAt(61));
    assert_eq!(selection(&session), Some(Selection::Landmark(61)));
    act(&mut session, Intent::Density(2));
    act(&mut session, Intent::SelectAt(7_256));
    let beyond = |vertex, count| Err(SessionError::NoSuchVertex { vertex, count });
    assert_eq!(session.apply(Intent::SelectAt(7_257)), beyond(7_257, 7_257));
    act(&mut session, Intent::SelectAt(5_000));
    assert_eq!(selection(&session), Some(Selection::Point { level: 2, vertex: 5_000 }));
    let position_m = face(&session).document().rest()[5_000];
    act(&mut session, Intent::Density(3));
    assert_eq!(selection(&session), Some(Selection::Point { level: 3, vertex: 5_000 }));
    act(&mut session, Intent::Density(1));
    assert!(matches!(selection(&session), Some(Selection::Point { level: 1, .. })));
    assert!(away_m(&session, position_m) < 0.006);
    let point = selection(&session).unwrap();
    act(&mut session, Intent::Mode(SelectionMode::Landmark));
    assert!(matches!(selection(&session), Some(Selection::Landmark(_))));
    assert!(away_m(&session, position_m) < 0.012);
    assert_eq!(session.apply(Intent::SelectAt(468)), beyond(468, 468));
    for (mode, is_region) in [(SelectionMode::Point, false), (SelectionMode::Region, true)] {
        select(&mut session, point);
        act(&mut session, Intent::Mode(mode));
        assert_eq!(matches!(selection(&session), Some(Selection::Region(_))), is_region);
    }
    act(&mut session, Intent::Mode(SelectionMode::Point));
    select(&mut session, point);
    act(&mut session, Intent::Density(0));
    assert!(matches!(selection(&session), Some(Selection::Landmark(_))));
}

#[test]
fn point_edits_are_mirrored_and_wait_on_coarser_meshes() {
    let mut session = session();
    select_points(&mut session, 1);
    act(&mut session, Intent::SelectAt(1_500));
    let before = positions(&session);
    move_by(&mut session, DVec3::new(1.0, 0.0, 2.0));
    let partner = face(&session).document().partner(1, 1_500).unwrap();
    for (vertex, x) in [(1_500, 1.0), (partner, -1.0)] {
        assert!(displacement_mm(&session, &before, vertex).distance(DVec3::new(x, 0.0, 2.0)) < 1e-9);
    }
    let now = state(&session);
    assert_eq!(now.offset_mm[2], 2.0);
    assert!(face(&session).can_mirror() && face(&session).can_reset_selection());
    let target = EditTarget::Point { level: 1, vertex: 1_500 };
    let label = face(&session).document().history().entries()[0].label.clone();
    assert_eq!(label, "point-1500@1");
    assert_eq!((face(&session).rows()[0].target, now.name.unwrap().key.as_ref()), (target, "target.near"));
    assert!(face(&session).document().part_of(target).is_some());
    assert_eq!(face(&session).rows()[0].status, EntryStatus::InForce);
    act(&mut session, Intent::Density(0));
    assert_eq!(face(&session).rows()[0].status, EntryStatus::Waits { level: 1 });
    assert_eq!(face(&session).rows()[0].target, target);
    assert_eq!(positions(&session), face(&session).document().rest());
}

#[test]
fn selection_and_entry_have_the_same_target() {
    let mut session = session();
    select(&mut session, Selection::Landmark(NOSE_TIP));
    move_by(&mut session, DVec3::Z);
    let target = EditTarget::Landmark(NOSE_TIP);
    assert_eq!(
        (face(&session).selection().map(Selection::target), face(&session).rows()[0].target),
        (Some(target), target)
    );
    assert_eq!(face(&session).document().history().entries()[0].label, "nose-tip");
}

#[test]
fn points_of_the_tessellation_move_without_the_mirror() {
    let mut session = session();
    select_points(&mut session, 1);
    act(&mut session, Intent::SelectAt(1_500));
    let position_m = face(&session).document().rest()[1_500];
    act(&mut session, Intent::Triangulation(Triangulation::Tessellation));
    assert!(away_m(&session, position_m) < 0.002);
    assert!(!face(&session).can_mirror());
    act(&mut session, Intent::Offset(DVec3::Z));
    assert_eq!(face(&session).document().handles().len(), 1);
    select(&mut session, Selection::Landmark(61));
    assert!(face(&session).can_mirror());
    assert_eq!(face(&session).document().handles().len(), 2);
}
