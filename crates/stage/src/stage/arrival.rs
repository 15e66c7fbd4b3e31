use super::Stage;

/// Duration of the still picture, and of the transition to the mesh.
const HOLD_MS: f64 = 250.0;
const ARRIVAL_MS: f64 = 500.0;

/// Animation from the picture to the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Arrival {
    Over,
    Asked,
    Since(f64),
}

/// Arrival animation.
impl Stage {
    /// Starts the arrival: the picture, then a transition to the mesh. Does nothing without a picture.
    pub fn start_arrival(&mut self) {
        if self.picture.is_some() {
            self.set(|stage| &mut stage.arrival, Arrival::Asked);
            self.picture_share = 1.0;
        }
    }

    pub(super) fn advance_arrival(&mut self, time_ms: f64) {
        self.arrival = match self.arrival {
            Arrival::Asked => Arrival::Since(time_ms),
            Arrival::Since(start_ms) if time_ms - start_ms >= HOLD_MS + ARRIVAL_MS => Arrival::Over,
            other => other,
        };
    }

    pub(super) fn is_arriving(&self) -> bool {
        self.arrival != Arrival::Over
    }

    /// Progress of the transition from picture (0) to mesh (1).
    fn progress(&self, time_ms: f64) -> f64 {
        match self.arrival {
            Arrival::Since(start_ms) => {
                let share = ((time_ms - start_ms - HOLD_MS) / ARRIVAL_MS).clamp(0.0, 1.0);
                share * share * (3.0 - 2.0 * share)
            }
            Arrival::Asked => 0.0,
            Arrival::Over => 1.0,
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
