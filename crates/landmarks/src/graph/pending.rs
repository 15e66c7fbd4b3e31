//! Pending layers, into which following operators can be fused.

use tract_onnx::pb::NodeProto;
use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{bail, ensure};

use super::attributes::Attributes;
use super::{Order, Reader, Value, Wire};
use crate::constants;
use crate::layers::{Convolution, Dense, Depthwise, Sum, Window};

/// A convolution with its input picture, and the value to add to its output.
pub(super) struct Pending {
    pub(super) kind: Kind,
    pub(super) picture: OutletId,
    pub(super) skip: Option<OutletId>,
    activated: bool,
}

pub(super) enum Kind {
    Depthwise(Depthwise),
    Convolution(Convolution),
}

impl Pending {
    fn on(picture: OutletId, kind: Kind) -> Self {
        Self { kind, picture, skip: None, activated: false }
    }

    fn channels(&self) -> usize {
        match &self.kind {
            Kind::Depthwise(depthwise) => depthwise.channels(),
            Kind::Convolution(convolution) => convolution.dense.channels,
        }
    }

    fn takes_skip(&self) -> bool {
        matches!(self.kind, Kind::Convolution(_)) && self.skip.is_none() && !self.activated
    }

    fn with_slopes(mut self, slopes: &[f32]) -> Self {
        self.activated = true;
        self.kind = match self.kind {
            Kind::Depthwise(depthwise) => Kind::Depthwise(depthwise.with_slopes(slopes)),
            Kind::Convolution(convolution) => {
                let dense = convolution.dense.with_slopes(slopes);
                Kind::Convolution(Convolution { dense, ..convolution })
            }
        };
        self
    }
}

impl<'a> Reader<'a> {
    pub(super) fn convolution(
        &mut self,
        node: &NodeProto,
        input: &str,
        weights: &str,
        biases: Option<&str>,
    ) -> TractResult<Value<'a>> {
        let weights = self.constant(weights)?;
        let [channels, channels_in, rows, columns] = *constants::shape(weights)? else {
            bail!("weights of shape {:?}", weights.dims)
        };
        let kernel = [rows, columns];
        ensure!(
            node.extents("kernel_shape")? == kernel && channels_in > 0 && channels > 0,
            "{:?} weights",
            weights.dims
        );
        let window = node.window(kernel, node.extents("dilations")?)?;
        let (weights, taps) = (constants::floats(weights)?, rows * columns);
        let biases = match biases {
            Some(biases) => constants::floats(self.constant(biases)?)?,
            None => vec![0.0; channels],
        };
        ensure!(biases.len() == channels, "{} biases for {channels} channels", biases.len());
        let weight = |channel: usize, input: usize, tap: usize| weights[(channel * channels_in + input) * taps + tap];
        let pending = match node.get_attr::<usize>("group")? {
            1 => {
                let depth = taps * channels_in;
                let by_pixel = |channel, input| weight(channel, input % channels_in, input / channels_in);
                let dense = Dense::new(&biases, depth, by_pixel);
                self.dense(input, Convolution { depthwise: None, window, channels_in, dense })?
            }
            groups if groups == channels && channels_in == 1 => {
                let depthwise = Depthwise::new(window, &biases, |channel, tap| weight(channel, 0, tap));
                Pending::on(self.picture(input)?, Kind::Depthwise(depthwise))
            }
            groups => bail!("{groups} groups of {channels_in} channels"),
        };
        Ok(Value::Pending(Box::new(pending)))
    }

    /// Fuses a preceding depthwise convolution into a 1 × 1 convolution.
    fn dense(&mut self, input: &str, convolution: Convolution) -> TractResult<Pending> {
        let fits = |pending: &Pending| {
            let fits = pending.channels() == convolution.channels_in && convolution.window == Window::POINT;
            fits && matches!(pending.kind, Kind::Depthwise(_))
        };
        match self.take_pending(input, fits) {
            Some(Pending { kind: Kind::Depthwise(depthwise), picture, .. }) => {
                let depthwise = Some(depthwise);
                Ok(Pending::on(picture, Kind::Convolution(Convolution { depthwise, ..convolution })))
            }
            _ => Ok(Pending::on(self.picture(input)?, Kind::Convolution(convolution))),
        }
    }

    pub(super) fn add(&mut self, name: &str, a: &str, b: &str) -> TractResult<Value<'a>> {
        for (input, other) in [(a, b), (b, a)] {
            if let Some(mut pending) = self.take_pending(input, Pending::takes_skip) {
                pending.skip = Some(self.skip(other, pending.channels())?);
                return Ok(Value::Pending(Box::new(pending)));
            }
        }
        let wires = [self.wired(a)?, self.wired(b)?];
        if wires.iter().all(|wire| wire.order == Order::FileOrder) {
            let outlets = wires.map(|wire| wire.outlet);
            return self.wire(name, Sum { slopes: None }, &outlets, Order::FileOrder).map(Value::Wired);
        }
        let pictures = [self.picture(a)?, self.picture(b)?];
        self.wire(name, Sum { slopes: None }, &pictures, Order::ChannelsLast).map(Value::Wired)
    }

    /// The summand for a convolution with this number of channels. Appended zero channels can be omitted.
    fn skip(&mut self, name: &str, channels: usize) -> TractResult<OutletId> {
        if let Value::WithMoreChannels(wire, more) = *self.value(name)? {
            let shape = self.model.outlet_fact(wire.outlet)?.shape.as_concrete();
            if shape.and_then(|shape| shape.last()?.checked_add(more)) == Some(channels) {
                return Ok(wire.outlet);
            }
        }
        let picture = self.picture(name)?;
        let shape = self.model.outlet_fact(picture)?.shape.as_concrete();
        ensure!(shape.and_then(<[_]>::last) == Some(&channels), "{shape:?} added to {channels} channels");
        Ok(picture)
    }

    /// Applies PReLU with the given slopes, or ReLU without.
    pub(super) fn activate(&mut self, name: &str, input: &str, slopes: Option<&str>) -> TractResult<Value<'a>> {
        let slopes = slopes.map(|slopes| constants::floats(self.constant(slopes)?)).transpose()?;
        let fits = |pending: &Pending| {
            !pending.activated && slopes.as_ref().is_none_or(|slopes| slopes.len() == pending.channels())
        };
        if let Some(pending) = self.take_pending(input, fits) {
            let slopes = slopes.unwrap_or_else(|| vec![0.0; pending.channels()]);
            return Ok(Value::Pending(Box::new(pending.with_slopes(&slopes))));
        }
        let wire = match slopes {
            Some(_) => Wire { outlet: self.picture(input)?, order: Order::ChannelsLast },
            None => self.wired(input)?,
        };
        let channels = self.model.outlet_fact(wire.outlet)?.shape.as_concrete().and_then(|shape| shape.last().copied());
        let slopes = slopes.unwrap_or_else(|| vec![0.0; channels.unwrap_or(1)]);
        self.wire(name, Sum { slopes: Some(slopes) }, &[wire.outlet], wire.order).map(Value::Wired)
    }

    /// Takes a pending layer that satisfies `fits` and has no other reader.
    fn take_pending(&mut self, name: &str, fits: impl Fn(&Pending) -> bool) -> Option<Pending> {
        let alone = self.readers.get(name) == Some(&1);
        match self.values.get(name)? {
            Value::Pending(pending) if alone && fits(pending) => match self.values.remove(name)? {
                Value::Pending(pending) => Some(*pending),
                _ => None,
            },
            _ => None,
        }
    }
}
