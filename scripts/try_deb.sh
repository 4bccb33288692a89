#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# try_deb.sh PACKAGE SUITE [ROOT]: does the package stand by itself?  It is put into an empty Debian (made in ROOT by
# debootstrap where there is none yet; a folder of its own otherwise, removed again) by apt-get, which brings what the
# package says it needs and nothing else; there every tool answers, a manual page is found and the demo runs, small.
# SUITE is bookworm or trixie.  As root, with a network; a package for ARM by qemu (scripts/debian.sh).
set -euo pipefail
package=$(realpath "$1") suite=$2 debian=$(realpath "$(dirname "$0")/debian.sh")
root=${3:-$(mktemp -d)}
[ $# -gt 2 ] || trap 'rm -rf "$root"' EXIT
inside() { bash "$debian" "$root" "$suite" "$(dpkg-deb -f "$package" Architecture)" "$1"; }

inside 'apt-get update -q > /tmp/apt.log'
cp "$package" "$root/tmp/luxpipe.deb"
inside 'apt-get install -q -y --no-install-recommends /tmp/luxpipe.deb' > "$root/tmp/apt.log" ||
    { tail -n 20 "$root/tmp/apt.log"; exit 2; }
inside 'for tool in ptrace ptaccum vcmetrics vcregion vcyear vcview luxpipe-live; do $tool -version; done'
inside 'test -s /usr/share/man/man1/ptrace.1.gz -a -s /usr/share/luxpipe/luxpipe.mk'
inside 'test -s "$(ptrace -library)/fabrics.rad"'
inside 'cd /tmp && SIZE=64 UNTIL="DGPf 0.02, Ev 2%" bash /usr/share/doc/luxpipe/examples/demo.sh /usr/bin out'
inside 'test -s /tmp/out/office.png'
inside 'apt-get purge -q -y luxpipe && test ! -e /usr/bin/ptrace -a ! -e /usr/share/luxpipe' > "$root/tmp/apt.log"
echo "$(basename "$package"): installed, run and removed in $suite"
