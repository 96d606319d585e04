//! Accessors: rows of numbers in the bytes of a buffer, some of which may be replaced.

use crate::formats::gltf::asset::{Asset, View};
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::json::Object;

/// How a number is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of_code(code: u64) -> Option<Self> {
        Some(match code {
            5120 => Component::I8,
            5121 => Component::U8,
            5122 => Component::I16,
            5123 => Component::U16,
            5125 => Component::U32,
            5126 => Component::F32,
            _ => return None,
        })
    }

    pub(super) fn code(self) -> u32 {
        match self {
            Component::I8 => 5120,
            Component::U8 => 5121,
            Component::I16 => 5122,
            Component::U16 => 5123,
            Component::U32 => 5125,
            Component::F32 => 5126,
        }
    }

    /// How many bytes a number has.
    pub(super) fn size(self) -> usize {
        match self {
            Component::I8 | Component::U8 => 1,
            Component::I16 | Component::U16 => 2,
            Component::U32 | Component::F32 => 4,
        }
    }
}

/// The types of a row: rows and columns of numbers.
const KINDS: [(&str, usize, usize); 7] = [
    ("SCALAR", 1, 1),
    ("VEC2", 2, 1),
    ("VEC3", 3, 1),
    ("VEC4", 4, 1),
    ("MAT2", 2, 2),
    ("MAT3", 3, 3),
    ("MAT4", 4, 4),
];

/// How a row is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Form {
    pub(super) component: Component,
    /// How many numbers a column has.
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) normalized: bool,
}

impl Form {
    /// How many numbers a row has.
    pub(super) fn width(self) -> usize {
        self.rows * self.columns
    }

    /// From the start of a column to the next. Columns of matrices begin at multiples of 4 bytes.
    fn column_stride(self) -> usize {
        let size = self.rows * self.component.size();
        if self.columns > 1 { size.next_multiple_of(4) } else { size }
    }

    /// How many bytes a row has.
    pub(super) fn size(self) -> usize {
        self.column_stride() * self.columns
    }

    /// Whether the numbers of a row follow each other without a gap.
    pub(super) fn is_packed(self) -> bool {
        self.size() == self.width() * self.component.size()
    }

    /// Where each number of a row begins.
    pub(super) fn places(self) -> impl Iterator<Item = usize> + Clone {
        (0..self.columns).flat_map(move |column| {
            (0..self.rows).map(move |row| column * self.column_stride() + row * self.component.size())
        })
    }

    /// What a row is called, such as `VEC3`.
    pub(super) fn kind(self) -> &'static str {
        KINDS.iter().find(|kind| (kind.1, kind.2) == (self.rows, self.columns)).map_or("", |kind| kind.0)
    }
}

/// Where rows are in a buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    pub(super) view: usize,
    pub(super) buffer: usize,
    /// The first byte within the buffer.
    pub(super) start: usize,
    /// From one row to the next.
    pub(super) stride: usize,
}

/// Rows of numbers.
#[derive(Clone, Debug)]
pub(super) struct Accessor {
    pub(super) index: usize,
    pub(super) form: Form,
    pub(super) count: usize,
    /// `None`: all numbers are 0, but for the sparse rows.
    pub(super) place: Option<Place>,
    pub(super) sparse: Option<Sparse>,
    /// Whether its numbers are not at a multiple of their size.
    pub(super) is_misaligned: bool,
}

/// Rows that replace others.
#[derive(Clone, Debug)]
pub(super) struct Sparse {
    pub(super) count: usize,
    /// Which rows, ascending.
    pub(super) indices: (Place, Component),
    /// By which rows.
    pub(super) values: Place,
}

impl Asset<'_> {
    /// An accessor.
    ///
    /// # Errors
    /// If its type is unknown, or its rows are not within its view.
    pub(super) fn accessor(&self, index: usize) -> Result<Accessor, Fault> {
        let pointer = Pointer::item("accessors", index);
        let object = Object::of(self.accessors[index], pointer.clone())?;
        let form = form_of(&object)?;
        let count = object.count("count")?;
        let count = usize::try_from(count).ok().filter(|&count| count > 0).ok_or_else(|| {
            object.fault_in("count", if count == 0 { "is 0, but must be 1 or more" } else { "is too large" })
        })?;
        let view = object.index("bufferView", self.views.len(), "buffer view")?;
        let offset = object.count_or("byteOffset", 0)?;
        let rows = Rows { view, offset, size: form.size(), count };
        let place = view.map(|at| self.place(at, &rows, &pointer)).transpose()?;
        let sparse = match object.object("sparse")? {
            Some(sparse) => Some(self.sparse(&sparse, form, count)?),
            None => None,
        };
        let size = form.component.size();
        let is_misaligned = place.is_some_and(|place| place.start % size != 0 || place.stride % size != 0);
        Ok(Accessor { index, form, count, place, sparse, is_misaligned })
    }

    /// Where some rows are within a view.
    fn place(&self, index: usize, rows: &Rows, pointer: &Pointer) -> Result<Place, Fault> {
        let view: View = self.view(index)?;
        let stride = match view.stride {
            Some(stride) if rows.view.is_some() => stride,
            _ => rows.size as u64,
        };
        if stride < rows.size as u64 {
            let reason = format!("rows of {} bytes do not fit a stride of {stride}", rows.size);
            return Err(pointer.fault(reason));
        }
        let end = (rows.count as u64 - 1).checked_mul(stride);
        let end = end.and_then(|end| end.checked_add(rows.size as u64)?.checked_add(rows.offset));
        match end {
            Some(end) if end <= view.length => {}
            Some(end) => {
                let reason = format!("ends at byte {end} of a view of {}", view.length);
                return Err(pointer.fault(reason));
            }
            None => return Err(pointer.fault("ends beyond all bytes")),
        }
        // Within a buffer that is in memory once its bytes are looked at.
        let start = usize::try_from(view.offset + rows.offset).unwrap_or(usize::MAX);
        Ok(Place { view: index, buffer: view.buffer, start, stride: stride as usize })
    }

    fn sparse(&self, sparse: &Object<'_>, form: Form, rows: usize) -> Result<Sparse, Fault> {
        let count = sparse.count("count")?;
        let count = usize::try_from(count).ok().filter(|&count| count <= rows).ok_or_else(|| {
            sparse.fault_in("count", format!("{count} rows are more than the {rows} of the accessor"))
        })?;
        let missing = |name: &str| sparse.pointer.fault(format!("has no `{name}`"));
        let indices = sparse.object("indices")?.ok_or_else(|| missing("indices"))?;
        let values = sparse.object("values")?.ok_or_else(|| missing("values"))?;
        let component = component_of(&indices)?;
        if !is_index(component) {
            return Err(indices.fault_in("componentType", "is not that of an index"));
        }
        let place_of = |of: &Object<'_>, size: usize| -> Result<Place, Fault> {
            let view = of.index("bufferView", self.views.len(), "buffer view")?;
            let view = view.ok_or_else(|| of.pointer.fault("has no `bufferView`"))?;
            let offset = of.count_or("byteOffset", 0)?;
            // Sparse rows stand without a gap, whatever stride their view has.
            let rows = Rows { view: None, offset, size, count: count.max(1) };
            self.place(view, &rows, &of.pointer)
        };
        let indices = (place_of(&indices, component.size())?, component);
        Ok(Sparse { count, indices, values: place_of(&values, form.size())? })
    }
}

/// Rows that are to be found in a view.
struct Rows {
    /// `None` if the view's stride does not matter.
    view: Option<usize>,
    offset: u64,
    size: usize,
    count: usize,
}

/// Whether indices may be stored so.
pub(super) fn is_index(component: Component) -> bool {
    matches!(component, Component::U8 | Component::U16 | Component::U32)
}

fn form_of(object: &Object<'_>) -> Result<Form, Fault> {
    let kind = object.text("type")?.ok_or_else(|| object.pointer.fault("has no `type`"))?;
    let known = KINDS.iter().find(|(name, ..)| *name == kind);
    let &(_, rows, columns) =
        known.ok_or_else(|| object.fault_in("type", format!("`{}` is unknown", kind.escape_debug())))?;
    let component = component_of(object)?;
    let normalized = object.get("normalized").is_some_and(|value| value.raw() == "true");
    let normalized = normalized && !matches!(component, Component::F32 | Component::U32);
    Ok(Form { component, rows, columns, normalized })
}

fn component_of(object: &Object<'_>) -> Result<Component, Fault> {
    let code = object.count("componentType")?;
    Component::of_code(code).ok_or_else(|| object.fault_in("componentType", format!("{code} is unknown")))
}
