// SPDX-License-Identifier: BSD-3-Clause
// Number of threads for this process: the processors that it may use.  A job on a cluster, a container or a user of
// taskset has fewer of them than the machine, and more threads than processors slow each other down.
#pragma once
#include <string>

namespace base {

// $LUXPIPE_THREADS, or the least of: processors the process may run on (taskset), the limit of its control group
// (containers, systemd, Slurm), $SLURM_CPUS_PER_TASK.  At least 1.
unsigned processors();

// Number of processors to use from now on, as the user says (-n); 0: not said.
void use_processors(unsigned count);

// Does the machine have these instructions?
bool has_avx2();
bool has_avx512();  // F, VL, DQ and BW

// The limit of a process's control groups, of either version, rounded up; 0: none.  `groups` is the text of
// /proc/PID/cgroup, `mount` where the groups are seen.
unsigned control_group_limit(const std::string& groups, const std::string& mount);

}  // namespace base
