#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that teapot.pl makes teapot.xyz and teapot.obj of the patches, and that no two
# faces have the same edge in the same direction, so that all face outward.
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
    for qw(teapot.xyz teapot.obj);

my %edges;
for my $face (grep { s/^f // } split /\n/, slurp('testdata/teapot.obj')) {
	my @corner = split ' ', $face;
	$edges{"@corner[$_ - 1, $_]"}++ for 0 .. $#corner;
}
is(scalar(grep { $_ > 1 } values %edges), 0, 'faces face one way');
done_or('perl testdata/teapot.pl');
