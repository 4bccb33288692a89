// SPDX-License-Identifier: BSD-3-Clause
// Picture location -> ray, for the six projections (the double-precision twin is lib/view; a test compares them).
// Host fills Params.view_*: unit d, h, u; view_scale_x, _y: by type (see render/view_params.h).
#ifndef LUX_VIEW_RAY_H
#define LUX_VIEW_RAY_H

// the letters of -vt
#define VIEW_PERSPECTIVE 118u    // v
#define VIEW_PARALLEL 108u       // l
#define VIEW_CYLINDRICAL 99u     // c
#define VIEW_ANGULAR 97u         // a
#define VIEW_HEMISPHERICAL 104u  // h

// Direction in the frame of the view from its radius factor k and its axial component z.
FN float3 round_view(PARAMS(const Params) par, float a, float b, float z, float k) {
    return unit3(add3(scale3(f3_of(par->view_d), z),
                      add3(scale3(f3_of(par->view_h), a * k), scale3(f3_of(par->view_u), b * k))));
}

// Direction of point (a, b) of the view's plane, by type, unnormalised, in the length that fore and aft clipping use;
// *org moves in a parallel view.  Returns 0 outside the view.
FN int view_direction(PARAMS(const Params) par, float a, float b, PRIVATE(float3) org, PRIVATE(float3) dir) {
    float3 d = f3_of(par->view_d), h = f3_of(par->view_h), up = f3_of(par->view_u);
    float sn, cs, r2 = a * a + b * b;

    switch (par->view_type) {
    case VIEW_PERSPECTIVE: *dir = madd3(up, b, madd3(h, a, d)); return 1;
    case VIEW_PARALLEL:
        *org = madd3(up, b, madd3(h, a, *org));
        *dir = d;
        return 1;
    case VIEW_CYLINDRICAL:
        k_sincos(a, &sn, &cs);
        *dir = add3(scale3(d, cs), madd3(up, b, scale3(h, sn)));
        return 1;
    case VIEW_ANGULAR: {  // a, b in units of 180 degrees from the axis
        float r = sqrt_(r2);
        if (r > 1.0f) return 0;
        k_sincos(K_PI * r, &sn, &cs);
        *dir = round_view(par, a, b, cs, r > 1e-6f ? sn / r : K_PI);
        return 1;
    }
    case VIEW_HEMISPHERICAL: {
        float z2 = 1.0f - a * a - b * b;
        if (z2 < 0.0f) return 0;
        *dir = round_view(par, a, b, sqrt_(z2), 1.0f);
        return 1;
    }
    default: {  // planispheric
        float z = (1.0f - r2) / (1.0f + r2);
        *dir = round_view(par, a, b, z, 1.0f + z);
        return 1;
    }
    }
}

// Moves the ray's origin to a point of the lens and aims it at the same point at distance |vd|; *stretch: ratio of the
// lengths of *dir.
FN void view_lens(PARAMS(const Params) par, float3 lens, PRIVATE(float3) org, PRIVATE(float3) dir,
                  PRIVATE(float) stretch) {
    float3 d = f3_of(par->view_d), h = f3_of(par->view_h), up = f3_of(par->view_u);
    float r = 0.5f * par->lens_diameter * sqrt_(lens.x), sn, cs;
    uint type = par->view_type;
    int planar = type == VIEW_PERSPECTIVE || type == VIEW_PARALLEL;
    k_sincos(K_TURN * lens.y, &sn, &cs);
    float3 shift = add3(scale3(h, r * cs), scale3(up, r * sn));
    if (!planar) {  // RADIANCE's lens of round views is as deep as wide, its focus a sphere
        shift = madd3(d, par->lens_diameter * (0.5f - lens.z), shift);
        *dir = scale3(*dir, 1.0f / *stretch);
    }

    *org = add3(*org, shift);
    *dir = madd3(shift, -1.0f / par->focal_distance, *dir);
    if (planar) *stretch = length3(*dir);
    else *dir = scale3(*dir, *stretch / length3(*dir));
}

// X, Y in [0,1], Y up; lens: three random numbers for a point on the lens of diameter -pd (rays of one X, Y intersect
// at the distance |vd|).  Returns 0 outside the view.
FN int view_lens_ray(PARAMS(const Params) par, float X, float Y, float3 lens, PRIVATE(Ray) ray) {
    float a = (X - 0.5f + par->view_shift) * par->view_scale_x;
    float b = (Y - 0.5f + par->view_lift) * par->view_scale_y;
    float fore = par->view_fore, aft = par->view_aft;
    float3 org = f3_of(par->view_org), dir;
    if (!view_direction(par, a, b, &org, &dir)) return 0;
    float stretch = length3(dir);
    if (par->lens_diameter > 0.0f) view_lens(par, lens, &org, &dir, &stretch);

    ray->org = madd3(dir, fore, org);
    ray->dir = scale3(dir, 1.0f / stretch);
    ray->tmin = 0.0f;
    ray->tmax = aft > 0.0f ? (aft - fore) * stretch : FAR_AWAY;
    return 1;
}

// Through the centre of the lens.
FN int view_ray(PARAMS(const Params) par, float X, float Y, PRIVATE(Ray) ray) {
    return view_lens_ray(par, X, Y, F3(0.0f, 0.0f, 0.5f), ray);
}
#endif
