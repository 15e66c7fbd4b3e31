use tract_onnx::pb::NodeProto;
use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::bail;

use crate::layers::Window;

/// Attributes of a sliding window.
pub(super) trait Attributes {
    /// Reads an attribute with height and width.
    fn extents(&self, name: &str) -> TractResult<[usize; 2]>;

    /// Reads the window of a kernel.
    fn window(&self, kernel: [usize; 2], dilations: [usize; 2]) -> TractResult<Window>;
}

impl Attributes for NodeProto {
    fn extents(&self, name: &str) -> TractResult<[usize; 2]> {
        match *self.get_attr_vec::<usize>(name)? {
            [height, width] => Ok([height, width]),
            ref other => bail!("{name} has {} values, expected 2", other.len()),
        }
    }

    fn window(&self, kernel: [usize; 2], dilations: [usize; 2]) -> TractResult<Window> {
        let [top, left, bottom, right] = *self.get_attr_vec::<usize>("pads")? else {
            bail!("pads does not have 4 values")
        };
        let strides = self.extents("strides")?;
        Window { kernel, strides, dilations, before: [top, left], after: [bottom, right] }.checked()
    }
}
