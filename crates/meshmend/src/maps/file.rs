//! The maps of all meshes of a file, as arrays under their names.

use std::io::{self, Write};

use meshmend_core::Blend;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::array::{Array, Values};
use super::{CAUSES, ElementMap, ElementMaps, npy};
use crate::files::{PartOutcome, RepairedFile};

/// Stands for no element.
const NONE: i64 = -1;

/// The maps of all meshes of a file that was repaired.
#[derive(Clone, Debug, Default)]
pub struct MapsFile {
    arrays: Vec<Array>,
}

impl MapsFile {
    /// The maps of a file. Parts that were not repaired have none.
    ///
    /// *Cost*: O(n log n) for n elements.
    pub fn of(repaired: &RepairedFile) -> Self {
        let mut file = MapsFile::default();
        match repaired {
            RepairedFile::Mesh(mesh) => file.add("", &ElementMaps::of(&mesh.file.mesh, &mesh.repaired)),
            RepairedFile::Parts(parts) => {
                for (number, outcome) in &parts.parts {
                    if let PartOutcome::Repaired(part) = outcome {
                        file.add(&format!("part{number}/"), &ElementMaps::of(&part.stored, &part.repaired));
                    }
                }
            }
        }
        let causes = Array { name: "causes".to_owned(), width: 1, values: Values::Words(CAUSES) };
        file.arrays.push(causes);
        file
    }

    fn add(&mut self, prefix: &str, maps: &ElementMaps) {
        let ElementMaps { vertices, faces, corners, flipped, created } = maps;
        for (kind, one, map) in
            [("vertices", "vertex", vertices), ("faces", "face", faces), ("corners", "corner", corners)]
        {
            self.add_map(prefix, (kind, one), map);
        }
        let flipped = flipped.iter().map(|&is_flipped| is_flipped.into()).collect();
        self.push(format!("{prefix}faces_flipped"), 1, Values::Bytes(flipped));
        let (mut from, mut inside) = (Vec::new(), Vec::new());
        for &(_, blend) in created {
            let (between, face) = match blend {
                Some(Blend::Along { from, to, numerator, denominator }) => {
                    ([from.0, to.0, numerator, denominator].map(i64::from), NONE)
                }
                Some(Blend::Inside { face }) => ([NONE; 4], face.0.into()),
                None => ([NONE; 4], NONE),
            };
            from.extend(between);
            inside.push(face);
        }
        let vertices = created.iter().map(|(vertex, _)| vertex.0.into()).collect();
        self.push(format!("{prefix}created_vertices"), 1, Values::Integers(vertices));
        self.push(format!("{prefix}created_from"), 4, Values::Integers(from));
        self.push(format!("{prefix}created_in_face"), 1, Values::Integers(inside));
    }

    fn add_map(&mut self, prefix: &str, (kind, one): (&str, &str), map: &ElementMap) {
        let new_to_old = map.new_to_old.iter().map(|old| old.map_or(NONE, i64::from)).collect();
        self.push(format!("{prefix}{kind}_new_to_old"), 1, Values::Integers(new_to_old));
        let starts = map.starts.iter().map(|&start| start as i64).collect();
        self.push(format!("{prefix}{kind}_old_to_new_starts"), 1, Values::Integers(starts));
        let items = map.items.iter().map(|&new| new.into()).collect();
        self.push(format!("{prefix}{kind}_old_to_new_items"), 1, Values::Integers(items));
        let causes = map.causes.iter().map(|&cause| cause as u8).collect();
        self.push(format!("{prefix}cause_old_{one}"), 1, Values::Bytes(causes));
    }

    fn push(&mut self, name: String, width: usize, values: Values) {
        self.arrays.push(Array { name, width, values });
    }

    /// Writes the arrays for numpy: `numpy.load(file, allow_pickle=False)`.
    ///
    /// # Errors
    /// If the sink can't take it.
    pub fn npz(&self, out: &mut dyn Write) -> io::Result<()> {
        npy::npz(&self.arrays, out)
    }

    /// Writes the arrays as one JSON object and a line end.
    ///
    /// # Errors
    /// If the sink can't take it.
    pub fn json(&self, out: &mut dyn Write) -> io::Result<()> {
        serde_json::to_writer(&mut *out, self)?;
        out.write_all(b"\n")
    }
}

impl Serialize for MapsFile {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.arrays.len()))?;
        self.arrays.iter().try_for_each(|array| map.serialize_entry(&array.name, array))?;
        map.end()
    }
}
