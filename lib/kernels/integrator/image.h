// SPDX-License-Identifier: BSD-3-Clause
// Images of the sun by smooth surfaces: in the discs of SceneTables.sun_images frame 0 holds them by
// area, from paths of MODE_IMAGE, and samples see none of them there.  The two parts divide the camera directions, so
// that any table gives the same mean.
//   A path of MODE_IMAGE takes each specular lobe of a surface with the same probability, by a number of its own (its
// way) in place of a random one: numbers at equal distances take each sequence of lobes equally often.
#ifndef LUX_PATH_IMAGE_H
#define LUX_PATH_IMAGE_H

FN void image_way_start(PARAMS(const Params) par, TABLES(const Paths) paths, uint path, float way) {
    if (par->mode == MODE_IMAGE) paths->shadow_rad[path] = shadow_rad_words(F3(way, 0.0f, 0.0f), 0.0f);
}

// The number that chooses among `count` lobes; what is left of it is the next one.
FN float image_way(TABLES(const Paths) paths, uint path, float count) {
    float way = paths->shadow_rad[path].x;
    float at = way * count;
    paths->shadow_rad[path] = shadow_rad_words(F3(at - floor_(at), 0.0f, 0.0f), 0.0f);
    return way;
}

// Returns 1 if the camera ray of this path lies in an image of the view.
FN_RARE int path_in_image(TABLES(const SceneTables) s, PARAMS(const Params) par, uint path) {
    Sampler rnd;
    Ray ray;
    if (par->mode == MODE_PILOT || !path_first_ray(s, par, path, &rnd, &ray)) return 0;
    for (UNIFORM uint i = 0u; i < par->sun_images_count; i++) {
        float3 e = sub3(ray.dir, f3_of(s->sun_images[i].dir));
        if (0.5f * dot3(e, e) <= s->sun_images[i].cap) return 1;
    }

    return 0;
}

// DRAWN_* of an active source.
FN uint drawn_by_area(TABLES(const SceneTables) s, PARAMS(const Params) par, uint source) {
    return source < par->drawn_count ? s->drawn[source] : 0u;
}

// Returns 1 if frame 0 holds by area what this specular path sees of a distant source.
FN int held_by_area(TABLES(const SceneTables) s, PARAMS(const Params) par, uint path, uint flags, uint source) {
    uint drawn = drawn_by_area(s, par, source);
    if (par->mode == MODE_RAY) return 0;
    if ((flags & PC_BENT) == 0u) return par->mode != MODE_IMAGE && (drawn & DRAWN_STRAIGHT) != 0u;
    return (drawn & DRAWN_IMAGES) != 0u && (par->mode == MODE_IMAGE || path_in_image(s, par, path));
}
#endif
