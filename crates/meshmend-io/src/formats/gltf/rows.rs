//! The numbers of accessors, read in bulk.

use meshmend_core::Values;

use crate::formats::gltf::accessor::{Accessor, Component, Sparse};
use crate::formats::gltf::buffers::Bytes;
use crate::formats::gltf::fault::{Fault, Pointer};

/// A number as files store it: the lowest byte first.
pub(super) trait Number: Copy + Default {
    /// How many bytes it has.
    const SIZE: usize;
    /// The number at the start of some bytes; 0 if there are too few.
    fn of(bytes: &[u8]) -> Self;
    /// As a double, exactly.
    fn wide(self) -> f64;
    /// Puts it at the start of some bytes, if they are enough.
    fn put(self, bytes: &mut [u8]);
}

macro_rules! numbers {
    ($($number:ty),*) => {$(
        impl Number for $number {
            const SIZE: usize = size_of::<$number>();
            #[inline]
            fn of(bytes: &[u8]) -> Self {
                bytes.first_chunk().map_or_else(Self::default, |bytes| Self::from_le_bytes(*bytes))
            }
            #[inline]
            fn wide(self) -> f64 {
                f64::from(self)
            }
            fn put(self, bytes: &mut [u8]) {
                bytes.iter_mut().zip(self.to_le_bytes()).for_each(|(byte, own)| *byte = own);
            }
        }
    )*};
}

numbers!(i8, u8, i16, u16, u32, f32);

/// Appends all numbers of an accessor, row by row.
///
/// # Errors
/// If its bytes are not there, or its sparse rows are not in order.
pub(super) fn append<T: Number>(
    accessor: &Accessor,
    bytes: &Bytes<'_>,
    into: &mut Vec<T>,
) -> Result<(), Fault> {
    let (form, count) = (accessor.form, accessor.count);
    let first = into.len();
    match &accessor.place {
        None if count > bytes.total => {
            let reason = format!("{count} rows of zeros are more than the {} bytes of the file", bytes.total);
            return Err(pointer(accessor).fault(reason));
        }
        None => into.resize(first + count * form.width(), T::default()),
        Some(place) => {
            let data = bytes.rows(place, count, form.size())?;
            into.reserve(count * form.width());
            if form.is_packed() && place.stride == form.size() {
                into.extend(data.chunks_exact(T::SIZE).map(T::of));
            } else {
                for row in data.chunks(place.stride) {
                    into.extend(form.places().map(|at| T::of(row.get(at..).unwrap_or_default())));
                }
            }
        }
    }
    match &accessor.sparse {
        Some(sparse) => replace(accessor, sparse, bytes, &mut into[first..]),
        None => Ok(()),
    }
}

/// Puts the sparse rows in their places.
fn replace<T: Number>(
    accessor: &Accessor,
    sparse: &Sparse,
    bytes: &Bytes<'_>,
    numbers: &mut [T],
) -> Result<(), Fault> {
    let (form, width) = (accessor.form, accessor.form.width());
    for (row, new) in sparse_rows(accessor, sparse, bytes)? {
        let numbers = &mut numbers[row * width..][..width];
        numbers
            .iter_mut()
            .zip(form.places())
            .for_each(|(number, at)| *number = T::of(new.get(at..).unwrap_or_default()));
    }
    Ok(())
}

/// The sparse rows, each with the bytes that replace it.
///
/// # Errors
/// If they are not in order, or a row does not exist.
pub(super) fn sparse_rows<'a>(
    accessor: &Accessor,
    sparse: &Sparse,
    bytes: &Bytes<'a>,
) -> Result<Vec<(usize, &'a [u8])>, Fault> {
    if sparse.count == 0 {
        return Ok(Vec::new());
    }
    let (place, component) = &sparse.indices;
    let indices = bytes.rows(place, sparse.count, component.size())?;
    let rows = indices.chunks_exact(component.size()).map(|index| index_in(*component, index) as usize);
    let rows: Vec<usize> = rows.collect();
    let pointer = || pointer(accessor).member("sparse").member("indices");
    if let Some(pair) = rows.windows(2).find(|pair| pair[0] >= pair[1]) {
        return Err(pointer().fault(format!("row {} follows row {}: they must ascend", pair[1], pair[0])));
    }
    if let Some(last) = rows.last().filter(|&&last| last >= accessor.count) {
        return Err(pointer().fault(format!("row {last} does not exist: there are {}", accessor.count)));
    }
    let size = accessor.form.size();
    let values = bytes.rows(&sparse.values, sparse.count, size)?;
    Ok(rows.into_iter().zip(values.chunks(size)).collect())
}

/// A number that is an index.
pub(super) fn index_in(component: Component, bytes: &[u8]) -> u32 {
    match component {
        Component::U8 | Component::I8 => u32::from(u8::of(bytes)),
        Component::U16 | Component::I16 => u32::from(u16::of(bytes)),
        Component::U32 | Component::F32 => u32::of(bytes),
    }
}

/// All numbers of an accessor that holds indices.
///
/// # Errors
/// As [`append`].
pub(super) fn indices(accessor: &Accessor, bytes: &Bytes<'_>) -> Result<Vec<u32>, Fault> {
    fn widened<T: Number + Into<u32>>(accessor: &Accessor, bytes: &Bytes<'_>) -> Result<Vec<u32>, Fault> {
        let mut numbers: Vec<T> = Vec::new();
        append(accessor, bytes, &mut numbers)?;
        Ok(numbers.into_iter().map(Into::into).collect())
    }
    match accessor.form.component {
        Component::U8 => widened::<u8>(accessor, bytes),
        Component::U16 => widened::<u16>(accessor, bytes),
        Component::U32 => {
            let mut numbers = Vec::new();
            append(accessor, bytes, &mut numbers)?;
            Ok(numbers)
        }
        _ => Err(pointer(accessor).member("componentType").fault("is not that of an index")),
    }
}

/// An empty pool for the numbers of an accessor.
pub(super) fn empty_pool(component: Component) -> Values {
    match component {
        Component::I8 => Values::I8(Vec::new()),
        Component::U8 => Values::U8(Vec::new()),
        Component::I16 => Values::I16(Vec::new()),
        Component::U16 => Values::U16(Vec::new()),
        Component::U32 => Values::U32(Vec::new()),
        Component::F32 => Values::F32(Vec::new()),
    }
}

/// Appends all numbers of an accessor to a pool of their type.
///
/// # Errors
/// As [`append`].
pub(super) fn append_to_pool(accessor: &Accessor, bytes: &Bytes<'_>, pool: &mut Values) -> Result<(), Fault> {
    match pool {
        Values::I8(numbers) => append(accessor, bytes, numbers),
        Values::U8(numbers) => append(accessor, bytes, numbers),
        Values::I16(numbers) => append(accessor, bytes, numbers),
        Values::U16(numbers) => append(accessor, bytes, numbers),
        Values::U32(numbers) => append(accessor, bytes, numbers),
        Values::F32(numbers) => append(accessor, bytes, numbers),
        _ => Ok(()),
    }
}

/// Appends the positions that an accessor holds, as doubles, exactly; normalised integers as the fractions that they
/// stand for.
///
/// # Errors
/// If they are not positions, or as [`append`].
pub(super) fn append_positions(
    accessor: &Accessor,
    bytes: &Bytes<'_>,
    into: &mut Vec<[f64; 3]>,
) -> Result<(), Fault> {
    let form = accessor.form;
    if form.width() != 3 || form.component == Component::U32 {
        let reason =
            format!("holds positions as {} of component type {}", form.kind(), form.component.code());
        return Err(pointer(accessor).fault(reason));
    }
    let unit = if form.normalized { unit_of(form.component) } else { 1.0 };
    let packed = form.component == Component::F32 && accessor.sparse.is_none();
    match accessor.place.filter(|place| packed && place.stride == form.size()) {
        Some(place) => {
            let data = bytes.rows(&place, accessor.count, form.size())?;
            let point = |row: &[u8]| [0, 4, 8].map(|at| f32::of(&row[at..]).wide());
            into.reserve(accessor.count);
            into.extend(data.chunks_exact(12).map(point));
            Ok(())
        }
        None => match form.component {
            Component::I8 => widened::<i8>(accessor, bytes, unit, into),
            Component::U8 => widened::<u8>(accessor, bytes, unit, into),
            Component::I16 => widened::<i16>(accessor, bytes, unit, into),
            Component::U16 => widened::<u16>(accessor, bytes, unit, into),
            Component::U32 | Component::F32 => widened::<f32>(accessor, bytes, unit, into),
        },
    }
}

fn widened<T: Number>(
    accessor: &Accessor,
    bytes: &Bytes<'_>,
    unit: f64,
    into: &mut Vec<[f64; 3]>,
) -> Result<(), Fault> {
    let mut numbers: Vec<T> = Vec::new();
    append(accessor, bytes, &mut numbers)?;
    let number = |number: T| if unit == 1.0 { number.wide() } else { (number.wide() / unit).max(-1.0) };
    into.extend(numbers.chunks_exact(3).map(|row| [row[0], row[1], row[2]].map(number)));
    Ok(())
}

/// The integer that stands for 1 in normalised numbers.
pub(super) fn unit_of(component: Component) -> f64 {
    match component {
        Component::I8 => f64::from(i8::MAX),
        Component::U8 => f64::from(u8::MAX),
        Component::I16 => f64::from(i16::MAX),
        Component::U16 => f64::from(u16::MAX),
        Component::U32 | Component::F32 => 1.0,
    }
}

pub(super) fn pointer(accessor: &Accessor) -> Pointer {
    Pointer::item("accessors", accessor.index)
}
