//! What careful visitors do, as theorems: sliders, selecting, moving, pointing, and coming back.

mod expressing;
mod lenses;
mod photo;
mod photos;
mod pointing;
mod returning;
mod selecting;
mod sliding;

use glam::{DVec2, DVec3};
use rosto_session::{Changed, FaceState, Intent, OpenFace, Selection, SelectionMode, Session};

const MM_PER_M: f64 = 1000.0;

/// Does what is not refused.
fn act(session: &mut Session, intent: Intent) -> Changed {
    session.apply(intent).unwrap()
}

fn face(session: &Session) -> &OpenFace {
    session.face().unwrap()
}

fn state(session: &Session) -> FaceState {
    session.state().face.unwrap()
}

fn select(session: &mut Session, selection: Selection) {
    act(session, Intent::Select(Some(selection)));
}

/// Moves what is selected, as one entry.
fn move_by(session: &mut Session, offset_mm: DVec3) {
    act(session, Intent::Preview(offset_mm));
    act(session, Intent::Commit);
}

fn positions(session: &Session) -> Vec<DVec3> {
    face(session).document().positions().to_vec()
}

/// How far a vertex is from where it was, in mm.
fn way_mm(session: &Session, before: &[DVec3], vertex: u32) -> DVec3 {
    (face(session).document().positions()[vertex as usize] - before[vertex as usize]) * MM_PER_M
}

/// Where a vertex appears on the canvas.
fn place_px(session: &Session, vertex: u32) -> DVec2 {
    let position_m = face(session).document().positions()[vertex as usize];
    session.stage().camera().project(position_m).unwrap()
}

/// Points are selected on a mesh subdivided so many times.
fn select_points(session: &mut Session, density: u32) {
    act(session, Intent::Mode(SelectionMode::Point));
    act(session, Intent::Density(density));
}
