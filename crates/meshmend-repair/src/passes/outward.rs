//! Turns whole components so that each shows its front.
//!
//! *Why*: a solid whose faces show their backs is taken for a hole in all of space, and the wall of a hollow for a second
//! solid. `orient` makes neighbours agree; which of the two sides is then the front is decided here, exactly, after holes
//! are closed and sheets are apart.
//!
//! 1. Find the closed components whose faces agree, the sign of the volume of each, and in how many others it lies.
//! 2. `solids`: those of negative volume are turned. `nested`: only in an even number of others; in an odd number those
//!    of positive volume are, as the walls of hollows. `visible`: as `nested`, and open components are turned by sight.
//! 3. A component all of whose faces now repeat, by position and direction, those of another one goes: if one of the two was
//!    turned, and no layer tells them apart.
//!
//! By sight: rays go to both sides of up to 256 points of an open component, in 32 directions. The side from which more
//! escape is the front, if they are a tenth more than from the other side; else the component stays as it is.
//!
//! Which components are turned is named, and so are those that have no outer side. *Promises* no component inside out.
//! *Requires* faces that agree. *May introduce* unreferenced vertices, where a component went, and solids within others with
//! `solids`. *Cost*: O(n log n) where components touch at few points; the rays of `visible` are 10⁸ at most.

mod repeats;

use meshmend_core::{Defect, DefectKind, FaceId, FlippedNormals, PolygonMesh, Watch};
use meshmend_spatial::{Front, NestedComponent, Nesting, NestingState, NoSpace, Surface, fronts, nesting};
use serde::{Deserialize, Serialize};

use crate::fates::Fates;
use crate::turned::turned;
use crate::{Context, Form, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow, Word};
use repeats::repeated_components;

/// Turns whole components so that each shows its front.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Outward {
    /// Which components are turned.
    pub turn: Turn,
    /// Whether the stored normals of a face turn with it. What `orient` has is taken where that keeps them.
    pub flipped_normals: FlippedNormals,
}

/// Which components are turned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Turn {
    /// Closed ones, so that each has a positive volume.
    #[default]
    Solids,
    /// Closed ones, so that those in an even number of others have a positive volume, those in an odd number a negative one.
    Nested,
    /// The same, and open ones, so that they are seen from their front.
    Visible,
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "outward",
    explanation: "Turns whole components so that each shows its front: closed ones by the exact sign of their volume and by how \
                  many others they lie in, open ones by sight. What was turned is named.",
    is_default: false,
    before: None,
    options: &[PassOption {
        name: "outward",
        help: "Which components are turned to show their front",
        sets: &["turn"],
        values: OptionValues::Words(&[
            Word::new("solids", "Closed ones, so that each encloses a positive volume"),
            Word::new("nested", "The same, but shells inside others alternate, as the walls of hollows do"),
            Word::new("visible", "The same, and open ones, so that they are seen from their front"),
        ]),
    }],
    form: Form::of::<Outward>(),
};

impl Pass for Outward {
    fn kind(&self) -> PassKind {
        PassKind::Outward
    }
    fn removes(&self) -> &'static [DefectKind] {
        &[DefectKind::InsideOutComponent]
    }
    fn requires(&self) -> &'static [DefectKind] {
        &[DefectKind::InconsistentEdge]
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[DefectKind::UnreferencedVertex, DefectKind::SolidWithin]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        let nesting = nesting(&Surface::watched(mesh, context.watch())?)?;
        context.check_cancelled()?;
        let mut wishes: Vec<Wish> = nesting.components.iter().map(|part| self.wish(part)).collect();
        if self.turn == Turn::Visible {
            see(mesh, &nesting, &mut wishes, context.watch())?;
            context.check_cancelled()?;
        }
        let turns: Vec<bool> = wishes.iter().map(|wish| *wish == Wish::Turned).collect();
        let mut fates = Fates::unchanged(mesh.counts().faces);
        for face in mesh.faces().faces() {
            if nesting.component_of(face).is_some_and(|part| turns[part]) {
                fates.flip(face);
            }
        }
        let gone = repeated_components(mesh, context, &nesting, &turns);
        gone.iter().for_each(|defect| {
            if let Some(face) = defect.at.face() {
                fates.remove(face);
            }
        });
        self.outcome(mesh, &nesting, &wishes, &fates, gone)
    }
}

/// What is to become of a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wish {
    /// It stays as it is, and there is nothing to say of it.
    Kept,
    /// It is turned.
    Turned,
    /// It stays as it is, as it has no outer side.
    Sideless,
    /// It stays as it is, as it is seen alike from both sides.
    Undecided,
}

impl Outward {
    /// What is to become of a closed component.
    fn wish(&self, part: &NestedComponent) -> Wish {
        let looks_right = match (part.state, self.turn) {
            (None, _) => return Wish::Kept,
            (Some(NestingState::NoVolume), _) => return Wish::Sideless,
            (Some(state), Turn::Solids) => matches!(state, NestingState::Outward | NestingState::SolidWithin),
            (Some(state), _) => matches!(state, NestingState::Outward | NestingState::Cavity),
        };
        if looks_right { Wish::Kept } else { Wish::Turned }
    }

    fn outcome(
        &self,
        mesh: &PolygonMesh,
        nesting: &Nesting,
        wishes: &[Wish],
        fates: &Fates,
        gone: Vec<Defect>,
    ) -> Result<Outcome, PassError> {
        let new_ids = fates.new_ids();
        let mut fixed = gone;
        let mut left = Vec::new();
        for (part, wish) in nesting.components.iter().zip(wishes) {
            let (lowest, faces) = (part.lowest_face, part.faces);
            if *wish == Wish::Turned {
                fixed.extend(was_wrong(part));
            }
            if fates.stays(lowest) {
                left.extend(self.remark(part, *wish, new_ids.of(lowest), faces));
            }
        }
        left.sort();
        let mut outcome = if fates.all_stay() && !fates.any_is_flipped() {
            Outcome::unchanged(mesh)
        } else {
            Outcome::changed(turned(mesh, fates, self.flipped_normals)?, fixed)
        };
        outcome.left = left;
        Ok(outcome)
    }

    /// What there is to say of a component that stays, by its lowest face's new id.
    fn remark(&self, part: &NestedComponent, wish: Wish, lowest: FaceId, faces: u32) -> Option<Defect> {
        let is_within = part.depth.is_some_and(|depth| !depth.is_multiple_of(2));
        match wish {
            Wish::Sideless => Some(Defect::no_volume(lowest, faces)),
            Wish::Undecided => Some(Defect::undecided_component(lowest, faces)),
            Wish::Kept | Wish::Turned => {
                let is_solid = self.turn == Turn::Solids && is_within && part.state.is_some();
                is_solid.then(|| Defect::solid_within(lowest, faces))
            }
        }
    }
}

/// What was wrong with a component that is turned; nothing if it was the wall of a hollow.
fn was_wrong(part: &NestedComponent) -> Option<Defect> {
    match part.state {
        Some(NestingState::SolidWithin) => Some(Defect::solid_within(part.lowest_face, part.faces)),
        Some(NestingState::Cavity) => None,
        _ => Some(Defect::inside_out_component(part.lowest_face, part.faces)),
    }
}

/// Decides by sight on the open components whose faces agree.
fn see(mesh: &PolygonMesh, nesting: &Nesting, wishes: &mut [Wish], watch: &Watch) -> Result<(), PassError> {
    let is_open = |part: &NestedComponent| part.is_oriented && matches!(part.reason, Some(NoSpace::Open(_)));
    let open: Vec<usize> = (0..wishes.len()).filter(|&part| is_open(&nesting.components[part])).collect();
    for (&part, front) in open.iter().zip(fronts(mesh, nesting, &open, watch)?) {
        wishes[part] = match front {
            Front::Shown => Wish::Kept,
            Front::Hidden => Wish::Turned,
            Front::Undecided => Wish::Undecided,
        };
    }
    Ok(())
}
