//! The rows of an element, column by column.

use meshmend_core::{Carry, Domain, Layer, Values};

use crate::ReadError;
use crate::formats::ply::data::Data;
use crate::formats::ply::header::{Element, Property};

/// The values of the columns of an element.
pub(super) struct Columns {
    /// As many as there are properties. A column that is read in another way is empty.
    pub(super) values: Vec<Values>,
}

impl Columns {
    pub(super) fn new(element: &Element) -> Self {
        let empty = |property: &Property| match property.length {
            None => property.item.empty(),
            Some(_) => Values::Lists { starts: vec![0], items: Box::new(property.item.empty()) },
        };
        Columns { values: element.properties.iter().map(empty).collect() }
    }

    /// Reads the next value or list of a column.
    #[inline]
    pub(super) fn read(
        &mut self,
        element: &Element,
        column: usize,
        data: &mut impl Data,
    ) -> Result<(), ReadError> {
        let property = &element.properties[column];
        match (property.length, &mut self.values[column]) {
            (Some(length), Values::Lists { starts, items }) => {
                let at = data.at();
                let count = data.length(length, property.item)?;
                (0..count).try_for_each(|_| data.push(property.item, items))?;
                let end = u32::try_from(items.len());
                starts.push(end.map_err(|_| data.wrong(at, "lists of more items than can be held"))?);
                Ok(())
            }
            (_, values) => data.push(property.item, values),
        }
    }

    /// Appends rows of numbers to columns of numbers, in the order of the columns.
    pub(super) fn append(&mut self, columns: impl Iterator<Item = usize> + Clone, rows: &[f64]) {
        let width = columns.clone().count();
        for (offset, column) in columns.enumerate() {
            extend(&mut self.values[column], rows.iter().skip(offset).step_by(width).copied());
        }
    }
}

/// Appends numbers, all of which have the type of the values.
fn extend(values: &mut Values, numbers: impl Iterator<Item = f64>) {
    match values {
        Values::I8(v) => v.extend(numbers.map(|x| x as i8)),
        Values::U8(v) => v.extend(numbers.map(|x| x as u8)),
        Values::I16(v) => v.extend(numbers.map(|x| x as i16)),
        Values::U16(v) => v.extend(numbers.map(|x| x as u16)),
        Values::I32(v) => v.extend(numbers.map(|x| x as i32)),
        Values::U32(v) => v.extend(numbers.map(|x| x as u32)),
        Values::F32(v) => v.extend(numbers.map(|x| x as f32)),
        Values::F64(v) => v.extend(numbers),
        Values::Text(_) | Values::Lists { .. } => {}
    }
}

impl Columns {
    /// One layer for each column. Each row has its own value.
    pub(super) fn into_layers(self, element: &Element) -> Vec<Layer> {
        let columns = self.values.into_iter().zip(&element.properties);
        let layer = |(values, property): (Values, &Property)| {
            Layer::direct(property.name.clone(), Domain::Face, 1, Carry::Clear, values)
        };
        columns.map(layer).collect()
    }
}

/// Skips the next value or list.
pub(super) fn skip_property(property: &Property, data: &mut impl Data) -> Result<(), ReadError> {
    let count = match property.length {
        None => 1,
        Some(length) => data.length(length, property.item)?,
    };
    (0..count).try_for_each(|_| data.number(property.item).map(drop))
}
