# SPDX-License-Identifier: BSD-3-Clause
# studies/cie171 in short: derived values of CIE 171:2006 against small pictures, fixed seed.  The reference is the
# committed one.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics python3
study=$TOP/studies/cie171
python3 -B "$study/reference.py" 5.3 5.7 '5.9, 1' '5.13, 1' > reference.tsv
check 'reference.tsv is what reference.py derives' \
    'test "$(wc -l < reference.tsv)" -gt 300 && ! grep -vxFf "$study/reference.tsv" reference.tsv >&2'
check 'the quadrature moves by less than .0001 when its cells are halved' \
    'awk -F"\t" "!/^#/ && NR > 2 && !(\$5 < 1e-4) { print; bad = 1 } END { exit bad }" "$study/reference.tsv" >&2'
check 'no value is more than 5 standard errors from the derived one' \
    'cd "$TOP" && python3 -B studies/cie171/run.py -bin "$BIN" \
         -points AGN -size 48 -frames 9 \
         -not 5.4 5.8 5.14 "5.10, 4x4 p" "5.12, 4x3 p" "5.12, 2x1, sensors" -skies 2 5 12 15 16 \
         > "$OLDPWD/rows.tsv"'
check 'intervals hold, 95 % less three standard deviations of 60 tries (the skies of a sensor are one)' \
    'awk -F"\t" "/inside|outside|wrong/ { n++; in_ += \$9 == \"inside\" }
         END { print in_, n; exit !(n > 200 && in_/n > .866) }" \
         rows.tsv >&2'
check 'compare.py: the own values, and a value that is not there' \
    'cut -f1-3,5 rows.tsv | grep -v "^#" > values.tsv; python3 -B "$study/compare.py" values.tsv > compared &&
     grep -q "^5.7	2	" compared; printf "case\tpoint\tsky\tvalue\n7.1\tA\t1\t3\n" > other.tsv
     not python3 -B "$study/compare.py" other.tsv 2> message; grep -q "no such value: 7.1 A 1" message'
check 'the page has the figures of its tables' 'python3 -B "$TOP/studies/certificate/page.py" -check >&2'
