// SPDX-License-Identifier: BSD-3-Clause
// See extent.h.
#include "scene/extent.h"

#include <algorithm>
#include <cstring>

namespace scene {

Extent extent_of(const Scene& s) {
    return {s.objects.size(),   s.files.size(),   s.string_pool.size(),
            s.name_pool.size(), s.history.size(), s.real_pool.size()};
}

void cut(Scene& s, const Extent& end) {
    s.objects.resize(end.objects);
    s.files.resize(end.files);
    s.string_pool.resize(end.strings);
    s.name_pool.resize(end.names);
    s.history.resize(end.history);
    s.real_pool.resize(end.reals);
    for (auto d = s.definitions.begin(); d != s.definitions.end();) {
        std::vector<int32_t>& objects = d->second;
        while (!objects.empty() && size_t(objects.back()) >= end.objects) objects.pop_back();
        d = objects.empty() ? s.definitions.erase(d) : std::next(d);
    }
}

base::Hash hash_of_objects(const Scene& s, size_t count) {
    base::Hash hash;
    if (count == 0) return hash;
    const auto word = [](uint64_t high, uint64_t low) { return high << 32 | (low & 0xffffffffu); };
    uint32_t last_file = 0;
    for (size_t i = 0; i < count; i++) {
        const Object& o = s.objects[i];
        last_file = std::max(last_file, o.file);
        hash.add({word(uint64_t(o.type) << 16 | o.string_count, uint32_t(o.modifier)), word(o.name, o.file),
                  word(o.line, o.string_at), word(o.real_count, uint32_t(o.alias_of)), o.real_at});
    }
    // the pools grow with the objects
    const Object& last = s.objects[count - 1];
    for (uint32_t k = 0; k < last.string_at + last.string_count; k++) hash.add_all(s.string_pool[k]);
    hash.add_all(Span<char>{s.name_pool.data(), last.name + std::strlen(&s.name_pool[last.name])});
    hash.add_all(Span<double>{s.real_pool.data(), size_t(last.real_at) + last.real_count});
    for (uint32_t k = 0; k <= last_file; k++) hash.add_all(s.files[k]);
    return hash;
}

}  // namespace scene
