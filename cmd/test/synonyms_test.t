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
my %params = (lookat => '{"eye":[0,0,-5],"at":[0,0,0]}', persp => $lens,
    w2n => '{"center":[0,0],"width":1,"height":1}',
    n2d => '{"width":1,"height":1}', ortho => '{"width":1,"height":1,"near":0,"far":1}');

my ($table) = slurp('cmd/message/words.c') =~ /word_rows\[\] = \{(.*?)\n\};/s;
my %words = map { $_ => 1 } (map { split } $table =~ /^\t\{ \w+, "([^"]+)"/mg),
    qw(pan rvec rotation flags columns fovy zoom eye lookAt
    radians transpose column-major near_far near-far extent);

# Runs words of the shell. Returns the status and the output.
sub try {
	my $said = `cd testdata && '$build/projcalc' $_[0] 2>&1 </dev/null`;
	return ($? >> 8, $said);
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
	push @calls, map { "$command $_" } $said =~ /did you mean (-[^?]*)\?/g;
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

my @commands = qw(lookat persp project fit inspect w2n);
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

# Remarks are also about members.
while ($table =~ /^\t\{ \w+, ((?:"[^"]*"\s*)+),\s*": /mg) {
	for my $word (map { split } $1 =~ /"([^"]*)"/g) {
		my ($status, $said) = try("lookat '{\"$word\":1}'");
		ok($status == 1 && $said =~ /unknown member; (?!there are)/,
		    "member $word") or diag($said);
	}
}

for my $said (slurp('testdata/transcripts/first-tries.txt') =~ /^! (.*)/mg) {
	my ($command) = $said =~ /^projcalc: (\w+): unknown/;
	works($_) for suggested($command // 'project', $said);
}
done_testing();
