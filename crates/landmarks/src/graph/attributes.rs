use tract_onnx::pb::NodeProto;
use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::bail;

use crate::layers::Window;

/// What ONNX says of a sliding window.
pub(super) trait Attributes {
    /// Height and width.
    fn extents(&self, name: &str) -> TractResult<[usize; 2]>;

    /// The window of so many taps.
    fn window(&self, kernel: [usize; 2], dilations: [usize; 2]) -> TractResult<Window>;
}

impl Attributes for NodeProto {
    fn extents(&self, name: &str) -> TractResult<[usize; 2]> {
        match *self.get_attr_vec::<usize>(name)? {
            [height, width] => Ok([height, width]),
            ref other => bail!("{} {name}", other.len()),
        }
    }

    fn window(&self, kernel: [usize; 2], dilations: [usize; 2]) -> TractResult<Window> {
        let [top, left, bottom, right] = *self.get_attr_vec::<usize>("pads")? else { bail!("pads that are not four") };
        let strides = self.extents("strides")?;
        Window { kernel, strides, dilations, before: [top, left], after: [bottom, right] }.checked()
    }
}
