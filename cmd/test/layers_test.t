#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks the structure of the sources: files include and call each other in layers
# without a ring, core only computes, only one file includes cJSON, functions have at
# most 60 lines, and lines at most 88 columns. The calls of a source are the undefined
# names of its object in BUILD. The picture of the folders in CONTRIBUTING is drawn from
# includes and calls.
# usage: layers_test.t [BUILD]
#        layers_test.t -w, which draws that picture anew
use strict;
use warnings;
use File::Basename;
use List::Util qw(max min sum uniq);

# The folders that the program does not need.
my $wing = qr{/(?:test|study|proof|bench|fuzz)/};

# The library functions that core may call: for arithmetic and bytes, and those that
# compilers insert.
my %computes = map { $_ => 1 } qw(atan2 copysign fabs floor fma fmaf fmax fmin
    __udivti3 fmod frexp hypot ldexp nextafter nextafterf rint sqrt
    memcmp memcpy memmove memset strcmp strlen
    __cpu_model __cpu_indicator_init __stack_chk_fail _GLOBAL_OFFSET_TABLE_);

chdir dirname($0) . '/../..' or die "$0: $!\n";
my $draw = @ARGV && $ARGV[0] eq '-w' && shift;
my $build = $ARGV[0] // $ENV{BUILD} // 'build';
my $n = 0;
my $failed = 0;

sub check {
	my ($name, @faults) = @_;
	printf "%s %d - %s\n", @faults ? 'not ok' : 'ok', ++$n, $name;
	$failed += @faults > 0;
	print map { "# $_\n" } sort @faults;
}

sub slurp {
	open my $file, '<', $_[0] or die "$_[0]: $!\n";
	local $/;
	return <$file>;
}

my %text = map { $_ => slurp($_) }
    grep { -e } glob '{core,cmd}/{,*/,*/*/}*.{c,cc,h}';

# $needs{A}{B} says why file A needs file B: "included", or names that B defines.
my %needs = map { $_ => {} } keys %text;

for my $file (keys %text) {
	for my $name ($text{$file} =~ /^#include "(.*)"/mg) {
		my $path = dirname($file) . "/$name";
		1 while $path =~ s{\w+/\.\./}{};
		$needs{$file}{$path}{included} = 1;
	}
}

# The names that objects define, and those that they need. If a test defines a name of
# the program again, the program's is meant.
my (%home, %lacks);
my %source = map { "$build/" . s/\.\w+$/.o/r => $_ } grep { !/h$/ } keys %text;
for (`nm -APg @{[grep { -e } keys %source]} 2>/dev/null`) {
	my ($object, $name, $type) = /^(.*): (\S+) (\w)/ or next;
	my $file = $source{$object};
	if ($type =~ /[Uw]/) {
		push @{$lacks{$file}}, $name;
	} elsif (!$home{$name} || $file !~ $wing) {
		$home{$name} = $file;
	}
}
my $unseen = %home ? '' : " # SKIP nm sees no names in $build";
my (@talks, %cjson);
for my $file (keys %lacks) {
	for my $name (@{$lacks{$file}}) {
		$needs{$file}{$home{$name}}{$name} = 1 if $home{$name};
		next if $home{$name} || $file =~ $wing;
		push @talks, "$file calls $name" if $file =~ m{^core/} &&
		    !$computes{$name =~ s/^__(\w+)_chk$/$1/r};
		$cjson{$file} = 1 if $name =~ /^cJSON/;
	}
}

# The calls of inline functions and macros stand in their headers. A header may call the
# source of its own name. A test may have a global name that is static in the program.
for my $file (grep { /\.h$/ } keys %text) {
	my $code = $text{$file} =~ s{/\*.*?\*/}{}gsr;
	my @bodies = ($code =~ /^\{\n(.*?)^\}/msg,
	    $code =~ /^#define ((?:.*\\\n)*.*)/mg);
	for my $name (map { /\b(\w+)\(/g } @bodies) {
		my $home = $home{$name} // next;
		$needs{$file}{$home}{$name} = 1 if $home !~ $wing &&
		    $home =~ s/\.\w+$/.h/r ne $file;
	}
}

# Returns all files that a file needs, directly or not. In a ring, they include the file
# itself.
sub reach {
	my ($file, $seen) = @_;
	for (keys %{$needs{$file}}) {
		reach($_, $seen) unless $seen->{$_}++;
	}
	return $seen;
}

my %reach = map { $_ => reach($_, {}) } keys %needs;
my (@rings, @upward);
for my $file (keys %needs) {
	for my $other (keys %{$needs{$file}}) {
		my $tie = "$file -> $other: " .
		    join ' ', sort keys %{$needs{$file}{$other}};
		push @rings, $tie if $reach{$other}{$file};
		push @upward, $tie if $file =~ m{^core/} && $other =~ m{^cmd/} ||
		    $file !~ $wing && $other =~ $wing;
	}
}

# A file's floor is one above the highest floor of the files it needs.
my %floor;

sub floor {
	my ($file) = @_;
	return $floor{$file} //= 1 + max(-1, map { floor($_) }
	    grep { !$reach{$_}{$file} } keys %{$needs{$file}});
}

# Returns the folders of the program, with an arrow to each folder that a folder needs,
# unless other arrows lead there, too.
sub picture {
	my %below;
	for my $file (grep { !m{$wing} } keys %needs) {
		for my $other (grep { !m{$wing} } keys %{$needs{$file}}) {
			$below{dirname($file)}{dirname($other)} = 1
			    if dirname($file) ne dirname($other);
		}
	}
	my %all;
	my $descend;
	$descend = sub {
		my ($folder) = @_;
		return $all{$folder} //= {map { $_ => 1, %{$descend->($_)} }
		    keys %{$below{$folder}}};
	};
	$descend->($_) for keys %below;
	my $lines = '';
	for my $folder (sort keys %below) {
		for my $other (sort keys %{$below{$folder}}) {
			$lines .= "  $folder --> $other\n" unless
			    grep { $all{$_}{$other} } keys %{$below{$folder}};
		}
	}
	return "```mermaid\ngraph TD\n$lines```\n";
}

# Returns the functions of a file, with their lines from the name to the closing brace.
sub functions {
	my ($file) = @_;
	my ($line, $name, $body, @found) = (0, 0, 0);
	for (split /\n/, $text{$file}) {
		$line++;
		$name = $line if /^\w.*\(/;
		$body = 1 if /^{$/;
		push @found, [$line - $name + 1, "$file:$name"] if $body && /^}$/;
		$body = 0 if /^}/;
	}
	return @found;
}

# Returns the lines of a file that are wider than 88 columns, with tabs of 8.
sub wide_lines {
	my ($file) = @_;
	my ($line, @found) = 0;
	for (split /\n/, $text{$file}) {
		$line++;
		utf8::decode(my $shown = $_);
		1 while $shown =~ s/\t/' ' x (8 - $-[0] % 8)/e;
		push @found, "$file:$line: " . length($shown) . ' columns'
		    if length $shown > 88;
	}
	return @found;
}

my @functions = sort { $a->[0] <=> $b->[0] } map { functions($_) } keys %text;
my $median = $functions[$#functions / 2][0];

check("includes and calls go round in no ring$unseen", @rings);
check('core needs nothing of cmd, the program nothing that tests it', @upward);
check("core neither prints nor allocates nor exits$unseen", @talks);
check("one file knows cJSON$unseen", %cjson > 1 ? keys %cjson : ());
check("the median of " . @functions . " functions is $median lines",
    $median < 15 ? () : 'under 15 is wanted');
check('no function is over 60 lines',
    map { "$_->[1]: $_->[0] lines" } grep { $_->[0] > 60 } @functions);
check('no line is over 88 columns, also where clang-format is off',
    map { wide_lines($_) } keys %text);

my $tour = '.github/CONTRIBUTING.md';
my $picture = picture();
my ($drawn) = slurp($tour) =~ /^(```mermaid\n.*?^```\n)/ms;
if ($draw) {
	my $text = slurp($tour) =~ s/^```mermaid\n.*?^```\n/$picture/msr;
	open my $file, '>', $tour or die "$tour: $!\n";
	print $file $text;
	close $file or die "$tour: $!\n";
	exit;
}
check("the picture in $tour is that of the code", $drawn eq $picture ? () :
    'perl cmd/test/layers_test.t -w draws it; read the diff');

for my $room (sort { $a cmp $b } uniq(map { dirname($_) } keys %text)) {
	my @files = grep { dirname($_) eq $room } keys %text;
	my @floors = map { floor($_) } @files;
	printf "# %-14s %3d files %5d lines, floors %d to %d\n", $room,
	    scalar @files, sum(map { tr/\n// } @text{@files}), min(@floors),
	    max(@floors);
}
print "1..$n\n";
exit($failed > 0);
