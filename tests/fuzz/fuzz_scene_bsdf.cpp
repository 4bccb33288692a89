// SPDX-License-Identifier: BSD-3-Clause
// BSDF files: what is read is whole: matrices of their bases' size, trees whose children exist.
#include "fuzz_try.h"
#include <cstdlib>
#include <string>
#include "scene/bsdf_xml.h"

static void check_tree(const scene::BsdfTree& t) {
    if (t.value.size() != t.child.size() || (t.dims && t.value.empty())) abort();
    for (uint32_t c : t.child)
        if (c != scene::BsdfTree::LEAF && c + (size_t(1) << t.dims) > t.child.size()) abort();
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    try_to([&] {
        const scene::Bsdf b = scene::parse_bsdf({reinterpret_cast<const char*>(data), size}, "fuzz.xml");
        for (const auto* side : {&b.reflection, &b.transmission})
            for (const scene::BsdfTable& t : *side) {
                if (!t.y.empty() && t.y.size() != b.bases[t.incident].cells() * b.bases[t.exit].cells()) abort();
                if (t.present && t.y.empty() && !t.tree.dims) abort();
                for (const auto* tree : {&t.tree, &t.u, &t.v}) check_tree(*tree);
            }
    });
    return 0;
}
