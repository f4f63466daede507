#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# What the program says of itself is what its manual pages say: commands and
# options are those of the synopsis, members of a scene and their defaults those of
# its page and of the schema; the examples of its help work; README's figures are
# measured ones; and the pages are without a fault that mandoc sees.
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
	# the options of every command are not in it
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
	# and the command to paste
	my @said = run($c->{example});
	ok($said[0] == 0 && $said[1] ne '' && $said[2] eq '', $c->{example});
	like(`$program help $c->{name}`, qr/^example: \Q$c->{example}\E$/m,
	    "the help shows it");
}

# The rows of an object's members; of a scene's where its name is undef.
sub rows {
	my ($in, $type) = @_;
	return grep { ($_->{in} // '') eq ($in // '') &&
	    (!$type || !$_->{types} || grep { $_ eq $type } @{$_->{types}}) }
	    @{$all->{members}};
}

sub members { sorted(map { $_->{name} } rows(@_)) }

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

# An item of the page, in the sections of that title or their beginning.
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
my $defs = $schema->{'$defs'};

# What the schema says of a type of the rows; near and far are sizes in a
# perspective alone.
my %shape = (number => qr/number"|size"/, size => qr/size"/,
    angle => qr/number"|opening"/, '4 angles' => qr/"exclusiveMaximum":90.*"maxItems":4/,
    '2 numbers' => qr/pair"/, '3 numbers' => qr/triple"|direction"/,
    '4 numbers' => qr/"maxItems":4/, matrix => qr/matrix"|affine"/,
    'true or false' => qr/"boolean"/, object => qr/"properties"|"allOf"/);

# Rows have the type and the default that the schema has, and the page tells it.
sub compare {
	my ($title, $properties, @rows) = @_;
	for my $row (@rows) {
		my $p = $properties->{$row->{name}};
		my ($def) = ($p->{'$ref'} // '') =~ m{(\w+)$};
		my $default = $p->{default} // ($def && $defs->{$def}{default});
		my $name = ($row->{in} ? "$row->{in}/" : '') . $row->{name};
		$default = $row->{default} if $name eq 'world';
		is($json->encode($row->{default}), $json->encode($default),
		    "default of $name in the schema");
		like($json->encode([$p, $def ? $defs->{$def} : ()]),
		    $shape{$row->{type}} // qr//, "type of $name in the schema");
		my $told = $json->encode($row->{default}) =~ s/["\[\]]//gr =~
		    s/,/, /gr;
		like(item($title, $row->{name}), $told eq 'null' ? qr// :
		    $name eq 'world' ? qr/default is the identity/ :
		    qr/default.*\Q$told\E|\Q$told\E.*default/s,
		    "default of $name on the page");
		my $words = $p->{enum} // [];
		is("@{$row->{words}}", "@$words", "words of $name") if @$words;
	}
}

is(in_schema($schema), members(), 'a scene in the schema');
is(sorted(map { s/ .*//r } $scene =~ /^\.Ss (\w+)$/mg), in_schema($schema),
    'a scene on the page');
for my $row (rows()) {
	compare($row->{name}, $schema->{properties}, $row);
	my $help = `$program help $row->{name}`;
	if ($help =~ /^usage/) {
		like($help, qr/^$row->{name}:$/m, "$row->{name} in its help");
		next;
	}
	my ($example) = $help =~ /^example: (.*)$/m;
	my @said = run($example);
	ok($said[0] == 0 && $said[1] ne '' && $said[2] eq '', $example);
}
for my $name (qw(camera viewport window device bounds pick)) {
	is(in_schema($defs->{$name}), members($name), "$name in the schema");
	is(on_page($name), members($name), "$name on the page");
	compare($name, $defs->{$name}{properties}, rows($name));
}
my $convention = $defs->{convention}{then};
is(in_schema($convention), members('convention'), 'convention in the schema');
is(on_page('convention'), sorted('convention', keys %{$convention->{properties}}),
    'convention on the page');
compare('convention', $convention->{properties}, rows('convention'));
for my $type (qw(persp ortho oblique volume matrix)) {
	my $has = members('projection', $type);
	my $shared = $type =~ /^(?:volume|matrix)$/ ? 'type' :
	    on_page('projection');
	my $def = $defs->{$type eq 'matrix' ? 'any' : $type};
	is(in_schema($def), $has, "$type in the schema");
	is(sorted(split / /, "$shared " . on_page("projection of type $type")),
	    $has, "$type on the page");
	compare('projection', $def->{properties}, rows('projection', $type));
}
# And a wrong member is told which there are.
like((run('projcalc lookat \'{"camera": {"xyzzyxyzzy": 0}}\''))[2],
    qr/unknown member; there are "eye", "at", .* and "orthonormalize"$/,
    'members in a message');

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
