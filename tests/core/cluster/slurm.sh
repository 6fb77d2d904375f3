#!/bin/sh
# A real Slurm on the loopback of this computer, for tests: munged, slurmctld and two slurmd, all
# of it in FOLDER and ended with this script, which ends when its standard input does.
#   tests/core/cluster/slurm.sh FOLDER
# Says "ready" when jobs can be submitted with SLURM_CONF=FOLDER/slurm.conf, else why not. FOLDER
# must not be too deep: a socket's path has at most 107 bytes.
set -eu
umask 022
mkdir -p "$1"
cd "$1"
here=$(pwd)
PATH=$PATH:/usr/sbin:/sbin
export PATH SLURM_CONF="$here/slurm.conf"
for program in munged slurmctld slurmd sbatch squeue python3; do
  command -v $program > /dev/null || { echo "$program is not installed"; exit 1; }
done

children=""
end() {
  trap - EXIT
  scancel --user="$(id -un)" --signal=KILL --full 2> /dev/null || true
  scancel --user="$(id -un)" 2> /dev/null || true
  for _ in 1 2 3 4 5 6 7 8 9 10; do
    [ -n "$(squeue --noheader --states=running,completing 2> /dev/null)" ] || break
    sleep 0.3
  done
  for child in $children; do kill "$child" 2> /dev/null || true; done
  sleep 0.3
  for child in $children; do kill -9 "$child" 2> /dev/null || true; done
}
trap end EXIT
trap 'exit 1' INT TERM HUP

mkdir -p munge state spool
chmod 700 munge
dd if=/dev/urandom of=munge/key bs=128 count=1 2> /dev/null
chmod 600 munge/key
ports=$(python3 -c '
import socket
held = [socket.socket() for _ in range(3)]
for one in held: one.bind(("127.0.0.1", 0))
print(*[one.getsockname()[1] for one in held])')
# shellcheck disable=SC2086  # words are wanted
set -- $ports
cat > slurm.conf << CONF
ClusterName=ostraka
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=$1
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$here/munge/socket,cred_expire=5
CredType=cred/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
ReturnToService=2
StateSaveLocation=$here/state
SlurmdSpoolDir=$here/spool/%n
SlurmctldPidFile=$here/slurmctld.pid
SlurmdPidFile=$here/slurmd.%n.pid
SlurmctldLogFile=$here/slurmctld.log
SlurmdLogFile=$here/slurmd.%n.log
SlurmdParameters=config_overrides
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=0,defer_batch
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
JobAcctGatherType=jobacct_gather/linux
JobAcctGatherFrequency=1
JobAcctGatherParams=OverMemoryKill
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
KillWait=2
MinJobAge=300
InactiveLimit=0
SlurmctldTimeout=30
SlurmdTimeout=30
MaxArraySize=20001
NodeName=near1 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$2 CPUs=2 RealMemory=4000
NodeName=near2 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$3 CPUs=2 RealMemory=4000
PartitionName=all Nodes=near1,near2 Default=YES MaxTime=INFINITE State=UP
PartitionName=brief Nodes=near1,near2 MaxTime=1 State=UP
CONF

munged --foreground --force --key-file="$here/munge/key" --socket="$here/munge/socket" \
  --pid-file="$here/munge/pid" --seed-file="$here/munge/seed" --log-file="$here/munge/log" \
  > munge/out 2>&1 &
children="$children $!"
for _ in 1 2 3 4 5 6 7 8 9 10; do
  [ -S munge/socket ] && break
  sleep 0.2
done
[ -S munge/socket ] || { echo "munged did not start: $(tail -n 1 munge/out)"; exit 1; }
slurmctld -D -i -f "$SLURM_CONF" > slurmctld.out 2>&1 &
children="$children $!"
for node in near1 near2; do
  mkdir -p "spool/$node"
  slurmd -D -N $node -f "$SLURM_CONF" > "slurmd.$node.out" 2>&1 &
  children="$children $!"
done
ready=no
for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
  [ "$(sinfo --noheader --Node --partition=all --states=idle --format=%N 2> /dev/null | wc -l)" = 2 ] &&
    { ready=yes; break; }
  sleep 0.5
done
[ $ready = yes ] || { echo "Slurm did not start: $(tail -n 1 slurmctld.log slurmd.near1.log 2>&1 | tr '\n' ' ')"; exit 1; }
echo ready
cat > /dev/null
