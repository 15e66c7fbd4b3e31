//! A reader for the part of the FlatBuffers format that TFLite files use, with bounds checks.
//!
//! Numbers are little-endian. An offset is a u32 relative to its own position. A table starts with an i32, the distance
//! back to its vtable: u16 size, u16 table size, then one u16 per field, 0 for an absent field.

use crate::ImportError;

/// A table of the file.
#[derive(Clone, Copy)]
pub(crate) struct Table<'a> {
    file: &'a [u8],
    position: usize,
}

impl<'a> Table<'a> {
    /// Returns the root table of a file whose bytes 4..8 are `identifier`.
    pub(crate) fn root(file: &'a [u8], identifier: [u8; 4]) -> Result<Self, ImportError> {
        if file.get(4..8) != Some(identifier.as_slice()) {
            return Err(ImportError::Damaged { what: "file identifier", offset: 4 });
        }
        Ok(Self { file, position: follow(file, 0, "root table")? })
    }

    /// An i8 field, `default` if absent.
    pub(crate) fn i8(&self, field: usize, default: i8) -> Result<i8, ImportError> {
        let position = self.field(field)?;
        position.map_or(Ok(default), |at| Ok(i8::from_le_bytes(read(self.file, at, "i8 field")?)))
    }

    /// An i32 field, `default` if absent.
    pub(crate) fn i32(&self, field: usize, default: i32) -> Result<i32, ImportError> {
        let position = self.field(field)?;
        position.map_or(Ok(default), |at| Ok(i32::from_le_bytes(read(self.file, at, "i32 field")?)))
    }

    /// A u32 field used as an index, 0 if absent.
    pub(crate) fn index(&self, field: usize) -> Result<usize, ImportError> {
        let position = self.field(field)?;
        position.map_or(Ok(0), |at| Ok(u32::from_le_bytes(read(self.file, at, "u32 field")?) as usize))
    }

    /// A table field.
    pub(crate) fn table(&self, field: usize) -> Result<Option<Self>, ImportError> {
        let Some(at) = self.field(field)? else { return Ok(None) };
        Ok(Some(Self { file: self.file, position: follow(self.file, at, "table field")? }))
    }

    /// A vector of tables, empty if absent.
    pub(crate) fn tables(&self, field: usize) -> Result<Vec<Self>, ImportError> {
        let Some((start, length)) = self.vector(field, 4)? else { return Ok(Vec::new()) };
        let table = |i| Ok(Self { file: self.file, position: follow(self.file, start + 4 * i, "table in a vector")? });
        (0..length).map(table).collect()
    }

    /// A vector of i32, empty if absent.
    pub(crate) fn i32s(&self, field: usize) -> Result<Vec<i32>, ImportError> {
        let Some((start, length)) = self.vector(field, 4)? else { return Ok(Vec::new()) };
        let number = |i| Ok(i32::from_le_bytes(read(self.file, start + 4 * i, "i32 in a vector")?));
        (0..length).map(number).collect()
    }

    /// A vector of bytes or a string, empty if absent.
    pub(crate) fn bytes(&self, field: usize) -> Result<&'a [u8], ImportError> {
        let Some((start, length)) = self.vector(field, 1)? else { return Ok(&[]) };
        Ok(&self.file[start..start + length])
    }

    /// Position and number of a vector's elements, which lie inside the file.
    fn vector(&self, field: usize, element_bytes: usize) -> Result<Option<(usize, usize)>, ImportError> {
        let Some(at) = self.field(field)? else { return Ok(None) };
        let length_at = follow(self.file, at, "vector field")?;
        let length = u32::from_le_bytes(read(self.file, length_at, "vector length")?) as usize;
        let start = length_at + 4;
        let end = length.checked_mul(element_bytes).and_then(|bytes| bytes.checked_add(start));
        match end {
            Some(end) if end <= self.file.len() => Ok(Some((start, length))),
            _ => Err(ImportError::Damaged { what: "vector length", offset: length_at }),
        }
    }

    /// Position of a field, `None` if absent.
    fn field(&self, field: usize) -> Result<Option<usize>, ImportError> {
        let damaged = ImportError::Damaged { what: "vtable", offset: self.position };
        let back = i32::from_le_bytes(read(self.file, self.position, "table")?);
        let vtable = (self.position as i64).checked_sub(i64::from(back)).and_then(|at| usize::try_from(at).ok());
        let vtable = vtable.ok_or(damaged)?;
        let vtable_bytes = usize::from(u16::from_le_bytes(read(self.file, vtable, "vtable size")?));
        let entry = 4 + 2 * field;
        if entry + 2 > vtable_bytes {
            return Ok(None);
        }
        let offset = usize::from(u16::from_le_bytes(read(self.file, vtable + entry, "vtable entry")?));
        Ok((offset != 0).then_some(self.position + offset))
    }
}

fn follow(file: &[u8], at: usize, what: &'static str) -> Result<usize, ImportError> {
    let offset = u32::from_le_bytes(read(file, at, what)?) as usize;
    at.checked_add(offset).filter(|&target| target < file.len()).ok_or(ImportError::Damaged { what, offset: at })
}

fn read<const N: usize>(file: &[u8], at: usize, what: &'static str) -> Result<[u8; N], ImportError> {
    let bytes = at.checked_add(N).and_then(|end| file.get(at..end));
    bytes.and_then(|bytes| bytes.try_into().ok()).ok_or(ImportError::Damaged { what, offset: at })
}
