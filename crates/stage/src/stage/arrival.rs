use std::f64::consts::TAU;

use super::Stage;

/// Duration of the still picture, and of the transition to the mesh.
const HOLD_MS: f64 = 250.0;
const ARRIVAL_MS: f64 = 500.0;
/// Duration of the swing that follows, and its amplitude in radians.
const SWING_S: f64 = 1.6;
const SWING: f64 = 0.34;

/// Animation from the picture to the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Arrival {
    Over,
    Asked,
    Since(f64),
    /// Swings to one side and back; the elapsed seconds.
    Swings(f64),
}

/// Arrival animation.
impl Stage {
    /// Starts the arrival: the picture, a transition to the mesh, then a slight swing. Does nothing without a picture.
    pub fn start_arrival(&mut self) {
        if self.picture.is_some() {
            self.set(|stage| &mut stage.arrival, Arrival::Asked);
            self.picture_share = 1.0;
        }
    }

    /// Ends the swing when the user takes over; the rotation glides back.
    pub fn end_swing(&mut self) {
        if let Arrival::Swings(_) = self.arrival {
            self.arrival = Arrival::Over;
            self.camera_mut().end_sway();
        }
    }

    /// Advances the arrival. The swing uses clamped time steps, because slow frames would skip most of it.
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

    /// Progress of the transition from picture (0) to mesh (1).
    fn progress(&self, time_ms: f64) -> f64 {
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
            let progress = self.progress(time_ms);
            self.camera.lift(picture, progress);
            self.picture_share = 1.0 - progress;
        }
    }
}
