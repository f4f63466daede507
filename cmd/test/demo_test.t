#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that the drawing in README.md is the one that views.sh draws, that no corner of
# a triangle is within 10 pixels of the edge of its view, and that `make demo` prints
# testdata/views/demo.txt.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

my ($status, undef, $said) = run("sh cmd/demo/views.sh '$build' '$tmp/views.svg'");
is("$status$said", '0', 'views.sh');
my $svg = slurp("$tmp/views.svg");
ok($svg eq slurp('testdata/charts/views.svg'), 'make views has been run');

# Views of 320 x 240 pixels, in tenths of a pixel; corners after the first are
# relative to the one before.
my (%triangles, @near);
while ($svg =~ /d="M(\d+) (\d+)l(-?\d+) (-?\d+) (-?\d+) (-?\d+)z"/g) {
	my ($x, $y) = ($1, $2);
	my $view = int($x / 3200) . int($y / 2400);
	$triangles{$view}++;
	for ([0, 0], [$3, $4], [$5, $6]) {
		$x += $_->[0];
		$y += $_->[1];
		my ($right, $down) = ($x - 3200 * substr($view, 0, 1),
		    $y - 2400 * substr($view, 1));
		push @near, "$x $y" if $right < 100 || $right > 3100 ||
		    $down < 100 || $down > 2300;
	}
}
is(sorted(keys %triangles), '00 01 10 11', 'four views');
is("@near", '', 'none is cut, nor near an edge');

is((run("sh cmd/demo/demo.sh '$build'"))[1], slurp('testdata/views/demo.txt'),
    'make demo');
done_or('make views; sh cmd/demo/demo.sh build >testdata/views/demo.txt');
