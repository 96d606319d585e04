//! A random mesh that is repaired with random options.

use std::fmt::Write;

use meshmend_tests::scratch::Scratch;

use crate::asked::{Asked, Outcome};
use crate::meshes::{solids, soup, spoil, strip};
use crate::options::options;
use crate::random::Random;

/// A mesh, how it is stored, and what is asked of its repair.
#[derive(Clone)]
pub(crate) struct Case {
    positions: Vec<[f64; 3]>,
    faces: Vec<Vec<u32>>,
    /// The material of each face, and for each face whether its corners have texture coordinates of their own.
    looks: Vec<(u8, bool)>,
    input: &'static str,
    output: &'static str,
    options: Vec<[&'static str; 2]>,
}

impl Case {
    pub(crate) fn random(seed: u64) -> Self {
        let random = &mut Random(seed);
        let (mut positions, mut faces) = match random.below(5) {
            0 => strip(random),
            1 => solids(random),
            _ => soup(random),
        };
        spoil(random, &mut positions, &mut faces);
        let materials = random.one(&[1, 1, 2]);
        let has_textures = random.percent(20);
        let looks = faces
            .iter()
            .map(|_| (random.below(materials) as u8, has_textures && random.percent(50)))
            .collect();
        let input = random.one(&["obj", "obj", "off", "ply", "stl"]);
        let output = random.one(&["obj", "off", "ply", "ply", "stl", "stl"]);
        Case { positions, faces, looks, input, output, options: options(random) }
    }

    /// The file that stores the mesh.
    pub(crate) fn text(&self) -> String {
        match self.input {
            "obj" => self.obj(),
            "stl" => self.stl(),
            "off" => self.table("OFF\n", "0"),
            _ => self.table("", ""),
        }
    }

    pub(crate) fn obj(&self) -> String {
        let mut text = String::new();
        for [x, y, z] in &self.positions {
            writeln!(text, "v {x:?} {y:?} {z:?}").unwrap();
        }
        text.push_str("vt 0 0\nvt 0 1\nvt 1 0\n");
        for (number, (face, &(material, is_textured))) in self.faces.iter().zip(&self.looks).enumerate() {
            writeln!(text, "usemtl m{material}").unwrap();
            text.push('f');
            for (place, v) in face.iter().enumerate() {
                match is_textured {
                    true => write!(text, " {}/{}", v + 1, (place + number) % 3 + 1).unwrap(),
                    false => write!(text, " {}", v + 1).unwrap(),
                }
            }
            text.push('\n');
        }
        text
    }

    /// The first three corners of each face.
    pub(crate) fn stl(&self) -> String {
        let mut text = "solid s\n".to_owned();
        for face in self.faces.iter().filter(|face| face.len() > 2) {
            text.push_str("facet normal 0 0 0\nouter loop\n");
            for &v in &face[..3] {
                let [x, y, z] = self.positions[v as usize];
                writeln!(text, "vertex {x:?} {y:?} {z:?}").unwrap();
            }
            text.push_str("endloop\nendfacet\n");
        }
        text + "endsolid s\n"
    }

    /// As OFF, or where there is no keyword as PLY.
    pub(crate) fn table(&self, keyword: &str, edges: &str) -> String {
        let (vertices, faces) = (self.positions.len(), self.faces.len());
        let mut text = if keyword.is_empty() {
            let numbers = "property double x\nproperty double y\nproperty double z\n";
            let list = "property list uchar int vertex_indices\n";
            format!(
                "ply\nformat ascii 1.0\nelement vertex {vertices}\n{numbers}element face {faces}\n{list}end_header\n"
            )
        } else {
            format!("{keyword}{vertices} {faces} {edges}\n")
        };
        for [x, y, z] in &self.positions {
            writeln!(text, "{x:?} {y:?} {z:?}").unwrap();
        }
        for face in &self.faces {
            write!(text, "{}", face.len()).unwrap();
            face.iter().for_each(|v| write!(text, " {v}").unwrap());
            text.push('\n');
        }
        text
    }

    pub(crate) fn outcome(&self, seed: u64) -> Outcome {
        let scratch = Scratch::new();
        let stored = scratch.path().join(format!("stored.{}", self.input));
        std::fs::write(&stored, self.text()).unwrap();
        self.asked().outcome(&stored, seed.is_multiple_of(8))
    }

    pub(crate) fn asked(&self) -> Asked {
        Asked { output: self.output, options: self.options.iter().flatten().copied().collect() }
    }
    /// The same kind of failure with as few faces and options as can be.
    pub(crate) fn shrunk(self, seed: u64) -> Self {
        let mut least = self;
        loop {
            let fewer_options = (0..least.options.len()).map(|at| {
                let mut case = least.clone();
                case.options.remove(at);
                case
            });
            let fewer_faces = (0..least.faces.len()).map(|at| {
                let mut case = least.clone();
                case.faces.remove(at);
                case.looks.remove(at);
                case
            });
            let fewer_corners = (0..least.faces.len()).filter(|&at| least.faces[at].len() > 3).map(|at| {
                let mut case = least.clone();
                case.faces[at].pop();
                case
            });
            let plainer = (0..least.faces.len()).filter(|&at| least.looks[at] != (0, false)).map(|at| {
                let mut case = least.clone();
                case.looks[at] = (0, false);
                case
            });
            let smaller = fewer_options.chain(fewer_faces).chain(fewer_corners).chain(plainer);
            let found = smaller.into_iter().find(|case| matches!(case.outcome(seed), Outcome::Wrong(_)));
            match found {
                Some(case) => least = case,
                None => return least,
            }
        }
    }

    pub(crate) fn told(&self, seed: u64) -> String {
        let why = match self.outcome(seed) {
            Outcome::Wrong(why) => why,
            _ => "nothing".to_owned(),
        };
        let options = self.options.concat().join(" ");
        let path = std::env::temp_dir().join(format!("second-run-{seed}.{}", self.input));
        std::fs::write(&path, self.text()).unwrap();
        format!("{seed}: {} -o 1.{} {options}: {why}", path.display(), self.output)
    }
}
