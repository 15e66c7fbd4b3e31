//! JPEG decoder for baseline, extended sequential and progressive files with Huffman coding and 8-bit samples (ITU-T
//! T.81).
//!
//! One pass over the file; the pixels are the same as libjpeg's. Other decoders fill missing data with grey and report
//! success. This one records the intact rows of each scan, and refuses a picture with fewer than 95 % of them.

mod bits;
mod block;
mod colours;
mod header;
mod huffman;
mod idct;
mod metadata;
mod plane;
mod progress;
mod rows;
mod scan;
mod segments;
mod upsample;

use image::ColorType;

use crate::stored::Stored;
use crate::{Limits, Photo, PhotoError, icc};
use colours::Colours;
use header::{Frame, Scan, Tables, broken, unsupported};
use metadata::Metadata;
use plane::Plane;
use progress::Progress;
use rows::Rows;
use segments::Segments;
use upsample::Upsampler;

/// At most one row in this many may be lost.
const ROWS_PER_LOST_ROW: usize = 20;
const ENDS_EARLY: &str = "the data ends before the last row";

pub(crate) fn decode(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    let mut segments = Segments { bytes: without_filler(bytes), position: 0 };
    let (mut tables, mut metadata) = (Tables::default(), Metadata::default());
    let frame = loop {
        let (marker, segment) = segments.next().ok_or_else(|| broken("the data ends before the frame header"))?;
        match marker {
            0xC0..=0xC2 => break Frame::read(segment, marker == 0xC2)?,
            _ => read_segment(marker, segment, &mut tables, &mut metadata)?,
        }
    };
    limits.check_size(frame.width as u32, frame.height as u32)?;
    let mut picture = Picture::new(&frame);
    while let Some((marker, segment)) = segments.next().filter(|&(marker, _)| marker != segments::END) {
        let result = match marker {
            segments::SCAN => picture.decode_scan(segment, &mut segments, &tables),
            _ => read_segment(marker, segment, &mut tables, &mut metadata),
        };
        match result {
            Ok(()) => {}
            // After damaged data, a "marker" may be part of the data.
            Err(_) if picture.rows.intact() < frame.height => break,
            Err(error) => return Err(error),
        }
    }
    picture.stored(metadata)?.upright()
}

/// Reads a segment other than a frame or scan header.
fn read_segment<'a>(
    marker: u8,
    segment: &'a [u8],
    tables: &mut Tables,
    metadata: &mut Metadata<'a>,
) -> Result<(), PhotoError> {
    let inconsistent = || broken("a table is inconsistent");
    match marker {
        0xC4 => tables.read_huffman(segment).ok_or_else(inconsistent),
        0xDB => tables.read_quantisation(segment).ok_or_else(inconsistent),
        0xDD => tables.read_restart_interval(segment).ok_or_else(inconsistent),
        0xE0..=0xEF => {
            metadata.read(marker, segment);
            Ok(())
        }
        0xC0..=0xC2 => Err(broken("there are two frame headers")),
        _ => unsupported_process(marker).map_or(Ok(()), |process| Err(unsupported(process.to_owned()))),
    }
}

/// Name of an unsupported coding process, by the marker of its frame header.
fn unsupported_process(marker: u8) -> Option<&'static str> {
    match marker {
        0xC3 => Some("lossless coding"),
        0xC5..=0xC7 | 0xDE => Some("hierarchical coding"),
        0xC9..=0xCB | 0xCD..=0xCF => Some("arithmetic coding"),
        0xF7 => Some("JPEG-LS coding"),
        _ => None,
    }
}

/// Strips trailing zeros that padded a truncated copy.
fn without_filler(bytes: &[u8]) -> &[u8] {
    /// A scan itself may end with a few zeros.
    const FILLER: usize = 16;
    let end = bytes.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    if bytes.len() - end >= FILLER { &bytes[..end] } else { bytes }
}

struct Picture<'a> {
    frame: &'a Frame,
    planes: Vec<Plane>,
    progress: Progress,
    rows: Rows,
}

impl<'a> Picture<'a> {
    fn new(frame: &'a Frame) -> Self {
        Self {
            frame,
            planes: frame.components.iter().map(|component| Plane::new(frame, component)).collect(),
            progress: Progress::new(frame),
            rows: Rows::new(frame.height),
        }
    }

    fn decode_scan(&mut self, segment: &[u8], segments: &mut Segments<'_>, tables: &Tables) -> Result<(), PhotoError> {
        let scan = Scan::read(segment, self.frame).ok_or_else(|| broken("a scan header is inconsistent"))?;
        self.progress.record(&scan).ok_or_else(|| broken("its scans are inconsistent"))?;
        for selected in &scan.components {
            let table = tables.quantisation[self.frame.components[selected.index].quantisation];
            let plane = &mut self.planes[selected.index];
            plane.quantisation = plane.quantisation.or(table.map(|table| table.map(i32::from)));
        }
        let data = (segments.bytes, segments.position);
        segments.position = scan::decode(data, self.frame, &scan, tables, &mut self.planes, &mut self.rows)
            .ok_or_else(|| unsupported("its tables are not in the file".to_owned()))?;
        Ok(())
    }

    fn stored(mut self, metadata: Metadata<'_>) -> Result<Stored, PhotoError> {
        let Frame { width, height, .. } = *self.frame;
        let intact = self.rows.intact();
        if !self.progress.is_nearly_complete() || self.rows.ends_early && self.is_damaged() {
            return Err(broken(ENDS_EARLY));
        }
        if self.is_damaged() {
            return Err(broken(&format!("only {intact} of {height} rows are intact")));
        }
        if self.frame.progressive {
            self.planes.iter_mut().for_each(Plane::transform);
        }
        let names: Vec<u8> = self.frame.components.iter().map(|component| component.id).collect();
        let colours = Colours::new(names.len(), metadata.jfif, metadata.adobe, &names);
        let layout = if colours == Colours::Grey { ColorType::L8 } else { ColorType::Rgb8 };
        let exif = metadata.exif.unwrap_or_default().to_vec();
        let (width, height, rgb) = (width as u32, height as u32, self.rgb(colours));
        let colours = icc::encoding(&metadata.profile(), layout);
        Ok(Stored { width, height, rgb, alpha: None, colours, exif })
    }

    fn is_damaged(&self) -> bool {
        (self.frame.height - self.rows.intact()) * ROWS_PER_LOST_ROW > self.frame.height
    }

    fn rgb(&self, colours: Colours) -> Vec<u8> {
        let row_bytes = 3 * self.frame.width;
        let mut rgb = vec![0; row_bytes * self.frame.height];
        let components = self.frame.components.iter().zip(&self.planes);
        let mut upsamplers: Vec<Upsampler<'_>> =
            components.map(|(component, plane)| Upsampler::new(self.frame, component, plane)).collect();
        for (y, out) in rgb.chunks_exact_mut(row_bytes).enumerate() {
            let rows: Vec<&[u8]> = upsamplers.iter_mut().map(|upsampler| upsampler.row(y)).collect();
            colours.write_rgb(&rows, out);
        }
        if self.rows.intact() < self.frame.height {
            let blurred_rows = upsamplers.iter().map(Upsampler::blurred_rows).max().unwrap_or(0);
            self.rows.repair(&mut rgb, row_bytes, blurred_rows);
        }
        rgb
    }
}
