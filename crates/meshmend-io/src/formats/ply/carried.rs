//! Elements of unknown meaning: their rows are carried as they are, or skipped.

use crate::ReadError;
use crate::formats::ply::columns::{Columns, skip_property};
use crate::formats::ply::data::{Data, RowReader};
use crate::formats::ply::header::Element;

/// Reads all rows of an element.
pub(super) fn of_rows(element: &Element, data: &mut impl Data) -> Result<Columns, ReadError> {
    let mut columns = Columns::new(element);
    if element.properties.is_empty() {
        return Ok(columns);
    }
    let sizes = element.properties.iter().map(|property| property.item.size());
    let offsets = sizes.scan(0, |end, size| Some(std::mem::replace(end, *end + size)));
    let offsets: Vec<usize> = offsets.collect();
    let is_read = data.fixed_rows(element, |rows| {
        columns.values.iter_mut().zip(&offsets).for_each(|(values, &at)| rows.extend(values, at));
        Ok(())
    })?;
    if !is_read {
        data.each_row(element, None, &mut CarriedRowReader { element, columns: &mut columns })?;
    }
    Ok(columns)
}

/// Skips the rows of an element.
pub(super) fn skip(element: &Element, data: &mut impl Data) -> Result<(), ReadError> {
    if element.properties.is_empty() || data.fixed_rows(element, |_| Ok(()))? {
        return Ok(());
    }
    data.each_row(element, None, &mut RowSkipper(element))
}

/// Skips rows.
struct RowSkipper<'r>(&'r Element);

impl RowReader for RowSkipper<'_> {
    fn row(&mut self, data: &mut impl Data) -> Result<(), ReadError> {
        self.0.properties.iter().try_for_each(|property| skip_property(property, data))
    }
}

/// Reads the rows of an element that is carried as it is.
pub(super) struct CarriedRowReader<'r> {
    pub(super) element: &'r Element,
    pub(super) columns: &'r mut Columns,
}

impl RowReader for CarriedRowReader<'_> {
    fn row(&mut self, data: &mut impl Data) -> Result<(), ReadError> {
        (0..self.element.properties.len())
            .try_for_each(|column| self.columns.read(self.element, column, data))
    }
}
