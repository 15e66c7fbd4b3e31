use std::f64::consts::TAU;

use super::Stage;

/// How long a picture is seen before what is in it rises, and how long that takes.
const HOLD_MS: f64 = 250.0;
const ARRIVAL_MS: f64 = 500.0;
/// How long it then takes to show a side and to come back, and how far it turns, in radians.
const SWING_S: f64 = 1.6;
const SWING: f64 = 0.34;

/// A mesh's way out of the picture that was taken of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Arrival {
    Over,
    Asked,
    Since(f64),
    /// It is there, and has turned a little and back for so many seconds.
    Swings(f64),
}

/// How a mesh arrives.
impl Stage {
    /// Shows the picture from the next frame on, and lets the mesh rise out of it in half a second; then it turns a little and
    /// back. Nothing without a picture.
    pub fn start_arrival(&mut self) {
        if self.picture.is_some() {
            self.set(|stage| &mut stage.arrival, Arrival::Asked);
            self.picture_share = 1.0;
        }
    }

    /// Lets a mesh that has arrived stand still, as somebody takes it in hand: what it is turned by it glides back.
    pub fn end_swing(&mut self) {
        if let Arrival::Swings(_) = self.arrival {
            self.arrival = Arrival::Over;
            self.camera_mut().end_sway();
        }
    }

    /// The arrival at a frame, `seconds` after the frame before. A swing goes by these, as slow frames would skip most of it.
    pub(super) fn advance_arrival(&mut self, time_ms: f64, seconds: f64) {
        self.arrival = match self.arrival {
            Arrival::Asked => Arrival::Since(time_ms),
            Arrival::Since(start_ms) if time_ms - start_ms >= HOLD_MS + ARRIVAL_MS => Arrival::Swings(0.0),
            Arrival::Swings(before_s) => {
                let swung_s = before_s + seconds;
                let share = (swung_s / SWING_S).min(1.0);
                self.camera.sway(if share < 1.0 { SWING * (0.5 - 0.5 * (TAU * share).cos()) } else { 0.0 });
                if share < 1.0 { Arrival::Swings(swung_s) } else { Arrival::Over }
            }
            other => other,
        };
    }

    pub(super) fn is_arriving(&self) -> bool {
        matches!(self.arrival, Arrival::Asked | Arrival::Since(_))
    }

    /// How far it has risen out of the picture.
    fn risen(&self, time_ms: f64) -> f64 {
        match self.arrival {
            Arrival::Since(start_ms) => {
                let share = ((time_ms - start_ms - HOLD_MS) / ARRIVAL_MS).clamp(0.0, 1.0);
                share * share * (3.0 - 2.0 * share)
            }
            Arrival::Asked => 0.0,
            Arrival::Over | Arrival::Swings(_) => 1.0,
        }
    }

    pub(super) fn lift(&mut self, time_ms: f64) {
        if let (true, Some(picture)) = (self.is_arriving(), self.picture) {
            let risen = self.risen(time_ms);
            self.camera.lift(picture, risen);
            self.picture_share = 1.0 - risen;
        }
    }
}
