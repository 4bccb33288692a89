# SPDX-License-Identifier: BSD-3-Clause
# The OpenCL program compiles for GPUs that are not here: NVIDIA's (nvptx64) and any that takes SPIR (spir64), with the
# tree of GPUs, also for a scene that has nothing special (features.h), and with that of CPUs.  Skipped where clang
# lacks OpenCL or the target.
. "${TOP:?}/tests/lib.sh"
clang=$(command -v clang || ls /usr/bin/clang-[0-9][0-9] 2> /dev/null | tail -n 1) || true
[ -n "$clang" ] || exit 77
opencl="$clang -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -Werror=implicit-function-declaration -I $TOP/lib"
printf '__kernel void k(__global float *x) { x[get_global_id(0)] = sqrt(x[0]); }\n' > one.cl
tried=0
for target in nvptx64-nvidia-cuda spir64-unknown-unknown; do
    $opencl -target $target -S -emit-llvm -o one.ll one.cl 2> /dev/null || continue
    tried=1
    for tree in -DLUX_COMPACT '-DLUX_COMPACT -DLUX_HAS=0u' ''; do
        check "the kernels compile for $target $tree" "
            $opencl -target $target $tree -O1 -S -emit-llvm -o kernels.ll $TOP/lib/kernels/program.cl
            grep -q 'define .*k_shade' kernels.ll"
    done
done
[ $tried = 1 ] || exit 77
