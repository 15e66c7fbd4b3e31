/// `x` if it is positive, else `slope · x`. A slope of 0 is ReLU; a slope of 1 is the identity.
///
/// Selects a factor instead of a result, because selecting results can compile to an unpredictable branch.
#[inline(always)]
pub(crate) fn activated(x: f32, slope: f32) -> f32 {
    x * if x < 0.0 { slope } else { 1.0 }
}
