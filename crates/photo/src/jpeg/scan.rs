//! Decoding of one scan, with a record of the rows it lost.

use std::ops::Range;

use super::bits::{Bits, Rest};
use super::block::{self, Run};
use super::header::{Frame, Scan, ScanComponent, Tables};
use super::huffman::Huffman;
use super::plane::Plane;
use super::rows::Rows;
use super::segments::END;

/// Codes of the first and the last restart marker.
const RESTART: [u8; 2] = [0xD0, 0xD7];

/// Decodes a scan whose data begins at `position`. Returns the position after it, or `None` if a table is missing.
pub(crate) fn decode(
    (bytes, position): (&[u8], usize),
    frame: &Frame,
    scan: &Scan,
    tables: &Tables,
    planes: &mut [Plane],
    rows: &mut Rows,
) -> Option<usize> {
    let interleaved = scan.components.len() > 1;
    let mut unit = Vec::new();
    for (component, &selected) in scan.components.iter().enumerate() {
        let step = if interleaved { frame.components[selected.index].sampling } else { [1, 1] };
        for at in 0..step[0] * step[1] {
            let offset = [at % step[0], at / step[0]];
            unit.push(UnitBlock::new(component, selected, scan, tables, planes, [step, offset])?);
        }
    }
    let first = scan.components.first()?.index;
    let [across, down] = if interleaved { frame.units() } else { planes[first].blocks };
    let sampled = if interleaved { 1 } else { frame.components[first].sampling[1] };
    let mut decoder = Decoder {
        bytes,
        bits: Bits::new(bytes, position),
        frame,
        scan,
        run: Run::default(),
        unit,
        across,
        total: across * down,
        unit_height_px: 8 * frame.largest[1] / sampled,
        restart_interval: tables.restart_interval,
    };
    decoder.decode_intervals(planes, rows);
    Some(decoder.bits.next_marker().map_or(bytes.len(), |code| code - 1))
}

struct Decoder<'a> {
    bytes: &'a [u8],
    bits: Bits<'a>,
    frame: &'a Frame,
    scan: &'a Scan,
    run: Run,
    /// Blocks of one coded unit.
    unit: Vec<UnitBlock<'a>>,
    /// Units per row, and in total.
    across: usize,
    total: usize,
    /// Height of a row of units, in picture px.
    unit_height_px: usize,
    restart_interval: usize,
}

/// A block's place within each coded unit.
struct UnitBlock<'a> {
    plane: usize,
    /// Index of the component within the scan.
    component: usize,
    dc: Option<&'a Huffman>,
    ac: Option<&'a Huffman>,
    quantisation: [i32; 64],
    /// Step in blocks from one unit to the next, and offset within the unit; horizontal and vertical.
    step: [usize; 2],
    offset: [usize; 2],
}

/// Reason why an interval is incomplete or invalid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fault {
    /// The data ends within a unit.
    Cut,
    /// The data ends with regular padding, but before the last unit.
    Short,
    /// The data contains a code that no encoder writes.
    Invalid,
    /// Data is left after the last unit.
    Long,
}

impl Decoder<'_> {
    /// Decodes up to the last unit, or until the data can no longer be assigned to units.
    fn decode_intervals(&mut self, planes: &mut [Plane], rows: &mut Rows) {
        let length = if self.restart_interval == 0 { self.total } else { self.restart_interval };
        let (mut start, mut number) = (0, 0);
        loop {
            let end = (start + length).min(self.total);
            let fault = self.decode_interval(start..end, planes);
            let marker = self.marker();
            if let Some((fault, unit)) = fault {
                self.lose(fault, unit, start..end, rows);
            }
            let missing = match marker {
                // There are more intervals than the picture has, and it is unknown which ones are surplus.
                Some(code) if end == self.total && is_restart(code) => return self.lose_units(0..self.total, rows),
                _ if end == self.total => return,
                Some(code) if self.restart_interval > 0 && is_restart(code) => self.restart(number),
                // The data ends regularly, so earlier intervals are missing.
                Some(_) if fault.is_none() => return self.lose_units(0..self.total, rows),
                _ => None,
            };
            let Some(missing) = missing else { return self.end_at(end, rows) };
            let next = (end + missing * length).min(self.total);
            self.lose_units(end..next, rows);
            if next == self.total {
                return;
            }
            (start, number) = (next, (number + missing + 1) % 8);
        }
    }

    /// Skips to the interval after the restart marker numbered `expected`, or a later one. Returns the number of
    /// missing intervals, or `None` if there is no such marker.
    fn restart(&mut self, expected: usize) -> Option<usize> {
        /// A number further ahead belongs to an earlier interval.
        const MOST_AHEAD: usize = 4;
        while let Some(code) = self.bits.next_marker().filter(|&code| is_restart(self.bytes[code])) {
            self.bits = Bits::new(self.bytes, code + 1);
            let ahead = (usize::from(self.bytes[code] - RESTART[0]) + 8 - expected) % 8;
            if ahead <= MOST_AHEAD {
                return Some(ahead);
            }
        }
        None
    }

    fn marker(&self) -> Option<u8> {
        self.bits.next_marker().map(|code| self.bytes[code])
    }

    /// Decodes the units of an interval. Returns the fault, if any, and the unit where it was detected.
    fn decode_interval(&mut self, units: Range<usize>, planes: &mut [Plane]) -> Option<(Fault, usize)> {
        self.run = Run::default();
        for unit in units.clone() {
            let mut before = self.bits.clone();
            let decoded = self.decode_unit(unit, planes);
            if self.bits.overrun() {
                return Some((if before.rest() == Rest::Ones { Fault::Short } else { Fault::Cut }, unit));
            }
            if decoded.is_none() {
                return Some((Fault::Invalid, unit));
            }
        }
        let complete = self.run.ended == 0 && self.bits.rest() != Rest::Data;
        (!complete).then_some((Fault::Long, units.end))
    }

    fn decode_unit(&mut self, unit: usize, planes: &mut [Plane]) -> Option<()> {
        let position = [unit % self.across, unit / self.across];
        for unit_block in &self.unit {
            let at = [0, 1].map(|axis| position[axis] * unit_block.step[axis] + unit_block.offset[axis]);
            let plane = &mut planes[unit_block.plane];
            let Scan { first, last, high, low, .. } = *self.scan;
            let (bits, run) = (&mut self.bits, &mut self.run);
            if !self.frame.progressive {
                let mut block = [0; 64];
                let prediction = &mut run.predictions[unit_block.component];
                let more = block::sequential(
                    bits,
                    [unit_block.dc?, unit_block.ac?],
                    prediction,
                    &unit_block.quantisation,
                    &mut block,
                )?;
                plane.write(at, &block, !more);
                continue;
            }
            let block = plane.coefficients(at);
            match (first, high) {
                (0, 0) => {
                    let (prediction, quantisation) =
                        (&mut run.predictions[unit_block.component], unit_block.quantisation[0] << low);
                    block[0] = (block::first(bits, unit_block.dc?, prediction, quantisation)? << low) as i16;
                }
                (0, _) => block[0] |= i16::from(bits.bit()) << low,
                (_, 0) => block::band(bits, unit_block.ac?, run, [first, last], low, block)?,
                _ => block::refine_band(bits, unit_block.ac?, run, [first, last], low, block)?,
            }
        }
        Some(())
    }

    /// Marks the units lost to a fault detected at `unit` of an interval.
    fn lose(&self, fault: Fault, unit: usize, interval: Range<usize>, rows: &mut Rows) {
        let marker = self.marker();
        let restarts = marker.is_some_and(is_restart);
        let lost = match fault {
            _ if self.restart_interval > 0 && restarts => interval,
            Fault::Cut => return self.end_at(unit, rows),
            Fault::Short if marker.is_none() => return self.end_at(unit, rows),
            Fault::Short if unit == interval.start => 0..self.total,
            Fault::Short | Fault::Long => interval.start..self.total,
            // Decoding may go wrong some blocks before the fault is detected.
            Fault::Invalid => unit.saturating_sub(self.across)..self.total,
        };
        self.lose_units(lost, rows);
    }

    /// Marks the units after the end of the data as lost. A refinement scan that only lacks its last bits, at the end
    /// of the file, leaves the picture almost unchanged.
    fn end_at(&self, unit: usize, rows: &mut Rows) {
        rows.ends_early = true;
        if self.scan.high != 1 || self.marker().is_some_and(|code| code != END) {
            self.lose_units(unit..self.total, rows);
        }
    }

    fn lose_units(&self, units: Range<usize>, rows: &mut Rows) {
        if !units.is_empty() {
            let row = |unit: usize| unit * self.unit_height_px;
            rows.lose(row(units.start / self.across)..row(units.end.div_ceil(self.across)));
        }
    }
}

fn is_restart(code: u8) -> bool {
    (RESTART[0]..=RESTART[1]).contains(&code)
}

impl<'a> UnitBlock<'a> {
    fn new(
        component: usize,
        selected: ScanComponent,
        scan: &Scan,
        tables: &'a Tables,
        planes: &[Plane],
        [step, offset]: [[usize; 2]; 2],
    ) -> Option<Self> {
        let (dc, ac) = (tables.dc[selected.dc].as_deref(), tables.ac[selected.ac].as_deref());
        let needs_dc = scan.first == 0 && scan.high == 0;
        let quantisation = planes[selected.index].quantisation?;
        let complete = (dc.is_some() || !needs_dc) && (ac.is_some() || scan.last == 0);
        complete.then_some(Self { plane: selected.index, component, dc, ac, quantisation, step, offset })
    }
}
