# SPDX-License-Identifier: BSD-3-Clause
# What ptxas -v says of a program's kernels, as a table (gpu_kernels.sh).  A kernel's own lines come first, up to that
# with its registers, then those of the functions that it calls.
/Function properties for/ { name = $NF }
/Function properties for k_/ { kernel = name }
/bytes stack frame/ && name == kernel { stack[kernel] = $1 }
/bytes stack frame/ { stores[kernel] += $5; loads[kernel] += $9 }
/Used [0-9]+ registers/ {
    order[++kernels] = kernel
    for (i = 2; i <= NF; i++) {
        if ($i ~ /^registers/) registers[kernel] = $(i - 1)
        if ($i == "bytes" && $(i + 1) ~ /^smem/) shared[kernel] = $(i - 1)
    }
}
END {
    print "kernel         registers  stack     spills shared  warps"
    for (i = 1; i <= kernels; i++) {
        k = order[i]
        of_warp = int((registers[k] + 7) / 8) * 8 * 32  # registers are given out by 256
        warps = 4 * int(16384 / of_warp)                # a multiprocessor has four parts
        printf "%-14s %9d %6d %10s %6d %6d\n", k, registers[k], stack[k], stores[k] "/" loads[k], shared[k],
            (warps > 64 ? 64 : warps)
    }
}
