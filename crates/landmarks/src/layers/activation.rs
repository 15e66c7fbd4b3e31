/// `x` where it is positive, `slope · x` elsewhere. ReLU has a slope of 0, and what has a slope of 1 does nothing.
#[inline(always)]
pub(crate) fn activated(x: f32, slope: f32) -> f32 {
    if x < 0.0 { x * slope } else { x }
}
