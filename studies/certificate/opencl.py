#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""opencl.py FOLDER: do other OpenCL drivers give the processor's values?  Four frames of the office, 48 x 48 pixels, by
PoCL and Mesa's rusticl of Debian 13 (debootstrap, as root), by Intel's runtime (from the package index) and by what is
installed here.  FOLDER, outside the tree, keeps the Debian and the runtime.  Writes studies/certificate/opencl.tsv; a
driver that cannot be had here keeps its row."""

import argparse
import glob
import os
import re
import subprocess
import sys
import time

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(TOP, "studies", "cie171"))
from compare import table  # noqa: E402

TABLE = os.path.join(TOP, "studies", "certificate", "opencl.tsv")
COLUMNS = ["driver", "device", "tries", "held", "said", "seconds", "date", "commit"]
OFFICE = "-vf view.vf materials.rad layout.rad sky_1400.rad"
PACKAGES = "ocl-icd-libopencl1,pocl-opencl-icd,mesa-opencl-icd"
# of the host's libraries that ptrace needs, a newer Debian has these itself
SYSTEM = re.compile(r"/(libc|libm|libstdc\+\+|libgcc_s|libOpenCL|libz)\.so")


def must(*command, **more):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **more)
    if done.returncode:
        raise OSError("%s: %s" % (command[0], done.stderr.decode(errors="replace").strip()[-300:]))
    return done.stdout


def debian_13(folder, programs):
    """A Debian 13 with its drivers, the programs, their libraries and the office in /luxpipe."""
    root = os.path.join(folder, "trixie")
    if not os.path.exists(os.path.join(root, "bin", "bash")):
        must("debootstrap", "--variant=minbase", "--include=" + PACKAGES, "trixie", root)
    inside = os.path.join(root, "luxpipe")
    must("rm", "-rf", inside)
    os.makedirs(os.path.join(inside, "lib"))
    ptrace = os.path.join(programs, "ptrace")
    found = re.findall(r"=> (/\S+)", must("ldd", ptrace).decode())
    must("cp", "-L", ptrace, *[f for f in found if not SYSTEM.search(f)], os.path.join(inside, "lib"))
    must("cp", "-r", os.path.join(TOP, "examples", "scenes", "office"), inside)
    return root


def drivers(folder, programs):
    """Name, command before a shell's line, variables; or name and why there is none."""
    yield "installed here", ["bash", "-c"], {}, ""
    try:
        root = debian_13(folder, programs)
        version = must("chroot", root, "dpkg-query", "-W", "-f", "${Version} ", "pocl-opencl-icd", "mesa-opencl-icd")
        mesa, pocl = version.decode().split()
        mounts = 'mount -t proc proc "$0/proc"; mount --rbind /sys "$0/sys"; mount --rbind /dev "$0/dev"; '
        enter = ["unshare", "-mp", "--fork", "bash", "-c", mounts + 'exec chroot "$0" bash -c "$1"', root]
        for name, icd in (("PoCL %s of Debian 13" % pocl, "pocl"), ("Mesa %s of Debian 13, rusticl" % mesa, "rusticl")):
            inside = {"LD_LIBRARY_PATH": "/luxpipe/lib", "RUSTICL_ENABLE": "llvmpipe"}
            yield name, enter, dict(inside, OCL_ICD_VENDORS="/etc/OpenCL/vendors/%s.icd" % icd), "/luxpipe"
    except OSError as error:
        print("opencl.py: Debian 13: %s" % error, file=sys.stderr)
    try:
        intel = os.path.join(folder, "intel")
        if not os.path.exists(intel):
            must(sys.executable, "-m", "venv", intel)
            must(os.path.join(intel, "bin", "pip"), "-q", "install", "intel-opencl-rt", "intel-cmplr-lib-rt")
        library = glob.glob(os.path.join(intel, "lib", "libintelocl.so"))[0]
        version = os.path.basename(glob.glob(library + ".2*")[0])[len("libintelocl.so."):]
        vendors = os.path.join(folder, "vendors")  # the package's own file names a folder that is not there
        os.makedirs(vendors, exist_ok=True)
        with open(os.path.join(vendors, "intel.icd"), "w") as f:
            f.write(library + "\n")
        own = {"OCL_ICD_VENDORS": vendors, "LD_LIBRARY_PATH": os.path.dirname(library)}
        yield "Intel's runtime " + version, ["bash", "-c"], own, ""
    except (OSError, IndexError) as error:
        print("opencl.py: Intel's runtime: %s" % error, file=sys.stderr)


def traced(command, variables, inside, programs, options):
    """What ptrace writes with these options in the office's folder, as bytes, and what it says."""
    ptrace = inside + "/lib/ptrace" if inside else os.path.join(programs, "ptrace")
    office = inside + "/office" if inside else os.path.join(TOP, "examples", "scenes", "office")
    line = "cd %s && %s %s" % (office, ptrace, options)
    done = subprocess.run([*command, line], env=dict(os.environ, **variables), stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE)
    return done.stdout, done.stderr.decode(errors="replace").strip()


def frames(device, *where):
    """Pixels of the frames, as bytes, and what was said of OpenCL."""
    out, said = traced(*where, "-device %s -moments- -x 48 -y 48 -frames 4 -seed 1 %s" % (device, OFFICE))
    pixels = b"".join(part[: 48 * 48 * 12] for part in re.split(rb"-Y 48 \+X 48\n", out)[1:])
    return pixels, "; ".join(w for w in said.replace("\t", " ").split("\n") if "opencl" in w)


def main():
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("folder")
    p.add_argument("-bin", default="build/bin")
    o = p.parse_args()
    programs, folder = os.path.abspath(o.bin), os.path.abspath(o.folder)
    os.makedirs(folder, exist_ok=True)
    here = must("git", "-C", TOP, "log", "-1", "--format=%h", "--", "lib").decode().strip()
    rows = {r["driver"]: r for r in table(TABLE)[1]} if os.path.exists(TABLE) else {}
    right, _ = frames("cpu", ["bash", "-c"], {}, "", programs)
    for name, command, variables, inside in drivers(folder, programs):
        start = time.time()
        where = command, variables, inside, programs
        pixels, said = frames("opencl", *where)
        same = sum(pixels[k : k + 4] == right[k : k + 4] for k in range(0, len(right), 4))
        device = re.search(r"(?m)^opencl:0 (.*)", traced(*where, "-devices")[0].decode())
        device = device[1] if device else "-"
        values = [name, device, len(right) // 4, same, said or "-", "%.0f" % (time.time() - start),
                  time.strftime("%Y-%m-%d", time.gmtime()), here]
        rows[name] = dict(zip(COLUMNS, map(str, values)))
        print("\t".join(rows[name].values()), flush=True)
    with open(TABLE, "w") as f:
        f.write("\t".join(COLUMNS) + "\n" + "".join("\t".join(r.values()) + "\n" for r in rows.values()))


if __name__ == "__main__":
    main()
