# SPDX-License-Identifier: BSD-3-Clause
# Links in the Markdown files lead to files that are there.  (`make site` checks the generated pages, anchors too.)
. "${TOP:?}/tests/lib.sh"
needs python3
cat > links.py << 'END'
import pathlib, re, sys
top = pathlib.Path(sys.argv[1])
seen = 0
for page in sorted(p for p in top.rglob("*.md") if not {"out", ".git"} & set(p.relative_to(top).parts[:1])
                   and not p.relative_to(top).parts[0].startswith("build")):
    text = re.sub(r"(?s)```.*?```|`[^`\n]*`", "", page.read_text())
    for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", text):
        if not re.match(r"[a-z]+:", target):
            seen += 1
            if not (page.parent / target).exists():
                print(f"{page.relative_to(top)}: {target}")
print(seen, file=sys.stderr)
END
check 'every link has its file' '
    python3 links.py "$TOP" > gone 2> seen; cat gone; test ! -s gone; test "$(cat seen)" -gt 10'
check 'a link without is seen' 'mkdir t; echo "[a](b.md) [c](https://x)" > t/p.md
    python3 links.py t 2> seen | grep -qx "p.md: b.md"'
