#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs a cluster on one machine: a head and three hosts. Each host is a set of
# namespaces, with its own network, process table, name and home, and runs sshd; the
# hosts share one directory. GNU parallel and Slurm spread points over the hosts as
# SCALE in projcalc-numbers(7) says, and hosts are killed half-way. The output must be
# that of one process. Nothing is left when the script ends. Needs root, and the
# packages of `make deps-all`.
# usage: cluster.sh BUILD
set -eu
build=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."

die() {
	echo "cluster.sh: $*" >&2
	exit 1
}

if [ "${CLUSTER:-}" != inside ]; then
	[ "$(id -u)" = 0 ] || die 'namespaces want root'
	CLUSTER=inside exec unshare --net --mount --uts --pid --fork \
	    --kill-child --mount-proc sh cmd/test/cluster.sh "$build"
fi

tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
PATH=$build:$PATH
LC_ALL=C
export PATH LC_ALL

# Repeats a command until it succeeds, for at most half a minute.
soon() {
	tries=0
	until "$@" >"$tmp/soon" 2>&1; do
		tries=$((tries + 1))
		[ $tries -lt 300 ] || die "$*: $(cat "$tmp/soon")"
		sleep 0.1
	done
}

# Makes all that sshd needs: an account whose home is the cluster's, a key, names
# for addresses. Nothing of the machine itself is read or changed.
system() {
	HOME=$tmp/home
	export HOME
	mkdir "$HOME" "$HOME/.ssh" "$tmp/1" "$tmp/2" "$tmp/3" "$tmp/shared"
	chmod 700 "$HOME/.ssh"
	mount -t tmpfs tmpfs /run
	mkdir /run/sshd
	ssh-keygen -q -t ed25519 -N '' -f "$HOME/.ssh/id_ed25519"
	cp "$HOME/.ssh/id_ed25519.pub" "$HOME/.ssh/authorized_keys"
	# A host that is silent for two seconds is dead.
	cat >"$HOME/.ssh/config" <<-END
		Host *
		StrictHostKeyChecking no
		LogLevel ERROR
		ServerAliveInterval 1
		ServerAliveCountMax 2
		ConnectTimeout 3
	END
	cat >"$tmp/passwd" <<-END
		root:x:0:0::$HOME:/bin/sh
		sshd:x:101:65534::/run/sshd:/usr/sbin/nologin
	END
	echo 'root:*:20000:0:99999:7:::' >"$tmp/shadow"
	cat >"$tmp/hosts" <<-END
		127.0.0.1 localhost
		10.0.0.10 head
		10.0.0.1 host1
		10.0.0.2 host2
		10.0.0.3 host3
	END
	for file in passwd shadow hosts; do
		mount --bind "$tmp/$file" /etc/$file
	done
	cat >"$tmp/sshd_config" <<-END
		HostKey $HOME/.ssh/id_ed25519
		UsePAM no
		PidFile none
		StrictModes no
		PermitRootLogin yes
		SetEnv PATH=$PATH
		MaxStartups 100
	END
	hostname head
	ip link set lo up
	ip link add switch type bridge
	ip addr add 10.0.0.10/24 dev switch
	ip link set switch up
}

# usage: host N: starts host N. All its processes are children of one process, which
# kill_host kills.
host() {
	cp -r "$HOME/.ssh" "$tmp/$1"
	unshare --net --mount --uts --pid --fork --kill-child --mount-proc \
	    sh -c "hostname host$1
		mount --bind '$tmp/$1' '$HOME'
		until ip link show eth0 >/dev/null 2>&1; do sleep 0.05; done
		ip link set lo up
		ip addr add 10.0.0.$1/24 dev eth0
		ip link set eth0 up
		exec /usr/sbin/sshd -D -e -f '$tmp/sshd_config'" \
	    2>"$tmp/sshd$1" &
	eval "host$1=$!"
	ip link add "port$1" type veth peer name "wire$1"
	ip link set "port$1" master switch up
	soon ip link set "wire$1" netns $! name eth0
	soon ssh "host$1" true
}

# Kills a host as a power cut does: its processes and network end without a message.
kill_host() {
	eval "kill -9 \$host$1"
	echo "	host$1 is killed" >&3
}

# usage: until_written BYTES: waits until the output of the job in the background, in
# one file image or in several, has that many bytes.
until_written() {
	until [ "$(cat image* 2>/dev/null | wc -c)" -gt "$1" ]; do
		kill -0 $! || die 'done before a host could be killed'
		sleep 0.02
	done
}

# usage: is_whole NAME [ONE]: checks that the image is that of one process, and reports
# it.
is_whole() {
	cmp "${2-one}" image || die "$1: not the image of one process"
	rm -f image*
	echo "ok - $1" >&3
}

three=host1,host2,host3

# A host that was killed is started again if the next run needs it.
parallel_runs() {
	parallel --pipe --block 1M -k -q -S $three --basefile scene.json \
	    projcalc project -j1 scene.json - <points >image
	is_whole 'parallel --pipe'
	parallel --pipepart -a points --block 1M -k -q -S $three \
	    --basefile scene.json projcalc project -j1 scene.json - >image
	is_whole 'parallel --pipepart'
	parallel --pipe --block 512k --retries 3 -k -q -S $three \
	    --basefile scene.json --joblog joblog \
	    projcalc project -j1 scene.json - <points >image &
	until_written 5000000
	kill_host 2
	wait $!
	cut -f 2 joblog | grep -q host2
	is_whole 'parallel --pipe --retries 3, a host less'
	host 2
	seq 40 | parallel --retries 3 -k -S $three "cd '$PWD' &&
	    split -n l/{}/40 points | projcalc project -j1 scene.json -" \
	    >image &
	until_written 5000000
	kill_host 3
	wait $!
	is_whole 'parallel, each task with its own part, a host less'
	host 3
}

# Inputs as a table, whose header is in the first piece only, and as JSON. parallel
# replaces {#} and {} in single quotes, and the script of Slurm $n.
by_number='projcalc project -j1 -i csv --columns 2,3,4'
make_tables() {
	awk 'BEGIN { print "t,x,y,z" } !/^#/ { print $4 "," $1 "," $2 "," $3 }' \
	    points >points.csv
	awk '!/^#/ { print "{\"x\":" $1 ",\"y\":" $2 ",\"t\":" $4 ",\"z\":" $3 "}" }' \
	    points >points.json
	projcalc project -i csv scene.json points.csv >one.csv
	projcalc project -i csv -o json scene.json points.csv >one.rows
	projcalc project -i json scene.json points.json >one.json
}

table_runs() {
	parallel --pipe --block 1M -k -S $three --basefile scene.json \
	    "$by_number \$([ {#} = 1 ] || echo --no-header) scene.json -" \
	    <points.csv >image
	is_whole 'parallel --pipe, a table' one.csv
	parallel --pipepart -a points.csv --block 1M -k \
	    "$by_number \$([ {#} = 1 ] || echo --no-header) scene.json -" >image
	is_whole 'parallel --pipepart, a table' one.csv
	parallel --pipe --header : --block 1M -k -q -S $three \
	    --basefile scene.json projcalc project -j1 -i csv -o json \
	    scene.json - <points.csv >image
	is_whole 'parallel --header, a table to JSON' one.rows
	seq 40 | parallel --retries 3 -k -S $three "cd '$PWD' &&
	    split -n l/{}/40 points.csv |
	    $by_number \$([ {} = 1 ] || echo --no-header) scene.json -" >image
	is_whole 'parallel, each task with its own part of a table' one.csv
	parallel --pipe --block 1M -k -q -S $three --basefile scene.json \
	    projcalc project -j1 -i json scene.json - <points.json >image
	is_whole 'parallel --pipe, JSON' one.json
	seq 40 | parallel --retries 3 -k -S $three "cd '$PWD' &&
	    split -n l/{}/40 points.json |
	    projcalc project -j1 -i json scene.json -" >image
	is_whole 'parallel, each task with its own part of JSON' one.json
}

slurm_conf() {
	cat <<-END
		ClusterName=projcalc
		SlurmctldHost=head
		SlurmUser=root
		SlurmdUser=root
		AuthType=auth/munge
		AuthInfo=socket=$tmp/munge.socket
		StateSaveLocation=$tmp
		SlurmdSpoolDir=$tmp/spool-%n
		SlurmctldPidFile=$tmp/slurmctld.pid
		SlurmdPidFile=$tmp/slurmd-%n.pid
		ProctrackType=proctrack/linuxproc
		TaskPlugin=task/none
		MpiDefault=none
		SelectType=select/cons_tres
		SelectTypeParameters=CR_CPU
		SlurmdTimeout=5
		TCPTimeout=1
		MessageTimeout=2
		NodeName=host[1-3] CPUs=2 State=UNKNOWN
		PartitionName=all Nodes=ALL Default=YES
	END
}

all_idle() {
	[ "$(sinfo -h -t idle -o %D)" = 3 ]
}

start_slurm() {
	slurm_conf >"$tmp/slurm.conf"
	SLURM_CONF=$tmp/slurm.conf
	export SLURM_CONF
	chmod 755 "$tmp"
	head -c 1024 /dev/urandom >"$tmp/munge.key"
	chmod 400 "$tmp/munge.key"
	munged --force --key-file="$tmp/munge.key" \
	    --socket="$tmp/munge.socket" --pid-file="$tmp/munge.pid" \
	    --log-file="$tmp/munge.log" --seed-file="$tmp/munge.seed"
	slurmctld -D >"$tmp/slurmctld" 2>&1 &
	for n in 1 2 3; do
		outer=$(eval "echo \$host$n")
		inner=$(tr -d ' ' <"/proc/$outer/task/$outer/children")
		nsenter -t "$inner" -a --root slurmd -D -N "host$n" \
		    >"$tmp/slurmd$n" 2>&1 &
	done
	soon all_idle
}

# Slurm waits for two minutes before it gives the tasks of a dead host to
# others; here scontrol tells it to start them at once.
slurm_run() {
	# sleep makes tasks long enough for a host to be killed during one.
	cat >job <<-'END'
		#!/bin/sh
		#SBATCH --array=1-20
		#SBATCH --requeue
		#SBATCH --output=/dev/null
		split -n l/$SLURM_ARRAY_TASK_ID/20 points |
		projcalc project -j1 scene.json - >image.$SLURM_ARRAY_TASK_ID
		status=$?
		sleep 1
		exit $status
	END
	sbatch job >"$tmp/sbatch"
	until_written 10000000
	kill_host 2
	while squeue -h -o %i >"$tmp/tasks" && [ -s "$tmp/tasks" ]; do
		for task in $(squeue -h -t PD -o %i); do
			scontrol update "JobId=$task" StartTime=now \
			    2>"$tmp/scontrol" || :
		done
		sleep 1
	done
	grep -q 'due to failure of node host2' "$tmp/slurmctld"
	for n in $(seq 20); do cat "image.$n"; done >image
	is_whole 'a Slurm array, a host less'
}

# Runs the tables as a Slurm array, on all hosts that are left.
slurm_tables() {
	cat >job <<-END
		#!/bin/sh
		#SBATCH --array=1-20
		#SBATCH --requeue
		#SBATCH --output=/dev/null
		n=\$SLURM_ARRAY_TASK_ID
		split -n l/\$n/20 points.csv |
		$by_number \$([ \$n = 1 ] || echo --no-header) \
		    scene.json - >image.\$n
		split -n l/\$n/20 points.json |
		projcalc project -j1 -i json scene.json - >json.\$n
	END
	sbatch --wait job >"$tmp/sbatch"
	for n in $(seq 20); do cat "image.$n"; done >image
	is_whole 'a Slurm array, a table' one.csv
	for n in $(seq 20); do cat "json.$n"; done >image
	is_whole 'a Slurm array, JSON' one.json
}

exec 3>&1
system
for n in 1 2 3; do host $n; done
yes testdata/teapot.xyz | head -n 300 | xargs cat |
    awk '{ print $0, NR }' >"$tmp/shared/points"
cp testdata/demo.json "$tmp/shared/scene.json"
cd "$tmp/shared"
projcalc project scene.json points >one
make_tables
parallel_runs
table_runs
if command -v slurmctld >/dev/null; then
	start_slurm
	slurm_run
	slurm_tables
else
	echo 'skip - no slurmctld' >&3
fi
