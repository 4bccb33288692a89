// SPDX-License-Identifier: BSD-3-Clause
// Groups of pixels for path reuse (-sampling reuse): 16 pixels in a square of 16 x 16, every fourth pixel of every
// fourth row, so that the members are near one another and groups interleave.  The squares move from frame to frame, or
// their edges would show.  Paths for many hours, whose suffix vertices cost more, have reuse_rounds groups together, a
// power of two: in round r the prefix vertices of group g meet the suffix vertices of group g ^ r of their square.
#ifndef LUX_PATH_REUSE_H
#define LUX_PATH_REUSE_H

#define REUSE_GROUP 16u    // pixels of a group
#define REUSE_ACROSS 4u    // in a row and in a column of a group
#define REUSE_STRIDE 4u    // pixels from one member to the next
#define REUSE_SIDE 16u     // pixels along a square
#define REUSE_SQUARE 256u  // pixels of a square, row by row in consecutive paths
#define REUSE_GROUPS (REUSE_SQUARE / REUSE_GROUP)

// Number of paths that a sample of a picture needs: whole squares.
FN uint reuse_paths(uint nx, uint ny) {
    return (nx + REUSE_SIDE - 1u) / REUSE_SIDE * ((ny + REUSE_SIDE - 1u) / REUSE_SIDE) * REUSE_SQUARE;
}

// Pixel of path gid of a pass, NONE outside the picture.
FN uint reuse_pixel(PARAMS(const Params) par, uint gid) {
    UNIFORM uint wide = (par->nx + REUSE_SIDE - 1u) / REUSE_SIDE, high = (par->ny + REUSE_SIDE - 1u) / REUSE_SIDE;
    uint sample = quotient_(gid, par->reuse_path_count);
    uint at = gid - sample * par->reuse_path_count, shift = hash32((par->frame + sample) ^ 0x9e3779b9u);
    uint square = at / REUSE_SQUARE, inside = at % REUSE_SQUARE;
    uint row = quotient_(square, wide);
    uint x = (square - row * wide) * REUSE_SIDE + inside % REUSE_SIDE + (shift & 0xffffu);
    uint y = row * REUSE_SIDE + inside / REUSE_SIDE + (shift >> 16);
    x -= quotient_(x, wide * REUSE_SIDE) * (wide * REUSE_SIDE);
    y -= quotient_(y, high * REUSE_SIDE) * (high * REUSE_SIDE);
    return x < par->nx && y < par->ny ? y * par->nx + x : NONE;
}

// Index in the film of a pass for a path: the samples of a pixel are consecutive.  NONE: outside the picture.
FN uint film_place(PARAMS(const Params) par, uint path) {
    uint gid = par->first + path;
    if (par->reuse_path_count == 0u) return path;
    uint pixel = reuse_pixel(par, gid);
    return pixel == NONE ? NONE : pixel * par->samples_per_pass + quotient_(gid, par->reuse_path_count);
}

// Number of these indices.
FN uint film_places(PARAMS(const Params) par) {
    return par->reuse_path_count == 0u ? par->path_count : par->nx * par->ny * par->samples_per_pass;
}

// Path of member 0 of a square's group, and of member m of the group of member 0.  Macros, so that ispc sees that they
// are uniform.
#define REUSE_FIRST(group) ((group) / REUSE_STRIDE * REUSE_SIDE + (group) % REUSE_STRIDE)
#define REUSE_MEMBER(first, m) \
    ((first) + (m) / REUSE_ACROSS * (REUSE_STRIDE * REUSE_SIDE) + (m) % REUSE_ACROSS * REUSE_STRIDE)

// The same member of the group that this path's group meets in this round: reuse_turn is REUSE_FIRST(round).
#define REUSE_MET(par, path) ((path) ^ (par)->reuse_turn)
// The member of the group of prefix vertices whose own ray has found the suffix vertex of member m, if it is there.
#define REUSE_FINDER(par, m) ((par)->reuse_turn == 0u ? (m) : REUSE_GROUP)

// The same for the group of a path, and the member's number.
FN uint reuse_first(uint path) {
    uint inside = path % REUSE_SQUARE;
    return path - inside + inside / REUSE_SIDE % REUSE_STRIDE * REUSE_SIDE + inside % REUSE_STRIDE;
}

FN uint reuse_member(uint path, uint m) { return REUSE_MEMBER(reuse_first(path), m); }

FN uint reuse_which(uint path) {
    uint inside = path % REUSE_SQUARE;
    return inside / REUSE_SIDE / REUSE_STRIDE * REUSE_ACROSS + inside % REUSE_SIDE / REUSE_STRIDE;
}
#endif
