//! Attribute layers, between a mesh and the dictionaries of the Python side.
//!
//! A layer crosses as all that it is made of ([`LayerParts`]), so that the Python side can spread its values over elements,
//! make layers of arrays, and pickle a mesh without loss.

use meshmend::mesh::{Carry, Domain, Layer, LayerParts, Role, Values};
use numpy::{Element, IntoPyArray, PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList, PyTuple};

use crate::errors;

/// The domains by their words on the Python side.
const DOMAINS: [(&str, Domain); 5] = [
    ("vertex", Domain::Vertex),
    ("corner", Domain::Corner),
    ("face", Domain::Face),
    ("loose_edge", Domain::LooseEdge),
    ("loose_point", Domain::LoosePoint),
];

const CARRIES: [(&str, Carry); 3] =
    [("copy", Carry::Copy), ("interpolate", Carry::Interpolate), ("clear", Carry::Clear)];

/// A layer of the Python side.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct GivenLayer<'py> {
    name: String,
    domain: String,
    home: String,
    width: usize,
    carry: String,
    role: String,
    is_normalized: bool,
    stored_vertices: usize,
    values: Bound<'py, PyAny>,
    uses: Option<Bound<'py, PyArray1<u32>>>,
    vertex_uses: Option<Bound<'py, PyArray1<u32>>>,
}

impl GivenLayer<'_> {
    /// The layer of a mesh.
    pub(crate) fn layer(&self) -> PyResult<Layer> {
        let role = Role::from_name(&self.role);
        Ok(Layer::from_parts(LayerParts {
            name: self.name.clone(),
            domain: meant("domain", &self.domain, &DOMAINS)?,
            home: meant("domain", &self.home, &DOMAINS)?,
            width: self.width,
            carry: meant("way to carry", &self.carry, &CARRIES)?,
            role: role.ok_or_else(|| errors::of_type(format!("`{}` is no role", self.role)))?,
            is_normalized: self.is_normalized,
            stored_vertices: self.stored_vertices,
            values: values_of(&self.values)?,
            uses: self.uses.as_ref().map(numbers).transpose()?,
            vertex_uses: self.vertex_uses.as_ref().map(numbers).transpose()?,
        }))
    }
}

fn meant<T: Copy>(what: &str, word: &str, known: &[(&str, T)]) -> PyResult<T> {
    let found = known.iter().find(|(name, _)| *name == word);
    found.map(|(_, value)| *value).ok_or_else(|| errors::of_type(format!("`{word}` is no {what}")))
}

/// A layer for the Python side.
pub(crate) fn given<'py>(py: Python<'py>, layer: &Layer) -> PyResult<Bound<'py, PyDict>> {
    let parts = layer.to_parts();
    let dict = PyDict::new(py);
    dict.set_item("name", parts.name)?;
    dict.set_item("domain", named(parts.domain, &DOMAINS))?;
    dict.set_item("home", named(parts.home, &DOMAINS))?;
    dict.set_item("width", parts.width)?;
    dict.set_item("carry", named(parts.carry, &CARRIES))?;
    dict.set_item("role", parts.role.name())?;
    dict.set_item("is_normalized", parts.is_normalized)?;
    dict.set_item("stored_vertices", parts.stored_vertices)?;
    dict.set_item("values", array_of(py, parts.values)?)?;
    dict.set_item("uses", parts.uses.map(|uses| uses.into_pyarray(py)))?;
    dict.set_item("vertex_uses", parts.vertex_uses.map(|uses| uses.into_pyarray(py)))?;
    Ok(dict)
}

fn named<T: PartialEq>(value: T, known: &[(&'static str, T)]) -> &'static str {
    known.iter().find(|(_, other)| *other == value).map_or("", |(name, _)| name)
}

/// The pool of a layer: an array, a list of texts, or a pair of starts and items for lists.
fn array_of(py: Python<'_>, values: Values) -> PyResult<Bound<'_, PyAny>> {
    Ok(match values {
        Values::I8(v) => v.into_pyarray(py).into_any(),
        Values::U8(v) => v.into_pyarray(py).into_any(),
        Values::I16(v) => v.into_pyarray(py).into_any(),
        Values::U16(v) => v.into_pyarray(py).into_any(),
        Values::I32(v) => v.into_pyarray(py).into_any(),
        Values::U32(v) => v.into_pyarray(py).into_any(),
        Values::F32(v) => v.into_pyarray(py).into_any(),
        Values::F64(v) => v.into_pyarray(py).into_any(),
        Values::Text(texts) => PyList::new(py, texts.iter().map(|text| PyBytes::new(py, text)))?.into_any(),
        Values::Lists { starts, items } => {
            let pair = [starts.into_pyarray(py).into_any(), array_of(py, *items)?];
            PyTuple::new(py, pair)?.into_any()
        }
    })
}

fn values_of(values: &Bound<'_, PyAny>) -> PyResult<Values> {
    if let Ok(pair) = values.cast::<PyTuple>() {
        let (starts, items): (Bound<'_, PyArray1<u32>>, Bound<'_, PyAny>) = pair.extract()?;
        let is_flat = !items.is_instance_of::<PyTuple>();
        if !is_flat {
            return Err(errors::of_type("the items of lists are no lists"));
        }
        return Ok(Values::Lists { starts: numbers(&starts)?, items: Box::new(values_of(&items)?) });
    }
    if let Ok(texts) = values.cast::<PyList>() {
        return Ok(Values::Text(texts.extract()?));
    }
    macro_rules! first_of {
        ($($kind:ident $number:ty),*) => {
            $(if let Ok(array) = values.cast::<PyArray1<$number>>() {
                return Ok(Values::$kind(numbers(array)?));
            })*
        };
    }
    first_of!(I8 i8, U8 u8, I16 i16, U16 u16, I32 i32, U32 u32, F32 f32, F64 f64);
    Err(errors::of_type("the values of a layer are an array of one dimension, a list of texts, or lists"))
}

fn numbers<T: Element + Copy>(array: &Bound<'_, PyArray1<T>>) -> PyResult<Vec<T>> {
    Ok(array.try_readonly()?.as_slice()?.to_vec())
}
