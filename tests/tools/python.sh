# SPDX-License-Identifier: BSD-3-Clause
# The Python package, with the built programs (tests/python), by a Python that has numpy and pytest.
. "${TOP:?}/tests/lib.sh"
needs ptrace
for python in python3 /usr/bin/python3 none; do
    [ "$python" != none ] || skip "no python3 with numpy and pytest"
    "$python" -c 'import numpy, pytest' 2> /dev/null && break
done
export PYTHONPATH=$TOP/python LUXPIPE_BIN=$BIN PYTHONDONTWRITEBYTECODE=1
check 'import luxpipe: its tests' '
    "$python" -m pytest -q -p no:cacheprovider -c "$TOP/pyproject.toml" "$TOP/tests/python" > said 2>&1 ||
        { tail -n 40 said; exit 1; }'
check 'nothing but numpy is needed' '
    printf "raise ImportError\n" > pandas.py; cp pandas.py tqdm.py; cp pandas.py matplotlib.py
    PYTHONPATH=$PYTHONPATH:. "$python" -c "
import luxpipe
office = luxpipe.examples / \"office\"
scene = [office / name for name in (\"materials.rad\", \"layout.rad\", \"sky_1400.rad\")]
r = luxpipe.render(scene, office / \"view.vf\", None, max_frames=2, size=16)
print(r[\"Ev\"])
try: r.metrics
except ImportError as error: print(error)" > said; grep -q "needs none" said'
check 'programs start without numpy, as quick as Python' '
    printf "raise ImportError\n" > numpy.py
    PYTHONPATH=.:$PYTHONPATH "$python" -c "
import sys, luxpipe._programs; sys.argv = [\"ptaccum\", \"-version\"]; luxpipe._programs.main()" | grep -q "^ptaccum"'
