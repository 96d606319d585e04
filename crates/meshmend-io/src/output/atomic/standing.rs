//! Who may read and write a file, and whose it is.

use std::fs::{File, Metadata, OpenOptions, Permissions};
use std::io;

/// The permissions, the owner and the group of a file.
pub(super) struct Standing {
    permissions: Permissions,
    #[cfg(unix)]
    owner: [u32; 2],
}

impl Standing {
    pub(super) fn of(status: &Metadata) -> Self {
        Standing {
            permissions: status.permissions(),
            #[cfg(unix)]
            owner: owner_of(status),
        }
    }

    /// Gives a new file, which nobody else may read yet, the owner, the group and then the permissions of the old
    /// one.
    ///
    /// Only the administrator can change the owner of a file, and other users can only choose among their own groups.
    /// If the group can't be kept, its members get the permissions of everybody.
    #[cfg(unix)]
    pub(super) fn give_to(&self, file: &File) -> io::Result<()> {
        use std::os::unix::fs::{PermissionsExt, fchown};
        let [user, group] = self.owner;
        let own = owner_of(&file.metadata()?);
        let keeps_group = own == self.owner
            || fchown(file, Some(user), Some(group)).is_ok()
            || own[1] == group
            || fchown(file, None, Some(group)).is_ok();
        let mode = self.permissions.mode() & 0o7777;
        file.set_permissions(Permissions::from_mode(if keeps_group { mode } else { without_group(mode) }))
    }

    #[cfg(not(unix))]
    pub(super) fn give_to(&self, file: &File) -> io::Result<()> {
        file.set_permissions(self.permissions.clone())
    }
}

/// Lets only us read and write a new file.
pub(super) fn only_for_us(options: &mut OpenOptions) {
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(options, 0o600);
    #[cfg(not(unix))]
    let _ = options;
}

#[cfg(unix)]
fn owner_of(status: &Metadata) -> [u32; 2] {
    use std::os::unix::fs::MetadataExt;
    [status.uid(), status.gid()]
}

/// A mode in which the group has the permissions of everybody, without the bits that lend an identity.
#[cfg(unix)]
fn without_group(mode: u32) -> u32 {
    (mode & 0o1707) | (mode & 0o007) << 3
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn a_group_that_is_not_kept_may_do_what_everybody_may() {
        for (mode, expected) in [(0o660, 0o600), (0o640, 0o600), (0o664, 0o644), (0o2775, 0o755)] {
            assert_eq!(without_group(mode), expected, "{mode:o}");
        }
    }
}
