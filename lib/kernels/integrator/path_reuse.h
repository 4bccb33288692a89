// SPDX-License-Identifier: BSD-3-Clause
// Which pixels share what their paths have found (-sampling shared): groups of 16 in squares of 16 x 16, every fourth
// pixel of every fourth row, so that a group's pixels are near one another and groups overlap.  The squares lie
// elsewhere in each frame, or their edges would show.
#ifndef LUX_PATH_REUSE_H
#define LUX_PATH_REUSE_H

#define REUSE_GROUP 16u    // pixels that share
#define REUSE_ACROSS 4u    // in a row and in a column of a group
#define REUSE_STRIDE 4u    // from one to the next
#define REUSE_SIDE 16u     // of a square
#define REUSE_SQUARE 256u  // its pixels, row by row in paths that follow one another
#define REUSE_GROUPS (REUSE_SQUARE / REUSE_GROUP)

// How many paths a sample of a picture needs: whole squares.
FN uint reuse_paths(uint nx, uint ny) {
    return (nx + REUSE_SIDE - 1u) / REUSE_SIDE * ((ny + REUSE_SIDE - 1u) / REUSE_SIDE) * REUSE_SQUARE;
}

// The pixel of path gid of a pass, NONE if it lies beside the picture.
FN uint reuse_pixel(PARAMS(const Params) par, uint gid) {
    uint index = par->frame + gid / par->reuse_path_count, at = gid % par->reuse_path_count;
    uint wide = (par->nx + REUSE_SIDE - 1u) / REUSE_SIDE, high = (par->ny + REUSE_SIDE - 1u) / REUSE_SIDE;
    uint square = at / REUSE_SQUARE, inside = at % REUSE_SQUARE, shift = hash32(index ^ 0x9e3779b9u);
    uint x = (square % wide * REUSE_SIDE + inside % REUSE_SIDE + (shift & 0xffffu)) % (wide * REUSE_SIDE);
    uint y = (square / wide * REUSE_SIDE + inside / REUSE_SIDE + (shift >> 16)) % (high * REUSE_SIDE);
    return x < par->nx && y < par->ny ? y * par->nx + x : NONE;
}

// Where the film of a pass has what a path brings: a pixel's samples lie side by side.  NONE: beside the picture.
FN uint film_place(PARAMS(const Params) par, uint path) {
    uint gid = par->first + path;
    if (par->reuse_path_count == 0u) return path;
    uint pixel = reuse_pixel(par, gid);
    return pixel == NONE ? NONE : pixel * par->samples_per_pass + gid / par->reuse_path_count;
}

// How many places it has.
FN uint film_places(PARAMS(const Params) par) {
    return par->reuse_path_count == 0u ? par->path_count : par->nx * par->ny * par->samples_per_pass;
}

// The paths of member 0 of a square's groups, and of member m of the group of member 0.  Macros, so that paths in lanes
// know that they have them in common.
#define REUSE_FIRST(group) ((group) / REUSE_STRIDE * REUSE_SIDE + (group) % REUSE_STRIDE)
#define REUSE_MEMBER(first, m) \
    ((first) + (m) / REUSE_ACROSS * (REUSE_STRIDE * REUSE_SIDE) + (m) % REUSE_ACROSS * REUSE_STRIDE)

// The same for the group to which a path belongs, and which member the path is.
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
