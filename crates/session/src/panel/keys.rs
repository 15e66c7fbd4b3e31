//! Keys of the page, as data.

use glam::DVec2;
use rosto_stage::{NamedView, Scene, Visibility};
use serde::Serialize;
use tsify::Tsify;

use crate::{Intent, Session};

/// Part of the canvas' height by which an arrow key moves, like a drag.
const STEP: f64 = 1.0 / 32.0;
const ZOOM: f64 = 1.1;

/// A key, and the id that the page pushes for it.
#[derive(Debug, Clone, Copy, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Key {
    /// Unique id, such as "key.undo".
    pub id: &'static str,
    /// The key, as in the browser's `KeyboardEvent`; letters in lower case.
    pub key: &'static str,
    /// Keys that are held with it.
    pub with: Held,
    /// The part of the page in which it works.
    pub place: Place,
    #[serde(skip)]
    act: fn(&Session) -> Intent,
}

/// Modifier keys. Other combinations belong to the browser.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum Held {
    /// None; Shift may be held.
    Nothing,
    /// Alt.
    Alt,
    /// Ctrl or Cmd.
    Ctrl,
    /// The same with Shift.
    CtrlShift,
}

/// The part of the page in which a key works.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum Place {
    /// On the canvas.
    Canvas,
    /// Everywhere, except while the visitor types.
    Page,
}

const fn key(id: &'static str, key: &'static str, with: Held, place: Place, act: fn(&Session) -> Intent) -> Key {
    Key { id, key, with, place, act }
}

/// The keys. B and ? belong to the page, because one is held and the other opens a dialog of the page.
pub(crate) const KEYS: [Key; 22] = [
    key("key.turn-left", "ArrowLeft", Held::Nothing, Place::Canvas, |session| Intent::Orbit(session.step(-1.0, 0.0))),
    key("key.turn-right", "ArrowRight", Held::Nothing, Place::Canvas, |session| Intent::Orbit(session.step(1.0, 0.0))),
    key("key.turn-up", "ArrowUp", Held::Nothing, Place::Canvas, |session| Intent::Orbit(session.step(0.0, -1.0))),
    key("key.turn-down", "ArrowDown", Held::Nothing, Place::Canvas, |session| Intent::Orbit(session.step(0.0, 1.0))),
    key("key.move-left", "ArrowLeft", Held::CtrlShift, Place::Canvas, |session| Intent::Pan(session.step(-1.0, 0.0))),
    key("key.move-right", "ArrowRight", Held::CtrlShift, Place::Canvas, |session| Intent::Pan(session.step(1.0, 0.0))),
    key("key.move-up", "ArrowUp", Held::CtrlShift, Place::Canvas, |session| Intent::Pan(session.step(0.0, -1.0))),
    key("key.move-down", "ArrowDown", Held::CtrlShift, Place::Canvas, |session| Intent::Pan(session.step(0.0, 1.0))),
    key("key.zoom-in", "ArrowUp", Held::Alt, Place::Canvas, |_| Intent::Zoom(ZOOM)),
    key("key.zoom-out", "ArrowDown", Held::Alt, Place::Canvas, |_| Intent::Zoom(1.0 / ZOOM)),
    key("key.front", "f", Held::Nothing, Place::Canvas, |_| Intent::GoTo(NamedView::Front)),
    key("key.left", "l", Held::Nothing, Place::Canvas, |_| Intent::GoTo(NamedView::Left)),
    key("key.top", "t", Held::Nothing, Place::Canvas, |_| Intent::GoTo(NamedView::Top)),
    key("key.reset-view", " ", Held::Nothing, Place::Canvas, |_| Intent::GoTo(NamedView::Reset)),
    key("key.wireframe", "w", Held::Nothing, Place::Canvas, |session| {
        let is_shown = session.view().wireframe == Visibility::Shown;
        Intent::Wireframe(if is_shown { Visibility::Hidden } else { Visibility::Shown })
    }),
    key("key.deselect", "Escape", Held::Nothing, Place::Canvas, |_| Intent::Select(None)),
    key("key.scene", "p", Held::Nothing, Place::Page, |session| {
        let shows_face = session.face().is_none() || session.view().scene == Scene::Picture;
        Intent::Scene(if shows_face { Scene::Solid } else { Scene::Picture })
    }),
    key("key.undo", "z", Held::Ctrl, Place::Page, |_| Intent::Undo),
    key("key.redo", "z", Held::CtrlShift, Place::Page, |_| Intent::Redo),
    key("key.redo-too", "y", Held::Ctrl, Place::Page, |_| Intent::Redo),
    key("key.redo-three", "y", Held::CtrlShift, Place::Page, |_| Intent::Redo),
    key("key.cancel", "Escape", Held::Nothing, Place::Page, |_| Intent::Cancel),
];

impl Key {
    /// The intent of the key with this id.
    pub(super) fn intent(id: &str, session: &Session) -> Option<Intent> {
        KEYS.iter().find(|key| key.id == id).map(|key| (key.act)(session))
    }
}

impl Session {
    /// The movement of an arrow key in px.
    fn step(&self, x: f64, y: f64) -> DVec2 {
        STEP * self.stage().camera().size_px().y * DVec2::new(x, y)
    }
}
