// SPDX-License-Identifier: BSD-3-Clause
// See pixel_names.h.
#include "render/pixel_names.h"

#include "kernels/dialect/host.h"

namespace render {
using namespace kernels;

const scene::Object* Names::object(uint32_t index) const {
    return index < scene_.objects.size() ? &scene_.objects[index] : nullptr;
}

const scene::Object* Names::surface(uint32_t prim, uint32_t inst) const {
    if (inst != NONE) return object(tables_.instance_object[inst]);
    return prim < tables_.prim_object.size() ? object(tables_.prim_object[prim]) : nullptr;
}

std::string Names::modifier(uint32_t record) const {
    return record < tables_.modifier_names.size() ? tables_.modifier_names[record].name : "";
}

std::string Names::source(uint32_t source) const {
    if (source < tables_.source_object.size()) return name(object(tables_.source_object[source]));
    const Relay& relay = tables_.relays[tables_.sources[source].relay];
    return this->source(relay.source) + " in " + name(surface(relay.prim, NONE));
}

std::string Names::distant(uint32_t number) const {
    return number < tables_.distant_object.size() ? name(object(tables_.distant_object[number])) : "";
}

}  // namespace render
