# SPDX-License-Identifier: BSD-3-Clause
# The page of a year with EN 17037's four parts and shades that move, from tables by hand: levels, rules, what lacks.
. "${TOP:?}/tests/lib.sh"
needs vcyear python3
python3 "$TOP/tests/tools/room_year.py" floor open > floor.tsv
python3 - << 'END'
days = [31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31]
desk = "sky\tview\tstate\tDGP\tDGP.lo\tDGP.hi\tpixels\terrors\n"
for month in range(1, 13):
    for day in range(1, days[month - 1] + 1):
        # Glare at noon on every tenth day: half closed shades are enough in January, not in February.
        for hour, name, dgps in ((9, "east", (.2, .2, .2)), (12, "desk<1>", (.5, .5 if month == 2 else .3, .2))):
            for state, dgp in zip(("open", "half", "shut"), dgps if day % 10 == 0 else (.2, .2, .2)):
                for view in ("east", "desk<1>"):
                    d = dgp if view == name else .2
                    desk += f"{month:02}{day:02}_{hour:02}30\t{view}\t{state}\t{d}\t{d}\t{d}\t9999\tDGP=.001/8\n"
open("desks.tsv", "w").write(desk)
with open("day.wea", "w") as wea, open("sun.tsv", "w") as sun:
    wea.write("place Berlin\nlatitude 52.52\nlongitude -13.4\ntime_zone -15\nsite_elevation 0\n")
    wea.write("weather_data_file_units 1\n")
    sun.write("sky\tgrid\tpoint\tE\tlo\thi\n")
    for m in range(300, 1200, 5):
        wea.write(f"3 21 {m / 60} 800 80\n")
        e = 500 if 600 <= m < 720 else 0
        sun.write(f"0321_{m // 60:02}{m % 60:02}\twindow\t0\t{e}\t{e}\t{e}\n")
END
header='region\tpixels\tsr\tshare\tx\ty\tz\n'
printf "${header}opening\t300\t.001\t.1\t0\t-1\t0\n${header}sky\t9\t.1\t.02\t0\t-1\t0\n" > out.tsv
page() {
    vcyear -w- -shades 'glare .40 at desk<1> until morning' -report page.html "$@" desks.tsv > said
    sed 's/<[^>]*>/ /g' page.html > text
}
parts=(-en17037 site.wea -plane floor.tsv -sunlight day.wea 11 -openings sun.tsv -viewout out.tsv)
says() { tr -s ' \n' ' ' < text | grep -qF "$1"; }

check 'provision: level, value, rule, what lacks, and which shades' '
    page "${parts[@]}"; says "Daylight and glare by EN 17037"
    says "Daylight provision floor, 20 sensors minimum 300 lx on 50.0 % 100 lx on 95.0 % minimum: 300 lx on 50 % of"
    says "each in half of 4380 daylight hours, those of most diffuse light in site.wea. Shades: open."
    says "for medium: 500 lx on 0.0 % where 50 % are asked, 300 lx on 50.0 % where 95 % are asked"'
check 'sunlight' '
    says "Exposure to sunlight window minimum 2.00 h on 21 Mar minimum: the sun, from 11° of height on, reaches"
    says "Steps of 5 min. for medium: 1.00 h more"'
check 'view out: what the sight angle allows' '
    says "View out one point at most medium 36.0° of the horizon seen: sky"; says "for high: 18.0° more"'
check 'glare: the worst view, and how many hours are too many' '
    says "Protection from glare east, the worst of 2 views high"
    says "at most 5 % of the 730 hours counted, 36 of them, have a DGP above"'
check 'shades: rules in the words of who wrote them, and in ours; hours, moves, why' '
    says "Shades that move Group"; says "glare .40 at desk&lt;1&gt; until morning"
    says "the most open state in which the DGP of desk&lt;1&gt; is at most 0.4; the last one where none is; closed"
    [ "$(grep -c "shades half: glare .40" page.html)" -gt 30 ]; grep -q "^why .* in 35 hours$" said; says "35 hours"
    says "shut 0.3 %"'
check 'each hour of the maps says its state and why' '
    why="shades shut: glare .40 at desk&lt;1&gt; until morning</title>"
    grep -q "<title>10 Feb, 12:30: DGP 0.200 (.*); $why" page.html; grep -q "<title>10 Feb, 12:30: $why" page.html
    vcyear -w- -shades glare -plot map.svg desks.tsv > said
    grep -q "<title>10 Jan, 12:30: shades half: glare</title>" map.svg'
check 'parts that no table tells are there with their rule' '
    page -viewout out.tsv; says "Daylight provision not counted &ndash; minimum: 300 lx"
    says "Exposure to sunlight not counted &ndash; minimum: the sun, from a height that the norm"'
check 'a page of glare alone has no parts' 'page; not says "Part of EN 17037"; says "Glare in 730 hours of a year"'
check_error 'a plane needs the daylight hours' 1 '^vcyear: -plane: needs the weather file of the year .-en17037.$' \
    'page -plane floor.tsv'
check_error 'openings need a day' 1 '^vcyear: -openings: needs the day and the lowest sun .-sunlight.$' \
    'page -openings sun.tsv'
check_error 'a plane is of sensors' 1 '^vcyear: -plane: is of sensors .vcmetrics -each., not of views$' \
    'vcyear -w- -state open -report p.html -en17037 site.wea -plane desks.tsv desks.tsv'
check_error 'no opening' 1 '^vcyear: two.tsv: has no region "opening" .vcregion -list.$' '
    grep -v opening out.tsv > two.tsv; page -viewout two.tsv'
check_error 'these tables are of a report' 1 '^vcyear: -plane: is of a report .-report.$' \
    'vcyear -en17037 site.wea -plane floor.tsv desks.tsv'
