#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Types each word of the table of remarks in words.c where it may stand, and then what
# its remark says, as the comment on the table explains. A call works if it ends with 0;
# a scene also if all that is wrong is that more is wanted.
# usage: synonyms_test.t [BUILD]
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use JSON::PP;
use Projcalc;

my $json = JSON::PP->new->canonical->allow_nonref;
my $help = $json->decode((run('projcalc help --json'))[1]);
my %takes_argument = map { my $o = $_; map { $_ => $o->{argument} } "--$o->{name}",
    $o->{letter} ? "-$o->{letter}" : () } @{$help->{options}};

# Scenes of three and of two dimensions, which have what any command needs.
my $scene = {convention => 'opencv', camera => {eye => [0, 2, -5], at => [0, 0, 0]},
    projection => {type => 'persp', fovy => 60, near => 1, far => 10},
    viewport => {width => 640, height => 480},
    pick => {at => [320, 240], radius => 400},
    bounds => {min => [-1, -1, -1], max => [1, 1, 1]}};
my $flat = {window => {center => [0, 0], width => 4, height => 3},
    device => {width => 640, height => 480}};

# Points in the forms that an option may want, and fields of zeros for binary formats.
spew("$tmp/$_->[0]", $_->[1]) for ['text', "1 1 1\n"], ['semicolons', "1;1;1\n"],
    ['csv', "1,1,1\n"], ['json', "[1,1,1]\n"], ['flat', "1 1\n"],
    ['binary', "\0" x 96];
my @inputs = map { "$tmp/$_" } qw(text csv json semicolons flat binary);

# Returns whether a call works, with a scene and points, or without.
my %works;

sub works {
	my ($call) = @_;
	return $works{$call} //= do {
		my $s = $call =~ /^(?:w2n|n2d|w2d|d2n|n2w|d2w)\b/ ? $flat : $scene;
		spew("$tmp/scene", $json->encode($s));
		my $found = $call eq 'help' && (run("projcalc help"))[0] == 0 ||
		    $call =~ / -$/ && (run("projcalc $call <$tmp/scene"))[0] == 0;
		for my $input ('', @inputs) {
			$found ||= (run("projcalc $call $tmp/scene $input"))[0] == 0;
		}
		$found;
	};
}

# Returns whether a command takes options, with a scene.
sub option_works {
	my ($options) = @_;
	for (qw(project inspect lookat fit pick)) {
		return 1 if works("$_ $options");
	}
	return works("project --separator ';' -i csv") if $options =~ /^--separator/;
	return 0;
}

# Returns whether members can be added to the scene, or replace what it has of them.
my %fits;

sub fits {
	my ($members) = @_;
	my ($name) = sort grep { !/^(?:camera|angle_unit|convention)$/ } keys %$members;
	my $command = ($name // '') =~ /^(?:window|device)$/ ? 'w2d' :
	    ($name // '') =~ /^(?:bounds|margin)$/ ? 'fit' :
	    ($name // '') eq 'pick' ? 'pick' : 'project';
	my $base = $command eq 'w2d' ? $flat : $scene;
	my $planes = {near => 1, far => 10};
	my @said;
	for my $how (0 .. 3) {
		my %tried = %$base;
		for my $key (keys %$members) {
			my ($old, $new) = ($base->{$key}, $members->{$key});
			$tried{$key} = ref $old ne 'HASH' || ref $new ne 'HASH' ? $new :
			    $how == 0 ? {%$old, %$new} :
			    $how == 1 || $key ne 'projection' ? $new :
			    {type => 'persp', ($how == 3 ? %$planes : ()), %$new};
		}
		my $point = $command eq 'w2d' ? $inputs[4] :
		    $command eq 'fit' ? '' : $inputs[0];

		# the scene's angle is in degrees
		$tried{projection} = {%{$tried{projection}}, fovy => 1}
		    if $tried{angle_unit} && ($tried{projection}{fovy} // 0) == 60;
		spew("$tmp/tried", $json->encode(\%tried));
		my ($status, $said) =
		    run("projcalc $command $tmp/tried $point 2>&1");
		return 1 if $status == 0 || $status == 1 &&
		    $said !~ /unknown|did you mean|does not go/ &&
		    $said =~ /missing|needs/;
		push @said, $said;
	}
	diag(@said);
	return 0;
}

# Returns whether a document can be typed alone, but for members that it lacks.
sub is_right_alone {
	my ($members) = @_;
	my $call = $members->{camera} ? 'lookat' :
	    $members->{projection} ? 'project -m --from view --to clip' :
	    $members->{world} ? 'project -m --to world' :
	    $members->{viewport} ? 'project -m --from ndc --to device' : undef;
	return 1 if !$call;
	spew("$tmp/alone", $json->encode($members));
	my ($status, $said) = run("projcalc $call $tmp/alone 2>&1");
	return 1 if $status == 0 || !grep { !/missing/ } split /\n/, $said;
	diag($said);
	return 0;
}

# Returns a value for a member, the i-th of those that are given together.
sub value_of {
	my ($row, $i) = @_;
	my $type = $row->{type};
	return $row->{words}[0] if @{$row->{words}};
	return [-10, 10, -10, 10] if $type eq '4 angles';
	return [500, 500, 320, 240] if $type =~ /K or P/;
	return [map { $i + $_ / 10 } 1 .. $1] if $type =~ /^(\d+) \w+/;
	return [map { $_ % 5 == 0 ? 1 : 0 } 0 .. 15] if $type =~ /matrix/;
	return $i + 1;
}

# Returns whether an object may have members with these names. `$of` may be its type.
sub belongs {
	my ($object, $of, @names) = @_;
	my %members;
	for my $name (@names) {
		my ($row) = grep { $_->{name} eq $name && ($_->{in} // '') eq $object &&
		    (!$of || !$_->{types} || grep { $_ eq $of } @{$_->{types}}) }
		    @{$help->{members}};
		return 0 if !$row;
		$members{$name} = value_of($row, scalar keys %members);
	}
	return $fits{"$object @names"} //= fits({$object => {
	    $of ? (type => $of) : (), %members}});
}

# Returns whether a manual has a section with this title.
sub has_section {
	my ($title, $page) = @_;
	return grep { slurp($_) =~ /^\.S[hs] \Q$title\E$/m } glob("man/$page.[0-9]");
}

# Returns what a remark says that is wrong, and appends to @$words what it says to type
# in place of the word.
sub wrong_in {
	my ($said, $words) = @_;
	my (@wrong, $last);
	my $left = $said;
	my $names = qr/(?:"\w+"(?:, | and | or )?)+/;
	my $braces;
	$braces = qr/\{(?:[^{}]|(??{$braces}))*\}/;
	while ($said =~ s/'([^']+)' in 'man ([\w-]+)'//) {
		my ($title, $page) = ($1, $2);
		push @wrong, $title if !has_section($title, $page);
	}
	while ($said =~ s/'projcalc ([^']+)'//) {
		push @wrong, $1 if !works($1);
	}
	while ($said =~ s/($braces)//) {
		my $members = $json->decode(my $object = $1);
		push @wrong, $object if !fits($members) || !is_right_alone($members);
	}
	while ($said =~ s/($names) of ($names)(?: of type "(\w+)")?//) {
		my ($members, $objects, $of) = ($1, $2, $3);
		for my $object ($objects =~ /\w+(?=")/g) {
			push @wrong, "$object: $members" if
			    !belongs($object, $of, $members =~ /\w+(?=")/g);
			$last = $object;
		}
	}
	my @rest = split / /, $said =~ s/,(?= |$)//gr;
	while (defined(my $option = shift @rest)) {
		push @wrong, $option
		    if $option =~ /^--?[a-z]/ && !exists $takes_argument{$option};
		next if !exists $takes_argument{$option};
		$last //= '';
		my $call = $option;
		while (1) {
			$call .= ' ' . shift @rest if $takes_argument{$option};
			last if !@rest || !exists $takes_argument{$rest[0]};
			$call .= ' ' . ($option = shift @rest);
		}
		push @wrong, $call if !option_works($call);
	}
	for my $word ($said =~ /"(\w+)"/g) {
		if (!$last) {
			push @$words, $word;
		} elsif (!belongs($last, undef, $word)) {
			push @wrong, "$last: $word";
		}
	}
	push @wrong, 'nothing to type' if $left eq $said && !defined $last && !@$words;
	return @wrong;
}

# Returns calls in which a word stands in a place.
sub calls_of {
	my ($place, $word) = @_;
	return $word if $place eq 'COMMAND';
	return map { "$_ '--$word'" } qw(project lookat inspect w2n)
	    if $place eq 'OPTION';
	my $s = sub { "project '" . $json->encode({%$scene, @_}) . "' '[1,1,1]'" };
	return ((map { "project $_ '$word' '" . $json->encode($scene) . "' '[1,1,1]'" }
	    qw(-c --to -i -p)),
	    "w2n '" . $json->encode({%$flat, window => {%{$flat->{window}},
		adapt => $word}}) . "' '[1,1]'",
	    $s->(projection => {type => $word}),
	    $s->(convention => {handedness => $word})) if $place eq 'VALUE';
	return ($s->($word => 1), $s->(world => [{$word => 1}]),
	    (map { my $o = $_; $s->($o => {%{$scene->{$o}}, $word => 1}) }
		qw(camera projection viewport bounds pick)),
	    (map { my $o = $_; "w2d '" . $json->encode({%$flat,
		$o => {%{$flat->{$o}}, $word => 1}}) . "' '[1,1]'" }
		qw(window device)));
}

# The rows of the table: places, words, the names that the remark says, and the remark.
my ($table) = slurp('cmd/message/words.c') =~ / remarks\[\] = \{(.*?)\n\};/s;
my $text = qr/(?:"(?:[^"\\]|\\.)*"\s*)+/;
my @rows = map { [/^([\w |]+),\s*($text),\s*($text|NULL),\s*($text)$/] }
    $table =~ /^\t\{ ([\w |]+,\s*$text,\s*(?:$text|NULL),\s*$text)\}/mg;
is(scalar @rows, scalar(() = $table =~ /^\t\{/mg), 'every row is read');
my %places = (CALL => 'COMMAND OPTION', ARGUMENT => 'OPTION VALUE',
    SETTING => 'OPTION MEMBER');
my %seen;

for my $row (@rows) {
	my ($places, $words, $names, $remark) = @$row;
	$_ = join('', /"((?:[^"\\]|\\.)*)"/g) =~ s/\\"/"/gr
	    for $words, $names, $remark;
	my @unsaid = grep { $remark !~ /"$_"|--?\w+ $_\b/ } split / /, $names;
	is("@unsaid", '', "says its names: $remark");
	my @places = split / /, join ' ', map { $places{$_} // s/^WORD_//r }
	    $places =~ /\w+/g;
	my @then;
	my @wrong = wrong_in($remark, \@then);
	is("@wrong", '', "works: $remark");
	unlike($words, qr/[A-Z_-]/, "as words are compared: $words");
	for my $place (@places) {
		for my $word (split / /, $words) {
			# of rows with names the one that fits what is there is said
			ok(!$seen{"$place $word" . ($names && " $names")}++,
			    "$place $word stands in one row");
			my @calls = calls_of($place, $word);
			my ($call) = grep {
				my ($status, $said) = run("projcalc $_ 2>&1");
				$status > 0 && index($said, $remark) >= 0;
			} @calls;
			ok(defined $call, "$place $word gets its remark") or next;
			for my $then (@then) {
				my $n = $call =~ /'\Q$word\E'/ ?
				    $call =~ s/'\Q$word\E'/'$then'/r :
				    $call =~ s/"\Q$word\E"/"$then"/r;
				my ($status, $said) = run("projcalc $n 2>&1");
				ok($status == 0 || $status > 0 &&
				    $said =~ /missing|needs|alone/ && $said !~ /unknown/,
				    "then: $n") or diag($said);
			}
		}
	}
}
done_testing();
