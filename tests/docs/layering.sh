# SPDX-License-Identifier: BSD-3-Clause
# Arrows go one way: an #include of "library/..." is allowed only downwards.  The table is docs/architecture.md's.
. "${TOP:?}/tests/lib.sh"

# who: whom it may include (besides itself)
cat > layers <<'END'
lib/base:
lib/kernels:
lib/view: base
lib/image: base view
lib/film: base view image
lib/display: base image
lib/spectrum: base image
lib/cal: base image spectrum kernels
lib/generators: base cal
lib/weather: base generators
lib/scene: base cal generators kernels
lib/uncertainty: base image
lib/glare: base view image
lib/evalglare: base view glare
lib/report: base view image uncertainty glare
lib/region: base view image display
lib/year: base view image display uncertainty glare report weather
lib/bvh: base kernels
lib/flatten: base spectrum cal scene bvh kernels
lib/device: base flatten bvh kernels
lib/sampling: base flatten device kernels
lib/render: base view image spectrum scene flatten device sampling kernels
lib/visibility: base region scene flatten
lib/live: base view image display glare region
tools/ptaccum: base view image film display
tools/vcmetrics: base view image spectrum display uncertainty glare evalglare report region visibility
tools/vcregion: base view image region visibility
tools/vcyear: base image report year
tools/vcview: base live
tools/ptrace: base view image film weather spectrum region scene render
END

# "file:line: lib/x includes y" for every include that points upwards in the tree at $1.
upward() {
    grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"[a-z_]+/' "$1/lib" "$1/tools" | sed "s|^$1/||" |
    sed -nE 's#^((lib|tools)/[a-z_]+)(/[^:]*:[0-9]+):.*"([a-z_]+)/.*#\1 \3 \4#p' |
    while read -r who place library; do
        case "$(grep "^$who:" layers) lib/${who#*/} " in
            *" $library "* | *" lib/$library "*) ;;
            *) echo "$who$place: includes $library" ;;
        esac
    done
}

check 'no library includes one above it' 'upward "$TOP" > hits; cat hits >&2; test ! -s hits'

# The system is asked in lib/base alone, and in what a system without POSIX does not get.
posix() {
    local names='unistd|fcntl|signal|poll|spawn|dlfcn|pwd|glob|termios|pthread|(sys|netinet|arpa)/.*'
    (cd "$1" && grep -rnE "#include <($names)\.h>" lib tools) |
        grep -vE '^(lib/(base|live|device)|tools/vcview)/'
}
check 'no POSIX header outside lib/base, lib/live, lib/device and vcview' '! posix "$TOP" >&2'

# Stages are functions of values: what a stage has returned does not change behind a const.
hidden() { grep -rnE '\bmutable\b|const_cast|void *\*' --include='*.cpp' --include='*.h' --include='*.inl' "$@"; }
check 'no mutable, const_cast or void* where frames are rendered' '! hidden "$TOP"/lib/render "$TOP"/lib/device >&2'

for folder in "$TOP"/lib/*/ "$TOP"/tools/*/; do
    who=${folder#"$TOP/"}; who=${who%/}
    check "$who has its row in the table" "grep -q '^$who:' layers"
done
check 'docs/architecture.md shows the same table' '
    sed -nE "s/^\| \`([a-z/]+)\` \| *([a-z ]*[a-z])? *\|.*/\1: \2/p" "$TOP/docs/architecture.md" | sed "s/ *$//" |
        sort > page
    sort layers | diff page -'

mkdir -p lib/base tools && echo '#include "render/options.h"' > lib/base/x.h
mkdir -p lib/image && echo '#include <sys/stat.h>' > lib/image/x.h
check 'a POSIX header is seen' 'posix . | grep -q "^lib/image/x.h:1:"'
check 'an upward include is seen' 'upward . | grep -qx "lib/base/x.h:1: includes render"'
