#!/usr/bin/perl
# The house: includes go downward only, core doesn't talk, files and functions
# are short. Each file of the program has a floor.
use strict;
use warnings;
use File::Basename;

my @floors = (
	[qw(core/dd)],
	[qw(core/expansion core/trig core/mat)],
	[qw(core/camera core/projection core/window)],
	[qw(core/scene core/taxonomy core/depth)],
	[qw(core/kernel core/kernel_exact core/kernel_plain core/kernel_copy
	    core/kernels core/kernels_baseline core/kernels_avx2
	    core/kernels_avx512 core/points core/carry core/frustum core/error_bound)],
	[qw(core/bounds core/gaze core/fit)],
	# numbers, words, messages
	[qw(cmd/number cmd/nearest cmd/show cmd/split cmd/talk cmd/page)],
	# JSON, and lines of points
	[qw(cmd/syntax cmd/value cmd/fields cmd/readers cmd/members
	    cmd/projection_member cmd/json cmd/json_line cmd/foreign
	    cmd/record cmd/record_read cmd/record_write)],
	[qw(cmd/progress)],
	[qw(cmd/chunk cmd/binary cmd/stream)],
	[qw(cmd/command cmd/input cmd/print_scene cmd/options)],
	[qw(cmd/matrix cmd/project cmd/pick cmd/fit cmd/inspect)],
	[qw(cmd/main)],
);
my %floor = map { my $i = $_; map { $_ => $i } @{$floors[$i]} } 0 .. $#floors;

chdir dirname($0) . '/../..' or die "$0: $!\n";
my $n = 0;
my $failed = 0;

sub check {
	my ($name, @faults) = @_;
	printf "%s %d - %s\n", @faults ? 'not ok' : 'ok', ++$n, $name;
	$failed += @faults > 0;
	print map { "# $_\n" } @faults;
}

sub slurp {
	open my $file, '<', $_[0] or die "$_[0]: $!\n";
	local $/;
	return <$file>;
}

# core/mat.c and core/mat.h are both core/mat.
sub part {
	return $_[0] =~ s/\.\w+$//r;
}

delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES)};
my @files = glob 'core/*.[ch] cmd/*.[ch] cmd/*.cc';
my %text = map { $_ => slurp($_) } @files;
my @sources = split ' ', `make -s sources`;
my %in_program = map { part($_) => 1 } @sources;

sub includes {
	my ($file) = @_;
	return map {
		my $name = dirname($file) . "/$_";
		1 while $name =~ s{\w+/\.\./}{};
		$name;
	} $text{$file} =~ /^#include "(.*)"/mg;
}

# The program is its sources and what they include; the rest is for tests.
my (%uses, @rings);

sub visit {
	my ($file, @way) = @_;
	if (grep { $_ eq $file } @way) {
		push @rings, join ' -> ', @way, $file;
		return;
	}
	return if $uses{$file};
	$uses{$file} = [includes($file)];
	visit($_, @way, $file) for @{$uses{$file}};
}

visit($_) for @sources;
check('includes go round in no ring', @rings);

my (@unknown, @upward, @tests, @talks, @cjson);
for my $file (sort keys %uses) {
	my $part = part($file);
	push @unknown, "$file: which floor? say it in cmd/layers_test.t"
	    unless exists $floor{$part};
	push @tests, $file if !$in_program{$part} && -e "$part.c";
	for my $other (@{$uses{$file}}) {
		my ($up, $down) = map { $floor{part($_)} // 0 } $other, $file;
		push @upward, "$file, floor $down, includes $other, $up"
		    if $up > $down;
	}
	push @talks, "$file includes <$1>"
	    if $file =~ /^core/ && $text{$file} =~
	    /^#include <(stdio\.h|stdlib\.h|unistd\.h|cjson.*)>/m;
	push @cjson, $file if $text{$file} =~ /^#include <cjson/m;
}
check('every file has a floor', @unknown);
check('includes go downward', @upward);
check('the program includes nothing of the tests', @tests);
check('core neither prints nor allocates nor exits', @talks);
check('one file knows cJSON', @cjson > 1 ? "@cjson" : ());

# Lines from the name to the closing brace, and the longest function's name.
sub functions {
	my ($file) = @_;
	my @lines = split /^/, $text{$file};
	my ($start, @found) = (0);
	for my $i (0 .. $#lines) {
		$start = $i if $lines[$i] =~ /^\w[^#;]*\(/ &&
		    $lines[$i] !~ /;\s*$/ && $lines[$i] !~ /^(?:enum|struct)\b[^(]*\{/;
		push @found, [$i - $start, $file . ':' . ($start + 1)]
		    if $lines[$i] eq "}\n" && $start > 0;
		$start = 0 if $lines[$i] =~ /^}/;
	}
	return @found;
}

my @functions = sort { $a->[0] <=> $b->[0] } map { functions($_) }
    grep { !/\.h$/ } @files;
my $median = $functions[$#functions / 2][0];

check("the median of " . @functions . " functions is $median lines",
    $median < 15 ? () : 'under 15 is wanted');
check('no function is over 60 lines',
    map { "$_->[1]: $_->[0] lines" } grep { $_->[0] > 60 } @functions);
check('no file is over 350 lines', map {
	my $lines = $text{$_} =~ tr/\n//;
	$lines > (/_test\.c$/ ? 400 : 350) ? "$_: $lines lines" : ();
} @files);
print "1..$n\n";
exit($failed > 0);
