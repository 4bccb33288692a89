#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The office at 14:00 in a browser while it is rendered.   live.sh [folder of the programs]
set -eu
tools=$(cd "${1:-build/bin}" && pwd)
cd "$(dirname "$0")/scenes/office"
PATH=$tools:$PATH
ptrace -vf view.vf -x 512 -y 512 -frames 1000 materials.rad layout.rad sky_1400.rad |
    ptaccum -every x2/16 | vcview -stay -- vcmetrics -regions ../../office.regions -metrics Ev,DGPf,DGP.px,TAL -ci 95
