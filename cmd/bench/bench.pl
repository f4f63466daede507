#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Measures the program beside what people use instead, and prints a page in
# markdown: whole programs, which take turns, and points in memory. Errors are
# those from the truth in MPFR, by worst.c and peers.c. What bench.gp draws is
# left in BUILD/bench.
# usage: [BENCH_SECONDS=N] bench.pl BUILD
use strict;
use warnings;
use Cwd qw(abs_path);
use File::Basename;
use List::Util qw(first);

my $seconds = $ENV{BENCH_SECONDS} // 200;
my ($points, $few, $copies) = (1e6, 1e4, 8);
my $here = dirname(abs_path($0));
my $build = abs_path($ARGV[0] // 'build');
$ENV{PATH} = "$build:$build/cmd/bench:$build/core/bench:$ENV{PATH}";
$ENV{LC_ALL} = 'C';
mkdir "$build/bench";
chdir "$build/bench" or die "$build/bench: $!\n";

my (@rows, %row, @left_out);
my @threads = (['text, one thread', 'text'], ['text, two threads', '-j 2'],
    ['f64, one thread', 'f64'], ['f64, two threads', 'f64 -j 2']);

# A whole program. In its command {name} is an input, which is made by make_inputs
# and of which few points are enough for its error; "from" and "to" are the
# formats of its points, and none are compared where "to" is missing.
sub row {
	my ($key, $name, $command, %more) = @_;
	push @rows, $row{$key} = {
		key => $key, name => $name, command => $command, n => $points,
		space => 'device', from => 'text', %more
	};
}

sub has {
	my ($tool) = @_;
	return 1 if system("command -v $tool >/dev/null 2>&1") == 0;
	push @left_out, $tool;
	return 0;
}

sub spew {
	my ($name, @text) = @_;
	open my $file, '>:raw', $name or die "$name: $!\n";
	print $file @text;
	close $file or die "$name: $!\n";
}

sub ask {
	my ($command) = @_;
	my $answer = `$command`;
	die "bench: failed: $command\n" if $?;
	return $answer;
}

### What is measured

# The scene of view.h, and points in every format; binary ones are quick, so there
# are more of them.
sub make_inputs {
	my ($folder, $n, $copies) = @_;
	my %file;
	mkdir $folder;
	for (qw(text long csv table json objects document pixels f64
	    f32)) {
		open $file{$_}, '>:raw', "$folder/$_" or die "$folder/$_: $!\n";
	}
	my $put = sub { print {$file{$_[0]}} @_[1 .. $#_] };
	srand 1;
	$put->(document => '{"points": [');
	for my $i (1 .. $n) {
		my @p = map { sprintf '%.6f', rand(4) - 2 } 1 .. 3;
		my $p = join ',', @p;
		$put->(text => "@p\n");
		$put->(long => sprintf("%.17g %.17g %.17g\n",
		    map { $_ + (rand() - 0.5) * 1e-6 } @p));
		$put->(csv => "$p\n");
		$put->(table => "id,$p\n");
		$put->(json => "[$p]\n");
		$put->(objects => sprintf(qq({"id":%d,"x":%s,"y":%s,"z":%s}\n),
		    $i, @p));
		$put->(document => ",\n" x ($i > 1) . "[$p]");
		$put->(pixels => sprintf("%.6f %.6f\n", 320 + 160 * $p[0],
		    240 + 120 * $p[1]));
		$put->(f64 => pack 'd<*', @p);
		$put->(f32 => pack 'f<*', @p);
	}
	$put->(document => '], ' . ask("sed '1s/{//' scene.json"));
	close $_ or die "$folder: $!\n" for values %file;
	for (qw(f64 f32)) {
		rename "$folder/$_", 'image';
		ask("cat @{[('image') x $copies]} >$folder/$_");
	}
}

# The view matrix as parameters of PROJ.
sub affine {
	my @m = map { [split] } split /\n/,
	    ask('projcalc project --matrix --to view scene.json');
	return join ' ', map {
		my $i = $_;
		'+' . qw(x y z)[$i] . "off=$m[3][$i]",
		    map { "+s@{[$i + 1]}@{[$_ + 1]}=$m[$_][$i]" } 0 .. 2
	} 0 .. 2;
}

# Ours.
sub our_rows {
	my $run = 'projcalc project -j 1';
	my @f64 = (group => 'binary', from => 'f64', to => 'f64',
	    n => $copies * $points);
	for my $how ('', ' -p double', ' -p single') {
		my @chart = (kind => 'ours',
		    label => $how ? substr $how, 1 : 'exact');
		row("text$how", "`projcalc$how`", "$run$how scene.json {text}",
		    group => 'text', to => 'text', @chart);
		row("f64$how", "`projcalc$how -i f64`",
		    "$run$how -i f64 scene.json {f64}", @f64, @chart);
	}
	row('f32', '`projcalc -p single -i f32`',
	    "$run -p single -i f32 scene.json {f32}", @f64, from => 'f32',
	    to => 'f32', kind => 'ours', label => '-p single, f32');
	row('f64 to f32', '`projcalc -i f64 -o f32`',
	    "$run -i f64 -o f32 scene.json {f64}", @f64, to => 'f32');
	row('affine', '`projcalc --to view`', "$run --to view scene.json {text}",
	    group => 'affine', to => 'text', space => 'view');
	row('avx2', '', "PROJCALC_CPU=avx2 $run scene.json {text}")
	    if `lscpu` =~ /avx2/;
	row('digits', '', "$run -d 6 scene.json {text}");
	row('flags', '', "$run --flags scene.json {text}");
	row('csv', '', "$run -i csv scene.json {csv}");
	row('columns', '', "$run -i csv --columns 2,3,4 scene.json {table}");
	row('json', '', "$run -i json scene.json {json}");
	row('objects', '', "$run -i json scene.json {objects}");
	row('long', '', "$run scene.json {long}");
	row('ray', '', "$run --ray scene.json {pixels}");
	row('document', '', "$run {document}");
	row("-j $_", '', "projcalc project -j $_ scene.json {text}")
	    for 2, 16, 64;
	row('f64 -j 2', '', 'projcalc project -j 2 -i f64 scene.json {f64}',
	    n => $copies * $points);
	row('piped', '', "cat {f64} | $run -i f64 scene.json -");
	row('cat', '', 'cat {f64} | cat');
	my $split = "-k -q $run scene.json -";
	row('one', 'one process', 'projcalc project scene.json {text}',
	    group => 'split');
	if (has('parallel')) {
		row('pipe', 'parallel --pipe',
		    "parallel --pipe --block 5M $split <{text}",
		    group => 'split');
		row('pipepart', 'parallel --pipepart',
		    "parallel --pipepart -a {text} --block -1 $split",
		    group => 'split');
	}
	my $forty = 'i=0; while [ $i -lt 40 ]; do i=$((i+1)); %s; done';
	row('start', '`projcalc lookat`',
	    sprintf($forty, 'projcalc lookat scene.json'), group => 'start');
	row('jq', '`jq -n 1`', sprintf($forty, 'jq -n 1'), group => 'start')
	    if has('jq');
}

# Others, with the quickest way in and out that they have; GLM also as most
# people write it.
sub their_rows {
	my (@peers) = @_;
	my @text = (group => 'text', to => 'text', kind => 'double');
	my @f64 = (group => 'binary', from => 'f64', to => 'f64',
	    kind => 'double', n => $copies * $points);
	for (@peers) {
		my ($label, $kind) = split /, /;
		my @chart = (kind => $kind, label => $label);
		my $type = $kind eq 'float' ? 'f32' : 'f64';
		row("text $_", "$_, fast_float, std::to_chars",
		    "peers text '$_' <{text}", @text, @chart);
		row("binary $_", "$_, fread, fwrite",
		    "peers binary '$_' <{$type}", @f64, from => $type,
		    to => $type, @chart);
		row("stdio $_", "$_, scanf, printf", "peers stdio '$_' <{text}",
		    @text, @chart, label => "$label, scanf") if /GLM/;
	}
	for my $library (qw(GLM cglm Eigen)) {
		push @left_out, $library unless grep { /^$library,/ } @peers;
	}
	my $python = first { !system "$_ -c 'import numpy' 2>/dev/null" }
	    qw(python3 /usr/bin/python3);
	if ($python) {
		my $peer = "OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $python " .
		    "$here/peer/peer.py matrix";
		row('numpy', 'numpy, loadtxt, savetxt', "$peer text {text}",
		    @text, label => 'numpy');
		row('fromfile', 'numpy, fromfile, tofile', "$peer f64 {f64}",
		    @f64, label => 'numpy');
	} else {
		push @left_out, 'python3 with numpy';
	}
	row('mawk', 'mawk', "mawk -f $here/peer/peer.awk matrix {text}",
	    @text, label => 'mawk') if has('mawk');
	row('cct', 'PROJ, cct', 'cct -d 15 -t 0 +proj=affine ' . affine() .
	    ' {text}', @text, group => 'affine', space => 'view',
	    label => 'cct, affine map alone') if has('cct');
	return $python;
}

### Measuring

sub command {
	my ($row, $folder) = @_;
	return $row->{command} =~ s/\{(\w+)\}/$folder\/$1/gr;
}

sub measure_errors {
	for my $r (grep { $_->{to} } @rows) {
		ask(command($r, 'few') . ' >image');
		chomp($r->{error} = ask("worst $r->{space} $r->{from} " .
		    "few/$r->{from} $r->{to} image"));
	}
}

sub measure_times {
	spew('commands', map { command($_, 'all') . " >/dev/null\n" } @rows);
	my @times = split /\n/, ask("turns $seconds <commands");
	for my $r (@rows) {
		@$r{qw(wall cpu memory)} = split /\t/, shift @times;
		$r->{$_} *= 1e9 / $r->{n} for qw(wall cpu);
	}
}

### The page

sub machine {
	my ($python) = @_;
	my @lines = (ask("lscpu | sed -n 's/^Model name: *//p'"), ask('uname -srm'),
	    ask('nproc') =~ s/$/ cores/r, split /^/, ask('peers versions'));
	push @lines, ask("$python -c 'import sys, numpy
print(\"Python\", sys.version.split()[0] + \", numpy\", numpy.__version__)'")
	    if $python;
	push @lines, `cct --version 2>&1` =~ s/,.*//r if $row{cct};
	push @lines, `mawk -W version 2>&1` =~ s/\n.*//sr . "\n" if $row{mawk};
	return map { "- $_" } @lines;
}

# Whole programs of a group.
sub programs {
	my ($group, $base) = @_;
	print "| | ns a point | times $base->{name} | worst error |
|---|--:|--:|--:|\n";
	for (grep { ($_->{group} // '') eq $group } @rows) {
		printf "| %s | %.1f | %.2f | %s |\n", $_->{name}, $_->{cpu},
		    $_->{cpu} / $base->{cpu}, $_->{error};
	}
}

# Ratios of two rows' times, a line each.
sub ratios {
	my $glm = 'stdio GLM, double';
	my $loop = 'text loop, double';
	my @ratios = (
		['GLM in double with scanf and printf, against exact text',
		    $glm, 'text'],
		['the same, `PROJCALC_CPU=avx2`', $glm, 'avx2'],
		['loop in double with fast_float and std::to_chars, against ' .
		    'exact text', $loop, 'text'],
		['the same, `PROJCALC_CPU=avx2`', $loop, 'avx2'],
		['one thread against two, text', 'text', '-j 2'],
		['one thread against two, f64', 'f64', 'f64 -j 2'],
		['`-d 6` against shortest', 'digits', 'text'],
		['csv against text', 'csv', 'text'],
		['JSON lines against text', 'json', 'text'],
		['JSON objects against text', 'objects', 'text'],
		['csv with `--columns` against text', 'columns', 'text'],
		['`--flags` against none', 'flags', 'text'],
		['17 digits against six decimals, read', 'long', 'text'],
		['exact f64 through a pipe, from cat, against cat to cat',
		    'piped', 'cat'],
		['f64 `-p double` against f32 `-p single`', 'f64 -p double',
		    'f32'],
		['`-j 16` against `-j 2`', '-j 16', '-j 2'],
		['`-j 64` against `-j 2`', '-j 64', '-j 2'],
	);
	print "| | CPU | wall |\n|---|--:|--:|\n";
	for (@ratios) {
		my ($name, $a, $b) = ($_->[0], @row{@$_[1, 2]});
		next unless $a && $b;    # GLM and AVX2 may be missing
		printf "| %s | %.2f | %.2f |\n", $name, $a->{cpu} / $b->{cpu},
		    $a->{wall} / $b->{wall};
	}
}

sub others {
	my $d = $row{document};
	print "| | |\n|---|--:|\n";
	printf "| a point, f64 to f32 | %.1f ns |\n", $row{'f64 to f32'}{cpu};
	printf "| a line of `--ray` | %.3f us |\n", $row{ray}{cpu} / 1e3;
	printf "| 1000000 points in the document's `points` | %.2f s |\n",
	    $d->{cpu} * $points / 1e9;
	printf "| memory for them beyond the document | %.0f MB |\n",
	    ($d->{memory} - -s 'all/document') / 1e6;
	printf "| %s | %.2f ms |\n", $_->{name}, $_->{cpu} * $points / 40e6
	    for grep { ($_->{group} // '') eq 'start' } @rows;
	printf "| the text, %s, wall | %.2f s |\n", $_->{name},
	    $_->{wall} * $points / 1e9
	    for grep { ($_->{group} // '') eq 'split' } @rows;
	printf "| a trillion lines of text, one core | %.1f days |\n",
	    $row{text}{cpu} * 1e3 / 86400;
	printf "| to read for them | %.0f TB |\n", (-s 'all/text') / $points;
	printf "| to write for them | %.0f TB |\n",
	    ask('projcalc project scene.json all/text | wc -c') / $points;
}

sub page {
	my ($python, @memory) = @_;
	print "# Measurements\n\n", machine($python), "
Medians of runs that take turns. Times are CPU time, unless they are called wall.
A ratio is of the two times.

## Ratios

";
	ratios();
	print "\n## Text, one thread

$points lines of three numbers with six decimals, world to device; errors in
pixels, from MPFR.

";
	programs('text', $row{text});
	print "\nAn affine map alone, errors in units of the world:\n\n";
	programs('affine', $row{affine});
	printf "\n## Binary, one thread

%d points of f64, or of f32 for floats.

", $copies * $points;
	programs('binary', $row{f64});
	print "\n## Two threads\n
| | million points a second, wall |\n|---|--:|\n";
	printf "| %s | %.2f |\n", $_->[0], 1e3 / $row{$_->[1]}{wall}
	    for @threads;
	print "\n## In memory, one thread

World to device. Floats start from the same numbers as all: they are floats in
ordinary scenes. 1e9 away from the origin they have no room for them.

| | ns a point | worst error | 1e9 away |\n|---|--:|--:|--:|\n";
	print map { s/\t/ | /gr =~ s/(.*)/| $1 |/r } @memory;
	print "\n## Other figures\n\n";
	others();
	print "\n## Scale: cores that one process keeps at work\n\n",
	    ask("sh $here/feed.sh $build scene.json all/text all/f64");
	print "\n## Kernels: ns a point\n\n", ask('points');
	print "\n## Digits: ns a number\n\n```\n", ask('number'), "```\n";
	print "\nNot installed, and left out: ", join(', ', @left_out), ".\n"
	    if @left_out;
}

# What names.pl and bench.gp draw: panel, kind, label, time, error, and in memory
# the error of scenes far away.
sub draw {
	my (@memory) = @_;
	my @points = map { [$_->{group} eq 'affine' ? 'text' : $_->{group},
	    @$_{qw(kind label cpu error)}] } grep { $_->{label} } @rows;
	for (@memory) {
		my ($name, @figures) = split /[\t\n]/;
		my ($who, $what) = split /, /, $name;
		push @points, ['memory', $who eq 'projcalc' ? ('ours', $what) :
		    ($what, $who), @figures];
	}
	spew('points.tsv', map { join("\t", @$_) . "\n" } @points);
	spew('threads.tsv', map { join("\t", $_->[0],
	    1e3 / $row{$_->[1]}{wall}) . "\n" } @threads);
}

spew('scene.json', '{
  "camera":     {"eye": [1, 2, -5], "at": [0.125, 0.25, 0.375]},
  "projection": {"type": "persp", "fovy": 60, "near": 1, "far": 10},
  "viewport":   {"width": 640, "height": 480}
}
');
spew('matrix', ask('projcalc project --matrix scene.json'));
make_inputs('all', $points, $copies);
make_inputs('few', $few, 1);
my @memory = split /^/, ask('peers');
our_rows();
my $python = their_rows(grep { !/^projcalc/ } map { s/\t.*\n//r } @memory);
measure_errors();
measure_times();
page($python, @memory);
draw(@memory);
ask('rm -rf all few image');
