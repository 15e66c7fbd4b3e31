use super::*;
use rosto_face::{FaceInput, Photo, Region, canonical_positions_m, mirror_of};
use rosto_studio::Switch;

fn session() -> Session {
    let landmarks: Vec<[f32; 3]> = canonical_positions_m()
        .iter()
        .map(|p| [0.5 + 3.0 * p.x, 0.5 - 3.0 * p.y, -3.0 * p.z].map(|coordinate| coordinate as f32))
        .collect();
    let picture = Photo::from_rgb(1, 1, vec![0; 3]).unwrap();
    let input = FaceInput { landmarks: &landmarks, width: 64, height: 64, colours: &[[0; 3]; LANDMARK_COUNT], picture };
    Session::new(FaceModel::new(input, Triangulation::Canonical).unwrap()).unwrap()
}

fn sculpting() -> Choices {
    let sculpt = Choices { hold: Hold::Exact, anchors: AnchorChoice::Oval, ..Choices::default() };
    Choices { mirror: Mirror::On, ..sculpt }
}

fn drag(session: &mut Session, slider: FaceSlider, to_mm: f64) {
    session.take_slider(slider, &sculpting()).unwrap();
    for tick in 1..=8 {
        session.slide(slider, to_mm * f64::from(tick) / 8.0).unwrap();
    }
    session.commit(&sculpting()).unwrap();
}

fn stands_at(session: &Session, slider: FaceSlider) -> f64 {
    let place = FaceSlider::ALL.iter().position(|one| *one == slider).unwrap();
    session.state().sliders_mm[place]
}

#[test]
fn a_slider_stands_where_its_entries_in_force_add_up_to() {
    let (mut session, choices) = (session(), sculpting());
    let slider = FaceSlider::NoseWidth;
    drag(&mut session, slider, 2.0);
    drag(&mut session, FaceSlider::ChinLength, -3.0);
    drag(&mut session, slider, 1.5);
    assert_eq!(session.state().entries.len(), 3);
    assert!((stands_at(&session, slider) - 1.5).abs() < 1e-9);
    session.change_history(&choices, |document| document.switch(0, Switch::Off)).unwrap();
    assert!((stands_at(&session, slider) + 0.5).abs() < 1e-9);
    session.change_history(&choices, Document::undo).unwrap();
    session.change_history(&choices, Document::undo).unwrap();
    assert!((stands_at(&session, slider) - 2.0).abs() < 1e-9);
    session.change_history(&choices, Document::redo).unwrap();
    assert!((stands_at(&session, slider) - 1.5).abs() < 1e-9);
    assert!((stands_at(&session, FaceSlider::ChinLength) + 3.0).abs() < 1e-9);
}

#[test]
fn a_drag_of_a_slider_is_the_command_of_its_amount() {
    let mut session = session();
    drag(&mut session, FaceSlider::JawWidth, 4.0);
    let dragged = session.document.positions().to_vec();
    let entries = session.document.history().entries();
    assert_eq!((entries.len(), entries[0].label.as_str()), (1, "jaw width"));
    let mut applied = Document::new(Rest::of_face(&session.face)).unwrap();
    applied.apply("", FaceSlider::JawWidth.command(0.004)).unwrap();
    assert!(dragged.iter().zip(applied.positions()).all(|(a, b)| a.distance(*b) < 1e-15));
}

#[test]
fn a_slider_put_back_or_let_go_of_leaves_no_entry() {
    let (mut session, choices) = (session(), sculpting());
    let slider = FaceSlider::LipFullness;
    let rest = session.document.positions().to_vec();
    session.take_slider(slider, &choices).unwrap();
    session.slide(slider, 2.0).unwrap();
    assert!(session.state().editing && (stands_at(&session, slider) - 2.0).abs() < 1e-12);
    session.cancel(&choices).unwrap();
    assert_eq!((session.document.positions(), stands_at(&session, slider)), (&rest[..], 0.0));
    session.take_slider(slider, &choices).unwrap();
    session.slide(slider, 2.0).unwrap();
    session.slide(slider, 0.0).unwrap();
    session.commit(&choices).unwrap();
    assert!(session.state().entries.is_empty());
}

#[test]
fn the_selection_is_in_hand_again_after_a_slider() {
    let (mut session, mut choices) = (session(), sculpting());
    session.select(Some(Selection::Landmark(61)), &mut choices, 5).unwrap();
    let (grip, follow) = (session.document.grip().cloned(), session.document.follow().cloned().unwrap());
    session.preview(DVec3::new(0.0, 1.0, 0.0)).unwrap();
    drag(&mut session, FaceSlider::EyeSize, 1.0);
    let subjects: Vec<Subject> = session.state().entries.iter().map(|entry| entry.subject).collect();
    assert_eq!(subjects, [Subject::Landmark(61), Subject::Slider(FaceSlider::EyeSize)]);
    assert_eq!(session.document.grip().cloned(), grip);
    let fields = session.follow_fields()[0].unwrap().iter().zip(follow.direct);
    assert!(fields.into_iter().all(|(now, before)| (now - before).abs() < 1e-12));
    assert_eq!(session.state().kept_y_mm, 1.0);
}

#[test]
fn a_region_moves_as_one_on_both_sides() {
    let (mut session, mut choices) = (session(), sculpting());
    let brow = Selection::Region(Region::LeftBrow);
    session.select(Some(brow), &mut choices, 5).unwrap();
    let before = session.document.positions().to_vec();
    let offset_mm = DVec3::new(1.0, 2.0, 0.5);
    session.preview(offset_mm).unwrap();
    session.commit(&choices).unwrap();
    let way_mm = |vertex: u32| (session.document.positions()[vertex as usize] - before[vertex as usize]) * MM_PER_M;
    for vertex in brow.handles() {
        assert!(way_mm(vertex).distance(offset_mm) < 1e-9);
        let mirrored = DVec3::new(-offset_mm.x, offset_mm.y, offset_mm.z);
        assert!(way_mm(mirror_of(vertex)).distance(mirrored) < 1e-9);
    }
    let state = session.state();
    assert_eq!(state.selected_region.as_deref(), Some("left-brow"));
    assert_eq!((state.entries.len(), state.entries[0].label.as_str()), (1, "left brow"));
    assert!((DVec3::new(state.kept_x_mm, state.kept_y_mm, state.kept_z_mm) - offset_mm).length() < 1e-9);
}

#[test]
fn asking_again_takes_the_next_larger_region() {
    let (mut session, mut choices) = (session(), sculpting());
    let mut seen = Vec::new();
    for _ in 0..4 {
        let region = session.at(1, Hand::Region);
        session.select(Some(region), &mut choices, 0).unwrap();
        seen.push(region);
    }
    let [tip, nose] = [Region::NoseTip, Region::Nose].map(Selection::Region);
    assert_eq!(seen, [tip, nose, tip, nose]);
}

#[test]
fn what_is_in_hand_follows_the_choice_between_landmark_and_region() {
    let (mut session, mut choices) = (session(), sculpting());
    assert_eq!(session.taken_by(Hand::Region), None);
    session.select(Some(Selection::Landmark(4)), &mut choices, 0).unwrap();
    let region = session.taken_by(Hand::Region).unwrap();
    assert_eq!(region, Selection::Region(Region::containing(4)[0]));
    session.select(Some(region), &mut choices, 0).unwrap();
    assert!(session.holds(4) && !session.holds(152));
    assert_eq!(session.taken_by(Hand::Region), Some(region));
    assert_eq!(session.taken_by(Hand::Landmark), Some(Selection::Landmark(region.middle())));
}

#[test]
fn only_what_has_edits_in_force_can_be_reset() {
    let (mut session, mut choices) = (session(), sculpting());
    let [nose, lips] = [Region::Nose, Region::Lips].map(Selection::Region);
    session.select(Some(nose), &mut choices, 0).unwrap();
    session.preview(DVec3::new(0.0, 0.0, 2.0)).unwrap();
    session.commit(&choices).unwrap();
    assert!(session.state().can_reset_selection);
    session.select(Some(lips), &mut choices, 0).unwrap();
    assert!(!session.state().can_reset_selection);
    session.select(Some(nose), &mut choices, 0).unwrap();
    session.change_history(&choices, |document| document.switch_off(nose.subject())).unwrap();
    assert!(!session.state().can_reset_selection);
}

#[test]
fn what_is_its_own_mirror_image_moves_in_the_plane_while_the_mirror_is_on() {
    let (mut session, mut choices) = (session(), sculpting());
    let one_sided = [Selection::Landmark(61), Selection::Region(Region::LeftBrow)];
    let whole = [Selection::Landmark(1), Selection::Region(Region::Nose)];
    for (selections, in_plane) in [(one_sided, false), (whole, true)] {
        for selection in selections {
            choices.mirror = Mirror::On;
            session.select(Some(selection), &mut choices, 0).unwrap();
            assert_eq!(session.state().selected_in_plane, in_plane, "{selection:?}");
            session.preview(DVec3::X).unwrap();
            let middle = selection.middle() as usize;
            let way = session.document.positions()[middle] - session.document.committed()[middle];
            assert_eq!(way.x.abs() < 1e-12, in_plane, "{selection:?} moves by {way}");
            choices.mirror = Mirror::Off;
            session.hold(&choices).unwrap();
            assert!(!session.state().selected_in_plane);
        }
    }
}

fn vertex_at_rest(session: &Session, place_m: DVec3) -> f64 {
    session.selected().map_or(f64::NAN, |vertex| session.document.rest()[vertex as usize].distance(place_m))
}

#[test]
fn any_point_is_a_landmark_at_468_points_and_one_of_the_dense_mesh_above() {
    let (mut session, mut choices) = (session(), sculpting());
    assert_eq!(session.at(61, Hand::Point), Selection::Landmark(61));
    session.set_density(2, Hand::Point, &choices).unwrap();
    assert_eq!(session.at(5_000, Hand::Point), Selection::Point { level: 2, vertex: 5_000 });
    assert!(session.known(7_256, Hand::Point).is_ok() && session.known(7_257, Hand::Point).is_err());
    assert!(session.known(468, Hand::Landmark).is_err());
    session.select(Some(session.at(5_000, Hand::Point)), &mut choices, 0).unwrap();
    let place_m = session.document.rest()[5_000];
    assert_eq!(session.selected(), Some(5_000));
    session.set_density(3, Hand::Point, &choices).unwrap();
    assert_eq!(session.selection(), Some(Selection::Point { level: 3, vertex: 5_000 }));
    session.set_density(1, Hand::Point, &choices).unwrap();
    assert!(matches!(session.selection(), Some(Selection::Point { level: 1, .. })));
    assert!(vertex_at_rest(&session, place_m) < 0.006);
    let Some(Selection::Landmark(landmark)) = session.taken_by(Hand::Landmark) else { panic!("a landmark") };
    assert!(session.document.rest()[landmark as usize].distance(place_m) < 0.012);
    assert!(matches!(session.taken_by(Hand::Region), Some(Selection::Region(_))));
    session.set_density(0, Hand::Point, &choices).unwrap();
    assert!(matches!(session.selection(), Some(Selection::Landmark(_))));
}

#[test]
fn a_point_moves_with_its_mirror_image_and_waits_under_its_name_while_the_mesh_is_coarser() {
    let (mut session, mut choices) = (session(), sculpting());
    session.set_density(1, Hand::Point, &choices).unwrap();
    let point = session.at(1_500, Hand::Point);
    session.select(Some(point), &mut choices, 0).unwrap();
    let before = session.document.positions().to_vec();
    session.preview(DVec3::new(1.0, 0.0, 2.0)).unwrap();
    session.commit(&choices).unwrap();
    let partner = session.document.partner(1, 1_500).unwrap();
    for (vertex, x) in [(1_500, 1.0), (partner, -1.0)] {
        let way_mm = (session.document.positions()[vertex as usize] - before[vertex as usize]) * MM_PER_M;
        assert!(way_mm.distance(DVec3::new(x, 0.0, 2.0)) < 1e-9);
    }
    let state = session.state();
    assert_eq!((state.kept_z_mm, state.can_mirror, state.can_reset_selection), (2.0, true, true));
    assert!(state.entries[0].label.starts_with("point 1,500 near the "), "{}", state.entries[0].label);
    assert_eq!(state.entries[0].waits_for_density, None);
    session.set_density(0, Hand::Point, &choices).unwrap();
    let state = session.state();
    assert_eq!(state.entries[0].waits_for_density, Some(1));
    assert!(session.label(state.entries[0].subject, Language::Portuguese).starts_with("ponto 1.500 perto d"));
    assert_eq!(session.document.positions(), session.document.rest());
}

#[test]
fn points_have_no_mirror_image_with_eyes_and_mouth_open_and_are_moved_alone() {
    let (mut session, mut choices) = (session(), sculpting());
    session.set_density(1, Hand::Point, &choices).unwrap();
    session.select(Some(session.at(1_500, Hand::Point)), &mut choices, 0).unwrap();
    let place_m = session.document.rest()[1_500];
    session.set_triangulation(Triangulation::Tessellation, &choices).unwrap();
    assert!(vertex_at_rest(&session, place_m) < 0.002);
    assert!(!session.state().can_mirror);
    session.preview(DVec3::Z).unwrap();
    assert_eq!(session.document.handles().len(), 1);
    session.select(Some(Selection::Landmark(61)), &mut choices, 0).unwrap();
    assert!(session.state().can_mirror);
    assert_eq!(session.document.handles().len(), 2);
}
