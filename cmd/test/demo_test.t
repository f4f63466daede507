#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that the picture of README.md is the one that `make views` draws, and that the
# teapot of `make demo` is testdata/views/demo.txt on a terminal of 80 columns.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

my %drawn = (
	'testdata/charts/views.svg' =>
	    'cat testdata/views/*.json | projcalc draw --scenes - testdata/teapot.obj',
	'testdata/views/demo.txt' =>
	    'projcalc draw --text testdata/demo.json testdata/teapot.obj',
);

for my $file (sort keys %drawn) {
	my ($status, $out, $said) = run($drawn{$file});
	is("$status$said", '0', $drawn{$file});
	ok($out eq slurp($file), "$file is as drawn");
	spew($file, $out) if $write;
}
done_or('make views; perl cmd/test/demo_test.t -w');
