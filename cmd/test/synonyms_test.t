#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that every word of the table of synonyms gets a suggestion, wherever it is
# typed, and that the suggested call works.
# usage: synonyms_test.t [BUILD]
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

# The arguments for options that messages suggest without an argument, and operands for
# the calls.
my %argument = (columns => '1,2,3', output => 'json', to => 'view', jobs => 1,
    decimals => 2, tolerance => 1, precision => 'double', separator => "','", convention => 'gl',
    color => 'auto', plane => '0,0,1,0', from => 'world', to => 'device');
my $scene = '{"camera":{"eye":[0,0,-5],"at":[0,0,0]},"projection":{"type":' .
    '"persp","fovy":60,"near":1,"far":10},"viewport":{"width":640,"height":480}}';
my $lens = '{"fovy":60,"aspect":1,"near":1,"far":10}';
my %params = (w2n_shown => q('{"center": [20,30], "width": 10, "height": 10}'),
    lookat => '{"eye":[0,0,-5],"at":[0,0,0]}', persp => $lens,
    w2n => '{"center":[0,0],"width":1,"height":1}',
    n2d => '{"width":1,"height":1}', ortho => '{"width":1,"height":1,"near":0,"far":1}');

# The rows of the table: places, words and hint.
my ($table) = slurp('cmd/message/words.c') =~ /word_rows\[\] = \{(.*?)\n\};/s;
my $text = qr/(?:"(?:[^"\\]|\\.)*"\s*)+/;
my @rows = map { [/(\w+), ($text), *\s*($text)\}/] } $table =~ /^\t\{ (\w+, $text,\s*$text\})/mg;
for my $row (@rows) {
	$_ = join('', /"((?:[^"\\]|\\.)*)"/g) =~ s/\\"/"/gr for @$row[1, 2];
}
is(scalar @rows, scalar(() = $table =~ /^\t\{/mg), 'every row is read');
my %words = map { $_ => 1 } (map { /</ ? () : $_ } map { split / / } map { $_->[1] }
    grep { $_->[0] =~ /^(?:CALL|VALUE|REMARK)$/ } @rows),
    qw(pan rvec rotation flags columns fovy zoom eye lookAt
    radians transpose column-major near_far near-far extent);

# Runs words of the shell. Returns the status and the output.
sub try {
	my ($status, $said) = run("projcalc $_[0] 2>&1", 'testdata');
	return ($status, $said);
}

# Returns the call with the argument of its last option, and with operands.
sub completed {
	my ($call) = @_;
	my ($command) = $call =~ /^(\S+)/;
	return $call if $command eq 'help' || $command =~ /^-/;
	$call .= " $argument{$1}" if $call =~ /--(\w+)$/ && $argument{$1};
	$call =~ s/1,2,3$/1,2/ if $call =~ /\b\w2\w\b/;
	my $points = $call =~ /--ray|--plane/ ? '[320,240]' : $call =~ /inspect/ ? '' :
	    $call =~ /\b\w2\w\b/ ? '[1,1]' : '[1,1,1]';
	$points = '' if $call =~ / -m/;
	$points = "1 1 1\n" if $call =~ /columns|input csv/;
	return "$call '" . ($params{$command} // $scene) . "'" .
	    ($points eq '' ? '' : $points =~ /^\[/ ? " '$points'" : ' - ');
}

# Returns the calls that a message suggests.
sub suggested {
	my ($command, $said) = @_;
	return if $said !~ /unknown (?:command|topic|option)|is no scene/;
	my @calls = map { s/^projcalc //r } $said =~ /did you mean '([^']*)'\?/g;
	push @calls, map { "$command $_" } $said =~ /did you mean (-[^?]*?)(?:, or [^?]*)?\?/g;
	push @calls, map { "project $_" } $said =~ /; (--.*) is an option of .*project/;
	push @calls, $said =~ /'projcalc (help \S+)'/g;
	push @calls, $1 if $said =~ /: projcalc (\w+ .*'[\[{].*)/;
	return @calls;
}

my %tried;

sub works {
	my ($call) = @_;
	return if $tried{$call}++;
	my ($status, $said) = try($call =~ /'/ ? $call : completed($call));
	ok($status == 0 || $status == 1 && $said !~ /unknown/,
	    "suggested: $call") or diag($said);
}

# A command of a camera, of points, and of a window.
my @commands = qw(lookat project w2n);
for my $word (sort keys %words) {
	for my $call ($word, "help $word", map { "$_ --$word" } @commands) {
		next if $word =~ /^-/ && $call ne $word;
		my ($status, $said) = try($call);
		my ($command) = $call =~ /^(\S+)/;
		next if $said !~ /unknown (?:command|topic|option)/ ||
		    "$command --$word" eq 'inspect --info';
		ok($status == 2 && $said =~ /; / && $said !~ / lists /, $call) or
		    diag($said);
		works($_) for suggested($command, $said);
	}
}

# Remarks are also about members, and about values.
for my $row (grep { $_->[2] =~ /^: / } @rows) {
	my ($places, $words, $hint) = @$row;
	for my $word (split / /, $words) {
		my ($status, $said) = try($places eq 'VALUE' ? "lookat -c '$word'" :
		    $places eq 'WORD_VALUE' ? "w2n -c '$word'" :
		    $places eq 'WORD_OPTION' ? "project '--$word'" :
		    $places eq 'WORD_JSON' ? "lookat '{\"eye\":[$word,0,0]}'" :
		    $places eq 'WORD_COMMAND' ? $word :
		    $places eq 'CALL' ? "lookat '--$word'" : "lookat '{\"$word\":1}'");
		# a camera may have a member of this name
		($status, $said) = try("project '{\"$word\":1}' '[0,0,0]'")
		    if $places =~ /MEMBER|REMARK/ && index($said, substr($hint, 2)) < 0;
		ok($status > 0 && index($said, substr($hint, 2)) >= 0, "$places $word") or
		    diag($said);
	}
}

# What is typed first, a part of the message, and what is typed then, which works.
my $k = '"convention":"opencv","viewport":{"width":640,"height":480}';
my $ortho = '"near":0,"far":9';
my @led = (
	["persp '{\"fovh\":60,\"aspect\":1,\"near\":1,\"far\":9}'", '"fovx"',
	    "persp '{\"fovx\":60,\"aspect\":1,\"near\":1,\"far\":9}'"],
	["oblique '{\"kind\":\"cabinet\",\"angle\":45,\"width\":2,\"height\":2,$ortho}'",
	    '"direction"',
	    "oblique '{\"kind\":\"cabinet\",\"direction\":45,\"width\":2,\"height\":2,$ortho}'"],
	["ortho '{\"xmin\":0,\"right\":1,\"bottom\":0,\"top\":1,$ortho}'", '"left"',
	    "ortho '{\"left\":0,\"right\":1,\"bottom\":0,\"top\":1,$ortho}'"],
	["ortho '{\"zoom\":2,\"width\":2,\"height\":2,$ortho}'", '"width" and "height"',
	    "ortho '{\"width\":1,\"height\":1,$ortho}'"],
	["ortho '{\"size\":2,$ortho}'", '"width" and "height"',
	    "ortho '{\"width\":2,\"height\":2,$ortho}'"],
	["persp '{\"d\":2,\"width\":2,\"height\":2,\"near\":1,\"far\":9}'", '"edges_at"',
	    "persp '{\"edges_at\":2,\"width\":2,\"height\":2,\"near\":1,\"far\":9}'"],
	["persp '{\"focal_length\":50,\"sensor_size\":36}'", '"edges_at"',
	    "persp '{\"edges_at\":50,\"width\":36,\"height\":24,\"near\":1,\"far\":9}'"],
	["persp '{\"hither\":1,\"yon\":9,\"fovy\":60,\"aspect\":1}'", '"near"',
	    "persp '{\"near\":1,\"far\":9,\"fovy\":60,\"aspect\":1}'"],
	["persp '{\"near\":1,\"yon\":9,\"fovy\":60,\"aspect\":1}'", '"far"',
	    "persp '{\"near\":1,\"far\":9,\"fovy\":60,\"aspect\":1}'"],
	["lookat '{\"cop\":[0,0,5],\"at\":[0,0,0]}'", '"eye"',
	    "lookat '{\"eye\":[0,0,5],\"at\":[0,0,0]}'"],
	["lookat '{\"eye\":[0,0,5],\"at\":[0,0,0],\"vrp\":[0,0,0]}'", '"eye"',
	    "lookat '{\"eye\":[0,0,5],\"at\":[0,0,0]}'"],
	["lookat '{\"eye\":[0,0,5],\"vpn\":[0,0,1]}'", '"gaze"',
	    "lookat '{\"eye\":[0,0,5],\"gaze\":[0,0,-1]}'"],
	["lookat '{\"eye\":[0,0,5],\"dop\":[0,0,1]}'", '"gaze"',
	    "lookat '{\"eye\":[0,0,5],\"gaze\":[0,0,1]}'"],
	["project -m '{$k,\"P2\":[1]}'", '"intrinsics" of "projection"', "project -m '{$k," .
	    "\"projection\":{\"type\":\"persp\",\"intrinsics\":[[4,0,3,1],[0,4,2,0],[0,0,1,0]]}}'"],
	["project -m '{$k,\"P_rect_02\":[1]}'", '"intrinsics" of "projection"',
	    "help intrinsics"],
	["project -m '{$k,\"R0_rect\":[1]}'", '"world": [{"matrix": Tr}, {"matrix": [R0|0]}]',
	    "project -m --to world '{\"world\": [{\"matrix\": " .
	    "[[0,-1,0,0],[0,0,-1,0],[1,0,0,0]]}, {\"matrix\": [[1,0,0,0],[0,1,0,0],[0,0,1,0]]}]}'"],
	["project -m '{$k,\"camera_intrinsic\":[1]}'", '"quaternion_wxyz"', "project -m " .
	    "--to world '{\"world\": [{\"quaternion_wxyz\": [1,0,0,0]}, {\"translate\": [0,0,0]}]}'"],
	(map { ["lookat '{\"eye\":[0,0,5],\"$_\":30}'", '[{"rotate_x": 10}, {"rotate_y": 30}, {"translate": [0,0,5]}]',
	    "lookat -c gl '{\"pose\": [{\"rotate_x\": 10}, {\"rotate_y\": 30}, " .
	    "{\"translate\": [0,0,5]}]}'"] }
	    qw(yaw pitch heading omega)),
	(map { ["lookat '{\"$_\":[1,0,0,0]}'",
	    '"matrix": [{"quaternion_wxyz": q}, {"translate": t}] of "camera"', "lookat -c opencv " .
	    "'{\"matrix\": [{\"quaternion_wxyz\": [1,0,0,0]}, {\"translate\": [0,0,1]}]}'"] }
	    qw(qvec quaternion_wxyz)),
	["project '{\"projectionMatrix\":[1]}'", '"matrix" in "projection", with "type": "matrix"',
	    "project -m --from view --to clip '{\"projection\":{\"type\":\"matrix\"," .
	    "\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}}'"],
	["lookat '{\"eye\":[0,0,5],\"to\":[0,0,0]}'", '"at"',
	    "lookat '{\"eye\":[0,0,5],\"at\":[0,0,0]}'"],
	["ortho '{\"width\":2,\"height\":2,\"zmin\":0,\"zmax\":9}'", '"far"',
	    "ortho '{\"width\":2,\"height\":2,\"near\":0,\"far\":9}'"],
	["w2n '{\"left\":0,\"y\":0,\"right\":1,\"top\":1}'", '"bottom"',
	    "w2n '{\"left\":0,\"bottom\":0,\"right\":1,\"top\":1}'"],
	(map { ["project '{\"$_->[0]\":1}'", "\"$_->[1]\"", "help $_->[1]"] } ['modelMatrix',
	    'world'], ['modelViewMatrix', 'matrix'], ['matrixWorldInverse', 'matrix'],
	    ['cam2world', 'pose'], ['translation_vector', 'translation'], ['proj', 'projection']),
	["fit '{\"bbox\":{\"min\":[0,0,0],\"max\":[1,1,1]}}'", '"bounds"', "fit '{\"bounds\":" .
	    "{\"min\":[0,0,0],\"max\":[1,1,1]},\"projection\":{\"type\":\"ortho\"}}'"],
	["project '{\"tvec\":[0,0,1]}'", '"translation" in "camera"', "lookat " .
	    "'{\"camera\":{\"translation\":[0,0,1],\"orientation\":[0,0,0,1]}}'"],
	(map { ["lookat -c $_->[0] '{\"eye\":[0,0,5],\"at\":[0,0,0]}'", "\"$_->[1]\"",
	    "lookat -c $_->[1] '{\"eye\":[0,0,5],\"at\":[0,0,0]}'"] } ['threejs', 'gl'],
	    ['three.js', 'gl'], ['unity', 'gl'], ['unreal', 'd3d'], ['blender', 'webgpu'],
	    ['metal', 'webgpu'], ['hlsl', 'd3d'], ['glsl', 'gl'], ['openxr', 'vulkan'],
	    ['colmap', 'opencv'], ['nerf', 'webgpu'], ['ros', 'opencv']),
	["project --reversed-z scene.json '[0,0,0]'", '"reverse_z"',
	    "persp '{\"reverse_z\":true,\"fovy\":60,\"aspect\":1,\"near\":1,\"far\":9}'"],
	["persp --infinite $params{persp}", '"far": "infinity"',
	    "persp '{\"far\": \"infinity\",\"fovy\":60,\"aspect\":1,\"near\":1}'"],
	["project --clip scene.json '[0,0,0]'", 'project --visible',
	    "project --visible scene.json '[0,0,0]'"],
	["project --clip scene.json '[0,0,0]'", 'project --to clip',
	    "project --to clip scene.json '[0,0,0]'"],
	["project --depth scene.json '[0,0,0]'", '--to view, or "viewport": {"depth": "distance"}',
	    "project --to view scene.json '[0,0,0]'"],
	(map { ["project $_ scene.json '[0,0,0]'", '--keep-going',
	    "project --keep-going scene.json '[0,0,0]'"] } '--na', '--skip'),
	["project --ground scene.json '[400,300]'", '--plane 0,1,0,0',
	    "project --plane 0,0,1,0 scene.json '[400,300]'"],
	["project --ray 400,300", "projcalc project --ray scene.json '[400,300]'",
	    "project --ray scene.json '[400,300]'"],
	["project '[0,0,0]' scene.json", "projcalc project scene.json '[0,0,0]'",
	    "project scene.json '[0,0,0]'"],
	["project scene.json 1,2,3", "'[1,2,3]'", "project scene.json '[1,2,3]'"],
	["project scene.json 1 2 3", "'[1,2,3]'", "project scene.json '[1,2,3]'"],
	["project 1,2,3 scene.json", "project scene.json '[1,2,3]'",
	    "project scene.json '[1,2,3]'"],
	["w2n '[0,10,0,10]'", "projcalc w2n $params{w2n_shown}", "w2n $params{w2n_shown}"],
	["w2n '{\"window\":[0,10,0,10]}'", '{"center": [20,30], "width": 10, "height": 10}',
	    "w2n '{\"window\":{\"center\": [20,30], \"width\": 10, \"height\": 10}}'"],
	["persp '{\"far\":Infinity,\"fovy\":60,\"aspect\":1,\"near\":1}'", '"infinity"',
	    "persp '{\"far\":\"infinity\",\"fovy\":60,\"aspect\":1,\"near\":1}'"],
	["persp '{\"reverse_z\":True,\"fovy\":60,\"aspect\":1,\"near\":1,\"far\":9}'", 'true',
	    "persp '{\"reverse_z\":true,\"fovy\":60,\"aspect\":1,\"near\":1,\"far\":9}'"],
	["project scene.json '[NaN,0,0]'", 'null', "project scene.json '[null,0,0]'"],
	["project scene.json '[None,0,0]'", 'null', "project scene.json '[null,0,0]'"],
	(map { ["project -i '$_' scene.json cameras/velodyne.bin", '-i f32x4',
	    "project -i f32x4 scene.json cameras/velodyne.bin"] }
	    qw(bin float32 double <f8 <f4 kitti npy)),
	["project scene.json cameras/velodyne.bin", '-i f32x4',
	    "project -i f32x4 scene.json cameras/velodyne.bin"],
);
my %files = ('wkt.txt' => "LINESTRING Z (1 2 3, 4 5 6)\n", 'copy.tsv' => "1\t2\t3\n1\t\\N\t3\n",
    'units.csv' => "x [m],y (m),z[m]\n1,2,3\n", 'degrees.csv' => "lat,lon,h\n50,8,1\n",
    'geo.json' => '{"type":"FeatureCollection","bbox":[0,0,0,9,9,9],"features":[{"type":' .
    '"Feature","geometry":{"type":"LineString","coordinates":[[1,2,3],[4,5,6]]}}]}' . "\n",
    'ost.yaml' => "image_width: 640\nimage_height: 480\n");
spew("$tmp/$_", $files{$_}) for keys %files;
for my $case (['wkt.txt', '-i text'], ['copy.tsv', '-i tsv'], ['units.csv', '-i csv'],
    ['geo.json', '-i json']) {
	my ($file, $format) = @$case;
	my ($said) = (try("project scene.json $tmp/$file"))[1];
	my ($filter) = $said =~ /(?:\?|:|units:) ((?:tr|sed|jq) .*?'(?= makes|$|;))/m;
	ok(defined $filter, "$file leads on") or diag($said);
	my ($status, $then) = run("$filter <$tmp/$file | projcalc project $format " .
	    'scene.json -', 'testdata');
	ok($status == 0 && $then =~ /\d/, "$file by $filter") or diag($then);
}
push @led, ["project scene.json $tmp/degrees.csv", '--columns lon,lat,h; degrees are no ' .
    'lengths', "project --columns lon,lat,h scene.json $tmp/degrees.csv"],
    ["project $tmp/ost.yaml", 'YAML', 'help camera'],
    ["project $tmp/geo.json", 'jq -c', 'help points'];
for my $case (@led) {
	my ($first, $part, $then) = @$case;
	my ($status, $said) = try($first);
	ok($status > 0 && index($said, $part) >= 0, "$first: $part") or diag($said);
	next if $tried{$then}++;
	($status, $said) = try("$then 2>&1");
	ok($status == 0, "then: $then") or diag($said);
}

# Names of files tell their formats, and a lone word of the command line its usage.
spew("$tmp/a.$_", /csv/i ? "x,y,z\n1,2,3\n" : /tsv/ ? "x\ty\tz\n1\t2\t3\n" : /json/ ?
    "[1,2,3]\n" : "1 2 3\n") for qw(csv tsv json jsonl ndjson CSV xyz);
for my $end (qw(csv tsv json jsonl ndjson CSV xyz)) {
	my ($status, $said) = try("project -d 0 scene.json $tmp/a.$end");
	ok($status == 0 && $said =~ /372.136.1/, "a.$end") or diag($said);
}
my ($status, $said) = try("project scene.json $tmp/a.csv $tmp/a.xyz");
ok($status == 2 && $said =~ /say -i/, 'files that disagree') or diag($said);
($status, $said) = try("project -i csv scene.json $tmp/a.csv $tmp/a.xyz");
ok($status == 0 || $said !~ /disagree|different/, 'but not with -i') or diag($said);
($status, $said) = run('projcalc');
ok($status == 2 && $said eq '', 'a call without a command prints nothing');

for my $said (slurp('testdata/transcripts/first-tries.txt') =~ /^! (.*)/mg) {
	my ($command) = $said =~ /^projcalc: (\w+): unknown/;
	works($_) for suggested($command // 'project', $said);
}
done_testing();
