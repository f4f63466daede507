#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that gcc and clang compile everything without a warning: one of them has made
# BUILD, where `make test` makes warnings of what it compiles errors, and the other one
# compiles here. Its program has the same bits, and prints subnormals also if it is
# linked with -ffast-math. Both programs are hardened.
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

sub hardened {
	my ($program) = @_;
	my $elf = `readelf -hldW --dyn-syms $program`;
	like($elf, $_->[1], "$_->[0] of $program") for
	    ['PIE', qr/^  Type: +DYN /m], ['RELRO', qr/^  GNU_RELRO /m],
	    ['bound at the start', qr/FLAGS_1.* NOW/],
	    ['stack protector', qr/__stack_chk_fail/],
	    ['FORTIFY', qr/__memcpy_chk/];
}

# A program that is linked with -ffast-math starts in a mode of the processor in
# which subnormals are 0.
sub keeps_subnormals {
	my ($make, $build) = @_;
	unlink "$build/projcalc" or die "$build/projcalc: $!\n";
	succeeds("$make $build/projcalc LDFLAGS=-ffast-math", 'link with -ffast-math');
	my $scene = '{"camera": {"eye": [0,0,0], "gaze": [0,0,1]}}';
	for my $precision (qw(exact double)) {
		is(scalar(`printf '5e-324 1e-310 1\n%.0s' 1 2 3 |
		    $build/projcalc project -q -j2 -p $precision --to view '$scene'`),
		    "5e-324 1e-310 1\n" x 3, "subnormals, $precision");
	}
	unlink "$build/projcalc";
	succeeds("$make $build/projcalc", 'link again');
}

SKIP: {
	skip 'BUILD has flags of its own', 5 if !$ENV{OWN_FLAGS};
	hardened("$build/projcalc");
}
my $made_by = `readelf -p .comment $build/projcalc` =~ /clang/ ? 'clang' : 'gcc';
for my $cc (grep { $_ ne $made_by } sort keys %compilers) {
	my ($cxx, $other) = ($compilers{$cc}, "$build/$cc");
	SKIP: {
		skip "no $cc", 12 if missing($cc, $cxx);
		my $make = "make -sj2 BUILD=$other CC=$cc CXX=$cxx " .
		    'CFLAGS=-O2 CXXFLAGS=-O2 WERROR=1';
		# Optimization finds more to warn of only in gcc, but for frames, whose
		# limit tests do not have.
		my $tests = $cc eq 'clang' ? 'CPPFLAGS=-fsyntax-only' : '';
		succeeds("$make all", "build with $cc");
		succeeds("$make $tests compiled_tests", "compile the tests with $cc");
		succeeds("$^X cmd/test/bits_test.t $other", "bits with $cc");
		hardened("$other/projcalc");
		keeps_subnormals($make, $other);
	}
}
done_testing();
