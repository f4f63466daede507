#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Compares what draw draws of random scenes with an oracle: along each edge, a ray from
# the eye to a point tells whether a face is in front of the point. Points for which the
# answer hangs on less than a margin are left out. The scenes have triangles, boxes that
# overlap in a circle or pass through each other, concave faces and lines, all of which
# may leave the view volume. Each drawn segment must be a part of an edge or a cut, and
# each part must be drawn once.
use strict;
use warnings;
use FindBin;
use List::Util qw(max min sum);
use lib $FindBin::Bin;
use Projcalc;

my ($width, $height, $near, $far) = (640, 480, 1.5, 12);
my $focal = 300;      # of the perspective, in pixels
my $scale = 60;       # of the orthographic projection, pixels for a unit
my $parallel = 0;     # which of them is drawn
my $pixel = 0.05;     # what is nearer to an outline is left open
my $pi = atan2 0, -1;

# Random numbers, which SEED begins again.
my $state;

sub under {
	$state = $state * 48271 % 2147483647;
	return $state % $_[0];
}

sub real { $_[0] + ($_[1] - $_[0]) * under(1 << 20) / (1 << 20) }
sub plus { [map { $_[0][$_] + $_[1][$_] } 0 .. 2] }
sub minus { [map { $_[0][$_] - $_[1][$_] } 0 .. 2] }
sub scaled { [map { $_[1] * $_ } @{$_[0]}] }
sub dot { sum map { $_[0][$_] * $_[1][$_] } 0 .. 2 }
sub cross {
	my ($a, $b) = @_;
	return [map { $a->[($_ + 1) % 3] * $b->[($_ + 2) % 3] -
	    $a->[($_ + 2) % 3] * $b->[($_ + 1) % 3] } 0 .. 2];
}
sub unit { scaled($_[0], 1 / sqrt dot($_[0], $_[0])) }

# Returns three random directions at right angles.
sub frame {
	my $x = unit([map { real(-1, 1) } 0 .. 2]);
	my $y = unit(cross($x, [map { real(-1, 1) } 0 .. 2]));
	return ($x, $y, cross($x, $y));
}

# The scene: points, faces and lines, as lists of places in @point.
my (@point, @face, @line);

sub points { push @point, @_; return $#point - $#_ .. $#point }

sub place { [real(-3, 3), real(-2, 2), real(1, 9)] }

sub triangle {
	my $at = place();
	push @face, [points(map { plus($at, [map { real(-2, 2) } 0 .. 2]) } 0 .. 2)];
}

sub box {
	my ($at, $size, @axis) = @_;
	@axis = frame() unless @axis;
	my @i = points(map {
		my $corner = $_;
		my $p = $at;
		$p = plus($p, scaled($axis[$_], $size->[$_] * ($corner >> $_ & 1 ? 1 : -1)))
		    for 0 .. 2;
		$p;
	} 0 .. 7);
	push @face, [@i[@$_]] for [0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1],
	    [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3];
}

# A flat face of 5 to 9 corners, at most of them concave.
sub star {
	my $at = place();
	my ($u, $v) = frame();
	my $n = 5 + under(5);
	push @face, [points(map {
		my $r = real(0.3, 2);
		plus($at, plus(scaled($u, $r * cos(2 * $pi * $_ / $n)),
		    scaled($v, $r * sin(2 * $pi * $_ / $n))));
	} 0 .. $n - 1)];
}

# Boards in a circle, each in front of the next.
sub circle {
	my $at = place();
	my $n = 3 + under(3);
	for my $k (0 .. $n - 1) {
		my $angle = 2 * $pi * $k / $n + 0.1;
		my $away = [cos $angle, sin $angle, 0];
		my $along = unit([-sin $angle, cos $angle, 0.4]);
		# turned, so that no two edges of a board are seen as one
		my $across = unit(plus($away, scaled(cross($along, $away), 0.3)));
		box(plus($at, $away), [2, 0.3, 0.05], $along, $across,
		    cross($along, $across));
	}
}

sub image {
	my ($p) = @_;
	my $k = $parallel ? $scale : $focal / $p->[2];
	return [$width / 2 + $k * $p->[0], $height / 2 - $k * $p->[1]];
}

# Returns whether a point is in the view volume: 1, 0 or, near a plane, undef.
sub inside {
	my ($p) = @_;
	my $margin = 1e-6;
	return 0 if $p->[2] < $near - $margin || $p->[2] > $far + $margin;
	return if $p->[2] < $near + $margin || $p->[2] > $far - $margin;
	my ($x, $y) = @{image($p)};
	my $room = min($x, $width - $x, $y, $height - $y);
	return $room < -$pixel ? 0 : $room > $pixel ? 1 : undef;
}

# Returns the distance of a point of the picture from the segment from a to b.
sub distance {
	my ($p, $a, $b) = @_;
	my ($dx, $dy) = ($b->[0] - $a->[0], $b->[1] - $a->[1]);
	my $square = $dx ** 2 + $dy ** 2;
	my $t = $square > 0 ? (($p->[0] - $a->[0]) * $dx + ($p->[1] - $a->[1]) * $dy) /
	    $square : 0;
	$t = max(0, min(1, $t));
	return sqrt(($a->[0] + $t * $dx - $p->[0]) ** 2 +
	    ($a->[1] + $t * $dy - $p->[1]) ** 2);
}

# Returns whether the point h, in the plane of a face, is inside it: 1, 0 or undef. The
# rule of even and odd is applied where the plane is seen along one axis.
sub holds {
	my ($face, $normal, $h) = @_;
	my ($a, $b) = grep { my $k = $_; grep { abs $normal->[$_] > abs $normal->[$k] ||
	    abs $normal->[$_] == abs $normal->[$k] && $_ < $k } 0 .. 2 } 0 .. 2;
	my ($odd, $near_edge) = (0, 0);
	for my $i (0 .. $#$face) {
		my ($p, $q) = @point[@$face[$i - 1, $i]];
		$near_edge ||= distance([@$h[$a, $b]], [@$p[$a, $b]], [@$q[$a, $b]]) < 3e-3;
		$odd ^= $p->[$a] + ($h->[$b] - $p->[$b]) / ($q->[$b] - $p->[$b]) *
		    ($q->[$a] - $p->[$a]) > $h->[$a]
		    if ($p->[$b] > $h->[$b]) != ($q->[$b] > $h->[$b]);
	}
	return $near_edge ? undef : $odd;
}

sub normal_of {
	my ($face) = @_;
	my $n = [0, 0, 0];
	for my $i (1 .. $#$face - 1) {
		my ($o, $p, $q) = @point[@$face[0, $i, $i + 1]];
		$n = plus($n, cross(minus($p, $o), minus($q, $o)));
	}
	return unit($n);
}

# Returns whether p, a point of an edge, is visible: 1, 0 or undef.
sub visible {
	my ($p, @ends) = @_;
	my $seen = inside($p);
	return $seen if !$seen && defined $seen;
	for my $face (@face) {
		next if 2 == grep { my $i = $_; grep { $_ == $i } @$face } @ends;
		my $n = normal_of($face);
		my $ray = $parallel ? [0, 0, 1] : unit($p);
		my $slope = dot($n, $ray);
		my $back = dot($n, minus($p, $point[$face->[0]]));
		if (abs $slope < 1e-3) {
			$seen = undef;
			next;
		}
		my $behind = $back / $slope; # the way from the face to p along the ray
		next if $behind < -1e-3;
		my $hit = minus($p, scaled($ray, $behind));
		my $held = holds($face, $n, $hit);
		next if defined $held && !$held;
		next if $hit->[2] < $near - 1e-3;
		return 0 if $held && $behind > 1e-3 && $hit->[2] > $near + 1e-3;
		$seen = undef;
	}
	return $seen;
}

# Returns how many segments that are parallel to the edge from a to b, as seen, cover p.
# The segments are made longer at both ends, or shorter.
sub covers {
	my ($segments, $p, $a, $b, $longer) = @_;
	my @d = ($b->[0] - $a->[0], $b->[1] - $a->[1]);
	my $count = 0;
	for (@$segments) {
		my ($q, $r) = @$_;
		next if min($q->[0], $r->[0]) > $p->[0] + 1 ||
		    max($q->[0], $r->[0]) < $p->[0] - 1;
		my @e = ($r->[0] - $q->[0], $r->[1] - $q->[1]);
		my $long = sqrt($e[0] ** 2 + $e[1] ** 2) + 1e-9;
		next if 2 * $longer <= -$long || abs($d[0] * $e[1] - $d[1] * $e[0]) >
		    (0.01 * $long + 0.02) * sqrt($d[0] ** 2 + $d[1] ** 2);
		($q, $r) = map { my $end = $_; [map { $end->[$_] +
		    $e[$_] * $longer / $long * ($end == $q ? -1 : 1) } 0, 1] } $q, $r;
		$count++ if distance($p, $q, $r) < 0.02;
	}
	return $count;
}

# Returns the segments of an SVG.
sub segments {
	my ($svg) = @_;
	my (@found, $last);
	while ($svg =~ /([ML])(-?[\d.e-]+) (-?[\d.e-]+)/g) {
		push @found, [$last, [$2, $3]] if $1 eq 'L';
		$last = [$2, $3];
	}
	return @found;
}

sub edges {
	my %seen;
	my @edges = map { my $f = $_; map { [@$f[$_ - 1, $_]] } 0 .. $#$f } @face;
	push @edges, map { my $l = $_; map { [@$l[$_ - 1, $_]] } 1 .. $#$l } @line;
	return grep { !$seen{join ' ', sort { $a <=> $b } @$_}++ } @edges;
}

# Returns what of an edge is between the near and the far plane, as its two ends.
sub between {
	my ($p, $q) = @_;
	for ([$near, 1], [$far, -1]) {
		my ($z, $sign) = @$_;
		my @side = map { $sign * ($_->[2] - $z) } $p, $q;
		return if $side[0] <= 0 && $side[1] <= 0;
		next if $side[0] >= 0 && $side[1] >= 0;
		my $cut = plus($p, scaled(minus($q, $p), $side[0] / ($side[0] - $side[1])));
		($p, $q) = $side[0] < 0 ? ($cut, $q) : ($p, $cut);
	}
	return ($p, $q);
}

# Returns where the plane of depth z cuts a face, as segments of a line in it.
sub cuts_of {
	my ($face, $z) = @_;
	my @at;
	for my $i (0 .. $#$face) {
		my ($p, $q) = @point[@$face[$i - 1, $i]];
		push @at, plus($p, scaled(minus($q, $p),
		    ($z - $p->[2]) / ($q->[2] - $p->[2])))
		    if ($p->[2] > $z) != ($q->[2] > $z);
	}
	my $d = cross(normal_of($face), [0, 0, 1]);
	@at = sort { dot($a, $d) <=> dot($b, $d) } @at;
	return map { [@at[2 * $_, 2 * $_ + 1]] } 0 .. @at / 2 - 1;
}

sub random_scene {
	@point = @face = @line = ();
	my $kind = under(5);
	if ($kind == 0) {
		triangle() for 1 .. 4 + under(16);
	} elsif ($kind == 1) {
		box(place(), [map { real(0.2, 1.5) } 0 .. 2]) for 1 .. 2 + under(4);
	} elsif ($kind == 2) {
		circle() for 1 .. 1 + under(2);
	} elsif ($kind == 3) {
		star() for 1 .. 3 + under(6);
	} else {
		triangle(), star();
		box(place(), [map { real(0.2, 1.5) } 0 .. 2]);
		circle();
	}
	push @line, [points(place(), map { place() } 0 .. under(5))] for 1 .. under(4);
}

my ($asked, $hidden, $left) = (0, 0, 0);

# Returns what is wrong with a drawing.
sub faults {
	my ($svg) = @_;
	my @drawn = segments($svg);
	my (@faults, @known);
	my @edges = edges();
	for my $edge (@edges) {
		my ($p, $q) = between(@point[@$edge]);
		push @known, [image($p), image($q)] if $p;
	}
	my @edge_images = @known;
	for my $edge (@edges) {
		my ($p, $q) = between(@point[@$edge]) or next;
		my @seen = (image($p), image($q));
		for my $k (1 .. 9) {
			my $at = plus($p, scaled(minus($q, $p), ($k + real(-0.3, 0.3)) / 10));
			my $truth = visible($at, @$edge);
			my ($least, $most) =
			    map { covers(\@drawn, image($at), @seen, $_) } -0.1, 0.1;
			my $name = sprintf 'at %.2f %.2f of %d %d', @{image($at)}, @$edge;
			$asked++;
			$left += !defined $truth;
			next unless defined $truth;
			# no edges that are seen as one
			next if 1 < grep { distance(image($at), @$_) < 0.1 } @edge_images;
			$hidden += !$truth;
			push @faults, "hidden but drawn $name" if !$truth && $least;
			push @faults, "visible but not drawn $name" if $truth && !$most;
			push @faults, "drawn $least times $name" if $truth && $least > 1;
		}
	}
	for my $face (@face) {
		for my $cut (map { cuts_of($face, $_) } $near, $far) {
			push @known, [map { image($_) } @$cut];
			next if $cut->[0][2] > $near + 1; # visible() is about far cuts, too
			my $at = scaled(plus(@$cut), 0.5);
			my $in = inside(plus($at, [0, 0, 1e-5])) // 0;
			push @faults, sprintf 'a cut is missing at %.2f %.2f', @{image($at)}
			    if $in && !covers(\@drawn, image($at), (map { image($_) } @$cut), 0.1);
		}
	}
	for my $segment (@drawn) {
		my ($p, $q) = @$segment;
		my $middle = [map { ($p->[$_] + $q->[$_]) / 2 } 0, 1];
		next if min($middle->[0], $width - $middle->[0], $middle->[1],
		    $height - $middle->[1]) < 0.02; # a cut at the side of the picture
		push @faults, sprintf 'no edge is at %.2f %.2f', @$middle
		    unless grep { distance($middle, @$_) < 0.03 } @known;
	}
	return @faults;
}

my @projections = (
	sprintf('"type":"persp","fovy":%.17g,"aspect":%.17g', 360 / $pi *
	    atan2($height / 2, $focal), $width / $height),
	sprintf('"type":"ortho","width":%.17g,"height":%.17g', $width / $scale,
	    $height / $scale));

my $first = $ENV{SEED} // 1;
for my $seed ($first .. $first + 7) {
	$state = $seed;
	under(2) for 1 .. 9;
	my @wrong;
	for my $n (1 .. 4) {
		random_scene();
		$parallel = under(2);
		spew("$tmp/scene.obj", join '',
		    (map { sprintf "v %.17g %.17g %.17g\n", @$_ } @point),
		    (map { join(' ', 'f', map { $_ + 1 } @$_) . "\n" } @face),
		    (map { join(' ', 'l', map { $_ + 1 } @$_) . "\n" } @line));
		my $scene = sprintf '{"projection":{%s,"near":%g,"far":%g},"viewport":' .
		    '{"width":%d,"height":%d}}', $projections[$parallel], $near, $far,
		    $width, $height;
		my ($status, $svg, $said) = run("projcalc draw -q '$scene' $tmp/scene.obj");
		my @faults = ($status || $said ne '' ? "$status$said" : (), faults($svg));
		next unless @faults;
		spew("draw-$seed-$n.obj", slurp("$tmp/scene.obj")) if $ENV{KEEP};
		push @wrong, "scene $n, '$scene': " . @faults . " faults", @faults[0 .. min($#faults, 4)];
	}
	is(join("\n", @wrong), '', "seed $seed");
}
note("$asked points of edges, $hidden hidden, $left left open");
ok($left < 0.2 * $asked && $hidden > 0.1 * $asked, 'the oracle has an answer');
done_testing();
