// SPDX-License-Identifier: BSD-3-Clause
// Active sources: a point on one, its radiance; and what lies behind everything (sun, sky).
// Active sources reach surfaces by this file alone, all other emitters by sampled rays alone (spec shading 0.1).
#ifndef LUX_SOURCES_H
#define LUX_SOURCES_H

FN float3 f3_at(GLOBAL const float* f) { return F3(f[0], f[1], f[2]); }
FN GLOBAL const float* source_record(PRIVATE const SceneTables* s, PRIVATE const Params* par, uint i) {
    return s->f + par->sources_at + SOURCE_FLOATS * i;
}

typedef struct {
    float3 dir;     // from the point to the source, unit
    float dist;     // 1e30 for distant ones
    float w;        // solid angle this sample stands for
    float pieces;   // with -ds: how many pieces of a source it stands for; lobes are widened by one of them
    float3 point;   // on the source (local ones)
    float3 normal;  // there
    uint index;
} LightSample;

// RADIANCE's partition of a large source (-ds; spec shading 4.3): the piece that holds this sample, found by halving
// the source while it is large for its distance, each half with equal chance.  *c is moved to the piece's centre, *u
// and *v become its half vectors; the result is the piece's share of the source.  Only -dj < 1 can tell it from the
// whole.
FN float source_piece(float3 p, float ds, int line, PRIVATE float3* c, PRIVATE float3* u, PRIVATE float3* v,
                      PRIVATE float2* x) {
    float share = 1.0f, k = 2.0f / ds, du = k * length3(*u), dv = line ? 0.0f : k * length3(*v);
    for (int i = 0; i < 6; i++) {  // at most 64 pieces
        float d = length3(sub3(p, *c)), sign;
        if (d >= du && d >= dv) break;
        if (du >= dv) {
            sign = x->x < 0.5f ? -0.5f : 0.5f;
            x->x = x->x < 0.5f ? 2.0f * x->x : 2.0f * x->x - 1.0f;
            *c = madd3(*u, sign, *c);
            *u = scale3(*u, 0.5f);
            du *= 0.5f;
        } else {
            sign = x->y < 0.5f ? -0.5f : 0.5f;
            x->y = x->y < 0.5f ? 2.0f * x->y : 2.0f * x->y - 1.0f;
            *c = madd3(*v, sign, *c);
            *v = scale3(*v, 0.5f);
            dv *= 0.5f;
        }
        share *= 0.5f;
    }
    return share;
}

// What a glow's reach and a spotlight's cone leave of a sample of the source with centre c.
FN void source_limits(GLOBAL const float* q, uint kind, float3 c, float3 p, PRIVATE LightSample* l) {
    if (q[SRC_MAXRAD] > 0.0f && l->dist > q[SRC_MAXRAD]) l->w = 0.0f;
    if (q[SRC_SPOT + 3] > -1.5f) {  // inside the cone, and as if its light came from f behind (spec 4.2)
        float f = q[SRC_SPOT + 4],
              d = kind == SK_SPHERE ? length3(sub3(c, p)) : l->dist;  // a sphere counts from its centre
        if (-dot3(f3_at(q + SRC_SPOT), l->dir) < q[SRC_SPOT + 3]) l->w = 0.0f;
        l->w *= d * d / ((d + f) * (d + f));
    }
}

// A sphere or a sun through a prism: its axes are sheared as the prism shears its place, and what is sampled decides
// how much of it the bent rays hit.  So these are RADIANCE's samples (spec shading 4.3): points of a ball; a square
// made a disc.
FN void sample_sheared(GLOBAL const float* q, int distant, float3 c, float3 p, float2 x, float dj,
                       PRIVATE LightSample* l) {
    float third = 4096.0f * x.x;  // what is left of the first number
    float3 k = F3(2.0f * x.x - 1.0f, 2.0f * x.y - 1.0f, 2.0f * (third - floor_(third)) - 1.0f);
    if (dj > 0.7f && distant) {
        k = F3(1.1284f * k.x * sqrt_(1.0f - 0.5f * k.y * k.y), 1.1284f * k.y * sqrt_(1.0f - 0.5f * k.x * k.x), 0.0f);
    } else if (dj > 0.7f) {
        float most = MAX_(fabs_(k.x), MAX_(fabs_(k.y), fabs_(k.z)));
        k = scale3(k, most / (MAX_(length3(k), 1e-6f) * 0.7236f));
    }
    k = scale3(k, dj);
    float3 at = madd3(f3_at(q + SRC_U), k.x, madd3(f3_at(q + SRC_V), k.y, c));
    if (distant) {
        l->dir = unit3(at);
        return;
    }
    float3 to = sub3(madd3(f3_at(q + SRC_NORMAL), k.z, at), p);
    l->dist = length3(to);
    l->dir = scale3(to, 1.0f / MAX_(l->dist, 1e-9f));
    l->w = 3.14159265f * q[SRC_RADIUS] * q[SRC_RADIUS] / MAX_(l->dist * l->dist, 1e-18f);
    l->point = madd3(l->dir, l->dist, p);
    l->normal = neg3(l->dir);
}

// A point of source i as seen from p; w = 0 if it cannot shine there.  x: two random numbers; dj: jitter 0..1.
FN void sample_source(PRIVATE const SceneTables* s, PRIVATE const Params* par, uint i, float3 p, float2 x, float dj,
                      PRIVATE LightSample* l) {
    GLOBAL const float* q = source_record(s, par, i);
    uint kind = as_uint_(q[SRC_KIND]);
    float3 c = f3_at(q + SRC_CENTRE);
    l->index = i;
    l->w = 0.0f;
    l->pieces = 1.0f;
    float ju = dj * (2.0f * x.x - 1.0f), jv = dj * (2.0f * x.y - 1.0f);
    if (kind == SK_DISTANT) {
        l->dir = c;
        if (dj > 0.0f && q[SRC_SHEARED] != 0.0f) {
            sample_sheared(q, 1, c, p, x, dj, l);
        } else if (dj > 0.0f) {  // uniform over the cap, pulled to its centre by dj
            float3 t, b;
            float sn, cs, z1 = x.x * dj * dj * q[SRC_CAP], r = sqrt_(z1 * (2.0f - z1));
            frame_of(c, &t, &b);
            k_sincos(6.28318531f * x.y, &sn, &cs);
            l->dir = unit3(add3(scale3(c, 1.0f - z1), add3(scale3(t, r * cs), scale3(b, r * sn))));
        }
        l->dist = 1e30f;
        l->w = q[SRC_AREA];
        l->point = p;  // patterns on a sun see where the ray starts
        l->normal = neg3(l->dir);
        return;
    }
    float area = q[SRC_AREA], cosine;
    float3 at, n = f3_at(q + SRC_NORMAL);
    if (kind == SK_SPHERE) {
        float r = q[SRC_RADIUS];
        float3 to = sub3(c, p);
        float d2 = dot3(to, to);
        if (d2 <= r * r) return;
        float d = sqrt_(d2);
        to = scale3(to, 1.0f / d);
        if (dj <= 0.0f) {  // the reference's centre sample (spec shading 4.2)
            l->dir = to;
            l->dist = q[SRC_MAXRAD] > 0.0f && d > q[SRC_MAXRAD] ? 1e20f : d - r;
            l->w = 3.14159265f * r * r / d2;
            l->point = madd3(to, -r, c);
            l->normal = neg3(to);
        } else if (q[SRC_SHEARED] != 0.0f) {
            sample_sheared(q, 0, c, p, x, dj, l);
        } else {  // exact: uniform over the cone it subtends
            float s2 = r * r / d2, cmax1 = s2 / (1.0f + sqrt_(1.0f - s2)), sn, cs;  // 1 - cos of the half angle
            float3 t, b;
            float z1 = x.x * cmax1, z = 1.0f - z1, rr = sqrt_(z1 * (2.0f - z1));
            frame_of(to, &t, &b);
            k_sincos(6.28318531f * x.y, &sn, &cs);
            l->dir = unit3(add3(scale3(to, z), add3(scale3(t, rr * cs), scale3(b, rr * sn))));
            float e = r * r - d2 * rr * rr;
            l->dist = d * z - sqrt_(e > 0.0f ? e : 0.0f);
            l->w = 6.28318531f * cmax1;
            l->point = madd3(l->dir, l->dist, p);
            l->normal = unit3(sub3(l->point, c));
        }
    } else {
        if (kind == SK_PARALLELOGRAM || (par->ds > 0.0f && (kind == SK_POLYGON || kind == SK_RING))) {
            // with -ds RADIANCE's own pieces and its idea of the shape; the shadow ray must then hit the source
            float3 u = f3_at(q + SRC_U), v = f3_at(q + SRC_V), c0 = c;
            if (kind == SK_RING) {  // square of equal area
                u = scale3(u, 0.886226925f);
                v = scale3(v, 0.886226925f);
            }
            float3 pu = u, pv = v;
            if (par->ds > 0.0f) {
                l->pieces = 1.0f / source_piece(p, par->ds, 0, &c, &pu, &pv, &x);
                ju = dj * (2.0f * x.x - 1.0f);
                jv = dj * (2.0f * x.y - 1.0f);
            }
            at = madd3(pu, ju, madd3(pv, jv, c));
            if (kind == SK_RING && par->ds > 0.0f) {  // square to disc (spec shading 4.3)
                float3 o = sub3(at, c0);
                float a = dot3(o, u) / dot3(u, u), b = dot3(o, v) / dot3(v, v);
                float a1 = 1.1284f * a * sqrt_(1.0f - 0.5f * b * b), b1 = 1.1284f * b * sqrt_(1.0f - 0.5f * a * a);
                at = madd3(u, a1, madd3(v, b1, c0));
            }
        } else if (kind == SK_RING) {
            float r = dj * sqrt_(x.x), sn, cs;
            k_sincos(6.28318531f * x.y, &sn, &cs);
            at = madd3(f3_at(q + SRC_U), r * cs, madd3(f3_at(q + SRC_V), r * sn, c));
        } else if (kind == SK_CYLINDER) {  // U = half axis, V radius in SRC_RADIUS
            float3 axis = f3_at(q + SRC_U), t, b;
            float r = q[SRC_RADIUS], sn, cs;
            if (dj <= 0.0f || par->ds > 0.0f) {
                float share = 1.0f;
                float3 none = axis;
                if (par->ds > 0.0f) {
                    float3 across = cross3(sub3(p, c), axis);
                    if (length3(across) > 2.0f * r * length3(axis))
                        share = source_piece(p, par->ds, 1, &c, &axis, &none, &x);
                    c = madd3(axis, dj * (2.0f * x.x - 1.0f), c);
                }
                float3 to = sub3(c, p);
                l->pieces = 1.0f / share;
                float d2 = dot3(to, to), h = length3(axis);
                float ca = dot3(to, axis) / (h * sqrt_(d2));
                l->dist = sqrt_(d2);
                l->dir = scale3(to, 1.0f / l->dist);
                float sa = 1.0f - ca * ca;
                l->w = 4.0f * r * (h / share) * sqrt_(sa > 0.0f ? sa : 0.0f) / d2;
                l->point = c;
                l->normal = neg3(l->dir);
                source_limits(q, kind, c, p, l);
                return;
            }
            frame_of(unit3(axis), &t, &b);
            k_sincos(6.28318531f * x.y, &sn, &cs);
            n = add3(scale3(t, cs), scale3(b, sn));
            at = madd3(n, r, madd3(axis, 2.0f * x.x - 1.0f, c));
        } else {  // triangle fan: pick a triangle by area
            uint at_f = as_uint_(q[SRC_TRIS]), count = as_uint_(q[SRC_NTRIS]), k = 0u;
            GLOBAL const float* tri = s->f + at_f;
            if (dj <= 0.0f) {
                at = c;
            } else {
                while (k + 1u < count && x.x >= tri[9]) {
                    k++;
                    tri += 12;
                }
                float lo = tri[10], u = (x.x - lo) / (tri[9] - lo), su = sqrt_(u);
                at = madd3(f3_at(tri + 3), su * (1.0f - x.y), madd3(f3_at(tri + 6), su * x.y, f3_at(tri)));
            }
        }
        float3 to = sub3(at, p);
        float d2 = dot3(to, to);
        if (d2 <= 0.0f) return;
        l->dist = sqrt_(d2);
        l->dir = scale3(to, 1.0f / l->dist);
        cosine = -dot3(n, l->dir);
        if (cosine <= 1e-4f) return;
        l->w = area * cosine / d2;
        l->point = at;
        l->normal = n;
    }
    source_limits(q, kind, c, p, l);
}

// Radiance of light material `mod` seen along dir (from the viewer to the light), patterns included.
FN float3 light_radiance(PRIVATE const SceneTables* s, PRIVATE const Params* par, uint mod, uint prim, float3 dir,
                         float3 point, float3 normal, float length, float total, PRIVATE Sampler* rnd) {
    Surface g;
    GLOBAL const uint* m = mod_record(s, par, mod);
    g.p = point;
    g.nface = normal;
    g.ng = normal;
    g.n = normal;
    g.v = neg3(dir);
    g.color = F3(1.0f, 1.0f, 1.0f);
    g.pert = F3(0.0f, 0.0f, 0.0f);
    g.u = 0.0f;
    g.vv = 0.0f;
    g.length = length;
    g.total = total;
    g.prim = prim;
    g.mod = mod;
    g.type = 0u;
    g.inst = NONE;
    g.front = 1;
    g.flat = 0;
    g.smooth = 0;
    g.mixed = 0;
    if (m[MOD_TYPE] < M_FIRST_MATERIAL || m[MOD_NEXT] != NONE) {
        if (!find_material(s, par, &g, rnd)) return F3(0.0f, 0.0f, 0.0f);
        m = mod_record(s, par, g.mod);
    }
    return mul3(g.color, f3_at(s->f + m[MOD_ARGS]));
}

// Radiance of the source of record src at its sampled point.  before: path length from the eye to the point lit.  A
// virtual source's is known only where its shadow ray arrives: 1 until then.
FN float3 sampled_radiance(PRIVATE const SceneTables* s, PRIVATE const Params* par, GLOBAL const float* src,
                           PRIVATE const LightSample* light, float before, PRIVATE Sampler* rnd) {
    if (as_uint_(src[SRC_VIRTUAL]) != NONE) return F3(1.0f, 1.0f, 1.0f);
    return light_radiance(s, par, as_uint_(src[SRC_MOD]), as_uint_(src[SRC_PRIM]), light->dir, light->point,
                          light->normal, light->dist, before + light->dist, rnd);
}

// The distant surface seen in direction dir: the first non-glow that matches, else the first glow.  NONE if none.
// sampled: by a ray that illums stop (emission.h).
FN uint distant_at(PRIVATE const SceneTables* s, PRIVATE const Params* par, float3 dir, int sampled) {
    uint glow = NONE;
    for (uint i = 0u; i < par->distant_count; i++) {
        GLOBAL const uint* q = s->u + par->distant_at + DISTANT_WORDS * i;
        float cap = as_float_(q[DISTANT_CAP]);
        float3 d = F3(as_float_(q[0]), as_float_(q[1]), as_float_(q[2]));
        // 1 - cos by the chord: single precision would lose a sun of half a degree in 1 - dot
        float3 e = sub3(dir, d);
        if (0.5f * dot3(e, e) > cap || (q[DISTANT_SEEN] == NONE && !sampled)) continue;
        if (q[DISTANT_SOURCE] != NONE) return i;
        if (glow == NONE) glow = i;
    }
    return glow;
}
#endif
