#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# gcc and clang build everything without a warning, and what clang builds
# prints the same bytes: the transcripts are of the program in build.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

my %compilers = (gcc => 'g++', clang => 'clang++');

sub succeeds {
	my ($command, $name) = @_;
	my $said = `$command 2>&1`;
	is($?, 0, $name) or diag($said =~ s/^ok .*\n//mgr);
}

for my $cc (sort keys %compilers) {
	my ($cxx, $build) = ($compilers{$cc}, "$build/$cc");
	SKIP: {
		skip "no $cc", 3 if missing($cc, $cxx);
		succeeds("make -sj2 programs BUILD=$build CC=$cc CXX=$cxx " .
		    'WERROR=1', "build with $cc");
		succeeds("$^X cmd/test/transcripts_test.t $build",
		    "transcripts with $cc");
		succeeds("$^X cmd/test/bits_test.t $build",
		    "the same bits with $cc");
	}
}
done_testing();
