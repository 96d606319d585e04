//! Where the faces of a mesh lie: the questions of a check that look at positions, and what they find as defects.

mod changes;
mod questions;

use meshmend_core::{Build, Defect, DefectKind, Defects, EdgeUse, Element, FaceId, Lie, PolygonMesh, Watch};
use meshmend_repair::PassError;
use meshmend_spatial::{
    Contact, FacePair, InternalFaces, IntersectionOptions, Intersections, NestedComponent, Nesting,
    NestingState, OpenLoop, Shapes, Sliver, SliverKind, Surface, TJunction, internal_faces, intersections,
    nesting, open_loops, shapes, t_junctions,
};

pub use self::changes::{GeometryChange, GeometryChanges, GeometryMarks};
pub use self::questions::{GeometryOptions, Question, Questions};

/// What was found about where the faces of a mesh lie. What was not asked is `None`.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct GeometryReport {
    /// Which faces cross or touch.
    pub intersections: Option<Intersections>,
    /// The vertices on edges.
    pub t_junctions: Option<Vec<TJunction>>,
    /// The boundary loops.
    pub loops: Option<Vec<OpenLoop>>,
    /// What is inside of what.
    pub nesting: Option<Nesting>,
    /// The faces inside of what closed components enclose; `None` also where the search for crossings stopped at its budget.
    pub internal: Option<InternalFaces>,
    /// The faces that are too thin.
    pub shapes: Option<Shapes>,
}

impl GeometryReport {
    /// Asks about a mesh.
    ///
    /// # Errors
    /// When the distance is not a finite, non-negative number, the triangles of the faces have more corners than a table
    /// holds, or whoever watches stops it.
    ///
    /// *Cost*: that of [`intersections`], [`t_junctions`], [`open_loops`], [`nesting`], [`internal_faces`] and
    /// [`shapes`], as far as they are asked.
    pub fn of(mesh: &PolygonMesh, options: &GeometryOptions, watch: &Watch) -> Result<Self, PassError> {
        let asks = |question| options.questions.contains(question);
        let mut report = GeometryReport::default();
        if [Question::Crossings, Question::Nesting, Question::Internal].into_iter().any(asks) {
            watch.look("surface", 0, 0)?;
            report.ask_surface(&Surface::watched(mesh, watch)?, options)?;
        }
        if asks(Question::TJunctions) {
            report.t_junctions = Some(t_junctions(mesh, near(mesh, options)?, watch)?);
            watch.look("loops", 0, 0)?;
            mesh.complex().edges();
            watch.look("loops", 0, 0)?;
            report.loops = Some(open_loops(&EdgeUse::build(mesh.complex())?, mesh, watch)?);
        }
        if asks(Question::Shape) {
            watch.look("shape", 0, 0)?;
            report.shapes = Some(shapes(mesh, options.aspect));
        }
        Ok(report)
    }

    /// Asks what the triangles of all faces tell.
    fn ask_surface(&mut self, surface: &Surface<'_>, options: &GeometryOptions) -> Result<(), PassError> {
        let asks = |question| options.questions.contains(question);
        let asks_internal = asks(Question::Internal);
        if asks_internal || asks(Question::Crossings) {
            let how = IntersectionOptions { budget: options.budget, limit: options.limit };
            self.intersections = Some(intersections(surface, how)?);
        }
        if asks_internal || asks(Question::Nesting) {
            self.nesting = Some(nesting(surface)?);
        }
        if let (true, Some(found), Some(nesting)) = (asks_internal, &self.intersections, &self.nesting) {
            self.internal = internal_faces(surface, found, nesting)?;
        }
        Ok(())
    }

    /// How many defects of a kind were found. Of pairs of faces, where the search stopped at its budget, how many are listed.
    pub fn count(&self, kind: DefectKind) -> usize {
        let figures = self.intersections.as_ref().and_then(|found| found.figures.as_ref());
        let of = |contact| figures.map(|figures| figures.count(contact) as usize);
        let pairs = match kind {
            DefectKind::CrossingFaces => of(Contact::FaceFace),
            DefectKind::CoincidentFaces => of(Contact::Coincident),
            DefectKind::TouchingFaces => TOUCHING.iter().map(|&contact| of(contact)).sum(),
            _ => None,
        };
        pairs.unwrap_or_else(|| self.placeless(kind).count())
    }

    /// The defects of a kind, by ascending ids; of pairs of faces those that are listed.
    pub fn defects<'a>(&'a self, kind: DefectKind, mesh: &'a PolygonMesh) -> Defects<'a> {
        match kind {
            DefectKind::TJunction => {
                let found = self.t_junctions.iter().flatten();
                Box::new(found.map(|junction| junction.defect(mesh)))
            }
            _ => self.placeless(kind),
        }
    }

    /// The defects of a kind, T-junctions without their edges.
    fn placeless(&self, kind: DefectKind) -> Defects<'_> {
        let pairs = |is_of: fn(Contact) -> bool| {
            let all = self.intersections.iter().flat_map(|found| &found.pairs);
            all.filter(move |pair| is_of(pair.contact))
        };
        let components = |state| {
            let all = self.nesting.iter().flat_map(|nesting| &nesting.components);
            all.filter(move |component| component.state == Some(state))
        };
        match kind {
            DefectKind::CrossingFaces => Box::new(pairs(|c| c == Contact::FaceFace).map(crossing)),
            DefectKind::CoincidentFaces => Box::new(pairs(|c| c == Contact::Coincident).map(coincident)),
            DefectKind::TouchingFaces => Box::new(pairs(|c| TOUCHING.contains(&c)).map(touching)),
            DefectKind::SelfCrossingFace => {
                let faces = self.intersections.iter().flat_map(|found| &found.self_crossing);
                Box::new(faces.map(|&face| Defect::self_crossing_face(face)))
            }
            DefectKind::TJunction => {
                let found = self.t_junctions.iter().flatten();
                Box::new(found.map(move |junction| Defect::new(kind, Element::Vertex(junction.vertex))))
            }
            DefectKind::InsideOutComponent => {
                Box::new(components(NestingState::InsideOut).map(of_component(Defect::inside_out_component)))
            }
            DefectKind::SolidWithin => {
                Box::new(components(NestingState::SolidWithin).map(of_component(Defect::solid_within)))
            }
            DefectKind::NoVolume => {
                Box::new(components(NestingState::NoVolume).map(of_component(Defect::no_volume)))
            }
            DefectKind::InternalFace => {
                let faces = self.internal.iter().flat_map(|found| &found.internal);
                Box::new(faces.map(|&face| Defect::internal_face(face)))
            }
            DefectKind::InternalComponent => Box::new(self.internal_components().into_iter()),
            DefectKind::ZeroAreaFace => {
                let faces = self.shapes.iter().flat_map(|shapes| &shapes.zero_area);
                Box::new(faces.map(|&face| Defect::zero_area_face(face)))
            }
            DefectKind::SliverFace => {
                let slivers = self.shapes.iter().flat_map(|shapes| &shapes.slivers);
                Box::new(slivers.map(sliver_face))
            }
            _ => Box::new(std::iter::empty()),
        }
    }

    /// The components all of whose faces are internal.
    fn internal_components(&self) -> Vec<Defect> {
        let (Some(nesting), Some(found)) = (&self.nesting, &self.internal) else { return Vec::new() };
        let all = nesting.components.iter().zip(found.whole_components(nesting));
        let whole = all.filter_map(|(component, is_whole)| is_whole.then_some(component));
        whole.map(of_component(Defect::internal_component)).collect()
    }
}

/// The contacts of faces that touch.
const TOUCHING: [Contact; 4] =
    [Contact::VertexEdge, Contact::VertexFace, Contact::EdgeEdge, Contact::EdgeFace];

fn crossing(pair: &FacePair) -> Defect {
    let [one, other] = pair.faces;
    let how = if pair.is_coplanar { Lie::Overlapping } else { Lie::Through };
    Defect::crossing_faces(one, other, how)
}

fn coincident(pair: &FacePair) -> Defect {
    // The higher face is named beside the one before it, as duplicates are.
    Defect::coincident_faces(pair.faces[1], pair.faces[0])
}

fn touching(pair: &FacePair) -> Defect {
    let how = match pair.contact {
        Contact::EdgeFace => Lie::EdgeFace,
        Contact::EdgeEdge => Lie::EdgeEdge,
        Contact::VertexFace => Lie::VertexFace,
        Contact::VertexEdge => Lie::VertexEdge,
        // The contacts of other kinds.
        Contact::FaceFace | Contact::Coincident => Lie::Through,
    };
    Defect::touching_faces(pair.faces[0], pair.faces[1], how)
}

fn sliver_face(sliver: &Sliver) -> Defect {
    let shape = match sliver.kind {
        SliverKind::Needle => Lie::Needle,
        SliverKind::Cap => Lie::Cap,
    };
    Defect::sliver_face(sliver.face, shape)
}

fn of_component(defect: fn(FaceId, u32) -> Defect) -> impl Fn(&NestedComponent) -> Defect {
    move |component| defect(component.lowest_face, component.faces)
}

/// The distance from which on a vertex is on an edge.
fn near(mesh: &PolygonMesh, options: &GeometryOptions) -> Result<f64, PassError> {
    let near = options.near.length_on(mesh);
    if near.is_finite() && near >= 0.0 {
        return Ok(near);
    }
    let reason = format!("{near} is not a distance from which on a vertex is on an edge");
    Err(PassError::Request { pass: "geometry", reason })
}
