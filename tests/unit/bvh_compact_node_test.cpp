// SPDX-License-Identifier: BSD-3-Clause
// The law of a packed node: a ray that meets a child's box meets the packed one, however large, small, flat or far
// away.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "bvh/compact_node.h"
#include <doctest/doctest.h>
#include <algorithm>
#include <cmath>
#include <vector>
#include "unit/bvh_host.h"

using bvh_scenes::Random;
using namespace kernels;

namespace {

struct Node {
    std::vector<bvh::Bounds> box;
    unsigned slot[8];
    float words[COMPACT_NODE_FLOATS];
};

// Boxes of a node as large as size, some of them as flat as bvh/bounds.cpp leaves them, about a place that many sizes
// away.
Node random_node(Random& random, unsigned count, double size, double away) {
    Node node;
    double centre[3];
    for (double& c : centre) c = random.in(-away, away) * size;
    for (unsigned i = 0; i < count; i++) {
        bvh::Bounds box;
        for (int a = 0; a < 3; a++) {
            const double lo = centre[a] + random.in(-1, 1) * size;
            const double extent = random.in(0, 1) < .2 ? std::fabs(lo) * 2.4e-7 : random.in(0, 1) * size;
            box.lo[a] = float(lo);
            box.hi[a] = std::max(box.lo[a], float(lo + extent));
        }
        node.box.push_back(box);
    }
    bvh::choose_slots(node.box.data(), count, node.slot);
    const bvh::Bounds* boxes[8] = {};
    uint32_t refs[8] = {};
    for (unsigned i = 0; i < count; i++) boxes[node.slot[i]] = &node.box[i];
    uint32_t nodes = 1000, blocks = 5000;
    for (unsigned k = 0; k < 8; k++)
        if (boxes[k]) refs[k] = k % 2 == 0 ? nodes++ : REF_LEAF | (blocks += 3);
    bvh::write_compact_node(node.words, boxes, refs);
    return node;
}

// Where the ray's line is within the box, in long double: from 0 on if its direction is not parallel to a flat box.
bool meets(const bvh::Bounds& box, const Ray& ray) {
    const float org[3] = {ray.org.x, ray.org.y, ray.org.z}, dir[3] = {ray.dir.x, ray.dir.y, ray.dir.z};
    long double from = ray.tmin, to = ray.tmax;
    for (int a = 0; a < 3; a++) {
        if (dir[a] == 0) {
            if (org[a] < box.lo[a] || org[a] > box.hi[a]) return false;
            continue;
        }
        const long double t0 = ((long double)box.lo[a] - org[a]) / dir[a];
        const long double t1 = ((long double)box.hi[a] - org[a]) / dir[a];
        from = std::max(from, std::min(t0, t1));
        to = std::min(to, std::max(t0, t1));
    }
    return from <= to;
}

}  // namespace

TEST_CASE("a ray that meets a box meets the packed one, and few others") {
    Random random(53);
    long met = 0, missed = 0, inside = 0, more = 0, rays = 0, twice = 0;
    for (int n = 0; n < 4000; n++) {
        const unsigned count = 1 + unsigned(n) % 8;
        const double size = std::pow(10.0, random.in(-9, 9));
        const double away = n % 3 == 0 ? 0 : std::pow(10.0, random.in(-1, 4));
        const Node node = random_node(random, count, size, away);
        unsigned used = 0;
        for (unsigned i = 0; i < count; i++) {
            twice += used >> node.slot[i] & 1;
            used |= 1u << node.slot[i];
        }
        for (int k = 0; k < 40; k++) {
            const bvh::Bounds& aim = node.box[random.engine() % count];
            float to[3], org[3], dir[3];
            for (int a = 0; a < 3; a++) {
                // Corners and edges of the box as often as its middle.
                const double along = k % 2 ? random.in(0, 1) : double(random.engine() % 2);
                to[a] = float(aim.lo[a] + along * (double(aim.hi[a]) - aim.lo[a]));
                org[a] = to[a] + float(random.in(-1, 1) * size * std::pow(10.0, random.in(-2, 2)));
                dir[a] = to[a] - org[a];
                if (k % 5 == 0 && a == k / 5 % 3) org[a] = to[a], dir[a] = 0;
            }
            const float length = std::sqrt(dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2]);
            if (!(length > 0)) continue;
            const Ray ray = {F3(org[0], org[1], org[2]), 0, F3(dir[0] / length, dir[1] / length, dir[2] / length),
                             k % 4 == 0 ? length : 1e30f};
            WoopRay woop;
            woop_prepare(ray.org, ray.dir, &woop);
            const uint order = compact::compact_order(&woop);
            const uint got = compact::compact_node(node.words, &woop, order, ray.tmin, ray.tmax);
            const uint slots = compact::compact_in_order((got | got >> 8) & 255u, order);
            for (unsigned i = 0; i < count; i++) {
                const bool want = meets(node.box[i], ray), is = slots >> node.slot[i] & 1;
                met += want;
                missed += want && !is;
                rays++;
                inside += k % 2 && !want;
                more += k % 2 && !want && is;
            }
            if ((slots & ~used) != 0) missed += 1000000;  // an empty slot
        }
    }
    CAPTURE(met);
    CAPTURE(rays);
    CHECK(twice == 0);
    CHECK(met > rays / 10);
    CHECK(missed == 0);
    CHECK(more < inside / 20);  // boxes of bytes are wider by 1/127 of their node at most, on each side
}

TEST_CASE("the next slots of a node are its leaves, then its nodes, nearest first") {
    const bvh::Bounds left{{0, 0, 0}, {1, 1, 1}}, middle{{2, 0, 0}, {3, 1, 1}}, right{{4, 0, 0}, {5, 1, 1}};
    const bvh::Bounds boxes[3] = {right, left, middle};
    unsigned slot[8];
    bvh::choose_slots(boxes, 3, slot);
    CHECK((slot[1] & 1) == 0);  // toward -x
    CHECK((slot[0] & 1) == 1);
    const bvh::Bounds* by_slot[8] = {};
    uint32_t refs[8] = {};
    uint32_t inner[2] = {}, next = 70;
    for (unsigned i = 0; i < 3; i++) by_slot[slot[i]] = &boxes[i];
    for (unsigned k = 0; k < 8; k++)
        if (by_slot[k]) refs[k] = k == slot[2] ? REF_LEAF | 33u : next++;
    inner[0] = refs[slot[1]];
    inner[1] = refs[slot[0]];
    float words[COMPACT_NODE_FLOATS];
    bvh::write_compact_node(words, by_slot, refs);
    for (const bool forth : {true, false}) {
        WoopRay woop;
        woop_prepare(F3(forth ? -1.0f : 6.0f, 0.5f, 0.5f), F3(forth ? 1.0f : -1.0f, 0.01f, 0.01f), &woop);
        const uint order = compact::compact_order(&woop);
        uint slots = compact::compact_node(words, &woop, order, 0, 1e30f);
        CHECK(compact::compact_next(words, order, &slots) == (REF_LEAF | 33u));
        CHECK(compact::compact_next(words, order, &slots) == inner[forth ? 0 : 1]);
        CHECK(compact::compact_next(words, order, &slots) == inner[forth ? 1 : 0]);
        CHECK(slots == 0);
    }
}
