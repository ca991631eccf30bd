#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# snapshot.sh: what a system has, a line each: files with type, mode and owner, those of /etc with their content too; users and
# groups. What installing and purging any package changes is left out.
set -euo pipefail

ignored=(
  /packages                              # the test's own
  /var/lib/apt /var/lib/dpkg             # apt's and dpkg's state: lists of packages, of files, of diversions
  /var/cache                             # may be removed at any time
  /var/log                               # logs of apt, dpkg and alternatives
  /run/systemd                           # systemd's, for the packages that bring it along; gone with the next start
  /etc/ld.so.cache                       # ldconfig's, of all libraries
  '/etc/passwd-' '/etc/group-' '/etc/shadow-' '/etc/gshadow-'  # what these files were before their last change
)
pruned=()
for path in "${ignored[@]}"; do pruned+=(-path "$path" -prune -o); done

# In other file systems: /run, which is searched too; /proc, /sys and /dev, which are the kernel's.
find / /run -xdev "${pruned[@]}" -printf '%y %m %u:%g %p -> %l\n'
find /etc -xdev "${pruned[@]}" -type f -exec sha256sum {} +
getent passwd | sed 's/^/user /'
getent group | sed 's/^/group /'
