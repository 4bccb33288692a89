// SPDX-License-Identifier: BSD-3-Clause
// The functions every function file may use, written from their definitions (the names of RADIANCE's rayinit.cal).
// Ray variables, arithmetic, noise and arg() are built into build.cpp.
#include "cal/library.h"

namespace cal {

const char* const rayinit_text = R"CAL(
AC = arg(0);
A1 = arg(1); A2 = arg(2); A3 = arg(3); A4 = arg(4); A5 = arg(5);
A6 = arg(6); A7 = arg(7); A8 = arg(8); A9 = arg(9); A10 = arg(10);

PI : 3.14159265358979323846;
DEGREE : PI/180;
FTINY : 1e-7;

D(i) = select(i, Dx, Dy, Dz);
N(i) = select(i, Nx, Ny, Nz);
P(i) = select(i, Px, Py, Pz);
noise3a(x, y, z) : noise3x(x, y, z);
noise3b(x, y, z) : noise3y(x, y, z);
noise3c(x, y, z) : noise3z(x, y, z);
noise3d(i, x, y, z) : select(i, noise3x(x, y, z), noise3y(x, y, z), noise3z(x, y, z));

and(a, b) : if(a, b, a);
or(a, b) : if(a, a, b);
not(a) : if(a, -1, 1);
xor(a, b) : if(a, not(b), b);
abs(x) : if(x, x, -x);
sgn(x) : if(x, 1, if(-x, -1, 0));
sq(x) : x*x;
bound(a, x, b) : if(a - x, a, if(x - b, b, x));
inside(a, x, b) : and(x - a, b - x);
frac(x) : x - floor(x);
mod(n, d) : n - floor(n/d)*d;
tri(n, d) : abs(d - mod(n - d, 2*d));
linterp(t, a, b) : a + t*(b - a);

Acos(x) : acos(bound(-1, x, 1));
Asin(x) : asin(bound(-1, x, 1));
Atan2(y, x) : if(x*x + y*y, atan2(y, x), 0);
Exp(x) : if(-x - 100, 0, exp(x));
Sqrt(x) : if(x, sqrt(x), 0);

noop(v) : v;
clip(v) : bound(0, v, 1);
noneg(v) : if(v, v, 0);
red(r, g, b) : noneg(r);
green(r, g, b) : noneg(g);
blue(r, g, b) : noneg(b);
grey(r, g, b) : noneg(.265074126*r + .670114631*g + .064811243*b);
clip_r(r, g, b) : clip(r);
clip_g(r, g, b) : clip(g);
clip_b(r, g, b) : clip(b);
clipgrey(r, g, b) : min(grey(r, g, b), 1);

dot(v1, v2) : v1(1)*v2(1) + v1(2)*v2(2) + v1(3)*v2(3);
cross(i, v1, v2) : select(i, v1(2)*v2(3) - v1(3)*v2(2), v1(3)*v2(1) - v1(1)*v2(3), v1(1)*v2(2) - v1(2)*v2(1));
fade(near_val, far_val, dist) : if(16 - dist, far_val + (near_val - far_val)/(1 + dist*dist), far_val);

hermite(p0, p1, r0, r1, t) : p0*((2*t - 3)*t*t + 1) + p1*(3 - 2*t)*t*t + r0*((t - 2)*t + 1)*t + r1*(t - 1)*t*t;
bezier(p1, p2, p3, p4, t) : p1*(1 - t)^3 + 3*p2*t*(1 - t)^2 + 3*p3*t^2*(1 - t) + p4*t^3;
bspline(a, b, c, d, t) : a*(1 - t)^3/6 + b*(2/3 + t*t*(t/2 - 1)) + c*(1/6 + t*(.5 + t*(.5 - t/2))) + d*t^3/6;

turbulence(x, y, z, s) = if(s - 1.01, 0, abs(noise3(x/s, y/s, z/s)*s) + turbulence(x, y, z, 2*s));
turbulencex(x, y, z, s) = if(s - 1.01, 0,
    sgn(noise3(x/s, y/s, z/s))*noise3x(x/s, y/s, z/s) + turbulencex(x, y, z, 2*s));
turbulencey(x, y, z, s) = if(s - 1.01, 0,
    sgn(noise3(x/s, y/s, z/s))*noise3y(x/s, y/s, z/s) + turbulencey(x, y, z, 2*s));
turbulencez(x, y, z, s) = if(s - 1.01, 0,
    sgn(noise3(x/s, y/s, z/s))*noise3z(x/s, y/s, z/s) + turbulencez(x, y, z, 2*s));

tail_normal`rayinit(t) : t - (2.515517 + t*(.802853 + t*.010328))/(1 + t*(1.432788 + t*(.189269 + t*.001308)));
quantile`rayinit(p) : tail_normal`rayinit(sqrt(-2*log(p)));
unif2norm(p) : if(.5 - p, -quantile`rayinit(p), quantile`rayinit(1 - p));
nrand(x) = unif2norm(rand(x));

nxy2`rayinit = Nx*Nx + Ny*Ny;
U = if(nxy2`rayinit - FTINY, (Py*Nx - Px*Ny)/nxy2`rayinit, Px);
V = if(nxy2`rayinit - FTINY, Pz - Nz*(Px*Nx + Py*Ny)/nxy2`rayinit, Py);

{ Local coordinates of anisotropic and tabulated materials: the last three real arguments point up. }
NP(i) = select(i, NxP, NyP, NzP);
up`rayinit(i) = arg(AC - 3 + i);
side`rayinit(i) = cross(i, up`rayinit, NP);
side_len`rayinit = Sqrt(dot(side`rayinit, side`rayinit));
lv`rayinit(i) = side`rayinit(i)/side_len`rayinit;
lu`rayinit(i) = cross(i, NP, lv`rayinit);
Ldx(x, y, z) = x*lu`rayinit(1) + y*lu`rayinit(2) + z*lu`rayinit(3);
Ldy(x, y, z) = x*lv`rayinit(1) + y*lv`rayinit(2) + z*lv`rayinit(3);
Ldz(x, y, z) = x*NxP + y*NyP + z*NzP;
Idx = Ldx(-Dx, -Dy, -Dz);
Idy = Ldy(-Dx, -Dy, -Dz);
Idz = RdotP;

{ Luminaire corrections: A1 multiplier (only if there are more real arguments), A2 A3 A4 box sizes. }
corr_mul`rayinit(v) = noneg(if(AC - 1.5, v*A1, v));
quotient`rayinit(a, b) : if(b, a/b, 0);
corr_box`rayinit = abs(Dx)*A3*A4 + abs(Dy)*A2*A4 + abs(Dz)*A2*A3;
corr_gap`rayinit(p, size) = max(abs(p) - size/2, 0);
corr_out`rayinit = corr_gap`rayinit(Px - Dx*Ts, A2)*A3*A4 + corr_gap`rayinit(Py - Dy*Ts, A3)*A2*A4
                 + corr_gap`rayinit(Pz - Dz*Ts, A4)*A2*A3;
source_corr(v, mode) = select(mode + 1,
    corr_mul`rayinit(v),
    quotient`rayinit(corr_mul`rayinit(v), Rdot),
    quotient`rayinit(corr_mul`rayinit(v), corr_box`rayinit),
    quotient`rayinit(corr_mul`rayinit(v)*Ts, corr_out`rayinit),
    quotient`rayinit(corr_mul`rayinit(v), A2*A3*Sqrt(1 - Dz*Dz) + PI/4*A2*A2*abs(Dz)));
source_theta(x) = Acos(Dz)/DEGREE;
turn`rayinit(a) : if(-a, a + 360, a);
source_az`rayinit = turn`rayinit(Atan2(-Dy, -Dx)/DEGREE);
half`rayinit(a) : if(a - 180, 360 - a, a);
source_phi(sym) = if(sym - 300, source_az`rayinit, if(sym - 150, half`rayinit(source_az`rayinit),
    if(half`rayinit(source_az`rayinit) - 90, 180 - half`rayinit(source_az`rayinit), half`rayinit(source_az`rayinit))));
)CAL";

}  // namespace cal
