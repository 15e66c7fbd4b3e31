//! Run-time selection of vector instructions.

/// Runs `work` compiled for the machine's widest vectors. Functions that it calls must be inlined.
///
/// Lanes are independent sums in a fixed order, and nothing uses fused multiply-add, so results are bit-identical on
/// all machines.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub fn widest<R>(work: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(work)
}

/// Other targets are compiled for a fixed instruction set.
#[cfg(not(target_arch = "x86_64"))]
#[inline(always)]
pub fn widest<R>(work: impl FnOnce() -> R) -> R {
    work()
}
