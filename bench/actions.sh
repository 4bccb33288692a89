# SPDX-License-Identifier: BSD-3-Clause
# Prints what an action costs beside the ordinary frames: the processor's seconds that a view of the office takes alone,
# with mel by 9 bands, and with mel and V by 12 bands.  BIN: the programs.
set -e
cd "$(dirname "$0")/../examples/scenes/office"
TIMEFORMAT=%U
frames() {
    local seconds
    seconds=$({ time "$BIN"/ptrace -w- -vf view.vf -x "$1" -y "$1" -frames "${@:2}" \
        materials.rad layout.rad sky_1400.rad > /dev/null; } 2>&1)
    echo "$1 x $1, ${*:2}: $seconds s"
}
for size in 64 256; do
    frames $size 16
    frames $size 16 -action mel
    frames $size 16 -action mel -action V
done
