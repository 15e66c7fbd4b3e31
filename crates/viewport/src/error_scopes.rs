use std::future::Future;

use crate::{Gpu, ViewportError};

/// Collects GPU errors from [`Self::open`] to [`Self::close`]. After an error, the GPU continues with invalid
/// resources, such as an empty picture.
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

    /// Resolves to the error, if any, of drawing a picture of this size. Failed allocations also cause validation
    /// errors, so memory is checked first.
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
