#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Measures the program beside what people use instead, and prints a page in markdown.
# Whole programs run in turn, by turns.c; peers.c measures points in memory. Errors are
# differences from MPFR, by worst.c and peers.c. short.pl copies the first part of the
# page to README. The data that speed.gp draws are left in BUILD/bench.
# usage: [BENCH_SECONDS=N] bench.pl BUILD
use strict;
use warnings;
use Cwd qw(abs_path);
use File::Basename;
use List::Util qw(first);
use Text::Wrap qw(fill);

my $seconds = $ENV{BENCH_SECONDS} // 300;
my ($points, $few, $copies) = (1e6, 1e4, 8);
my $here = dirname(abs_path($0));
my $build = abs_path($ARGV[0] // 'build');
$ENV{PATH} = "$build:$build/cmd/bench:$build/core/bench:$ENV{PATH}";
$ENV{LC_ALL} = 'C';
mkdir "$build/bench";
chdir "$build/bench" or die "$build/bench: $!\n";

my (@rows, %row, @left_out);

# The names of rows with which rows of projcalc are compared.
my $hand = 'hand loop, double';
my $standard = 'standard loop, double';
my $glm = 'stdio GLM, double';
my $loop = 'binary loop, double';
my @wide = map { "hand $_" } 'loop, long double', 'loop, double-double',
    'MPFR, 113 bits';

# Returns the kind and the label in speed.gp of a peer: its type and its library, or
# "wide" and its type.
sub drawn {
	my ($library, $type) = split /, /, $_[0];
	return $type =~ /^(?:double|float)$/ ? ($type, $library) :
	    ('wide', $library eq 'loop' ? $type : "$library, $type");
}

# Adds a whole program to the rows. In its command {name} is an input that make_inputs
# makes; its error is measured on fewer points. "from" and "to" are the formats of its
# points; without "to" it has no error. speed.gp draws rows with a label.
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

# Returns a point of an object of 20 units, for a scene that sees it from 7e5 away.
sub far {
	return join ' ', map { $_ * 5 } @_;
}

# Options, and a line with other columns as a survey has them.
my @survey = ('-i csv --columns 2,3,4', sub { my $n = abs $_[0] * 1e6; join ',',
    $n, @_, map({ $n * $_ % 256 } 3, 5, 7, 11), 2,
    ('ground', 'low veg', 'building')[$n % 3], $n / 1e3, $n % 2 });

# Kinds of lines. Each has a name, the kind with which it is compared, options of
# project, a line of three coordinates and, if it is not scene.json, the scene.
my $kind_lines = 5e5;
my @object = ('objects', '-i json');
my @kinds = (
	['lines', '', '', sub { "@_" }],
	['an exponent', 'lines', '', sub { "$_[0]e-01 $_[1] $_[2]" }],
	['a plus on every number', 'lines', '',
	    sub { join ' ', map { s/^(?!-)/+/r } @_ }],
	['17 digits', 'lines', '', sub { sprintf '%.17g %.17g %.17g',
	    map { $_ * 1.1 } @_ }],
	(map { my $f = $_; [$f, 'lines', '', sub { join ' ',
	    map { sprintf $f, $_ * 1.1 } @_ }] } qw(%.16e %.18e %.19f %.20f)),
	['whole numbers', 'lines', '', sub { join ' ',
	    map { int abs $_ * 1e3 } @_ }],
	['tabs', 'lines', '', sub { join "\t", @_ }],
	['blanks before', 'lines', '', sub { "   @_" }],
	['columns of 14 characters', 'lines', '', sub { join ' ',
	    map { sprintf '%14.*f', 1 + abs($_ * 1e6) % 6, $_ } @_ }],
	['a name behind', 'lines', '', sub { "@_ name" }],
	['CR LF', 'lines', '', sub { "@_\r" }],
	['-d 6', 'lines', '-d 6', sub { "@_" }],
	['-d 15', 'lines', '-d 15', sub { "@_" }],
	['-d 16', 'lines', '-d 16', sub { "@_" }],
	['-d 20', 'lines', '-d 20', sub { "@_" }],
	['--digits 6', '-d 6', '--digits 6', sub { "@_" }],
	['--digits 17', 'lines', '--digits 17', sub { "@_" }],
	['--flags', 'lines', '--flags', sub { "@_" }],
	['--lines, all one run', 'lines', '--lines', sub { "@_" }],
	['trace', 'lines', 'trace', sub { "@_" }],
	['far object, view', 'lines', '--to view', \&far, 'far.json'],
	['far object, ndc', 'lines', '--to ndc', \&far, 'far.json'],
	['far object, trace', 'trace', 'trace', \&far, 'far.json'],
	['csv', 'lines', '-i csv', sub { join ',', @_ }],
	['csv by --columns', 'csv', '-i csv --columns 2,3,4',
	    sub { join ',', 'id', @_ }],
	['csv, quoted coordinates', 'csv', '-i csv',
	    sub { join ',', map { "\"$_\"" } @_ }],
	['csv, quoted first field', 'csv', '-i csv --columns 2,3,4',
	    sub { join ',', '"a, b"', @_ }],
	['csv, a quoted field behind', 'csv', '-i csv',
	    sub { join ',', @_, '"a, b"' }],
	['csv with semicolons', 'csv', '-i csv --separator ";"',
	    sub { join ';', @_ }],
	['csv, a gap in ten', 'csv', '-i csv',
	    sub { join ',', $_[0] =~ /3$/ ? '' : $_[0], @_[1, 2] }],
	['csv, NA in ten', 'csv', '-i csv',
	    sub { join ',', $_[0] =~ /3$/ ? 'NA' : $_[0], @_[1, 2] }],
	['csv of 12 columns', 'csv', @survey],
	(map { ["csv of 12 columns to $_", 'csv of 12 columns',
	    "$survey[0] -o $_", $survey[1]] } qw(text tsv json)),
	['JSON arrays', 'lines', '-i json',
	    sub { sprintf '[%s,%s,%s]', @_ }],
	['JSON arrays with blanks', 'JSON arrays', '-i json',
	    sub { sprintf '[ %s, %s, %s ]', @_ }],
	['objects', 'lines', '-i json',
	    sub { sprintf '{"id":7,"x":%s,"y":%s,"z":%s}', @_ }],
	['objects, null in ten', @object,
	    sub { sprintf '{"id":7,"x":%s,"y":%s,"z":%s}',
	    $_[0] =~ /3$/ ? 'null' : $_[0], @_[1, 2] }],
	['objects with blanks', @object,
	    sub { sprintf '{"id": 7, "x": %s, "y": %s, "z": %s}', @_ }],
	['objects, an escaped quote', @object,
	    sub { sprintf '{"id":"a\"b","x":%s,"y":%s,"z":%s}', @_ }],
	['objects, \u00e9', @object,
	    sub { sprintf '{"id":"caf\u00e9","x":%s,"y":%s,"z":%s}', @_ }],
	['objects, an exponent elsewhere', @object,
	    sub { sprintf '{"id":1e5,"x":%s,"y":%s,"z":%s}', @_ }],
	['objects, a nested member', @object,
	    sub { sprintf '{"id":{"a":[1,2]},"x":%s,"y":%s,"z":%s}', @_ }],
);

# Makes the inputs of the kinds: a few lines, repeated many times.
sub make_kinds {
	my ($folder) = @_;
	my $lines = 2e4;
	srand 2;
	my @points = map { [map { sprintf '%.6f', rand(4) - 2 } 1 .. 3] }
	    1 .. $lines;
	for (@kinds) {
		my ($name, undef, undef, $line) = @$_;
		my $text = join '', map { $line->(@$_) . "\n" } @points;
		spew("$folder/$name", ($text) x ($kind_lines / $lines));
	}
}

# Makes the scene of view.h, and n points in every format. Binary points are read so
# fast that their file has $copies times as many.
sub make_inputs {
	my ($folder, $n, $copies) = @_;
	my %file;
	mkdir $folder;
	for (qw(text document pixels f64 f32)) {
		open $file{$_}, '>:raw', "$folder/$_" or die "$folder/$_: $!\n";
	}
	my $put = sub { print {$file{$_[0]}} @_[1 .. $#_] };
	srand 1;
	$put->(document => '{"points": [');
	for my $i (1 .. $n) {
		my @p = map { sprintf '%.6f', rand(4) - 2 } 1 .. 3;
		$put->(text => "@p\n");
		$put->(document => ",\n" x ($i > 1) . '[' .
		    join(',', @p) . ']');
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

# Makes a bumpy ball of 100,352 triangles as an OBJ file.
sub make_mesh {
	my ($folder) = @_;
	my ($n, $pi) = (224, atan2 0, -1);
	my @lines;
	for my $i (0 .. $n) {
		for my $k (0 .. $n - 1) {
			my ($up, $round) = ($pi * $i / $n, 2 * $pi * $k / $n);
			my $r = 2 + 0.1 * sin(9 * $up) * sin(8 * $round);
			push @lines, sprintf "v %.6f %.6f %.6f\n",
			    $r * sin($up) * cos $round, $r * cos $up,
			    $r * sin($up) * sin $round;
		}
	}
	for my $i (0 .. $n * $n - 1) {
		my ($a, $b) = ($i + 1, $i - $i % $n + ($i + 1) % $n + 1);
		push @lines, sprintf "f %d %d %d\nf %d %d %d\n", $a, $b, $b + $n,
		    $a, $b + $n, $a + $n;
	}
	spew("$folder/mesh.obj", @lines);
}

# Returns the view matrix as the parameters of an affine transform in PROJ.
sub affine {
	my @m = map { [split] } split /\n/,
	    ask('projcalc project --matrix --to view scene.json');
	return join ' ', map {
		my $i = $_;
		'+' . qw(x y z)[$i] . "off=$m[3][$i]",
		    map { "+s@{[$i + 1]}@{[$_ + 1]}=$m[$_][$i]" } 0 .. 2
	} 0 .. 2;
}

# Adds the rows of projcalc.
sub our_rows {
	my $run = 'projcalc project -j 1';
	my @f64 = (group => 'binary', from => 'f64', to => 'f64',
	    n => $copies * $points);
	for my $how ('', ' -p double', ' -p single') {
		my @chart = (kind => 'ours', label => substr $how || ' exact', 1);
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
	row('avx2', '`projcalc` without AVX-512', "PROJCALC_CPU=avx2 " .
	    "$run scene.json {text}", group => 'text', to => 'text')
	    if `lscpu` =~ /avx512f/;
	for (@kinds) {
		my ($name, $usual, $how, undef, $scene) = @$_;
		my $command = $how =~ /^trace/ ? 'projcalc' : $run;
		$scene //= 'scene.json';
		row($name, $name, "$command $how -j 1 $scene {$name}",
		    group => 'kinds', usual => $usual, n => $kind_lines);
	}
	row('ray', '', "$run --ray scene.json {pixels}");
	row('document', '', "$run {document}");
	row("draw$_", '', "projcalc draw -j 1$_ scene.json {mesh.obj}")
	    for '', ' --text';
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

# Adds the rows of other programs. In text the reading and writing take most of the
# time, not the library: the hand loop and the standard loop use the fastest functions
# that there are, and GLM has scanf and printf, as most people write it.
sub their_rows {
	my (@peers) = @_;
	my @text = (group => 'text', to => 'text', kind => 'double');
	my @f64 = (group => 'binary', from => 'f64', to => 'f64',
	    kind => 'double', n => $copies * $points);
	my $peer = sub {
		my ($filter, $name, $how, @more) = @_;
		row("$filter $name", "$name, $how",
		    "peers $filter '$name' <{text}", @text, @more);
	};
	for (@peers) {
		my ($kind, $label) = drawn($_);
		my @chart = (kind => $kind, label => $label);
		my $type = $kind eq 'float' ? 'f32' : 'f64';
		if ($kind eq 'wide') {
			$peer->('hand', $_, 'by hand', @chart);
			next;
		}
		row("binary $_", /loop/ ? "$_, in place" : "$_, fread, write",
		    "peers binary '$_' <{$type}", @f64, from => $type,
		    to => $type, @chart);
		$peer->('hand', $_, 'by hand', @chart, label => 'by hand')
		    if /loop/;
		$peer->('standard', $_, 'fast_float, std::to_chars', @chart,
		    label => 'fast_float, to_chars') if /loop, double/;
		$peer->('stdio', $_, 'scanf, printf', @chart,
		    label => 'GLM, scanf, printf') if /GLM/;
	}
	for my $library (qw(GLM cglm Eigen)) {
		push @left_out, $library unless grep { /^$library,/ } @peers;
	}
	my $python = first { !system "$_ -c 'import numpy' 2>/dev/null" }
	    qw(python3 /usr/bin/python3);
	if ($python) {
		my $script = "OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $python " .
		    "$here/peer/peer.py matrix";
		row('numpy', 'numpy, loadtxt, savetxt', "$script text {text}",
		    @text, label => 'numpy');
		row('fromfile', 'numpy, fromfile, tofile', "$script f64 {f64}",
		    @f64, label => 'numpy');
	} else {
		push @left_out, 'python3 with numpy';
	}
	row('mawk', 'mawk', "mawk -f $here/peer/peer.awk matrix {text}",
	    @text, label => 'mawk') if has('mawk');
	row('cct', 'PROJ, cct', 'cct -d 15 -t 0 +proj=affine ' . affine() .
	    ' {text}', to => 'text', group => 'affine', space => 'view')
	    if has('cct');
	return $python;
}

### Measuring

sub command {
	my ($row, $folder) = @_;
	return $row->{command} =~ s/\{(.*?)\}/'$folder\/$1'/gr;
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

# Returns the name of the processor. A virtual machine may leave out its number; then
# the family and the model tell which it is.
sub processor {
	my %line = `lscpu 2>/dev/null` =~ /^([\w ]+?): *(.*?) *$/mg;
	my $name = $line{'Model name'} // `sysctl -n machdep.cpu.brand_string`;
	chomp $name;
	return $name if $name =~ /\d/ || !$line{'CPU family'};
	return "$name (CPU family $line{'CPU family'}, model $line{Model}, " .
	    "stepping $line{Stepping})";
}

sub machine {
	my ($python) = @_;
	my @lines = (processor() . "\n", ask('uname -srm'),
	    ask('nproc') =~ s/$/ cores/r, split /^/, ask('peers versions'));
	push @lines, ask("$python -c 'import sys, numpy
print(\"Python\", sys.version.split()[0] + \", numpy\", numpy.__version__)'")
	    if $python;
	push @lines, `cct --version 2>&1` =~ s/,.*//r if $row{cct};
	push @lines, `mawk -W version 2>&1` =~ s/\n.*//sr . "\n" if $row{mawk};
	return map { "- $_" } @lines;
}

# Prints a table of whole programs, compared with the first of them.
sub programs {
	my ($base, @others) = @_;
	print "| $base->{from} | ns a point | times $base->{name} | worst error |
|---|--:|--:|--:|\n";
	printf "| %s | %.1f | %s | %s |\n", @$_{qw(name cpu)},
	    ratio($_->{key}, $base->{key}), $_->{error} for $base, @others;
}

# Prints a table of points in memory, from lines of peers.
sub memory {
	my ($base) = map { (split /\t/)[1] } @_;
	print "| in memory | ns a point | times `projcalc` | worst error | " .
	    "1e9 away |\n|---|--:|--:|--:|--:|\n";
	for (@_) {
		chomp(my ($name, $time, @errors) = split /\t/);
		printf "| %s | %.2f | %.2f | %s |\n", $name =~
		    s/^(projcalc)(?:, exact|,( -p.*))/'`' . $1 . ($2 \/\/ '') . '`'/er,
		    $time, $time / $base, join ' | ', @errors;
	}
}

sub group {
	my ($group) = @_;
	programs(grep { ($_->{group} // '') eq $group } @rows);
}

# Prints the tables of README, and a word about them.
sub short {
	my (@memory) = @_;
	my %memory = map { my @fields = split /\t/; ($fields[0] => $_) } @memory;
	programs(grep { $_ } @row{'text', 'avx2', $hand, @wide, $standard, $glm,
	    'numpy', 'mawk'});
	print "\n";
	memory(grep { $_ } @memory{'projcalc, exact', 'projcalc, -p double',
	    'loop, double', 'GLM, double', map { s/^hand //r } @wide});
	local $Text::Wrap::columns = 85;
	print "\n", fill('', '', 'The rows "by hand" read and write text with the same',
	    'code, the fastest that we could write, and those in wider types round their',
	    'images to doubles. All ran in turn on one thread of an', processor() . ',',
	    'the others compiled with -O3 -march=native. "1e9 away" are scenes as far',
	    'as that from the origin.'), "\n";
}

# Returns the time of row $a as a multiple of that of row $b: CPU time, or that of
# $clock. Returns undef if a row is missing, as without GLM or AVX2.
sub ratio {
	my ($a, $b, $clock) = @_;
	return unless $row{$a} && $row{$b};
	return sprintf '%.2f', $row{$a}{$clock // 'cpu'} /
	    $row{$b}{$clock // 'cpu'};
}

# Prints ratios of the times of two rows, each on a line.
sub ratios {
	my @ratios = (
		['GLM in double with scanf and printf, against exact text',
		    $glm, 'text'],
		['the same, `PROJCALC_CPU=avx2`', $glm, 'avx2'],
		['loop in double by hand, against exact text', $hand, 'text'],
		['the same, `PROJCALC_CPU=avx2`', $hand, 'avx2'],
		['loop in double with fast_float and std::to_chars, against ' .
		    'exact text', $standard, 'text'],
		['exact against `-p double`, text', 'text', 'text -p double'],
		['exact against `-p double`, f64', 'f64', 'f64 -p double'],
		['exact against a loop in double, f64', 'f64', $loop],
		['one thread against two, text', 'text', '-j 2'],
		['one thread against two, f64', 'f64', 'f64 -j 2'],
		['exact f64 through a pipe, from cat, against cat to cat',
		    'piped', 'cat'],
		['f64 `-p double` against f32 `-p single`', 'f64 -p double',
		    'f32'],
		['`-j 16` against `-j 2`', '-j 16', '-j 2'],
		['`-j 64` against `-j 2`', '-j 64', '-j 2'],
	);
	print "| | CPU | wall |\n|---|--:|--:|\n";
	for (@ratios) {
		my ($name, @two) = @$_;
		my $cpu = ratio(@two) or next;
		print "| $name | $cpu | ", ratio(@two, 'wall'), " |\n";
	}
}

# Prints a table of the kinds of lines, each compared with its usual kind.
sub kinds {
	print "| | ns a line | times | of |\n|---|--:|--:|---|\n";
	for (grep { ($_->{group} // '') eq 'kinds' } @rows) {
		my ($name, $usual) = @$_{qw(name usual)};
		printf "| %s | %.1f | %s | %s |\n", $name, $_->{cpu},
		    $usual ? (ratio($name, $usual), $usual) : ('', '');
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
	printf "| `draw%s` of 100352 triangles | %.2f s |\n", $_,
	    $row{"draw$_"}{cpu} * $points / 1e9
	    for '', ' --text';
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

## In short

<!-- speed -->
";
	short(@memory);
	print "<!-- -->\n\n## Ratios\n\n";
	ratios();
	print "\n## Text, one thread

$points lines of three numbers with six decimals, world to device; errors in
pixels, from MPFR.

";
	group('text');
	print "\nAn affine map alone, errors in units of the world:\n\n";
	group('affine');
	printf "\n## Binary, one thread

%d points of f64, or of f32 for floats.

", $copies * $points;
	group('binary');
	print "\n## Two threads\n
| | million points a second, wall |\n|---|--:|\n";
	my @threads = (['text, one thread', 'text'],
	    ['text, two threads', '-j 2'], ['f64, one thread', 'f64'],
	    ['f64, two threads', 'f64 -j 2']);
	printf "| %s | %.2f |\n", $_->[0], 1e3 / $row{$_->[1]}{wall}
	    for @threads;
	print "\n## In memory, one thread

World to device. Floats start from the same numbers as all: they are floats in
ordinary scenes. 1e9 away from the origin they have no room for them.

";
	memory(@memory);
	print "\n## Kinds of lines, one thread\n\n";
	kinds();
	print "\n## Other figures\n\n";
	others();
	print "\n## Scale: cores that one process keeps at work\n\n",
	    ask("sh $here/feed.sh $build scene.json all/text all/f64");
	print "\n## Kernels: ns a point\n\n", ask('points');
	print "\n## Digits: ns a number\n\n```\n", ask('number'), "```\n";
	print "\nNot installed, and left out: ", join(', ', @left_out), ".\n"
	    if @left_out;
}

# Writes the data of names.pl and speed.gp: panel, kind, label, time, error and, for
# points in memory, the error in scenes far away.
sub draw {
	my (@memory) = @_;
	my @points = map { [@$_{qw(group kind label cpu error)}] }
	    grep { $_->{label} } @rows;
	for (@memory) {
		my ($name, @figures) = split /[\t\n]/;
		push @points, ['memory', $name =~ /^projcalc, (.*)/ ? ('ours', $1) :
		    drawn($name), @figures];
	}
	spew('points.tsv', map { join("\t", @$_) . "\n" } @points);
}

spew('scene.json', '{
  "convention": "d3d",
  "camera":     {"eye": [1, 2, -5], "at": [0.125, 0.25, 0.375]},
  "projection": {"type": "persp", "fovy": 60, "near": 1, "far": 10},
  "viewport":   {"width": 640, "height": 480}
}
');
spew('far.json', '{
  "convention": "d3d",
  "camera":     {"eye": [210000, 30000, 700000], "at": [0, 0, 0]},
  "projection": {"type": "persp", "fovy": 2, "near": 6e5, "far": 9e5},
  "viewport":   {"width": 640, "height": 480}
}
');
spew('matrix', ask('projcalc project --matrix scene.json'));
make_inputs('all', $points, $copies);
make_inputs('few', $few, 1);
make_kinds('all');
make_mesh('all');
my @memory = split /^/, ask('peers');
our_rows();
my $python = their_rows(grep { !/^projcalc/ } map { s/\t.*\n//r } @memory);
measure_errors();
measure_times();
page($python, @memory);
draw(@memory);
ask('rm -rf all few image');
