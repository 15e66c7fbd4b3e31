use rosto_face::Region;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::hand::{Hand, Selection};
use crate::modes::HandName;
use crate::session::Session;
use crate::trouble::{Outcome, Trouble};

/// Seeds for random anchors stay exact as JavaScript's and JSON's numbers.
const SEEDS: f64 = 9_007_199_254_740_992.0;

/// Taking landmarks and regions in hand, and pinning them.
#[wasm_bindgen]
impl Studio {
    /// Takes a landmark in hand, or lets go of it. Random anchors are drawn anew.
    ///
    /// # Errors
    /// `no-face`, `bad-vertex`, `bad-anchors` or `cannot-solve`.
    pub fn select(&mut self, vertex: Option<u32>) -> Result<(), JsValue> {
        self.take(vertex.map(Selection::Landmark))
    }

    /// Takes all landmarks of a region in hand, by the region's id; they move as one.
    ///
    /// # Errors
    /// `no-face`, `bad-choice`, `bad-anchors` or `cannot-solve`.
    #[wasm_bindgen(js_name = selectRegion)]
    pub fn select_region(&mut self, region: &str) -> Result<(), JsValue> {
        let region = Region::from_id(region).ok_or_else(Trouble::bad_choice)?;
        self.take(Some(Selection::Region(region)))
    }

    /// What a click or a drag takes from now on. What is in hand follows: the region around the landmark, the landmark in
    /// the middle of the region, or the point at its place. The first time that points of a dense mesh are to be taken
    /// needs a while.
    ///
    /// # Errors
    /// `bad-choice`, `bad-anchors` or `cannot-solve`.
    #[wasm_bindgen(js_name = setHand)]
    pub fn set_hand(&mut self, hand: HandName) -> Result<(), JsValue> {
        self.hand = match hand {
            HandName::Landmark => Hand::Landmark,
            HandName::Region => Hand::Region,
            HandName::Point => Hand::Point,
            _ => return Err(Trouble::bad_choice().into()),
        };
        self.prepare()?;
        let selection = self.selection();
        let wanted = self.session.as_ref().and_then(|session| session.taken_by(self.hand));
        if wanted == selection { Ok(()) } else { self.take(wanted) }
    }

    /// Takes what is at a vertex in hand: it alone, or the smallest region around it and, asked again, the next larger
    /// one.
    ///
    /// # Errors
    /// `no-face`, `bad-vertex`, `bad-anchors` or `cannot-solve`.
    #[wasm_bindgen(js_name = takeAt)]
    pub fn take_at(&mut self, vertex: u32) -> Result<(), JsValue> {
        let session = self.session()?;
        let selection = session.at(session.known(vertex, self.hand)?, self.hand);
        self.take(Some(selection))
    }

    /// The vertex in hand; of a region, the landmark in its middle.
    #[wasm_bindgen(getter)]
    pub fn selected(&self) -> Option<u32> {
        self.session.as_ref()?.selected()
    }

    /// Whether a vertex is in hand, alone or with its region.
    pub fn holds(&self, vertex: u32) -> bool {
        self.session.as_ref().is_some_and(|session| session.holds(vertex))
    }

    /// Whether all that is in hand is pinned.
    #[wasm_bindgen(getter)]
    pub fn pinned(&self) -> bool {
        let is_pinned = |vertex: &u32| self.choices.pins.contains(vertex);
        self.selection().is_some_and(|selection| selection.handles().iter().all(is_pinned))
    }

    /// Pins what is in hand, so that it stays while others move, or unpins it.
    ///
    /// # Errors
    /// `no-selection`, `bad-anchors` or `cannot-solve`.
    #[wasm_bindgen(js_name = setPinned)]
    pub fn set_pinned(&mut self, pinned: bool) -> Result<(), JsValue> {
        let handles = self.selection().ok_or_else(Trouble::no_selection)?.handles();
        self.choices.pins.retain(|pin| !handles.contains(pin));
        if pinned {
            self.choices.pins.extend(handles);
        }
        self.hold_again()
    }

    /// Pins a vertex, or unpins it.
    ///
    /// # Errors
    /// `no-face`, `bad-vertex`, `bad-anchors` or `cannot-solve`.
    #[wasm_bindgen(js_name = togglePin)]
    pub fn toggle_pin(&mut self, vertex: u32) -> Result<(), JsValue> {
        self.session()?.known(vertex, self.hand)?;
        let pins = &mut self.choices.pins;
        let before = pins.len();
        pins.retain(|&pin| pin != vertex);
        if pins.len() == before {
            pins.push(vertex);
        }
        self.hold_again()
    }
}

impl Studio {
    /// Marks the region that would be taken at a landmark which the pointer is over.
    pub(crate) fn point_at(&mut self, landmark: Option<u32>) {
        let at = |landmark| self.session.as_ref().map(|session| session.at_or_held(landmark, self.hand));
        let pointed = landmark.and_then(at).filter(|pointed| Some(*pointed) != self.selection());
        if pointed != self.pointed {
            self.pointed = pointed;
            self.show_marks();
        }
    }

    fn selection(&self) -> Option<Selection> {
        self.session.as_ref().and_then(Session::selection)
    }

    pub(crate) fn prepare(&mut self) -> Outcome<()> {
        let hand = self.hand;
        self.session_mut().map_or(Ok(()), |(session, choices)| session.prepare(hand, choices))
    }

    fn take(&mut self, selection: Option<Selection>) -> Result<(), JsValue> {
        self.drag = None;
        self.pointed = None;
        let seed = (js_sys::Math::random() * SEEDS) as u64;
        self.change(|session, choices| session.select(selection, choices, seed))
    }
}
