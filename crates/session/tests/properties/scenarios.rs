//! Scenarios: sliders, selecting, moving, pointing and restoring work.

mod card;
mod expressing;
mod lenses;
mod marks;
mod photo;
mod photos;
mod pointing;
mod returning;
mod selecting;
mod sliding;

use glam::{DVec2, DVec3};
use rosto_session::{Changed, Intent, OpenFace, Selection, SelectionMode, Session, State};

const MM_PER_M: f64 = 1000.0;

/// Applies an intent that must be accepted.
fn act(session: &mut Session, intent: Intent) -> Changed {
    session.apply(intent).unwrap()
}

fn face(session: &Session) -> &OpenFace {
    session.face().unwrap()
}

fn state(session: &Session) -> State {
    session.state()
}

fn select(session: &mut Session, selection: Selection) {
    act(session, Intent::Select(Some(selection)));
}

/// Moves the selection, as one entry.
fn move_by(session: &mut Session, offset_mm: DVec3) {
    act(session, Intent::Offset(face(session).committed_mm() + offset_mm));
    act(session, Intent::Commit);
}

fn positions(session: &Session) -> Vec<DVec3> {
    face(session).document().positions().to_vec()
}

/// Displacement of a vertex, in mm.
fn displacement_mm(session: &Session, before: &[DVec3], vertex: u32) -> DVec3 {
    (face(session).document().positions()[vertex as usize] - before[vertex as usize]) * MM_PER_M
}

/// Position of a vertex on the canvas.
fn position_px(session: &Session, vertex: u32) -> DVec2 {
    let position_m = face(session).document().positions()[vertex as usize];
    session.stage().camera().project(position_m).unwrap()
}

/// Selects points on a mesh of the given density.
fn select_points(session: &mut Session, density: u32) {
    act(session, Intent::Mode(SelectionMode::Point));
    act(session, Intent::Density(density));
}
