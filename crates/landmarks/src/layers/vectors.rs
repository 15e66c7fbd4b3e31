//! The same arithmetic in wider vectors, where the machine has them.

/// Runs `work` compiled for the widest vectors of this machine; what it calls takes part if it is inlined.
///
/// Vectors hold neighbouring numbers, each with a sum of its own in an order of its own, and nothing is fused: the answer
/// is the same to the bit on every machine.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(crate) fn widest<R>(work: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(work)
}

/// Elsewhere a program is compiled for the vectors there are.
#[cfg(not(target_arch = "x86_64"))]
#[inline(always)]
pub(crate) fn widest<R>(work: impl FnOnce() -> R) -> R {
    work()
}
