//! Addition of graph values to the model.

use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{TractErrorContext, bail, ensure};

use super::pending::{Kind, Pending};
use super::{CHANNELS_FIRST, CHANNELS_LAST, Order, Reader, Value, Wire};
use crate::layers::{Layer, Operator, Pad, Permute};

impl Reader<'_> {
    /// Adds a layer to the model.
    pub(super) fn wire(
        &mut self,
        name: &str,
        layer: impl Layer,
        inputs: &[OutletId],
        order: Order,
    ) -> TractResult<Wire> {
        let operator: Box<dyn TypedOp> = Operator::new(layer).into();
        let outlets = self.model.wire_node(name, operator, inputs)?;
        Ok(Wire { outlet: outlets[0], order })
    }

    /// A value in the file's axis order.
    pub(super) fn in_file_order(&mut self, name: &str) -> TractResult<OutletId> {
        let wire = self.wired(name)?;
        match wire.order {
            Order::FileOrder => Ok(wire.outlet),
            Order::ChannelsLast => self.permuted(name, wire, CHANNELS_FIRST),
        }
    }

    /// A picture in channels last order.
    pub(super) fn picture(&mut self, name: &str) -> TractResult<OutletId> {
        let wire = self.wired(name)?;
        if wire.order == Order::ChannelsLast {
            return Ok(wire.outlet);
        }
        ensure!(self.rank(wire.outlet)? == 4, "{name} is not a picture");
        let outlet = self.permuted(name, wire, CHANNELS_LAST)?;
        // Share the permuted value among all readers.
        if let Some(value) = self.values.get_mut(name) {
            *value = Value::Wired(Wire { outlet, order: Order::ChannelsLast });
        }
        Ok(outlet)
    }

    fn permuted(&mut self, name: &str, wire: Wire, axes: [usize; 4]) -> TractResult<OutletId> {
        let name = format!("{name}/{}", self.model.nodes.len());
        Ok(self.wire(&name, Permute { axes: axes.to_vec() }, &[wire.outlet], wire.order)?.outlet)
    }

    /// A value of the model; adds a pending layer to it.
    pub(super) fn wired(&mut self, name: &str) -> TractResult<Wire> {
        if let Value::Wired(wire) = self.value(name)? {
            return Ok(*wire);
        }
        let (key, value) = self.values.remove_entry(name).with_context(|| format!("{name} is not defined"))?;
        let wire = match value {
            Value::Wired(wire) => wire,
            Value::Constant(_) => bail!("{name} is a constant"),
            Value::WithMoreChannels(wire, more) => {
                let by_axis = vec![[0, 0], [0, 0], [0, 0], [0, more]];
                self.wire(name, Pad { by_axis }, &[wire.outlet], Order::ChannelsLast)?
            }
            Value::Pending(pending) => {
                let Pending { kind, picture, skip, .. } = *pending;
                let inputs: TVec<OutletId> = [picture].into_iter().chain(skip).collect();
                match kind {
                    Kind::Depthwise(layer) => self.wire(name, layer, &inputs, Order::ChannelsLast)?,
                    Kind::Convolution(layer) => self.wire(name, layer, &inputs, Order::ChannelsLast)?,
                }
            }
        };
        self.values.insert(key, Value::Wired(wire));
        Ok(wire)
    }

    pub(super) fn rank(&self, outlet: OutletId) -> TractResult<usize> {
        Ok(self.model.outlet_fact(outlet)?.rank())
    }
}
