//! What is done with a mesh.

use meshmend_core::{Connectivity, PolygonMesh};
use meshmend_io::{Format, Shell, WriteOptions, encode, held_layers};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_render::{
    Camera, Outlines, Scene, Size, boundary, components, inconsistent, non_manifold, witness,
};
use meshmend_repair::{Emptying, Plan, Side, SplitEdges, TriangulateFaces};
use meshmend_topology::{TopologyReport, topology};

use crate::families::read_any;

/// What is done with a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Work {
    /// Nothing; it is made, as for all work.
    Make,
    /// The whole report.
    Check,
    /// The default pipeline.
    Repair,
    /// The pipeline that cuts where it is not beyond doubt what belongs together.
    Cut,
    /// The pipeline that splits vertices alone.
    PinchOnly,
    /// The pipeline that cuts all faces into triangles.
    Triangulate,
    /// The pipeline that turns shells by how they are nested.
    OutwardNested,
    /// Writing every format in every encoding, reading that, and writing it as it was read.
    Files,
    /// A picture of what is wrong, written in both formats.
    Render,
}

impl Work {
    /// All that is compared.
    pub(crate) const ALL: [Work; 8] = [
        Work::Check,
        Work::Repair,
        Work::Cut,
        Work::PinchOnly,
        Work::Triangulate,
        Work::OutwardNested,
        Work::Files,
        Work::Render,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Work::Make => "make",
            Work::Check => "check",
            Work::Repair => "repair",
            Work::Cut => "cut",
            Work::PinchOnly => "pinch-only",
            Work::Triangulate => "triangulate",
            Work::OutwardNested => "outward-nested",
            Work::Files => "files",
            Work::Render => "render",
        }
    }

    pub(crate) fn named(name: &str) -> Option<Self> {
        Work::ALL.into_iter().chain([Work::Make]).find(|work| work.name() == name)
    }

    /// The work of these names, all if there is none; nothing if one is not known.
    pub(crate) fn all_named(names: &[String]) -> Option<Vec<Self>> {
        if names.is_empty() {
            Some(Work::ALL.to_vec())
        } else {
            names.iter().map(|name| Work::named(name)).collect()
        }
    }

    pub(crate) fn run(self, mesh: &PolygonMesh, shell: &Shell) {
        match self {
            Work::Make => {}
            Work::Check => {
                KernelKind::EdgeUse.run(mesh.complex(), Report(mesh)).expect("the kernel holds anything");
            }
            Work::Repair => repair(mesh, |_| ()),
            Work::Cut => repair(mesh, |plan| plan.split.edges = SplitEdges::Cut),
            Work::PinchOnly => repair(mesh, |plan| plan.split.edges = SplitEdges::PinchOnly),
            Work::Triangulate => repair(mesh, |plan| plan.triangulate.faces = TriangulateFaces::All),
            Work::OutwardNested => repair(mesh, |plan| plan.orient.side = Side::OutwardNested),
            Work::Files => files(mesh, shell),
            Work::Render => render(mesh),
        }
    }
}

fn repair(mesh: &PolygonMesh, choose: impl FnOnce(&mut Plan)) {
    let mut plan = Plan::default();
    choose(&mut plan);
    plan.pipeline().on_emptying(Emptying::Allow).run(mesh).expect("these policies take any mesh");
}

fn files(mesh: &PolygonMesh, shell: &Shell) {
    for (format, encoding) in Format::ALL.iter().flat_map(|&f| f.encodings().iter().map(move |&e| (f, e))) {
        let options = WriteOptions::of(format).with_encoding(encoding).with_shell(shell.clone());
        let file = read_any(&written(mesh, &options), format);
        // As it was read, and in a format that holds no names of properties.
        for format in [format, Format::Obj] {
            written(&file.mesh, &WriteOptions::of(format).as_read(&file));
        }
    }
}

fn written(mesh: &PolygonMesh, options: &WriteOptions) -> Vec<u8> {
    let mut bytes = Vec::new();
    encode(mesh, options, &mut bytes).expect("any mesh can be written");
    held_layers(mesh, options);
    bytes
}

fn render(mesh: &PolygonMesh) {
    let camera = Camera::from_angles(-45.0, 30.0).expect("a direction");
    let overlays =
        vec![boundary(mesh), non_manifold(mesh), inconsistent(mesh), witness(mesh), components(mesh)];
    let scene = Scene { mesh: mesh.clone(), camera, outlines: Outlines::Drawn, overlays, caption: None };
    let size = Size::new(400, 300).expect("a size of pictures");
    let picture = meshmend_render::render(&scene, size).expect("overlays of the mesh");
    picture.write_png(&mut std::io::sink()).expect("a sink takes all");
    picture.write_svg(&mut std::io::sink()).expect("a sink takes all");
}

struct Report<'a>(&'a PolygonMesh);

impl KernelTask for Report<'_> {
    type Output = TopologyReport;
    fn run<K: Connectivity>(self, kernel: &K) -> TopologyReport {
        topology(kernel, self.0)
    }
}
