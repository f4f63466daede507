#!/usr/bin/perl
# gcc and clang build everything without a warning, and what clang builds
# prints the same bytes: the golden cases are those of the program in build.
use strict;
use warnings;
use File::Basename;

chdir dirname($0) . '/../..' or die "$0: $!\n";
# What the make above was told is no business of the ones below.
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES)};

my %compilers = (gcc => 'g++', clang => 'clang++');

sub check {
	my ($ok, $name, $report) = @_;
	print $ok ? 'ok' : 'not ok', " - $name\n";
	print $report =~ s/^/# /mgr if !$ok;
}

print '1..', 3 * keys %compilers, "\n";
for my $cc (sort keys %compilers) {
	my $build = "build/$cc";
	my $cxx = $compilers{$cc};
	if (system("command -v $cc $cxx >/dev/null") != 0) {
		print "ok - $_ # SKIP no $cc\n" for "build with $cc",
		    'golden cases', 'the same bits';
		next;
	}
	my $said = `make -sj2 programs BUILD=$build CC=$cc CXX=$cxx WERROR=1 2>&1`;
	check($? == 0, "build with $cc", $said);
	$said = `$^X cmd/test/golden_test.t $build 2>&1`;
	check($? == 0, "golden cases with $cc", $said =~ s/^ok .*\n//mgr);
	$said = `$^X cmd/test/bits_test.t $build 2>&1`;
	check($? == 0, "the same bits with $cc", $said =~ s/^ok .*\n//mgr);
}
