# SPDX-License-Identifier: MIT
# For each panel of bench.gp, of points.tsv in DATA: where the points' names stand
# so that they meet neither points nor each other, and the ranges of its axes.
# usage: names.pl DATA
use strict;
use warnings;
use List::Util qw(max min first);

# In pixels: the panel inside its axes, a letter, and how high a line is.
my ($width, $height, $letter, $line) = (690, 240, 7.4, 14);
my ($low, $high) = (1e-16, 10);
my @steps = map { my $e = $_; map { $_ * 10 ** $e } 1, 2, 5 } -3 .. 5;

sub meet {
	my ($a, $b) = @_;
	return $a->[0] < $b->[2] && $a->[2] > $b->[0] &&
	    $a->[1] < $b->[3] && $a->[3] > $b->[1];
}

# Points of a kind that lie close together share a name.
sub groups {
	my @groups;
	for my $p (@_) {
		my $near = first {
			my $group = $_;
			first { $_->{kind} eq $p->{kind} &&
			    abs($_->{x} - $p->{x}) < 16 &&
			    abs($_->{y} - $p->{y}) < 5 } @$group
		} @groups;
		push @groups, $near = [] unless $near;
		push @$near, $p;
	}
	return @groups;
}

# The best place for the name of a group, beside, above or below it.
sub place {
	my ($group, $boxes) = @_;
	my $name = join ', ', map { $_->{label} } @$group;
	my $w = $letter * length $name;
	my @x = sort { $a <=> $b } map { $_->{x} } @$group;
	my @place = (1e9);
	for my $up (0, 0.75, -0.75, 1.2, -1.2, 2, -2, 3, -3, 4, -4) {
		for my $side (1, -1, 0) {
			next if $side == 0 && abs($up) < 1;
			my $x = $side > 0 ? $x[-1] + 9 :
			    $side < 0 ? $x[0] - 9 - $w :
			    ($x[0] + $x[-1] - $w) / 2;
			my $y = $group->[0]{y} + ($up - 0.5) * $line;
			my $box = [$x, $y, $x + $w, $y + $line];
			my $out = $x < 2 || $y < 2 || $box->[2] > $width - 2 ||
			    $box->[3] > $height - 2;
			my $cost = abs($up) + ($side < 0) / 10 + 1e4 * $out +
			    1e3 * grep { meet($box, $_) } @$boxes;
			@place = ($cost, $box, $side) if $cost < $place[0];
		}
	}
	my (undef, $box, $side) = @place;
	push @$boxes, $box;
	return [$name, $box->[0] + $w * (1 - $side) / 2, $box->[1] + $line / 2,
	    $side];
}

# And for that of the line of nearest doubles.
sub place_half {
	my ($y, $boxes) = @_;
	my $name = 'half a unit in the last place';
	my $w = $letter * length $name;
	my @free = grep {
		my $box = [$_, $y - $line - 2, $_ + $w, $y - 2];
		!grep { meet($box, $_) } @$boxes
	} map { $width - $w - 5 * $_ } 0 .. ($width - $w) / 5;
	return [$name, ($free[0] // $width - $w), $y - $line / 2 - 2, 1];
}

sub panel {
	my ($name, @points) = @_;
	my @times = map { $_->[2] } @points;
	my $left = max(grep { $_ < 0.85 * min(@times) } @steps);
	my $right = min(grep { $_ > 1.15 * max(@times) } @steps);
	my $across = $width / log($right / $left);
	my $up = $height / log($high / $low);
	my $y_of = sub { $up * log(min(max($_[0], $low), $high) / $low) };

	my (@at, @boxes);
	for (@points) {
		my ($kind, $label, $time, $error, $far) = @$_;
		my ($x, $y) = ($across * log($time / $left), $y_of->($error));
		push @at, {kind => $kind, label => $label, x => $x, y => $y};
		push @boxes, [$x - 6, $y - 6, $x + 6, $y + 6],
		    [$x - 4, $y, $x + 4, $y_of->($far)];
	}
	open my $out, '>', "$name.tsv" or die "$name.tsv: $!\n";
	print $out join("\t", @$_[0, 2 .. 4]) . "\n" for @points;
	print $out "\n\n";
	for ((map { place($_, \@boxes) } groups(@at)),
	    place_half($y_of->(2 ** -44), \@boxes)) {
		my ($label, $x, $y, $side) = @$_;
		print $out join("\t", $label, $left * exp($x / $across),
		    $low * exp($y / $up), $side) . "\n";
	}
	open my $axes, '>', "$name.gp" or die "$name.gp: $!\n";
	print $axes "set xrange [$left * 0.999:$right * 1.001]\n",
	    "set yrange [$low:$high]\n",
	    'set xtics (' . join(', ', @steps) . ")\n";
}

chdir $ARGV[0] or die "$ARGV[0]: $!\n";
my %panel;
open my $in, '<', 'points.tsv' or die "points.tsv: $!\n";
while (<$in>) {
	chomp;
	my ($name, $kind, $label, $time, $error, $far) = split /\t/;
	$far = $error if !$far || $far eq '-';
	push @{$panel{$name}}, [$kind, $label, $time, $error, $far];
}
panel($_, @{$panel{$_}}) for keys %panel;
