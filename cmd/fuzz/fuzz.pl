#!/usr/bin/perl
# Runs each fuzzer for its share of the time, from what testdata holds and what
# earlier runs found worth keeping. What one finds stands in BUILD/finding-*:
# make it a golden case.
# usage: fuzz.pl BUILD SECONDS FUZZER...
use strict;
use warnings;
use File::Basename;
use File::Path 'make_path';

my ($build, $seconds, @fuzzers) = @ARGV;

sub slurp {
	open my $file, '<:raw', $_[0] or return '';
	local $/;
	return <$file> // '';
}

sub seed {
	my ($fuzzer, $name, $text) = @_;
	make_path("$build/corpus/$fuzzer");
	open my $file, '>:raw', "$build/corpus/$fuzzer/seed-$name"
	    or die "$build/corpus/$fuzzer: $!\n";
	print $file $text;
}

# The first byte of layout.h: the same format in and out.
my %formats = (text => 0, csv => 6, json => 12, f64 => 18, f32 => 24);

sub seed_lines {
	my ($name, $format, $text) = @_;
	for my $fuzzer (qw(line stream)) {
		seed($fuzzer, $name, pack('C4', $format, 0, 0, 1) . $text);
		seed($fuzzer, "$name-json", pack('C4', $format / 6 + 10, 0, 0,
		    1) . $text);
	}
}

for my $case (glob 'testdata/golden/*/') {
	my ($name, $cmd) = (basename($case), slurp("$case/cmd"));
	my $format = $cmd =~ /-i (\w+)/ && $formats{$1} || 0;
	seed_lines($name, $format, slurp("$case/in")) if -s "$case/in";
	seed_lines("$name-cmd", $format, $1 =~ s/\\n/\n/gr)
	    if $cmd =~ /printf '([^']*)'/;
	seed('document', $name, "\0$1") if $cmd =~ /'(\{.*?\})'/s;
	seed('number', $name, $1) if $cmd =~ /(-?\d+\.?\d*(e\S\d+)?)/;
}
seed('document', basename($_), "\0" . slurp($_)) for glob 'testdata/*.json';

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
