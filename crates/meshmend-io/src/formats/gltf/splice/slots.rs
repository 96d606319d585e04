//! Which accessor has which rows: the one that had them, or a new one where others name that too.

use std::collections::BTreeMap;

use crate::formats::gltf::accessor::{Component, Form};
use crate::formats::gltf::splice::part_change::{Change, PartChange, PrimitiveChange};
use crate::formats::gltf::splice::users::{User, Users};
use crate::formats::gltf::splice::values::RowBytes;

/// An accessor that has other rows.
pub(super) struct NewAccessor {
    /// The accessor of the file whose members it keeps.
    pub(super) like: Option<usize>,
    /// Its number.
    pub(super) index: usize,
    /// Whether its slot is one of the file.
    pub(super) keeps_slot: bool,
    pub(super) rows: RowBytes,
    /// Whether it holds indices of a primitive, not values of vertices.
    pub(super) holds_indices: bool,
    /// Whether the file must say the least and the greatest of its numbers.
    pub(super) needs_bounds: bool,
}

/// Where a primitive names another accessor than before.
pub(super) struct Renamed {
    pub(super) mesh: usize,
    pub(super) primitive: usize,
    pub(super) member: Member,
    pub(super) accessor: usize,
}

/// A member of a primitive that names an accessor.
pub(super) enum Member {
    Indices,
    Attribute(String),
    OfTarget(usize, String),
}

/// All accessors that have other rows.
#[derive(Default)]
pub(super) struct Slots {
    pub(super) accessors: Vec<NewAccessor>,
    pub(super) renamed: Vec<Renamed>,
    /// How many accessors there are then.
    pub(super) count: usize,
}

impl Slots {
    pub(super) fn new(count: usize) -> Self {
        Slots { count, ..Slots::default() }
    }

    /// A new accessor at the end.
    pub(super) fn append(&mut self, accessor: NewAccessor) -> usize {
        let index = self.count;
        self.accessors.push(NewAccessor { index, keeps_slot: false, ..accessor });
        self.count += 1;
        index
    }

    /// Gives all rows of a part to accessors.
    pub(super) fn add(&mut self, change: &PartChange, users: &Users) {
        for pool in &change.pools {
            let is_own = |user: User| match user {
                User::Primitive(mesh, primitive) => {
                    mesh == change.mesh && pool.primitives.contains(&primitive)
                }
                User::Manifold(mesh) => mesh == change.mesh,
                User::Other => false,
            };
            // One accessor may have the rows of two attributes, which may differ now.
            let mut given: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
            for of_accessor in &pool.rows {
                let (old, known) = (of_accessor.accessor, given.entry(of_accessor.accessor).or_default());
                let is_same = |at: &&usize| self.accessors[**at].rows.bytes == of_accessor.rows.bytes;
                let index = match known.iter().find(is_same) {
                    Some(&at) => self.accessors[at].index,
                    None => {
                        let keeps_slot = known.is_empty() && users.are_among(old, is_own);
                        known.push(self.accessors.len());
                        self.give(NewAccessor {
                            like: Some(old),
                            index: old,
                            keeps_slot,
                            rows: of_accessor.rows.clone(),
                            holds_indices: false,
                            needs_bounds: of_accessor.name == "POSITION",
                        })
                    }
                };
                if index != old {
                    for &primitive in &pool.primitives {
                        let member = match of_accessor.target {
                            None => Member::Attribute(of_accessor.name.clone()),
                            Some(target) => Member::OfTarget(target, of_accessor.name.clone()),
                        };
                        self.renamed.push(Renamed { mesh: change.mesh, primitive, member, accessor: index });
                    }
                }
            }
        }
    }

    /// Gives new indices of a primitive to the accessor that has the old ones, or to a new one.
    pub(super) fn add_indices(
        &mut self,
        mesh: usize,
        change: &PrimitiveChange,
        old: Option<usize>,
        users: &Users,
    ) {
        let Change::Indices { indices, component, .. } = &change.change else { return };
        let primitive = change.primitive;
        let index = self.add_numbers(indices, *component, old, User::Primitive(mesh, primitive), users);
        if Some(index) != old {
            self.renamed.push(Renamed { mesh, primitive, member: Member::Indices, accessor: index });
        }
    }

    /// Gives indices to an accessor that one user alone names, once, or to a new one.
    pub(super) fn add_numbers(
        &mut self,
        numbers: &[u32],
        component: Component,
        old: Option<usize>,
        by: User,
        users: &Users,
    ) -> usize {
        let is_own =
            |old: &usize| users.are_among(*old, |user| user == by) && users.of_accessor[*old].len() == 1;
        let own = old.filter(is_own);
        self.give(NewAccessor {
            like: own,
            index: own.unwrap_or_default(),
            keeps_slot: own.is_some(),
            rows: index_rows(numbers, component),
            holds_indices: true,
            needs_bounds: false,
        })
    }

    /// The accessor that has the positions of a mesh of one pool now, if it is another one.
    pub(super) fn renamed_positions(&self, mesh: usize) -> Option<usize> {
        let is_position = |renamed: &&Renamed| {
            renamed.mesh == mesh && matches!(&renamed.member, Member::Attribute(name) if name == "POSITION")
        };
        self.renamed.iter().find(is_position).map(|renamed| renamed.accessor)
    }

    fn give(&mut self, accessor: NewAccessor) -> usize {
        if !accessor.keeps_slot {
            return self.append(accessor);
        }
        let index = accessor.index;
        self.accessors.push(accessor);
        index
    }
}

/// Indices as rows.
pub(super) fn index_rows(indices: &[u32], component: Component) -> RowBytes {
    let mut rows = RowBytes::new(Form { component, rows: 1, columns: 1, normalized: false });
    rows.bytes.reserve(indices.len() * component.size());
    for index in indices {
        rows.bytes.extend_from_slice(&index.to_le_bytes()[..component.size()]);
    }
    rows
}
