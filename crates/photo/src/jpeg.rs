//! JPEG files of the baseline, extended sequential and progressive processes with Huffman codes and 8 bits a sample
//! (ITU-T T.81), decoded in one pass to the same pixels as libjpeg.
//!
//! Other decoders fill what is missing with grey and call it a success; half a face is of no use here. So each scan reports
//! which rows are intact in it, and a picture with fewer than 95 % of them is damaged.

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
use header::{Frame, Scan, Tables, broken, unread};
use metadata::Metadata;
use plane::Plane;
use progress::Progress;
use rows::Rows;
use segments::Segments;
use upsample::Upsampler;

/// One row of so many may be lost.
const ROWS_FOR_EACH_LOST: usize = 20;
const ENDS_EARLY: &str = "it ends before its last row";

pub(crate) fn decode(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    let mut segments = Segments { bytes: without_filler(bytes), position: 0 };
    let (mut tables, mut metadata) = (Tables::default(), Metadata::default());
    let frame = loop {
        let (marker, segment) = segments.next().ok_or_else(|| broken("it ends before its header"))?;
        match marker {
            0xC0..=0xC2 => break Frame::read(segment, marker == 0xC2)?,
            _ => see(marker, segment, &mut tables, &mut metadata)?,
        }
    };
    limits.check_size(frame.width as u32, frame.height as u32)?;
    let mut picture = Picture::new(&frame);
    while let Some((marker, segment)) = segments.next().filter(|&(marker, _)| marker != segments::END) {
        let seen = match marker {
            segments::SCAN => picture.decode_scan(segment, &mut segments, &tables),
            _ => see(marker, segment, &mut tables, &mut metadata),
        };
        match seen {
            Ok(()) => {}
            // Whatever comes after damaged data may be data.
            Err(_) if picture.rows.intact() < frame.height => break,
            Err(error) => return Err(error),
        }
    }
    picture.stored(metadata)?.upright()
}

/// Takes in what a segment says that is neither a frame nor a scan.
fn see<'a>(marker: u8, segment: &'a [u8], tables: &mut Tables, metadata: &mut Metadata<'a>) -> Result<(), PhotoError> {
    let contradictory = || broken("its tables contradict themselves");
    match marker {
        0xC4 => tables.read_huffman(segment).ok_or_else(contradictory),
        0xDB => tables.read_quantisation(segment).ok_or_else(contradictory),
        0xDD => tables.read_restart_interval(segment).ok_or_else(contradictory),
        0xE0..=0xEF => {
            metadata.see(marker, segment);
            Ok(())
        }
        0xC0..=0xC2 => Err(broken("it has two headers")),
        _ => process(marker).map_or(Ok(()), |process| Err(unread(process.to_owned()))),
    }
}

/// The name of a process that is not read, by the marker that begins its frame.
fn process(marker: u8) -> Option<&'static str> {
    match marker {
        0xC3 => Some("lossless coding"),
        0xC5..=0xC7 | 0xDE => Some("hierarchical coding"),
        0xC9..=0xCB | 0xCD..=0xCF => Some("arithmetic coding"),
        0xF7 => Some("JPEG-LS coding"),
        _ => None,
    }
}

/// Without zeros that a copy was filled up with.
fn without_filler(bytes: &[u8]) -> &[u8] {
    /// A scan may end with a zero, but hardly with so many.
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
        let scan = Scan::read(segment, self.frame).ok_or_else(|| broken("a scan contradicts itself"))?;
        self.progress.see(&scan).ok_or_else(|| broken("its scans contradict each other"))?;
        for of in &scan.components {
            let table = tables.quantisation[self.frame.components[of.index].quantisation];
            let plane = &mut self.planes[of.index];
            plane.quantisation = plane.quantisation.or(table.map(|table| table.map(i32::from)));
        }
        let data = (segments.bytes, segments.position);
        segments.position = scan::decode(data, self.frame, &scan, tables, &mut self.planes, &mut self.rows)
            .ok_or_else(|| unread("its tables are in another file".to_owned()))?;
        Ok(())
    }

    fn stored(mut self, metadata: Metadata<'_>) -> Result<Stored, PhotoError> {
        let Frame { width, height, .. } = *self.frame;
        let intact = self.rows.intact();
        if !self.progress.is_nearly_complete() || self.rows.ends_early && self.is_damaged() {
            return Err(broken(ENDS_EARLY));
        }
        if self.is_damaged() {
            return Err(broken(&format!("{intact} of its {height} rows are intact")));
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
        (self.frame.height - self.rows.intact()) * ROWS_FOR_EACH_LOST > self.frame.height
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
