// SPDX-License-Identifier: BSD-3-Clause
// Which pixels share what their paths have found (-sampling shared): groups of 16 in squares of 16 x 16, every fourth
// pixel of every fourth row, so that a group's pixels are near one another and groups overlap.  The squares lie
// elsewhere in each frame, or their edges would show.
#ifndef LUX_SHARE_H
#define LUX_SHARE_H

#define SHARE_GROUP 16u    // pixels that share
#define SHARE_ACROSS 4u    // in a row and in a column of a group
#define SHARE_STRIDE 4u    // from one to the next
#define SHARE_SIDE 16u     // of a square
#define SHARE_SQUARE 256u  // its pixels, row by row in slots that follow one another
#define SHARE_GROUPS (SHARE_SQUARE / SHARE_GROUP)

// How many slots a sample of a picture needs: whole squares.
FN uint share_slots(uint nx, uint ny) {
    return (nx + SHARE_SIDE - 1u) / SHARE_SIDE * ((ny + SHARE_SIDE - 1u) / SHARE_SIDE) * SHARE_SQUARE;
}

// The pixel of slot gid of a pass, NONE if it lies beside the picture.
FN uint shared_pixel(UNIFORM(const Params) par, uint gid) {
    uint index = par->frame + gid / par->shared_slots, at = gid % par->shared_slots;
    uint wide = (par->nx + SHARE_SIDE - 1u) / SHARE_SIDE, high = (par->ny + SHARE_SIDE - 1u) / SHARE_SIDE;
    uint square = at / SHARE_SQUARE, inside = at % SHARE_SQUARE, shift = hash32(index ^ 0x9e3779b9u);
    uint x = (square % wide * SHARE_SIDE + inside % SHARE_SIDE + (shift & 0xffffu)) % (wide * SHARE_SIDE);
    uint y = (square / wide * SHARE_SIDE + inside / SHARE_SIDE + (shift >> 16)) % (high * SHARE_SIDE);
    return x < par->nx && y < par->ny ? y * par->nx + x : NONE;
}

// Where the film of a pass has what a slot brings: a pixel's samples lie side by side.  NONE: beside the picture.
FN uint film_place(UNIFORM(const Params) par, uint slot) {
    uint gid = par->first + slot;
    if (par->shared_slots == 0u) return slot;
    uint pixel = shared_pixel(par, gid);
    return pixel == NONE ? NONE : pixel * par->together + gid / par->shared_slots;
}

// How many places it has.
FN uint film_places(UNIFORM(const Params) par) {
    return par->shared_slots == 0u ? par->slots : par->nx * par->ny * par->together;
}

// The slots of member 0 of a square's groups, and of member m of the group of member 0.  Macros, so that paths in lanes
// know that they have them in common.
#define SHARE_FIRST(group) ((group) / SHARE_STRIDE * SHARE_SIDE + (group) % SHARE_STRIDE)
#define SHARE_MEMBER(first, m) \
    ((first) + (m) / SHARE_ACROSS * (SHARE_STRIDE * SHARE_SIDE) + (m) % SHARE_ACROSS * SHARE_STRIDE)

// The same for the group to which a slot belongs, and which member the slot is.
FN uint share_first(uint slot) {
    uint inside = slot % SHARE_SQUARE;
    return slot - inside + inside / SHARE_SIDE % SHARE_STRIDE * SHARE_SIDE + inside % SHARE_STRIDE;
}

FN uint share_member(uint slot, uint m) { return SHARE_MEMBER(share_first(slot), m); }

FN uint share_which(uint slot) {
    uint inside = slot % SHARE_SQUARE;
    return inside / SHARE_SIDE / SHARE_STRIDE * SHARE_ACROSS + inside % SHARE_SIDE / SHARE_STRIDE;
}
#endif
