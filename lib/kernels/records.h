// SPDX-License-Identifier: BSD-3-Clause
// Records that the host writes and the kernels read, each declared here and nowhere else: a vector of FlatScene on the
// host is a table of SceneTables in the kernels, and both have the same structures.
//   Members are uint, float and Packed3 alone, so that C++, OpenCL C and ispc lay them out alike: four bytes each,
// without gaps.  Every device is asked for their sizes (RECORDS; device/layout.h).  Points are relative to the scene's
// centre (Params.centre gives it back), so that single precision stays fine far from the origin.
#ifndef LUX_RECORDS_H
#define LUX_RECORDS_H

#define NONE 0xffffffffu

// Three floats; float3 has another size in each language.
STRUCT(Packed3) { float x, y, z; };
FN float3 f3_of(Packed3 v) { return F3(v.x, v.y, v.z); }

// A primitive, as shading sees it.
STRUCT(Prim) {
    uint kind;       // PRIM_FLAT .. | flags
    uint mod;        // modifier, NONE if void
    uint source;     // active source, NONE
    Packed3 normal;  // flat: unit
    float offset;    // flat: n.p of its plane
    uint at;  // sphere, cone: in the table of shapes; PRIM_SMOOTH: index into u of the numbers of its three corners
};

// A corner of smooth triangles.
STRUCT(Corner) {
    Packed3 normal;  // 0: none
    float u, v;      // mesh coordinates Lu, Lv
};

// A surface other than a triangle (geom/shapes.h).  A bubble is a sphere, a tube a cone: the host flips their normals
// (flags of the primitive).
STRUCT(Shape) {
    uint kind;           // SHAPE_*
    Packed3 centre;      // sphere, ring; cone: where its axis begins
    Packed3 normal;      // unit, of a ring or polygon; cone: its axis
    float radius;        // sphere; cone: where its axis begins; ring: the outer one
    float other_radius;  // cone: where its axis ends; ring: the inner one
    float length;        // cone: of its axis
    float offset;        // polygon: n.p of its plane
    float margin;        // polygon: points this near to an edge are inside
    uint dropped_axis;   // polygon: polygon_uv holds the two others in order (0: y z, 1: x z, 2: x y)
    uint uv_at;          // polygon: in polygon_uv: last corner, all corners, NaN up to where eight can be read from
                         // each corner on; then the other coordinate in the same way
    uint corners;        // polygon: their number
};
#define SHAPE_SPHERE 1u
#define SHAPE_CONE 2u  // with open ends; of a cylinder both radii are the same
#define SHAPE_RING 3u
#define SHAPE_POLYGON 4u

// One geometry in several places (bvh/instance.h); Hit.inst is the number of one.  Its matrices are three rows of four.
STRUCT(Instance) {
    float to_tree[12];  // to the coordinates of its tree (instance_point)
    uint tree;          // >= 1; only tree 0 holds instances
    uint forced;        // RAY_* of all its surfaces; 0: their own
    uint clear;         // 1: its modifier is of a transparent type (PRIM_CLEAR)
    float frame[12];    // to the coordinates that functions of the modifiers see
    uint mod;           // modifier in place of all those inside, NONE = their own
    float scale;        // a world length in the coordinates of `frame`
};

// A material, pattern, texture or mixture.
STRUCT(Modifier) {
    uint type;              // M_*
    uint flags;             // MF_*
    uint next;              // modifier up the chain, NONE
    uint program;           // .cal program entry, NONE
    uint args;              // index into f of the real arguments
    uint branch1, branch2;  // mixtures: foreground, background; illum, mirror: branch1 is the alternate; antimatter:
                            // the cut face's material
    uint rs_mod, ts_mod, td_mod;  // wgmd: modifiers of its components; WGMD_INHERIT: its own
    uint lobe_program;            // .cal program of a material's lobe
    uint bsdf_at;                 // first of a BSDF's four components: front reflection, front transmission, back ..
    uint lights;                  // sets of sources that a mist names, one bit each
};
#define WGMD_INHERIT 0xfffffffeu  // the modifier "inherit"

// Reflection or transmission of a BSDF for v (toward the viewer) on one side; l is toward the light.
STRUCT(BsdfComponent) {
    uint table;        // NONE: there is none
    float lambertian;  // its Lambertian part, which the table does not hold
};

// Its table: a matrix of Klems' patches, or a tensor tree.  "at f" and "at u" are indices of the arenas.
STRUCT(BsdfTable) {
    uint kind;                  // BSDF_*
    uint swap;                  // 1: data are for light coming from v's other side: v takes the exiting role
    float min_psa;              // smallest projected solid angle of a cell
    uint v_rings_at, v_rings;   // matrix: basis of v
    uint l_rings_at, l_rings;   // and of l
    uint l_cells;               // matrix: cells of l
    uint v_grid;                // tree: cells per side of the grid of v
    uint dims;                  // tree: dimensions
    uint values;                // at f: matrix: row by row of v; tree: of each node, means above the leaves
    uint sums;                  // matrix: at f: the values' cumulative sums along a row
    uint children;              // tree: at u: child of each node, NONE: a leaf
    uint hemi;                  // at f, by cell of v: directional-hemispherical value
    uint v_psa;                 // at f, by cell of v: projected solid angle that jitters v
    uint l_psa;                 // matrix: at f, by cell of l: projected solid angle
    uint rgb;                   // matrix: at f: RGB per cell; NONE: grey
    uint u_values, u_children;  // tree: of CIE 1976 u'; u_children NONE: grey
    uint v_values, v_children;  // and of v'
};
#define BSDF_MATRIX 1u
#define BSDF_TREE4 2u
#define BSDF_TREE3 3u

// A ring of a matrix's basis.
STRUCT(BsdfRing) {
    float low, high;  // cosine of its lower bound, and of its upper one
    uint cells;
    uint first;  // its first cell
};

// An active source.
STRUCT(Source) {
    uint kind;         // SK_*
    uint prim;         // NONE: distant
    uint mod;          // modifier
    uint light_type;   // M_LIGHT, M_GLOW, M_SPOTLIGHT, M_ILLUM
    uint relay;        // in the table of relays: a virtual source; NONE: a real one
    Packed3 centre;    // or unit direction to a distant source
    Packed3 u, v;      // half vectors; of a cylinder u is half the axis
    Packed3 normal;    // unit
    float area;        // m2, or sr of a distant source
    float cap;         // of a distant one: 1 - cos of the half angle
    float power;       // luminance-like radiance, for choosing among sources
    float max_radius;  // of a glow: > 0 limits its reach; else 0
    float radius;      // of a ball around the centre that holds it
    Packed3 spot;      // unit aim of a spotlight
    float spot_cos;    // cosine of its half cone, NO_SPOT for other sources
    float spot_focus;  // its focal length
    uint fan_at;       // general polygons: their triangles in the table of fans
    uint fan_count;
    uint sheared;  // 1 = a sphere or a distant source seen through a prism: u, v, normal are its axes
    uint covered;  // 1 = another surface lies in its plane and may hide a part of it
    uint hour;     // suns of many hours: a number that decides the random ones, whatever other hours there are
};
#define SK_DISTANT 0u
#define SK_PARALLELOGRAM 1u
#define SK_POLYGON 2u
#define SK_RING 3u
#define SK_SPHERE 4u
#define SK_CYLINDER 5u
#define NO_SPOT -2.0f
#define IS_SPOT(src) ((src)->spot_cos > -1.5f)

// A triangle of a general polygon.
STRUCT(FanTriangle) {
    Packed3 corner, edge1, edge2;
    float from, upto;  // share of the source's area before this triangle, and with it
};

// The mirror or prism of a virtual source (spec shading 4.6).
STRUCT(Relay) {
    uint prim;
    uint source;  // the source behind it, real or virtual
    uint exit;    // of a prism: 0, 1
    uint aperture_at, aperture_count;
};

// A rectangle around a relay, at its apparent place from the point lit.  The rectangles of a source follow each other,
// the nearest first.
STRUCT(Aperture) {
    Packed3 centre, normal;
    Packed3 u, v;     // axes over their half lengths
    uint both_sides;  // a prism's: no back
};

// A node of the tree of many sources (light_tree.h), followed by its two subtrees.
#define LIGHT_TREE_FROM 33u  // least number of sources of a tree
STRUCT(LightNode) {
    Packed3 centre;  // of a ball about all its sources, or of the unit directions to distant ones
    float radius;
    Packed3 axis;                      // unit, about which the normals of its sources lie; 0 if some have none
    float spread;                      // how far the normals are from the axis
    float power;                       // radiance (Source.power) times area, the sum
    float far;                         // no source reaches points this far from the centre; 0: distant sources
    uint aperture_at, aperture_count;  // the same for all its sources
    uint past;                         // the node after this one's subtree
    uint source;                       // a single source; NONE: two children
    float share;                       // probability of the first child, by power
};

// Sources that the same mists name: `count` words of u.
STRUCT(LightSet) { uint at, count; };

// A distant surface (a "source" primitive); they are tried in order.
STRUCT(Distant) {
    Packed3 dir;
    float cap;    // 1 - cos of the half angle (as such: cos would round a sun); > 2 = everything
    uint seen;    // visible modifier, of an illum its alternate; NONE: the eye sees past it
    uint source;  // active source, NONE
};
#define DISTANT_BLACK 0xfffffffeu  // Distant.seen: its alternate emits nothing

// A window, patch of sun or glossy reflector in it, toward which diffuse directions are sampled (sampling/portals.h).
STRUCT(Portal) {
    Packed3 centre;
    Packed3 u, v;              // edges
    Packed3 normal;            // unit, away from the side that it lights
    Packed3 along_u, along_v;  // dot product with an offset from the centre in its plane gives the fraction of the edge
    float area;
    float gloss2;        // a glossy rectangle in the sun: its roughness, squared; else 0
    Packed3 sun;         // unit, toward the sun that it mirrors
    float mirrored_out;  // of the unit vector toward the mirrored sun, from the side that it lights: along the normal
    float mirrored_u, mirrored_per_u;  // how much of the edge u it is, and the inverse of that
    float mirrored_v, mirrored_per_v;
};
#define MOST_PORTALS 32u

// A sunlit rectangle on a glossy plane (sampling/highlights.h).
STRUCT(Highlight) {
    Packed3 corner;
    Packed3 u, v;    // perpendicular edges
    Packed3 normal;  // unit, on the sun's side
    Packed3 dir;     // unit, toward the mirrored sun, from above
    float alpha2;    // roughness, squared
};
#define MOST_HIGHLIGHTS 8u

// An image of the sun in a smooth surface: the disc of camera directions in which frame 0 holds it by area
// (render/sun_images.h).
STRUCT(SunImage) {
    Packed3 dir;  // unit
    float cap;    // 1 - cos of the half angle
};
#define MOST_IMAGES 128u

// A pixel's point of ptrace -points.
STRUCT(PointRay) {
    Packed3 org;  // of a sensor, above the surface on which it may lie
    Packed3 dir;  // unit; of a sensor, against its normal; 0: the pixel has no point
};

// A pixel with several samples in each frame: a pass makes Params.spp samples for an entry.
STRUCT(FocusEntry) {
    uint pixel;
    uint spp;            // samples of the pixel in each frame
    uint from;           // the entry's are from .. from + Params.spp - 1
    uint suns_at, suns;  // PF_ASKS: the suns that it asks are in `asked`
};

// State of the mixture's techniques (sampling/mixture.h) at a point.  Path reuse stores it whole at each prefix
// vertex (integrator/state.h), so that a new field needs no other line.
STRUCT(Mixture) {
    float light;      // through all portals
    uint highlights;  // rectangles that can be sampled, one bit each
};

// ---- tables on a device, TABLE(type, name) for each.  Params.NAME_count is the number of records in RECORD_TABLES and
// VIEW_TABLES.
// clang-format off
#define BVH_TABLES(TABLE)                                                                   \
    TABLE(float, nodes)       /* BVH of either kind, roots: ROOT_OF_SCENE ... */            \
    TABLE(float, leaves)      /* triangle blocks and shape references */
#define RECORD_TABLES(TABLE)                                                                \
    TABLE(Prim, prims)                                                                      \
    TABLE(Shape, shapes)                                                                    \
    TABLE(Corner, corners)                                                                  \
    TABLE(Instance, instances)                                                              \
    TABLE(Modifier, modifiers)                                                              \
    TABLE(BsdfComponent, bsdf_components)                                                   \
    TABLE(BsdfTable, bsdf_tables)                                                           \
    TABLE(BsdfRing, bsdf_rings)                                                             \
    TABLE(Source, sources)                                                                  \
    TABLE(FanTriangle, fans)                                                                \
    TABLE(Relay, relays)                                                                    \
    TABLE(Aperture, apertures)                                                              \
    TABLE(LightNode, light_nodes)                                                           \
    TABLE(LightSet, light_sets)                                                             \
    TABLE(Distant, distant)                                                                 \
    TABLE(Portal, portals)                                                                  \
    TABLE(Highlight, highlights)
#define FLAT_TABLES(TABLE)                                                                  \
    TABLE(float, polygon_uv)  /* projected corners (Shape.uv_at) */                         \
    RECORD_TABLES(TABLE)                                                                    \
    TABLE(uint, u)            /* word arena: .cal code, trees of BSDFs, rows of indices */           \
    TABLE(float, f)           /* float arena: arguments of modifiers, BSDFs */
#define VIEW_TABLES(TABLE)                                                                  \
    TABLE(uint, drawn)        /* of an active source: what frame 0 holds by area, DRAWN_* */ \
    TABLE(SunImage, sun_images)                                                             \
    TABLE(PointRay, points)                                                                 \
    TABLE(FocusEntry, focus)                                                                \
    TABLE(Source, suns)       /* of many hours (integrator/hours.h) */                      \
    TABLE(uint, asked)        /* of these */
#define SCENE_TABLES(TABLE) BVH_TABLES(TABLE) FLAT_TABLES(TABLE) VIEW_TABLES(TABLE)
    // clang-format on

#define TABLE_POINTER(type, name) GLOBAL const type* name;
STRUCT(SceneTables){SCENE_TABLES(TABLE_POINTER)};
#define TABLE_COUNT(type, name) uint name##_count;

// RECORD(type) for each structure whose size the host compares with a device's.
#define RECORD_OF_TABLE(type, name) RECORD(type)
#define RECORDS RECORD_TABLES(RECORD_OF_TABLE) VIEW_TABLES(RECORD_OF_TABLE) RECORD(Mixture) RECORD(Params)
#endif
