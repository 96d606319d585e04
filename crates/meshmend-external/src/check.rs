//! The whole check, step by step.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use meshmend_core::{Connectivity, Defect, DefectKind, EdgeId, Element, VertexId};
use meshmend_io::{ReadOptions, Streamed};
use meshmend_topology::{Figures, Reason, TopologyReport, Undefined, Witness};

use crate::boundary::count_loops;
use crate::budget::{Budget, FaceBudget};
use crate::components::Tally;
use crate::error::ExternalError;
use crate::excerpt::{Excerpt, Wanted};
use crate::face_parts::FaceParts;
use crate::faces::{Faces, faces};
use crate::lists::Lists;
use crate::patches::{Patches, faces_of};
use crate::places::{Places, places};
use crate::sides::PatchSides;
use crate::survey::Survey;

/// How a mesh larger than memory is checked.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ExternalOptions {
    /// How many bytes of memory may be used.
    pub memory: u64,
    /// The folder for what does not fit it.
    pub folder: PathBuf,
    /// Whether vertices at one place are one; by default in files without indices.
    pub is_welded: Option<bool>,
    /// How many defects of each kind are listed.
    pub limit: usize,
    /// How the file is read, and who watches.
    pub read: ReadOptions,
    /// So many parts, whatever fits the memory: for tests, whose meshes are small.
    pub parts: Option<usize>,
}

impl ExternalOptions {
    /// With so many bytes of memory, and the system's folder for temporary files.
    pub fn within(memory: u64) -> Self {
        ExternalOptions {
            memory,
            folder: std::env::temp_dir(),
            is_welded: None,
            limit: 10,
            read: ReadOptions::default(),
            parts: None,
        }
    }
}

/// What a check of a mesh larger than memory found.
#[derive(Debug)]
pub struct ExternalCheck {
    /// Whether vertices at one place were taken for one.
    pub is_welded: bool,
    /// What is known of the file.
    pub file: Streamed,
    /// How many vertices and faces are stored.
    pub stored: [u64; 2],
    /// The figures. The list of defects is empty.
    pub topology: TopologyReport,
    /// How many defects of each kind there are, also of kinds that a report does not list unasked, and the first of them by the
    /// numbers of the excerpt.
    pub defects: BTreeMap<DefectKind, (u64, Vec<Defect>)>,
    /// What the defects name.
    pub excerpt: Excerpt,
    /// How many vertices single precision would join beyond those at one place.
    pub joined_in_single: u64,
    /// How many bytes were written to disk.
    pub spilled: u64,
}

/// Checks the mesh of a binary PLY or STL file that may be larger than memory.
///
/// The answers are those of a check in memory, whatever the memory and the number of parts. Only what shows that a patch is not
/// orientable is absent where the faces of these patches do not fit the memory: `undefined` says so.
///
/// # Errors
/// When the file can't be read row by row, the disk is full, or the memory is less than the mesh takes: 4.3 bytes a face, or 4.5
/// a vertex, and 36 MiB.
///
/// *Cost*: the faces of the file are read twice, once more where patches are not orientable, and its positions three times. Each
/// face is written once for each part in which it has a vertex, as 16 bytes; a position takes 16 bytes (28 in double precision).
/// Sorting, else near-linear time.
pub fn external_check(path: &Path, options: &ExternalOptions) -> Result<ExternalCheck, ExternalError> {
    let ExternalOptions { memory, folder, is_welded, limit, read, parts } = options;
    let budget = Budget { memory: *memory, folder, parts: *parts };
    let mut lists = Lists::new(*limit);
    let mut places = places(path, read, *is_welded, &budget, &mut lists)?;
    let for_faces = budget.for_faces(&places.announced, places.vertex_count.into(), places.is_welded)?;
    let faces = faces(path, read, &mut places, (&budget, for_faces), &mut lists)?;
    Check { path, options, budget, for_faces, lists, places, faces }.run()
}

/// A mesh whose faces are in parts.
struct Check<'a> {
    path: &'a Path,
    options: &'a ExternalOptions,
    budget: Budget<'a>,
    for_faces: FaceBudget,
    lists: Lists,
    places: Places,
    faces: Faces,
}

impl Check<'_> {
    fn run(mut self) -> Result<ExternalCheck, ExternalError> {
        let face_count = self.places.announced.faces as u32;
        let mut survey = Survey {
            budget: &self.budget,
            faces: self.for_faces,
            watch: &self.options.read.watch,
            lists: &mut self.lists,
            sides: PatchSides::new(face_count as usize),
            tally: Tally::new(&self.budget, self.faces.components, self.for_faces.room)?,
            vertices: 0,
            edges: 0,
            branches: self.budget.spill(1)?,
            boundary: self.budget.spill(1)?,
            written: 0,
        };
        let first_edges = survey.all(&self.faces.parts, &self.faces.labels)?;
        let Survey { mut sides, mut tally, vertices, edges, branches, boundary, mut written, .. } = survey;
        let degenerate = u64::from(face_count) - self.faces.proper;
        let patches = Patches::of(&mut sides, (face_count, degenerate), &branches, self.options.limit)?;
        let twisted = faces_of(&mut sides, face_count, &patches.first_twisted);
        drop(sides);
        count_loops(&boundary, self.places.vertex_count, &mut tally)?;
        let (mut kinds, of_components) = tally.kinds()?;
        kinds.iter_mut().for_each(|kind| {
            kind.first_vertex = VertexId(self.places.vertices.stored(kind.first_vertex.0));
        });
        written += [branches.written(), boundary.written(), of_components].iter().sum::<u64>();
        written += self.faces.parts.spill.written() + self.faces.labels.written() + self.places.written;
        self.list_loose_edges()?;
        let elements = [vertices, edges, self.faces.proper];
        let components = u64::from(self.faces.components);
        let fits = twisted.count_ones(..) as u64 * ROUND_A_FACE <= self.for_faces.room;
        let figures = Figures {
            elements,
            components,
            patches: patches.count,
            component_kinds: kinds,
            betti: patches.betti(elements, components),
            witness: Witness::BreadthFirst,
            witness_unknown: (!fits).then_some(Undefined { figure: "witness", reason: Reason::BeyondMemory }),
        };
        self.lists.set(DefectKind::NonOrientablePatch, patches.twisted, Vec::new());
        let topology = figures.report(|kind| self.lists.count(kind));
        let mut defects = std::mem::replace(&mut self.lists, Lists::new(0)).into_kinds();
        let source = (self.path, &self.options.read);
        let mut wanted = Wanted::nothing(self.places.vertex_count);
        defects.values().flat_map(|(_, first)| first).for_each(|defect| wanted.add(defect));
        let has_strips = fits && !patches.first_twisted.is_empty();
        if has_strips {
            wanted.add_faces(source, &mut self.places.vertices, &twisted)?;
        }
        let mut excerpt = Excerpt::of(source, &mut self.places.vertices, wanted)?;
        for (_, first) in defects.values_mut() {
            for defect in first {
                *defect = excerpt.of_whole(defect.clone());
            }
        }
        if has_strips {
            let strips = excerpt.strips(&patches.first_twisted);
            self.name_edges(&mut excerpt, &strips, &first_edges)?;
            if let Some((_, first)) = defects.get_mut(&DefectKind::NonOrientablePatch) {
                *first = strips;
            }
        }
        let Places { announced, joined_in_single, .. } = self.places;
        Ok(ExternalCheck {
            is_welded: self.places.is_welded,
            file: self.faces.streamed,
            stored: [announced.vertices, announced.faces],
            topology,
            defects,
            excerpt,
            joined_in_single,
            spilled: written,
        })
    }

    fn list_loose_edges(&mut self) -> Result<(), ExternalError> {
        let edges = std::mem::take(&mut self.faces.streamed.loose_edges);
        for (index, ends) in (0..).zip(&edges) {
            let mut here = *ends;
            for end in &mut here {
                *end = VertexId(self.places.vertices.vertex(end.0)?);
            }
            self.lists.add(Defect::new(DefectKind::LooseEdge, Element::LooseEdge { index, ends: here }));
        }
        self.faces.streamed.loose_edges = edges;
        Ok(())
    }

    /// Finds which edges of the whole mesh those are that strips cross.
    fn name_edges(
        &self,
        excerpt: &mut Excerpt,
        strips: &[Defect],
        first_edges: &[u64],
    ) -> Result<(), ExternalError> {
        let crossed = excerpt.crossed(strips);
        let parts: &FaceParts = &self.faces.parts;
        let mut parts_of: Vec<usize> = crossed.keys().map(|ends| parts.part_of(ends[0])).collect();
        parts_of.dedup();
        for part in parts_of {
            let mut number = first_edges[part];
            parts.look_at(part, (&self.budget, self.for_faces.faces_a_part), &mut |part| {
                for edge in part.own_edges() {
                    let ends = part.kernel.edge_ends(edge).map(|end| part.vertex(end).0);
                    if let Some(&here) = crossed.get(&ends) {
                        excerpt.name(here, EdgeId(number as u32));
                    }
                    number += 1;
                }
                Ok(())
            })?;
        }
        Ok(())
    }
}

/// How many bytes a face takes whose surroundings are held as a mesh, with theirs.
const ROUND_A_FACE: u64 = 600;
