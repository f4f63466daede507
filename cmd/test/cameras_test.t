#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks the manual's recipes for cameras of other programs: the pixels that they print
# for a file of such a program are the doubles nearest to the results of the program's
# own formula in 60 digits.
use strict;
use warnings;
use FindBin;
use JSON::PP;
use List::Util qw(sum0);
use Math::BigFloat try => 'GMP';
use POSIX 'strtod';
use lib $FindBin::Bin;
use Projcalc;
use Transcript;

plan skip_all => 'no jq' if missing('jq');
Math::BigFloat->accuracy(90);

# Returns the exact value of the double nearest to a text. Doubles of these sizes have
# at most 86 digits.
sub number {
	my ($double) = strtod("$_[0]");
	return Math::BigFloat->new(sprintf '%.85e', $double);
}

sub numbers { map { number($_) } @_ }
sub dot { my ($a, $b) = @_; return sum_of(map { $a->[$_] * $b->[$_] } 0 .. $#$a) }
sub sum_of { my $s = Math::BigFloat->bzero; $s += $_ for @_; return $s }
sub rows { my ($n, @m) = @_; return map { [splice @m, 0, $n] } 1 .. @m / $n }
sub through { my ($p, @rows) = @_; return map { dot($_, $p) } @rows }

# Returns the rows of the rotation of a quaternion, which may have any norm.
sub turn {
	my ($x, $y, $z, $w) = @_;
	my $n = dot([@_], [@_]);
	return map { [map { $_ / $n } @$_] } (
		[$w*$w + $x*$x - $y*$y - $z*$z, 2*($x*$y - $z*$w), 2*($x*$z + $y*$w)],
		[2*($x*$y + $z*$w), $w*$w - $x*$x + $y*$y - $z*$z, 2*($y*$z - $x*$w)],
		[2*($x*$z - $y*$w), 2*($y*$z + $x*$w), $w*$w - $x*$x - $y*$y + $z*$z]);
}

sub transposed {
	my (@m) = @_;
	return map { my $j = $_; [map { $_->[$j] } @m] } 0 .. 2;
}

sub minor {
	my ($i, $j, @m) = @_;
	my ($a, $b) = ($m[($i + 1) % 3], $m[($i + 2) % 3]);
	my ($k, $l) = (($j + 1) % 3, ($j + 2) % 3);
	return $a->[$k] * $b->[$l] - $a->[$l] * $b->[$k];
}

sub inverse {
	my (@m) = @_;
	my $det = sum_of(map { $m[0][$_] * minor(0, $_, @m) } 0 .. 2);
	return map { my $i = $_; [map { minor($_, $i, @m) / $det } 0 .. 2] } 0 .. 2;
}

sub divided { return [$_[0] / $_[2], $_[1] / $_[2]] }
sub minus { my ($p, $q) = @_; return [map { $p->[$_] - $q->[$_] } 0 .. 2] }

sub tangent {
	my ($a) = @_;
	return $a->copy->bsin / $a->copy->bcos;
}

sub lines { return split /\n/, slurp("testdata/cameras/$_[0]") }
sub fields { my ($file, $at, $word) = @_;
	return (grep { ($_->[$at] // '') eq $word } map { [split / /] } lines($file))[0] }
sub document {
	# Perl would round numbers to 15 digits
	return JSON::PP->new->allow_bignum->decode(slurp("testdata/cameras/$_[0]"));
}

# The recipes by the file that they read: the command without its points.
my %recipe;
my @whole = map { $_->{command} } examples('man/projcalc-scene.5');
for my $case (examples('man/projcalc-scene.5')) {
	my ($jq, $file) = $case->{command} =~
	    m{\A(jq .*? cameras/(\w+\.\w+)(?: cameras/\w+\.txt)?)\s*\|\s+projcalc}s or next;
	push @{$recipe{$file}}, $jq =~ s/\\\n//r;
}

# Returns the output of the program for points, by a recipe in which words may be
# replaced.
sub printed {
	my ($recipe, $points, %other) = @_;
	my $command = $recipe;
	$command =~ s/\Q$_\E/$other{$_}/ for keys %other;
	spew("$tmp/points", join '', map { "@$_\n" } @$points);
	my ($status, $out, $err) =
	    run("$command | projcalc project - $tmp/points", 'testdata');
	die "$command\n$err" if $status != 0;
	return map { [split] } split /\n/, $out;
}

# Compares the bits of the first two coordinates.
sub compare {
	my ($name, $said, @true) = @_;
	my @wrong;
	for my $i (0 .. $#true) {
		for my $j (0, 1) {
			my ($nearest) = strtod($true[$i][$j]->copy->bround(60)->bsstr);
			my ($got) = strtod($said->[$i][$j] // 'nan');
			push @wrong, "$i: $said->[$i][$j], not $true[$i][$j]"
			    if pack('d', $got + 0) ne pack('d', $nearest + 0);
		}
	}
	ok(@$said == @true && @true > 0 && !@wrong, $name) or diag("@wrong[0 .. 3]");
}

sub grid {
	my ($x, $y, $z) = @_;
	return map { my $i = $_; map { my $j = $_; map { [$x->[$i], $y->[$j], $z->[$_]] }
	    0 .. $#$z } 0 .. $#$y } 0 .. $#$x;
}

# OpenCV: K (R p + t), for some cameras of the file, and a grid of points around the
# object.
my @corners = grid([-0.041897, 0, 0.030897], [0.001126, 0.05, 0.088227],
    [-0.037845, 0.035495]);
for my $name (qw(dino0001.png dino0059.png dino0120.png dino0299.png)) {
	my (undef, @n) = numbers(@{fields('dino_par.txt', 0, $name)});
	my @k = rows(3, @n[0 .. 8]);
	my @r = rows(3, @n[9 .. 17]);
	compare("OpenCV, $name", [printed($recipe{'dino_par.txt'}[0], \@corners,
	    'dino0001.png' => $name)], map {
		my @c = through([numbers(@$_)], @r);
		@c = through([map { $c[$_] + $n[18 + $_] } 0 .. 2], @k);
		[$c[0] / $c[2], $c[1] / $c[2]]
	} @corners);
}

# COLMAP: q and t map the world to the camera. The observed corners differ from the
# images by COLMAP's residuals, and by the distortion, which the program lacks.
my %point = map { my @f = split / /; ($f[0] => [@f[1 .. 3]]) }
    grep { !/^#/ } lines('points3D.txt');
my ($f, $cx, $cy) = numbers(@{fields('cameras.txt', 0, 1)}[4 .. 6]);
my @lines = lines('images.txt');
for my $at (grep { $lines[$_] =~ / (frame\d+\.jpg)$/ } 0 .. $#lines) {
	my ($name) = $lines[$at] =~ / (\S+)$/;
	my (undef, $w, $x, $y, $z, @t) = numbers((split / /, $lines[$at])[0 .. 7]);
	my @r = turn($x, $y, $z, $w);
	my @seen = rows(3, split / /, $lines[$at + 1]);
	my @points = map { $point{$_->[2]} } @seen;
	my @said = printed($recipe{'cameras.txt'}[0], \@points, 'frame1.jpg' => $name);
	compare("COLMAP, $name", \@said, map {
		my @c = through([numbers(@$_)], @r);
		@c = map { $c[$_] + $t[$_] } 0 .. 2;
		[$cx + $f * $c[0] / $c[2], $cy + $f * $c[1] / $c[2]]
	} @points);
	my @far = sort { $a <=> $b } map {
		sqrt(($said[$_][0] - $seen[$_][0])**2 + ($said[$_][1] - $seen[$_][1])**2)
	} 0 .. $#seen;
	cmp_ok($far[@far / 2], '<', 1, "half of what COLMAP saw in $name is as near");
}

# COLMAP: each model that the recipe reads has its numbers, and any other stops it.
for my $case (['PINHOLE 4000 2250 3000 2900 2000 1125', 3000, 2900, 2000, 1125],
    ['SIMPLE_PINHOLE 4000 2250 3000 2001 1126', 3000, 3000, 2001, 1126], ['OPENCV ' .
    '4000 2250 3000 2900 2000 1125 0.1 0.2 0 0']) {
	my ($camera, @k) = @$case;
	my ($model) = $camera =~ /(\w+)/;
	spew("$tmp/cameras.txt", "1 $camera\n");
	my $recipe = $recipe{'cameras.txt'}[0] =~ s{cameras/cameras.txt}{$tmp/cameras.txt}r;
	my (undef, $out) = run($recipe, 'testdata');
	my $scene = $out ne '' && decode_json($out);
	ok(@k ? "@{$scene->{projection}{intrinsics}}" eq "@k" : $out eq '', "COLMAP's $model")
	    or diag($out);
}

# NeRF: the pose's inverse; x right, y up, z backward.
my $nerf = document('transforms.json');
for my $i (0 .. $#{$nerf->{frames}}) {
	my @m = map { [numbers(@$_)] } @{$nerf->{frames}[$i]{transform_matrix}};
	my @inverse = inverse(@m[0 .. 2]);
	my ($fx, $fy, $u, $v) = numbers(@$nerf{qw(fl_x fl_y cx cy)});
	my @points = grid([3.5, 4], [6, 7.1], [2.5, 3.3]);
	compare("NeRF, frame $i", [printed($recipe{'transforms.json'}[0], \@points,
	    'frames[0]' => "frames[$i]")], map {
		my @c = through(minus([numbers(@$_)], [map { $_->[3] } @m]), @inverse);
		[$u - $fx * $c[0] / $c[2], $v + $fy * $c[1] / $c[2]]
	} @points);
}

# glTF: the node's inverse; half the height is tan(yfov / 2).
my $gltf = document('camera.gltf');
my @things = grid([0, 0.3], [0, 0.7], [0, -1.1]);
for my $i (1, 2) {
	my $node = $gltf->{nodes}[$i];
	my @t = numbers(@{$node->{translation}});
	my @r = transposed(turn(numbers(@{$node->{rotation} // [0, 0, 0, 1]})));
	my $camera = $gltf->{cameras}[$node->{camera}];
	my $p = $camera->{$camera->{type}};
	compare("glTF, $camera->{type}", [printed($recipe{'camera.gltf'}[$i - 1],
	    \@things)], map {
		my @c = through(minus([numbers(@$_)], \@t), @r);
		my ($x, $y) = $i == 1 ? map {
			-$_ / ($c[2] * tangent(number($p->{yfov}) / 2))
		} $c[0] / number($p->{aspectRatio}), $c[1] :
		    ($c[0] / number($p->{xmag}), $c[1] / number($p->{ymag}));
		[256 + 256 * $x, 256 - 256 * $y]
	} @things);
}

# KITTI: the product P2 R0_rect Tr_velo_to_cam.
my %calib = map { my ($name, $n) = split /: /; ($name => [numbers(split / /, $n)]) }
    grep { /: / } lines('calib.txt');
my @lidar = grid([6.3, 10, 44.7], [-3.2, 0, 2.9], [-1.6, 0.4]);
for my $p (qw(P0 P1 P2)) {
	compare("KITTI, $p", [printed($recipe{'calib.txt'}[0], \@lidar, P2 => $p)], map {
		my @c = through([numbers(@$_, 1)], rows(4, @{$calib{Tr_velo_to_cam}}));
		@c = through(\@c, rows(3, @{$calib{R0_rect}}));
		@c = through([@c, number(1)], rows(4, @{$calib{$p}}));
		[$c[0] / $c[2], $c[1] / $c[2]]
	} @lidar);
}

# OpenCV: the board, turned by Rodrigues' formula.
my $pnp = document('pnp.json');
my ($rvec, $tvec, $k9) = map { [numbers(@{$pnp->{$_}{data}})] }
    qw(rvec tvec camera_matrix);
my $angle = dot($rvec, $rvec)->bsqrt;
my @axis = map { $_ / $angle } @$rvec;
my @board = grid([0, 0.1, 0.25], [0, 0.175], [0, -0.02]);
compare('OpenCV, rvec', [printed($recipe{'pnp.json'}[0], \@board)], map {
	my @p = numbers(@$_);
	my $along = dot(\@axis, \@p) * (1 - $angle->copy->bcos);
	my @c = map {
		my ($i, $j) = (($_ + 1) % 3, ($_ + 2) % 3);
		$p[$_] * $angle->copy->bcos + $axis[$_] * $along + $tvec->[$_] +
		    ($axis[$i] * $p[$j] - $axis[$j] * $p[$i]) * $angle->copy->bsin
	} 0 .. 2;
	divided(through(\@c, rows(3, @$k9)))
} @board);

# Returns the numbers that a whole recipe prints, in which words are replaced.
sub whole {
	my ($what, @swaps) = @_;
	my ($command) = grep { /$what/ } @whole;
	while (my ($from, $to) = splice @swaps, 0, 2) {
		$command =~ s/$from/$to/g;
	}
	my ($status, $out, $err) = run($command, 'testdata');
	die "$command\n$err" if $status != 0;
	return map { [split] } split /\n/, $out;
}

# Compares numbers that were computed in doubles, to 14 digits of the largest.
sub near {
	my ($name, $said, @true) = @_;
	my @wrong = grep { my $i = $_; grep { abs($said->[$i][$_] - $true[$i][$_]) >
	    1e-14 * ($said->[$i][0] ** 2 + $said->[$i][1] ** 2) ** 0.5 } 0 .. $#{$true[$i]} }
	    0 .. $#true;
	my $i = $wrong[0] // 0;
	ok(@$said == @true && !@wrong, $name) or diag("@{$said->[$i]}; @{$true[$i]}");
}

# The lens of OpenCV's projectPoints, with 5 and with 8 coefficients.
for my $lens ([map { "$_" } @{$pnp->{distortion_coefficients}{data}}],
    [0.25, -0.5, 0.003, -0.002, 0.125, 0.5, -0.25, 0.0625]) {
	my ($k1, $k2, $p1, $p2, $k3, @rational) = numbers(@$lens);
	my ($k4, $k5, $k6) = @rational ? @rational : numbers(0, 0, 0);
	my $list = join ', ', @$lens;
	my $json = '[' . join(', ', map { '[' . join(', ', @$_) . ']' } @board) . ']';
	my @said = whole('distortion_coefficients', qr/\Q.distortion_coefficients.data[]\E/ =>
	    $list, qr/%\.3f/ => '%.17g', qr/\[\[0, 0, 0\].*?\]\]/ => $json);
	near(@$lens . ' coefficients of a lens', \@said, map {
		my @p = numbers(@$_);
		my $along = dot(\@axis, \@p) * (1 - $angle->copy->bcos);
		my @c = map {
			my ($i, $j) = (($_ + 1) % 3, ($_ + 2) % 3);
			$p[$_] * $angle->copy->bcos + $axis[$_] * $along + $tvec->[$_] +
			    ($axis[$i] * $p[$j] - $axis[$j] * $p[$i]) * $angle->copy->bsin
		} 0 .. 2;
		my ($x, $y) = ($c[0] / $c[2], $c[1] / $c[2]);
		my $r = $x * $x + $y * $y;
		my $d = (1 + $k1 * $r + $k2 * $r ** 2 + $k3 * $r ** 3) /
		    (1 + $k4 * $r + $k5 * $r ** 2 + $k6 * $r ** 3);
		[$k9->[2] + $k9->[0] * ($x * $d + 2 * $p1 * $x * $y + $p2 * ($r + 2 * $x * $x)),
		    $k9->[5] + $k9->[4] * ($y * $d + $p1 * ($r + 2 * $y * $y) + 2 * $p2 * $x * $y)]
	} @board);
}

# A disparity: z is f b / d.
my @right = @{document('camera_info.json')->{p}};
near('disparity', [whole('fb=', qr/-d 3/ => '')], map {
	my ($u, $v, $d) = numbers(@$_);
	my $z = -number($right[3]) / $d;
	[($u - number($right[2])) * $z / number($right[0]),
	    ($v - number($right[6])) * $z / number($right[5]), $z]
} [340, 240, 20], [400, 200, 8.5]);

SKIP: {
	skip 'no gnuplot', 1 if missing('gnuplot');
	my ($lines) = grep { /project --lines/ } @whole;
	chomp $lines;
	my (undef, $out, $err) = run("$lines | gnuplot -e 'set terminal dumb; " .
	    "set yrange [480:0]; plot \"<cat\" with lines'", 'testdata');
	ok($out =~ /\*/ && $err eq '', 'gnuplot draws a wireframe') or diag($err);
}

# ROS and DTU: the matrix P.
my @p12 = ((map { [camera_info => $_, numbers(@{document('camera_info.json')->{p}})] }
    qw(json yaml)),
    [pos_001 => 'txt', numbers(map { split } lines('pos_001.txt'))]);
for my $p (@p12) {
	my ($name, $kind, @p) = @$p;
	my @points = grid([-0.5, 70], [0.25, 90.5], [2, 300]);
	compare("P of $name", [printed($recipe{"$name.$kind"}[0], \@points)],
	    map { divided(through([numbers(@$_, 1)], rows(4, @p))) } @points);
}

# RealSense: the pixel is ppx + fx x / z.
my ($ppx, $ppy, $fx, $fy) = numbers((lines('realsense.txt'))[0] =~ /(\d+\.\d+)/g);
my @near = grid([-0.3, 0, 0.4], [-0.2, 0.1], [0.5, 3]);
compare('RealSense', [printed($recipe{'realsense.txt'}[0], \@near)], map {
	my ($x, $y, $z) = numbers(@$_);
	[$ppx + $fx * $x / $z, $ppy + $fy * $y / $z]
} @near);

# ARKit: the transform's inverse; x right, y up, z backward.
my $arkit = document('arkit.json');
my @columns = map { [numbers(@$_)] } @{$arkit->{transform}};
my @toward = inverse(transposed(@columns[0 .. 2]));
my @lens = map { [numbers(@$_)] } @{$arkit->{intrinsics}};
my @room = grid([-0.9, -0.6], [1.5, 2], [-3, -2.5]);
compare('ARKit', [printed($recipe{'arkit.json'}[0], \@room)], map {
	my @c = through(minus([numbers(@$_)], $columns[3]), @toward);
	divided(through([$c[0], -$c[1], -$c[2]], transposed(@lens)))
} @room);

# Blender: millimetres of a sensor, which is as wide as the larger side of the picture,
# and which the shift moves.
my $blender = document('blender.json');
my @world = map { [numbers(@$_)] } @{$blender->{matrix_world}};
my @object = inverse(map { [@$_[0 .. 2]] } @world[0 .. 2]);
my @cube = grid([-1, 1], [-1, 1], [0, 1]);
compare('Blender', [printed($recipe{'blender.json'}[0], \@cube)], map {
	my @c = through(minus([numbers(@$_)], [map { $_->[3] } @world]), @object);
	my ($x, $y) = map { -number($blender->{lens}) * $_ / $c[2] /
	    number($blender->{sensor_width}) } @c[0, 1];
	[960 + 1920 * ($x - number($blender->{shift_x})),
	    540 - 1920 * ($y - number($blender->{shift_y}))]
} @cube);

# Unity: its two matrices, whose elements are named e, row, column; pixels count from
# the bottom left.
my $unity = document('unity.json');
my @crowd = grid([-1, 2.5], [0, 1.75], [0, 4]);
compare('Unity', [printed($recipe{'unity.json'}[0], \@crowd)], map {
	my $c = [numbers(@$_, 1)];
	for my $m (@$unity{qw(worldToCameraMatrix projectionMatrix)}) {
		$c = [through($c, map { my $i = $_;
		    [numbers(map { $m->{"e$i$_"} } 0 .. 3)] } 0 .. 3)];
	}
	[640 + 640 * $c->[0] / $c->[3], 360 + 360 * $c->[1] / $c->[3]]
} @crowd);

# OpenXR: ndc is -1 at one tangent and 1 at the other; in Vulkan y points down.
my $fov = document('fov.json');
my ($left, $right, $up, $down) = map { tangent(number($fov->{$_})) }
    qw(angleLeft angleRight angleUp angleDown);
my @ahead = grid([-0.4, 0, 0.3], [-0.2, 0.5], [-1, -7.7]);
compare('OpenXR', [printed($recipe{'fov.json'}[0], \@ahead)], map {
	my @c = numbers(@$_);
	[(-2 * $c[0] / $c[2] - $left - $right) / ($right - $left),
	    -(-2 * $c[1] / $c[2] - $down - $up) / ($up - $down)]
} @ahead);

# GLM: its matrices in the order of memory.
my @glm = numbers(map { split } lines('glm.txt'));
my @about = grid([-1, 0.25], [0.5, 2], [0, 1.5]);
compare('GLM', [printed($recipe{'glm.txt'}[0], \@about)], map {
	my @c = (numbers(@$_), number(1));
	for my $m (\@glm, [@glm[16 .. 31]]) {
		@c = map { my $j = $_; sum_of(map { $c[$_] * $m->[4 * $_ + $j] } 0 .. 3) }
		    0 .. 3;
	}
	[320 + 320 * $c[0] / $c[3], 240 + 240 * $c[1] / $c[3]]
} @about);

SKIP: {
	skip 'no GLM', 1 if missing('c++') || !-e '/usr/include/glm/glm.hpp';
	spew("$tmp/dump.cc", <<'END');
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

static void dump(const glm::mat4 &m)
{
	for (int i = 0; i < 16; i++)
		std::printf("%.9g%c", glm::value_ptr(m)[i], i % 4 < 3 ? ' ' : '\n');
}

int main()
{
	dump(glm::lookAt(glm::vec3(4, 3, 7), glm::vec3(0, 0.5f, 0),
	    glm::vec3(0, 1, 0)));
	dump(glm::perspective(0.8f, 4 / 3.0f, 0.1f, 100.0f));
}
END
	my (undef, $out, $err) = run("c++ -O1 -ffp-contract=off -o $tmp/dump " .
	    "$tmp/dump.cc && $tmp/dump");
	is($out, slurp('testdata/cameras/glm.txt'), 'what GLM prints') or diag($err);
}

# The view matrices of other projects' tests: converted through all conventions they
# become the same matrices again, and a point has the same pixel in each convention.
my @names = qw(d3d gl vulkan webgpu opencv);

sub projcalc {
	my ($arguments, $scene) = @_;
	my $json = JSON::PP->new->canonical->encode($scene);
	my ($status, $out, $err) = run("projcalc $arguments '$json'");
	die "projcalc $arguments '$json'\n$err" if $status != 0;
	return $out;
}

for my $case (@{decode_json(slurp('testdata/recorded/others.json'))->{cases}}) {
	my $right = ($case->{input}{hand} // '') eq 'rh';
	my $dump = {matrix => $case->{expected}, vectors => 'column'};
	if ($case->{op} eq 'lookat') {
		my $home = $right ? 'gl' : 'd3d';
		my ($at, $m) = ($home, $dump);
		for my $next ((grep { $_ ne $home } @names), $home) {
			$m = decode_json(projcalc("lookat -o json -c $next",
			    {convention => $at, camera => {matrix => $m}}));
			$at = $next;
		}
		my @rows = $m->{vectors} eq 'column' ? @{$m->{matrix}} :
		    map { my $j = $_; [map { $_->[$j] } @{$m->{matrix}}] } 0 .. 3;
		is(join(' ', map { $_ + 0 } map { @$_ } @rows),
		    join(' ', map { $_ + 0 } map { @$_ } @{$case->{expected}}),
		    "$case->{id} around all conventions");
	} elsif ($case->{op} =~ /^(?:persp|frustum)$/) {
		my %convention = (handedness => $right ? 'right' : 'left',
			depth => ($case->{input}{depth} // '') eq 'no' ?
			    'minus_one_to_one' : 'zero_to_one');
		my %scene = (convention => \%convention,
			camera => {eye => [0, 0, 0], gaze => [0, 0, 1]},
			projection => {type => 'matrix', matrix => $dump},
			viewport => {width => 640, height => 480},
			points => [[0.1, 0.2, 3]]);
		my %seen = map { projcalc("project -c $_", \%scene) => 1 }
		    grep { $_ ne 'gl' } @names;
		is(scalar keys %seen, 1, "$case->{id} is one picture");
	}
}
done_testing();
