#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that teapot.pl makes teapot.xyz and teapot.faces of the patches, and that no two
# triangles have the same edge in the same direction, so that all face outward.
use strict;
use warnings;
use File::Copy;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

copy("testdata/$_", "$tmp/$_") or die "$_: $!\n" for qw(teapot.pl teapot.patches);
my ($status, undef, $said) = run("perl $tmp/teapot.pl");
is("$status$said", '0', 'teapot.pl');
ok(slurp("$tmp/$_") eq slurp("testdata/$_"), "$_ is made anew")
    for qw(teapot.xyz teapot.faces);

my %edges;
for my $face (grep { !/^#/ } split /\n/, slurp('testdata/teapot.faces')) {
	my ($a, $b, $c) = split ' ', $face;
	$edges{$_}++ for "$a $b", "$b $c", "$c $a";
}
is(scalar(grep { $_ > 1 } values %edges), 0, 'triangles face one way');
done_or('perl testdata/teapot.pl');
