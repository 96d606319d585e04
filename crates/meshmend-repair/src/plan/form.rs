//! How a plan stands in a file.

use std::fmt;

use serde::de::{DeserializeSeed, Error, MapAccess, SeqAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use toml::Table;

use crate::{AnyPass, FilePolicies, PassKind, PassRow, Passes, Plan};

impl Serialize for Plan {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("passes", &self.passes)?;
        map.serialize_entry("empty", &self.empty)?;
        let FilePolicies { fail_on, seams, limit } = &self.files;
        if !fail_on.is_empty() {
            map.serialize_entry("fail-on", fail_on)?;
        }
        seams.iter().try_for_each(|seams| map.serialize_entry("seams", seams))?;
        limit.iter().try_for_each(|limit| map.serialize_entry("limit", limit))?;
        self.write_builtin(&mut map)?;
        for pass in &self.own {
            let options = pass.kind().row().form.write(pass.as_pass());
            map.serialize_entry(pass.kind().name(), &options.map_err(serde::ser::Error::custom)?)?;
        }
        map.end()
    }
}

impl<'de> Deserialize<'de> for Plan {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        PlanOf(Passes::builtin()).deserialize(deserializer)
    }
}

/// A plan of these passes, to be read.
pub(super) struct PlanOf(pub(super) Passes);

impl<'de> DeserializeSeed<'de> for PlanOf {
    type Value = Plan;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Plan, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for PlanOf {
    type Value = Plan;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a plan")
    }

    fn visit_map<M: MapAccess<'de>>(self, mut map: M) -> Result<Plan, M::Error> {
        let mut plan = Plan::of(self.0);
        while let Some(key) = map.next_key_seed(Key(self.0))? {
            match key {
                PlanKey::Passes => plan.passes = map.next_value_seed(Names(self.0))?,
                PlanKey::Empty => plan.empty = map.next_value()?,
                PlanKey::FailOn => plan.files.fail_on = map.next_value()?,
                PlanKey::Seams => plan.files.seams = Some(map.next_value()?),
                PlanKey::Limit => plan.files.limit = Some(map.next_value()?),
                PlanKey::Options(PassKind::Own(row)) => plan.put(map.next_value_seed(OwnOptions(row))?),
                PlanKey::Options(kind) => plan.read_builtin(kind, &mut map)?,
            }
        }
        Ok(plan)
    }
}

/// What a plan says something of.
enum PlanKey {
    Passes,
    Empty,
    FailOn,
    Seams,
    Limit,
    Options(PassKind),
}

/// A key of a plan of these passes, to be read.
struct Key(Passes);

impl<'de> DeserializeSeed<'de> for Key {
    type Value = PlanKey;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<PlanKey, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Key {
    type Value = PlanKey;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("`passes`, `empty`, `fail-on`, `seams`, `limit` or the name of a pass")
    }

    fn visit_str<E: Error>(self, key: &str) -> Result<PlanKey, E> {
        match key {
            "passes" => Ok(PlanKey::Passes),
            "empty" => Ok(PlanKey::Empty),
            "fail-on" => Ok(PlanKey::FailOn),
            "seams" => Ok(PlanKey::Seams),
            "limit" => Ok(PlanKey::Limit),
            name => known(self.0, name).map(PlanKey::Options),
        }
    }
}

/// Some of these passes by their names, to be read.
struct Names(Passes);

impl<'de> DeserializeSeed<'de> for Names {
    type Value = Vec<PassKind>;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Vec<PassKind>, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Names {
    type Value = Vec<PassKind>;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the names of passes")
    }

    fn visit_seq<S: SeqAccess<'de>>(self, mut names: S) -> Result<Vec<PassKind>, S::Error> {
        let mut kinds = Vec::new();
        while let Some(kind) = names.next_element_seed(Name(self.0))? {
            kinds.push(kind);
        }
        Ok(kinds)
    }
}

/// One of these passes by its name, to be read.
struct Name(Passes);

impl<'de> DeserializeSeed<'de> for Name {
    type Value = PassKind;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<PassKind, D::Error> {
        deserializer.deserialize_str(self)
    }
}

impl Visitor<'_> for Name {
    type Value = PassKind;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a pass")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<PassKind, E> {
        known(self.0, name)
    }
}

fn known<E: Error>(passes: Passes, name: &str) -> Result<PassKind, E> {
    passes.kind(name).ok_or_else(|| {
        let names: Vec<&str> = passes.kinds().into_iter().map(PassKind::name).collect();
        E::custom(format!("there is no pass `{name}`; the passes are {}", names.join(", ")))
    })
}

/// The options of a pass of another crate, to be read.
struct OwnOptions(&'static PassRow);

impl<'de> DeserializeSeed<'de> for OwnOptions {
    type Value = AnyPass;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<AnyPass, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for OwnOptions {
    type Value = AnyPass;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the options of `{}`", self.0.name)
    }

    fn visit_map<M: MapAccess<'de>>(self, mut map: M) -> Result<AnyPass, M::Error> {
        let mut options = Table::new();
        while let Some((key, value)) = map.next_entry()? {
            options.insert(key, value);
        }
        self.0.form.read(options).map_err(M::Error::custom)
    }
}
