# SPDX-License-Identifier: BSD-3-Clause
# OpenCL that fails (opencl_faults.cpp): ptrace goes on with the same bits, or ends with one line and status 2; frames
# that are there are whole and right.  PoCL stands for a GPU.
. "${TOP:?}/tests/lib.sh"
needs ptrace
[ -e "$OPENCL_FAULTS" ] || skip 'no library of faults'
ptrace -devices | grep -q '^opencl:0' || skip 'no OpenCL device here'
cat > room.rad << 'END'
void light l 0 0 3 90 90 70
l sphere lamp 0 0 4 0 2 1.5 .2
void brightfunc half 2 .5 .
0 0
half plastic w 0 0 5 .5 .5 .5 .02 .1
w bubble room 0 0 4 0 0 0 4
void dielectric crystal 0 0 5 .9 .9 .9 1.5 0
crystal sphere ball 0 0 4 .5 2 -.5 .6
END
frames='-vta -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180 -x 24 -y 24 -frames 3 -o f%d.hdr room.rad'
export POCL_CACHE_DIR=$TMP/cache  # with what is remembered of devices
body() { sed '1,/^-Y/d' "$1"; }  # pixels, and the moments behind frame 0
ptrace -device cpu $frames && for k in 0 1 2; do body f$k.hdr > right$k; done

# run FAULT DEVICE: files f*.hdr, said, status, and how many frames there are.
run() {
    rm -f f?.hdr
    status=0
    OPENCL_FAULT="gpu $1" LD_PRELOAD=$OPENCL_FAULTS ptrace -device "$2" $frames 2> said || status=$?
    made=$(find . -name 'f?.hdr' | wc -l)
}
right() { for k in 0 1 2; do [ ! -e f$k.hdr ] || body f$k.hdr | cmp - right$k || return 1; done; }
# Goes on: all frames, and at most one line.  Ends: one line.
well() {
    echo "# $1, $2: status $status, $made frames: $(cat said)" >> outcomes
    right || return 1
    [ $status = 0 ] && [ $made = 3 ] && [ $(wc -l < said) -le 1 ] && ! grep -v '^ptrace: warning: ' said && return 0
    [ $status = 2 ] && [ $(wc -l < said) = 1 ] && grep -q '^ptrace: opencl\|^ptrace: -device' said
}

for device in auto opencl; do
    while read -r fault; do
        check "$device: $fault" "run '$fault' $device; well '$fault' $device"
    done << 'END'
clGetPlatformIDs:0=-1001
clGetPlatformIDs:0=die
clGetDeviceIDs:0=-1
clGetDeviceIDs:1=-6
clGetDeviceInfo:1=-5
clGetDeviceInfo:12=-33
clCreateContext:0=-6
clCreateContext:0=-2
clCreateCommandQueue:0=-35
clCreateProgramWithSource:0=-6
clBuildProgram:0=-11
clBuildProgram:0=-3
clBuildProgram:1=-11
clCreateKernel:5=-46
clCreateBuffer:0=-4
clCreateBuffer:30=-61
clCreateBuffer:50!=-4
clCreateBuffer:110=-5
clSetKernelArg:0=-50
clEnqueueWriteBuffer:20=-5
clEnqueueNDRangeKernel:0=-54
clEnqueueNDRangeKernel:100!=-5
clEnqueueNDRangeKernel:500=-5
clEnqueueReadBuffer:60=-14
clEnqueueMapBuffer:0=-12
clWaitForEvents:3=-14
clFlush:5=-36
memory=32
lies=32
memory=1
read:0=nan
read:0=noise
END
done
check 'auto goes on with the processor, and says so once' "
    run clEnqueueNDRangeKernel:500=-5 auto; [ \$status = 0 ]
    grep -q '^ptrace: warning: opencl:0: .*CL_OUT_OF_RESOURCES (-5); the processor goes on in its place$' said"
check 'a device with little memory works in parts' 'run memory=32 opencl; [ $status = 0 ] && [ ! -s said ]'
check 'or in smaller ones than it said' 'run lies=32 opencl; [ $status = 0 ] && [ ! -s said ]'
check 'a device that gives other bits is told of, and has another fingerprint' '
    run read:0=bit opencl; [ $status = 0 ]
    grep -q "^ptrace: warning: opencl: .* gives other bits than the processor in .*division" said
    strings f1.hdr | grep -q "^FINGERPRINT=.* device:"'
check 'samples that are not numbers end the run' '
    run read:5=nan opencl; [ $status = 2 ]; [ $made = 0 ]
    grep -q "^ptrace: 100 % of a pass.s samples are not numbers" said'
# A spoiled GPU follows the tree of bytes (LUX_COMPACT).
frames_of_room=$frames
for scene in room.rad "$TOP/tests/golden/lamps/mist.rad"; do
    frames=${frames_of_room/room.rad/$scene}
    rm -f f?.hdr; ptrace -device cpu $frames && for k in 0 1 2; do body f$k.hdr > right$k; done
    for fill in 85 255; do
        check "nothing is read before it is written: ${scene##*/}, bytes $fill" "
            run fill=$fill opencl; [ \$status = 0 ] && [ \$made = 3 ] && [ ! -s said ] && right"
    done
done
frames=$frames_of_room
rm -f f?.hdr; ptrace -device cpu $frames && for k in 0 1 2; do body f$k.hdr > right$k; done
for place in clBuildProgram:0 clBuildProgram:1 clEnqueueReadBuffer:60 clWaitForEvents:3; do
    check "SIGTERM ends a call that does not return: $place" "
        rm -f f?.hdr; OPENCL_FAULT='gpu $place=hang' LD_PRELOAD=\$OPENCL_FAULTS ptrace -device opencl $frames & p=\$!
        sleep 6; kill -0 \$p; kill -TERM \$p; SECONDS=0; s=0; wait \$p || s=\$?
        [ \$s = 3 ] && [ \$SECONDS -le 3 ]; right"
done
cat outcomes
