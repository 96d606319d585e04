//! What is on a picture, told as facts.

#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;

use meshmend_core::{EdgeId, FaceId, FaceTableBuilder, PolygonMesh, VertexId};
use meshmend_render::{
    Camera, Fit, Outlines, Overlay, Picture, Projection, RenderError, Scene, Size, boundary, components,
    contact_sheet, inconsistent, loops, non_manifold, render, seam, witness,
};
use meshmend_shapes::{Closed, surface};

fn mesh(positions: &[[f64; 3]], faces: &[&[u32]]) -> PolygonMesh {
    let mut builder = FaceTableBuilder::default();
    faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
    PolygonMesh::new(positions.to_vec(), builder.build(positions.len()).unwrap()).unwrap()
}

const CUBE: [&[u32]; 6] =
    [&[0, 2, 3, 1], &[4, 5, 7, 6], &[0, 1, 5, 4], &[1, 3, 7, 5], &[3, 2, 6, 7], &[2, 0, 4, 6]];

fn cube_corners() -> Vec<[f64; 3]> {
    (0..8).map(|k| [k & 1, k >> 1 & 1, k >> 2 & 1].map(f64::from)).collect()
}

fn from_above() -> Camera {
    Camera::from([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]).unwrap()
}

fn size(width: u32, height: u32) -> Size {
    Size::new(width, height).unwrap()
}

fn seen_from_above(mesh: PolygonMesh) -> Scene {
    Scene { camera: from_above(), ..Scene::of(mesh) }
}

fn pixel(picture: &Picture, x: usize, y: usize) -> [u8; 3] {
    picture.pixels()[y * picture.size().width() as usize + x]
}

fn svg(picture: &Picture) -> String {
    let mut bytes = Vec::new();
    picture.write_svg(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn png(picture: &Picture) -> Vec<u8> {
    let mut bytes = Vec::new();
    picture.write_png(&mut bytes).unwrap();
    bytes
}

/// A band of triangles that comes back mirrored.
fn moebius_band() -> PolygonMesh {
    let points = (0..12).map(|k| {
        let (turn, side) = (f64::from(k / 2) / 6.0, f64::from(k % 2 * 2 - 1) * 0.4);
        let (round, twist) = (std::f64::consts::TAU * turn, std::f64::consts::PI * turn);
        let radius = 1.0 + side * twist.cos();
        [radius * round.cos(), radius * round.sin(), side * twist.sin()]
    });
    let faces: Vec<Vec<u32>> = (0..6)
        .flat_map(|k| {
            let [a, b] = [2 * k, 2 * k + 1];
            let [c, d] = if k == 5 { [1, 0] } else { [2 * k + 2, 2 * k + 3] };
            [vec![a, c, b], vec![b, c, d]]
        })
        .collect();
    let faces: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
    mesh(&points.collect::<Vec<_>>(), &faces)
}

#[test]
fn a_cube_seen_along_an_axis_covers_exactly_its_square() {
    // One row of 20 pixels is left for what a legend may have to say, and 8 at each border.
    let picture = render(&seen_from_above(mesh(&cube_corners(), &CUBE)), size(116, 136)).unwrap();
    let pixels = picture.pixels();
    let colours: BTreeSet<[u8; 3]> = pixels.iter().copied().collect();
    assert_eq!(colours.len(), 2, "a face in one shade, and paper");
    for (place, colour) in pixels.iter().enumerate() {
        let (x, y) = (place % 116, place / 116);
        let is_inside = (8..108).contains(&x) && (8..108).contains(&y);
        assert_eq!(*colour != [255; 3], is_inside, "at {x}, {y}");
    }
    assert_eq!(picture.legend(), Vec::<&str>::new());
}

#[test]
fn the_nearer_face_is_seen_whatever_the_order_of_faces() {
    let points = [
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [4.0, 4.0, 0.0],
        [0.0, 4.0, 0.0],
        [1.0, 1.0, 1.0],
        [3.0, 1.0, 2.0],
        [1.0, 3.0, 1.0],
    ];
    let faces: [&[u32]; 2] = [&[0, 1, 2, 3], &[4, 5, 6]];
    let pictures = [[0, 1], [1, 0]].map(|order| {
        let picture =
            render(&seen_from_above(mesh(&points, &order.map(|k| faces[k]))), size(100, 120)).unwrap();
        (picture.pixels(), svg(&picture))
    });
    assert!(pictures[0] == pictures[1]);
    let colours: BTreeSet<[u8; 3]> = pictures[0].0.iter().copied().collect();
    assert!(colours.len() > 2, "both faces are seen");
}

#[test]
fn backs_are_darker_hatched_and_named() {
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let picture = |face: &[u32]| render(&seen_from_above(mesh(&square, &[face])), size(116, 136)).unwrap();
    let (front, back) = (picture(&[0, 1, 2, 3]), picture(&[3, 2, 1, 0]));
    let inside = |picture: &Picture| -> BTreeSet<[u8; 3]> {
        let pixels = picture.pixels();
        (20..90).flat_map(|y| (20..90).map(move |x| (x, y))).map(|(x, y)| pixels[y * 116 + x]).collect()
    };
    assert_eq!(inside(&front).len(), 1);
    assert!(inside(&back).len() > 1, "hatched");
    let grey = |colour: &[u8; 3]| colour.iter().map(|&part| u32::from(part)).sum::<u32>();
    assert!(inside(&back).iter().all(|colour| grey(colour) + 60 < grey(inside(&front).first().unwrap())));
    assert_eq!((front.legend(), back.legend()), (vec![], vec!["back of a face"]));
}

#[test]
fn the_legend_lists_just_what_is_there() {
    let all = |mesh: PolygonMesh| {
        let overlays = vec![
            boundary(&mesh),
            non_manifold(&mesh),
            inconsistent(&mesh),
            witness(&mesh),
            components(&mesh),
        ];
        let picture = render(&Scene { overlays, ..Scene::of(mesh) }, size(400, 300)).unwrap();
        picture.legend().into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(all(mesh(&cube_corners(), &CUBE)), ["component 0"]);
    let band = all(moebius_band());
    for entry in ["boundary", "inconsistent edges", "one-sided strip", "component 0", "back of a face"] {
        assert!(band.iter().any(|text| text == entry), "{entry}: {band:?}");
    }
    assert!(!band.iter().any(|text| text.starts_with("non-manifold")));
    let open_cube = all(mesh(&cube_corners(), &CUBE[1..]));
    assert!(open_cube.contains(&"behind faces".to_owned()), "{open_cube:?}");
    let bow_tie: [&[u32]; 2] = [&[0, 1, 2], &[0, 4, 3]];
    let points = [[0.0; 3], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, -1.0, 0.0], [-1.0, 1.0, 0.0]];
    assert!(all(mesh(&points, &bow_tie)).contains(&"non-manifold vertices".to_owned()));
}

#[test]
fn a_long_legend_ends_with_how_many_more_there_are() {
    let torus_like = mesh(&cube_corners(), &CUBE);
    let loops = (0..9).map(|k| vec![VertexId(k % 8), VertexId((k + 1) % 8)]).collect();
    let scene = Scene { overlays: vec![Overlay::Generators { loops, more: 3 }], ..Scene::of(torus_like) };
    let picture = render(&scene, size(400, 300)).unwrap();
    assert!(picture.legend().contains(&"and 3 more generators"), "{:?}", picture.legend());
    assert!(picture.legend().contains(&"not drawn: 3 generators"), "{:?}", picture.legend());
    let small = render(&scene, size(200, 100)).unwrap();
    assert_eq!(small.legend(), ["and 9 more"]);
}

#[test]
fn a_line_that_is_seen_is_on_the_picture_and_one_behind_is_pale() {
    let cube = mesh(&cube_corners(), &CUBE);
    let edge_between = |ends: [u32; 2]| {
        let ends = ends.map(VertexId);
        cube.complex().edges().edges().find(|&e| cube.complex().edges().ends(e) == ends).unwrap()
    };
    let with = |edge: EdgeId| {
        let scene = Scene { overlays: vec![Overlay::Seam { edges: vec![edge] }], ..Scene::of(cube.clone()) };
        let picture = render(&scene, size(500, 200)).unwrap();
        let darkest = picture.pixels()[..500 * 160].iter().map(|colour| colour[0]).min().unwrap();
        (picture.legend().contains(&"behind faces"), darkest)
    };
    // From the right, in front and above: the edge from v4 to v5 is in front, the one from v2 to v6 behind.
    assert_eq!(with(edge_between([4, 5])), (false, 20));
    let (is_behind, darkest) = with(edge_between([2, 3]));
    assert!(is_behind && darkest > 60, "{darkest}");
}

#[test]
fn faces_that_are_not_finite_are_left_out_and_named() {
    let mut points = cube_corners();
    points[7] = [f64::NAN, 1.0, 1.0];
    points.push([f64::INFINITY, 0.0, 0.0]);
    let mesh = mesh(&points, &CUBE);
    let overlays = vec![
        boundary(&mesh),
        components(&mesh),
        Overlay::Generators { loops: vec![vec![VertexId(7), VertexId(0), VertexId(8)]], more: 0 },
    ];
    let scene = Scene { overlays, outlines: Outlines::Drawn, ..Scene::of(mesh) };
    let picture = render(&scene, size(400, 200)).unwrap();
    assert_eq!(picture.left_out().collect::<Vec<_>>(), [[1, 3, 4].map(FaceId)]);
    assert!(svg(&picture).contains("(not finite, left out: 3)") && !svg(&picture).contains("NaN"));
}

#[test]
fn nothing_much_is_drawn_without_a_panic() {
    let nothing = mesh(&[], &[]);
    let points = mesh(&[[0.0; 3], [1.0; 3], [f64::NAN; 3]], &[]);
    let flat = mesh(&[[0.0; 3]; 3], &[&[0, 1, 2], &[0, 0, 1], &[]]);
    let loose =
        mesh(&cube_corners(), &[]).with_loose(vec![[VertexId(0), VertexId(7)]], vec![VertexId(3)]).unwrap();
    let huge = mesh(&[[-1e308, 0.0, 0.0], [1e308, 1e308, 0.0], [0.0, -1e308, f64::MAX]], &[&[0, 1, 2]]);
    let tiny = mesh(&[[0.0; 3], [5e-324, 0.0, 0.0], [0.0, 5e-324, 0.0]], &[&[0, 1, 2]]);
    for mesh in [nothing, points, flat, loose, huge, tiny] {
        for projection in [Projection::Orthographic, Projection::Perspective] {
            let camera = Camera::default().with_projection(projection);
            let scene = Scene { camera, outlines: Outlines::Drawn, ..Scene::of(mesh.clone()) };
            let picture = render(&scene, size(64, 64)).unwrap();
            assert!(!svg(&picture).contains("NaN") && !svg(&picture).contains("inf"));
            assert_eq!(&png(&picture)[1..4], b"PNG");
        }
    }
}

#[test]
fn points_alone_are_dots() {
    let picture = render(&seen_from_above(mesh(&[[0.0; 3], [1.0, 1.0, 0.0]], &[])), size(116, 116)).unwrap();
    assert_ne!(pixel(&picture, 107, 8), [255; 3]);
    assert_ne!(pixel(&picture, 8, 107), [255; 3]);
    assert_eq!(pixel(&picture, 58, 58), [255; 3]);
}

#[test]
fn huge_meshes_look_like_small_ones() {
    let scaled = |factor: f64| {
        let points: Vec<[f64; 3]> = cube_corners().iter().map(|p| p.map(|x| (x - 0.5) * factor)).collect();
        render(&Scene::of(mesh(&points, &CUBE)), size(100, 100)).unwrap().pixels()
    };
    assert!(scaled(1.0) == scaled(f64::from_bits(0x7fe0_0000_0000_0000)));
    assert!(scaled(1.0) == scaled(f64::from_bits(0x0010_0000_0000_0000)));
}

#[test]
fn a_surface_of_genus_four_has_eight_loops_to_show_and_a_tree() {
    let shape = surface(Closed::Handles(4), 0, 3).unwrap();
    let found = loops(&shape.mesh).unwrap();
    assert_eq!(found.generators.element_count(), 8);
    assert_eq!(found.tree.element_count(), shape.truth.vertices - 1);
    assert_eq!(found.cotree.element_count(), shape.truth.faces - 1);
    let overlays = vec![found.generators, found.tree, found.cotree];
    let picture = render(&Scene { overlays, ..Scene::of(shape.mesh) }, size(800, 600)).unwrap();
    for entry in ["generator 5", "and 2 more generators", "tree", "co-tree", "behind faces"] {
        assert!(picture.legend().contains(&entry), "{entry}");
    }
    // Each loop has its number.
    let text = svg(&picture);
    assert!((0..8).all(|k| text.contains(&format!(">{k}</text>"))));
}

#[test]
fn a_band_with_one_side_has_a_seam_and_a_sphere_has_none() {
    assert_eq!(seam(&moebius_band()).element_count(), 1);
    assert_eq!(seam(&mesh(&cube_corners(), &CUBE)).element_count(), 0);
}

/// The names of the elements of a well-formed XML document.
fn elements(text: &str) -> Vec<String> {
    let mut reader = quick_xml::Reader::from_str(text);
    reader.config_mut().check_end_names = true;
    let (mut names, mut depth) = (Vec::new(), 0);
    loop {
        match reader.read_event().unwrap() {
            quick_xml::events::Event::Start(tag) => {
                depth += 1;
                tag.attributes().for_each(|attribute| drop(attribute.unwrap()));
                names.push(tag.name().as_ref().to_owned());
            }
            quick_xml::events::Event::Empty(tag) => {
                tag.attributes().for_each(|attribute| drop(attribute.unwrap()));
                names.push(tag.name().as_ref().to_owned());
            }
            quick_xml::events::Event::End(_) => depth -= 1,
            quick_xml::events::Event::Eof => break,
            _ => {}
        }
    }
    assert_eq!(depth, 0);
    names
}

#[test]
fn svg_is_well_formed_and_captions_are_escaped() {
    let band = moebius_band();
    let overlays = vec![boundary(&band), witness(&band), components(&band)];
    let caption = Some("<a & b> \u{1}\u{ffff} \"c\"".to_owned());
    let scene = Scene { overlays, caption, outlines: Outlines::Drawn, ..Scene::of(band) };
    let text = svg(&render(&scene, size(300, 240)).unwrap());
    let names = elements(&text);
    assert_eq!(names[0], "svg");
    assert!(names.iter().all(|name| ["svg", "rect", "g", "path", "circle", "text"].contains(&name.as_str())));
    assert!(text.contains("&lt;a &amp; b&gt; \u{fffd}\u{fffd} \"c\""));
}

#[test]
fn svg_draws_only_what_is_seen_from_far_to_near() {
    let text = svg(&render(&seen_from_above(mesh(&cube_corners(), &CUBE)), size(116, 136)).unwrap());
    assert_eq!(text.matches('Z').count(), 1, "one face of a cube is seen along an axis");
    assert!(text.contains("M108 8 ") || text.contains(" 108 8"), "{text}");
    let default = svg(&render(&Scene::of(mesh(&cube_corners(), &CUBE)), size(116, 136)).unwrap());
    assert_eq!(default.matches('Z').count(), 3);
}

#[test]
fn png_reads_back_to_the_same_pixels() {
    let picture = render(&Scene::of(mesh(&cube_corners(), &CUBE)), size(90, 70)).unwrap();
    let bytes = png(&picture);
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), (90, 70));
    assert!(pixels == picture.pixels().as_flattened());
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    let once = || {
        let band = moebius_band();
        let scene = Scene { overlays: vec![boundary(&band), witness(&band)], ..Scene::of(band) };
        let picture = render(&scene, size(300, 200)).unwrap();
        (png(&picture), svg(&picture))
    };
    assert!(once() == once());
}

#[test]
fn pictures_of_a_sheet_fill_their_places_or_share_a_scale() {
    let small: Vec<[f64; 3]> = cube_corners().iter().map(|p| p.map(|x| x / 2.0)).collect();
    let scenes = [cube_corners(), small].map(|points| seen_from_above(mesh(&points, &CUBE)));
    let covered = |fit| {
        let picture = contact_sheet(&scenes, fit, size(200, 120)).unwrap();
        let pixels = picture.pixels();
        [0, 100].map(|left| {
            let places = (0..100).flat_map(|y| (left..left + 100).map(move |x| y * 200 + x));
            places.filter(|&place| pixels[place] != [255; 3]).count()
        })
    };
    assert_eq!(covered(Fit::Each), [84 * 84, 84 * 84]);
    assert_eq!(covered(Fit::Together), [84 * 84, 42 * 42]);
}

#[test]
fn captions_are_over_their_pictures() {
    let captioned =
        |caption: &str| Scene { caption: Some(caption.into()), ..Scene::of(mesh(&cube_corners(), &CUBE)) };
    let scenes = [captioned("one"), captioned("two")];
    let text = svg(&contact_sheet(&scenes, Fit::Each, size(300, 120)).unwrap());
    let place = |caption: &str| text.find(&format!(">{caption}<")).unwrap();
    assert!(place("one") < place("two"));
}

#[test]
fn what_cant_be_drawn_is_refused() {
    assert_eq!(Size::new(0, 100), Err(RenderError::Size { width: 0, height: 100 }));
    assert!(Size::new(100, 9000).is_err());
    let cube = mesh(&cube_corners(), &CUBE);
    let foreign =
        Scene { overlays: vec![Overlay::Tree { edges: vec![EdgeId(12)] }], ..Scene::of(cube.clone()) };
    let error = render(&foreign, size(100, 100)).unwrap_err();
    assert_eq!(error.to_string(), "the overlay `tree` names e12, which the mesh does not have");
    let many = vec![Scene::of(cube); 100];
    let error = contact_sheet(&many, Fit::Each, size(100, 100)).unwrap_err();
    assert_eq!(error, RenderError::Crowded { count: 100, width: 100, height: 100 });
    assert!(contact_sheet(&[], Fit::Each, size(100, 100)).is_ok());
}
