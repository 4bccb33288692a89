#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# try_wheel.sh WHEEL [FOLDER]: does the wheel stand by itself?  It is installed in a fresh virtual environment here,
# then in empty Debians 11 to 13 (made by debootstrap in FOLDER where there are none yet; else in a folder that is
# removed again) with python3-venv, without a compiler and without OpenCL.  There README's pipe runs, frames have the
# bits of tests/golden/bits.tsv, vcview and luxpipe-live answer and `import luxpipe` renders.  As root, with a network.
set -euo pipefail
wheel=$(realpath "$1") top=$(realpath "$(dirname "$0")/..")
machine=$(uname -m) arch=$(dpkg --print-architecture)
case $wheel in *_aarch64.whl) machine=aarch64 arch=arm64 ;; esac  # by qemu (scripts/debian.sh)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
roots=${2:-$work}
mkdir -p "$roots/wheels"
for python in 3.9 3.11 3.13; do
    python3 -m pip download -q --only-binary :all: --no-deps --python-version "$python" -d "$roots/wheels" \
        --platform "manylinux_2_28_$machine" --platform "manylinux2014_$machine" numpy
done

# trial BIN TOP DEVICES: what is tried in each place; BIN is where pip put the programs, TOP has tests and examples.
cat > "$work/trial" << 'END'
set -euo pipefail
PATH=$1:$PATH top=$2
cd "$("$1"/python -c 'import luxpipe; print(luxpipe.examples)')/office"
frames() { ptrace -vf view.vf -x 64 -y 64 "$@" materials.rad layout.rad sky_1400.rad; }
started=$(date +%s)
frames | ptaccum -every x2/4 | vcmetrics -metrics Ev,DGP,DGPf -ci 95 -until 'DGPf 0.01' | tail -n 1
echo "the first DGP: $(($(date +%s) - started)) s"
frames -frames 3 | ptaccum | vcview -- vcmetrics > /dev/null 2> "$TMPDIR/said"
grep -q 'http://' "$TMPDIR/said"
luxpipe-live -version
luxpipe-live -regions "$TMPDIR/regions" -vf view.vf -x 64 -y 64 materials.rad layout.rad sky_day.rad \
    > "$TMPDIR/lines" 2> "$TMPDIR/said" & live=$!
trap 'kill $live 2> /dev/null || :' EXIT
for i in $(seq 1200); do [ "$(wc -l < "$TMPDIR/lines")" -lt 4 ] || break; sleep .05; done
"$1"/python << 'PYTHON'
import os, re, urllib.request
folder = os.environ["TMPDIR"]
address = re.search(r"http://[^/]+/", open(folder + "/said").read())[0]
page = urllib.request.urlopen(address).read()
print("luxpipe-live:", len(page), "bytes of page;", len(open(folder + "/lines").readlines()), "lines")
PYTHON
kill $live; wait $live
"$1"/python << 'PYTHON'
import luxpipe
scene = [luxpipe.examples / "office" / name for name in ("materials.rad", "layout.rad", "sky_1400.rad")]
print(luxpipe.render(scene, luxpipe.examples / "office" / "view.vf", until="Ev 2%", size=64))
PYTHON
"$1"/python "$top/tests/parity/bits_frames.py" "$1" "$top" "${@:3}"
END

if [ "$machine" = "$(uname -m)" ]; then
    python3 -m venv "$work/venv"
    "$work/venv/bin/pip" install -q --find-links "$roots/wheels" "$wheel"
    TMPDIR=$work bash "$work/trial" "$work/venv/bin" "$top" cpu:lanes16 cpu:lanes8 cpu:avx2 cpu:baseline
    bash "$top/scripts/golden_runs.sh" "$work/venv/bin/vcmetrics" | tail -n 4
    test -s "$work/venv/share/man/man1/ptrace.1"
    if grep -rlF "$top" "$work"/venv/lib/python*/site-packages/luxpipe{,.libs}; then
        echo "these name $top, where the wheel was built" >&2
        exit 1
    fi
    echo "virtual environment: installed and run"
fi

suites='bookworm trixie'
[ "$machine" != x86_64 ] || suites="bullseye $suites"  # of ARM it is Debian 12's C library
for suite in $suites; do
    root=$roots/$suite
    inside() { bash "$top/scripts/debian.sh" "$root" "$suite" "$arch" "$1"; }
    inside 'apt-get update -q && apt-get install -q -y --no-install-recommends python3-venv' > "$work/apt.log" 2>&1 ||
        { tail -n 20 "$work/apt.log"; exit 2; }
    inside 'rm -rf /tmp/try /tmp/venv && mkdir /tmp/try'
    cp "$wheel" "$roots"/wheels/* "$work/trial" "$root/tmp/try"
    (cd "$top" && cp -r --parents tests/golden tests/parity/bits_frames.py examples/scenes "$root/tmp/try")
    started=$(date +%s)
    inside 'python3 -m venv /tmp/venv && /tmp/venv/bin/pip install -q --no-index --find-links /tmp/try luxpipe'
    installed=$(date +%s)
    inside 'bash /tmp/try/trial /tmp/venv/bin /tmp/try cpu'
    echo "$suite: installed ($((installed - started)) s) and run ($(($(date +%s) - installed)) s)"
done
