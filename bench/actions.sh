# SPDX-License-Identifier: BSD-3-Clause
# What an action costs beside the ordinary frames: seconds of a view of the office alone, with mel by 9 bands, and with
# V by 12, too.  BIN: the programs.
set -e
cd "$(dirname "$0")/../examples/scenes/office"
frames() {
    local begin; begin=$(date +%s.%N)
    "$BIN"/ptrace -w- -vf view.vf -x "$1" -y "$1" -frames "${@:2}" materials.rad layout.rad sky_1400.rad > /dev/null
    echo "$1 x $1, ${*:2}: $(echo "$(date +%s.%N) - $begin" | bc) s"
}
for size in 64 256; do
    frames $size 16
    frames $size 16 -action mel
    frames $size 16 -action mel -action V
done
