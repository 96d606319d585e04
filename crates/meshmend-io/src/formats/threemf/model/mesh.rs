//! The reader of a mesh: vertices, triangles, and what numbers them.

use std::ops::Range;

use super::rows::{self, Triangle};
use super::{MeshText, NONE};
use crate::formats::threemf::counts::Counts;
use crate::formats::threemf::package::Fault;
use crate::formats::threemf::xml::{Scanner, Space, Tag};
use crate::input::assemble::no_such_vertex;
use crate::text::shown;

/// Reads the mesh of one object.
pub(super) struct Reader<'r, 'a, 'l> {
    pub(super) scanner: &'r mut Scanner<'a>,
    pub(super) counts: &'r mut Counts<'l>,
    pub(super) entry: &'r str,
    pub(super) id: u32,
}

impl<'a> Reader<'_, 'a, '_> {
    /// Reads a mesh. The defaults are the property group of its object and the member of that.
    pub(super) fn mesh(&mut self, mesh: &Tag<'a>, default: [Option<u32>; 2]) -> Result<MeshText, Fault> {
        let mut found = MeshText::default();
        let mut properties = Properties { default, groups: Vec::new(), members: Vec::new() };
        while let Some(tag) = self.scanner.child(mesh)? {
            match (tag.space, tag.local) {
                (Space::Core, "vertices") => {
                    let place = self.vertices(&tag, &mut found)?;
                    self.set_once(&mut found.places.vertices, place, "vertices")?;
                }
                (Space::Core, "triangles") => {
                    let place = self.triangles(&tag, &mut found, &mut properties)?;
                    self.set_once(&mut found.places.triangles, place, "triangles")?;
                }
                (Space::Core | Space::TriangleSets, "trianglesets") => {
                    found.places.sets.push(self.scanner.inside(&tag)?);
                }
                (Space::Lattice, "beamlattice") => found.places.lattices.push(self.scanner.inside(&tag)?),
                _ => {
                    self.scanner.skip(&tag)?;
                    found.unknown = found.unknown.or_else(|| Some(shown(tag.name().as_bytes())));
                }
            }
        }
        self.check_indices(&found)?;
        (found.groups, found.members) = properties.complete(found.corners.len() / 3);
        Ok(found)
    }

    fn set_once(
        &self,
        slot: &mut Option<Range<usize>>,
        place: Range<usize>,
        name: &str,
    ) -> Result<(), Fault> {
        if slot.replace(place).is_none() { Ok(()) } else { Err(self.wrong(format!("`{name}` stands twice"))) }
    }

    fn vertices(&mut self, vertices: &Tag<'a>, mesh: &mut MeshText) -> Result<Range<usize>, Fault> {
        while let Some(tag) = self.scanner.child(vertices)? {
            if !tag.is(Space::Core, "vertex") {
                self.foreign_row(&tag, mesh)?;
                continue;
            }
            let number = mesh.positions.len();
            let position =
                rows::vertex(&tag).map_err(|reason| self.wrong(format!("vertex {number}: {reason}")))?;
            mesh.positions.push(position);
            self.counts.vertex(self.entry)?;
            self.scanner.skip(&tag)?;
        }
        Ok(self.scanner.inner(vertices))
    }

    fn triangles(
        &mut self,
        triangles: &Tag<'a>,
        mesh: &mut MeshText,
        properties: &mut Properties,
    ) -> Result<Range<usize>, Fault> {
        while let Some(tag) = self.scanner.child(triangles)? {
            if !tag.is(Space::Core, "triangle") {
                self.foreign_row(&tag, mesh)?;
                continue;
            }
            let number = mesh.corners.len() / 3;
            let triangle =
                rows::triangle(&tag).map_err(|reason| self.wrong(format!("triangle {number}: {reason}")))?;
            mesh.corners.extend_from_slice(&triangle.vertices);
            properties.see(number, &triangle);
            self.counts.triangle(self.entry)?;
            self.scanner.skip(&tag)?;
        }
        Ok(self.scanner.inner(triangles))
    }

    /// Something among rows that is no row.
    fn foreign_row(&mut self, tag: &Tag<'a>, mesh: &mut MeshText) -> Result<(), Fault> {
        mesh.unknown.get_or_insert_with(|| shown(tag.name().as_bytes()));
        self.scanner.skip(tag)
    }

    fn check_indices(&self, mesh: &MeshText) -> Result<(), Fault> {
        let count = mesh.positions.len();
        let outside = mesh.corners.iter().position(|vertex| vertex.0 as usize >= count);
        outside.map_or(Ok(()), |corner| {
            let missing =
                no_such_vertex(i64::from(mesh.corners[corner].0), count).replace("the file", "the object");
            Err(self.wrong(format!("triangle {}: {missing}", corner / 3)))
        })
    }

    fn wrong(&self, reason: impl Into<String>) -> Fault {
        Fault::of_object(self.entry, self.id, reason)
    }
}

/// The properties of triangles. Lists are empty until some triangle has one.
struct Properties {
    default: [Option<u32>; 2],
    groups: Vec<u32>,
    members: Vec<u32>,
}

impl Properties {
    #[inline]
    fn see(&mut self, number: usize, triangle: &Triangle) {
        if triangle.group.is_some() || triangle.members[0].is_some() {
            self.keep(number, triangle);
        }
    }

    fn keep(&mut self, number: usize, triangle: &Triangle) {
        self.fill(number);
        let [group, _] = self.default;
        let [first, second, third] = triangle.members;
        self.groups.push(triangle.group.or(group).unwrap_or(NONE));
        self.members.extend([first, second.or(first), third.or(first)].map(|member| member.unwrap_or(NONE)));
    }

    /// Gives the triangles before one what their object says.
    fn fill(&mut self, number: usize) {
        let (group, member) = match self.default {
            [Some(group), member] => (group, member.unwrap_or(0)),
            [None, _] => (NONE, NONE),
        };
        self.groups.resize(number, group);
        self.members.resize(number * 3, member);
    }

    /// The groups of all triangles and the members of all corners; nothing if there is none.
    fn complete(mut self, triangles: usize) -> (Vec<u32>, Vec<u32>) {
        if self.default[0].is_some() || !self.groups.is_empty() {
            self.fill(triangles);
        }
        (self.groups, self.members)
    }
}
