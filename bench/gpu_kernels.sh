#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# What each kernel takes of an NVIDIA GPU (H100, H200: sm_90), counted on a machine without one: bench/gpu_kernels.sh
# clang makes PTX of lib/kernels, NVIDIA's assembler makes code of it and says what that needs.  The assembler comes
# with CUDA, and is on the Python index: `pip download --no-deps nvidia-cuda-nvcc-cu12` is a zip file that holds
# bin/ptxas; then PTXAS=/path/to/ptxas.  CLANG=clang-22 takes another compiler.  NVIDIA's OpenCL driver has a front end
# of its own, so that these are estimates: two releases of clang differ by a tenth (docs/decisions/0031).
#   registers  of a work item; 255 at most
#   stack      bytes of it: arrays indexed at run time, what functions that were not inlined hand over
#   spills     bytes stored and loaded where registers ran out, in the functions that are called, too
#   shared     bytes of a group of 64
#   warps      that a multiprocessor holds at once for its 65536 registers, 64 at most
set -eu
bench=$(cd "$(dirname "$0")" && pwd)
left_out() { echo "gpu_kernels.sh: left out, $1"; exit 0; }
ptxas=$(command -v "${PTXAS:-ptxas}") || left_out 'no ptxas (the head of the script says where from)'
clang=$(command -v "${CLANG:-clang}") || left_out 'no clang'
out=$(mktemp -d) && trap 'rm -rf "$out"' EXIT

to_ptx() {  # architecture, features
    "$clang" -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -target nvptx64-nvidia-nvcl -Xclang -target-cpu \
        -Xclang "$1" -I "$bench/../lib" -cl-fp32-correctly-rounded-divide-sqrt -DLUX_COMPACT "-DLUX_HAS=$2" -O3 -S \
        -o "$out/kernels.ptx" "$bench/gpu_builtins.cl" 2> "$out/clang.log"
}
table() {  # what is said of it, features (lib/kernels/features.h)
    to_ptx sm_90 "$2" || to_ptx sm_80 "$2" || { head -n 5 "$out/clang.log" >&2; exit 1; }
    "$ptxas" -v -arch sm_90 -O3 -o "$out/kernels.cubin" "$out/kernels.ptx" > "$out/ptxas.log" 2>&1 ||
        { head -n 5 "$out/ptxas.log"; exit 1; }
    printf '\n%s\n' "$1"
    awk -f "$bench/gpu_kernels.awk" "$out/ptxas.log"
}

echo '__kernel void one(__global float *x) { *x = 1; }' > "$out/one.cl"
"$clang" -x cl -cl-std=CL1.2 -target nvptx64-nvidia-nvcl -S -o "$out/one.ptx" "$out/one.cl" 2> "$out/clang.log" ||
    left_out 'this clang makes no PTX of OpenCL C'
echo "# $("$clang" --version | head -n 1), ptxas $("$ptxas" --version | sed -n 's/.*, \(V[0-9.]*\).*/\1/p')"
table 'Plain surfaces and any sky: the office of make demo' 0u
table 'Patterns on surfaces, too: the classroom' 1u
table 'Everything that a scene may hold' 31u
