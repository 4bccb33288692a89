// SPDX-License-Identifier: BSD-3-Clause
// Builds the light tree (kernels/light/light_tree.h): separates distant sources from others, then splits by the
// apertures that their light must pass, so that a node's apertures hold for all its sources, then by position, in
// halves across the longest side.  The data of a node depend on its set of sources alone.
#include "flatten/light_tree.h"

#include <algorithm>

#include "flatten/pack.h"
#include "flatten/surfaces.h"
#include "kernels/dialect/host.h"

namespace flatten {
namespace {

constexpr double unlimited = 1e30;
constexpr double rounding = 1.0001;  // keeps balls from shrinking in conversion to float

// A source, as the tree sees it.
struct Emitter {
    uint32_t source;
    bool distant;
    Vec3 centre, axis;  // axis: its normal, 0 if it has none
    double radius, power, far;
    std::vector<uint32_t> chain;  // its relays, the nearest to the point lit first
    uint32_t aperture_at;
};

Emitter emitter_of(const FlatScene& scene, uint32_t i) {
    const Source& q = scene.sources[i];
    const uint32_t kind = q.kind;
    const Vec3 u = vec_of(q.u), v = vec_of(q.v), w = vec_of(q.normal);
    Emitter emitter{};
    emitter.source = i;
    emitter.distant = kind == SK_DISTANT;
    emitter.centre = vec_of(q.centre);
    emitter.radius = q.radius;
    if (kind == SK_CYLINDER) emitter.radius += length(u);
    if (q.sheared != 0) emitter.radius = 2 * (length(u) + length(v) + length(w));  // holds any sampled point
    if (kind == SK_PARALLELOGRAM || kind == SK_POLYGON || kind == SK_RING) emitter.axis = unit(w);
    emitter.power = double(std::max(q.power, 1e-20f)) * std::max(q.area, 1e-20f);  // never 0
    emitter.far = q.max_radius > 0 ? q.max_radius + emitter.radius : unlimited;

    uint32_t relay = q.relay;
    const uint32_t apertures = relay == NONE ? 0 : scene.relays[relay].aperture_count;
    emitter.aperture_at = relay == NONE ? 0 : scene.relays[relay].aperture_at;
    for (uint32_t k = 0; k < apertures; k++) {
        emitter.chain.push_back(scene.relays[relay].prim);
        relay = scene.sources[scene.relays[relay].source].relay;
    }
    return emitter;
}

bool by_chain(const Emitter& a, const Emitter& b) {
    if (a.distant != b.distant) return a.distant;
    return a.chain != b.chain ? a.chain < b.chain : a.source < b.source;
}

using Emitters = std::vector<Emitter>;

class LightTree {
public:
    explicit LightTree(Emitters& emitters) : emitters_(emitters) {}

    // Appends the nodes of emitters begin .. end - 1, all distant or none.
    void plant(size_t begin, size_t end) {
        const size_t at = nodes.size();
        nodes.emplace_back();
        if (end - begin > 1) {
            const size_t middle = split(begin, end);
            plant(begin, middle);
            const size_t second = nodes.size();
            plant(middle, end);
            nodes[at].share = share(nodes[at + 1].power, nodes[second].power);
        }
        describe(begin, end, nodes[at]);
        nodes[at].past = uint32_t(nodes.size());
    }

    std::vector<LightNode> nodes;

private:
    // Number of relays that all have in common, the nearest first.
    size_t common(size_t begin, size_t end) const {
        const std::vector<uint32_t>& first = emitters_[begin].chain;
        size_t same = first.size();
        for (size_t i = begin + 1; i < end; i++) {
            const std::vector<uint32_t>& c = emitters_[i].chain;
            same = std::min(same, c.size());
            same = size_t(std::mismatch(first.begin(), first.begin() + long(same), c.begin()).first - first.begin());
        }
        return same;
    }

    // Splits where chains differ, as near the middle as the next relay allows; else across the longest side.
    size_t split(size_t begin, size_t end) {
        const size_t middle = begin + (end - begin) / 2, next = common(begin, end);
        const auto relay = [&](size_t i) { return next < emitters_[i].chain.size() ? emitters_[i].chain[next] : NONE; };
        size_t best = 0;
        for (size_t i = begin + 1; i < end; i++)
            if (relay(i) != relay(i - 1) && (best == 0 || gap(i, middle) < gap(best, middle))) best = i;
        if (best != 0) return best;

        Box box;
        for (size_t i = begin; i < end; i++) grow(box, emitters_[i].centre);
        const Vec3 size = box.hi - box.lo;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        std::nth_element(at(begin), at(middle), at(end), [&](const Emitter& a, const Emitter& b) {
            return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis] : a.source < b.source;
        });
        return middle;
    }

    Emitters::iterator at(size_t i) const { return emitters_.begin() + long(i); }
    static size_t gap(size_t a, size_t b) { return a < b ? b - a : a - b; }

    // Probability of the first of two children, never 0 or 1: the other may hold the only source visible from a point.
    static float share(float first, float second) {
        return std::clamp(first / (first + second), 1 / 1024.f, 1023 / 1024.f);
    }

    void describe(size_t begin, size_t end, LightNode& node) const {
        const Emitter& first = emitters_[begin];
        Box box;
        Vec3 axis;
        double power = 0, radius = 0, spread = 0, far = 0;
        for (size_t i = begin; i < end; i++) {
            grow(box, emitters_[i].centre);
            axis = axis + emitters_[i].axis * emitters_[i].power;
            power += emitters_[i].power;
        }
        const Vec3 centre = end - begin == 1 ? first.centre : (box.lo + box.hi) * .5;
        axis = unit(axis);
        for (size_t i = begin; i < end; i++) {
            const Emitter& emitter = emitters_[i];
            radius = std::max(radius, length(emitter.centre - centre) + emitter.radius);
            far = std::max(far, length(emitter.centre - centre) + emitter.far);
            spread = std::max(spread, length(emitter.axis) > 0 ? length(emitter.axis - axis) : 2);
        }

        node.centre = packed(centre);
        node.axis = packed(axis);
        node.radius = float(radius * rounding);
        node.spread = float(spread * rounding);
        node.power = float(power);
        node.far = first.distant ? 0 : float(far * rounding);
        node.aperture_at = first.aperture_at;
        node.aperture_count = uint32_t(common(begin, end));
        node.source = end - begin == 1 ? first.source : NONE;
    }

    Emitters& emitters_;
};

}  // namespace

void plant_light_tree(FlatScene& scene) {
    if (scene.sources.size() < LIGHT_TREE_FROM) return;
    Emitters emitters;
    for (uint32_t i = 0; i < scene.sources.size(); i++) emitters.push_back(emitter_of(scene, i));
    std::sort(emitters.begin(), emitters.end(), by_chain);
    const auto local =
        std::find_if(emitters.begin(), emitters.end(), [](const Emitter& emitter) { return !emitter.distant; });
    const size_t distant = size_t(local - emitters.begin());

    LightTree tree(emitters);
    if (distant > 0) tree.plant(0, distant);
    if (distant < emitters.size()) tree.plant(distant, emitters.size());
    scene.light_nodes = std::move(tree.nodes);
}

}  // namespace flatten
