#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Draws random calls: commands, options, scenes and points in every format, right and
# wrong. Each call must give the same output, messages and status
# - with one program: with the loops of this processor and without, on one thread and
#   on several, from a file and a pipe that is cut anywhere, and of scenes of --scenes
#   what each of them gives alone;
# - with two: from both. Differences are counted by class. For each class the first one
#   is made as short as possible, and kept as a call in a folder of its own.
# usage: differential.pl PROGRAM [OTHER] [SECONDS] [SEED]; SECONDS of the processor,
# default 10; SEED, default the time. The same seed draws the same calls.
use strict;
use warnings;
use File::Spec;
use File::Temp 'tempdir';
use POSIX ();
use Time::HiRes qw(sleep time);

my $usage = "usage: differential.pl PROGRAM [OTHER] [SECONDS] [SEED]\n";
my @programs = map { File::Spec->rel2abs($_) }
    splice @ARGV, 0, 1 + (@ARGV > 1 && $ARGV[1] !~ /^\d+$/);
die $usage if !@programs || @ARGV > 2 || grep { !/^\d+$/ } @ARGV;
for (@programs) {
	die "$_ is no program\n" if !-x || -d;
}
my ($seconds, $seed) = ($ARGV[0] // 10, $ARGV[1] // int time);
$ENV{LC_ALL} = 'C';
delete @ENV{qw(PROJCALC_CPU NO_COLOR)};
$SIG{PIPE} = 'IGNORE';

# Random numbers by Park and Miller, begun anew for each call, so that a call can be
# drawn alone.
my $state;

sub begin {
	my ($n) = @_;
	$state = ($seed * 1000003 + $n * 7919) % 2147483646 + 1;
	below(2) for 1 .. 3;
}

sub below {
	$state = $state * 48271 % 2147483647;
	return $state % $_[0];
}

sub pick { $_[below(scalar @_)] }
sub one_in { below($_[0]) == 0 }
sub some { $_[0] ? @_[1 .. $#_] : () }

sub shuffled {
	my @from = @_;
	return map { splice @from, below(scalar @from), 1 } 1 .. @from;
}

# ---- Numbers

sub digits { join '', map { below(10) } 1 .. $_[0] }

my @usual = (
	sub { (below(20001) - 10000) / pick(1000, 2000, 4096) },
	sub { sprintf '%.6f', (below(4000001) - 2000000) / 1000000 },
	sub { sprintf '%.3f', (below(20001) - 10000) / 2999 },
	sub { below(20) - 10 },
	sub { sprintf '%.17g', (below(2000001) - 1000000) / 199983 },
);
my @rare = (
	sub { pick('', '-') . digits(1 + below(6)) . '.' . digits(1 + below(24)) },
	sub { pick('', '-') . (1 + below(9)) . digits(13 + below(8)) },
	sub { 9007199254740993 + 2 * below(1000000) },
	sub { '0.' . '0' x below(24) . (1 + digits(1 + below(8))) },
	sub { pick('-0', '0', '-0.0', '0.000', '1e2', '-2.5E-1', '1e+3') },
	sub { (below(2000) - 1000) . 'e' . (below(60) - 30) },
);
my @odd = (qw(+1.5 .5 5. -.5 1e400 1e-400 1e151 -nan inf -Infinity true 0x10 1..2
    1.2.3 --1 - . -. +-1 1-2 1e 1.5e-x x 1/2 12:30 "1.5" "1 1" 1"2 " 007.5 [1
    {"x":1} [1]), '1,5', '#1', "1\xe9", "\xef\xbb\xbf1", "1\0", "1\x1b", '9' x 33, '1' x 400,
    '1' . '0' x 150, '-' . '1' x 32);
my @missing = ('', '', 'nan', 'NaN', 'NA', 'null', 'None', '?', '-');

sub usual { pick(@usual)->() }
sub number { one_in(12) ? pick(@rare)->() : usual() }

# Returns numbers of scenes, of which JSON takes fewer forms.
sub near {
	my $n = one_in(30) ? pick(@rare)->() : usual();
	return $n =~ /^(-?)0+(?=\d)(.*)/ ? "$1$2" : $n;
}

sub size { (1 + below(1000)) / pick(64, 100, 300) }
sub list { '[' . join(pick(',', ', '), @_) . ']' }
sub vector { list(map { near() } 1 .. $_[0] // 3) }

# ---- Scenes: an object is a list of pairs of a name and a text or an object, so that
# a fault can be put anywhere.

my $radians;

sub angle {
	my ($degrees) = @_;
	return $radians ? $degrees * 0.017453292519943295 : $degrees;
}

sub object {
	my @pairs;
	push @pairs, [splice @_, 0, 2] while @_;
	return one_in(3) ? [shuffled(@pairs)] : \@pairs;
}

sub quoted { "\"$_[0]\"" }

sub json {
	my ($value, $indent) = @_;
	return $value if !ref $value;
	my ($gap, $end) = $indent ? ("\n$indent", "\n" . substr $indent, 2) :
	    ('', '');
	my $space = $indent ? ' ' : '';
	return '{' . join(',', map { $gap . quoted($_->[0]) . ":$space" .
	    json($_->[1], $indent && "$indent  ") } @$value) . "$end}";
}

sub rows {
	my ($columns, @numbers) = @_;
	return list(@numbers) if !$columns;
	return list(map { list(splice @numbers, 0, $columns) }
	    1 .. @numbers / $columns);
}

# Returns a rotation by an angle about an axis, row after row.
sub rotation {
	my ($s, $c) = (pick([0, 1], [0.6, 0.8], [1, 0], [0.28, 0.96],
	    [sin 1, cos 1]))->@*;
	return pick([1, 0, 0, 0, $c, $s, 0, -$s, $c], [$c, 0, -$s, 0, 1, 0, $s, 0, $c],
	    [$c, $s, 0, -$s, $c, 0, 0, 0, 1])->@*;
}

sub affine {
	my @r = one_in(3) ? map { near() } 1 .. 9 : rotation();
	my @t = map { near() } 1 .. 3;
	my @row = (@r[0 .. 2], 0, @r[3 .. 5], 0, @r[6 .. 8], 0, @t, 1);
	my @column = map { my $i = $_; map { $row[$i + 4 * $_] } 0 .. 3 } 0 .. 3;
	return pick(rows(4, @row), rows(4, @column)) if one_in(8);
	return pick(rows(0, @row), rows(4, @column[0 .. 11]), rows(3, @r, @t),
	    object(matrix => rows(4, @row), vectors => '"row"'));
}

# Returns a rotation vector, mostly of a length that is allowed.
sub turn { one_in(20) ? vector() : list(map { near() / 6 } 1 .. 3) }

sub step {
	return object(pick(
	    [translate => vector()], [scale => pick(size(), vector())],
	    ['rotate_' . pick(qw(x y z)) => angle(below(360) - 180)],
	    [rotate => object(axis => vector(), angle => angle(near()))],
	    [quaternion => vector(4)], [quaternion_wxyz => vector(4)],
	    [rvec => turn()], [matrix => affine()],
	    [node => object(translation => vector(), some(below(2),
	    rotation => vector(4)), some(below(2), scale => vector()))])->@*);
}

sub frame {
	return affine() if below(2);
	my $steps = '[' . join(',', map { json(step()) } 1 .. 1 + below(3)) . ']';
	return one_in(4) ? "[{\"inverse\":$steps}]" : $steps;
}

sub camera {
	my $way = below(7);
	return object(pose => frame(), some(one_in(4), orthonormalize => 'true'))
	    if $way == 0;
	return object(matrix => frame(), some(one_in(4), orthonormalize => 'true'))
	    if $way == 1;
	my @roll = some(one_in(3), roll => angle(near()));
	return object(translation => vector(),
	    pick([orientation => vector(4)], [rvec => turn()])->@*, @roll)
	    if $way == 2;
	my @up = some(one_in(3), up => pick('[0,1,0]', '[0,0,1]', vector()));
	return object(eye => pick(vector(), '[0,0,-5]', '[1,2,-8]'),
	    pick([at => pick(vector(), '[0,0,0]'), @up], [at => vector(), @up],
	    [gaze => vector(), @up], [orientation => vector(4)],
	    [rvec => turn()])->@*, @roll);
}

sub edges {
	return (left => -size(), right => size(), bottom => -size(), top => size());
}

sub persp {
	my ($bare) = @_;
	my $near = size() / 8;
	my @depths = (near => $near, far => one_in(8) ? '"infinity"' : $near + 9 *
	    size());
	my @aspect = some($bare || one_in(4), aspect => size());
	my @at = some(one_in(6), edges_at => size());
	my $way = below(8);
	return (intrinsics => pick(list(80, 81, 32, 24), '[[80,0,32],' .
	    '[0,80,24],[0,0,1]]', '[70,1,30,2,0,71,20,3,0,0,1,0.5]',
	    list(map { 20 * size() } 1 .. 4)), some(below(2), @depths))
	    if $way == 0;
	return (@depths, some(one_in(4), reverse_z => 'true'),
	    pick(
	    [fovy => angle(1 + below(178)), @aspect],
	    [fovy => angle(60), @aspect], [fovx => angle(1 + below(1780) / 10), @aspect],
	    [view_angle => angle(1 + below(178)), @aspect],
	    [field => size(), @aspect],
	    [width => size(), height => size(), @at], [edges(), @at],
	    [angles => list(map { angle($_) } -1 - below(80), 1 + below(80),
		-1 - below(80), 1 + below(80))])->@*);
}

sub parallel {
	my ($bare) = @_;
	my $near = near();
	return (near => $near, far => $near + 9 * size(),
	    some(one_in(4), reverse_z => 'true'), pick([edges()],
	    [width => size(), height => size()],
	    [pick(qw(width height)) => size(), some($bare, aspect => size())])->@*);
}

my %projections = (
	persp => \&persp,
	ortho => \&parallel,
	oblique => sub {
		return (parallel(@_), pick([kind => '"cabinet"'],
		    [kind => '"cavalier"'], [angle => angle(1 + below(89))])->@*,
		    some(below(2), direction => angle(pick(below(360), near()))),
		    some(one_in(3), plane => near()));
	},
	volume => sub {
		my $near = size() / 8;
		return (z_near => $near, z_far => $near + 9 * size(),
		    pick([half_width => size(), half_height => size()],
		    [size => size(), aspect => size()])->@*,
		    pick([], [inverse_eye_z => -1 / size(), tan_skew => vector(2)],
		    [tan_skew => vector(2)], [eye => list(near(), near(), -size())],
		    [view_angle => angle(1 + below(120))])->@*);
	},
	matrix => sub {
		my $n = size();
		my $f = 2 * $n + size();
		my $q = $f / ($f - $n);
		my @row = (size(), 0, 0, 0, 0, size(), 0, 0, near(), near(), $q, 1,
		    0, 0, -$n * $q, 0);
		@row = map { near() } 1 .. 16 if one_in(5);
		return (matrix => pick(rows(0, @row), rows(4, @row), rows(4, map {
		    my $i = $_; map { $row[$i + 4 * $_] } 0 .. 3 } 0 .. 3)));
	},
);

sub projection {
	my ($type, $bare) = @_;
	my @members = $projections{$type}->($bare);
	return object(some(!$bare, type => quoted($type)), @members);
}

sub viewport {
	return object(pick([width => 640, height => 480],
	    [width => 100 * size(), height => 100 * size()])->@*,
	    some(one_in(3), x => near(), y => near()),
	    some(one_in(5), scale => pick('"uniform"', '"fill"', '[300,200]')),
	    one_in(16) ? (depth => '"distance"') :
	    some(one_in(5), min_z => 0.25, max_z => size()));
}

my @conventions = qw(d3d gl vulkan webgpu opencv);

sub convention {
	return quoted(pick(@conventions)) if below(4);
	return object(some(below(2), handedness => pick('"left"', '"right"')),
	    some(below(2), view_y => pick('"up"', '"down"')),
	    some(below(2), depth => pick('"zero_to_one"', '"minus_one_to_one"')),
	    some(below(2), vectors => pick('"row"', '"column"')),
	    some(below(2), ndc_y => pick('"up"', '"down"')),
	    some(below(2), origin => pick('"top-left"', '"bottom-left"')));
}

sub window {
	my ($has_device) = @_;
	return object(pick([edges()], [center => vector(2), width => size(),
	    height => size()])->@*, some(one_in(3), zoom => size()),
	    some(one_in(4), pan => vector(2)), some(one_in(5), about => vector(2)),
	    some($has_device && one_in(3), adapt => quoted(pick(qw(stretch grow shrink)))));
}

sub device {
	return object(width => 100 * size(), height => 100 * size(),
	    some(one_in(3), x => near(), y => near()),
	    some(one_in(3), origin => pick('"top-left"', '"bottom-left"')));
}

my @flat = qw(w2n n2w n2d d2n w2d d2w);
my %is_flat = map { $_ => 1 } @flat;
my @commands = (qw(lookat persp ortho oblique volume trace pick fit inspect inspect),
    ('project') x 8, @flat);

sub points_member { one_in(3) ? vector() : list(map { vector() } 1 .. 1 + below(4)) }

# Returns the members of a scene that a command reads.
sub members {
	my ($command, $has_points) = @_;
	return (window => window(1), device => device()) if $is_flat{$command};
	return (camera => camera()) if $command eq 'lookat';
	my $type = pick(qw(persp persp persp ortho oblique volume matrix));
	$type = $command if $projections{$command} && below(20);
	my @projection = (projection => projection($type));
	return (@projection, viewport => viewport()) if $projections{$command};
	return (some(below(8), window => window(1)), device => device(),
	    some(!$has_points && below(3), bounds => object(min => '[-1,-2]',
	    max => list(size(), size()))))
	    if $command =~ /^(?:fit|inspect)$/ && one_in(8);
	return (some(one_in(3), world => frame()), some(below(8), camera => camera()),
	    some(below(30), @projection), some(below(40), viewport => viewport()),
	    some($command =~ /^(?:fit|inspect)$/ && !$has_points && below(6),
	    bounds => pick(object(center => vector(), radius => size()),
	    object(min => '[-3,-2,-1]', max => list(map { size() } 1 .. 3)))),
	    some($command eq 'fit' && one_in(3), margin => below(90) / 200),
	    some($command eq 'pick' && one_in(3), pick => object(at => vector(2),
	    radius => 100 * size())));
}

# Returns a value that is seldom right.
sub odd_value {
	return pick('null', 'true', '1e151', '-1', '0', '""', '"x"', '[]', '{}', '[1]',
	    '[1,2]', '[1,2,3]', '"infinity"', '1e-151', '01', '1.', 'nan', '1e400',
	    '"\u0000"', "\"\xff\"", '180', '[[1]]', '{"a":1}', '12345678901234567890',
	    '0.' . digits(70));
}

my @names = qw(camera eye at up fov fovy aspect near far type width height x y scale
    depth window projection matrix pose Eye znear _note points angle_unit left);

# Puts a fault into a text of bytes.
sub mangle {
	my ($text) = @_;
	my $at = below(1 + length $text);
	return substr $text, 0, $at if one_in(3);
	substr $text, $at, below(3), pick('', ',', '"', "\0", "\xe9", ' ', "\n", '}',
	    '[', '1', '-', "\r", '/', '\\', "\t", ';', 'x', "\x{c2}\x{a0}", '#');
	return $text;
}

sub objects {
	my ($value) = @_;
	return ref $value ? ($value, map { objects($_->[1]) } @$value) : ();
}

sub put_fault {
	my ($scene) = @_;
	my $object = pick(objects($scene));
	my $i = below(1 + @$object);
	return push @$object, [pick(@names), odd_value()] if $i == @$object;
	my $pair = $object->[$i];
	my $what = below(5);
	splice @$object, $i, 1 if $what == 0;
	push @$object, [@$pair] if $what == 1;
	$pair->[0] = pick(@names, uc $pair->[0], "$pair->[0]s") if $what == 2;
	$pair->[1] = odd_value() if $what > 2;
}

# The member that may stand alone in place of a scene.
my %alone = (lookat => \&camera, w2n => \&window, n2w => \&window,
    n2d => \&device, d2n => \&device,
    map { my $type = $_; $type => sub { projection($type, 1) } }
    qw(persp ortho oblique volume));

sub scene {
	my ($command, $has_points) = @_;
	$radians = one_in(6);
	my @unit = some($radians, angle_unit => '"radians"');
	my $scene = $alone{$command} && one_in(3) ? $alone{$command}->() :
	    object(some(below(12), convention => convention()),
	    members($command, $has_points), some(one_in(12), points => points_member()));
	push @$scene, \@unit if @unit;
	return $scene if below(8);
	put_fault($scene) for 0 .. below(2);
	return one_in(8) ? mangle(json($scene)) : $scene;
}

# ---- Points

my @words = ('a', 'label', 'two words', "\xc3\xa9", '', '#', "it's", '5" pipe', '17',
    'x' x 70);
my @titles = (([qw(x y z w)]) x 5, [qw(X Y Z W)], [qw(px py pz pw)],
    ['x [m]', 'y [m]', 'z [m]', 'w'], [qw(device_x device_y device_z device_w)],
    [qw(lon lat alt w)], [qw(nx ny nz nw)], [qw(a b c d)]);

# Draws what the lines of a file have in common.
sub style {
	my ($format, $size) = @_;
	return {
		format => $format,
		size => $size,
		separator => $format eq 'csv' ? pick((',') x 5, ', ', ';') :
		    $format eq 'tsv' ? "\t" :
		    pick((' ') x 5, "\t", ',', ', ', '  '),
		before => one_in(6) ? 1 + below(2) : 0,
		after => one_in(3) ? 1 + below(2) : 0,
		bad => pick(0, 0, 40, 10),
		missing => pick(0, 0, 0, 8),
		quotes => pick(0, 0, 0, 3, 1),
		aligned => one_in(5),
		end => one_in(5) ? "\r\n" : "\n",
		between => pick(0, 0, 10),
		usual => below(3) ? \&usual : \&number,
	};
}

sub word {
	my ($style) = @_;
	my $word = one_in(3) ? pick(@words) : pick(qw(a b lamp 7));
	return $word if $style->{format} !~ /csv|tsv/ || !$style->{quotes} || below(2);
	return pick('"a"', '"a,b"', '"a""b"', '"two words"', '" x "', '""', '"open',
	    "\"1\n2\"");
}

sub cell {
	my ($style) = @_;
	return pick(@odd) if $style->{bad} && one_in(4 * $style->{bad});
	return pick(@missing) if $style->{missing} && one_in($style->{missing});
	my $n = $style->{usual}->();
	return "\"$n\"" if $style->{quotes} && one_in($style->{quotes});
	return $style->{aligned} ? sprintf '%*s', 8 + below(4), $n : $n;
}

sub fields {
	my ($style) = @_;
	my $n = $style->{size};
	$n += below(3) - 1 if $style->{bad} && one_in(2 * $style->{bad});
	return (map({ word($style) } 1 .. $style->{before}),
	    map({ cell($style) } 1 .. $n), map({ word($style) } 1 .. $style->{after}));
}

# Returns a cell of JSON, which is seldom odd.
sub json_cell {
	my $cell = cell(@_);
	return $cell =~ /^ *-?(?:0|[1-9]\d*)(?:\.\d+)?(?:e[-+]?\d+)?$/i || one_in(20) ?
	    $cell : 'null';
}

sub array_line {
	my ($style) = @_;
	my @cells = map { json_cell($style) } 1 .. $style->{size};
	push @cells, map { pick('"a"', '"a,b]"', '7', 'null', '{"a":[1,2]}', '"\"q\""',
	    'true', '[]') } 1 .. $style->{after};
	return list(@cells);
}

sub object_line {
	my ($style) = @_;
	my @members = map { '"' . (qw(x y z w)[$_] // "c$_") . '":' . json_cell($style) }
	    0 .. $style->{size} - 1;
	push @members, '"id":' . pick(7, '"a"', '"a,{b}"', 'null', '[1,{"x":2}]')
	    if $style->{after};
	unshift @members, '"name":"b"' if $style->{before};
	@members = shuffled(@members) if one_in(10);
	my $comma = $style->{aligned} ? ', ' : ',';
	return '{' . join($comma, @members) . '}';
}

sub line {
	my ($style) = @_;
	return pick('', ' ', "\r", '# 1 2 3', '  #x', "\t") if $style->{between} &&
	    one_in($style->{between});
	return pick('x', '[1,2,3]', '{"x":1}', '1 2', '1,2', '"', ',', '1 2 3 4 5')
	    if $style->{bad} && one_in($style->{bad});
	return array_line($style) if $style->{format} eq 'json';
	return object_line($style) if $style->{format} eq 'objects';
	return join $style->{separator}, fields($style);
}

sub header {
	my ($style) = @_;
	my @titles = grep { defined } pick(@titles)->@[0 .. $style->{size} - 1];
	@titles = map { "\"$_\"" } @titles if $style->{quotes} && below(2);
	@titles = shuffled(@titles) if one_in(8);
	return join $style->{separator}, (map { "id$_" } 1 .. $style->{before}),
	    @titles, map { "more$_" } 1 .. $style->{after};
}

# Packs points as numbers of a binary format; the last may be cut off.
sub binary {
	my ($format, $size, $n) = @_;
	my $numbers = $format eq 'f32x4' ? 4 : $size;
	my @all = map { one_in(200) ? pick('nan', 'inf', 1e300, -0.0) : usual() + 0 }
	    1 .. $numbers * $n;
	my $bytes = pack $format eq 'f64' ? 'd<*' : 'f<*', @all;
	return one_in(20) ? substr $bytes, 0, below(1 + length $bytes) : $bytes;
}

# Returns the bytes of a file of points, and options that may go with it.
sub points {
	my ($format, $size) = @_;
	my $n = pick(1, 2 + below(4), 5 + below(40), one_in(3) ? 40 + below(260) : 3);
	return binary($format, $size, $n) if $format =~ /^f/;
	my $style = style($format, $size);
	my @options;
	push @options, ['--keep-going'] if $style->{bad} && below(4);
	push @options, ['--separator', ';'] if $style->{separator} eq ';' && below(8);
	my @lines = map { line($style) } 1 .. $n;
	if ($format =~ /csv|tsv/) {
		my $with = below(2);
		unshift @lines, header($style) if $with;
		push @options, [$with ? '--header' : '--no-header'] if one_in(4);
	}
	unshift @lines, pick('# x y z', '#', '# columns: id x y z', '') if one_in(12);
	push @options, ['--columns', columns($style)]
	    if $format ne 'objects' && $style->{before} ? below(8) : one_in(12);
	my $text = join $style->{end}, @lines;
	$text = '[' . join(pick(',', ",\n"), @lines) . ']'
	    if $format =~ /json|objects/ && one_in(6);
	$text .= $style->{end} if below(6);
	# A file of more than one piece, so that threads share it.
	$text x= 1 + 90000 / (1 + length $text) if $text =~ /\n\z/ && one_in(25);
	$text = "\xef\xbb\xbf$text" if one_in(40);
	return (one_in(14) ? mangle($text) : $text, @options);
}

sub columns {
	my ($style) = @_;
	return pick('x,y,z', 'y,x', '/x,/y,/z', 'x,y,w', 'x,y,z,w')
	    if $style->{format} eq 'objects';
	return pick('x,y,z', 'X,Y,Z', 'x,y', 'z,y,x') if $style->{format} =~
	    /csv|tsv/ && one_in(3);
	my $first = 1 + $style->{before};
	my @columns = $first .. $first + $style->{size} - 1;
	return join ',', one_in(5) ? shuffled(@columns) : @columns;
}

# ---- Calls

my @spaces = qw(model world view clip ndc device);

# Returns the options of a command, each as a list, and the size of its points.
sub options {
	my ($command, $format) = @_;
	my @o;
	my $words = $format =~ /^(?:text|csv|tsv|json|objects)$/;
	my $matrix = $command !~ /^(?:fit|inspect|pick|trace)$/;
	my $size = $is_flat{$command} ? 2 : 3;
	push @o, ['-c', pick(@conventions)] if one_in(4) && $command ne 'fit';
	push @o, pick(['-d', pick(0, 1, 3, 9, 20, '1,2', '3,0,1')],
	    ['--digits', pick(1, 4, 17, 25)]) if one_in(4) && $command ne 'fit';
	push @o, ['-p', pick(qw(exact double single))]
	    if one_in(5) && ($matrix || $command eq 'trace');
	push @o, ['-m'] if one_in(16) && $matrix;
	push @o, ['--unit-w'] if one_in(30) && $command =~ /^(?:project|persp|volume)$/;
	push @o, ['--append'] if one_in(5) && $matrix && ($words || one_in(9));
	push @o, ['-o', pick(qw(text csv tsv json f64 f32))] if one_in($matrix ? 5 : 20);
	my @about = (some(one_in(4) && ($words || one_in(9)), ['--flags']),
	    some(one_in(8), ['--visible']));
	push @o, @about if $is_flat{$command} && $format || $command eq 'trace';
	push @o, ['--from', pick(@spaces)] if $command eq 'trace' && one_in(3);
	if ($command eq 'project' && one_in(8)) {
		push @o, pick(['--ray'], ['--plane', pick('0,1,0,0', '0,0,1,-2',
		    '1,2,3,-4')]);
		push @o, @about if one_in(8);
		$size = 2;
	} elsif ($command eq 'project' && one_in(3)) {
		my ($from, $to) = shuffled(@spaces);
		push @o, ['--from', $from], ['--to', $to];
		$size = 4 if $from eq 'clip';
		push @o, ['-H'] if one_in(3);
	} elsif ($command eq 'project') {
		push @o, @about, some(one_in(10), ['-H']);
	}
	push @o, ['--at', pick('320,240', '1,1', '100.5,50')], ['--radius',
	    pick(10, 300, 1e4)] if $command eq 'pick' && below(8);
	push @o, pick(['--textbook'], ['--distances', '1,2,5'], ['-t', '1e-3'])
	    if $command eq 'inspect' && one_in(3);
	push @o, ['--keep-going'] if below(2);
	push @o, odd_option() if one_in(30);
	push @o, ['-q'] if one_in(10);
	push @o, ['--errors', 'json'] if one_in(5);
	$size += below(3) - 1 if one_in(25);
	return ($size, @o);
}

# Options that are wrong, or written in an unusual form.
sub odd_option {
	return pick(['--dig', 3], ['--decimals=2'], ['-d2'], ['-d', 'x'], ['-d', '-1'],
	    ['--from', 'space'], ['--to', 'pixel'], ['-i', 'f4'], ['-i', 'xml'],
	    ['-o', 'png'], ['-c', 'opengl'], ['--columns', '1,1'], ['--columns', '0'],
	    ['--columns', 'a'], ['--colour'], ['--color', 'always'], ['--flag'],
	    ['--fov', 60], ['--separator', 'ab'], ['--separator', 'tab'], ['-x'],
	    ['--append', '--append'], ['--plane', '0,0,0,1'], ['--at', '1'], ['-qH'],
	    ['--keep-going=1'], ['-p', 'quad'], ['--e', 'json'], ['--'], ['-t', '0']);
}

# Calls of words alone.
sub words {
	return (pick('help', '--help', '-V', '--version', 'projct', 'perspective', ''))
	    if one_in(3);
	return ('help', pick(@commands, qw(camera scene eye viewport world steps
	    convention fovy pick --json projection projct bounds zoom))) if below(2);
	return (pick(@commands), pick('--help', '-h', '-V', '--frobnicate', '{', '[]',
	    'nowhere.json', '{}', '{"a":1} {"b":2}', '--fovy=60', '0'));
}

my @formats = ((qw(text csv json objects)) x 3, qw(tsv f64 f32 f32x4));

# Draws a call: {command, options, scenes, points, file, way}. `way` says where scenes
# and points are: "inline" or "file" scenes with points from standard input; scenes
# on standard input with points in a file, or in two; points as an operand; or no scene,
# but words.
sub draw {
	my ($n) = @_;
	begin($n);
	if (one_in(50)) {
		my ($command, @words) = words();
		return {n => $n, command => $command, scenes => [], format => 'words',
		    options => [map { [$_] } @words], way => 'words'};
	}
	my %call = (n => $n, command => my $command = pick(@commands), scenes => []);
	my $kind = pick(@formats);
	my $has_points = $command =~ /^(?:project|trace|pick)$/ || $command ne
	    'inspect' && below(3);
	my ($size, @options) = options($command, $has_points ? $kind : '');
	my $scenes = one_in(5) ? 2 + below(8) : 1;
	push @options, ['--scenes'] if $scenes > 1;
	$call{scenes} = [map { scene($command, $has_points) } 1 .. $scenes];
	$call{indent} = one_in(4) ? '  ' : '';
	$call{way} = pick('inline', ('file') x 3, 'stdin', 'twice', 'operand');
	$call{way} = 'file' if $scenes > 1 && $call{way} =~ /inline|operand/;
	my $format = $kind eq 'objects' ? 'json' : $kind;
	$call{format} = $kind;
	if ($has_points) {
		($call{points}, my @more) = points($kind, $size < 1 ? 1 : $size);
		push @options, @more, ['-i', $format];
		$call{file} = 'points.' . ($kind eq 'objects' ? 'jsonl' : $format);
	}
	$call{options} = \@options;
	return \%call;
}

sub spew {
	my ($name, $text) = @_;
	open my $file, '>:raw', $name or die "$name: $!\n";
	print $file $text;
	close $file or die "$name: $!\n";
}

sub slurp {
	open my $file, '<:raw', $_[0] or die "$_[0]: $!\n";
	local $/;
	return <$file> // '';
}

# Writes the files of a call here. Returns its arguments and standard input's file.
sub files {
	my ($call) = @_;
	my $scenes = join "\n", map { json($_, $call->{indent}) } $call->{scenes}->@*;
	my @args = map { @$_ } $call->{options}->@*;
	return (\@args, '/dev/null') if $call->{way} eq 'words';
	my $has_points = defined $call->{points};
	spew($call->{file}, $call->{points}) if $has_points;
	if ($call->{way} eq 'inline' && $scenes =~ /^\{/ && $scenes !~ /\0/) {
		return ([@args, $scenes, $has_points ? '-' : ()],
		    $has_points ? $call->{file} : '/dev/null');
	}
	spew('scene.json', "$scenes\n");
	return ([@args, '-', ($has_points ? $call->{file} : ()) x
	    (1 + ($call->{way} eq 'twice'))], 'scene.json')
	    if $call->{way} =~ /stdin|twice/;
	return ([@args, 'scene.json', $call->{points}], '/dev/null')
	    if $call->{way} eq 'operand' && $has_points &&
	    $call->{points} =~ /\A\[[^\0]{0,2000}\z/;
	return ([@args, 'scene.json', $has_points ? '-' : ()],
	    $has_points ? $call->{file} : '/dev/null');
}

# ---- Runs

# Waits until the reader has taken what is in the pipe, or for a few milliseconds, as it
# may have ended, or wait for its output.
my $FIONREAD = 0x541b;

sub wait_for_reader {
	my ($pipe) = @_;
	for (1 .. 20) {
		my $left = pack 'i', 0;
		return sleep 0.0001 if !ioctl $pipe, $FIONREAD, $left;
		return if unpack('i', $left) == 0;
		sleep 0.0001;
	}
}

# Writes a file to a pipe in pieces: a few, or if it is short single bytes.
sub feed {
	my ($pipe, $name) = @_;
	my $text = slurp($name);
	my @at = length $text < 60 && one_in(4) ? (1 .. length $text) :
	    map { below(1 + length $text) } 1 .. 1 + below(4);
	my $from = 0;
	for my $to (sort({ $a <=> $b } @at), length $text) {
		next if $to == $from;
		syswrite($pipe, $text, $to - $from, $from) // last;
		$from = $to;
		wait_for_reader($pipe);
	}
	close $pipe;
}

my $runs = 0;

# Runs a program. Returns its output, its messages and its status.
sub answer {
	my ($program, $command, $args, $from, %how) = @_;
	$runs++;
	my ($reader, $writer);
	$how{pipe} and (pipe $reader, $writer or die "pipe: $!\n");
	my $pid = fork // die "fork: $!\n";
	if ($pid == 0) {
		$ENV{PROJCALC_CPU} = $how{cpu} if $how{cpu};
		alarm 60;
		close $writer if $how{pipe};
		$how{pipe} ? open STDIN, '<&', $reader : open STDIN, '<', $from;
		open STDOUT, '>', 'out';
		open STDERR, '>', 'err';
		exec {$program} $program, $command,
		    ($how{jobs} ? "-j$how{jobs}" : ()), @$args or POSIX::_exit(127);
	}
	if ($how{pipe}) {
		close $reader;
		feed($writer, $from);
	}
	waitpid $pid, 0;
	my $status = $?;
	return [slurp('out'), slurp('err'), $status & 127 ? 128 + ($status & 127) :
	    $status >> 8];
}

sub same { "@{[map { length . \":$_\" } $_[0]->@*]}" eq
    "@{[map { length . \":$_\" } $_[1]->@*]}" }

# The call as typed in a shell.
sub typed {
	my ($call, $args, $from) = @_;
	return join ' ', 'projcalc', $call->{command}, (map { m{^[\w./,:=+-]+$} ? $_ :
	    "'" . s/'/'\\''/gr . "'" } @$args),
	    $from eq '/dev/null' ? () : "<$from";
}

my $folder = tempdir('differential-XXXXXX', TMPDIR => 1);
my $work = "$folder/work";
mkdir $work or die "$work: $!\n";
chdir $work or die "$work: $!\n";
my ($passed, $failed, $kept) = (0, 0, 0);

# Keeps a call in a folder of its own, and prints how it is run there.
sub keep {
	my ($call, @said) = @_;
	my $dir = "$folder/" . ++$kept;
	mkdir $dir or die "$dir: $!\n";
	chdir $dir or die "$dir: $!\n";
	my $typed = typed($call, files($call));
	chdir $work or die "$work: $!\n";
	print "\tcd $dir; $typed\n", map { "\t$_\n" } @said;
}

# Returns the first lines in which two texts differ.
sub first_difference {
	my @lines = map { [split /^/] } @_;
	my $i = 0;
	$i++ while $i < $lines[0]->@* && $i < $lines[1]->@* &&
	    $lines[0][$i] eq $lines[1][$i];
	return map { ($_->[$i] // '(no line)') =~ s/\n\z//r } @lines;
}

sub shown {
	my ($text) = @_;
	$text =~ s/([^ -~])/sprintf '\\x%02x', ord $1/ge;
	return length $text > 150 ? substr($text, 0, 147) . '...' : $text;
}

# Returns two lines, each from shortly before the first byte in which they differ.
sub shown_pair {
	my ($one, $two) = @_;
	my ($same) = ($one ^ $two) =~ /^(\0*)/;
	my $from = length $same > 90 ? length($same) - 60 : 0;
	return join '  BUT  ', map { ($from ? '...' : '') . shown(substr $_, $from) }
	    $one, $two;
}

# Returns a message without its numbers and quoted words.
sub plain {
	my ($text) = @_;
	return $text =~ s/'[^']*'/''/gr =~ s/(?<!\w)-?\d[\d.e+-]*/N/gr =~
	    s/^projcalc: (?:note: )?(?:scene N, line N: )?//r =~
	    s/^(?:-|scene\.json|points\.\w+|PARAMS|POINTS)[:N ]*//r;
}

# Returns the class of the difference of two answers, or ''.
sub class {
	my ($call, $one, $two) = @_;
	return '' if same($one, $two);
	my @messages = $one->[1] ne $two->[1] ? first_difference($one->[1], $two->[1]) :
	    $one->[1] =~ /^(.*)/;
	my $where = "$call->{command} " . (defined $call->{points} ?
	    $call->{format} : 'without points');
	my $words = join ' | ', map { shown(plain($_)) } @messages;
	return "$where: status $one->[2] and $two->[2]: $words"
	    if $one->[2] != $two->[2];
	return "$where: only message: $words" if $one->[0] eq $two->[0];
	my @out = map { s/-?(?:\d[\d.e+-]*|nan)/N/gr } $one->[0], $two->[0];
	return "$where: stdout: " . ($out[0] eq $out[1] ? 'numbers' :
	    grep({ $_->[0] eq '' } $one, $two) ? 'one prints nothing' : 'text') .
	    ($one->[1] eq $two->[1] ? '' : ": $words");
}

sub both {
	my ($call) = @_;
	my ($args, $from) = files($call);
	return map { answer($_, $call->{command}, $args, $from,
	    jobs => $call->{jobs}) } @programs;
}

# Returns shorter forms of a call: without an option, a scene, a member, or lines.
sub shorter {
	my ($call) = @_;
	my @forms = map { my $i = $_; my @left = $call->{options}->@*;
	    splice @left, $i, 1; +{%$call, options => \@left} }
	    0 .. $call->{options}->$#*;
	my @scenes = $call->{scenes}->@*;
	push @forms, map { +{%$call, scenes => [$_]} } @scenes if @scenes > 1;
	if (@scenes == 1 && ref $scenes[0]) {
		push @forms, map { +{%$call, scenes => [$_]} } without($scenes[0]);
	}
	return @forms if !defined $call->{points} || $call->{format} =~ /^f/;
	my @lines = split /^/, $call->{points};
	for (my $n = int @lines / 2; $n > 0; $n = int $n / 2) {
		for my $at (0, @lines - $n, 1) {
			my @left = @lines;
			splice @left, $at, $n;
			push @forms, {%$call, points => join '', @left};
		}
	}
	return @forms;
}

sub without {
	my ($object) = @_;
	return map {
		my $i = $_;
		my @left = @$object;
		my ($pair) = splice @left, $i, 1;
		my @inner = ref $pair->[1] ? without($pair->[1]) : ();
		([@left], map { my @all = @$object; $all[$i] = [$pair->[0], $_]; \@all }
		    @inner);
	} 0 .. $#$object;
}

sub shorten {
	my ($call, $class) = @_;
	my $left = 150;
	my @forms = shorter($call);
	while (@forms && $left-- > 0) {
		my $form = shift @forms;
		next if class($form, both($form)) ne $class;
		$call = $form;
		@forms = shorter($call);
	}
	return $call;
}

my (%count, %first);

sub compare_programs {
	my ($call) = @_;
	$call->{jobs} = $call->{command} eq 'inspect' || $call->{way} eq 'words' ? 0 :
	    1 + below(2);
	my $class = class($call, both($call));
	$class eq '' ? $passed++ : $failed++;
	$first{$class} //= $call if $class ne '' && !$count{$class}++;
}

my @cpus;

# Of binary formats a message names those first that the size of the file divides by,
# but a pipe has no size.
sub without_size {
	my ($answer) = @_;
	$answer->[1] =~ s/(if it is numbers alone, say -i )f\w+ or f\w+ or f\w+/$1/g;
	return $answer;
}

sub compare_paths {
	my ($call) = @_;
	my ($args, $from) = files($call);
	my $threads = $call->{command} ne 'inspect' && $call->{way} ne 'words';
	my @ways = ({cpu => 'baseline', jobs => 4},
	    {cpu => pick(@cpus), jobs => 1 + below(4), pipe => 1});
	my $want = without_size(answer($programs[0], $call->{command}, $args, $from,
	    jobs => $threads));
	for my $way (@ways) {
		delete $way->{jobs} if !$threads;
		my $got = without_size(answer($programs[0], $call->{command}, $args,
		    $from, %$way));
		if (same($want, $got)) {
			$passed++;
			next;
		}
		$failed++;
		print "call $call->{n}, with ", join(' ', map { "$_=" .
		    ($way->{$_} || 'of this machine') } sort keys %$way), ":\n";
		keep($call, map { "$_->[0]: " . shown_pair(@$_[1, 2]) }
		    grep { $_->[1] ne $_->[2] }
		    ['output', first_difference($want->[0], $got->[0])],
		    ['message', first_difference($want->[1], $got->[1])],
		    ['status', "$want->[2]", "$got->[2]"]) if $kept < 20;
	}
}

# Compares the output of scenes that are all right with that of each alone. A last line
# without a newline gets one if another scene follows.
sub compare_scenes {
	my ($call) = @_;
	my @alone;
	return if $call->{scenes}->@* < 2;
	for my $scene ($call->{scenes}->@*) {
		my ($args, $from) = files({%$call, scenes => [$scene]});
		my $got = answer($programs[0], $call->{command}, $args, $from);
		return if $got->[2];
		push @alone, $got->[0];
	}
	my ($args, $from) = files($call);
	my $got = answer($programs[0], $call->{command}, $args, $from);
	my $ended = join('', map { $_ eq '' || /\n\z/ ? $_ : "$_\n" } @alone[0 .. $#alone - 1])
	    . $alone[-1];
	return $passed++ if $got->[0] eq join('', @alone) || $got->[0] eq $ended;
	$failed++;
	print "call $call->{n}, of scenes and of each alone:\n";
	keep($call, 'output: ' . shown_pair(first_difference($got->[0], $ended)))
	    if $kept < 20;
}

sub seconds_used { my @t = times; return $t[0] + $t[1] + $t[2] + $t[3] }

$| = 1;
print "seed $seed, in $folder\n";
@cpus = ('', grep { answer($programs[0], 'w2n', ['{"center":[0,0],"width":1,"height":1}'],
    '/dev/null', cpu => $_)->[2] == 0 } qw(baseline avx2));
my $began = time;
for (my $n = 0; seconds_used() < $seconds && time - $began < 4 * $seconds; $n++) {
	my $call = draw($n);
	@programs == 2 ? compare_programs($call) : compare_paths($call);
	compare_scenes($call) if @programs == 1;
}
my $took = time - $began;
for my $class (sort { $count{$b} <=> $count{$a} || $a cmp $b } keys %count) {
	print "$count{$class} times $class\n";
	next if $kept >= 60;
	my $call = shorten($first{$class}, $class);
	my ($one, $two) = both($call);
	keep($call, map { "$_->[0]: " . shown_pair(@$_[1, 2]) }
	    grep { $_->[1] ne $_->[2] }
	    ['output', first_difference($one->[0], $two->[0])],
	    ['message', first_difference($one->[1], $two->[1])]);
}
system 'rm', '-r', $kept ? $work : $folder;
printf "seed %d: %d passed, %d failed; %d runs in %.1f s, %.0f a second\n", $seed,
    $passed, $failed, $runs, $took, $runs / ($took || 1);
exit($failed > 0);
