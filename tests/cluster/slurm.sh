#!/usr/bin/env bash
# Runs a batch as an array of eight jobs of a Slurm on this machine, and compares its table with that of a single run.
#
#   apt-get install slurm-wlm munge
#   tests/cluster/slurm.sh [HYSTERON]
#
# Needs root for munge and the daemons of Slurm, which it starts with a configuration of its own and stops in the end.
set -euo pipefail
cd "$(dirname "$0")/../.."
engine=$(realpath "${1:-target/release/hysteron}")
place=$(mktemp -d /tmp/hysteron-slurm-XXXXXX)
export PATH="$place:$PATH" SLURM_CONF="$place/slurm.conf"
ln -s "$engine" "$place/hysteron"
host=$(hostname -s)

finish() {
    scancel --quiet --user "$(id -un)" 2>/dev/null || true
    for daemon in slurmd slurmctld; do
        [ -f "$place/$daemon.pid" ] && kill "$(cat "$place/$daemon.pid")" 2>/dev/null
    done
    rm -rf "$place"
}
trap finish EXIT

pgrep -x munged > /dev/null || { mkdir -p /run/munge && chown munge: /run/munge && runuser -u munge -- munged; }
mkdir -p "$place/state" "$place/spool"
cat > "$SLURM_CONF" <<CONF
ClusterName=one
SlurmctldHost=$host
AuthType=auth/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$place/state
SlurmdSpoolDir=$place/spool
SlurmctldPidFile=$place/slurmctld.pid
SlurmdPidFile=$place/slurmd.pid
SlurmctldLogFile=$place/slurmctld.log
SlurmdLogFile=$place/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MpiDefault=none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
NodeName=$host CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
slurmctld
slurmd
for _ in $(seq 60); do
    sinfo --noheader --format=%t 2>/dev/null | grep -qE '^(idle|mix)' && break
    sleep 0.5
done
sinfo

plan=$PWD/tcl-like-inputs/batch_study/plan.toml
hysteron batch "$plan" --out "$place/single"
hysteron batch "$plan" --out "$place/array" --emit slurm --jobs 8
sbatch --wait --chdir="$place" --output="$place/job-%a.log" "$place/array/batch.slurm"
hysteron batch "$plan" --out "$place/array" --merge
cmp "$place/single/results.csv" "$place/array/results.csv"
diff -r "$place/single/cases" "$place/array/cases"

# A task of srun takes its part from its rank.
srun --chdir="$place" --ntasks="$(nproc)" hysteron batch "$plan" --out "$place/ranks"
hysteron batch "$plan" --out "$place/ranks" --merge
cmp "$place/single/results.csv" "$place/ranks/results.csv"
echo "an array of eight jobs and $(nproc) tasks of srun give the table of a single run, to the bit"
