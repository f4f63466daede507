#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that --scenes prints what one call for each scene prints, with any blanks
# between the scenes, and from a file or a pipe; and that trace prints in each space
# what project prints.
use strict;
use warnings;
use FindBin;
use IPC::Open2;
use JSON::PP;
use lib $FindBin::Bin;
use Projcalc;

chdir 'testdata' or die "testdata: $!\n";
my $json = JSON::PP->new->canonical;
my $scene = $json->decode(slurp('scene.json'));

# Returns the scene with members added or replaced; undef removes a member.
sub with {
	my %scene = (%$scene, @_);
	return {map { defined $scene{$_} ? ($_ => $scene{$_}) : () }
	    keys %scene};
}

sub camera { {eye => [@_], at => [0, 0, 0]} }

# Returns the messages without those that count points without an image, and bad lines;
# and a text with these counts and the first such point.
sub imageless {
	my ($said) = @_;
	my ($n, $where) = (0, '');
	my $behind = qr/(?:(?:is|are) behind the camera and )?/;
	while ($said =~ s/^projcalc: (\d+) points? ${behind}ha(?:s|ve) no image(?:: |, the first in )(.*)\n//m) {
		$n += $1;
		$where ||= $2;
	}
	my $bad = 0;
	$bad += $1 while $said =~ s/^projcalc: (\d+) bad lines?\n//m;
	return ($said, "$n $where, $bad bad");
}

# Compares one call for all scenes with a call for each. Messages must be the same,
# except that they name the scene, and that one message counts the points without an
# image, or the bad lines, of all scenes.
sub same {
	my ($name, $args, $points, @scenes) = @_;
	my ($status, $out, $err) = (0, '', '');
	for my $s (@scenes) {
		spew("$tmp/one", $json->encode($s));
		my @said = run("projcalc $args $tmp/one $points");
		$status ||= $said[0];
		$out .= $said[1];
		$err .= $said[2];
	}
	my @texts = (join("\n", map { $json->encode($_) } @scenes),
	    join('', map { $json->pretty->encode($_) } @scenes),
	    join('', map { "\xef\xbb\xbf\r\n" . $json->pretty(0)->encode($_) }
	    @scenes));
	$json->pretty(0);
	for my $i (0 .. $#texts) {
		spew("$tmp/all", $texts[$i]);
		my @said = run("projcalc $args --scenes $tmp/all $points");
		$said[2] =~ s/scene \d+, line \d+: //g;
		ok($said[1] eq $out, "$name: output, as text $i") or
		    diag("$said[1]$said[2]");
		my ($told, $n) = imageless($said[2]);
		my ($each, $all) = imageless($err);
		is("$said[0]\n$told$n", "$status\n$each$all",
		    "$name: messages, as text $i");
		cmp_ok($said[2] =~ s/no image//g, '<=', 1,
		    "$name: counted once, as text $i");
	}
}

my @path = map { with(camera => camera($_, 2, -5)) } 0 .. 4;
my @own = map { with(points => [[$_, 0, 0], [0, 0, $_, '"]}\\']]) } 0 .. 2;
my @bare = map { $_->{camera} } @path;
my $box = {min => [-1, -1, -1], max => [1, 2, 3]};
my @lens = map { {fovy => $_, aspect => 1.5, near => 1, far => 9} } 30, 60;

same('project', 'project', 'teapot.xyz', @path);
same('points of their own', 'project', '', @own);
same('points of some', 'lookat', '', @path, with(points => undef), @own);
same('behind', 'project', "'[[0,0,-9],[0,0,0]]'", @path);
same('typed', 'project --flags', "'[[0,0,0],[1,1,1]]'", @path);
same('a matrix', 'project -m -o f64', '', @path);
same('bare cameras', 'lookat -c gl', '', @bare);
same('bare projections', 'persp -c d3d -o json', '', @lens);
same('trace', 'trace', "inputs/three-points.txt '[[1,2,3]]'", @path);
same('trace, points of their own', 'trace -o json', '', @own);
same('pick', 'pick --at 320,240 --radius 90', 'teapot.xyz', @path);
same('fit', 'fit', '', map { with(points => undef, bounds => $box,
    camera => $_) } @bare);
same('fit to points', 'fit', 'teapot.xyz', map { with(points => undef,
    viewport => {%{$scene->{viewport}}, width => $_}) } 640, 480);
same('inspect', 'inspect', '', @path);
same('windows', 'w2d', "'[[1,2]]'", map { {window => {center => [$_, 0],
    width => 2, height => 2}, device => {width => 300, height => 300}} } 1, 2);

my @windows = map { {window => {center => [$_, 0], width => 2, height => 2},
    device => {width => 300, height => $_}} } 1 .. 3;
same('edges', 'w2d --flags', "'[[1,2],[0.5,0]]'", @windows);
same('inspect windows', 'inspect', '', @windows);
same('fit windows', 'fit', "'[[1,2],[4,4]]'", @windows);
same('fit either', 'fit -c d3d', '', map { {%{$windows[$_]}, $_ == 1 ?
    (projection => {type => 'ortho'}, points => [[1, 2, 3], [4, 4, 4]]) :
    (points => [[1, 2], [3, $_]])} } 0 .. 2);

# Points that are read once for all scenes: by a header, in binary, with bad lines.
spew("$tmp/csv", "name,z,y,x\n" . "lamp,1,2,3\n" x 20000);
same('columns', 'project -i csv --columns x,y,z', "$tmp/csv", @path[0 .. 2]);
spew("$tmp/f64", pack 'd<*', map { $_ / 7 } 1 .. 3 * 30000);
same('binary', 'project -i f64 -j2', "$tmp/f64", @path[0 .. 2]);
same('binary picked', 'pick -i f64 --at 320,240 --radius 90', "$tmp/f64",
    @path[0, 1]);
same('binary to text', 'project -i f64 -o text --flags', "$tmp/f64",
    @path[0, 1]);
spew("$tmp/bad", "0 0 0\n0 0\n1 1 1\n");
same('bad lines', 'project --flags --keep-going', "$tmp/bad", @path);
same('bad lines traced', 'trace --keep-going', "$tmp/bad", @path);
my $lines = join "\n", map { $json->encode($_) } @path;
spew("$tmp/path", $lines);
my @first = run("cat inputs/three-points.txt | projcalc project --scenes $tmp/path -");
my @second = run("projcalc project --scenes $tmp/path inputs/three-points.txt");
is("@first", "@second", 'points from a pipe');

# Scenes that are larger than one read, so that reads end anywhere in them.
my @large = map { with(points => [map { [$_ % 7, 0, $_ % 5, '{"\\'] }
    1 .. $_]) } 20000, 5, 30000, 1;
same('large scenes', 'project', '', @large);
@first = run("dd if=$tmp/all bs=777 2>/dev/null | projcalc project --scenes");
@second = run("projcalc project --scenes $tmp/all");
ok("@first" eq "@second" && length $second[1] > 1e6, 'and from a pipe');

# A scene is answered before the next arrives.
my $pid = open2(my $from, my $to, "$build/projcalc", 'lookat', '-q', '--scenes', '-',
    '[[0,0,1]]');
$to->autoflush;
alarm 60;
for my $z (1 .. 3) {
	print $to "{\"eye\": [0, 0, -$z],\n\"at\": [0, 0, 1]}";
	is(readline($from), '0 0 ' . ($z + 1) . "\n", "scene $z is answered");
}
close $to;
waitpid $pid, 0;
is($?, 0, 'and the last');
alarm 0;

# A scene with a point takes a twentieth of the time of a call; a tenth passes, as the
# machine may be busy.
sub seconds {
	my ($command, $times) = @_;
	my @before = times;
	system("PATH='$build':\$PATH; $command >/dev/null");
	my @after = times;
	return ($after[2] + $after[3] - $before[2] - $before[3]) / $times;
}

spew("$tmp/one", $json->encode(with(points => [[1, 2, 3]])));
spew("$tmp/many", slurp("$tmp/one") x 4000);
my $call = seconds('i=0; while [ $i -lt 200 ]; do ' .
    "projcalc project $tmp/one; i=\$((i + 1)); done", 200);
my $each = seconds("projcalc project --scenes $tmp/many", 4000);
cmp_ok($each, '<', $call / 10, sprintf 'a scene takes 1/%.0f of a call',
    $call / $each);

# trace prints what project prints, from every space to every other.
my @spaces = qw(model world view clip ndc device);
my $affine = [2, 0, 0, 0, 1, 3, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1];
my %scenes = (perspective => with(world => $affine, camera => camera(1, 2, -5)),
    parallel => with(world => $affine, projection => {type => 'oblique',
    kind => 'cabinet', width => 9, height => 9, near => -9, far => 9}));
for my $name (sort keys %scenes) {
	spew("$tmp/scene", $json->encode($scenes{$name}));
	for my $from (@spaces) {
		my $w = $from eq 'clip' ? ' 1.5' : '';
		my @points = map { join(' ', map { below(999) / 100 - 4 }
		    1 .. 3) . $w } 1 .. 40;
		spew("$tmp/points", join '', map { "$_\n" } @points, "nan 1 1$w");
		for my $how ('', '-p single', '-p double', '--digits 4',
		    '-c gl --visible') {
			my $args = "$how --from $from $tmp/scene $tmp/points";
			my %traced;
			my (undef, $said, $err) = run("projcalc trace $args");
			$traced{$1} .= "$2\n"
			    while $said =~ /^(\w+) +(.* .*)$/mg;
			my $bad = $err;
			for my $to (@spaces) {
				my $all = $how =~ /visible/ ? '' : '--flags';
				my (undef, $want) =
				    run("projcalc project $all --to $to $args");
				$want =~ s/ \S+$//mg if $all;
				my $kept = $traced{$to} // '';
				$bad .= "$to:\n$want-\n$kept" if $want ne $kept;
			}
			is($bad, '', "$name, from $from $how");
		}
	}
}
done_testing();
