# SPDX-License-Identifier: BSD-3-Clause
# Pictures as other programs write them (foreign_pictures.py): the value that the format gives them, or one line.
. "${TOP:?}/tests/lib.sh"
needs vcmetrics python3

python3 "$TOP/tests/tools/foreign_pictures.py" . > list
ev() { vcmetrics -metrics Ev "$1" | tail -1 | awk '{ print $NF }'; }
plain=$(ev plain.hdr)
check 'the plain picture has the illuminance of its pixels' '
    awk -v ev="$plain" "BEGIN { exit !(ev / (179 * 128.5 / 128 * 3.14159265) > .99 && ev / 564.55 < 1.01) }"'
while read -r name factor; do
    if [ "$factor" = - ]; then
        check_error "$name is refused in one line" 1 "^vcmetrics: $name: " "vcmetrics -metrics Ev $name"
    else
        check "$name is $factor of the plain one" "
            awk -v ev=\"\$(ev $name)\" -v plain=$plain -v factor=$factor \\
                'BEGIN { r = ev / plain / factor; exit !(r > .9998 && r < 1.0002) }'"
    fi
done < list
