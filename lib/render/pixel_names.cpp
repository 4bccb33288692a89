// SPDX-License-Identifier: BSD-3-Clause
// See pixel_names.h.
#include "render/pixel_names.h"

#include "kernels/dialect/host.h"

namespace render {
using namespace kernels;

const scene::Object* Names::object(uint32_t index) const {
    return index < scene_.objects.size() ? &scene_.objects[index] : nullptr;
}

const scene::Object* Names::object(uint32_t prim, uint32_t inst) const {
    if (inst != NONE) return object(tables_.instance_object[inst]);
    return prim < tables_.prim_object.size() ? object(tables_.prim_object[prim]) : nullptr;
}

Names::Name Names::name(const scene::Object* o) const {
    return o ? Name{scene_.name(*o), scene::type_name(o->type), scene_.place(*o)} : Name{};
}

Names::Name Names::surface(uint32_t prim, uint32_t inst) const {
    const uint32_t inner = inst != NONE && prim < tables_.prim_object.size() ? tables_.prim_object[prim] : NONE;
    return inner < tables_.inner_names.size() ? tables_.inner_names[inner] : name(object(prim, inst));
}

Names::Name Names::modifier(uint32_t record) const {
    return record < tables_.modifier_names.size() ? tables_.modifier_names[record] : Name{};
}

Names::Name Names::material(uint32_t prim, uint32_t inst) const {
    return modifier(flatten::material_of(tables_, prim, inst));
}

std::string Names::source(uint32_t source) const {
    if (source < tables_.source_object.size()) return name(object(tables_.source_object[source])).name;
    const Relay& relay = tables_.relays[tables_.sources[source].relay];
    return this->source(relay.source) + " in " + surface(relay.prim, NONE).name;
}

std::string Names::distant(uint32_t number) const {
    return number < tables_.distant_object.size() ? name(object(tables_.distant_object[number])).name : "";
}

}  // namespace render
