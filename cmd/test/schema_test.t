#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that the JSON Schema of a scene accepts every scene of testdata and
# every value of projcalc-scene(5), and refuses what the program refuses in the
# transcripts, as far as a schema can. The validator is python3-jsonschema.
use strict;
use warnings;
use FindBin;
use JSON::PP;
use lib $FindBin::Bin;
use Projcalc;
use Transcript;

my $python = '/usr/bin/python3';
plan skip_all => 'no python3-jsonschema'
    if system("$python -c 'import jsonschema' 2>/dev/null") != 0;

# Reads a list of [text, pointer] and validates each text by the part of the
# schema to which the pointer leads. Prints a list of the faults, null if there
# is none.
my $validate = <<'END';
import json, sys
from jsonschema import Draft202012Validator
schema = json.load(open(sys.argv[1]))
Draft202012Validator.check_schema(schema)
def wrong(text, pointer):
    try:
        value = json.loads(text)
    except ValueError:
        return "not JSON"
    part = {"$ref": pointer, "$defs": schema["$defs"]} if pointer else schema
    for error in Draft202012Validator(part).iter_errors(value):
        return error.json_path + ": " + error.message
print(json.dumps([wrong(*case) for case in json.load(open(sys.argv[2]))]))
END

# Messages about faults that no schema finds: it cannot compare numbers, count
# members or invert matrices, and knows neither the command nor the operands.
my $beyond = qr{
	other\ handedness | does\ not\ mirror | equal\ to | longer\ than | not\ less\ than | not\ greater\ than | greater\ than\ max |
	less\ than\ min | no\ extent | parallel\ to | does\ not\ run | does\ not\ begin |
	that\ fit\ computes | all\ of\ the\ bounds | takes\ z\ to\ w | about\ the\ depth\ of |
	no\ straight\ lines | missing;\ lines\ of | no\ points$ | not\ in\ order | crosses\ the\ volume |
	repeated; | all\ but\ vanished |
	singular | determinant | last\ column | rows\ are\ for | transposed | leave\ -c\ out | needs\ a\ "convention" | pi\S*\ radians |
	too\ far\ from |
	beyond\ the\ range\ of\ doubles | --distances
	    (?!;\ numbers) |
	missing;\ (?:add|it\ is|device|say|-t) | give\ --(?:at|radius) |
	project\ takes\ any | coordinates\ are\ wanted | not\ together\ with\ PO |
	can't\ be\ taken\ back | nothing\ that\ can\ be\ fitted | --distances |
	^projcalc:\ POINTS:
}x;

# The commands whose document may be one member of a scene, and that member.
my %bare = (lookat => 'camera', (map { $_ => 'window' } qw(w2n n2w)),
	(map { $_ => 'device' } qw(n2d d2n)),
	map { $_ => 'projection' } qw(persp ortho oblique volume));

sub as_scene {
	my ($command, $text) = @_;
	# The points that fit holds may be in operands.
	my $center = $text =~ /"projection"/ ? '[0,0,0]' : '[0,0]';
	$text =~ s/^\s*\{/{"bounds": {"center": $center, "radius": 1}, /
	    if $command eq 'fit' && $text !~ /"bounds"/;
	my $bare = $bare{$command} or return $text;
	return $text if $text =~ /"(?:convention|world|camera|projection|viewport
	    |window|device|bounds|pick|points)"\s*:/x;
	my $type = $bare eq 'projection' && $text !~ /"type"/ ?
	    "{\"type\": \"$command\"" .
	    ($text =~ /^\s*\{\s*\}\s*$/ ? '' : ',') : '{';
	# angle_unit beside the member's own members is the scene's.
	my $unit = $text =~ s/\s*("angle_unit":\s*"\w*"),?// ? "$1," : '';
	return "{$unit\"$bare\": " . $text =~ s/^\s*\{/$type/r . '}';
}

# Returns the documents of a shell command, which are in quotes, in files or on
# standard input.
sub documents {
	my ($shell) = @_;
	my ($in, @found) = input($shell);
	while ($shell =~ /projcalc (\w+)([^|]*)/g) {
		my ($command, $rest) = ($1, $2);
		push @found, map { as_scene($command, $_) }
		    $rest =~ /'(\{[^']*\})'/g;
		push @found, map { as_scene($command, slurp($_)) }
		    grep { -e } map { "testdata/$_" } $rest =~ m{(?<![\w<'])([\w/-]+\.json)\b}g;
		push @found, as_scene($command, $in) if $in =~ /^\s*\{/ && $shell !~ /-i json|\.json -/;
	}
	return @found;
}

my @cases; # [name, text, pointer, message or '']

sub add {
	push @cases, [@_];
}

add($_, slurp($_), '', '') for glob 'testdata/*.json testdata/views/*.json';
for my $case (map { transcript($_) } glob 'testdata/transcripts/*.txt') {
	next if $case->{status} > 1;
	# The schema knows the program's own names, not those that it reads, too.
	next if $case->{name} =~ /^alias-/;
	# The schema describes one scene.
	next if $case->{command} =~ /--scenes/;
	my $err = $case->{status} == 1 ? $case->{err} : '';
	# Skips messages that are not about the document, but a point, or no JSON.
	next if $err ne '' && $err !~ m{^projcalc: [^:]+: (?:/|is an? )};
	add($case->{name}, $_, '', $err) for documents($case->{command});
}
for my $line (split /^/, slurp('testdata/recorded/sources.tsv')) {
	my (undef, $what, $command) = split /\t/, $line;
	add($what, $_, '', '') for documents($command // '');
}

# The values of the manual page, in lines .It Cm NAME : No VALUE.
my ($section, %where) = ('', projection => '#/$defs/ortho',
	'projection of type matrix' => '#/$defs/any',
	convention => '#/$defs/convention/then', 'lists of steps' => '#/$defs/step');
for my $line (split /^/, slurp('man/projcalc-scene.5')) {
	$section = $1 if $line =~ /^\.Ss (.*)/;
	my ($name, $value) = $line =~ /^\.It Cm (\w+) : No (.*)/ or next;
	my $object = $where{$section} //
	    '#/$defs/' . $section =~ s/.* of type //r;
	$object = '#/$defs' if $name eq 'type' || $name eq $section;
	$object = '#/$defs' if $section eq 'world';
	add("$section $name", $value =~ s/\\\(dq/"/gr,
	    $name eq 'type' ? '#/$defs/projection/properties/type' :
	    $section eq 'world' ? '#/$defs/matrix' :
	    $object eq '#/$defs' ? "$object/$name" :
	    "$object/properties/$name", '');
}

spew("$tmp/validate", $validate);
spew("$tmp/list", encode_json([map { [$_->[1], $_->[2]] } @cases]));
my $schema = "$tmp/schema.json";
system("$^X man/schema.pl $build/projcalc >$schema") == 0
    or die "schema.pl failed\n";
my $said = `$python $tmp/validate $schema $tmp/list`;
die "the validator failed\n" if $? != 0;
my $wrong = decode_json($said);

my $refusals = 0;
for my $i (0 .. $#cases) {
	my ($name, $text, undef, $message) = @{$cases[$i]};
	my $error = $wrong->[$i];
	my $agree = defined $error == ($message ne '');
	# No schema can tell these; and in members that a command doesn't use, the program
	# checks only the form.
	next if !$agree && ($message =~ $beyond || $name =~ m{^unneeded-\w+-range$});
	ok($agree, $name) or diag("$text\n", $message eq '' ?
	    "The program takes it, the schema says: $error" :
	    "The schema takes it, the program says: $message");
	$refusals++ if $agree && $message ne '';
}
# The patterns above must not let everything pass.
cmp_ok($refusals, '>=', 50, 'refusals of the program are the schema\'s');
diag('man/schema.pl makes the schema of the rows of cmd/scene. What no schema can ' .
    'tell is in $beyond above.')
    unless Test::More->builder->is_passing;
done_testing();
