use std::future::Future;

use crate::{Gpu, ViewportError};

/// Everything that the GPU refuses from [`Self::open`] to [`Self::close`]: it goes on with what it has, such as nothing at all
/// in place of a picture.
pub(crate) struct ErrorScopes {
    memory: wgpu::ErrorScopeGuard,
    validation: wgpu::ErrorScopeGuard,
    internal: wgpu::ErrorScopeGuard,
}

impl ErrorScopes {
    pub fn open(gpu: &Gpu) -> Self {
        let scope = |filter| gpu.device.push_error_scope(filter);
        Self {
            memory: scope(wgpu::ErrorFilter::OutOfMemory),
            validation: scope(wgpu::ErrorFilter::Validation),
            internal: scope(wgpu::ErrorFilter::Internal),
        }
    }

    /// Resolves to what went wrong while a picture of this size was drawn. What there was no memory for is invalid, too: memory
    /// is the reason, then.
    pub fn close(self, [width, height]: [u32; 2]) -> impl Future<Output = Result<(), ViewportError>> + use<> {
        let (internal, validation, memory) = (self.internal.pop(), self.validation.pop(), self.memory.pop());
        async move {
            if memory.await.is_some() {
                return Err(ViewportError::OutOfMemory { width, height });
            }
            match validation.await.or(internal.await) {
                Some(error) => Err(ViewportError::NotDrawn(error.to_string())),
                None => Ok(()),
            }
        }
    }
}
