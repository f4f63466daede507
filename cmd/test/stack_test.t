#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that streams of every format give through threads and with the stack limit of
# the tests what they give without.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

plan skip_all => 'no limit for a script or with a sanitizer' if !stack_limit();
# Ordinary points, and some that the fast loops leave to slower code: far away, or no
# points.
my $number = sub {
	(below(4001) - 2000) / pick(7, 100, 100, 1024) .
	    (below(200) ? '' : pick('e120', 'e-120', 'e9'))
};
my @points = map { join(' ', map { $number->() } 1 .. 4) . "\n" } 1 .. 9000;
spew("$tmp/text", join '', map { below(999) ? $_ : "bad\n" } @points);
spew("$tmp/csv", join '', map { tr/ /,/r } @points);
spew("$tmp/json", join '', map { tr/ /,/r =~ s/^(.*)$/[$1,"a"]/r } @points);
spew("$tmp/f64", pack 'd<*', map { split } @points);
spew("$tmp/f32", pack 'f<*', map { split } @points);

my @options = ('', '-p double', '-p single', '--flags',
    '--visible', '-H', '-H -p single', '--ray', '--from clip', '--to view',
    '-d 3', '--digits 20');
my @runs = map {
	my $in = $_;
	(map { "project -i $in $_ scene.json $tmp/$in" } @options),
	    (map { "project -i $in -o $_ scene.json $tmp/$in" }
	    qw(text csv json f64 f32)),
	    "trace -i $in scene.json $tmp/$in", "fit -i $in full.json $tmp/$in",
	    "pick -i $in --at 320,240 --radius 99 scene.json $tmp/$in"
} qw(text csv json f64 f32);
for my $run (@runs) {
	my @want = run("(projcalc $run --keep-going -j 1)", 'testdata'); # without the limit
	my @small = run("projcalc $run --keep-going -j 3", 'testdata');
	is_deeply(\@small, \@want, $run =~ s/ \S*testdata\S*| \Q$tmp\E\S*//gr);
}
done_testing();
