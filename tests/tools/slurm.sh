# SPDX-License-Identifier: BSD-3-Clause
# examples/cluster as a Slurm job array, on a cluster of this one machine that the test starts on loopback and ends:
# eight shares, one of them killed and requeued, merge to the bits of one run.
. "${TOP:?}/tests/lib.sh"
PATH=$PATH:/usr/sbin
needs ptrace ptaccum mkstream slurmctld slurmd sbatch scontrol
[ "$(id -u)" = 0 ] || skip 'Slurm must be started as root'
plugins=$(slurmctld -V > /dev/null && find /usr/lib* -name auth_none.so 2> /dev/null | head -n 1)
[ -n "$plugins" ] || skip 'this Slurm lacks auth/none'

port=$((20000 + $$ % 20000))
cat > slurm.conf << END
ClusterName=luxpipe
SlurmctldHost=localhost
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
CredType=cred/none
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmctldPidFile=$TMP/slurmctld.pid
SlurmdPidFile=$TMP/slurmd.pid
SlurmctldLogFile=$TMP/slurmctld.log
SlurmdLogFile=$TMP/slurmd.log
StateSaveLocation=$TMP/state
SlurmdSpoolDir=$TMP/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
NodeName=here NodeAddr=localhost NodeHostname=$(hostname) CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=here Default=YES MaxTime=INFINITE State=UP
END
mkdir state spool
export SLURM_CONF=$TMP/slurm.conf
stop() {
    status=$?
    for d in slurmd slurmctld; do
        pid=$(cat "$TMP/$d.pid" 2> /dev/null) && kill "$pid" && while kill -0 "$pid" 2> /dev/null; do sleep .1; done
    done
    (exit "$status")
    finish
}
trap stop EXIT
# wait_for COMMAND: until it succeeds, two minutes at most.
wait_for() {
    local end=$((SECONDS + 120))
    until eval "$1"; do [ $SECONDS -lt $end ] || return 1; sleep .3; done
}

slurmctld -c && slurmd -N here || skip 'Slurm does not start here'
wait_for 'sinfo -h -t idle -o %N | grep -q here' || skip "no idle node: $(tail -n 1 slurmctld.log)"

cp -r "$TOP/examples" .
cd examples/cluster || exit 2
export SIZE=16 FRAMES=40
bash share.sh 0 1 single

# At its first try the share of frames 15 to 19 stops in mid-stream, until it is killed.
mkdir stops
cat > stops/ptrace << END
#!/bin/bash
$BIN/ptrace "\$@"
case \$*:\${SLURM_RESTART_COUNT:-0} in *15:19*:0) touch "$TMP/stopped"; sleep 1000 ;; esac
END
chmod +x stops/ptrace

check 'eight shares, one killed and requeued, merge to the bits of one run' '
    job=$(PATH=$PWD/stops:$PATH sbatch --parsable array.sbatch)
    wait_for "test -e $TMP/stopped"; scontrol requeue ${job}_3
    wait_for "scontrol show job ${job}_3 | grep -q JobState=PENDING"; not test -e out/3.exr
    scontrol update jobid=${job}_3 StartTime=now
    wait_for "! squeue -h | grep -q ."
    scontrol show job ${job}_3 | grep -q Restarts=1
    ptaccum out/[0-7].exr -o whole.exr; [ "$(mkstream differ single/0.exr whole.exr)" = 0 ]'
