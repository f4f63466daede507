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

# Returns the rows of the rotation of a rotation vector.
sub rodrigues {
	my (@r) = @_;
	my $angle = dot(\@r, \@r)->bsqrt;
	my ($x, $y, $z) = map { $_ / $angle } @r;
	my ($c, $s) = ($angle->copy->bcos, $angle->copy->bsin);
	my $d = 1 - $c;
	return ([$c + $x*$x*$d, $x*$y*$d - $z*$s, $x*$z*$d + $y*$s],
		[$y*$x*$d + $z*$s, $c + $y*$y*$d, $y*$z*$d - $x*$s],
		[$z*$x*$d - $y*$s, $z*$y*$d + $x*$s, $c + $z*$z*$d]);
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
my @whole = map { $_->{command} } map { examples($_) } glob 'man/*.[157]';
for my $command (@whole) {
	my ($jq, $file) = $command =~
	    m{\A(jq\ .*?\ cameras/(\w+\.(?!jq)\w+)(?:\s[\s\\]*cameras/\w+\.\w+)*)
		[\s\\]*\|\s+projcalc}sx or next;
	push @{$recipe{$file}}, $jq =~ s/\\\n//gr;
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
# images by COLMAP's residuals.
my %point = map { my @f = split / /; ($f[0] => [@f[1 .. 3]]) }
    grep { !/^#/ } lines('points3D.txt');
my ($f, $cx, $cy) = numbers(@{fields('cameras.txt', 0, 1)}[5 .. 7]);
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

# COLMAP: each model that the recipe reads has its numbers.
for my $case (['PINHOLE 4000 2250 3000 2900 2000 1125', 3000, 2900, 2000, 1125],
    ['SIMPLE_PINHOLE 4000 2250 3000 2001 1126', 3000, 3000, 2001, 1126],
    ['SIMPLE_RADIAL 4000 2250 3000 2001 1126 0', 3000, 3000, 2001, 1126]) {
	my ($camera, @k) = @$case;
	my ($model) = $camera =~ /(\w+)/;
	spew("$tmp/cameras.txt", "1 $camera\n");
	my $recipe = $recipe{'cameras.txt'}[0] =~ s{cameras/cameras.txt}{$tmp/cameras.txt}r;
	my (undef, $out) = run($recipe, 'testdata');
	is("@{decode_json($out)->{projection}{intrinsics}}", "@k", "COLMAP's $model");
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
my @turned = rodrigues(@$rvec);
my @board = grid([0, 0.1, 0.25], [0, 0.175], [0, -0.02]);
compare('OpenCV, rvec', [printed($recipe{'pnp.json'}[0], \@board)], map {
	my @c = through([numbers(@$_)], @turned);
	divided(through([map { $c[$_] + $tvec->[$_] } 0 .. 2], rows(3, @$k9)))
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

# Returns where the lens of OpenCV's projectPoints shows a direction.
sub bent {
	my ($x, $y, @lens) = @_;
	my ($k1, $k2, $p1, $p2, $k3, $k4, $k5, $k6) = (@lens, (number(0)) x 4);
	my $r = $x * $x + $y * $y;
	my $d = (1 + $k1 * $r + $k2 * $r ** 2 + $k3 * $r ** 3) /
	    (1 + $k4 * $r + $k5 * $r ** 2 + $k6 * $r ** 3);
	return ($x * $d + 2 * $p1 * $x * $y + $p2 * ($r + 2 * $x * $x),
	    $y * $d + $p1 * ($r + 2 * $y * $y) + 2 * $p2 * $x * $y);
}

# A lens with 4, 5 and 8 coefficients, and back; behind the camera there is no image.
for my $lens ([0.25, -0.5, 0.003, -0.002],
    [map { "$_" } @{$pnp->{distortion_coefficients}{data}}],
    [0.25, -0.5, 0.003, -0.002, 0.125, 0.5, -0.25, 0.0625]) {
	my @coefficients = (qr/\Q.distortion_coefficients.data\E/ =>
	    '[' . join(', ', @$lens) . ']', qr/-d \d/ => '');
	my (@raw, @straight);
	for my $p (@board) {
		my @c = through([numbers(@$p)], @turned);
		@c = map { $c[$_] + $tvec->[$_] } 0 .. 2;
		my ($x, $y) = ($c[0] / $c[2], $c[1] / $c[2]);
		my ($u, $v) = bent($x, $y, numbers(@$lens));
		push @raw, [$k9->[2] + $k9->[0] * $u, $k9->[5] + $k9->[4] * $v];
		push @straight, [$k9->[2] + $k9->[0] * $x, $k9->[5] + $k9->[4] * $y];
	}
	my $json = '[' . join(', ', map { '[' . join(', ', @$_) . ']' } @board) . ']';
	my $pixels = join '', map { sprintf "%.17g %.17g 1\\n", map { $_->numify } @$_ } @raw;
	near(@$lens . ' coefficients of a lens, and back', [whole('fisheye_model',
	    @coefficients, qr/\[\[0, 0, 0\].*?\]\]/ => $json,
	    qr/echo 596.*? 1\b/ => "printf '$pixels'")], @raw, @straight);
}
spew("$tmp/bent", "0 0 -1\n0 0 0\n2 1 1\nnan nan nan\n0.5 0.25 1\n");
for my $back ('', 'back=1') {
	my (undef, $out) = run("awk -v k='-0.3 0 0 0' -f lens.awk $back $tmp/bent",
	    'testdata');
	like($out, qr/^(?:nan nan nan\n){4}0\.[45]\d+ 0\.2\d+ 1$/,
	    "what a lens does not show $back");
}
for my $k ('', '0.1 0.2 0.3', '0 0 0 0 0 0 0 0 0') {
	my ($status, $out, $err) = run("echo 0 0 1 | awk -v k='$k' -f lens.awk",
	    'testdata');
	ok($status == 1 && $out eq '' && $err =~ /^lens.awk: a lens has 4, 5 or 8/,
	    "lens.awk refuses '$k'");
}

# A disparity: z is f b / d.
my @right = @{document('camera_info.json')->{p}};
near('disparity', [whole('stereo.jq', qr/-d 3/ => '')], map {
	my ($u, $v, $d) = numbers(@$_);
	my $z = -number($right[3]) / $d;
	[($u - number($right[2])) * $z / number($right[0]),
	    ($v - number($right[6])) * $z / number($right[5]), $z]
} [340, 240, 20], [400, 200, 8.5]);

# OpenMVG: K R (x - center), R by rows.
my $sfm = document('sfm_data.json');
for my $i (0, 1) {
	my ($view) = map { $_->{value}{ptr_wrapper}{data} } $sfm->{views}[$i];
	my ($pose) = map { $_->{value} } grep { $_->{key} == $view->{id_pose} }
	    @{$sfm->{extrinsics}};
	my ($k) = map { $_->{value}{ptr_wrapper}{data} }
	    grep { $_->{key} == $view->{id_intrinsic} } @{$sfm->{intrinsics}};
	my @points = grid([0.5, -0.25], [0, 0.75], [1, 2.5]);
	compare("OpenMVG, $view->{filename}", [printed($recipe{'sfm_data.json'}[0], \@points,
	    'b.jpg' => $view->{filename})], map {
		my @c = through(minus([numbers(@$_)], [numbers(@{$pose->{center}})]),
		    map { [numbers(@$_)] } @{$pose->{rotation}});
		[map { number($k->{principal_point}[$_]) +
		    number($k->{focal_length}) * $c[$_] / $c[2] } 0, 1]
	} @points);
}

# Meshroom: as OpenMVG, but R by columns, millimetres, and pixels from the centre.
my $mesh = document('sfm.json');
my $lens = $mesh->{intrinsics}[0];
for my $i (0, 1) {
	my ($center, @c) = map { [numbers(@$_)] }
	    @{$mesh->{poses}[$i]{pose}{transform}}{qw(center rotation)};
	my @r = transposed(rows(3, @{$c[0]}));
	my @points = grid([-3, 0.5], [-2, 0.25], [0.5, 4]);
	my $f = number($lens->{focalLength}) / number($lens->{sensorWidth}) * $lens->{width};
	near("Meshroom, view $i", [printed($recipe{'sfm.json'}[0], \@points,
	    'IMG_2' => 'IMG_' . ($i + 1))], map {
		my @c = through(minus([numbers(@$_)], $center), @r);
		[$lens->{width} / 2 + number($lens->{principalPoint}[0]) + $f * $c[0] / $c[2],
		    $lens->{height} / 2 + number($lens->{principalPoint}[1]) +
		    $f * number($lens->{pixelRatio}) * $c[1] / $c[2]]
	} @points);
}

# Metashape: u = w/2 + cx + x f + x b1 + y b2, v = h/2 + cy + y f, with x and y of the
# inverse of the transform.
my $xml = slurp('testdata/cameras/cameras.xml');
my %adjusted = $xml =~ /adjusted.*?<\/calibration>/s && $& =~ /<(\w+)>([^<]*)</g;
for my $label (qw(DJI_0001 DJI_0003)) {
	my ($m) = $xml =~ /label="$label">\s*<transform>([^<]*)/;
	my @m = rows(4, numbers(split ' ', $m));
	my @r = inverse(map { [@$_[0 .. 2]] } @m[0 .. 2]);
	my @points = grid([-3.5, 0.25], [1, -2.5], [3.5, 0]);
	near("Metashape, $label", [printed($recipe{'cameras.xml'}[0], \@points,
	    DJI_0003 => $label)], map {
		my @c = through(minus([numbers(@$_)], [map { $_->[3] } @m[0 .. 2]]), @r);
		my ($x, $y) = ($c[0] / $c[2], $c[1] / $c[2]);
		my %n = map { $_ => number($adjusted{$_}) } qw(f cx cy b1 b2);
		[5472 / 2 + $n{cx} + $x * $n{f} + $x * $n{b1} + $y * $n{b2},
		    3648 / 2 + $n{cy} + $y * $n{f}]
	} @points);
}

# Bundle Adjustment in the Large: P = R X + t, p = -P / P.z, f r(p) p.
{
	my @c = through([numbers(0.5, 1, -2)], rodrigues(numbers(0.02, -0.01, 0.03)));
	my @t = numbers(-0.1, 0.2, -5);
	@c = map { $c[$_] + $t[$_] } 0 .. 2;
	my ($x, $y) = map { -$_ } @{divided(@c)};
	my $r = $x * $x + $y * $y;
	my $s = 400 * (1 + number(-0.1) * $r + number(0.02) * $r * $r);
	near('Bundle Adjustment in the Large', [whole('camera=', qr/%\.3f/ => '%.17g')],
	    [$s * $x, $s * $y]);
}

# EuRoC: T_BS leads from the camera to the body, and q and p from there to the world;
# what the recipe of lenses does with a scene leads on to the pixel.
my ($bends) = (grep { /fisheye_model/ } @whole)[0] =~
    /( && \\\n  k=.*?) && \\\n  echo/s;
my ($yaml, @truth) = (slurp('testdata/cameras/sensor.yaml'), lines('groundtruth.csv'));
my ($t_bs, $fu, $disto) = map { [numbers(split /,\s*/)] }
    map { $yaml =~ /\n$_:[^\[]*\[([^\]]*)/ }
    qw(T_BS intrinsics distortion_coefficients);
my @t_bs = rows(4, @$t_bs);
my @from_body = inverse(map { [@$_[0 .. 2]] } @t_bs[0 .. 2]);
for my $line (@truth[1, 2]) {
	my ($time) = split /,/, $line;
	my (undef, @n) = numbers(split /,/, $line);
	my @from_world = transposed(turn(@n[4 .. 6, 3]));
	my @points = ([2.75, 2.5, 0.5], [2, 3, 0.75]);
	my $json = '[' . join(', ', map { '[' . join(', ', @$_) . ']' } @points) . ']';
	my $recipe = $recipe{'sensor.yaml'}[0] =~ s/1520500401312143104/$time/r;
	my ($status, $out, $err) = run("scene=\$($recipe)" .
	    ($bends =~ s/\[\[.*?\]\]/$json/r =~ s/-d 3//r), 'testdata');
	near("EuRoC, $time", [map { [split] } split /\n/, $out], map {
		my @c = through(minus([numbers(@$_)], [@n[0 .. 2]]), @from_world);
		@c = through(minus(\@c, [map { $_->[3] } @t_bs[0 .. 2]]), @from_body);
		my ($u, $v) = bent($c[0] / $c[2], $c[1] / $c[2], @$disto);
		[$fu->[2] + $fu->[0] * $u, $fu->[3] + $fu->[1] * $v]
	} @points);
}

{
	my ($up, $round) = map { $_ * Math::BigFloat->bpi(90) / 180 } numbers(20, 30);
	near('an orbit', [whole('azimuth', qr/-d 3/ => '')],
	    [5 * $up->copy->bcos * $round->copy->bsin, 1 + 5 * $up->copy->bsin,
	    5 * $up->copy->bcos * $round->copy->bcos]);
}

# A distance along the ray: the point is as far from the eye, and on the pixel's ray.
my @far = whole('append --ray', qr/awk/ => 'awk -v OFMT=%.17g',
    qr/echo 400 300 2.5/ => "printf '400 300 2.5\n10 20 0\n10 20 nan\n10 20 -1\n'");
is("@{pop @far}", 'nan nan nan', 'no distance') for 1 .. 3;
my @ray = numbers(0.1, 0.075, 1);
my $norm = dot(\@ray, \@ray)->bsqrt;
near('depth along the ray', \@far, [map { number(2.5) * $_ / $norm } @ray]);

# What a recipe assumes of its file: with another file it prints nothing but the reason,
# and ends with another status than 0.
for my $case (
    ['camera_info.json' => 'viewport: .width, height.,',
	['"binning_x": 0' => '"binning_x": 2', 'binning'],
	['"binning_y": 0' => '"binning_y": 4', 'binning'],
	['"x_offset": 0' => '"x_offset": 16', 'roi'],
	['"height": 0, "width": 0' => '"height": 240, "width": 320', 'roi'],
	['plumb_bob' => 'equidistant', 'distortion_model'],
	['plumb_bob' => 'rational_polynomial', 'distortion_model']],
    ['camera_info.yaml' => 'camera_info.yaml',
	['plumb_bob' => 'equidistant', 'distortion_model'],
	['distortion_model: plumb_bob' => 'x: 1', 'no distortion_model'],
	['projection_matrix' => 'x', 'no projection_matrix']],
    ['camera_info_left.json' => 'camera_info_left',
	['341.12068, 0.0' => '339.5, 0.0', 'cx of the cameras differ'],
	['415.97421' => '415.5', 'not the left and the right'],
	['"binning_x": 0' => '"binning_x": 2', 'binning'],
	['"y_offset": 0' => '"y_offset": 8', 'roi'],
	['plumb_bob' => 'equidistant', 'distortion_model']],
    ['camera_info.json' => 'camera_info_left',
	['-49.918765' => '0.0', 'not the left and the right'],
	['-49.918765' => '49.918765', 'not the left and the right']],
    ['pnp.json' => 'fisheye_model',
	['0.0 ]\n    },\n    "rvec"' => '0.0, 0.1 ]\n    },\n    "rvec"',
	    'coefficients'],
	['0.0 ]\n    },\n    "rvec"' => '0, 0, 0, 0, 0, 0, 0, 0, 0, 0]},"rvec"',
	    'coefficients'],
	['"image_width"' => '"fisheye_model": 1, "image_width"', 'fisheye_model'],
	['"image_width"' => '"fisheye_model": true, "image_width"', 'fisheye_model']],
    ['realsense.txt' => 'realsense',
	['[0 0 0 0 0]' => '[-0.055 0.066 0 0 -0.02]', 'undistort first'],
	['Brown Conrady' => 'Kannala Brandt4', 'undistort first']],
    ['cameras.txt' => 'images.txt',
	['PINHOLE 4000 2250 2950.5' => 'SIMPLE_RADIAL 4000 2250', 'SIMPLE_RADIAL'],
	['PINHOLE' => 'OPENCV_FISHEYE', 'undistort OPENCV_FISHEYE first']],
    ['images.txt' => 'images.txt', ['frame1.jpg' => 'x.jpg', 'no picture frame1.jpg']],
    ['sfm_data.json' => 'sfm_data',
	['"disto_k3": [0.0' => '"disto_k3": [0.01', 'undistort first'],
	['disto_k3' => 'fisheye', 'undistort first'],
	['focal_length' => 'spherical', 'undistort first'],
	['"b.jpg"' => '"x.jpg"', 'no picture b.jpg'],
	['"id_pose": 1' => '"id_pose": 9', 'no pose']],
    ['sfm.json' => 'sfm.json',
	['"2", "8"' => '"2", "4"', 'version before 1.2.5'],
	['"poseId": "2291", "intrinsicId"' => '"poseId": "2291", "rigId": "1", "intrinsicId"',
	    'rigId'],
	['["0", "0", "0"]' => '["0.1", "0", "0"]', 'undistort first'],
	['radialk3' => 'fisheye4', 'undistort first'],
	['pinhole' => 'equidistant', 'undistort first'],
	['IMG_2' => 'IMG_3', 'no picture IMG_2.jpg'],
	['"poseId": "2291", "pose"' => '"poseId": "1", "pose"', 'no pose']],
    ['cameras.xml' => 'cameras.xml',
	['<k2>0' => '<k2>0.01', 'undistort first'],
	['mm" type="frame"' => 'mm" type="fisheye"', 'not a frame'],
	['class="adjusted"' => 'class="initial"', 'not adjusted'],
	['DJI_0002' => 'DJI_0003', 'not aligned'],
	['DJI_0003' => 'DJI_0004', 'no camera DJI_0003']],
    ['transforms.json' => 'frames\[0\]',
	['"cx"' => '"k1": 0.1, "cx"', 'undistort first'],
	['"cx"' => '"is_fisheye": true, "cx"', 'undistort first'],
	['"cx"' => '"camera_model": "OPENCV_FISHEYE", "cx"', 'undistort first']],
    ['sensor.yaml' => 'sensor.yaml',
	['camera_model: pinhole' => 'camera_model: omni', 'camera_model'],
	['radial-tangential' => 'equidistant', 'distortion_model'],
	['-4.0921e-05' => '-4.0921e-05, 0, 0', 'not 4 coefficients']],
    ['groundtruth.csv' => 'sensor.yaml',
	['401312143104' => '401312143105', 'no such time']],
    ['blender.json' => 'blender',
	['"AUTO"' => '"VERTICAL"', 'sensor_fit'],
	['"lens"' => '"pixel_aspect_x": 2, "pixel_aspect_y": 1, "lens"', 'pixel_aspect_x'],
	['"lens"' => '"resolution_percentage": 50, "lens"', 'resolution_percentage'],
	['"lens"' => '"type": "ORTHO", "lens"', 'type']]) {
	my ($file, $what, @changes) = @$case;
	my ($command) = grep { /$what/ } @whole;
	for my $change (@changes) {
		my ($from, $to, $reason) = map { s/\\n/\n/gr } @$change;
		my $text = slurp("testdata/cameras/$file");
		$text =~ s/\Q$from\E/$to/ or die "$file has no $from\n";
		spew("$tmp/$file", $text);
		$to =~ s/\s+/ /g;
		my ($status, $out, $err) = run($command =~ s{cameras/\Q$file\E}{$tmp/$file}gr =~
		    s/\| sed -n 3p//r, 'testdata');
		ok($status != 0 && $out eq '' && $err =~ /\Q$reason\E/, "$to stops $file")
		    or diag("$status $out $err");
	}
}

# What says the same in other words does not stop it.
for my $case (
    ['camera_info.json' => 'viewport: .width, height.,',
	['"height": 0, "width": 0' => '"height": 480, "width": 640'], ['"p":' => '"P":']],
    ['pnp.json' => 'fisheye_model',
	['"image_width"' => '"fisheye_model": 0, "image_width"']],
    ['realsense.txt' => 'realsense', ['Brown Conrady' => 'None']],
    ['transforms.json' => 'frames\[0\]',
	['"cx"' => '"k1": 0, "is_fisheye": false, "camera_model": "PINHOLE", "cx"']],
    ['blender.json' => 'blender', ['"lens"' => '"resolution_percentage": 100, "lens"'],
	['"lens"' => '"pixel_aspect_x": 1, "pixel_aspect_y": 1, "type": "PERSP", "lens"']]) {
	my ($file, $what, @changes) = @$case;
	my ($command) = grep { /$what/ } @whole;
	for my $change (@changes) {
		my ($from, $to) = @$change;
		my $text = slurp("testdata/cameras/$file");
		$text =~ s/\Q$from\E/$to/ or die "$file has no $from\n";
		spew("$tmp/$file", $text);
		my @said = run($command =~ s{cameras/\Q$file\E}{$tmp/$file}gr, 'testdata');
		is("@said", join(' ', run($command, 'testdata')), "$to does not stop $file");
	}
}

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
