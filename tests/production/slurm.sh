#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A Slurm cluster of this machine alone, on the loopback address: an array of shards of which one is killed in the
# middle and requeued, and the merge that waits for it, by the scripts in examples/farm. The picture must be that of
# a single run. Needs root, and Debian's slurmctld, slurmd, slurm-client and munge; ends with 77 where they are missing.
#   slurm.sh PROGRAM
set -euo pipefail

for needed in slurmctld slurmd sbatch munged; do
    command -v $needed > /dev/null || PATH=$PATH:/usr/sbin:/sbin
    command -v $needed > /dev/null || { echo "skipped: $needed is not installed"; exit 77; }
done
[ "$(id -u)" -eq 0 ] || { echo "skipped: a cluster of one's own needs root"; exit 77; }

program=$(realpath "$1")
farm=$(realpath "$(dirname "$0")/../../examples/farm")
folder=$(mktemp -d)
chmod 755 "$folder"
pids=()
finish() {
    for pid in "${pids[@]}"; do kill "$pid" 2> /dev/null || true; done
    wait 2> /dev/null || true
    [ -e "$folder/munged.pid" ] && kill "$(cat "$folder/munged.pid")" 2> /dev/null || true
    rm -rf "$folder"
}
trap finish EXIT
cd "$folder"
mkdir state spool munge
chmod 711 munge
head -c 128 /dev/urandom > munge/key
chmod 600 munge/key
munged --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munged.pid" \
       --log-file="$folder/munge/log" --seed-file="$folder/munge/seed"
host=$(hostname -s)
cat > slurm.conf <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MinJobAge=600
KillWait=5
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=512 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=10 State=UP
CONF
export SLURM_CONF=$folder/slurm.conf
slurmctld -D > ctld.out 2>&1 & pids+=($!)
slurmd -D > slurmd.out 2>&1 & pids+=($!)
for _ in $(seq 60); do
    sinfo -h -o %T 2> /dev/null | grep -q idle && break
    sleep 0.5
done
sinfo -h -o %T | grep -q idle || { echo "the cluster does not come up"; cat ctld.out slurmd.out slurm*.log; exit 1; }
echo "cluster: $(sinfo -h -o '%n %T %c cores')"

cat > scene.pov <<'SCENE'
#version 3.7;
camera { location <0, 2, -6> look_at <0, 0.8, 0> }
plane { y, 0 pigment { rgb 0.7 } }
sphere { <0, 1, 0>, 1 pigment { rgb <0.9, 0.5, 0.4> } }
#for (I, 0, 11)
    sphere { <2, 0.4, 0>, 0.1 rotate 30*I*y pigment { rgb 1 } finish { diffuse 0 emission 9 } }
#end
SCENE
options='+W160 +H120 --samples 200 +WT1'
# shellcheck disable=SC2086
"$program" scene.pov -V $options +Osingle.png
export CANDELABRA=$program
sent=$("$farm/submit.sh" 4 "$folder/scene.pov" "$folder/array.png" "$options")
echo "$sent"
array=$(echo "$sent" | sed -n 's/^array: //p')
# One task is killed when it has a state or runs for a moment.
for _ in $(seq 100); do
    running=$(squeue -h -t R -r -j "$array" -o %i | head -1)
    [ -n "$running" ] && break
    sleep 0.2
done
sleep 1
echo "killed in the middle and requeued: $running"
scontrol requeue "$running"
for _ in $(seq 240); do
    [ -z "$(squeue -h 2> /dev/null)" ] && break
    # A requeued task would wait two minutes.
    scontrol update "jobid=$running" StartTime=now 2> /dev/null || true
    sleep 0.5
done
squeue
scontrol show job "$array" | grep -E "ArrayTaskId|JobState|Restarts" | sed 's/^ *//' || true
cmp single.png array.png || { cat slurm-*.out; exit 1; }
echo "the picture of the array is that of the single run, byte for byte"
