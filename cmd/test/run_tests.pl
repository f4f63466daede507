#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Runs test programs, cmocka's and perl's, and sums them up in one line.
# usage: run_tests.pl JOBS PROGRAM...
use strict;
use warnings;
use TAP::Harness;

my $jobs = shift;
$ENV{CMOCKA_MESSAGE_OUTPUT} = 'TAP';
my $harness = TAP::Harness->new({
	jobs => $jobs,
	exec => sub {
		my ($harness, $file) = @_;
		return $file =~ /\.t$/ ? [$^X, $file] : [$file];
	},
});
my $sum = $harness->runtests(@ARGV);

# A program that crashed or stopped early has failed, even if all its cases passed. A
# program that skips all its cases counts as one.
my $failed = $sum->failed;
my $skipped = $sum->skipped;
my $passed = $sum->passed - $skipped;
for my $program ($sum->parsers) {
	$failed++ if $program->has_problems && !$program->failed;
	$skipped++ if defined $program->skip_all;
}
printf "%d passed, %d failed, %d skipped\n", $passed, $failed, $skipped;
exit($failed > 0);
