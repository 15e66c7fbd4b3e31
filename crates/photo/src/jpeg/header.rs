//! Header and table segments (ITU-T T.81, annex B).

use super::huffman::Huffman;
use crate::PhotoError;
use crate::format::Format;

/// Index within a block of each coefficient, in stored order.
pub(crate) const ZIGZAG: [u8; 64] = [
    0, 1, 8, 16, 9, 2, 3, 10, 17, 24, 32, 25, 18, 11, 4, 5, 12, 19, 26, 33, 40, 48, 41, 34, 27, 20, 13, 6, 7, 14, 21,
    28, 35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51, 58, 59, 52, 45, 38, 31, 39, 46, 53, 60, 61, 54,
    47, 55, 62, 63,
];

pub(crate) struct Frame {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) progressive: bool,
    pub(crate) components: Vec<Component>,
    /// Largest sampling factors, horizontal and vertical.
    pub(crate) largest: [usize; 2],
}

pub(crate) struct Component {
    pub(crate) id: u8,
    /// Sampling factors, horizontal and vertical.
    pub(crate) sampling: [usize; 2],
    pub(crate) quantisation: usize,
}

/// Scan header: components and coefficients of a scan.
pub(crate) struct Scan {
    pub(crate) components: Vec<ScanComponent>,
    pub(crate) first: usize,
    pub(crate) last: usize,
    /// Successive approximation: point transform of the preceding scan; 0 in the first.
    pub(crate) high: u8,
    /// Point transform of this scan: number of low bits left out.
    pub(crate) low: u8,
}

/// Indices of a component and its Huffman tables.
#[derive(Clone, Copy)]
pub(crate) struct ScanComponent {
    pub(crate) index: usize,
    pub(crate) dc: usize,
    pub(crate) ac: usize,
}

/// Tables that later segments refer to.
#[derive(Default)]
pub(crate) struct Tables {
    /// In zigzag order.
    pub(crate) quantisation: [Option<[u16; 64]>; 4],
    pub(crate) dc: [Option<Box<Huffman>>; 4],
    pub(crate) ac: [Option<Box<Huffman>>; 4],
    /// Coded units between restart markers; 0 if there are none.
    pub(crate) restart_interval: usize,
}

impl Frame {
    /// Reads a frame header.
    ///
    /// # Errors
    /// [`PhotoError::UnsupportedFeature`] for valid headers that are not supported, otherwise [`PhotoError::Damaged`].
    pub(crate) fn read(segment: &[u8], progressive: bool) -> Result<Self, PhotoError> {
        let (&[precision, h1, h0, w1, w0, count], listed) =
            segment.split_first_chunk().ok_or_else(|| broken("the frame header is too short"))?;
        let (width, height) = (usize::from(u16::from_be_bytes([w1, w0])), usize::from(u16::from_be_bytes([h1, h0])));
        match (precision, height, count) {
            (8, 1.., 1 | 3 | 4) if width > 0 && listed.len() == 3 * usize::from(count) => {}
            (8, 0, _) if width > 0 => return Err(unsupported("the height is stored after the pixels".to_owned())),
            (8, _, 2 | 5..) => return Err(unsupported(format!("{count} components"))),
            (2..=16, ..) if precision != 8 => return Err(unsupported(format!("{precision} bits per sample"))),
            _ => return Err(broken("the frame header is inconsistent")),
        }
        let components: Vec<Component> = listed.as_chunks().0.iter().map(Component::read).collect::<Result<_, _>>()?;
        let largest = [0, 1].map(|axis| components.iter().map(|component| component.sampling[axis]).max().unwrap_or(1));
        match components
            .iter()
            .find(|component| [0, 1].iter().any(|&axis| largest[axis] % component.sampling[axis] != 0))
        {
            None => Ok(Self { width, height, progressive, components, largest }),
            Some(Component { sampling: [h, v], .. }) => {
                Err(unsupported(format!("a component sampled {h}×{v} next to {}×{}", largest[0], largest[1])))
            }
        }
    }

    /// Size of a component in samples.
    pub(crate) fn samples(&self, component: &Component) -> [usize; 2] {
        let scaled = |side: usize, axis: usize| (side * component.sampling[axis]).div_ceil(self.largest[axis]);
        [scaled(self.width, 0), scaled(self.height, 1)]
    }

    /// Number of minimum coded units, horizontal and vertical.
    pub(crate) fn units(&self) -> [usize; 2] {
        [self.width.div_ceil(8 * self.largest[0]), self.height.div_ceil(8 * self.largest[1])]
    }
}

impl Component {
    fn read(&[id, sampling, quantisation]: &[u8; 3]) -> Result<Self, PhotoError> {
        let sampling = [sampling >> 4, sampling & 15].map(usize::from);
        match sampling.iter().all(|factor| (1..=4).contains(factor)) && quantisation < 4 {
            true => Ok(Self { id, sampling, quantisation: quantisation.into() }),
            false => Err(broken("the frame header is inconsistent")),
        }
    }
}

impl Scan {
    pub(crate) fn read(segment: &[u8], frame: &Frame) -> Option<Self> {
        let (&count, rest) = segment.split_first()?;
        let (listed, rest) = rest.split_at_checked(2 * usize::from(count))?;
        let &[first, last, bits] = rest.first_chunk()?;
        let components = listed.as_chunks().0.iter().map(|component| ScanComponent::read(component, frame));
        let components: Vec<ScanComponent> = components.collect::<Option<_>>()?;
        let repeats = |at: usize| components[..at].iter().any(|other| other.index == components[at].index);
        if components.is_empty() || (0..components.len()).any(repeats) {
            return None;
        }
        if !frame.progressive {
            return Some(Self { components, first: 0, last: 63, high: 0, low: 0 });
        }
        let band = first == 0 && last == 0 || first > 0 && first <= last && last < 64 && components.len() == 1;
        let (high, low) = (bits >> 4, bits & 15);
        let (first, last) = (first.into(), last.into());
        (band && low <= 13 && (high == 0 || high == low + 1)).then_some(Self { components, first, last, high, low })
    }
}

impl ScanComponent {
    fn read(&[id, tables]: &[u8; 2], frame: &Frame) -> Option<Self> {
        let index = frame.components.iter().position(|component| component.id == id)?;
        let [dc, ac] = [tables >> 4, tables & 15].map(usize::from);
        (dc < 4 && ac < 4).then_some(Self { index, dc, ac })
    }
}

impl Tables {
    /// Reads a DQT segment; `None` if it is malformed.
    pub(crate) fn read_quantisation(&mut self, mut segment: &[u8]) -> Option<()> {
        while let Some((&kind, rest)) = segment.split_first() {
            let bytes = if kind >> 4 == 0 { 1 } else { 2 };
            let (values, rest) = rest.split_at_checked(64 * bytes)?;
            let value = |digits: &[u8]| digits.iter().fold(0, |value, &byte| value << 8 | u16::from(byte));
            let table = std::array::from_fn(|k| value(&values[k * bytes..][..bytes]));
            *self.quantisation.get_mut(usize::from(kind & 15))? = Some(table);
            segment = rest;
        }
        Some(())
    }

    /// Reads a DHT segment; `None` if it is malformed.
    pub(crate) fn read_huffman(&mut self, mut segment: &[u8]) -> Option<()> {
        while let Some((&kind, rest)) = segment.split_first() {
            let (counts, rest) = rest.split_first_chunk::<16>()?;
            let (symbols, rest) = rest.split_at_checked(counts.iter().map(|&count| usize::from(count)).sum())?;
            let tables = if kind >> 4 == 0 { &mut self.dc } else { &mut self.ac };
            *tables.get_mut(usize::from(kind & 15))? = Some(Huffman::new(counts, symbols)?);
            segment = rest;
        }
        Some(())
    }

    /// Reads a DRI segment; `None` if it is malformed.
    pub(crate) fn read_restart_interval(&mut self, segment: &[u8]) -> Option<()> {
        self.restart_interval = u16::from_be_bytes(*segment.first_chunk()?).into();
        Some(())
    }
}

pub(crate) fn broken(reason: &str) -> PhotoError {
    Format::Jpeg.damaged(reason)
}

pub(crate) fn unsupported(reason: String) -> PhotoError {
    Format::Jpeg.unsupported(reason)
}
