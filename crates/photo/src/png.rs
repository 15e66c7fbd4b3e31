//! PNG decoding.

use std::io::{Cursor, ErrorKind};

use image::ColorType;
use png::{BitDepth, DecodingError, Info, InterlaceInfo, Reader, Transformations};

use crate::code_points::{CodePoints, ColourEncoding, encoding_from_gamma};
use crate::format::Format;
use crate::primaries::Primaries;
use crate::stored::Stored;
use crate::{Limits, Photo, PhotoError, icc, pixels};

type Source<'a> = Cursor<&'a [u8]>;

pub(crate) fn decode(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    // Checked here as well, because the decoder reads up to the pixel data before it returns the size.
    if let Some((width, height)) = size(bytes) {
        limits.check_size(width, height)?;
    }
    check_kind(bytes)?;
    let mut reader = reader(bytes, limits)?;
    let (width, height) = reader.info().size();
    limits.check_size(width, height)?;
    check_palette(reader.info())?;
    let layout = layout(&reader)?;
    let mut decoded = vec![0; width as usize * height as usize * usize::from(layout.bytes_per_pixel())];
    read_rows(&mut reader, layout, &mut decoded)?;
    let (rgb, alpha) = pixels::to_rgb(decoded, layout).ok_or_else(|| unsupported(layout))?;
    let exif = reader.info().exif_metadata.as_deref().unwrap_or_default().to_vec();
    Stored { width, height, rgb, alpha, colours: encoding(reader.info(), layout)?, exif }.upright()
}

/// Width and height from the header chunk, which has to come first.
fn size(bytes: &[u8]) -> Option<(u32, u32)> {
    let header = bytes.get(12..24)?.strip_prefix(b"IHDR")?;
    let number = |at: usize| u32::from_be_bytes([header[at], header[at + 1], header[at + 2], header[at + 3]]);
    Some((number(0), number(4)))
}

/// Refuses files that the standard does not cover: an unknown method in the header, or an unknown critical chunk, such
/// as the first chunk of Apple's CgBI variant.
fn check_kind(bytes: &[u8]) -> Result<(), PhotoError> {
    const KNOWN: [&[u8; 4]; 4] = [b"IHDR", b"PLTE", b"IDAT", b"IEND"];
    for (name, content) in chunks(bytes).take_while(|(name, _)| name != b"IDAT") {
        let method = |at: usize, most: u8| content.get(at).is_some_and(|&method| method > most);
        if name[0].is_ascii_uppercase() && !KNOWN.contains(&&name) {
            return Err(Format::Png.unsupported(format!("the critical chunk {}", name.escape_ascii())));
        }
        if &name == b"IHDR" && (method(10, 0) || method(11, 0) || method(12, 1)) {
            return Err(Format::Png.unsupported("a non-standard compression, filter or interlace method"));
        }
    }
    Ok(())
}

/// Names and contents of the chunks, up to the first damaged one.
fn chunks(bytes: &[u8]) -> impl Iterator<Item = ([u8; 4], &[u8])> {
    let mut rest = bytes.get(8..).unwrap_or_default();
    std::iter::from_fn(move || {
        let (length, after) = rest.split_first_chunk()?;
        let (named, after) = after.split_at_checked((u32::from_be_bytes(*length) as usize).checked_add(4)?)?;
        let (checksum, after) = after.split_first_chunk()?;
        let (&name, content) = named.split_first_chunk()?;
        rest = after;
        // Pixel data is not read twice for its checksum.
        (&name == b"IDAT" || crc32fast::hash(named) == u32::from_be_bytes(*checksum)).then_some((name, content))
    })
}

fn reader<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Reader<Source<'a>>, PhotoError> {
    /// Allowance for metadata, mainly a compressed colour profile.
    const METADATA_BYTES: u64 = 16_000_000;
    let most = limits.max_pixels.saturating_mul(8).saturating_add(METADATA_BYTES);
    let most = png::Limits { bytes: usize::try_from(most).unwrap_or(usize::MAX) };
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), most);
    decoder.set_ignore_text_chunk(true);
    decoder.set_transformations(Transformations::EXPAND);
    decoder.read_info().map_err(|error| decode_error(&error, "the data ends before the first row"))
}

/// Refuses a palette with a partial colour, on which the decoder panics. The decoder itself refuses an empty or
/// oversized palette.
fn check_palette(info: &Info<'_>) -> Result<(), PhotoError> {
    match info.palette.as_deref().map_or(0, <[u8]>::len) {
        bytes if info.color_type == png::ColorType::Indexed && !bytes.is_multiple_of(3) => {
            Err(Format::Png.damaged(format!("{bytes} bytes of palette are not a multiple of three")))
        }
        _ => Ok(()),
    }
}

/// Pixel layout of the decoder's output.
fn layout(reader: &Reader<Source<'_>>) -> Result<ColorType, PhotoError> {
    let (colour, depth) = reader.output_color_type();
    match (colour, depth) {
        (png::ColorType::Grayscale, BitDepth::Eight) => Ok(ColorType::L8),
        (png::ColorType::Grayscale, BitDepth::Sixteen) => Ok(ColorType::L16),
        (png::ColorType::GrayscaleAlpha, BitDepth::Eight) => Ok(ColorType::La8),
        (png::ColorType::GrayscaleAlpha, BitDepth::Sixteen) => Ok(ColorType::La16),
        (png::ColorType::Rgb, BitDepth::Eight) => Ok(ColorType::Rgb8),
        (png::ColorType::Rgb, BitDepth::Sixteen) => Ok(ColorType::Rgb16),
        (png::ColorType::Rgba, BitDepth::Eight) => Ok(ColorType::Rgba8),
        (png::ColorType::Rgba, BitDepth::Sixteen) => Ok(ColorType::Rgba16),
        other => Err(unsupported(other)),
    }
}

/// Reads all rows, big-endian. The file may be truncated after the last row.
fn read_rows(reader: &mut Reader<Source<'_>>, layout: ColorType, decoded: &mut [u8]) -> Result<(), PhotoError> {
    let (width, height) = reader.info().size();
    if let Some(frame) = reader.info().frame_control.filter(|frame| (frame.width, frame.height) != (width, height)) {
        let sizes =
            format!("its first frame is {}×{} px, but the picture is {width}×{height} px", frame.width, frame.height);
        return Err(Format::Png.damaged(sizes));
    }
    let row_bytes = width as usize * usize::from(layout.bytes_per_pixel());
    let mut filled = 0;
    loop {
        match reader.next_interlaced_row() {
            Ok(Some(row)) => {
                let data = row.data();
                match row.interlace() {
                    InterlaceInfo::Null(_) => decoded[filled..filled + data.len()].copy_from_slice(data),
                    InterlaceInfo::Adam7(pass) => {
                        png::expand_interlaced_row(decoded, row_bytes, data, pass, layout.bits_per_pixel() as u8);
                    }
                }
                filled += data.len();
            }
            Ok(None) => return Ok(()),
            Err(error) if is_end(&error) && filled == decoded.len() => return Ok(()),
            Err(error) => {
                return Err(decode_error(
                    &error,
                    &format!("the data ends after {} of {height} rows", filled / row_bytes),
                ));
            }
        }
    }
}

/// Returns the colour encoding of the file: the first supported one of code points, profile, sRGB, and gamma with
/// primaries.
///
/// Refuses a file whose only description is an unsupported transfer curve, since its colours would be wrong.
fn encoding(info: &Info<'_>, layout: ColorType) -> Result<ColourEncoding, PhotoError> {
    let points = info.coding_independent_code_points.as_ref().map(|points| CodePoints {
        primaries: points.color_primaries,
        transfer: points.transfer_function,
        full_range: points.is_video_full_range_image,
    });
    let encoding = match points.map_or(ColourEncoding::Unspecified, CodePoints::encoding) {
        ColourEncoding::Unspecified => encoding_without_code_points(info, layout),
        encoding => encoding,
    };
    match (encoding, points) {
        (ColourEncoding::Unspecified, Some(points)) if points.has_unsupported_curve() => {
            Err(Format::Png.unsupported(format!("transfer characteristics {} of H.273", points.transfer)))
        }
        (encoding, _) => Ok(encoding),
    }
}

fn encoding_without_code_points(info: &Info<'_>, layout: ColorType) -> ColourEncoding {
    if let Some(profile) = &info.icc_profile {
        return icc::encoding(profile, layout);
    }
    if info.srgb.is_some() {
        return ColourEncoding::Srgb;
    }
    let value = |number: png::ScaledFloat| f64::from(number.into_scaled()) / 100_000.0;
    let point = |(x, y): (png::ScaledFloat, png::ScaledFloat)| [value(x), value(y)];
    let primaries = info.chrm_chunk.map(|chrm| Primaries {
        red: point(chrm.red),
        green: point(chrm.green),
        blue: point(chrm.blue),
        white: point(chrm.white),
    });
    encoding_from_gamma(info.gama_chunk.map(value), primaries)
}

fn is_end(error: &DecodingError) -> bool {
    matches!(error, DecodingError::IoError(error) if error.kind() == ErrorKind::UnexpectedEof)
}

fn decode_error(error: &DecodingError, at_the_end: &str) -> PhotoError {
    if is_end(error) { Format::Png.damaged(at_the_end) } else { Format::Png.damaged(error) }
}

fn unsupported(layout: impl std::fmt::Debug) -> PhotoError {
    Format::Png.unsupported(format!("{layout:?} pixels"))
}
