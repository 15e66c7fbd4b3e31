use crate::StudioError;

/// Fault injection: with the feature `faults`, a test can make one of the next calls fail and check the resulting
/// state.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Fault {
    #[cfg(feature = "faults")]
    pub calls_until: Option<u32>,
}

impl Fault {
    /// Fails if a test has chosen this call.
    #[cfg(feature = "faults")]
    pub fn check(&mut self) -> Result<(), StudioError> {
        let Some(calls) = self.calls_until else { return Ok(()) };
        self.calls_until = calls.checked_sub(1);
        if calls == 0 { Err(StudioError::Injected) } else { Ok(()) }
    }

    #[cfg(not(feature = "faults"))]
    #[expect(clippy::unused_self, clippy::unnecessary_wraps, reason = "same signature as with the feature")]
    pub fn check(&mut self) -> Result<(), StudioError> {
        Ok(())
    }
}
