#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# debian.sh ROOT SUITE ARCH COMMAND: runs COMMAND, for bash, in ROOT: a Debian (bookworm, trixie) of ARCH that
# debootstrap makes where there is none yet, with /proc, by which programs find their libraries.  As root, network on.
# ARCH is this machine's, or arm64 by qemu-user-static.  A kernel that was not told of it (in a container) learns it for
# a user namespace alone (Linux 6.7), where no device can be made: those that are needed are made before.
set -euo pipefail
root=$1 arch=$3
own=(unshare -mp --fork) words=
if [ "$arch" != "$(dpkg --print-architecture)" ] && [ ! -e /proc/sys/fs/binfmt_misc/qemu-aarch64 ]; then
    own=(unshare -Ump --fork)
    words='until [ "$(id -u)" = 0 ]; do sleep .1; done
        mount -t binfmt_misc none /proc/sys/fs/binfmt_misc
        cat /usr/lib/binfmt.d/qemu-aarch64.conf > /proc/sys/fs/binfmt_misc/register'
    mkdir -p "$root/dev"
    [ -e "$root/dev/null" ] || cp -a /dev/{null,zero,full,random,urandom,tty} "$root/dev"
fi
"${own[@]}" sh -euc "$words"'
    [ -x "$1/bin/bash" ] || container=lxc debootstrap --arch="$3" --variant=minbase "$2" "$1" > /dev/null
    mount -t proc proc "$1/proc"
    exec chroot "$1" /usr/bin/env -i PATH=/usr/sbin:/usr/bin LC_ALL=C TMPDIR=/tmp DEBIAN_FRONTEND=noninteractive \
        bash -eo pipefail -c "$4"' sh "$@" &
[ -z "$words" ] || for ids in gid uid; do  # all of them, not root's alone; the last lets it go on
    until echo 0 0 65536 2> /dev/null > "/proc/$!/${ids}_map"; do kill -0 $!; sleep .1; done
done
wait $!
