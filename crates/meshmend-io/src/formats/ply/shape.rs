//! The choices of a PLY file: the elements of its header, their properties and types, and the order of all of them.

use meshmend_core::{Layer, PolygonMesh, counted};

use crate::formats::ply::columns::Columns;
use crate::formats::ply::header::{Element, Header};
use crate::formats::ply::listed::{Listed, Named};
use crate::formats::ply::property_names::{CORNER_PREFIX, GROUPS};
use crate::formats::ply::scalar::Scalar;
use crate::shell::{Output, Shape};
use crate::{Loss, LossKind};

/// The choices of a PLY file.
#[derive(Debug)]
pub(super) struct PlyShape {
    pub(super) elements: Listed<Declared>,
    /// The mesh of the file, if a carried element names its vertices or faces by number.
    stored: Option<PolygonMesh>,
}

/// An element as a header declares it.
#[derive(Debug, PartialEq)]
pub(super) struct Declared {
    pub(super) name: String,
    pub(super) properties: Listed<DeclaredProperty>,
    /// The rows, if the meaning of the element is unknown. It is carried unchanged.
    pub(super) table: Option<CarriedRows>,
}

/// The rows of an element that is carried unchanged: one layer for each property, with one value for each row.
#[derive(Debug, PartialEq)]
pub(super) struct CarriedRows {
    pub(super) count: usize,
    pub(super) columns: Vec<Layer>,
}

/// A property as a header declares it.
#[derive(Debug, PartialEq)]
pub(super) struct DeclaredProperty {
    pub(super) name: String,
    pub(super) length: Option<Scalar>,
    pub(super) item: Scalar,
}

impl Named for Declared {
    fn name(&self) -> &str {
        &self.name
    }
}

impl Named for DeclaredProperty {
    fn name(&self) -> &str {
        &self.name
    }
}

impl PlyShape {
    /// What a header declares, with the rows of the elements that are carried unchanged: their places in the header,
    /// ascending, and their columns.
    pub(super) fn new(header: &Header, tables: Vec<(usize, Columns)>, mesh: &PolygonMesh) -> Self {
        let mut tables = tables.into_iter().peekable();
        let declared = |(at, element): (usize, &Element)| {
            let columns = tables.next_if(|(table, _)| *table == at).map(|(_, columns)| columns);
            Declared::of(element, columns)
        };
        let elements: Vec<Declared> = header.elements.iter().enumerate().map(declared).collect();
        let stored = elements.iter().any(Declared::names_elements).then(|| mesh.clone());
        PlyShape { elements: Listed::new(elements), stored }
    }

    /// The declaration of an element.
    pub(super) fn element(&self, name: &str) -> Option<&Declared> {
        self.elements.find(name).map(|(_, element)| element)
    }

    /// Whether vertices or faces have a property as which a layer is written.
    pub(super) fn declares(&self, layer: &Layer) -> bool {
        let groups = GROUPS.iter().filter(|group| group.layer == layer.name());
        let of_corners = format!("{CORNER_PREFIX}{}", layer.name());
        let own = [layer.name(), of_corners.as_str()];
        let mut names = groups.flat_map(|group| group.members).copied().chain(own);
        let elements = ["vertex", "face"].map(|name| self.element(name));
        names.any(|name| elements.iter().flatten().any(|element| element.property(name).is_some()))
    }

    /// The losses of carried elements that name vertices or faces by numbers that are out of date.
    pub(super) fn stale_losses(&self, written: &PolygonMesh) -> Vec<Loss> {
        let Some(stored) = &self.stored else { return Vec::new() };
        let bits = |mesh: &PolygonMesh| -> Vec<u64> {
            mesh.positions().iter().flatten().map(|x| x.to_bits()).collect()
        };
        if stored.faces() == written.faces() && bits(stored) == bits(written) {
            return Vec::new();
        }
        let stale = self.elements.all().iter().filter(|element| element.names_elements());
        let loss = |element: &Declared| {
            let count = element.table.as_ref().map_or(0, |rows| rows.count);
            Loss::if_any(LossKind::StaleData, count, |count| {
                let rows = counted(count, "row");
                format!(
                    "element `{}` of {rows} is carried as it was, but vertices or faces that it names have other numbers now",
                    element.name
                )
            })
        };
        stale.filter_map(loss).collect()
    }
}

impl Declared {
    fn of(element: &Element, columns: Option<Columns>) -> Self {
        let properties = element.properties.iter().map(|property| DeclaredProperty {
            name: property.name.clone(),
            length: property.length,
            item: property.item,
        });
        let table = columns.map(|columns| CarriedRows {
            count: element.count as usize,
            columns: columns.into_layers(element),
        });
        Declared { name: element.name.clone(), properties: Listed::new(properties.collect()), table }
    }

    /// Whether it is carried unchanged and has whole numbers that are those of vertices or faces, judging by their
    /// names.
    fn names_elements(&self) -> bool {
        let is_number = |property: &DeclaredProperty| {
            let name = property.name.to_ascii_lowercase();
            let is_named = name.starts_with("face") || name.starts_with("vertex") && name.contains("ind");
            is_named && !property.item.has_fractions()
        };
        self.table.is_some() && self.properties.all().iter().any(is_number)
    }

    /// A property's declaration, with its place.
    pub(super) fn property(&self, name: &str) -> Option<(usize, &DeclaredProperty)> {
        self.properties.find(name)
    }
}

/// Compares the declarations alone: the mesh that is kept is that of the same file.
impl PartialEq for PlyShape {
    fn eq(&self, other: &Self) -> bool {
        self.elements == other.elements
    }
}

impl Shape for PlyShape {
    fn is_same(&self, other: &dyn Shape) -> bool {
        other.downcast() == Some(self)
    }

    /// In another format, the elements that a PLY file would carry.
    fn losses_in(&self, output: Output) -> Vec<Loss> {
        if let Output::OfSameFormat = output {
            return Vec::new();
        }
        let tables =
            self.elements.all().iter().filter_map(|element| Some((element, element.table.as_ref()?)));
        let loss = |(element, rows): (&Declared, &CarriedRows)| {
            Loss::if_any(LossKind::Elements, rows.count, |count| {
                format!("element `{}` of {}", element.name, counted(count, "row"))
            })
        };
        tables.filter_map(loss).collect()
    }
}
