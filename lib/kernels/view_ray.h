// SPDX-License-Identifier: BSD-3-Clause
// Picture location -> ray, for the six projections (the double-precision twin is lib/view; a test compares them).
// Host fills Params.view_*: unit d, h, u; view_size.x/.y = the scale factors of each type (see trace/view_params.cpp).
#ifndef LUX_VIEW_RAY_H
#define LUX_VIEW_RAY_H

// X, Y in [0,1], Y up; lens: three random numbers, the place on the lens of diameter -pd (rays of one X, Y meet again
// at the distance |vd|).  0 if no ray belongs there.
FN int view_lens_ray(PRIVATE const Params* par, float X, float Y, float3 lens, PRIVATE Ray* ray) {
    float3 d = F3(par->view_d.x, par->view_d.y, par->view_d.z);
    float3 h = F3(par->view_h.x, par->view_h.y, par->view_h.z);
    float3 up = F3(par->view_u.x, par->view_u.y, par->view_u.z);
    float3 org = F3(par->view_org.x, par->view_org.y, par->view_org.z);
    float a = (X - 0.5f + par->view_size.z) * par->view_size.x;
    float b = (Y - 0.5f + par->view_size.w) * par->view_size.y;
    float fore = par->view_clip.x, aft = par->view_clip.y;
    float far_ = 1e30f, stretch = 1.0f;
    float3 dir = d;
    int type = (int)par->view_d.w;
    if (type == 'v') {
        dir = madd3(up, b, madd3(h, a, d));
    } else if (type == 'l') {
        org = madd3(up, b, madd3(h, a, org));
    } else if (type == 'c') {
        float s, c;
        k_sincos(a, &s, &c);
        dir = add3(scale3(d, c), madd3(up, b, scale3(h, s)));
    } else {
        float z, k;
        if (type == 'a') {  // a, b in units of 180 degrees from the axis
            float q = sqrt_(a * a + b * b), s, c;
            if (q > 1.0f) return 0;
            k_sincos(3.14159265f * q, &s, &c);
            z = c;
            k = q > 1e-6f ? s / q : 3.14159265f;
        } else if (type == 'h') {
            float zz = 1.0f - a * a - b * b;
            if (zz < 0.0f) return 0;
            z = sqrt_(zz);
            k = 1.0f;
        } else {  // planispheric
            float q = a * a + b * b;
            z = (1.0f - q) / (1.0f + q);
            k = 1.0f + z;
        }
        dir = unit3(add3(scale3(d, z), add3(scale3(h, a * k), scale3(up, b * k))));
    }
    stretch = length3(dir);
    if (par->view_clip.w > 0.0f) {
        float r = 0.5f * par->view_clip.w * sqrt_(lens.x), s, c;
        int planar = type == 'v' || type == 'l';
        float3 shift;
        k_sincos(6.28318531f * lens.y, &s, &c);
        shift = add3(scale3(h, r * c), scale3(up, r * s));
        if (!planar) {  // the reference's lens of the round views is as deep as wide, its focus a sphere
            shift = madd3(d, par->view_clip.w * (0.5f - lens.z), shift);
            dir = scale3(dir, 1.0f / stretch);
        }
        org = add3(org, shift);
        dir = madd3(shift, -1.0f / par->view_h.w, dir);
        if (planar) stretch = length3(dir);
        else dir = scale3(dir, stretch / length3(dir));
    }
    org = madd3(dir, fore, org);
    dir = scale3(dir, 1.0f / stretch);
    if (aft > 0.0f) far_ = (aft - fore) * stretch;
    ray->org = org;
    ray->dir = dir;
    ray->tmin = 0.0f;
    ray->tmax = far_;
    return 1;
}

// Through the middle of the lens.
FN int view_ray(PRIVATE const Params* par, float X, float Y, PRIVATE Ray* ray) {
    return view_lens_ray(par, X, Y, F3(0.0f, 0.0f, 0.5f), ray);
}
#endif
