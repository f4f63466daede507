#!/bin/sh
# Prints a page in markdown: how fast and how exact the program is, beside what
# people use instead. Whole programs take turns, so that what slows the machine
# down for a while slows a run of each.
# usage: [BENCH_LINES=N] bench.sh BUILD
set -eu
export LC_ALL=C
lines=${BENCH_LINES:-1000000}
rounds=5
build=$(cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
PATH=$build:$build/cmd/bench:$build/core/bench:$PATH
mkdir -p "$build/bench"
cd "$build/bench"
rm -f commands times.tsv left_out

say() {
	echo "bench: $*" >&2
}

# usage: add GROUP NAME COMMAND. A program of text reads in.xyz.
add() {
	printf '%s\t%s\t%s\n' "$1" "$2" "$3" >>commands
}

# usage: add_if TOOL GROUP NAME COMMAND: adds it if there is such a tool.
add_if() {
	if command -v "$1" >/dev/null; then
		shift
		add "$@"
	else
		echo "$1 is not installed" >>left_out
	fi
}

make_input() {
	cat >scene.json <<-'EOF'
	{
	  "camera":     {"eye": [1, 2, -5], "at": [0.1, 0.2, 0.3]},
	  "projection": {"type": "persp", "fovy": 60, "near": 1, "far": 10},
	  "viewport":   {"width": 640, "height": 480}
	}
	EOF
	# Park and Miller's generator: the same points from every awk.
	awk -v n="$lines" 'function next_number() {
		s = s * 16807 % 2147483647
		return 4 * s / 2147483647 - 2
	}
	BEGIN {
		s = 1
		for (i = 0; i < n; i++) {
			x = next_number()
			y = next_number()
			printf "%.6f %.6f %.6f\n", x, y, next_number()
		}
	}' >points.xyz
	head -n 1000 points.xyz >few.xyz
	projcalc project --matrix scene.json >matrix
	projcalc project --from world --to world -o f64 scene.json \
	    points.xyz >points.f64
}

# The view matrix as parameters of PROJ.
affine() {
	projcalc project --matrix --to view scene.json | awk '{
		for (i = 1; i <= 3; i++)
			if (NR < 4)
				printf "+s%d%d=%s ", i, NR, $i
			else
				printf "+%soff=%s ", substr("xyz", i, 1), $i
	}'
}

find_python() {
	for python in python3 /usr/bin/python3; do
		"$python" -c 'import numpy' 2>/dev/null && return
	done
	python='python3 with numpy'
}

add_text() {
	for precision in exact double; do
		for jobs in 1 2; do
			add text "projcalc $precision, -j$jobs" "projcalc \
project -p $precision -j $jobs scene.json in.xyz"
		done
	done
	for library in GLM cglm Eigen; do
		peers versions | grep -q "^$library " ||
		    echo "$library is not installed" >>left_out
	done
	for peer in 'GLM double' 'GLM float' 'cglm float'; do
		if peers filter "$peer" </dev/null; then
			add text "$peer, scanf and printf" \
			    "peers filter '$peer' <in.xyz"
		fi
	done
	add_if mawk text mawk "mawk -f '$here/peer/peer.awk' matrix in.xyz"
	find_python
	add_if "$python" text 'python3, numpy' \
	    "$python '$here/peer/peer.py' matrix in.xyz"
	add affine 'projcalc exact, -j1' \
	    'projcalc project --to view -j 1 scene.json in.xyz'
	add_if cct affine 'cct, PROJ' \
	    "cct -d 15 -t 0 +proj=affine $(affine) in.xyz"
}

# The same points, spread over as many processes as there are cores.
add_split() {
	project='projcalc project -j 1 scene.json -'
	add split 'one process' "projcalc project scene.json in.xyz"
	add_if parallel split 'parallel --pipe' "parallel --pipe --block 5M \
-k -q $project <in.xyz"
	add_if parallel split 'parallel --pipepart' "parallel --pipepart \
-a in.xyz --block -1 -k -q $project"
	add split 'split -n l/K/N, for each core' "for k in $(seq -s ' ' \
"$(nproc)"); do split -n l/\$k/$(nproc) in.xyz | $project >image\$k & done; wait"
}

add_others() {
	f=points.f64
	for command in cat 'projcalc project -i f64 scene.json -' \
	    'projcalc project -p double -i f64 scene.json -' \
	    'projcalc project -p single -i f64 scene.json -' \
	    'projcalc project -t 0.5 -i f64 scene.json -'; do
		add binary "$command" "cat $f $f $f $f $f $f $f $f | $command"
	done
	add start 'projcalc lookat' 'projcalc lookat scene.json'
	add_if jq start 'jq -n 1' 'jq -n 1'
}

run() {
	i=0
	while [ "$i" -lt "$2" ]; do
		eval "$1"
		i=$((i + 1))
	done >/dev/null
}

measure() {
	ln -sf points.xyz in.xyz
	round=0
	while [ "$round" -le "$rounds" ]; do
		say "round $round of $rounds"
		while IFS='	' read -r group name command <&3; do
			[ "$group" = start ] && count=40 || count=1
			spent=0
			# The quick ones are run more often.
			while [ "$spent" -lt 300000000 ]; do
				start=$(date +%s%N)
				run "$command" "$count"
				took=$(($(date +%s%N) - start))
				spent=$((spent + took))
				# the first round warms up
				[ "$round" -eq 0 ] || printf '%s\t%s\t%s\n' \
				    "$group" "$name" $((took / count)) \
				    >>times.tsv
			done
		done 3<commands
		round=$((round + 1))
	done
}

# Compares the numbers of each text program with those of its group's first.
check() {
	ln -sf few.xyz in.xyz
	last=
	while IFS='	' read -r group name command <&3; do
		case $group in
		text | affine) ;;
		*) continue ;;
		esac
		eval "$command" >image
		[ "$group" = "$last" ] || cp image reference
		last=$group
		paste reference image | awk -v group="$group" -v name="$name" \
		    'NF < 6 { exit bad = 1 }
		{
			for (i = 1; i <= 3; i++) {
				d = $i - $(i + 3)
				if (d < 0)
					d = -d
				if (d > worst)
					worst = d
			}
		}
		END {
			printf "%s\t%s\t%.1e\n", group, name,
			    bad || NR < 1 ? "nan" : worst
		}'
	done 3<commands >differences.tsv
}

# group, name, minimum and median in ns
summarise() {
	awk -F '\t' '{
		key = $1 "\t" $2
		if (!(key in n))
			order[++keys] = key
		for (i = ++n[key]; i > 1 && t[key, i - 1] > $3; i--)
			t[key, i] = t[key, i - 1]
		t[key, i] = $3
	}
	END {
		for (k = 1; k <= keys; k++) {
			key = order[k]
			printf "%s\t%.0f\t%.0f\n", key, t[key, 1],
			    t[key, int((n[key] + 1) / 2)]
		}
	}' times.tsv >results.tsv
}

# What bench.gp draws: million lines a second, the fastest first.
throughput() {
	awk -F '\t' -v lines="$lines" '$1 == "text" || $1 == "affine" {
		if ($1 == "affine")
			$2 = $2 ", affine map"
		printf "%s\t%.3f\n", $2, lines / $4 * 1e3
	}' results.tsv | sort -t '	' -k 2,2gr >throughput.tsv
}

machine() {
	echo "- $(lscpu | sed -n 's/^Model name: *//p'), $(nproc) cores"
	uname -srm | sed 's/^/- /'
	peers versions | sed 's/^/- /'
	cut -f 2 commands | sort -u | while read -r name; do
		case $name in
		mawk) mawk -W version 2>&1 | head -n 1 ;;
		python3*) "$python" -c 'import sys, numpy
print("Python", sys.version.split()[0] + ", numpy", numpy.__version__)' ;;
		cct*) cct --version 2>&1 | sed 's/,.*//' ;;
		jq*) jq --version ;;
		esac
	done | sed 's/^/- /'
}

memory_table() {
	cat <<-'EOF'
	| | ns a point | median | worst error | 1e9 away |
	|---|--:|--:|--:|--:|
	EOF
	sed 's/inf$/nan/; s/\t/ | /g; s/.*/| & |/' memory.tsv
}

text_table() {
	printf '| | seconds | median | million lines a second | against %s |' "$2"
	printf ' largest difference from exact |\n|---|--:|--:|--:|--:|--:|\n'
	awk -F '\t' -v lines="$lines" -v group="$1" -v base="$2" '
	FNR == NR {
		difference[$1, $2] = $3
		next
	}
	$1 == group && index($2, base) == 1 { base_time = $4 }
	$1 == group { row[++n] = $0 }
	END {
		for (i = 1; i <= n; i++) {
			split(row[i], f, "\t")
			printf "| %s | %.3f | %.3f | %.2f | %s | %s |\n", f[2],
			    f[3] / 1e9, f[4] / 1e9, lines / f[4] * 1e3,
			    base_time ? sprintf("%.2f", base_time / f[4]) : "",
			    difference[f[1], f[2]]
		}
	}' differences.tsv results.tsv
}

binary_table() {
	cat <<-'EOF'
	| `cat points... \|` | seconds | median | GB/s | time against cat |
	|---|--:|--:|--:|--:|
	EOF
	awk -F '\t' -v bytes="$((lines * 24 * 8))" '$1 == "binary" {
		if ($2 == "cat")
			cat = $4
		printf "| `%s` | %.3f | %.3f | %.2f | %.2f |\n", $2, $3 / 1e9,
		    $4 / 1e9, bytes / $4, $4 / cat
	}' results.tsv
}

split_table() {
	printf '| | seconds | median | more than one process |\n|---|--:|--:|--:|\n'
	awk -F '\t' '$1 == "split" {
		if (!base)
			base = $4
		printf "| %s | %.3f | %.3f | %.3f |\n", $2, $3 / 1e9, $4 / 1e9,
		    ($4 - base) / 1e9
	}' results.tsv
}

start_table() {
	printf '| | ms | median |\n|---|--:|--:|\n'
	awk -F '\t' '$1 == "start" {
		printf "| `%s` | %.2f | %.2f |\n", $2, $3 / 1e6, $4 / 1e6
	}' results.tsv
}

say "$lines lines, $rounds rounds"
make_input
add_text
add_split
add_others
points >kernels
peers >memory.tsv
check
measure
summarise
throughput

printf '# Measurements\n\n'
machine
printf '\nTimes are the least and the median of many runs, taken in turn. '
printf 'Rates and\nratios are of the medians.\n'
printf '\n## Kernels: ns a point, least (median)\n\n'
cat kernels
printf '\n## Points in memory: world to device, errors in device units\n\n'
memory_table
printf '\n## Text: %s lines of three numbers, whole programs\n\n' "$lines"
text_table text 'GLM double'
printf '\nAn affine map alone:\n\n'
text_table affine cct
printf '\n## Binary: %s points of f64 through a pipe\n\n' "$((lines * 8))"
binary_table
printf '\n## Splitting: the same lines over %s processes\n\n' "$(nproc)"
split_table
printf '\n## Scale: cores that one process keeps at work\n\n'
sh "$here/feed.sh" "$build" scene.json points.xyz points.f64
printf '\n## Start-up\n\n'
start_table
if [ -s left_out ]; then
	printf '\nLeft out:\n\n'
	sed 's/^/- /' left_out
fi
