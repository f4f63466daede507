#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that the examples of the manual pages and README.md print the output
# that is written below them.
# usage: examples_test.t [BIN]; the directory of projcalc, or build
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;
use Transcript;

for my $case (map { examples($_) } glob 'man/*.[157] README.md') {
	my $name = join ' ', split /\n/, $case->{command};
	SKIP: {
		my $lacks = missing(grep { $name =~ /\b$_\b/ }
		    qw(parallel jq python3 bash));
		skip "no $lacks: $name", 1 if $lacks;
		# errors are among the output, as in a terminal
		my $command = "{ $case->{command}} 2>&1";
		is(said({%$case, command => $command})->{out}, $case->{out},
		    $name);
	}
}
done_or('write what came into the page');
