//! The materials of a library.

use crate::formats::obj::library::{image, without_options};
use crate::text::{trimmed, word, words};
use crate::{Material, Picture};

/// The materials that a library describes. Only pictures that are there are named.
pub(super) fn materials(text: &[u8], is_there: &dyn Fn(&[u8]) -> bool) -> Vec<Material> {
    let mut materials: Vec<Material> = Vec::new();
    for line in text.split(|&byte| byte == b'\n' || byte == b'\r').map(trimmed) {
        let keyword = word(line, 0);
        let rest = trimmed(&line[keyword.len()..]);
        if keyword.eq_ignore_ascii_case(b"newmtl") {
            materials.push(Material::named(rest));
        } else if let Some(material) =
            materials.last_mut().filter(|_| !keyword.is_empty() && keyword[0] != b'#')
        {
            Statement { keyword, line, rest }.add_to(material, is_there);
        }
    }
    materials
}

/// A statement about a material.
struct Statement<'a> {
    keyword: &'a [u8],
    line: &'a [u8],
    rest: &'a [u8],
}

impl Statement<'_> {
    fn add_to(&self, material: &mut Material, is_there: &dyn Fn(&[u8]) -> bool) {
        let is_understood = match &self.keyword.to_ascii_lowercase()[..] {
            b"kd" => put(self.color(), &mut material.base_color),
            b"ke" => put(self.color(), &mut material.emissive),
            b"d" => put(self.number(), &mut material.opacity),
            b"tr" => put(self.number().map(|transparency| 1.0 - transparency), &mut material.opacity),
            b"pm" => put(self.number(), &mut material.metallic),
            b"pr" => put(self.number(), &mut material.roughness),
            b"map_kd" => self.picture(&mut material.base_map, is_there),
            b"map_ke" => self.picture(&mut material.emissive_map, is_there),
            b"norm" => self.picture(&mut material.normal_map, is_there),
            _ => false,
        };
        if !is_understood {
            material.others.push(String::from_utf8_lossy(self.keyword).into_owned());
        }
    }

    /// Three numbers, or one for all three.
    fn color(&self) -> Option<[f64; 3]> {
        let numbers: Option<Vec<f64>> = words(self.rest).map(number).collect();
        match numbers?[..] {
            [gray] => Some([gray; 3]),
            [red, green, blue] => Some([red, green, blue]),
            _ => None,
        }
    }

    fn number(&self) -> Option<f64> {
        number(self.rest)
    }

    /// Takes a picture; whether nothing else is said of it.
    fn picture(&self, slot: &mut Option<Picture>, is_there: &dyn Fn(&[u8]) -> bool) -> bool {
        let readings = image(self.line);
        let name = readings.iter().flatten().find(|name| is_there(name));
        *slot = name.map(|name| Picture::File(name.to_vec()));
        without_options(self.rest) == self.rest
    }
}

fn number(text: &[u8]) -> Option<f64> {
    fast_float2::parse(text).ok().filter(|x: &f64| x.is_finite())
}

/// Puts a value where it belongs; whether there is one.
fn put<T>(value: Option<T>, slot: &mut Option<T>) -> bool {
    let is_there = value.is_some();
    *slot = value.or(slot.take());
    is_there
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_library_says_is_kept_by_material() {
        let text = b"Kd 9 9 9\r\nnewmtl red paint\nKa 1 1 1\n\tKd 1 0.5 0 \nd 0.25\nmap_Kd -s 2 2 my red.png\n\
            newmtl glow\n# illum\nKe 0.5\nTr 0.75\nPr .5\nPm 1\nmap_Ke none.png\nnorm n.png\nNs 10\nd -halo 0.5\nKd spectral a.rfl";
        let [red, glow] = &materials(text, &|name| name != b"none.png")[..] else { panic!("two materials") };
        assert_eq!(
            (&red.name[..], red.base_color, red.opacity),
            (&b"red paint"[..], Some([1.0, 0.5, 0.0]), Some(0.25))
        );
        assert_eq!(red.base_map, Some(Picture::File(b"my red.png".to_vec())));
        assert_eq!(red.others, ["Ka", "map_Kd"]);
        assert_eq!((glow.emissive, glow.opacity), (Some([0.5; 3]), Some(0.25)));
        assert_eq!((glow.roughness, glow.metallic), (Some(0.5), Some(1.0)));
        assert_eq!((&glow.emissive_map, &glow.normal_map), (&None, &Some(Picture::File(b"n.png".to_vec()))));
        assert_eq!(glow.others, ["Ns", "d", "Kd"]);
    }
}
