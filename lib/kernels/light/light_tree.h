// SPDX-License-Identifier: BSD-3-Clause
// Light tree (after Conty Estevez and Kulla 2018; built by flatten/light_tree.cpp): its nodes are bounding balls of
// neighbouring sources.  The importance of a node at a point bounds the joint contribution of its sources; it is 0 only
// where none of them contributes.  Traversal opens the nodes that are large for their distance; the others are the cut.
// Candidates are drawn from the cut by importance, and within a node by power; one candidate is chosen by its own
// importance (resampled importance sampling, Talbot et al. 2005).
#ifndef LUX_LIGHT_TREE_H
#define LUX_LIGHT_TREE_H

#define LIGHT_OPENED 0.5f          // opens a node whose radius is more than this part of its distance
#define LIGHT_CUT 128u             // most nodes of a cut; up to this number of sources all are in it
#define LIGHT_CANDIDATES 32u       // drawn where there are more sources
#define LEAST_OF_BOTH_SIDES 0.05f  // of the cosine, where normals other than the given one apply

// Nodes that together hold every source once, except those that cannot contribute.
STRUCT(LightCut) {
    uint count, at[LIGHT_CUT];
    float upto[LIGHT_CUT];  // running sums of their importances
};

// Decides whether the next of a row of weights replaces the one kept, t being its part of the sum.  One random number r
// serves for all (reservoir sampling, Chao 1982).
FN int reservoir_accept(float t, PRIVATE(float) r) {
    int takes = *r < t;
    *r = takes ? *r / t : (*r - t) / (1.0f - t);
    return takes;
}

// Cosine c of a ball above a horizon, which subtends an angle of sine `sine`: 0 if all of it is below, c if all is
// above.
FN float above_horizon(float c, float sine) {
    if (c >= sine) return MIN_(c, 1.0f);
    if (c <= -sine) return 0.0f;
    return MIN_((c + sine) * (c + sine) / (4.0f * sine), 1.0f);
}

FN int light_is_source(GLOBAL const LightNode* node) { return node->source != NONE; }

// Vector from p to the middle of a node's ball.
FN float3 lobe_to_light(GLOBAL const LightNode* node, float3 p) {
    float3 centre = f3_of(node->centre);
    return node->far > 0.0f ? sub3(centre, p) : centre;  // else distant
}

// Importance of a node at p with normal n, up to a factor; both: also from behind.
FN float light_importance(TABLES(const SceneTables) s, GLOBAL const LightNode* node, float3 p, float3 n, int both) {
    float3 to = lobe_to_light(node, p);
    float d = MAX_(length3(to), 1e-9f), r = node->radius, far = node->far, power = node->power;
    float inv_d = 1.0f / d;
    float sine = r * inv_d;
    if (far > 0.0f) {
        if (d > far) return 0.0f;
        power /= MAX_(d * d, 0.25f * r * r);
    }

    float c = dot3(to, n) * inv_d;
    if (both) power *= MAX_(above_horizon(fabs_(c), sine), LEAST_OF_BOTH_SIDES);
    else power *= above_horizon(c, sine);

    float spread = node->spread, facing = -dot3(to, f3_of(node->axis)) * inv_d;
    if (!(power > 0.0f) || facing + sine + spread <= 0.0f) return 0.0f;

    uint end = node->aperture_at + node->aperture_count;
    for (uint k = node->aperture_at; k < end; k++)
        if (aperture_occludes(&s->apertures[k], p, to, sine, 1)) return 0.0f;
    return power * MIN_(above_horizon(facing, sine) + spread, 1.0f);
}

// Returns 1 if a node is to be replaced by its children.
FN int light_is_opened(GLOBAL const LightNode* node, float3 p, float share) {
    float3 to = lobe_to_light(node, p);
    float r = node->radius;
    return !light_is_source(node) && r * r > share * share * dot3(to, to);
}

// Opens the nodes whose radius is more than the given part of their distance.  Returns 0 if a cut cannot hold them all.
// Nodes are in depth-first order, each followed by its children, and store where the traversal goes on without them.
FN int cut_tree(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n, int both, float share,
                PRIVATE(LightCut) cut) {
    int all = par->sources_count <= LIGHT_CUT;
    float sum = 0.0f;
    cut->count = 0u;
    for (uint i = 0u; i < par->light_nodes_count;) {
        GLOBAL const LightNode* node = &s->light_nodes[i];
        int opened = all ? !light_is_source(node) : light_is_opened(node, p, share);
        float w = opened ? 0.0f : light_importance(s, node, p, n, both);
        if (sum + w > sum) {
            if (cut->count == LIGHT_CUT) return 0;
            sum += w;
            cut->upto[cut->count] = sum;
            cut->at[cut->count++] = i;
        }
        i = opened ? i + 1u : node->past;
    }
    return 1;
}

// Draws a source of node i by power.  u: a random number below *prob, the probability of the node, which becomes that
// of the source.  Returns the source's node.
FN uint source_of_light(TABLES(const SceneTables) s, uint i, float u, PRIVATE(float) prob) {
    for (;;) {
        GLOBAL const LightNode* node = &s->light_nodes[i];
        if (light_is_source(node)) return i;
        float first = *prob * node->share;
        int is_first = u < first;
        i = is_first ? i + 1u : node[1].past;
        u = is_first ? u : u - first;
        *prob = is_first ? first : *prob - first;
    }
}

// A candidate: its node, its importance, and its probability times the sum of the cut's importances.
STRUCT(LightCandidate) {
    uint at;
    float importance, prob;
};

// Candidate at y, from 0 to the sum of the cut's importances.  *k: where in the cut the search begins, and where it
// ended.
FN LightCandidate light_candidate(TABLES(const SceneTables) s, PRIVATE(const LightCut) cut, float3 p, float3 n,
                                  int both, float y, PRIVATE(uint) k) {
    while (*k + 1u < cut->count && cut->upto[*k] <= y) (*k)++;
    float below = *k > 0u ? cut->upto[*k - 1u] : 0.0f;
    LightCandidate c;
    c.importance = cut->upto[*k] - below;
    c.prob = c.importance;
    c.at = source_of_light(s, cut->at[*k], y - below, &c.prob);
    if (c.at != cut->at[*k]) c.importance = light_importance(s, &s->light_nodes[c.at], p, n, both);
    return c;
}

// Chooses a source for a surface at p with normal n, lit from both sides or one.  Returns the weight of the choice,
// whose mean is 1/probability, or 0 if no source can light it.
FN float choose_light(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n, int both, float2 x,
                      PRIVATE(uint) chosen) {
    LightCut cut;
    for (float share = LIGHT_OPENED; !cut_tree(s, par, p, n, both, share, &cut);) share *= 2.0f;
    if (cut.count == 0u) return 0.0f;

    uint candidates = par->sources_count <= LIGHT_CUT ? 1u : LIGHT_CANDIDATES, k = 0u;
    float step = cut.upto[cut.count - 1u] / (float)candidates, sum = 0.0f, kept = 0.0f, r = x.y;
    for (uint j = 0u; j < candidates; j++) {
        LightCandidate c = light_candidate(s, &cut, p, n, both, ((float)j + x.x) * step, &k);
        if (!(c.importance > 0.0f)) continue;

        float w = c.importance / c.prob;
        sum += w;
        if (!reservoir_accept(w / sum, &r)) continue;
        *chosen = s->light_nodes[c.at].source;
        kept = c.importance;
    }
    return sum > 0.0f ? sum * step / kept : 0.0f;
}
#endif
