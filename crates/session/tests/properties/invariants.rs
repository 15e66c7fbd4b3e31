//! Invariants of a session.

use rosto_session::{OpenFace, Selection, Session, State, Tick};
use rosto_studio::{CoordinateFrame, Document, EntryStatus, History, Mirror, Rest, project};

use crate::faces::bits;

/// The observable state that a refused intent leaves unchanged.
#[derive(Debug, Clone, PartialEq)]
pub struct Seen {
    state: State,
    tick: Tick,
    positions: Vec<[u64; 3]>,
    history: Option<History>,
}

pub fn seen(session: &Session) -> Seen {
    Seen {
        state: session.state(),
        tick: session.tick(),
        positions: session.face().map(|face| bits(face.document().positions())).unwrap_or_default(),
        history: session.face().map(|face| face.document().history().clone()),
    }
}

/// The committed shape and its history.
pub fn shape(session: &Session) -> Option<(Vec<[u64; 3]>, String)> {
    session.face().map(|face| (bits(face.document().committed()), face.history_json()))
}

/// Cheap checks, for use after each action.
pub fn check(session: &Session) -> Result<(), String> {
    let Some(face) = session.face() else {
        return ensure(session.stage().gizmo().is_none(), || "a gizmo without a face".to_owned());
    };
    let document = face.document();
    let count = document.topology().vertex_count();
    for (what, positions) in
        [("now", document.positions()), ("committed", document.committed()), ("rest", document.rest())]
    {
        ensure(positions.len() == count, || format!("{} positions {what} for {count} vertices", positions.len()))?;
        ensure(positions.iter().all(|p| p.is_finite()), || format!("a position {what} is not finite"))?;
    }
    let selected_level = face.selection().map_or(0, Selection::level);
    ensure(selected_level <= document.density(), || format!("{:?} is not on this mesh", face.selection()))?;
    ensure(face.selected().is_none_or(|vertex| (vertex as usize) < count), || {
        "the selected vertex does not exist".to_owned()
    })?;
    ensure(session.stage().gizmo().is_none_or(|vertex| (vertex as usize) < count), || {
        "the gizmo's vertex does not exist".to_owned()
    })?;
    let selectable = face.selectable_count(session.mode());
    ensure(session.hovered().vertex.is_none_or(|vertex| (vertex as usize) < selectable), || {
        "the hovered vertex cannot be selected".to_owned()
    })?;
    let mut pins = face.pins().to_vec();
    pins.sort_unstable();
    pins.dedup();
    ensure(pins.len() == face.pins().len(), || "a vertex is pinned twice".to_owned())?;
    let is_held = document.spec().is_some() || face.expression().is_some();
    ensure(!face.is_moving() || is_held, || "an edit without preparation".to_owned())?;
    ensure(face.rows().len() == document.history().entries().len(), || "rows and entries differ in number".to_owned())?;
    mirrored(face)
}

/// Expensive checks: rereads and replays the history.
pub fn check_thoroughly(session: &Session) -> Result<(), String> {
    let Some(face) = session.face() else { return Ok(()) };
    let json = face.history_json();
    let entries = project::from_json(&json).map_err(|error| error.to_string())?;
    ensure(project::to_json(&entries) == json, || "the history changes when it is read back".to_owned())?;
    if face.rows().iter().any(|row| matches!(row.status, EntryStatus::Impossible(_))) {
        return Ok(());
    }
    let rest = Rest::of_landmarks(
        face.triangulation().topology(),
        face.model().positions_m().to_vec(),
        CoordinateFrame::Model,
    );
    let replayed = Document::open(rest, entries, face.document().density()).map_err(|error| error.to_string())?;
    ensure(bits(replayed.positions()) == bits(face.document().committed()), || {
        "a replay gives another shape".to_owned()
    })
}

fn mirrored(face: &OpenFace) -> Result<(), String> {
    let document = face.document();
    let Some(spec) = document.spec().filter(|spec| spec.settings.mirror == Mirror::On) else { return Ok(()) };
    let handles = document.handles();
    let partner = |vertex: u32| document.partner(spec.level, vertex);
    let is_closed = handles.iter().all(|&handle| partner(handle).is_some_and(|partner| handles.contains(&partner)));
    ensure(is_closed, || "a handle's partner is not a handle".to_owned())
}

fn ensure(holds: bool, message: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(message()) }
}
