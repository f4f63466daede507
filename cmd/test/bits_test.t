#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that the output of the program for a fixed list of scenes, points and options
# has the digests of testdata/bits.sha256: with any compiler, with every copy of the
# loops that this processor runs, and with any number of threads.
# usage: bits_test.t [-w] [BUILD]; -w rewrites the digests: read the diff of
# the transcripts first.
use strict;
use warnings;
use Digest::SHA;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

my $digests = 'testdata/bits.sha256';

# Returns a number: an integer, with decimals, large, near a power of two, or beyond the
# limits of scenes.
sub number {
	my $n = below(1000) - 1000;
	$n = -$n if below(2);
	return pick($n, $n, "$n." . below(10000), $n . below(1000000),
	    "$n.0000000" . below(1000), $n / 64, '0', '-0',
	    "${n}e" . pick(9, 17, -9, -17, 30), "${n}e" . (below(280) - 140));
}

# Returns a number of about the size of a scene.
sub near { (below(2001) - 1000) / pick(100, 128, 300) }

sub triple { '[' . join(',', map { $_[0]->() } 1 .. 3) . ']' }

sub camera {
	my $up = pick('[0,1,0]', '[0,0,1]', '[1,2,3]', triple(\&near));
	my $size = below(4) ? \&near : \&number;
	return '{"eye":' . triple($size) . ',' . pick(
	    '"at":' . triple($size) . ",\"up\":$up",
	    '"at":' . triple(\&near) . ',"roll":' . near(),
	    '"gaze":' . triple(\&near) . ",\"up\":$up",
	    '"orientation":[' . join(',', map { near() } 1 .. 4) . ']') . '}';
}

sub size { (1 + below(1000)) / pick(1, 3, 64) }

sub depths {
	my $near = size();
	return "\"near\":$near,\"far\":" . ($near + size()) .
	    pick('', ',"reverse_z":true');
}

sub edges {
	return '"left":' . -size() . ',"right":' . size() . ',"bottom":' .
	    -size() . ',"top":' . size();
}

my %projections = (
	persp => sub {
		return depths() . ',' . pick(
		    '"fovy":' . (1 + below(178)) . ',"aspect":' . size(),
		    '"fovx":' . (1 + below(1780) / 10) . ',"aspect":' . size(),
		    '"field":' . size() . ',"aspect":' . size(),
		    '"width":' . size() . ',"height":' . size(), edges());
	},
	ortho => sub {
		return depths() . ',' . pick(edges(),
		    '"width":' . size() . ',"height":' . size());
	},
	oblique => sub {
		return depths() . ',' . edges() . ',' . pick(
		    '"kind":"cabinet","direction":' . below(360),
		    '"kind":"cavalier","plane":' . near(),
		    '"angle":' . (1 + below(89)) . ',"direction":' . near());
	},
	volume => sub {
		my $near = size();
		return '"half_width":' . size() . ',"half_height":' . size() .
		    ",\"z_near\":$near,\"z_far\":" . ($near + size()) . ',' .
		    pick('"inverse_eye_z":' . -1 / size(),
			'"tan_skew":[' . near() . ',' . near() . ']',
			'"eye":[' . near() . ',' . near() . ',' . -size() .
			']');
	},
);
my @types = sort keys %projections;
my @conventions = qw(d3d gl vulkan webgpu);
my @d3d = ('-c', 'd3d');

sub projection {
	my ($type) = @_;
	return "{\"type\":\"$type\"," . $projections{$type}->() . '}';
}

sub viewport {
	return '{"width":' . size() . ',"height":' . size() . pick('',
	    ',"x":' . near() . ',"y":' . near(), ',"scale":"uniform"',
	    ',"min_z":0.25,"max_z":' . size()) . '}';
}

sub world {
	return '[' . join(',', map { map({ near() } 1 .. 3), $_ } 0, 0, 0, 1) .
	    ']';
}

sub scene {
	my ($type) = @_;
	return '{"camera":' . camera() . ',"projection":' . projection($type) .
	    ',"viewport":' . viewport() . pick('', ',"world":' . world()) .
	    '}';
}

sub flat {
	return '{"window":' . pick('{' . edges() . '}', '{"center":[' . near() .
	    ',' . near() . '],"width":' . size() . ',"height":' . size() .
	    ',"zoom":' . size() . ',"adapt":"' . pick(qw(stretch grow shrink)) .
	    '"}') . ',"device":{"width":' . size() . ',"height":' . size() .
	    ',"x":' . near() . pick('', ',"origin":"top-left"') . '}}';
}

# Returns n points of $size coordinates, a few of which may be any numbers.
sub points {
	my ($n, $size) = @_;
	return map { join(' ', map { below(8) ? near() : number() }
	    1 .. $size) . "\n" } 1 .. $n;
}

# Returns random bits as doubles: from 1e-150 to 1e150, but one in $wild is any double.
sub any_bits {
	my ($n, $wild) = @_;
	return pack 'v*', map {
		my $range = below(2) << 15 | (525 + below(996)) << 4;
		(map { below(65536) } 1 .. 3), $wild && below($wild) == 0 ?
		    below(65536) : $range | below(16)
	} 1 .. $n;
}

# The commands by group. Those of the groups of %once print a matrix, for which no loop
# over points runs.
my (%runs, @groups);
my %once = map { $_ => 1 } 'lookat', 'windows', @types;

sub add {
	my ($group, @arguments) = @_;
	push @groups, $group if !$runs{$group};
	push @{$runs{$group}}, [@arguments];
}

sub make_files {
	for my $size (2 .. 4) {
		my @points = points(150, $size);
		spew("$tmp/$size.text", join '', @points);
		spew("$tmp/$size.csv", join '', map { tr/ /,/r } @points);
		spew("$tmp/$size.json", join '', map { tr/ /,/r =~
		    s/^(.*)$/[$1,"a"]/r =~ s/(?<=[\[,])(-?)\./${1}0./gr }
		    @points);
		spew("$tmp/$size.f64", pack 'd<*', map { split } @points);
		spew("$tmp/$size.f32", any_bits($size * 60));
	}
	spew("$tmp/any.f64", any_bits(3 * 600, 50));
	spew("$tmp/many", join '', points(20000, 3));
	spew("$tmp/many.f64", any_bits(3 * 20000));
}

sub make_matrices {
	for my $i (0 .. 23) {
		my @c = ('-c', $conventions[$i % 4]);
		add('lookat', 'lookat', @c, camera());
		add($_, $_, @c, projection($_)) for @types;
		add('windows', $_, flat()) for qw(w2n n2d w2d d2w);
	}
	add('2D', $_, flat(), "$tmp/2.text") for qw(w2n n2d w2d d2w);
}

my @ways = ([qw(model device)], [qw(model clip)], [qw(world ndc)],
    [qw(world view)], [qw(view ndc)], [qw(clip device)], [qw(clip model)],
    [qw(ndc world)], [qw(device model)], [qw(device clip)]);

sub make_points {
	for my $i (0 .. 4 * @ways - 1) {
		my ($from, $to) = @{$ways[$i % @ways]};
		my $size = $from eq 'clip' ? 4 : 3;
		my @c = ('project', '-c', $conventions[$i % 4], '--from', $from,
		    '--to', $to, scene($types[$i / @ways]), "$tmp/$size.text");
		add('exact', @c);
		add('double', @c, '-p', 'double');
		add('single', @c, '-p', 'single');
		add('decimals', @c, '-d', pick(9, 3, 1));
	}
}

sub make_options {
	my @formats = qw(text csv json f64 f32);
	for my $in (@formats) {
		my @c = ('project', @d3d, '-i', $in, '--keep-going', scene('persp'),
		    "$tmp/3.$in");
		add('formats', @c, '-o', $_) for @formats;
		add('formats', @c, '--flags', '-o', 'text');
		add('formats', @c, '--visible', '-o', 'json');
	}
	for my $type (@types) {
		my $scene = scene($type);
		add('styles', 'project', @d3d, $scene, "$tmp/3.text", @$_)
		    for ['-d', 3], ['-d', 40], ['--digits', 4],
		    ['--digits', 25], ['-H'], ['--flags'], ['--visible'];
		add('rays', 'project', @d3d, '--ray', $scene, "$tmp/2.text");
		add('pick', 'pick', @d3d, '--at', '1,1', '--radius', 10,
		    $scene, "$tmp/3.text", @$_) for [], ['-o', 'json'];
		add('inspect', 'inspect', '-c', $_, $scene) for @conventions;
		add('fit', 'fit', '-c', $_, $scene, '[[1,2,3],[4,6,8]]')
		    for @conventions;
		add('any bits', 'project', @d3d, '-i', 'f64', '--keep-going',
		    $scene, "$tmp/any.f64", @$_) for [], ['-p', 'double'], ['-p', 'single'],
		    ['-o', 'f32'], ['--flags', '-o', 'text'];
	}
}

sub make_streams {
	my $scene = scene('persp');
	add('text stream', 'project', @d3d, $scene, "$tmp/many");
	add('binary stream', 'project', @d3d, '-i', 'f64', $scene,
	    "$tmp/many.f64");
}

sub make_windows {
	for my $command (qw(w2n n2w n2d d2n w2d d2w)) {
		add('2D', $command, flat());
		add('2D', $command, '--keep-going', flat(), @$_)
		    for ["$tmp/2.text", '--flags'], ["$tmp/2.csv", '--visible'],
		    ['-p', 'double', "$tmp/2.text"],
		    ['-p', 'single', "$tmp/2.text"],
		    map { ['-i', $_, "$tmp/2.$_"] } qw(json f64 f32);
	}
}

sub digest {
	my ($group, @more) = @_;
	my $sha = Digest::SHA->new(256);
	for my $run (@{$runs{$group}}) {
		my ($status, $out) = run(join ' ', 'projcalc',
		    map { "'" . s/'/'\\''/gr . "'" } @$run, @more);
		$sha->add($out, '|', $status, "|0\n");
	}
	return $sha->hexdigest;
}

make_files();
make_matrices();
make_points();
make_options();
make_streams();
make_windows();

if ($write) {
	spew($digests, join '', map { digest($_) . "  $_\n" } @groups);
	exit;
}

my %want = reverse slurp($digests) =~ /^(\S+)  (.*)/mg;

is(digest($_), $want{$_}, $_) for grep { $once{$_} } @groups;
@groups = grep { !$once{$_} } @groups;
for my $cpu (qw(baseline avx2 avx512 neon)) {
	local $ENV{PROJCALC_CPU} = $cpu;
	SKIP: {
		skip "no $cpu here", scalar @groups
		    if (run('projcalc w2n \'{"center":[0,0],"width":1,"height":1}\' []'))[0] != 0;
		is(digest($_), $want{$_}, "$_, $cpu") for @groups;
	}
}
for my $group (grep { /stream/ } @groups) {
	is(digest($group, '-j', $_), $want{$group}, "$group, -j $_")
	    for 1, 2, 3, 7;
}
done_or('make bits');
