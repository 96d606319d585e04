//! What is left to do when all statements have been read: layers, and what there is to note about them.

use meshmend_core::{Carry, Domain, Layer, Values};

use crate::assemble::Uses;
use crate::obj::ObjShape;
use crate::obj::names::KINDS;
use crate::obj::read::Reader;
use crate::read::Parsed;
use crate::shell::Shape;
use crate::{Encoding, NoteKind, Place, ReadError, Shell};

impl Reader<'_> {
    pub(super) fn finish(mut self) -> Result<Parsed, ReadError> {
        if !self.is_obj {
            return Err(self.source.malformed(Place::Line(1), "no statement of an OBJ file"));
        }
        self.vertex_layers();
        self.corner_layers();
        let faces = self.parts.faces.face_count();
        self.note_unused_names();
        let names = std::mem::take(&mut self.names);
        self.parts
            .layers
            .extend(names.into_iter().zip(&KINDS).filter_map(|(runs, kind)| runs.layer(kind, faces)));
        let source = self.source;
        let (mesh, notes) = self.parts.assemble(source, 1, |at| source.line(at))?;
        let shell = Shell::of_file(Encoding::Ascii, Shape::Obj(ObjShape));
        Ok(Parsed { mesh, variant: "obj", notes, shell })
    }

    fn note_unused_names(&mut self) {
        let source = self.source;
        for (runs, kind) in self.names.iter().zip(&KINDS) {
            let Some((count, at)) = runs.unused() else { continue };
            let message = format!("names of `{}` that no face has were skipped", kind.layer);
            self.parts.notes.add_many(NoteKind::UnusedName, &message, count, || source.line(at));
        }
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

    fn corner_layers(&mut self) {
        self.note_mixed_widths();
        let texcoords = std::mem::take(&mut self.texcoords.values);
        let normals = std::mem::take(&mut self.normals.values);
        let texcoord_uses = std::mem::take(&mut self.texcoord_uses);
        let normal_uses = std::mem::take(&mut self.normal_uses);
        self.corner_layer("texcoord", self.texcoords.width, texcoords, texcoord_uses);
        self.corner_layer("normal", 3, normals, normal_uses);
    }

    fn note_mixed_widths(&mut self) {
        let message = "texture coordinates of several widths were padded with zeros";
        self.parts.notes.add_many(NoteKind::MixedWidths, message, self.texcoords.mixed, || Place::File);
    }

    fn corner_layer(&mut self, name: &str, width: usize, pool: Vec<f64>, uses: Uses) {
        if uses.is_empty() && pool.is_empty() {
            return;
        }
        let width = width.max(1);
        let (uses, wrong) = uses.checked(self.parts.faces.corner_count(), pool.len() / width);
        if let Some((count, at)) = wrong.filter(|&(count, _)| count > 0) {
            self.note_out_of_range(count, at);
        }
        if !pool.is_empty() {
            let values = Values::F64(pool);
            let layer = Layer::indexed(name, Domain::Corner, width, Carry::Interpolate, values, uses);
            self.parts.layers.push(layer);
        }
    }
}
