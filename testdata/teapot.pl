#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Makes teapot.xyz and teapot.obj from the Bezier patches in teapot.patches. Each patch
# becomes a grid of 8 x 8 cells, and each cell a face, whose corners go
# counterclockwise as seen from outside. z of the patches points upward, and becomes y.
# A corner that several triangles share is one vertex.
# usage: teapot.pl, in any folder
use strict;
use warnings;
use FindBin;

my $cells = 8;
chdir $FindBin::Bin or die "$FindBin::Bin: $!\n";
open my $in, '<', 'teapot.patches' or die "teapot.patches: $!\n";
my (@control, @patch);
while (<$in>) {
	my ($kind, @number) = split;
	push @control, \@number if $kind eq 'v';
	push @patch, [@control[@number]] if $kind eq 'p';
}

# Returns the four weights of Bernstein's polynomials of degree 3 at t.
sub weights {
	my ($t) = @_;
	my $s = 1 - $t;
	return ($s ** 3, 3 * $s ** 2 * $t, 3 * $s * $t ** 2, $t ** 3);
}

my (@vertex, %index, @face);

# Returns the index of the vertex at row v and column u of a patch's grid.
sub vertex {
	my ($patch, $v, $u) = @_;
	my @row = weights($v / $cells);
	my @column = weights($u / $cells);
	my @at = (0, 0, 0);
	for my $i (0 .. 15) {
		$at[$_] += $row[int($i / 4)] * $column[$i % 4] *
		    $patch->[$i][$_] for 0 .. 2;
	}
	my $text = join ' ', map { sprintf('%.6f', $_) + 0 } $at[0], $at[2], -$at[1];
	$index{$text} //= push(@vertex, $text) - 1;
	return $index{$text};
}

for my $patch (@patch) {
	for my $v (0 .. $cells - 1) {
		for my $u (0 .. $cells - 1) {
			my ($a, $b, $c, $d) = map { vertex($patch, @$_) }
			    [$v, $u], [$v, $u + 1], [$v + 1, $u + 1], [$v + 1, $u];
			my %seen;
			my @corner = grep { !$seen{$_}++ } $a, $b, $c, $d;
			push @face, join ' ', map { $_ + 1 } @corner if @corner > 2;
		}
	}
}

my %lines = ('teapot.xyz' => \@vertex,
    'teapot.obj' => [(map { "v $_" } @vertex), map { "f $_" } @face]);
for my $name (sort keys %lines) {
	open my $out, '>', $name or die "$name: $!\n";
	print $out "# made by teapot.pl from Martin Newell's teapot\n",
	    map { "$_\n" } @{$lines{$name}};
	close $out or die "$name: $!\n";
}
