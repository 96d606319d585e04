//! Small meshes and plans out of bytes.
//!
//! Every byte string stands for something: choices are taken from the front, one byte or two each, and are the
//! first possible one when the bytes run out. So the engine can shorten and splice inputs, and a short input is a
//! small mesh.

use arbitrary::{Arbitrary, Result, Unstructured};
use meshmend_core::{Carry, Domain, Layer, Metadata, NO_VALUE, PolygonMesh, Values, VertexId};
use meshmend_kernels::KernelKind;
use meshmend_repair::{
    Clean, Compact, CrossingFills, Distance, DropParts, Duplicates, Emptying, Fill, FillRims, FillWith, Heal,
    HealWithin, Internal, LooseElements, NonFinite, NonOrientable, OptionValues, Orient, Outward, PassKind,
    Passes, Plan, Repeated, Side, SmallComponents, Split, SplitEdges, Triangulate, TriangulateFaces, Turn,
    Weld,
};
use meshmend_testkit::Soup;

/// The most vertices of a small mesh.
const MOST_VERTICES: usize = 16;
/// The most faces of a small mesh, which naive oracles judge.
const MOST_FACES: usize = 24;
/// How many corners a face has, by chance: mostly three or four, and all from 1 to 8.
const SIZES: [usize; 16] = [3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 1, 2, 5, 6, 7, 8];

/// A mesh on a small grid, so that many vertices coincide, or in general position.
#[derive(Clone, Debug)]
pub struct SmallMesh(pub Soup);

impl<'a> Arbitrary<'a> for SmallMesh {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let vertex_count = u.int_in_range(1..=MOST_VERTICES)?;
        let positions = positions(u, vertex_count)?;
        let mut faces = Vec::new();
        while faces.len() < MOST_FACES && !u.is_empty() {
            let size = *u.choose(&SIZES)?;
            let corner = |_| u.choose_index(vertex_count).map(|v| v as u32);
            faces.push((0..size).map(corner).collect::<Result<Vec<u32>>>()?);
        }
        Ok(SmallMesh(Soup { positions, faces }))
    }
}

/// Points of a grid of one to four points a side, now and then with a −0 or a coordinate that is not finite; or
/// points in general position.
fn positions(u: &mut Unstructured<'_>, count: usize) -> Result<Vec<[f64; 3]>> {
    let side = u.int_in_range(0..=4u8)?;
    if side == 4 {
        return Ok(Soup::generic(count, [[]; 0]).positions);
    }
    let point = |_| -> Result<[f64; 3]> {
        let place: u8 = u.arbitrary()?;
        let mut point = [0, 2, 4].map(|shift| f64::from((place >> shift & 3).min(side)));
        match place >> 6 {
            0 | 1 => {}
            2 => point.iter_mut().filter(|x| **x == 0.0).for_each(|x| *x = -0.0),
            _ => point[usize::from(place & 1)] = unusual(u)?,
        }
        Ok(point)
    };
    (0..count).map(point).collect()
}

fn unusual(u: &mut Unstructured<'_>) -> Result<f64> {
    let tiny = f64::MIN_POSITIVE / 4.0;
    u.choose(&[1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.0 + f64::EPSILON, 1e300, -tiny, 0.1])
        .copied()
}

/// A small mesh with what a file can hold beside it: any positions, loose elements, attributes, statements.
#[derive(Clone, Debug)]
pub struct DressedMesh(pub PolygonMesh);

impl<'a> Arbitrary<'a> for DressedMesh {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let vertex_count = u.int_in_range(0..=8usize)?;
        let mut soup = Soup { positions: vec![[0.0; 3]; vertex_count], faces: Vec::new() };
        for x in soup.positions.iter_mut().flatten() {
            *x = coordinate(u)?;
        }
        let vertex = |u: &mut Unstructured<'a>| u.choose_index(vertex_count).map(|v| v as u32);
        let (mut edges, mut points) = (Vec::new(), Vec::new());
        if vertex_count > 0 {
            for _ in 0..u.int_in_range(0..=5u8)? {
                let size = u.int_in_range(0..=5u8)?;
                soup.faces.push((0..size).map(|_| vertex(u)).collect::<Result<_>>()?);
            }
            for _ in 0..u.int_in_range(0..=2u8)? {
                edges.push([VertexId(vertex(u)?), VertexId(vertex(u)?)]);
            }
            for _ in 0..u.int_in_range(0..=2u8)? {
                points.push(VertexId(vertex(u)?));
            }
        }
        let mesh = soup.mesh();
        let mut layers: Vec<Layer> = Vec::new();
        for _ in 0..u.int_in_range(0..=3u8)? {
            let new = layer(u, &mesh)?;
            let is_same = |old: &Layer| (old.name(), old.domain()) == (new.name(), new.domain());
            if !layers.iter().any(is_same) {
                layers.push(new);
            }
        }
        let mut metadata = (0..u.int_in_range(0..=2u8)?).map(|_| statement(u)).collect::<Result<Vec<_>>>()?;
        // A file has one name.
        metadata.dedup_by(|later, first| later.key == first.key && first.key.starts_with('s'));
        let mesh = mesh.with_loose(edges, points).expect("the vertices exist");
        Ok(DressedMesh(mesh.with_layers(layers).expect("the layers fit").with_metadata(metadata)))
    }
}

fn coordinate(u: &mut Unstructured<'_>) -> Result<f64> {
    match u.int_in_range(0..=7u8)? {
        0..=3 => u.arbitrary().map(|x: i8| f64::from(x)),
        4 => u.arbitrary().map(|x: f32| f64::from(x)),
        5 => u.arbitrary(),
        6 => unusual(u),
        _ => Ok(-0.0),
    }
}

/// The names that formats know, and some that they have to spell otherwise.
const NAMES: [&str; 14] = [
    "texcoord",
    "normal",
    "color",
    "weight",
    "object",
    "group",
    "material",
    "smoothing",
    "attribute",
    "quality",
    "x",
    "vertex_indices",
    "two words",
    "",
];

fn layer(u: &mut Unstructured<'_>, mesh: &PolygonMesh) -> Result<Layer> {
    let name = *u.choose(&NAMES)?;
    let domain = *u.choose(&[Domain::Vertex, Domain::Corner, Domain::Face])?;
    let elements = mesh.element_count(domain);
    let width = u.int_in_range(1..=4usize)?;
    let is_direct: bool = u.arbitrary()?;
    let pool = if is_direct { elements } else { u.int_in_range(0..=3usize)? };
    let last_kind = match (name, domain) {
        // Words for colours are what a file had in place of numbers, not any text.
        ("color", _) => 7,
        // A face's list of texture coordinates is by convention what its corners have.
        ("texcoord", Domain::Face) => 8,
        _ => 9,
    };
    let kind = u.int_in_range(0..=9u8)?.min(last_kind);
    let values = values(u, kind, pool * width)?;
    if is_direct {
        return Ok(Layer::direct(name, domain, width, Carry::Copy, values));
    }
    let one = |_| Ok(u.int_in_range(0..=pool)?.checked_sub(1).map_or(NO_VALUE, |value| value as u32));
    let uses = (0..elements).map(one).collect::<Result<_>>()?;
    Ok(Layer::indexed(name, domain, width, Carry::Copy, values, uses))
}

fn values(u: &mut Unstructured<'_>, kind: u8, count: usize) -> Result<Values> {
    fn many<'a, T: Arbitrary<'a>>(u: &mut Unstructured<'a>, count: usize) -> Result<Vec<T>> {
        (0..count).map(|_| u.arbitrary()).collect()
    }
    Ok(match kind {
        0 => Values::I8(many(u, count)?),
        1 => Values::U8(many(u, count)?),
        2 => Values::I16(many(u, count)?),
        3 => Values::U16(many(u, count)?),
        4 => Values::I32(many(u, count)?),
        5 => Values::U32(many(u, count)?),
        6 => Values::F32(many(u, count)?),
        7 => Values::F64(many(u, count)?),
        8 => Values::Text((0..count).map(|_| text(u)).collect::<Result<_>>()?),
        _ => {
            let mut starts = vec![0u32];
            for _ in 0..count {
                starts.push(starts[starts.len() - 1] + u.int_in_range(0..=3u32)?);
            }
            let (kind, items) = (u.int_in_range(0..=7u8)?, starts[count] as usize);
            Values::Lists { starts, items: Box::new(values(u, kind, items)?) }
        }
    })
}

/// What a file says of itself. Readers trim it, so there is no blank at its ends; names in STL are not empty.
fn statement(u: &mut Unstructured<'_>) -> Result<Metadata> {
    let key = *u.choose(&["comment", "obj_info", "mtllib", "solid", "stl-header", "other"])?;
    let mut text = text(u)?;
    if key == "mtllib" {
        text.retain(|&byte| byte != b'#');
    }
    let is_name = key.starts_with('s');
    let value = if is_name || !text.is_empty() { [b"<", &text[..], b">"].concat() } else { text };
    Ok(Metadata { key: key.to_owned(), value })
}

/// Up to seven bytes, of which many mean something in some format.
fn text(u: &mut Unstructured<'_>) -> Result<Vec<u8>> {
    const MEANINGFUL: [u8; 16] = *b"a0\n\r \t\0#\\/.-e\xff\xc3s";
    let byte = |u: &mut Unstructured<'_>| {
        let byte: u8 = u.arbitrary()?;
        Ok(if byte < 128 { MEANINGFUL[usize::from(byte % 16)] } else { byte.wrapping_sub(96) })
    };
    (0..u.int_in_range(0..=7u8)?).map(|_| byte(u)).collect()
}

/// A small mesh, a plan with any options and any order of passes, and a kernel.
#[derive(Clone, Debug)]
pub struct Work {
    /// What is repaired.
    pub mesh: SmallMesh,
    /// How it is repaired.
    pub plan: Plan,
    /// On what.
    pub kernel: KernelKind,
}

impl<'a> Arbitrary<'a> for Work {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let mut work = Work { kernel: *u.choose(KernelKind::ALL)?, plan: any_plan(u)?, mesh: u.arbitrary()? };
        // What is chosen last leaves the meaning of inputs that are kept as it was.
        work.plan.clean.repeated = *u.choose(&[Repeated::KeepDifferent, Repeated::Drop])?;
        work.plan.empty = *u.choose(&[Emptying::Refuse, Emptying::Allow])?;
        choose_the_rest(&mut work.plan, u)?;
        Ok(work)
    }
}

/// Chooses what `any_plan` leaves out: the options of the rows of all passes, so that a new one is covered.
fn choose_the_rest(plan: &mut Plan, u: &mut Unstructured<'_>) -> Result<()> {
    let chosen = [
        "distance",
        "non-finite",
        "repeated",
        "side",
        "non-orientable",
        "duplicates",
        "edges",
        "faces",
        "loose-edges",
        "loose-points",
    ];
    for (kind, option) in Passes::builtin().options() {
        let OptionValues::Words(words) = option.values else { continue };
        for key in option.sets.iter().filter(|key| !chosen.contains(key)) {
            let word = u.choose(words)?;
            plan.set(kind, key, word.value).expect("a word of the row");
        }
    }
    Ok(())
}

fn any_plan(u: &mut Unstructured<'_>) -> Result<Plan> {
    use NonOrientable::{Cut, Fail, Report};
    let passes = match u.int_in_range(0..=8usize)? {
        0 => PassKind::ALL.to_vec(),
        count => (0..count).map(|_| u.choose(PassKind::ALL).copied()).collect::<Result<_>>()?,
    };
    let length =
        |u: &mut Unstructured<'_>| u.choose(&[0.0, 1.0, 0.3, 1.5, 1e-300, 1e300, -1.0, f64::NAN]).copied();
    let distance = match u.int_in_range(0..=6u8)? {
        0 | 1 => Distance::Exact,
        2 => Distance::Absolute(length(u)?),
        3 => Distance::Boundary(length(u)?),
        4 => Distance::BoundaryRelative(length(u)?),
        5 => Distance::Auto,
        _ => Distance::Relative(length(u)?),
    };
    let within = match u.int_in_range(0..=2u8)? {
        0 => HealWithin::Exact,
        1 => HealWithin::Absolute(length(u)?),
        _ => HealWithin::Relative(length(u)?),
    };
    let components = match u.int_in_range(0..=3u8)? {
        0 => SmallComponents::Keep,
        1 => SmallComponents::Faces(2),
        2 => SmallComponents::Area(length(u)?),
        _ => SmallComponents::Volume(length(u)?),
    };
    let loose = [LooseElements::Remove, LooseElements::Keep];
    Ok(Plan {
        passes,
        weld: Weld::within(distance),
        clean: Clean {
            non_finite: *u.choose(&[NonFinite::Drop, NonFinite::Keep, NonFinite::Fail])?,
            ..Clean::default()
        },
        orient: Orient {
            side: *u.choose(&[Side::Majority, Side::Outward, Side::OutwardNested])?,
            non_orientable: *u.choose(&[Report, Cut, Report, Cut, Report, Fail])?,
            duplicates: *u.choose(&[Duplicates::Keep, Duplicates::RemovePair, Duplicates::KeepFirst])?,
            ..Orient::default()
        },
        heal: Heal { within },
        fill: Fill {
            by: *u.choose(&[FillWith::Fold, FillWith::Area, FillWith::Fan])?,
            rims: *u.choose(&[FillRims::Leave, FillRims::Take])?,
            crossing: *u.choose(&[CrossingFills::Leave, CrossingFills::Keep])?,
            ..Fill::default()
        },
        drop: DropParts {
            components,
            internal: *u.choose(&[Internal::Keep, Internal::RemoveComponents, Internal::RemoveFaces])?,
        },
        split: Split {
            edges: *u.choose(&[SplitEdges::Sheets, SplitEdges::Cut, SplitEdges::PinchOnly])?,
            ..Split::default()
        },
        triangulate: Triangulate { faces: *u.choose(&[TriangulateFaces::Auto, TriangulateFaces::All])? },
        outward: Outward {
            turn: *u.choose(&[Turn::Solids, Turn::Nested, Turn::Visible])?,
            ..Outward::default()
        },
        compact: Compact { loose_edges: *u.choose(&loose)?, loose_points: *u.choose(&loose)? },
        ..Plan::default()
    })
}
