//! What became of each boundary loop.

use std::fmt;

use meshmend_core::{FaceId, VertexId, counted};
use serde::Serialize;

/// A boundary loop, and what became of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LoopRecord {
    /// Its lowest vertex.
    pub first_vertex: VertexId,
    /// How many edges it has.
    pub edges: usize,
    /// How long it is.
    pub length: f64,
    /// What part of its component's area faces as the loop does: from 0.4 on it is a rim.
    pub turned: f64,
    /// What became of it.
    #[serde(flatten)]
    pub fate: LoopFate,
    /// What its fill crosses, or would.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crossing: Option<FillCrossing>,
}

/// A triangle of a fill and what it crosses.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct FillCrossing {
    /// Its corners on the loop: two for a triangle of a fan.
    pub triangle: Vec<VertexId>,
    /// What it crosses.
    pub with: Crossed,
}

/// What a fill crosses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Crossed {
    /// A face that was there.
    Face(FaceId),
    /// Another part of this fill, or the fill of another loop, by the loop's lowest vertex.
    Fill(VertexId),
}

/// What became of a boundary loop.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum LoopFate {
    /// It was filled.
    Filled {
        /// With what.
        fill: FillShape,
        /// How many faces fill it.
        faces: usize,
        /// The greatest of 1 − cos of the angle between two faces at a side of the fill, those round it included.
        fold: f64,
        /// The area of the fill.
        area: f64,
    },
    /// It is still open.
    Left {
        /// Why.
        left: LeftOpen,
    },
}

/// What fills a hole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FillShape {
    /// Triangles over its vertices.
    Triangles,
    /// Triangles round a new vertex.
    Fan,
}

/// Why a boundary loop is still open.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LeftOpen {
    /// It is the outer border of a sheet.
    Rim,
    /// Its component is a single face, which a fill would put on its own back.
    LoneFace,
    /// The faces of its component have no common side.
    NoSide,
    /// A corner of its component is not finite.
    NotFinite,
    /// It comes back to a vertex, or shares one with another loop.
    NotSimple,
    /// It has more edges than the limit.
    Edges,
    /// It is longer than the limit.
    Length,
    /// It encloses more than the limit.
    Area,
    /// Every fill has no area: it is a slit, which welding closes.
    Flat,
    /// It runs twice between the same places, or within one place: every fill has two faces in one place, or a face that
    /// welding would remove.
    Repeated,
    /// Its fill would cross a face or another fill.
    Crossing,
}

impl LoopRecord {
    /// Whether the loop was filled.
    pub fn is_filled(&self) -> bool {
        matches!(self.fate, LoopFate::Filled { .. })
    }
}

impl LeftOpen {
    /// The reason in words, as it follows “left open: ”.
    pub fn reason(self) -> &'static str {
        match self {
            LeftOpen::Rim => "it is the outer border of a sheet",
            LeftOpen::LoneFace => "its component is a single face",
            LeftOpen::NoSide => "the faces round it have no common side",
            LeftOpen::NotFinite => "a corner of its component is not finite",
            LeftOpen::Repeated => "it runs twice between the same places, or within one place",
            LeftOpen::NotSimple => "it shares a vertex with itself or another loop",
            LeftOpen::Edges => "it has more edges than the limit",
            LeftOpen::Length => "it is longer than the limit",
            LeftOpen::Area => "its area is above the limit",
            LeftOpen::Flat => "it is a slit: every fill has no area, and welding closes it",
            LeftOpen::Crossing => "its fill would cross what is there",
        }
    }
}

impl fmt::Display for FillCrossing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let vertices: Vec<String> = self.triangle.iter().map(ToString::to_string).collect();
        write!(f, "the triangle at {} and ", vertices.join(", "))?;
        match self.with {
            Crossed::Face(face) => write!(f, "{face} cross"),
            Crossed::Fill(first) => write!(f, "the fill of the loop at {first} cross"),
        }
    }
}

impl fmt::Display for LoopRecord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let LoopRecord { first_vertex, edges, length, turned, fate, crossing } = self;
        write!(f, "loop at {first_vertex}: {}, length {length:.6}, ", counted(*edges, "edge"))?;
        write!(f, "turned {turned:.3}: ")?;
        match fate {
            LoopFate::Filled { fill, faces, fold, area } => {
                let with = match fill {
                    FillShape::Triangles => counted(*faces, "face"),
                    FillShape::Fan => format!("a fan of {}", counted(*faces, "face")),
                };
                write!(f, "filled by {with}, fold {fold:.3}, area {area:.6}")?;
            }
            LoopFate::Left { left } => write!(f, "left open: {}", left.reason())?,
        }
        crossing.iter().try_for_each(|crossing| write!(f, " ({crossing})"))
    }
}
