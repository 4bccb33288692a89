# SPDX-License-Identifier: BSD-3-Clause
# Functions of more than `most` lines, heads included, in files that clang-format has laid out: there a function begins
# at the margin, or four columns in if it is a member, and its closing brace is below its first letter.
#   awk -v most=80 -f long_functions.awk file ...        prints "lines file:line: head"
FNR == 1 { inside = 0; head = "" }

inside {
    if (index($0, margin "}") != 1) next
    if (FNR - first + 1 > most) print FNR - first + 1, FILENAME ":" first ": " head
    inside = 0; head = ""
    next
}

{ line = $0; sub(/ *\/\/.*$/, "", line) }

head == "" && line ~ /^(    )?[A-Za-z~]/ &&
line !~ /^ *(namespace|struct|class|enum|union|extern|typedef|using|public|private|protected)[ :]/ {
    head = line; first = FNR; margin = line ~ /^ / ? "    " : ""
}

head != "" && line ~ /\{$/ && line !~ /= *\{$/ { inside = 1; next }
head != "" && line ~ /[;}]$/ { head = "" }
