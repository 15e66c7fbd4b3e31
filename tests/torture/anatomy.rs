//! Where a file's parts and numbers are, so that mutations hit what readers rely on.

use std::ops::Range;

/// How a file is built.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    Jpeg,
    Png,
    WebP,
    Icc,
    Glb,
    /// A line of JSON, landmarks, colours, a PNG.
    Project,
    Json,
    /// Only bytes.
    Plain,
}

/// Parts that can be moved about, and the numbers that say how long or large something is.
#[derive(Debug, Default, PartialEq)]
pub struct Anatomy {
    pub parts: Vec<Range<usize>>,
    pub fields: Vec<Field>,
}

/// A whole number in the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Field {
    pub at: usize,
    /// 1, 2 or 4 bytes.
    pub width: usize,
    pub order: Order,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    Big,
    Little,
}

impl Field {
    pub fn read(self, bytes: &[u8]) -> Option<u32> {
        let digits = bytes.get(self.at..self.at.checked_add(self.width)?)?.iter();
        let join = |value: u32, digit: &u8| value << 8 | u32::from(*digit);
        Some(match self.order {
            Order::Big => digits.fold(0, join),
            Order::Little => digits.rev().fold(0, join),
        })
    }

    pub fn write(self, bytes: &mut [u8], value: u32) {
        let Some(place) = bytes.get_mut(self.at..self.at + self.width) else { return };
        match self.order {
            Order::Big => place.copy_from_slice(&value.to_be_bytes()[4 - self.width..]),
            Order::Little => place.copy_from_slice(&value.to_le_bytes()[..self.width]),
        }
    }
}

/// Looks at a file that may be damaged already.
pub fn of(format: Format, bytes: &[u8]) -> Anatomy {
    match format {
        Format::Jpeg => jpeg(bytes),
        Format::Png => png(bytes),
        Format::WebP => riff(bytes),
        Format::Icc => icc(bytes),
        Format::Glb => glb(bytes),
        Format::Project => project(bytes),
        Format::Json | Format::Plain => Anatomy::default(),
    }
}

/// The chunks of a PNG: where each begins and ends.
pub fn png_chunks(bytes: &[u8]) -> Vec<Range<usize>> {
    let mut chunks = Vec::new();
    let mut at = 8;
    while let Some(length) = big(at, 4).read(bytes) {
        let end = at.saturating_add(12).saturating_add(length as usize);
        if end > bytes.len() {
            break;
        }
        chunks.push(at..end);
        at = end;
    }
    chunks
}

/// Where the text is in a file that has text.
pub fn json(format: Format, bytes: &[u8]) -> Option<Range<usize>> {
    match format {
        Format::Json => Some(0..bytes.len()),
        Format::Project => Some(0..bytes.iter().position(|&byte| byte == b'\n')?),
        Format::Glb => {
            let end = 20_usize.checked_add(little(12, 4).read(bytes)? as usize)?;
            (end <= bytes.len()).then_some(20..end)
        }
        _ => None,
    }
}

/// Where a PNG begins in a file that has one.
pub fn png_in(format: Format, bytes: &[u8]) -> Option<usize> {
    match format {
        Format::Png => Some(0),
        Format::Project => bytes.windows(4).position(|window| window == b"\x89PNG"),
        _ => None,
    }
}

fn big(at: usize, width: usize) -> Field {
    Field { at, width, order: Order::Big }
}

fn little(at: usize, width: usize) -> Field {
    Field { at, width, order: Order::Little }
}

fn jpeg(bytes: &[u8]) -> Anatomy {
    const START_OF_SCAN: u8 = 0xDA;
    const FRAMES: std::ops::RangeInclusive<u8> = 0xC0..=0xC2;
    let mut anatomy = Anatomy::default();
    let mut at = 2;
    while let (Some(0xFF), Some(&marker), Some(length)) = (bytes.get(at), bytes.get(at + 1), big(at + 2, 2).read(bytes))
    {
        let end = at + 2 + length as usize;
        anatomy.fields.push(big(at + 2, 2));
        if FRAMES.contains(&marker) {
            anatomy.fields.extend([big(at + 5, 2), big(at + 7, 2), big(at + 9, 1), big(at + 11, 1)]);
        }
        if end > bytes.len() {
            break;
        }
        anatomy.parts.push(at..end);
        if marker == START_OF_SCAN {
            anatomy.parts.push(end..bytes.len());
            break;
        }
        at = end;
    }
    anatomy
}

fn png(bytes: &[u8]) -> Anatomy {
    let parts = png_chunks(bytes);
    let lengths = parts.iter().map(|chunk| big(chunk.start, 4));
    let header = [(16, 4), (20, 4), (24, 1), (25, 1), (28, 1)].map(|(at, width)| big(at, width));
    let animation = parts.iter().filter(|chunk| &bytes[chunk.start + 4..chunk.start + 8] == b"fcTL");
    let frames = animation.flat_map(|chunk| (0..5).map(|field| big(chunk.start + 8 + 4 * field, 4)));
    Anatomy { fields: lengths.chain(header).chain(frames).collect(), parts }
}

fn project(bytes: &[u8]) -> Anatomy {
    let start = png_in(Format::Project, bytes).unwrap_or(bytes.len());
    let picture = png(&bytes[start..]);
    let line = json(Format::Project, bytes).map_or(0, |line| line.end + 1).min(start);
    let chunks = picture.parts.iter().map(|chunk| start + chunk.start..start + chunk.end);
    let fields = picture.fields.iter().map(|field| Field { at: start + field.at, ..*field });
    Anatomy { parts: [0..line, line..start].into_iter().chain(chunks).collect(), fields: fields.collect() }
}

fn riff(bytes: &[u8]) -> Anatomy {
    let mut anatomy = Anatomy { fields: vec![little(4, 4)], parts: Vec::new() };
    let mut at = 12;
    while let Some(length) = little(at + 4, 4).read(bytes) {
        let end = at.saturating_add(8).saturating_add(length as usize).saturating_add(length as usize % 2);
        // Sizes stand in the first bytes of a chunk, in whatever width.
        anatomy.fields.extend([little(at + 4, 4), little(at + 9, 4), little(at + 12, 2), little(at + 15, 2)]);
        if end > bytes.len() {
            break;
        }
        anatomy.parts.push(at..end);
        at = end;
    }
    anatomy
}

fn icc(bytes: &[u8]) -> Anatomy {
    let count = big(128, 4).read(bytes).unwrap_or(0).min(64) as usize;
    let entries = (0..count).map(|entry| 132 + 12 * entry).filter(|at| at + 12 <= bytes.len());
    let mut anatomy = Anatomy { fields: vec![big(0, 4), big(128, 4)], parts: Vec::new() };
    for entry in entries {
        let (offset, size) = (big(entry + 4, 4), big(entry + 8, 4));
        anatomy.fields.extend([offset, size]);
        anatomy.parts.push(entry..entry + 12);
        let (Some(start), Some(length)) = (offset.read(bytes), size.read(bytes)) else { continue };
        let start = start as usize;
        if let Some(end) = start.checked_add(length as usize).filter(|&end| end <= bytes.len()) {
            anatomy.parts.push(start..end);
            // The number of samples of a curve, the kind of a parametric one, its numbers.
            anatomy.fields.extend([big(start + 8, 4), big(start + 8, 2), big(start + 12, 4), big(start + 16, 4)]);
        }
    }
    anatomy
}

fn glb(bytes: &[u8]) -> Anatomy {
    let mut anatomy = Anatomy { fields: vec![little(4, 4), little(8, 4)], parts: Vec::new() };
    let mut at = 12;
    while let Some(length) = little(at, 4).read(bytes) {
        let end = at.saturating_add(8).saturating_add(length as usize);
        anatomy.fields.push(little(at, 4));
        if end > bytes.len() {
            break;
        }
        anatomy.parts.push(at..end);
        at = end;
    }
    anatomy
}
