/// `x` where it is positive, `slope · x` elsewhere. ReLU has a slope of 0, and what has a slope of 1 does nothing.
///
/// A choice between factors and not between results, which would become a jump that no machine can foresee.
#[inline(always)]
pub(crate) fn activated(x: f32, slope: f32) -> f32 {
    x * if x < 0.0 { slope } else { 1.0 }
}
