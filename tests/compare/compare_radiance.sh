# SPDX-License-Identifier: BSD-3-Clause
# The comparison of random scenes with rtrace, on a few: what it says, and that it finds a fault that is put in.
. "${TOP:?}/tests/lib.sh"
needs python3 rtrace oconv obj2mesh
# Its programs without its library (rayinit.cal ...) fail at the first function.
printf 'void brightfunc f 2 if(1,1,1) .\n0\n0\nf glow g 0 0 4 1 1 1 0\ng sphere s 0 0 4 0 0 0 1\n' > library.rad
oconv library.rad > library.oct
echo 0 0 5 0 0 -1 | rtrace -h library.oct > library.txt 2>&1 ||
    skip "rtrace does without its library (RAYPATH is ${RAYPATH:-not set}): $(head -n 1 library.txt)"
compare="python3 $TOP/tests/compare/radiance/compare.py --tracer $BIN/trace_rays --jobs 2 --out out"

check 'scenes agree with rtrace' "$compare -n 3 --rays 60 --seed 3 > report"
check 'it counts scenes and pixels' 'grep -q "^3 scenes, seeds 3 to 5, 60 rays each: 3 agrees$" report &&
    grep -q "^180 pixels: 100.000 % agree" report'

# Ambient light that rtrace is not told of: everything diffuse differs, and one lit thing is enough to show it.
check_exit 'a fault is found' 1 "$compare -n 1 --rays 60 --seed 3 --ours '-av .3 .3 .3'"
check 'and shrunk to a scene of few primitives' 'test $(grep -c "^[a-z]" out/3/minimal/scene.rad) -le 3'
check 'with a row for the table' 'test $(awk -F "\t" "NF >= 6" out/3/minimal/row.tsv | wc -l) -eq 1'
check 'the differences that it knows are listed in differences.md' 'cd $TOP/tests/compare/radiance && python3 -B -c "
import known
page = \" \".join(open(\"$TOP/docs/differences.md\").read().split())
assert all(words in page for _, words, _, _ in known.RULES)"'
check_exit 'a wrong option is refused' 2 "$compare --nothing"
