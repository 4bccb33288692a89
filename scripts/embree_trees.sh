#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# embree_trees.sh FOLDER: unpacks Embree's sources in FOLDER and prints cmake's options for what of it luxpipe needs: a
# static library that builds trees, without rays and kinds of geometry, for one instruction set, with its own threads
# in place of TBB's, and without the files that take longest.
set -eu
tar -xf "$1"/embree_*.orig.tar.* -C "$1"
cd "$1"/embree-*/
sed -i '1,/^  )/{/curve_intersector_virtual_\|bvh_builder_hair\|bvh_intersector1_bvh4\|embree\.rc/d}' \
    kernels/CMakeLists.txt
# Windows' compiler is taken for Microsoft's
sed -i '/^# Compiler$/,/DEFAULT_CMAKE/s/^IF (WIN32)/IF (MSVC)/' CMakeLists.txt
# two lines that print name what is not there, which clang 22 takes for an error
sed -i 's/ << a\.u\.lower << ", " << a\.u\.upper//' kernels/subdiv/bezier_curve.h
sed -i 's/ << line\.v0//' kernels/geometry/pointi.h
: > readme.pdf  # Debian took it out
echo -DEMBREE_STATIC_LIB=ON -DEMBREE_TASKING_SYSTEM=INTERNAL -DEMBREE_ISPC_SUPPORT=OFF -DEMBREE_TUTORIALS=OFF \
    -DEMBREE_RAY_PACKETS=OFF -DEMBREE_MAX_ISA=SSE2
for kind in TRIANGLE QUAD CURVE SUBDIVISION USER INSTANCE GRID POINT; do echo "-DEMBREE_GEOMETRY_$kind=OFF"; done
