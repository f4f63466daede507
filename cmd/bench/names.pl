# SPDX-License-Identifier: MIT
# Places the names of the points of points.tsv in DATA in each panel of speed.gp. Each
# name is as near to its points as can be, and does not meet points, other names and
# their lines. A name that is not beside its points has a line to them.
# usage: names.pl DATA
use strict;
use warnings;
use List::Util qw(first max min shuffle sum0);

# In pixels: the width and height of a panel inside its axes, the width of a letter, the
# height of a line of text, and the distance from its points beyond which a name has a
# line to them.
my ($width, $height, $letter, $line, $apart) = (690, 260, 6.9, 14, 12);
my ($low, $high) = (1e-15, 1e-2);
my $half = 2 ** -44;
my @steps = map { my $e = $_; map { $_ * 10 ** $e } 1, 2, 5 } -3 .. 5;

# Returns whether two boxes, [left, bottom, right, top], overlap.
sub meet {
	my ($a, $b) = @_;
	return ($a->[0] < $b->[2] && $a->[2] > $b->[0] &&
	    $a->[1] < $b->[3] && $a->[3] > $b->[1]) || 0;
}

# Returns the shortest line between two boxes, as x, y, x, y of its ends.
sub way {
	my ($a, $b) = @_;
	my @ends = map {
		my ($low, $high) = (max($a->[$_], $b->[$_]),
		    min($a->[$_ + 2], $b->[$_ + 2]));
		$low <= $high ? [($low + $high) / 2, ($low + $high) / 2] :
		    $a->[$_] > $b->[$_] ? [$low, $high] : [$high, $low]
	} 0, 1;
	return ($ends[0][0], $ends[1][0], $ends[0][1], $ends[1][1]);
}

sub far {
	my ($x, $y, $x2, $y2) = way(@_);
	return sqrt(($x - $x2) ** 2 + ($y - $y2) ** 2);
}

# Returns whether a line passes through a box.
sub passes {
	my ($x, $y, $x2, $y2, $box) = @_;
	return scalar grep {
		my ($px, $py) = ($x + ($x2 - $x) * $_ / 16,
		    $y + ($y2 - $y) * $_ / 16);
		meet($box, [$px, $py, $px, $py])
	} 0 .. 16;
}

# Returns the points in groups: points of the same kind that overlap share a name.
sub groups {
	my @groups;
	for my $p (sort { $a->{x} <=> $b->{x} } @_) {
		my $near = first {
			my $q = $_->[-1];
			$q->{kind} eq $p->{kind} &&
			    abs($q->{x} - $p->{x}) < 9 &&
			    abs($q->{y} - $p->{y}) < 9
		} @groups;
		push @groups, $near = [] unless $near;
		push @$near, $p;
	}
	return map { {
		points => $_,
		name => join(', ', map { $_->{label} } @$_),
		kind => $_->[0]{kind},
		at => [$_->[0]{x} - 5, min(map { $_->{y} } @$_) - 5,
		    $_->[-1]{x} + 5, max(map { $_->{y} } @$_) + 5]
	} } @groups;
}

# Returns the cost of a box for a name that is $far from its points. It costs more if
# the name has a line, or is nearer to other points.
sub cost {
	my ($box, $line, $far, @others) = @_;
	my $cost = $far + ($line ? 20 : 0);
	for my $point (@others) {
		my $near = $far + 12 - far($box, $point);
		$cost += 2 * $near if $near > 0;
		$cost += 1e4 if meet($box, $point);
		$cost += 500 if $line && passes(@$line, $point);
	}
	return $cost;
}

# Returns the places above $floor that the name of a group may have, the best first. A
# place is a box, a line if the box is apart from the points, and a cost.
sub places {
	my ($group, $floor, @boxes) = @_;
	my @at = @{$group->{at}};
	my $w = $letter * length $group->{name};
	my @x = ($at[2] + 4, $at[0] - 4 - $w,
	    map { ($at[0] + $at[2] - $w) / 2 + 15 * $_ } -12 .. 12);
	my @others = grep { !meet($_, \@at) } @boxes;
	my @places;
	for my $y (map { ($at[1] + $at[3] - $line) / 2 + 5 * $_ } -16 .. 16) {
		next if $y < $floor || $y + $line > $height;
		for my $x (grep { $_ > 0 && $_ + $w < $width } @x) {
			my $box = [$x, $y, $x + $w, $y + $line];
			my $far = far($box, \@at);
			my $line = $far > $apart ? [way($box, \@at)] : undef;
			next if meet($box, \@at);
			push @places, {box => $box, line => $line,
			    cost => cost($box, $line, $far, @others)};
		}
	}
	return sort { $a->{cost} <=> $b->{cost} } @places;
}

# Returns what it costs that a place meets other names and their lines.
sub trouble {
	my ($place, @others) = @_;
	my ($box, $line) = @$place{qw(box line)};
	my $wide = [$box->[0] - 8, $box->[1], $box->[2] + 8, $box->[3]];
	return sum0(map {
		1e4 * meet($wide, $_->{box}) +
		    500 * ($_->{line} && passes(@{$_->{line}}, $box) ||
		    $line && passes(@$line, $_->{box}) || 0)
	} @others);
}

# Places the names one after another, and then each once more, now that the others have
# a place. Returns the cost of all places.
sub place {
	my @groups = @_;
	delete @$_{qw(box line cost)} for @groups;
	for my $group ((@groups) x 3) {
		my @others = grep { $_ != $group && $_->{box} } @groups;
		$group->{cost} = 9e99;
		for my $place (@{$group->{places}}) {
			last if $place->{cost} >= $group->{cost};
			my $cost = $place->{cost} +
			    trouble($place, @others);
			@$group{qw(box line cost)} =
			    (@$place{qw(box line)}, $cost)
			    if $cost < $group->{cost};
		}
	}
	return sum0(map { $_->{cost} } @groups);
}

sub panel {
	my ($name, @points) = @_;
	my @times = map { $_->[2] } @points;
	my $left = max(grep { $_ < 0.85 * min(@times) } @steps);
	my $right = min(grep { $_ > 1.15 * max(@times) } @steps);
	my $across = $width / log($right / $left);
	my $up = $height / log($high / $low);
	my $y_of = sub { $up * log(min(max($_[0], $low), $high) / $low) };
	my $place_of = sub { ($left * exp($_[0] / $across),
	    $low * exp($_[1] / $up)) };

	my (@at, @boxes);
	for (@points) {
		my ($kind, $label, $time, $error, $far) = @$_;
		my ($x, $y) = ($across * log($time / $left), $y_of->($error));
		push @at, {kind => $kind, label => $label, x => $x, y => $y};
		push @boxes, [$x - 5, $y - 5, $x + 5, $y + 5],
		    [$x - 4, $y, $x + 4, $y_of->($far) + 5];
	}
	my @groups = groups(@at);
	$_->{places} = [places($_, $y_of->($half) + 1, @boxes)] for @groups;
	# Places the names in several orders, and keeps the best.
	my @orders = sort { $a->[0] <=> $b->[0] } map {
		my @order = shuffle(@groups);
		[place(@order), @order]
	} 1 .. 30;
	place(@{$orders[0]}[1 .. @groups]);

	open my $out, '>', "$name.tsv" or die "$name.tsv: $!\n";
	print $out join("\t", @$_[0, 2 .. 4]) . "\n" for @points;
	print $out "\n\n";
	for (@groups) {
		my @box = @{$_->{box}};
		print $out join("\t", $_->{kind}, $_->{name} =~ s/_/\\\\_/gr, $place_of->(
		    ($box[0] + $box[2]) / 2, ($box[1] + $box[3]) / 2)) . "\n";
	}
	open my $axes, '>', "$name.gp" or die "$name.gp: $!\n";
	print $axes "set xrange [$left * 0.999:$right * 1.001]\n",
	    "set yrange [$low:$high]\n",
	    'set xtics (' . join(', ', @steps) . ")\n";
	print $axes 'set arrow from ', join(', ', $place_of->(@$_[0, 1])),
	    ' to ', join(', ', $place_of->(@$_[2, 3])),
	    " nohead linestyle 5\n" for grep { $_ } map { $_->{line} } @groups;
}

srand 1;
chdir $ARGV[0] or die "$ARGV[0]: $!\n";
my %panel;
open my $in, '<', 'points.tsv' or die "points.tsv: $!\n";
while (<$in>) {
	chomp;
	my ($name, $kind, $label, $time, $error, $far) = split /\t/;
	$far = $error if !$far || $far eq '-';
	push @{$panel{$name}}, [$kind, $label, $time, $error, $far];
}
panel($_, @{$panel{$_}}) for sort keys %panel;
