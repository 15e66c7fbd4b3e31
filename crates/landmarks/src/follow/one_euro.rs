use std::f64::consts::TAU;

/// One-euro filter (Casiez, Roussel and Vogel 2012) of a scalar: a low-pass filter whose cutoff rises with speed, to
/// suppress jitter at rest and lag in motion.
///
/// Speed is the low-passed `|dx/dt| · scale` of the raw values; the cutoff is `MIN_CUTOFF_HZ + BETA · speed`. With a
/// cutoff `f` and a time step `t`, the filter moves towards a value by the fraction `r / (1 + r)` with `r = 2π f t`.
///
/// After a step of more than `LONG_STEP_S`, the speed is that of the step alone. Low-passed, it would contain half of
/// the previous speed. At a reversal of the motion the two can cancel, and the filter would suppress the whole step as
/// jitter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OneEuro {
    raw: f64,
    smooth: f64,
    /// Low-passed speed of the scaled value, per second.
    speed_per_s: f64,
}

// MediaPipe's settings for face landmarks.
const MIN_CUTOFF_HZ: f64 = 0.05;
const BETA: f64 = 80.0;
const SPEED_CUTOFF_HZ: f64 = 1.0;
/// Twice the frame interval of a camera in good light.
const LONG_STEP_S: f64 = 1.0 / 15.0;

impl OneEuro {
    pub(super) fn new(value: f64) -> Self {
        Self { raw: value, smooth: value, speed_per_s: 0.0 }
    }

    /// Filters the next value, `elapsed_s` (at least 0) after the previous one. `scale` normalises speeds; use the
    /// inverse of the object's size.
    ///
    /// `elapsed_s == 0` leaves the value unchanged; the formulas do not divide by it.
    pub(super) fn next(&mut self, value: f64, elapsed_s: f64, scale: f64) -> f64 {
        let change = (value - self.raw) * scale;
        self.speed_per_s = match elapsed_s > LONG_STEP_S {
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
    fn a_constant_value_is_unchanged() {
        let mut filter = OneEuro::new(123.456_789);
        assert!((0..100).all(|frame| filter.next(123.456_789, FRAME_S * f64::from(frame % 3), 0.01) == 123.456_789));
    }

    /// Compares with the frequency form of the paper and of MediaPipe.
    #[test]
    fn steps_match_the_paper() {
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
    fn zero_and_tiny_time_steps_stay_finite() {
        let mut filter = OneEuro::new(5.0);
        assert_eq!(filter.next(90.0, 0.0, 0.01), 5.0);
        assert!(filter.next(91.0, f64::MIN_POSITIVE, 0.01).is_finite());
        assert!(filter.next(92.0, 1.0, 0.01).is_finite());
    }

    /// Reduction of the noise's root mean square.
    fn noise_reduction(frame_s: f64) -> f64 {
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
    fn jitter_is_reduced_at_normal_and_slow_frame_rates() {
        assert!(noise_reduction(FRAME_S) > 3.0, "{}", noise_reduction(FRAME_S));
        assert!(noise_reduction(0.2) > 1.4, "{}", noise_reduction(0.2));
    }

    /// Triangle wave at constant speed, as of a shaken head, at several frame intervals.
    #[test]
    fn reversals_at_slow_frame_rates_lag_by_a_few_px() {
        const SPEED_PX_S: f64 = 200.0;
        for frame_s in (1..=60).map(|step| LONG_STEP_S + 0.005 * f64::from(step)) {
            let mut filter = OneEuro::new(0.0);
            for frame in 1..200 {
                let travelled_px = frame_s * f64::from(frame) * SPEED_PX_S;
                let value = 100.0 - (travelled_px % 400.0 - 200.0).abs();
                let lag_px = (value - filter.next(value, frame_s, 1.0 / 250.0)).abs();
                assert!(lag_px < 7.0, "{lag_px} px behind, every {frame_s} s");
            }
        }
    }

    #[test]
    fn steady_motion_lags_by_less_than_20_ms() {
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
