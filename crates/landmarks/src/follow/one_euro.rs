use std::f64::consts::TAU;

/// The one-euro filter (Casiez, Roussel and Vogel 2012) of one number: a low-pass filter whose cutoff rises with speed, so
/// that what rests does not tremble and what moves does not lag.
///
/// Speed is `|dx/dt| · scale` of the raw values, itself low-passed; the cutoff is `MIN_CUTOFF_HZ + BETA · speed`. With a
/// cutoff `f` and a time step `t`, a value is approached by the share `r / (1 + r)`, `r = 2π f t`.
///
/// After a step of more than `SLOW_S` speed is that of the step alone. Low-passed it would still be half of the speed before:
/// of what turns round the two can cancel, and all of a step, by then many px, would be taken for trembling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OneEuro {
    raw: f64,
    smooth: f64,
    /// Low-passed, in units of the scaled value per second.
    speed_per_s: f64,
}

// As MediaPipe sets them for the landmarks of faces.
const MIN_CUTOFF_HZ: f64 = 0.05;
const BETA: f64 = 80.0;
const SPEED_CUTOFF_HZ: f64 = 1.0;
/// Twice as long as a camera that has enough light takes from frame to frame.
const SLOW_S: f64 = 1.0 / 15.0;

impl OneEuro {
    pub(super) fn new(value: f64) -> Self {
        Self { raw: value, smooth: value, speed_per_s: 0.0 }
    }

    /// The next value, `elapsed_s` (at least 0) after the last one, smoothed. `scale` makes speeds comparable: one over the
    /// size of what moves.
    ///
    /// In no time nothing moves: steps are written so that nothing is divided by the time, which may be 0.
    pub(super) fn next(&mut self, value: f64, elapsed_s: f64, scale: f64) -> f64 {
        let change = (value - self.raw) * scale;
        self.speed_per_s = match elapsed_s > SLOW_S {
            true => change / elapsed_s,
            false => {
                let per_s = TAU * SPEED_CUTOFF_HZ / (1.0 + TAU * SPEED_CUTOFF_HZ * elapsed_s);
                self.speed_per_s + per_s * (change - self.speed_per_s * elapsed_s)
            }
        };
        let steps = TAU * (MIN_CUTOFF_HZ + BETA * self.speed_per_s.abs()) * elapsed_s;
        self.smooth += (value - self.smooth) * (steps / (1.0 + steps));
        self.raw = value;
        self.smooth
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::seeded::Seeded;

    const FRAME_S: f64 = 1.0 / 30.0;

    #[test]
    fn what_rests_stays_exactly_where_it_is() {
        let mut filter = OneEuro::new(123.456_789);
        assert!((0..100).all(|frame| filter.next(123.456_789, FRAME_S * f64::from(frame % 3), 0.01) == 123.456_789));
    }

    /// Written as in the paper and in MediaPipe, with a frequency.
    #[test]
    fn its_steps_are_those_of_the_paper() {
        let mut seeded = Seeded::new(3);
        let (mut filter, scale) = (OneEuro::new(0.0), 1.0 / 250.0);
        let alpha = |cutoff_hz: f64, rate_hz: f64| 1.0 / (1.0 + rate_hz / (TAU * cutoff_hz));
        let (mut raw, mut smooth, mut speed) = (0.0, 0.0, 0.0);
        for _ in 0..200 {
            let (value, elapsed_s) = (raw + 4.0 * seeded.signed(), 0.034 + 0.03 * seeded.signed());
            let rate_hz = 1.0 / elapsed_s;
            let pull = alpha(SPEED_CUTOFF_HZ, rate_hz);
            speed = pull * (value - raw) * scale * rate_hz + (1.0 - pull) * speed;
            let pull = alpha(MIN_CUTOFF_HZ + BETA * f64::abs(speed), rate_hz);
            smooth = pull * value + (1.0 - pull) * smooth;
            raw = value;
            let found = filter.next(value, elapsed_s, scale);
            assert!((found - smooth).abs() < 1e-9, "{found} {smooth}");
        }
    }

    #[test]
    fn time_that_stands_still_moves_nothing_and_makes_no_nan() {
        let mut filter = OneEuro::new(5.0);
        assert_eq!(filter.next(90.0, 0.0, 0.01), 5.0);
        assert!(filter.next(91.0, f64::MIN_POSITIVE, 0.01).is_finite());
        assert!(filter.next(92.0, 1.0, 0.01).is_finite());
    }

    /// By how much less noise is left (root of the mean square).
    fn stiller(frame_s: f64) -> f64 {
        let mut seeded = Seeded::new(7);
        let mut filter = OneEuro::new(0.0);
        let (mut before, mut after) = (0.0, 0.0);
        for _ in 0..3000 {
            let value = 0.5 * seeded.signed();
            before += value * value;
            after += filter.next(value, frame_s, 1.0 / 250.0).powi(2);
        }
        f64::sqrt(before / after)
    }

    #[test]
    fn what_trembles_about_a_place_is_held_three_times_stiller_and_between_slow_frames_still() {
        assert!(stiller(FRAME_S) > 3.0, "{}", stiller(FRAME_S));
        assert!(stiller(0.2) > 1.4, "{}", stiller(0.2));
    }

    /// To and fro at one speed, as a head is shaken; frames come as slowly as the machine is busy.
    #[test]
    fn what_turns_round_between_slow_frames_lags_by_a_few_px() {
        const SPEED_PX_S: f64 = 200.0;
        for frame_s in (1..=60).map(|step| SLOW_S + 0.005 * f64::from(step)) {
            let mut filter = OneEuro::new(0.0);
            for frame in 1..200 {
                let way = frame_s * f64::from(frame) * SPEED_PX_S;
                let value = 100.0 - (way % 400.0 - 200.0).abs();
                let behind_px = (value - filter.next(value, frame_s, 1.0 / 250.0)).abs();
                assert!(behind_px < 7.0, "{behind_px} px behind, every {frame_s} s");
            }
        }
    }

    #[test]
    fn what_moves_steadily_lags_by_less_than_a_fiftieth_of_a_second() {
        for speed_px_s in [100.0, 200.0, 300.0] {
            let mut filter = OneEuro::new(0.0);
            let after_a_second = (1..=30).map(|frame| {
                let value = speed_px_s * FRAME_S * f64::from(frame);
                value - filter.next(value, FRAME_S, 1.0 / 250.0)
            });
            let lag_ms = after_a_second.last().map_or(f64::NAN, |behind| 1000.0 * behind / speed_px_s);
            assert!((0.0..20.0).contains(&lag_ms), "{lag_ms} ms at {speed_px_s} px/s");
        }
    }
}
