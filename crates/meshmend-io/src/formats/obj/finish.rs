//! The end of reading: layers are made of what the statements gave, with notes about them.

use meshmend_core::{Carry, Domain, Layer, Values};

use crate::formats::obj::name_statements::KINDS;
use crate::formats::obj::reader::Reader;
use crate::formats::obj::shape::ObjShape;
use crate::input::indices::Uses;
use crate::input::source::Parsed;
use crate::{Encoding, Format, NoteKind, Place, ReadError, Shell};

impl Reader<'_> {
    pub(super) fn finish(mut self) -> Result<Parsed, ReadError> {
        if !self.is_obj {
            return Err(self.source.malformed(Place::Line(1), "no statement of an OBJ file"));
        }
        let shape = ObjShape { has_alpha: self.colors.has_alpha(), ..ObjShape::default() };
        self.vertex_layers();
        let texcoords = self.corner_layers();
        self.name_layers();
        self.loose_layers(texcoords.as_ref());
        let source = self.source;
        let (mesh, notes) = self.parts.assemble(source, 1, |at| source.line(at))?;
        let shell = Shell::of_file(Format::Obj, Encoding::Ascii, shape);
        Ok(Parsed::whole(mesh, notes, shell))
    }

    fn name_layers(&mut self) {
        let (source, elements) = (self.source, self.elements());
        let mut loose = Vec::new();
        for (runs, kind) in std::mem::take(&mut self.names).into_iter().zip(&KINDS) {
            let (layers, unused) = runs.layers(kind, elements);
            let (of_faces, others): (Vec<Layer>, _) =
                layers.into_iter().partition(|layer| layer.domain() == Domain::Face);
            self.parts.layers.extend(of_faces);
            loose.extend(others);
            let message = format!("names of `{}` that no element has were skipped", kind.layer);
            let first = || source.line(unused.first);
            self.parts.notes.add_many(NoteKind::UnusedName, &message, unused.count, first);
        }
        self.parts.layers.extend(loose);
    }

    fn vertex_layers(&mut self) {
        let vertices = self.parts.positions.len();
        if let Some(weights) = self.weights.take() {
            let values = Values::F64(weights);
            self.parts.layers.push(Layer::direct("weight", Domain::Vertex, 1, Carry::Interpolate, values));
        }
        let colors = std::mem::take(&mut self.colors);
        self.parts.layers.extend(colors.layer(vertices));
    }

    /// Adds the layers of texture coordinates and normals, and returns the former.
    fn corner_layers(&mut self) -> Option<Layer> {
        self.note_mixed_widths();
        let texcoords = std::mem::take(&mut self.texcoords.values);
        let normals = std::mem::take(&mut self.normals.values);
        let texcoord_uses = std::mem::take(&mut self.texcoord_uses);
        let normal_uses = std::mem::take(&mut self.normal_uses);
        let texcoords = self.corner_layer("texcoord", self.texcoords.width, texcoords, texcoord_uses);
        let normals = self.corner_layer("normal", 3, normals, normal_uses);
        self.parts.layers.extend(texcoords.iter().cloned().chain(normals));
        texcoords
    }

    fn note_mixed_widths(&mut self) {
        let message = "texture coordinates of several widths were padded with zeros";
        self.parts.notes.add_many(NoteKind::MixedWidths, message, self.texcoords.mixed, || Place::File);
    }

    fn corner_layer(&mut self, name: &str, width: usize, pool: Vec<f64>, uses: Uses) -> Option<Layer> {
        if uses.is_empty() && pool.is_empty() {
            return None;
        }
        let width = width.max(1);
        let (uses, wrong) = uses.checked(self.parts.faces.corner_count(), pool.len() / width);
        if let Some((count, at)) = wrong.filter(|&(count, _)| count > 0) {
            self.note_out_of_range(count, at);
        }
        let values = Values::F64(pool);
        let layer = Layer::indexed(name, Domain::Corner, width, Carry::Interpolate, values, uses);
        (!layer.values().is_empty()).then_some(layer)
    }
}
