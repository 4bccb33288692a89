#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# site.sh OUT: the documentation as a site in OUT/html, by mkdocs-material: this tree's Markdown, the manual pages by
# mandoc, the Python reference from its docstrings.  A link that leads nowhere is an error (--strict).
set -euo pipefail
mkdir -p "$1" && out=$(cd "$1" && pwd) && top=$(cd "$(dirname "$0")/.." && pwd)
[ -x "$out/venv/bin/mkdocs" ] || {
    python3 -m venv "$out/venv"
    "$out/venv/bin/pip" install -q mkdocs==1.6.1 mkdocs-material==9.6.14 'mkdocstrings[python]==0.29.1' numpy
}
rm -rf "$out/docs" "$out/html"
mkdir -p "$out/docs/man"
cp -r "$top"/docs/. "$out/docs"
cp "$top/python/README.md" "$out/docs/python.md"
cp "$top/CONTRIBUTING.md" "$out/docs/contributing.md"
cp "$top/CHANGELOG.md" "$out/docs/changelog.md"
sed 's|(docs/|(|' "$top/README.md" > "$out/docs/index.md"
# Pages that are named become links: `docs/scale.md`, `man/ptrace.1`, `python/README.md`.
sed -i -E 's#`docs/((decisions/)?[a-z0-9-]+)\.md`#[\1](\1.md)#g; s#`(man ./)?man/([a-z-]+\.[157])`#[\2](man/\2.md)#g
    s#`python/README.md`#[Python](python.md)#g; s#`CONTRIBUTING.md`#[CONTRIBUTING](contributing.md)#g' "$out"/docs/*.md

links=$(cd "$top/man" && for page in *.[157]; do  # a link where a page names another one
    name=${page%.?} section=${page##*.}
    printf 's#<b>%s</b>[(]%s[)]#<a href="%s.html">%s(%s)</a>#g; ' "$name" "$section" "$page" "$name" "$section"
done)
{
    printf '# Manual pages\n\n| | |\n| --- | --- |\n'
    for page in "$top"/man/*.[157]; do
        name=$(basename "$page")
        { printf -- '---\ntitle: %s\n---\n' "$name"; printf '<div class="man" markdown="0">\n'
          mandoc -T html -O fragment "$page" | sed -E "s/^$/<!-- -->/; $links"; printf '</div>\n'; } \
            > "$out/docs/man/$name.md"
        about=$(sed -nE '/^[.]S[Hh] "?NAME/{n;s/.* \\- //;p;q}' "$page")
        printf '| [%s](man/%s.md) | %s |\n' "$name" "$name" "$about"
    done
} > "$out/docs/man.md"
{
    printf '# Decisions\n\n'
    for page in "$top"/docs/decisions/*.md; do
        printf -- '* [%s](decisions/%s)\n' "$(sed -n 's/^# //p;/^# /q' "$page" | head -n 1)" "$(basename "$page")"
    done
} > "$out/docs/decisions.md"
printf '# Python reference\n\n::: luxpipe\n    options:\n      members: [%s]\n\n## luxpipe.plot\n\n::: luxpipe.plot\n' \
    'render, frames, measure, read, difference, Result, Interval, Error, Warning, evalglare, rpict' > "$out/docs/api.md"
# Numbers under their names, and the head of a manual page over its width.
cat > "$out/docs/site.css" << 'END'
pre { tab-size: 12; }
.man table.head, .man table.foot { width: 100%; }
.head-vol, .foot-date { text-align: center; }
.head-rtitle, .foot-os { text-align: right; }
END

cd "$top"
"$out/venv/bin/mkdocs" build --strict --quiet -f mkdocs.yml
find "$out/html" -name '*.html' | wc -l | sed "s|\$| pages; with search: python3 -m http.server -d $out/html|"
