//! A kernel as a value, whichever crate it is from.

use std::fmt;
use std::time::Duration;

use meshmend_core::{
    Array, Build, Capabilities, Cell, Complex, Costs, DefectKind, Lesson, Pointer, PolygonMesh, Refusal,
    Watch,
};
use meshmend_kernels::{KernelKind, KernelVisitor};
use meshmend_repair::PassError;
use meshmend_topology::{
    GeneratorError, GeneratorOptions, Generators, Incremental, TopologyReport, Witness, generators,
    incremental, patches, topology_watched,
};

use super::KernelCost;

/// A kernel, to be chosen at run time: one of meshmend's own, or one of another crate.
///
/// A question that is generic over the kernel can't be called through a pointer. So the list of kernels is open here, and
/// the list of what can be asked is closed; [`KernelKind::run`] is the reverse.
///
/// ```
/// use meshmend::kernels::HalfEdge;
/// use meshmend::{AnyKernel, PolygonMesh};
///
/// const MINE: AnyKernel = AnyKernel::of::<HalfEdge>();
/// let mesh = PolygonMesh::from_triangles(&[[0.0; 3]; 4], &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])?;
/// assert!(MINE.heap_bytes(mesh.complex())? > 0);
/// assert_eq!(MINE.topology(&mesh, Default::default(), &Default::default())?.edges, 6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct AnyKernel {
    /// What it is called in commands and reports.
    pub name: &'static str,
    /// What it holds and what it offers.
    pub capabilities: Capabilities,
    /// What its answers cost.
    pub costs: Costs,
    /// The text that teaches it, as [`Lesson::TEXT`] says.
    pub lesson: &'static str,
    heap_bytes: fn(&Complex) -> Result<usize, Refusal>,
    arrays: fn(&Complex) -> Result<Vec<Array>, Refusal>,
    pointers: PointersOf,
    cost: CostOf,
    topology: fn(&PolygonMesh, Witness, &Watch) -> Result<TopologyReport, PassError>,
    generators: GeneratorsOf,
    incremental: fn(&Complex) -> Result<Incremental, Refusal>,
}

type PointersOf = fn(&Complex, &[Cell]) -> Result<Vec<Vec<Pointer>>, Refusal>;
type CostOf = fn(&PolygonMesh, usize, &dyn Fn() -> Duration) -> Result<KernelCost, Refusal>;
type GeneratorsOf =
    fn(&Complex, &GeneratorOptions<'_>) -> Result<Result<Generators, GeneratorError>, Refusal>;

impl AnyKernel {
    /// A kernel as a value.
    pub const fn of<K: Lesson>() -> Self {
        AnyKernel {
            name: K::NAME,
            capabilities: K::CAPABILITIES,
            costs: K::COSTS,
            lesson: K::TEXT,
            heap_bytes: |complex| Ok(K::build(complex)?.heap_bytes()),
            arrays: |complex| Ok(K::build(complex)?.arrays()),
            pointers: |complex, cells| {
                let kernel = K::build(complex)?;
                Ok(cells.iter().map(|&cell| kernel.pointers(cell)).collect())
            },
            cost: |mesh, runs, clock| KernelCost::of::<K>(mesh, runs, clock),
            topology: |mesh, witness, watch| {
                watch.look("topology", 0, 0)?;
                let complex = mesh.complex();
                watch.look("topology", 0, 0)?;
                Ok(topology_watched(&K::build(complex)?, mesh, witness, watch)?)
            },
            generators: |complex, options| Ok(generators(&K::build(complex)?, options)),
            incremental: |complex| {
                let kernel = K::build(complex)?;
                Ok(incremental(&kernel, &patches(&kernel)))
            },
        }
    }

    /// Why it refuses a kind of defect, as its lesson says in a list item that begins with the kind's code.
    pub fn why_refused(&self, kind: DefectKind) -> Option<String> {
        let begin = format!("* `{}`: ", kind.code());
        let mut lines = self.lesson.lines().skip_while(|line| !line.starts_with(&begin));
        let first = lines.next()?.strip_prefix(&begin)?;
        let further = lines.take_while(|line| line.starts_with("  "));
        Some(further.fold(first.to_owned(), |said, line| said + " " + line.trim()))
    }

    /// The bytes that it takes for a complex, as [`Connectivity::heap_bytes`](meshmend_core::Connectivity::heap_bytes) says.
    ///
    /// # Errors
    /// When it can't hold the complex: every reason why. So have all questions below.
    ///
    /// *Cost*: that of building it, as of each question below; and that of the question.
    pub fn heap_bytes(&self, complex: &Complex) -> Result<usize, Refusal> {
        (self.heap_bytes)(complex)
    }

    /// Of which arrays it consists for a complex.
    ///
    /// # Errors
    /// When it can't hold the complex.
    pub fn arrays(&self, complex: &Complex) -> Result<Vec<Array>, Refusal> {
        (self.arrays)(complex)
    }

    /// The fields of the records of some elements, which must be the complex's.
    ///
    /// # Errors
    /// When it can't hold the complex.
    pub fn pointers(&self, complex: &Complex, cells: &[Cell]) -> Result<Vec<Vec<Pointer>>, Refusal> {
        (self.pointers)(complex, cells)
    }

    /// What it costs on a mesh, as [`KernelCost::of`] says.
    ///
    /// # Errors
    /// When it can't hold the mesh.
    pub fn cost(
        &self,
        mesh: &PolygonMesh,
        runs: usize,
        clock: &dyn Fn() -> Duration,
    ) -> Result<KernelCost, Refusal> {
        (self.cost)(mesh, runs, clock)
    }

    /// The topology of a mesh.
    ///
    /// # Errors
    /// When it can't hold the mesh, or the watch stops it.
    pub fn topology(
        &self,
        mesh: &PolygonMesh,
        witness: Witness,
        watch: &Watch,
    ) -> Result<TopologyReport, PassError> {
        (self.topology)(mesh, witness, watch)
    }

    /// The closed paths that generate a complex's homology.
    ///
    /// # Errors
    /// When it can't hold the complex; and within, when there are no generators.
    pub fn generators(
        &self,
        complex: &Complex,
        options: &GeneratorOptions<'_>,
    ) -> Result<Result<Generators, GeneratorError>, Refusal> {
        (self.generators)(complex, options)
    }

    /// The Betti numbers as a complex is put together cell by cell.
    ///
    /// # Errors
    /// When it can't hold the complex.
    pub fn incremental(&self, complex: &Complex) -> Result<Incremental, Refusal> {
        (self.incremental)(complex)
    }
}

impl From<KernelKind> for AnyKernel {
    fn from(kind: KernelKind) -> Self {
        struct Value;
        impl KernelVisitor for Value {
            type Output = AnyKernel;
            fn visit<K: Lesson>(self) -> AnyKernel {
                AnyKernel::of::<K>()
            }
        }
        kind.visit(Value)
    }
}

/// The default kernel.
impl Default for AnyKernel {
    fn default() -> Self {
        KernelKind::default().into()
    }
}

/// Kernels are told apart by their names.
impl PartialEq for AnyKernel {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for AnyKernel {}

impl fmt::Debug for AnyKernel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("AnyKernel").field(&self.name).finish()
    }
}

impl fmt::Display for AnyKernel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name)
    }
}
