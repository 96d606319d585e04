//! The material library of a mesh that comes from another format.

use std::collections::BTreeSet;

use meshmend_core::{Metadata, counted};

use crate::document::{Material, Picture, extension};
use crate::formats::obj::name_statements::{KINDS, spelled};
use crate::output::companions::{Companion, Content};
use crate::output::material_losses::other_words_loss;
use crate::output::statements::one_line;
use crate::{Companions, Format, Loss, LossKind, Prepared};

/// Makes a library for the materials that another file describes, and names it in the output. Pictures within that file
/// become files beside the output.
pub(super) fn make_library(prepared: &mut Prepared) {
    let materials = prepared.materials();
    if prepared.options.materials.is_none() && prepared.options.shell.format() == Some(Format::Obj) {
        // The file names its libraries itself.
        let named = prepared.options.shell.companions().into_iter().map(|file| file.name);
        return prepared.named.extend(named);
    }
    if materials.is_empty() {
        return;
    }
    let is_wanted = prepared.options.companions == Companions::Copy && prepared.options.folder.is_some();
    let Some(stem) = prepared.options.stem.clone().filter(|_| is_wanted) else {
        prepared.losses.extend(Loss::if_any(LossKind::Material, materials.len(), |count| {
            let look = if count == 1 { "looks" } else { "look" };
            format!("what {} {look} like: no library is written", counted(count, "material"))
        }));
        return;
    };
    let mut library = Library { stem, text: Vec::new(), pictures: Vec::new(), named: Vec::new() };
    materials.iter().for_each(|material| library.add(material));
    let Library { stem, text, pictures, named } = library;
    let name = format!("{stem}.mtl").into_bytes();
    prepared.companions.push(Companion { name: name.clone(), content: Content::Bytes(text.into()) });
    prepared.companions.extend(pictures.into_iter().map(|(_, companion)| companion));
    prepared.named.extend(named);
    prepared.losses.extend(other_words_loss(&materials, "MTL"));
    let mut metadata = vec![Metadata { key: "mtllib".to_owned(), value: name }];
    metadata.extend_from_slice(prepared.mesh.metadata());
    prepared.mesh = prepared.mesh.clone().with_metadata(metadata);
}

/// A library that is being written.
struct Library {
    stem: String,
    text: Vec<u8>,
    /// The pictures that become files, with those.
    pictures: Vec<(Picture, Companion)>,
    /// The names of those that are files.
    named: Vec<Vec<u8>>,
}

impl Library {
    fn add(&mut self, material: &Material) {
        let [_, _, kind, _] = &KINDS;
        self.statement("newmtl", &spelled(kind, &material.name));
        self.color("Kd", material.base_color);
        self.color("Ke", material.emissive);
        for (word, number) in [("d", material.opacity), ("Pm", material.metallic), ("Pr", material.roughness)]
        {
            if let Some(number) = number {
                self.statement(word, number.to_string().as_bytes());
            }
        }
        self.picture("map_Kd", material.base_map.as_ref());
        self.picture("map_Ke", material.emissive_map.as_ref());
        self.picture("norm", material.normal_map.as_ref());
    }

    fn statement(&mut self, word: &str, value: &[u8]) {
        self.text.extend_from_slice(word.as_bytes());
        self.text.push(b' ');
        self.text.extend_from_slice(&one_line(value));
        self.text.push(b'\n');
    }

    fn color(&mut self, word: &str, color: Option<[f64; 3]>) {
        if let Some([red, green, blue]) = color {
            self.statement(word, format!("{red} {green} {blue}").as_bytes());
        }
    }

    fn picture(&mut self, word: &str, picture: Option<&Picture>) {
        match picture {
            Some(Picture::File(name)) => {
                self.statement(word, name);
                self.named.push(name.clone());
            }
            Some(embedded @ Picture::Embedded { name, bytes }) => {
                let made = self.pictures.iter().find(|(picture, _)| picture == embedded);
                let file = made.map(|(_, companion)| companion.name.clone()).unwrap_or_else(|| {
                    let file = self.free_name(name, extension(bytes));
                    let content = Content::Bytes(bytes.clone());
                    self.pictures.push((embedded.clone(), Companion { name: file.clone(), content }));
                    file
                });
                self.statement(word, &file);
            }
            None => {}
        }
    }

    /// A name for the file of a picture. It begins as that of the mesh file, so that the pictures of several files find
    /// room in one folder.
    fn free_name(&self, name: &str, extension: &str) -> Vec<u8> {
        let is_plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.');
        let plain: String = name.chars().map(|c| if is_plain(c) { c } else { '_' }).collect();
        let plain = plain.strip_suffix(&format!(".{extension}")).unwrap_or(&plain);
        let plain = if plain.is_empty() { "image" } else { plain };
        let names: BTreeSet<&[u8]> = self.pictures.iter().map(|(_, companion)| &companion.name[..]).collect();
        let candidates = (1..).map(|number| {
            let number = if number == 1 { String::new() } else { format!("_{number}") };
            format!("{}_{plain}{number}.{extension}", self.stem).into_bytes()
        });
        candidates.into_iter().find(|name| !names.contains(&name[..])).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceTable, PolygonMesh, VertexId};

    use super::*;
    use crate::WriteOptions;

    fn embedded(name: &str, bytes: &[u8]) -> Option<Picture> {
        Some(Picture::Embedded { name: name.to_owned(), bytes: bytes.into() })
    }

    fn written(options: WriteOptions) -> Prepared {
        let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
        let mesh = PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces).unwrap();
        let materials = vec![
            Material {
                base_color: Some([1.0, 0.5, 0.1]),
                opacity: Some(0.25),
                base_map: embedded("wood grain.png", b"\x89PNG1"),
                emissive_map: embedded("", b"\xff\xd8\xff"),
                ..Material::named("red paint")
            },
            Material {
                metallic: Some(1.0),
                roughness: Some(0.0),
                base_map: embedded("wood_grain", b"\x89PNG2"),
                normal_map: Some(Picture::File(b"n.png".to_vec())),
                emissive_map: embedded("wood grain.png", b"\x89PNG1"),
                others: vec!["occlusionTexture".to_owned()],
                ..Material::named("steel")
            },
        ];
        Prepared::new(&mesh, &options.with_materials(materials)).unwrap()
    }

    #[test]
    fn a_library_says_what_is_known_and_pictures_become_files() {
        let prepared = written(WriteOptions::default().for_path("out/car.obj".as_ref()));
        let names: Vec<String> =
            prepared.companions.iter().map(|file| String::from_utf8_lossy(&file.name).into_owned()).collect();
        assert_eq!(names, ["car.mtl", "car_wood_grain.png", "car_image.jpg", "car_wood_grain_2.png"]);
        let Content::Bytes(text) = &prepared.companions[0].content else { panic!("a text") };
        let expected = "newmtl red_paint\nKd 1 0.5 0.1\nd 0.25\nmap_Kd car_wood_grain.png\nmap_Ke car_image.jpg\n\
            newmtl steel\nPm 1\nPr 0\nmap_Kd car_wood_grain_2.png\nmap_Ke car_wood_grain.png\nnorm n.png\n";
        assert_eq!(String::from_utf8_lossy(text), expected.replace("red_paint", "red paint"));
        assert_eq!(prepared.named, [b"n.png".to_vec()]);
        let mut obj = Vec::new();
        prepared.encode(&mut obj).unwrap();
        assert!(obj.starts_with(b"mtllib car.mtl\nv "));
        let messages: Vec<String> = prepared.losses().into_iter().map(|loss| loss.message).collect();
        assert_eq!(messages, ["1 statement about materials that MTL has no word for: `occlusionTexture`"]);
    }

    #[test]
    fn without_a_folder_there_is_no_library() {
        let skipped = WriteOptions::default().for_path("car.obj".as_ref()).with_companions(Companions::Skip);
        for options in [WriteOptions::of(Format::Obj), skipped] {
            let prepared = written(options);
            let messages: Vec<String> = prepared.losses().into_iter().map(|loss| loss.message).collect();
            assert_eq!(messages, ["what 2 materials look like: no library is written"]);
            assert!(prepared.companions.is_empty() && prepared.mesh().metadata().is_empty());
        }
    }
}
