//! The reader: each mesh becomes a part, in its own space.

use std::io::Read;

use meshmend_core::{FaceTable, PolygonMesh};

use crate::document::{Part, PartSource, PartStatus};
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::bounds::note_bounds;
use crate::formats::gltf::buffers::{Beside, Bytes};
use crate::formats::gltf::container;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::file::File;
use crate::formats::gltf::nodes::{nodes, roots};
use crate::formats::gltf::part::read_part;
use crate::formats::gltf::pools::Pools;
use crate::formats::gltf::primitives::{Mesh, Mode};
use crate::formats::gltf::rows::pointer;
use crate::formats::gltf::shape::GltfShape;
use crate::input::notes::Notes;
use crate::input::source::{Parsed, Source};
use crate::text::{trimmed_start, without_mark};
use crate::{Encoding, Limits, NoteKind, Place, ReadError, Shell};

pub(crate) fn read(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    read_owned(source.bytes.to_vec(), source, limits)
}

/// Reads a file that is called GLB. One that is JSON all the same is read as that.
pub(crate) fn read_glb(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let is_json = trimmed_start(without_mark(source.bytes)).starts_with(b"{");
    if !is_json {
        container::check_header(source.bytes).map_err(|fault| fault.in_file(source))?;
    }
    read(source, limits)
}

/// Reads a GLB file, whose bytes are kept, without a copy of them.
pub(crate) fn read_blocks(
    head: &Source<'_>,
    rest: &mut dyn Read,
    limits: &Limits,
) -> Option<Result<Parsed, ReadError>> {
    head.bytes.starts_with(container::MAGIC).then(|| {
        let mut bytes = Vec::new();
        let further = head.length.saturating_sub(head.bytes.len());
        let too_large = |_| head.failed(std::io::ErrorKind::OutOfMemory.into());
        bytes.try_reserve_exact(head.length).map_err(too_large)?;
        bytes.extend_from_slice(head.bytes);
        rest.take(further as u64).read_to_end(&mut bytes).map_err(|error| head.failed(error))?;
        read_owned(bytes, head, limits)
    })
}

fn read_owned(bytes: Vec<u8>, source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let mut notes = Notes::default();
    let beside = Beside { folder: source.folder, limits };
    let file = File::open(bytes, beside, &mut notes).map_err(|fault| fault.in_file(source))?;
    let parts = parts(&file, source, limits, &mut notes)?;
    let shell = Shell::of_file(file.format(), Encoding::LittleEndian, GltfShape::of(file));
    Ok(Parsed { parts, notes, shell })
}

fn parts(
    file: &File,
    source: &Source<'_>,
    limits: &Limits,
    notes: &mut Notes,
) -> Result<Vec<Part>, ReadError> {
    let found = |fault: Fault| fault.in_file(source);
    let (asset, bytes) = (file.asset().map_err(found)?, file.buffers());
    let nodes = nodes(&asset).map_err(found)?;
    roots(&asset, &nodes).map_err(found)?;
    let mut reading = Reading { asset: &asset, bytes: &bytes, limits, notes, sizes: Sizes::default() };
    let mut parts = Vec::with_capacity(asset.meshes.len());
    for index in 0..asset.meshes.len() {
        source.look(0)?;
        parts.push(reading.part(index).map_err(found)?);
    }
    if let Some(reason) = parts.first().and_then(Part::seal)
        && parts.iter().all(|part| part.seal().is_some())
    {
        return Err(found(Pointer::item("meshes", 0).fault(reason)));
    }
    let positions = || parts.iter().flat_map(|part| part.mesh.positions());
    let infinite = positions().filter(|p| !p.iter().all(|x| x.is_finite())).count() as u64;
    notes.add_many(NoteKind::NonFinite, "vertices whose position is not finite", infinite, || Place::File);
    if positions().next().is_none() {
        notes.add(NoteKind::Empty, "the file holds no vertex", || Place::File);
    }
    Ok(parts)
}

/// How much was read.
#[derive(Default)]
struct Sizes {
    vertices: u64,
    corners: u64,
    /// Before strips are known, how many numbers there are at most.
    numbers: u64,
}

/// How many numbers may be read for each byte of the file: meshes may share accessors, but not without end.
const NUMBERS_A_BYTE: u64 = 64;

/// How many numbers may be read in any case.
const FEW_NUMBERS: u64 = 1 << 20;

struct Reading<'r, 'a> {
    asset: &'r Asset<'a>,
    bytes: &'r Bytes<'a>,
    limits: &'r Limits,
    notes: &'r mut Notes,
    sizes: Sizes,
}

impl Reading<'_, '_> {
    fn part(&mut self, index: usize) -> Result<Part, Fault> {
        let mesh = self.asset.mesh(index)?;
        let name = mesh.name.clone().into_bytes();
        let source = |tells_vertices| PartSource::GltfMesh { index: index as u32, tells_vertices };
        if let Some(reason) = mesh.seal {
            self.notes.add(NoteKind::SealedPart, &reason, || mesh.object.pointer.place());
            let empty = PolygonMesh::new(Vec::new(), FaceTable::empty(0));
            let empty = empty.map_err(|error| mesh.object.pointer.fault(error.to_string()))?;
            return Ok(Part { name, source: source(false), mesh: empty, status: PartStatus::Sealed(reason) });
        }
        let pools = Pools::of(self.asset, &mesh)?;
        self.check_sizes(&mesh, &pools)?;
        let read = read_part(self.asset, &mesh, &pools, self.bytes)?;
        self.sizes.corners += read.mesh.counts().corners as u64;
        Fault::if_more("faces", self.sizes.corners / 3, self.limits.max_faces)?;
        Fault::if_more("corners", self.sizes.corners, self.limits.max_corners)?;
        self.note_rows(&mesh, &pools, read.mesh.positions())?;
        let lines = mesh.primitives.iter().filter(|primitive| primitive.mode == Mode::NoFaces).count() as u64;
        let message = "primitives of points or lines stay in the file as they are: they have no faces";
        self.notes.add_many(NoteKind::SkippedElement, message, lines, || mesh.object.pointer.place());
        let message = "triangles that name a vertex twice, which lead from strip to strip, are not faces";
        self.notes
            .add_many(NoteKind::Stitches, message, read.stitches as u64, || mesh.object.pointer.place());
        let source = source(read.tells_vertices);
        Ok(Part { name, source, mesh: read.mesh, status: PartStatus::Editable })
    }

    /// Compares what is to be read with the limits and with the bytes that are there.
    fn check_sizes(&mut self, mesh: &Mesh<'_>, pools: &Pools) -> Result<(), Fault> {
        for pool in &pools.list {
            let widths: usize = pool.attributes.iter().map(|(_, accessor)| accessor.form.width()).sum();
            self.sizes.vertices += pool.rows as u64;
            let numbers = (pool.rows as u64).saturating_mul(widths as u64);
            self.sizes.numbers = self.sizes.numbers.saturating_add(numbers);
        }
        for (primitive, pool) in mesh.primitives.iter().zip(&pools.of_primitive) {
            let Some(pool) = *pool else { continue };
            let count = match primitive.indices {
                Some(indices) => self.asset.accessor(indices)?.count,
                None => pools.list[pool].rows,
            };
            self.sizes.numbers = self.sizes.numbers.saturating_add(primitive.most_corners(count));
        }
        Fault::if_more("vertices", self.sizes.vertices, self.limits.max_vertices)?;
        let numbers = self.sizes.numbers;
        let most = (self.bytes.total as u64).saturating_mul(NUMBERS_A_BYTE).saturating_add(FEW_NUMBERS);
        if numbers > most {
            let reason =
                format!("the meshes up to here hold {numbers} numbers, too many for a file of this size");
            return Err(mesh.object.pointer.fault(reason));
        }
        Ok(())
    }

    /// Remarks on accessors that hold something else than they say.
    fn note_rows(&mut self, mesh: &Mesh<'_>, pools: &Pools, rows: &[[f64; 3]]) -> Result<(), Fault> {
        for pool in &pools.list {
            for (_, accessor) in pool.attributes.iter().filter(|(_, accessor)| accessor.is_misaligned) {
                let message = "accessors whose numbers are not at multiples of their size";
                self.notes.add(NoteKind::Misaligned, message, || pointer(accessor).place());
            }
            // Where some rows are no vertices, what is stated of all of them is not compared.
            let rows = rows.get(pool.base..pool.base + pool.rows).filter(|_| rows.len() == pools.rows);
            if let (Some(accessor), Some(rows)) = (pool.positions(), rows) {
                note_bounds(self.asset, accessor, rows, self.notes)?;
            }
        }
        for index in mesh.primitives.iter().filter_map(|primitive| primitive.indices) {
            if self.asset.accessor(index)?.is_misaligned {
                let message = "accessors whose numbers are not at multiples of their size";
                self.notes.add(NoteKind::Misaligned, message, || Pointer::item("accessors", index).place());
            }
        }
        Ok(())
    }
}
