# SPDX-License-Identifier: BSD-3-Clause
# CONTRIBUTING's recipe "Add a sampling technique", followed in a copy of the tree: `beacon`, a quarter of the diffuse
# directions inside the cone of a ball about the first portal.  Its target has a record in the scene's tables, a point
# has a field for it.  Compiles one unit test, and all that has the scene's tables.
. "${TOP:?}/tests/lib.sh"
build=${BIN%/bin}
CXX=${CXX:-c++}
needs "$CXX" ninja
[ -f "$build/build.ninja" ] || skip 'not a build of ninja'
echo '#include <doctest/doctest.h>' | $CXX -E -x c++ - > /dev/null 2>&1 || skip 'no doctest here'
mkdir -p tree/tests
cp -r "$TOP/lib" tree
cp -r "$TOP/tests/unit" tree/tests
cp -r tree before
cd tree || exit 2

# 1. the technique
cat > lib/kernels/sampling/beacon.h << 'END'
// SPDX-License-Identifier: BSD-3-Clause
// Technique of beacons: directions inside the cone of a ball, all alike.
#ifndef LUX_BEACON_H
#define LUX_BEACON_H

FN float3 beacon_offset(TABLES(const SceneTables) s, float3 p) {
    return sub3(f3_of(s->beacons[0].centre), p);
}

// 1 - cosine of half the cone at p; 0 without a beacon, and inside of it.
FN float beacon_cone(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p) {
    if (par->beacons_count == 0u) return 0.0f;
    float3 offset = beacon_offset(s, p);
    float sine2 = s->beacons[0].radius2 / dot3(offset, offset);
    return sine2 < 1.0f ? sine2 / (1.0f + sqrt_(1.0f - sine2)) : 0.0f;
}

FN float beacon_weight(float cone) { return cone > 0.0f ? 0.25f : 0.0f; }

FN float3 beacon_sample(TABLES(const SceneTables) s, float3 p, float cone, float x, float turn) {
    float3 axis = unit3(beacon_offset(s, p)), e1, e2;
    float sn, cs, drop = x * cone, r = sqrt_(drop * (2.0f - drop));
    orthonormal_basis(axis, &e1, &e2);
    k_sincos(K_TURN * turn, &sn, &cs);
    return unit3(add3(scale3(axis, 1.0f - drop), add3(scale3(e1, r * cs), scale3(e2, r * sn))));
}

FN float beacon_pdf(TABLES(const SceneTables) s, float3 p, float cone, float3 dir) {
    float cosine = dot3(dir, unit3(beacon_offset(s, p)));
    return 1.0f - cosine <= cone ? 1.0f / (K_TURN * cone) : 0.0f;
}
#endif
END

# 2. its place in the mixture: the first that sample_diffuse() asks, the last that diffuse_pdf() adds
place() {  # NAME FILE
    sed -i -e "s|^#include \"kernels/sampling/highlights.h\"|#include \"kernels/sampling/$1.h\"\n&|" \
        -e "s|^    mixture.light = .*|&\n    mixture.$1_cone = $1_cone(s, par, p);|" \
        -e "s|^    if (mixture_takes(&u, |    if (mixture_takes(\&u, $1_weight(mixture->$1_cone))) {\n\
        *dir = $1_sample(s, p, mixture->$1_cone, u, x.y);\n    } else if (mixture_takes(\&u, |" \
        -e "/^FN float diffuse_pdf/,/^}/s|^    return pdf;|    w = $1_weight(mixture->$1_cone);\n\
    if (w > 0.0f) pdf = (1.0f - w) * pdf + w * $1_pdf(s, p, mixture->$1_cone, dir);\n    return pdf;|" "$2"
}
place beacon lib/kernels/sampling/mixture.h

# 3. its field, and the record of its target
sed -i -e 's|^    uint highlights;.*|&\n    float beacon_cone;|' \
    -e 's|^// State of the mixture.s techniques.*|STRUCT(Beacon) {\
    Packed3 centre;\
    float radius2;\
};\n\n&|' -e 's|^    TABLE(Portal, portals).*|&\n    TABLE(Beacon, beacons) \\|' lib/kernels/records.h
# 4. frames of before and after are not to be summed
version() { sed -n 's/^constexpr int estimator = \([0-9]*\);.*/\1/p' "$1/lib/render/fingerprint.h"; }
sed -i "s/^constexpr int estimator = .*/constexpr int estimator = $(($(version .) + 1));/" lib/render/fingerprint.h

# 5. how they are found
cat > lib/sampling/beacons.h << 'END'
// SPDX-License-Identifier: BSD-3-Clause
// Finds the beacon: the first portal's centre.
#pragma once
#include "flatten/flat_scene.h"
#include "kernels/dialect/host.h"

namespace sampling {

inline void find_beacons(flatten::FlatScene& scene) {
    if (!scene.portals.empty()) scene.beacons.push_back({scene.portals[0].centre, 1});
}

}  // namespace sampling
END
sed -i -e 's|^#include "sampling/highlights.h"|#include "sampling/beacons.h"\n&|' \
    -e 's|^    find_portals.*|&\n    find_beacons(scene);|' lib/sampling/targets.h

recipe() {
    sed -n '/^## Add a sampling/,/^Then its/{s/^[0-9]\. //;/^`lib/s/:.*//p}' "$TOP/CONTRIBUTING.md" |
        grep -o '`lib[^`]*`' | tr -d '`'
}
cd ..
check 'the files that were touched are those of the recipe, and no others' '
    { diff -rq before tree || true; } | sed -E "s|^Only in tree/(.*): |\1/|; s|^Files before/(.*) and .*|\1|" |
        sort > touched
    recipe | sed "s/NAME/beacon/" | sort | diff - touched'

check 'a second technique takes its place beside the first' '
    cp tree/lib/kernels/sampling/mixture.h both.h; place lamp both.h
    for name in beacon lamp; do
        grep -c "$name[_]weight(mixture\|$name[_]sample(\|$name[_]pdf(" both.h | grep -qx 4
    done
    [ "$(grep -n "if (mixture_takes" both.h | grep -o "[a-z]*_weight" | tr "\n" " ")" = \
        "lamp_weight beacon_weight highlights_weight portals_weight " ]'

# build_unit TREE: the test of the mixture, which calculates the mean of a cosine in several ways.  Its only portal
# becomes the beacon, too.
build_unit() {
    $CXX -std=c++17 -O1 -ffp-contract=off -I"$1/lib" -I"$1/tests" "$1/tests/unit/kernels_portals_test.cpp" -o "$1/test"
}
sed -i -e "s|^        par.portal_most = .9f;|&\n        beacon.centre = portals[0].centre;\
        s.beacons = \&beacon;\n        par.beacons_count = 1;|" \
    -e "s|^struct Room : Tables {|&\n    Beacon beacon = {{}, 1};|" tree/tests/unit/kernels_portals_test.cpp
check 'the test of the mixture builds with it' 'build_unit tree'
check 'it passes: the estimator is unbiased' 'tree/test'
check 'it fails if the pdf does not know the technique' '
    cp -r tree broken
    sed -i "s|^    w = beacon_weight(.*|    w = 0.0f;|" broken/lib/kernels/sampling/mixture.h; build_unit broken
    ! broken/test > said && grep -q "mean" said'

# Pictures by path reuse: those of the copy, by its baseline kernels, against those of the build.
cat > bias.cpp << 'END'
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include <fstream>
#include <iomanip>

#include "physics/blocks.h"
#include "physics/seeds.h"
#include "render/fingerprint.h"

// A room with a window, without ceiling.
const char* const room =
    "void glow bright 0 0 4 9 9 12 0\nbright source sky 0 0 4 0 0 1 360\nvoid plastic matt 0 0 5 .7 .6 .5 0 0\n"
    "matt polygon floor 0 0 12 -2 -2 0 2 -2 0 2 2 0 -2 2 0\nmatt polygon back 0 0 12 -2 2 0 2 2 0 2 2 3 -2 2 3\n"
    "matt polygon front 0 0 12 -2 -2 0 -2 -2 3 2 -2 3 2 -2 0\nvoid glass pane 0 0 3 .8 .9 .8\n"
    "pane polygon window 0 0 12 2 -2 0 2 -2 3 2 2 3 2 2 0\n";

laws::Means means(const std::string& device, uint64_t first_seed) {
    const scene::Scene scene = laws::scene_of(room);
    view::View view;
    view.vp = {-1.5, -1.8, 1.6};
    view.vd = {.5, 1, -.25};
    view.vh = view.vv = 80;
    return laws::over_seeds(12, 2, [&](uint64_t seed) {
        render::RenderOptions options;
        options.seed = first_seed + seed;
        options.noisy_share = 0;
        options.ab = 1;
        render::Renderer renderer(scene, view, 32, 32, options, device, {});
        return laws::block_means(renderer, 32, 1, 1, 250);
    });
}

TEST_CASE("reference") {
    const laws::Means without = means("cpu:avx2", 0);
    std::ofstream("reference") << std::setprecision(17) << without.mean[0] << " " << without.variance[0] << " "
                               << render::estimator;
}
TEST_CASE("no bias") {
    double mean = 0, variance = 0;
    int estimator = 0;
    std::ifstream("reference") >> mean >> variance >> estimator;
    REQUIRE(mean > 0);
    CHECK(estimator < render::estimator);
    const laws::Means with = means("cpu:baseline", 100);
    const double error = std::sqrt(variance + with.variance[0]) / mean;
    const double difference = with.mean[0] / mean - 1;
    MESSAGE("difference " << 100 * difference << " +- " << 100 * error << " %");
    CHECK(error < .001);
    CHECK(difference != 0);
    CHECK(std::abs(difference) < 4 * error);
}
END
build_commands "$build" path_reuse_test > commands
# compile TREE FILE AS: FILE of the copy, or of this folder, as the build compiles AS, kernels alone with optimisation.
compile() {
    local level=-O0
    case $3 in */cpu_kernels_*) level=-O1 ;; esac
    sed -n "s|^cd [^&]*&& ||; s|^[^ ]*ccache ||; s| -MD.* -c | -c |; s| && .*||; s| -o [^ ]*||g; s|-O3|$level|
        s|$TOP/lib|$PWD/$1/lib|g; \| -c .*/$3\$|{s| -c .*| -c $2 -o $PWD/$1/$(basename "$2").o|p;q}" commands > command
    [ -s command ] && (cd "$build" && bash -e "$TMP/command")
}
link() {
    tail -1 commands | sed "s|^[^ ]* && ||; s| -o bin/path_reuse_test | $PWD/$1/*.cpp.o -Wl,-z,muldefs -o $PWD/$1/bias |
        s| [^ ]*/path_reuse_test.cpp.o||; s| && :||" > command
    (cd "$build" && bash -e "$TMP/command")
}
if [ "$(uname -m)" = x86_64 ] && grep -q avx2 /proc/cpuinfo; then
    check 'what has the tables of a scene compiles with it' '
        for file in $(grep -oE "lib/(device|flatten|sampling|render)/[a-z_0-9]*[.]cpp" commands | sort -u |
            grep -vE "cpu_kernels_avx|kernel_source"); do
            compile tree "$PWD/tree/$file" "$file"
        done
        for tree in before tree; do
            compile $tree "$PWD/bias.cpp" tests/physics/path_reuse_test.cpp
            link $tree
        done'
    check 'path reuse has no bias with it' 'before/bias -tc=reference && tree/bias -tc="no bias"'
    check 'it has if a field of the point is lost' '
        mkdir -p lost && cp -r tree/lib lost && cp tree/*.cpp.o lost
        sed -i "s|^    prefix.mixture = .*|&\n    prefix.mixture.beacon_cone = 0.0f;|" \
            lost/lib/kernels/integrator/connect.h
        compile lost "$PWD/lost/lib/device/cpu_kernels_baseline.cpp" lib/device/cpu_kernels_baseline.cpp
        link lost
        ! lost/bias -tc="no bias" > said && grep -q "difference) <" said'
fi
