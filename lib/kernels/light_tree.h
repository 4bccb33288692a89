// SPDX-License-Identifier: BSD-3-Clause
// Many active sources stand in a tree (flatten/light_tree.cpp): its nodes are balls about sources that are near each
// other.  What a node promises at a point is what its sources together could give there; 0 only where none of them can
// give anything.  A walk opens the nodes that are large for their distance, one of those that it meets then is chosen
// by their promises, and from there a source by the promises of halves (after Conty Estevez and Kulla 2018).
#ifndef LUX_LIGHT_TREE_H
#define LUX_LIGHT_TREE_H

#define LIGHT_OPENED 0.25f         // a node whose radius is more than this share of its distance is opened
#define GATES_LOOKED_AT 256u       // of no more sources than so many each is opened that gates let through in part
#define LEAST_OF_BOTH_SIDES 0.05f  // of the cosine, where other normals than the one given may count

// What a horizon leaves of a ball's cosine c, which subtends an angle of sine `reach`: nothing below, all of it above.
FN float above_horizon(float c, float reach) {
    if (c >= reach) return MIN_(c, 1.0f);
    if (c <= -reach) return 0.0f;
    return MIN_((c + reach) * (c + reach) / (4.0f * reach), 1.0f);
}

// From p to the middle of a node's ball.
FN float3 way_to_light(GLOBAL const float* node, float3 p) {
    float3 centre = f3_at(node + LIGHT_CENTRE);
    return node[LIGHT_FAR] > 0.0f ? sub3(centre, p) : centre;  // else distant
}

// What the gates that all sources of a node have in common let through of them: one of GATE_*.
FN int light_gates(PRIVATE const SceneTables* s, GLOBAL const float* node, float3 p) {
    uint gates = as_uint_(node[LIGHT_GATES]);
    if (gates == 0u) return GATE_OPEN;
    float3 to = way_to_light(node, p);
    float reach = node[LIGHT_RADIUS] / MAX_(length3(to), 1e-9f);
    GLOBAL const float* gate = s->f + as_uint_(node[LIGHT_GATES_AT]);
    int open = GATE_OPEN;
    for (uint k = 0u; k < gates && open != GATE_SHUT; k++, gate += GATE_FLOATS) {
        int passes = gate_passes(gate, p, to, reach, 1);
        open = MIN_(open, passes);
    }
    return open;
}

// Is a node to be replaced by its halves?  gates: what they let through.
FN int light_is_opened(UNIFORM const Params* par, GLOBAL const float* node, float3 p, int gates) {
    if (gates == GATE_SHUT || as_uint_(node[LIGHT_SOURCE]) != NONE) return 0;
    if (node[LIGHT_MORE_GATES] != 0.0f || (gates == GATE_AJAR && par->source_count <= GATES_LOOKED_AT)) return 1;
    float3 to = way_to_light(node, p);
    float least = node[LIGHT_RADIUS] * (1.0f / LIGHT_OPENED);
    return least * least > dot3(to, to);
}

// What the sources of a node could give a surface at p with normal n, up to a factor; both: from behind, too.
FN float light_promise(GLOBAL const float* node, float3 p, float3 n, int both, int gates) {
    if (gates == GATE_SHUT) return 0.0f;
    float3 to = way_to_light(node, p);
    float d = MAX_(length3(to), 1e-9f), r = node[LIGHT_RADIUS], far = node[LIGHT_FAR], power = node[LIGHT_POWER];
    float inv_d = 1.0f / d, reach = r * inv_d;
    if (far > 0.0f) {
        if (d > far) return 0.0f;
        power /= MAX_(d * d, 0.25f * r * r);
    }

    float c = dot3(to, n) * inv_d;
    if (both) power *= MAX_(above_horizon(fabs_(c), reach), LEAST_OF_BOTH_SIDES);
    else power *= above_horizon(c, reach);

    float spread = node[LIGHT_SPREAD], facing = -dot3(to, f3_at(node + LIGHT_AXIS)) * inv_d;
    if (!(power > 0.0f) || facing + reach + spread <= 0.0f) return 0.0f;
    return power * MIN_(above_horizon(facing, reach) + spread, 1.0f);
}

FN GLOBAL const float* light_node(PRIVATE const SceneTables* s, UNIFORM const Params* par, uint i) {
    return s->f + par->light_tree_at + LIGHT_FLOATS * i;
}

// The node whose sources one is chosen from, and 1/chance of it, or 0 if no source can shine.  Nodes stand in the order
// of a walk that opens all of them, each followed by its halves, and know where the walk goes on without that.
FN float choose_light_node(PRIVATE const SceneTables* s, UNIFORM const Params* par, float3 p, float3 n, int both,
                           float r, PRIVATE uint* chosen) {
    float sum = 0.0f, kept = 0.0f;
    for (uint i = 0u; i < par->light_nodes;) {
        GLOBAL const float* node = light_node(s, par, i);
        int gates = light_gates(s, node, p);
        if (light_is_opened(par, node, p, gates)) {
            i++;
            continue;
        }

        float w = light_promise(node, p, n, both, gates);
        if (w > 0.0f) {
            sum += w;
            float t = w / sum;  // one random number, reused (Chao's reservoir)
            if (r < t) {
                *chosen = i;
                kept = w;
                r = r / t;
            } else {
                r = (r - t) / (1.0f - t);
            }
        }
        i = as_uint_(node[LIGHT_PAST]);
    }

    return sum > 0.0f ? sum / kept : 0.0f;
}

// Chooses a source for a surface at p with normal n, lit from both sides or not.  Returns 1/chance, or 0 if none can
// shine.
FN float choose_light(PRIVATE const SceneTables* s, UNIFORM const Params* par, float3 p, float3 n, int both, float2 x,
                      PRIVATE uint* chosen) {
    uint at = 0u;
    float inv_p = choose_light_node(s, par, p, n, both, x.x, &at), r = x.y;
    if (!(inv_p > 0.0f)) return 0.0f;

    for (;;) {
        GLOBAL const float* node = light_node(s, par, at);
        *chosen = as_uint_(node[LIGHT_SOURCE]);
        if (*chosen != NONE) return inv_p;

        GLOBAL const float* half1 = node + LIGHT_FLOATS;
        uint second = as_uint_(half1[LIGHT_PAST]);
        GLOBAL const float* half2 = light_node(s, par, second);
        float w1 = light_promise(half1, p, n, both, light_gates(s, half1, p));
        float w2 = light_promise(half2, p, n, both, light_gates(s, half2, p));
        if (!(w1 + w2 > 0.0f)) return 0.0f;

        float t = w1 / (w1 + w2);
        int is_first = r < t || !(w2 > 0.0f);
        at = is_first ? at + 1u : second;
        r = is_first ? r / t : (r - t) / (1.0f - t);
        inv_p /= is_first ? t : 1.0f - t;
    }
}
#endif
