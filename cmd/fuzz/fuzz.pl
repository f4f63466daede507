#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Runs each fuzzer for its share of the time. It starts from the inputs of testdata and
# from those that earlier runs have kept. Findings are in BUILD/finding-*; make each a
# case of a transcript.
# usage: fuzz.pl BUILD SECONDS FUZZER...
use strict;
use warnings;
use File::Basename;
use File::Path 'make_path';
use FindBin;
use lib "$FindBin::Bin/../test";
use Projcalc;
use Transcript;

my ($seconds, @fuzzers) = @ARGV;

sub seed {
	my ($fuzzer, $name, $text) = @_;
	make_path("$build/corpus/fuzz_$fuzzer");
	spew("$build/corpus/fuzz_$fuzzer/seed-" . $name =~ tr{/}{-}r, $text);
}

# The numbers of the formats. The first byte that layout.h reads is the number of the
# input's format plus that of the output's, times the number of formats.
my @formats = map { lc } slurp('cmd/table/format.h') =~ /^\tFORMAT_(\w+),/mg;
my %number = map { $formats[$_] => $_ } 0 .. $#formats;

sub seed_lines {
	my ($name, $in, $text) = @_;
	for my $fuzzer (qw(line stream)) {
		for my $out ($in, 'json') {
			my $both = $number{$in} + @formats * $number{$out};
			seed($fuzzer, $out eq $in ? $name : "$name-json",
			    pack('C4', $both, 0, 0, 0) . $text);
		}
		seed($fuzzer, "$name-more", pack('C4',
		    $number{$in} * (1 + @formats), 0, 0, 64) . $text);
	}
	# as runs: the parts of --lines, and with names
	seed('stream', "$name-runs-$_", pack('C4', $number{$in}, 0, 0, $_) . $text)
	    for 128, 192;
}

for my $case (map { transcript($_) } glob 'testdata/transcripts/*.txt') {
	my ($name, $command) = @$case{qw(name command)};
	my $format = $command =~ /-i (\w+)/ && exists $number{$1} ? $1 : 'text';
	my $input = input($command);
	seed_lines($name, $format, $input) if $input ne '';
	seed('document', $name, "\0$1") if $command =~ /'(\{.*?\})'/s;
	seed('number', $name, $1) if $command =~ /(-?\d+\.?\d*(e\S\d+)?)/;
}
seed('document', basename($_), "\0" . slurp($_)) for glob 'testdata/*.json';
for my $case (transcript('testdata/transcripts/draw.txt')) {
	seed('obj', "$case->{name}-$1", $2) while $case->{command} =~
	    /cat > (\w+)\.obj <<'END'\n(.*?)^END/msg;
}
seed('obj', 'box', join "\n", (map { 'v ' . join ' ', map { $_ / 9 } @$_ } [1, 1, 1],
    [8, 1, 2], [8, 8, 3], [1, 8, 2], [2, 2, 9], [7, 2, 9], [7, 7, 9]), 'f 1 2 3 4',
    'f 5//1 6 7/2', 'f 1 2 7 4 5', 'l 1 -1', "p 5 \\\n6", '');

my $failed = 0;
for my $path (@fuzzers) {
	my $name = basename($path);
	my $share = int($seconds / @fuzzers) || 1;
	make_path("$build/corpus/$name");
	my $said = `$path -max_total_time=$share -max_len=4096 \\
	    -timeout=10 -dict=testdata/fuzz/projcalc.dict \\
	    -artifact_prefix=$build/finding-$name- $build/corpus/$name 2>&1`;
	my $ok = $? == 0;
	print $ok ? $said =~ /^Done (.*)/m ? "$name: $1\n" : "$name: ok\n" :
	    "$said\n$name: failed\n";
	$failed++ if !$ok;
}
exit($failed > 0);
