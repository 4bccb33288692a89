# SPDX-License-Identifier: BSD-3-Clause
# The comparison of random pictures with evalglare, on a few: what it says, and that it finds a fault that is put in.
. "${TOP:?}/tests/lib.sh"
needs python3 evalglare
compare="python3 $TOP/tests/compare/evalglare/compare.py --vcmetrics $BIN/vcmetrics --jobs 2 --out out"

# Not every row: evalglare's last bits are not all known (docs/differences-evalglare.md).
check 'rows agree with evalglare' "$compare -n 24 --seed 1001 --share .95 --shrink 0 > report"
check 'it counts rows' 'grep -q "^24 rows, pictures 1001 to 1006: 2[34] equal, .* % of 24; 0 without an answer" report'

# A threshold that evalglare is not told of, in a small picture: shrinking runs both programs some hundred times.
fault="python3 $TOP/tests/compare/evalglare/compare.py --vcmetrics '$BIN/vcmetrics -b 2.5' --out out"
check_exit 'a fault is found' 1 "$fault -n 4 --seed 1177 --shrink 1"
check 'and its row shrunk, with both commands' 'grep -q "^evalglare .*minimal.hdr" out/*/commands &&
    test -s out/*/minimal.hdr'

# A program that ends by a signal in evalglare's place.
mkdir fake && printf '#!/bin/sh\nkill -SEGV $$\n' > fake/evalglare && chmod +x fake/evalglare
check 'rows that evalglare ends in are counted apart' "PATH=fake:$PATH $compare -n 4 --seed 1001 > ended"
check 'and said' 'grep -q "0 equal, 0.00 % of 0; 4 without an answer of evalglare" ended'
check_exit 'a wrong option is refused' 2 "$compare --nothing"
