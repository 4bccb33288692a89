# SPDX-License-Identifier: BSD-3-Clause
# vcyear -report: a page of a year, whose cells lead to pictures or to commands that run.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcyear python3
cp "$TOP"/examples/scenes/office/*.* "$TOP/studies/year/desks.vf" .
grep -E "VIEW= (window|back) " desks.vf > two.vf
python3 "$TOP/studies/year/weather.py" | sed '1s/Made up,-,-/Here,<North>,Land/' > site.epw
scene='materials.rad layout.rad'
ptrace -w- -views two.vf -x 16 -y 16 -wea site.epw -hours '0121 0621 1221 9-13' -frames 5 $scene 2> said |
    ptaccum -every x2/8 | vcmetrics -W- -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95 -last > hours.tsv
ptrace -w- -views two.vf -x 16 -y 16 -wea site.epw -hours 1221_1230 -frames 5 $scene 2> said | ptaccum -last -o %s.exr
ptrace -w- -vtl -vp 2 3 2.7 -vd 0 0 -1 -vu 0 1 0 -vh 4 -vv 6 -x 40 -y 60 -wea site.epw -hours 0621_1230 -frames 2 \
    $scene 2> said | ptaccum -last -o plan_%s.exr
page() {
    vcyear -report year.html -title 'A <room>' -views two.vf -wea site.epw -plan plan_0621_1230.exr \
        -pictures window_1221_1230.exr -pictures back_1221_1230.exr \
        -command "ptrace -w- -picture -frames 5 -o %s.exr -views two.vf -x 16 -y 16 -wea site.epw $scene" "$@"
}

check 'it says of how many hours and days it is, of which place and weather, and what is left out' '
    page hours.tsv > five; vcyear hours.tsv > plain; [ "$(wc -l < five)" = "$(wc -l < plain)" ]
    grep -q "<h1>Glare in 12 hours of 3 days</h1>" year.html; grep -q "Class of EN 17037, of 3 days" year.html
    grep -q "A &lt;room&gt;" year.html
    grep -q "Here, &lt;North&gt;, Land, 39.74° north, 105.18° west" year.html
    grep -q "site.epw; its source: weather.py<br>made up" year.html
    grep -q "Left out: 8,748 hours of the file" year.html
    [ "$(grep -c "<g class=.scale.*>[125] m</text>.*>N</text>" year.html)" = 1 ]
    [ "$(grep -c "<g class=.arrow" year.html)" = 2 ]; ! grep -qE "src=.(http|file)|<script" year.html'
check 'every cell leads to a picture or a command' '
    grep -o "<a href=.#[^\"]*" year.html | sed "s/.*#//" | sort > from; [ "$(wc -l < from)" = 24 ]
    grep -oE "<(figure|span) id=.[^\"]*" year.html | sed "s/.*\"//" | sort | cmp - from
    grep -o "<figure id=.[^\"]*" year.html | sed "s/.*\"//" | sort | paste -sd " " |
        grep -qx "v0_1221_1230 v1_1221_1230"'
check 'the command of a cell runs in another folder, to the hour that was counted' '
    python3 -c "import html, re
page = open(\"year.html\").read()
text = re.search(r\"<p class=.command.>.*?<code>(.*?)<span.*?id=.v0_0121_0930.>(.*?)</span>.*</span>( .*?)</code>\",
                 page, re.S)
print(html.unescape(\"\".join(text.groups())))" > command
    mkdir other; cp *.* other; (cd other; bash ../command 2> said)
    vcmetrics -W- -metrics Ev other/window_0121_0930.exr | tail -n 1 | cut -f 4 > is
    awk -F "\t" "\$3 == \"window\" && \$4 == \"0121_0930\" { print \$5 }" hours.tsv | paste is - |
        awk "{ exit !(\$1 > 0 && (\$1 / \$2 - 1) ^ 2 < .15 ^ 2) }"'
check 'a year that was cut off says so' '
    sed 9q hours.tsv > some.tsv; page some.tsv > five; grep -q "Glare in 8 of 12 hours of 2 days" year.html'
check_error 'words of a report without one' 1 '^vcyear: -plan: is of a report .-report.$' 'vcyear -plan x.exr hours.tsv'
check_error 'a plan that is no plan' 1 '^vcyear: -plan: is no parallel view .ptrace -vtl.$' '
    vcyear -report x.html -views two.vf -plan window_1221_1230.exr hours.tsv'
check_error 'sensors have no such page' 1 '^vcyear: -report: is of views, not of sensors$' '
    printf "sky\tgrid\tpoint\tE\tlo\thi\n0621_1430\tg\t0\t5\t4\t6\n" > g.tsv; vcyear -w- -report x.html g.tsv'
