#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that the program agrees with the tests of other projects: each line of
# testdata/recorded/peers.jsonl is a call, the file that expects its numbers, and the
# tolerance there, absolute and relative. Where 25 digits of the truth are known, which
# were computed without the program, each number is the double nearest to it.
use strict;
use warnings;
use FindBin;
use JSON::PP;
use POSIX 'strtod';
use lib $FindBin::Bin;
use Projcalc;

sub is_near {
	my ($row, $said, $i) = @_;
	my $expected = $row->{expected}[$i];
	my $truth = $row->{truth} ? (strtod($row->{truth}[$i]))[0] : $said;
	return abs($said - $expected) <= $row->{abs} + $row->{rel} * abs $expected &&
	    $said == $truth;
}

for my $line (split /\n/, slurp('testdata/recorded/peers.jsonl')) {
	my $row = decode_json($line);
	my $command = join ' ', 'projcalc', map { "'" . s/'/'\\''/gr . "'" }
	    @{$row->{call}};
	my ($status, $out, $err) = run($command);
	my @said = map { my ($v, $left) = strtod($_); $left == 0 ? $v : 'nan' }
	    split ' ', $out;
	ok($status == 0 && @said == @{$row->{expected}} &&
	    !grep({ !is_near($row, $said[$_], $_) } 0 .. $#said),
	    "$row->{source}: $command") or
	    diag("expected: @{$row->{expected}}\nsaid:\n$out$err");
}
done_testing();
