# SPDX-License-Identifier: BSD-3-Clause
# CONTRIBUTING's recipe "Add a sampling technique", followed in a copy of the kernels: `uniform`, a quarter of the
# diffuse directions uniform over the hemisphere.  Compiles one unit test.
. "${TOP:?}/tests/lib.sh"
CXX=${CXX:-c++}
needs "$CXX"
echo '#include <doctest/doctest.h>' | $CXX -E -x c++ - > /dev/null 2>&1 || skip 'no doctest here'
mkdir -p tree/tests
cp -r "$TOP/lib" tree
cp -r "$TOP/tests/unit" tree/tests
cp -r tree before
cd tree || exit 2

# 1. the technique
cat > lib/kernels/sampling/uniform.h << 'END'
// SPDX-License-Identifier: BSD-3-Clause
// Technique of uniform directions over the hemisphere.
#ifndef LUX_UNIFORM_H
#define LUX_UNIFORM_H

FN float uniform_weight(void) { return 0.25f; }

FN float3 uniform_sample(float3 n, float x, float turn) {
    float3 e1, e2;
    float sn, cs, r = sqrt_(x * (2.0f - x));
    frame_of(n, &e1, &e2);
    k_sincos(K_TURN * turn, &sn, &cs);
    return unit3(add3(scale3(n, 1.0f - x), add3(scale3(e1, r * cs), scale3(e2, r * sn))));
}

FN float uniform_pdf(float3 n, float3 dir) { return dot3(dir, n) > 0.0f ? 1.0f / K_TURN : 0.0f; }
#endif
END

# 2. its place in the mixture
sed -i -e 's|^#include "kernels/sampling/portals.h"|&\n#include "kernels/sampling/uniform.h"|' \
    -e 's|^    if (mixture_takes(&u, highlights_weight|    if (mixture_takes(\&u, uniform_weight())) {\
        *dir = uniform_sample(n, u, x.y);\
    } else if (mixture_takes(\&u, highlights_weight|' \
    -e '/^FN float diffuse_pdf/,/^}/s|^    return pdf;|    w = uniform_weight();\
    return (1.0f - w) * pdf + w * uniform_pdf(n, dir);|' lib/kernels/sampling/mixture.h

recipe() { sed -n '/^## Add a sampling/,/^The estimator/s/^[0-9]\. `\(lib[^`]*\)`.*/\1/p' "$TOP/CONTRIBUTING.md"; }
cd ..
check 'the files that were touched are those of the recipe, and no others' '
    { diff -rq before tree || true; } | sed -E "s|^Only in tree/(.*): |\1/|; s|^Files before/(.*) and .*|\1|" |
        sort > touched
    recipe | sed "s/NAME/uniform/" | sort | diff - touched'

# build TREE: the test of the mixture, which calculates the mean of a cosine in several ways
build() {
    $CXX -std=c++17 -O1 -ffp-contract=off -I"$1/lib" -I"$1/tests" "$1/tests/unit/kernels_portals_test.cpp" -o "$1/test"
}
check 'the test of the mixture builds with it' 'build tree'
check 'it passes: the estimator is unbiased' 'tree/test'
check 'it fails if the pdf does not know the technique' '
    sed -i "s|^    w = uniform_weight();|    w = 0.0f;|" tree/lib/kernels/sampling/mixture.h && build tree
    ! tree/test > said && grep -q "mean" said'
