#!/usr/bin/perl
# What the program says of itself is what its manual pages say: commands and
# options are those of the synopsis, members of a scene those of its page and
# of the schema; README's figures are measured ones; and the pages are without a
# fault that mandoc sees.
use strict;
use warnings;
use FindBin;
use JSON::PP;
use lib $FindBin::Bin;
use Projcalc;

my $program = "$build/projcalc";
my $manual = slurp('man/projcalc.1');
my $scene = slurp('man/projcalc-scene.5');
my $schema = decode_json(slurp('man/projcalc.schema.json'));

# Options by command, the short name where there is one.
my %synopsis;
my ($text) = $manual =~ /^\.Sh SYNOPSIS\n(.*?)^\.Sh/ms;
for my $call (split /^\.Nm\n/m, $text) {
	my ($commands) = $call =~ /^\.Cm (.*)/ or next;
	my @options = $call =~ /\bFl (\S+)/g;
	$synopsis{$_} = sorted(@options) for split / \| /, $commands;
}
delete $synopsis{help};

my ($options) = $manual =~ /^\.Sh OPTIONS\n(.*?)^\.Sh/ms;
my $help = `$program help`;
my @commands = $help =~ /^  ([a-z]\w*) /mg;
my %options;

is(sorted(keys %synopsis), sorted(@commands), 'commands');
for my $command (@commands) {
	my $said = `$program help $command`;
	my @names;
	while ($said =~ /^  (?:-(\w), |    )--([\w-]+) (\S*)/mg) {
		my ($letter, $long, $argument) = ($1, $2, $3);
		my $item = ($letter ? "Fl $letter , " : '') . "Fl -$long" .
		    ($argument ne '' ? ' Ar' : '');
		$options{$letter // "-$long"} = $item;
		push @names, $letter // "-$long"
		    unless $long =~ /^(?:help|version)$/;
	}
	is($synopsis{$command}, sorted(@names), "options of $command");
	is(`$program $command -h`, $said, "-h of $command");
}
for my $option (sort keys %options) {
	like($options, qr/^\.It .*\Q$options{$option}\E\b/m,
	    "option $option is explained");
}

# The program lists the members of an object when it is given another.
sub members {
	my ($object) = @_;
	my $said = `$program lookat '$object' 2>&1`;
	my ($list) = $said =~ /unknown member; there are (.*)/;
	return sorted(($list // $said) =~ /"(\w+)"/g);
}

# And the page has them in a section each, with a value.
sub on_page {
	my @sections = @_;
	my @names;
	for my $title (@sections) {
		my ($section) = $scene =~ /^\.Ss \Q$title\E\n(.*?)^\.S[sh]/ms;
		push @names, ($section // '') =~ /^\.It Cm (\w+) : No /mg;
	}
	return sorted(@names);
}

sub in_schema {
	my ($object) = @_;
	return sorted(keys %{$object->{properties}});
}

my $other = '"xyzzyxyzzy": 0';
my $camera = '"camera": {"eye": [0,0,0], "at": [1,1,1]}, ';
my $defs = $schema->{'$defs'};
is(in_schema($schema), members("{\"camera\": 0, $other}"),
    'a scene in the schema');
is(sorted(map { s/ .*//r } $scene =~ /^\.Ss (\w+)$/mg), in_schema($schema),
    'a scene on the page');
for my $name (qw(camera viewport window device bounds pick)) {
	my $has = members('{' . ($name eq 'camera' ? '' : $camera) .
	    "\"$name\": {$other}}");
	is(in_schema($defs->{$name}), $has, "$name in the schema");
	is(on_page($name), $has, "$name on the page");
}
is(in_schema($defs->{convention}{then}),
    members("{\"convention\": {$other}, \"camera\": 0}"),
    'convention in the schema');
is(on_page('convention'),
    sorted('convention', keys %{$defs->{convention}{then}{properties}}),
    'convention on the page');
for my $type (qw(persp ortho oblique volume matrix)) {
	my $has = members(
	    "{$camera \"projection\": {\"type\": \"$type\", $other}}");
	my $shared = $type =~ /^(?:volume|matrix)$/ ? 'type' :
	    on_page('projection');
	is(in_schema($defs->{$type eq 'matrix' ? 'any' : $type}), $has,
	    "$type in the schema");
	is(sorted(split / /, "$shared " . on_page("projection of type $type")),
	    $has, "$type on the page");
}

for my $page (qw(projcalc.1 projcalc-scene.5)) {
	SKIP: {
		skip 'no mandoc', 1 if missing('mandoc');
		is(`mandoc -T lint -W warning man/$page 2>&1`, '', $page);
	}
}
# README's table is of rows of the last measurement.
my $measured = slurp('testdata/charts/bench.md');
is(join('', grep { index($measured, $_) < 0 }
    slurp('README.md') =~ /^(\|.*\n)/mg), '', 'README\'s figures');
done_testing();
