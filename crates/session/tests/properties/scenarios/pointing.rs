use glam::{DVec2, DVec3};
use rosto_face::Region;
use rosto_session::{Changed, Intent, Motion, Pace, SLIDER_MM, Selection, SelectionMode, Session};
use rosto_stage::{Pointer, ShadingMode, Visibility};
use rosto_studio::FaceSlider;

use super::{MM_PER_M, act, displacement_mm, face, move_by, position_px, positions, select, state};
use crate::faces::{self, SIZE_PX, detected, found, open};
use crate::invariants::{check, shape};

const MOUTH_CORNER: u32 = 61;
const NOSE_TIP: u32 = 1;
const CHIN: u32 = 152;
const BY_PX: DVec2 = DVec2::new(30.0, -20.0);

/// A session that shows the face from the front, and without resistance to drags.
pub fn session() -> Session {
    let mut session = faces::session();
    act(&mut session, Intent::Backdrop(Visibility::Hidden));
    session.stage_mut().advance(0.0);
    act(&mut session, Intent::Expert(true));
    session
}

fn drag(session: &mut Session, to_px: DVec2) -> Changed {
    act(session, Intent::Drag(to_px, Pace::Usual))
}

#[test]
fn another_mode_forgets_a_hovered_point_that_it_cannot_select() {
    let mut session = session();
    act(&mut session, Intent::Mode(SelectionMode::Point));
    act(&mut session, Intent::Density(2));
    let point_px = position_px(&session, 5_000);
    act(&mut session, Intent::Hover(Some(point_px)));
    assert!(session.hovered().vertex.unwrap() >= 468, "{:?}", session.hovered());
    let applied = session.answer(Intent::Mode(SelectionMode::Landmark)).unwrap();
    assert_eq!(applied.hovered, None);
}

#[test]
fn a_drag_follows_the_pointer_and_is_one_entry() {
    let mut session = session();
    let rest = shape(&session);
    for (count, vertex) in [(1, MOUTH_CORNER), (2, 205), (3, 334)] {
        let before = shape(&session);
        let from = position_px(&session, vertex);
        assert_eq!(act(&mut session, Intent::Hover(Some(from))), Changed::View);
        assert_eq!(act(&mut session, Intent::Hover(Some(from))), Changed::Nothing, "the pointer rests");
        assert_eq!(session.hovered().vertex, Some(vertex));
        act(&mut session, Intent::Press(from, Pointer::Fine));
        assert!(session.has_grabbed() && !session.is_dragging());
        assert_ne!(face(&session).selected(), Some(vertex), "a press without a drag selects nothing");
        assert_eq!(drag(&mut session, from + BY_PX * 0.5), Changed::Document);
        assert_eq!(drag(&mut session, from + BY_PX), Changed::Tick);
        assert!(session.is_dragging() && session.tick().is_editing);
        assert_eq!(face(&session).selection(), Some(Selection::Landmark(vertex)));
        let now = position_px(&session, vertex);
        assert!(now.distance(from + BY_PX) < 1e-6, "{vertex} is at {now}");
        assert_eq!(shape(&session), before, "nothing is committed before the release");
        assert_eq!(act(&mut session, Intent::Release), Changed::Document);
        assert!(!session.has_grabbed() && !session.tick().is_editing);
        assert_eq!(state(&session).entry_count, count);
        assert!(position_px(&session, vertex).distance(from + BY_PX) < 1e-6);
        assert_eq!(drag(&mut session, from), Changed::Nothing);
        check(&session).unwrap();
    }
    for _ in 0..3 {
        act(&mut session, Intent::Undo);
    }
    assert_eq!(shape(&session), rest);
}

#[test]
fn a_cancelled_drag_ignores_the_rest_of_the_press() {
    let mut session = session();
    let (before, from) = (positions(&session), position_px(&session, MOUTH_CORNER));
    act(&mut session, Intent::Press(from, Pointer::Fine));
    drag(&mut session, from + BY_PX);
    assert_ne!(positions(&session), before);
    assert_eq!(act(&mut session, Intent::Cancel), Changed::Document);
    assert_eq!(positions(&session), before);
    assert!(session.has_grabbed() && !session.is_dragging(), "the rest of the press does not orbit the view");
    assert_eq!(drag(&mut session, from + 2.0 * BY_PX), Changed::Nothing);
    assert_eq!(act(&mut session, Intent::Release), Changed::Nothing);
    assert_eq!((positions(&session), state(&session).entry_count), (before, 0));
    assert!(!session.has_grabbed());
    act(&mut session, Intent::Press(from, Pointer::Fine));
    drag(&mut session, from + BY_PX);
    act(&mut session, Intent::Release);
    assert_eq!(state(&session).entry_count, 1);
}

#[test]
fn touch_grabs_the_selection_from_farther_away_than_a_mouse() {
    for (pointer, taken) in [(Pointer::Fine, 334), (Pointer::Coarse, MOUTH_CORNER)] {
        let mut session = session();
        select(&mut session, Selection::Landmark(MOUTH_CORNER));
        let ring = position_px(&session, MOUTH_CORNER);
        // Away from the gizmo's axes, which point right and up.
        act(&mut session, Intent::Press(ring + DVec2::new(-18.0, 18.0), pointer));
        drag(&mut session, ring + BY_PX);
        let is_selected = face(&session).selected() == Some(MOUTH_CORNER);
        assert_eq!(is_selected, taken == MOUTH_CORNER, "{:?}", face(&session).selected());
        act(&mut session, Intent::Release);
        let far = position_px(&session, 334);
        act(&mut session, Intent::Press(far, pointer));
        drag(&mut session, far + BY_PX);
        assert_eq!(face(&session).selected(), Some(334), "an unselected point can be grabbed");
    }
}

/// Positions of a grid over the canvas.
fn grid_px() -> impl Iterator<Item = DVec2> {
    let size_px = glam::UVec2::from(SIZE_PX).as_dvec2();
    (0..23).flat_map(move |row| {
        (0..23).map(move |column| size_px * DVec2::new(f64::from(column) + 0.37, f64::from(row) + 0.41) / 23.0)
    })
}

/// Whether a drag moves the highlighted selection, as one entry; `None` if nothing is highlighted.
fn is_grabbed(session: &mut Session, position_px: DVec2, pointer: Pointer) -> Option<bool> {
    act(session, Intent::Hover(Some(position_px)));
    let hovered = session.hovered().vertex;
    act(session, Intent::Press(position_px, pointer));
    let lit = session.hovered().vertex;
    assert!(pointer == Pointer::Coarse || lit == hovered);
    assert_eq!(session.has_grabbed(), lit.is_some(), "{position_px}");
    let vertex = lit?;
    drag(session, position_px + DVec2::new(14.0, 11.0));
    let moved = face(session).selection().map(Selection::handles).unwrap_or_default();
    act(session, Intent::Release);
    let is_one_entry = state(session).entry_count == 1;
    act(session, Intent::Undo);
    Some(is_one_entry && moved.contains(&vertex))
}

#[test]
fn a_click_selects_the_highlighted_point() {
    for (mode, density) in [(SelectionMode::Landmark, 0), (SelectionMode::Landmark, 1), (SelectionMode::Point, 1)] {
        let mut session = session();
        act(&mut session, Intent::Density(density));
        act(&mut session, Intent::Mode(mode));
        let mut clicks = 0;
        for position_px in grid_px() {
            act(&mut session, Intent::Hover(Some(position_px)));
            let (hovered, before) = (session.hovered(), face(&session).selected());
            act(&mut session, Intent::SelectUnder(position_px));
            let expected = if hovered.axis.is_some() { before } else { hovered.vertex };
            assert_eq!(face(&session).selected(), expected, "{mode:?} {position_px}");
            clicks += usize::from(hovered.vertex.is_some());
        }
        assert!(clicks > 50, "{clicks} clicks on the face");
    }
}

#[test]
fn a_press_grabs_the_highlighted_vertex_in_each_mode() {
    for (mode, density) in [
        (SelectionMode::Landmark, 0),
        (SelectionMode::Landmark, 1),
        (SelectionMode::Region, 0),
        (SelectionMode::Point, 1),
    ] {
        for pointer in [Pointer::Fine, Pointer::Coarse] {
            let mut session = session();
            act(&mut session, Intent::Density(density));
            act(&mut session, Intent::Mode(mode));
            let mut lit_count = 0;
            for position_px in grid_px() {
                let Some(is_grabbed) = is_grabbed(&mut session, position_px, pointer) else { continue };
                assert!(is_grabbed, "{mode:?} at {density}, {pointer:?}, {position_px}");
                lit_count += 1;
            }
            assert!(lit_count > 80, "{lit_count} of {}", grid_px().count());
        }
    }
}

#[test]
fn a_landmark_of_a_denser_mesh_follows_the_pointer() {
    for density in 1..=3 {
        let mut session = session();
        act(&mut session, Intent::Density(density));
        for vertex in [NOSE_TIP, MOUTH_CORNER, 334] {
            let from = position_px(&session, vertex);
            act(&mut session, Intent::Press(from, Pointer::Fine));
            drag(&mut session, from + BY_PX);
            drag(&mut session, from + BY_PX * 1.5);
            let off_px = position_px(&session, vertex).distance(from + BY_PX * 1.5);
            assert!(off_px < 1.0, "{vertex} at {density} is {off_px} px away");
            act(&mut session, Intent::Cancel);
            act(&mut session, Intent::Release);
        }
    }
}

#[test]
fn a_midline_point_can_be_dragged_sideways() {
    let mut session = session();
    let from = position_px(&session, NOSE_TIP);
    act(&mut session, Intent::Press(from, Pointer::Fine));
    let before = positions(&session);
    drag(&mut session, from + DVec2::new(4.0, -40.0));
    assert!(!state(&session).leaves_plane, "small sideways movements are ignored");
    assert!(displacement_mm(&session, &before, NOSE_TIP).x.abs() < 1e-9);
    assert_eq!(drag(&mut session, from + DVec2::new(40.0, -3.0)), Changed::Document);
    assert!(state(&session).leaves_plane);
    assert!(position_px(&session, NOSE_TIP).distance(from + DVec2::new(40.0, -3.0)) < 1e-6);
    assert_eq!(drag(&mut session, from + DVec2::new(2.0, 30.0)), Changed::Document);
    assert!(!state(&session).leaves_plane && displacement_mm(&session, &before, NOSE_TIP).x.abs() < 1e-9);
    drag(&mut session, from + DVec2::new(40.0, 0.0));
    act(&mut session, Intent::Release);
    assert_eq!(state(&session).entry_count, 1);
    assert!(displacement_mm(&session, &before, NOSE_TIP).x > 1.0);
    assert!(
        !state(&session).leaves_plane && face(&session).lies_in_plane(session.edit_options()),
        "the next edit starts in the plane"
    );
    act(&mut session, Intent::Undo);
    assert_eq!(positions(&session), before);
}

#[test]
fn an_edit_that_moves_nothing_adds_no_entry() {
    let mut session = session();
    select(&mut session, Selection::Landmark(MOUTH_CORNER));
    for offset_mm in [DVec3::ZERO, DVec3::splat(1e-8)] {
        act(&mut session, Intent::Offset(offset_mm));
        act(&mut session, Intent::Commit);
        assert_eq!(state(&session).entry_count, 0);
    }
    act(&mut session, Intent::Symmetrise(1.0));
    for share in [1.0, 0.5, 0.0] {
        act(&mut session, Intent::Symmetrise(share));
        assert_eq!(state(&session).entry_count, 1, "both sides are symmetric already");
    }
}

#[test]
fn a_drag_stops_at_the_sliders_range_and_reports_it() {
    let mut session = session();
    let from = position_px(&session, MOUTH_CORNER);
    act(&mut session, Intent::Press(from, Pointer::Fine));
    drag(&mut session, from + DVec2::new(0.0, 60.0));
    assert!(!session.tick().is_at_end);
    drag(&mut session, from + DVec2::new(0.0, 4_000.0));
    assert!(session.tick().is_at_end);
    let [_, y_mm, _] = session.tick().offset_mm.unwrap();
    assert!((y_mm - SLIDER_MM.min).abs() < 1e-9, "{y_mm}");
    act(&mut session, Intent::Release);
    assert!(!session.tick().is_at_end);
    let from = position_px(&session, MOUTH_CORNER);
    act(&mut session, Intent::Press(from, Pointer::Fine));
    drag(&mut session, from + DVec2::new(0.0, 50.0));
    let [_, y_mm, _] = session.tick().offset_mm.unwrap();
    assert!(
        session.tick().is_at_end && (y_mm - SLIDER_MM.min).abs() < 1e-9,
        "the range applies to the sum of both edits"
    );
    act(&mut session, Intent::Release);
    assert_eq!(state(&session).entry_count, 1);
}

#[test]
fn moving_the_nose_leaves_eyelids_and_mouth_in_place() {
    let lids = [Region::RightUpperEyelid, Region::LeftUpperEyelid, Region::RightLowerEyelid, Region::LeftLowerEyelid];
    let inner_lips = [13, 14, 78, 308, 82, 312, 87, 317];
    let far: Vec<u32> = lids.iter().flat_map(|lid| lid.vertices()).chain(inner_lips).collect();
    for selection in
        [Selection::Landmark(NOSE_TIP), Selection::Region(Region::NoseTip), Selection::Region(Region::Nose)]
    {
        for offset_mm in [DVec3::Z * 12.0, DVec3::X * 12.0, DVec3::Y * 12.0] {
            let mut session = session();
            select(&mut session, selection);
            let before = positions(&session);
            act(&mut session, Intent::Offset(offset_mm));
            assert!(displacement_mm(&session, &before, NOSE_TIP).length() > 11.9);
            for &vertex in &far {
                let displacement_mm = displacement_mm(&session, &before, vertex);
                assert!(
                    displacement_mm.length() < 0.05,
                    "{selection:?} by {offset_mm} moves {vertex} by {displacement_mm}"
                );
            }
        }
    }
}

#[test]
fn a_point_of_the_outline_moves_its_neighbours_and_not_the_rest() {
    const CHIN_TIP: u32 = 152;
    let (beside, far) = ([148, 377], [10, 234, 454]);
    let mut session = session();
    select(&mut session, Selection::Landmark(CHIN_TIP));
    let before = positions(&session);
    act(&mut session, Intent::Offset(DVec3::NEG_Y * 8.0));
    let displacement_mm = |vertex: u32| displacement_mm(&session, &before, vertex).length();
    assert!((displacement_mm(CHIN_TIP) - 8.0).abs() < 1e-9);
    for vertex in beside {
        assert!((1.5..8.0).contains(&displacement_mm(vertex)), "{vertex} moves by {} mm", displacement_mm(vertex));
    }
    assert!(far.iter().all(|&vertex| displacement_mm(vertex) < 1e-9));
    act(&mut session, Intent::Cancel);
    select(&mut session, Selection::Landmark(199));
    assert!(
        face(&session).document().anchors().contains(&CHIN_TIP),
        "the outline is anchored while another point moves"
    );
}

#[test]
fn edits_do_not_change_the_framing() {
    let mut session = session();
    let camera = session.stage().camera().clone();
    select(&mut session, Selection::Landmark(CHIN));
    move_by(&mut session, DVec3::NEG_Y * 40.0);
    for slider in FaceSlider::ALL {
        act(&mut session, Intent::Slide(slider, slider.range_m() * MM_PER_M));
        act(&mut session, Intent::Commit);
    }
    act(&mut session, Intent::Undo);
    assert_eq!(session.stage().camera(), &camera);
}

#[test]
fn a_drag_moves_the_feature_with_resistance_and_its_slider_follows() {
    let reached_mm = |is_expert| {
        let mut session = Session::new(3);
        act(&mut session, Intent::Motion(Motion::Reduced));
        act(&mut session, Intent::Resize(SIZE_PX, 1.0));
        open(&mut session, found(detected()));
        act(&mut session, Intent::Expert(is_expert));
        session.stage_mut().advance(0.0);
        let before = positions(&session);
        let chin_px = position_px(&session, CHIN);
        act(&mut session, Intent::Press(chin_px, Pointer::Fine));
        act(&mut session, Intent::Drag(chin_px + DVec2::new(0.0, 200.0), Pace::Usual));
        let during_mm = face(&session).slider_mm(FaceSlider::ChinLength);
        act(&mut session, Intent::Release);
        assert_eq!(face(&session).selection(), Some(Selection::Region(Region::Chin)));
        assert_eq!(session.panel().iter().filter(|section| section.id == "section.face").count(), 1);
        let reached_mm = displacement_mm(&session, &before, CHIN).length();
        let slider_mm = face(&session).slider_mm(FaceSlider::ChinLength);
        assert!((slider_mm - reached_mm).abs() < 0.1 * reached_mm, "{slider_mm} of {reached_mm} mm");
        assert!((slider_mm - during_mm).abs() < 1e-6, "{slider_mm} after {during_mm} mm");
        act(&mut session, Intent::Slide(FaceSlider::ChinLength, 0.0));
        act(&mut session, Intent::Commit);
        assert!(face(&session).slider_mm(FaceSlider::ChinLength).abs() < 1e-9);
        reached_mm
    };
    let (usual_mm, expert_mm) = (reached_mm(false), reached_mm(true));
    let spread_mm = Region::Chin.spread_mm();
    assert!(usual_mm > spread_mm && usual_mm < 1.5 * spread_mm, "{usual_mm} mm");
    assert!(expert_mm > 2.0 * spread_mm, "{expert_mm} mm");
}

#[test]
fn changes_are_reported_at_their_extent() {
    let mut session = Session::new(1);
    act(&mut session, Intent::Motion(Motion::Reduced));
    for nothing in [Intent::Offset(DVec3::Z), Intent::Commit, Intent::Undo, Intent::Release] {
        assert_eq!(act(&mut session, nothing), Changed::Nothing);
    }
    for (intent, changed) in [
        (Intent::Open(Box::new(found(detected()))), Changed::Mesh),
        (Intent::Select(Some(Selection::Landmark(MOUTH_CORNER))), Changed::Document),
        (Intent::Offset(DVec3::Z), Changed::Tick),
        (Intent::Commit, Changed::Document),
        (Intent::Slide(FaceSlider::NoseWidth, 1.0), Changed::Document),
        (Intent::Slide(FaceSlider::NoseWidth, 2.0), Changed::Tick),
        (Intent::Orbit(BY_PX), Changed::View),
        (Intent::Hover(Some(BY_PX)), Changed::View),
        (Intent::Shading(ShadingMode::Distortion), Changed::Tick),
        (Intent::Undo, Changed::Document),
        (Intent::Redo, Changed::Document),
        (Intent::Density(1), Changed::Mesh),
        (Intent::Triangulation(rosto_face::Triangulation::Tessellation), Changed::Mesh),
        (Intent::Drag(BY_PX, Pace::Usual), Changed::Nothing),
        (Intent::Close, Changed::Mesh),
    ] {
        assert_eq!(act(&mut session, intent.clone()), changed, "{intent:?}");
    }
    let order = [Changed::Nothing, Changed::View, Changed::Tick, Changed::Document, Changed::Mesh];
    assert!(order.is_sorted());
}
