#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that the program and its manual pages agree: the commands and options are those
# of the synopsis; the members of a scene, their defaults and words are those of
# projcalc-scene(5). Each command and option has a call in the transcripts that
# succeeds. The examples of the help work, README has the figures of the last
# measurement, mandoc finds no fault in the pages, and they keep their sizes.
use strict;
use warnings;
use FindBin;
use JSON::PP;
use List::Util qw(uniq);
use lib $FindBin::Bin;
use Projcalc;
use Transcript;

my $program = "$build/projcalc";
my $manual = slurp('man/projcalc.1');
my $scene = slurp('man/projcalc-scene.5');
my $numbers = slurp('man/projcalc-numbers.7');
my $schema = decode_json(scalar `$^X man/schema.pl $program`);

# The options by command, by their letter if they have one.
my %synopsis;
my ($text) = $manual =~ /^\.Sh SYNOPSIS\n(.*?)^\.Sh/ms;
my ($calls, $shared) = split /^\.Pp\n/m, $text;
for my $call (split /^\.Nm\n/m, $calls) {
	my ($commands) = $call =~ /^\.Cm (.*)/ or next;
	# the options of every command are not in it
	$call .= $shared if $call =~ /^\.Op Ar shared options$/m;
	my @options = $call =~ /\bFl (\S+)/g;
	$synopsis{$_} = sorted(@options) for split / \| /, $commands;
}
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
		    unless $long =~ /^(?:errors|color|help|version)$/;
	}
	is($synopsis{$command}, sorted(@names), "options of $command");
	is(`$program $command -h`, $said, "-h of $command");
}
for my $option (sort keys %options) {
	like($options, qr/^\.It .*\Q$options{$option}\E\b/m,
	    "option $option is explained");
}

my $all = decode_json(scalar `$program help --json`);
is(sorted(map { $_->{name} } @{$all->{commands}}), sorted(@commands),
    'commands in JSON');
is($all->{version}, `$program --version` =~ s/^projcalc |\n//gr,
    'version in JSON');
for my $c (@{$all->{commands}}) {
	is("@{$c->{options}}", join(' ', `$program help $c->{name}` =~
	    /^  (?:-\w, |    )--([\w-]+)/mg), "options of $c->{name} in JSON");
	# the example can be pasted into a shell
	my @said = run($c->{example});
	is("$said[0]$said[2]", 0, "$c->{example} succeeds");
	isnt($said[1], '', 'and prints');
	like(`$program help $c->{name}`, qr/^example: \Q$c->{example}\E$/m,
	    "the help shows it");
}

my ($about) = $manual =~ /^\.Sh COMMANDS\n(.*?)^\.Sh/ms;
my @calls = map { $_->{command} =~ /^.*$/mg } grep { ($_->{status} // 0) == 0 }
    map { transcript($_) } glob 'testdata/transcripts/*.txt';
for my $command (@commands) {
	like($about, qr/^\.It Cm .*\b$command\b/m, "$command is explained");
	ok((grep { /projcalc $command\b/ } @calls) > 0, "a transcript calls $command");
}
for my $o (@{$all->{options}}) {
	my $commands = join '|', map { quotemeta } @{$o->{commands}};
	my $letter = $o->{letter} ? "|-\\w*$o->{letter}" : '';
	ok((grep { /projcalc (?:$commands|\$\w+) (?:.* )?(?:--$o->{name}\b$letter)/ }
	    @calls) > 0, "a transcript calls --$o->{name}");
}

# Returns the rows of an object's members; those of the scene if $in is undef.
sub rows {
	my ($in, $type) = @_;
	return grep { ($_->{in} // '') eq ($in // '') &&
	    (!$type || !$_->{types} || grep { $_ eq $type } @{$_->{types}}) }
	    @{$all->{members}};
}

sub members { sorted(map { $_->{name} } rows(@_)) }

# Returns the names of the members in sections of the page, each of which has a value.
sub on_page {
	my @sections = @_;
	my @names;
	for my $title (@sections) {
		my ($section) = $scene =~ /^\.Ss \Q$title\E\n(.*?)^\.S[sh]/ms;
		push @names, ($section // '') =~ /^\.It Cm (\w+) : No /mg;
	}
	return sorted(@names);
}

# Returns the item of a name on the page, in sections whose title begins with $title.
sub item {
	my ($title, $name) = @_;
	my $found = '';
	for my $section ($scene =~ /^\.Ss \Q$title\E[^\n]*\n(.*?)(?=^\.S[sh])/gms) {
		$found .= $1 if $section =~
		    /^\.It Cm \Q$name\E : No (.*?)(?=^\.(?:It|El))/ms;
	}
	return $found =~ s/\\\(dq|\n(?:\.Cm |\.Bq )?/ /gr;
}

my $json = JSON::PP->new->canonical->allow_nonref;

# Checks that the page has the default and the words of the rows, and that each word of
# the schema is one of these words.
sub compare {
	my ($title, @rows) = @_;
	for my $row (@rows) {
		my $name = ($row->{in} ? "$row->{in}/" : '') . $row->{name};
		my $told = $json->encode($row->{default}) =~ s/["\[\]]//gr =~
		    s/,/, /gr;
		my $item = item($title, $row->{name});
		like($item, $told eq 'null' ? qr// :
		    $name eq 'world' ? qr/default is the identity/ :
		    qr/default.*\Q$told\E|\Q$told\E.*default/s,
		    "default of $name on the page");
		like($scene, qr/(?:\\\(dq|Cm )\Q$_\E\b/, "$_ of $name on the page")
		    for @{$row->{words}};
	}
}

# Returns all words that a schema lists.
sub words_of {
	my ($s) = @_;
	return map { words_of($_) } @$s if ref $s eq 'ARRAY';
	return () if ref $s ne 'HASH';
	return (@{$s->{enum} // []}, map { words_of($_) } values %$s);
}

is(sorted(uniq(words_of($schema))), sorted(uniq('row', 'column', 'fill', 'uniform',
    map { @{$_->{words}} } @{$all->{members}})), 'words in the schema');
like($manual, qr/\b\Q$_\E\b/, "$_ in the manual")
    for @{$all->{formats}}, @{$all->{spaces}};
# Formats and spaces are words of options, which completions take from these rows.
for my $about ([formats => 'output'], [spaces => 'to']) {
	my ($list, $option) = @$about;
	my ($row) = grep { $_->{name} eq $option } @{$all->{options}};
	is("@{$row->{words}}", "@{$all->{$list}}", "$list as words of --$option");
}
is(sorted(map { s/ .*//r } $scene =~ /^\.Ss (\w+)$/mg), members(),
    'a scene on the page');
for my $row (rows()) {
	compare($row->{name}, $row);
	my $help = `$program help $row->{name}`;
	if ($help =~ /^usage/) {
		like($help, qr/^$row->{name}:$/m, "$row->{name} in its help");
		next;
	}
	my ($example) = $help =~ /^example: (.*)$/m;
	my @said = run($example);
	is("$said[0]$said[2]", 0, "$example succeeds");
	isnt($said[1], '', 'and prints');
}
for my $name (qw(camera viewport window device bounds pick)) {
	is(on_page($name), members($name), "$name on the page");
	compare($name, rows($name));
}
is(sorted(on_page('lists of steps'), 'vectors'), sorted(members('world')),
    'steps on the page');
is(on_page('convention'), sorted('convention', split / /, members('convention')),
    'convention on the page');
compare('convention', rows('convention'));
my @shown = map { transcript($_) } glob 'testdata/transcripts/*.txt';
my ($formulas) = $numbers =~ /^\.Sh FORMULAS\n(.*?)^\.Sh/ms;
my ($types) = map { $_->{words} } grep { $_->{name} eq 'type' } rows('projection');
for my $type (@$types) {
	my $shared = $type =~ /^(?:volume|matrix)$/ ? 'type' :
	    on_page('projection');
	is(sorted(split / /, "$shared " . on_page("projection of type $type")),
	    members('projection', $type), "$type on the page");
	compare('projection', rows('projection', $type));
	ok((grep { $_->{status} == 0 && $_->{command} =~
	    /\bprojcalc $type\b|"type":\s*"$type"/ } @shown),
	    "a transcript shows $type");
	ok($type eq 'matrix' || $formulas =~ /^\.It Cm $type\b/m,
	    "the formula of $type");
}
# The message about a wrong member lists the members.
like((run('projcalc n2d \'{"device": {"xyzzyxyzzy": 0}}\''))[2],
    qr/unknown member; there are "x", "y", .* and "origin"$/m,
    'members in a message');

for my $page (map { s|^man/||r } glob 'man/*.[157]') {
	SKIP: {
		skip 'no mandoc', 1 if missing('mandoc');
		is(`mandoc -T lint -W warning man/$page 2>&1`, '', $page);
	}
}
# The pages keep their sizes: a user reads the first screen, and finds the rest.
SKIP: {
	skip 'no mandoc', 7 if missing('mandoc');
	my %most = ('projcalc.1' => 5500, 'projcalc-scene.5' => 4500);
	my $all_words = 0;
	for my $page (map { s|^man/||r } glob 'man/*.[157]') {
		my $said = `mandoc -T utf8 -O width=80 man/$page` =~ s/.\x08//gr;
		my $words = () = $said =~ /\S+/g;
		$all_words += $words;
		cmp_ok($words, '<=', $most{$page} // 17500, "words of $page");
		next if $page ne 'projcalc.1';
		my @screen = (split /\n/, $said)[0 .. 23];
		is(scalar(() = "@screen" =~ /(?:\$|\|) projcalc /g), 10, 'ten calls on a screen');
		my ($points) = $said =~ /^POINTS\n(.*?)^[A-Z]/ms;
		cmp_ok(scalar(() = $points =~ /\S+/g), '<=', 700, 'words of POINTS');
	}
	cmp_ok($all_words, '<=', 17500, 'words of the manual');
}
# README has the tables of the last measurement and the words about them.
my @figures = map { slurp($_) =~ /^(<!-- speed -->\n.*?^<!-- -->\n)/ms }
    qw(README.md testdata/charts/bench.md);
is($figures[0], $figures[1], 'README\'s figures');
done_testing();
