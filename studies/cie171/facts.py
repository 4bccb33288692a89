# SPDX-License-Identifier: BSD-3-Clause
"""The first lines of a table of figures: when they were measured, of which commit, on what machine."""

import os
import re
import subprocess
import time


def machine():
    """Processors, their model, and what else ran there."""
    model = "unknown"
    if os.path.exists("/proc/cpuinfo"):
        with open("/proc/cpuinfo") as f:
            found = re.search(r"(?m)^model name\s*: (.*)$", f.read())
            model = found.group(1).strip() if found else model
    count = len(os.sched_getaffinity(0))
    return "%d processor%s (%s), load %.0f" % (count, "" if count == 1 else "s", model, os.getloadavg()[0])


def facts(command, **more):
    git = subprocess.run(
        ["git", "log", "-1", "--format=%h", "--", "lib"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    )
    print("# date\t%s" % time.strftime("%Y-%m-%d", time.gmtime()))
    print("# commit\t%s" % (git.stdout.decode().strip() or "unknown"))
    print("# machine\t%s" % machine())
    print("# command\t%s" % command)
    for name, value in more.items():
        print("# %s\t%s" % (name, value))
