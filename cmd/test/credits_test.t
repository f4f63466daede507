#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that each source has an SPDX line with its license at the top or below #!, and
# that .debian/copyright names only existing files, and licenses whose text it has.
# usage: credits_test.t [-w]; with -w the line is added where it is missing
use strict;
use warnings;
use File::Find;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

my $says = 'SPDX-License-Identifier: MIT';
my %comment = (
	(map { $_ => "/* $says */\n" } qw(c h)),
	(map { $_ => "// $says\n" } qw(cc js)),
	v => "(* $says *)\n",
	(map { $_ => ".\\\" $says\n" } 1, 5, 7),
	(map { $_ => "# $says\n" } qw(awk gp pl pm py sh t script)),
);
my @sources = qw(Makefile .ci/run .debian/build .debian/deps);
find({no_chdir => 1, wanted => sub {
	push @sources, $_ if -f && /\.(\w+)\z/ && $comment{$1};
}}, qw(cmd core man));

my @lacking;
for my $file (sort @sources) {
	my $line = $comment{$file =~ /\.(\w+)\z/ ? $1 : ''} // $comment{script};
	my $text = slurp($file);
	next if $text =~ /\A(?:#!.*\n)?\Q$line\E/;
	if ($write) {
		spew($file, $text =~ s/\A((?:#!.*\n)?)/$1$line/r);
	} else {
		push @lacking, $file;
	}
}
is("@lacking", '', "sources say $says");

my (%named, %told);
for my $part (split /\n\n/, slurp('.debian/copyright')) {
	my ($license) = $part =~ /^License: (.*)/m or next;
	if ($part =~ /^Files: (.*(?:\n .*)*)/) {
		$named{$license}++;
		for my $file (split ' ', $1) {
			ok($file eq '*' || -f $file, "$file is there");
			like($part, qr/^Copyright: \S/m, "$file has an author");
		}
	} else {
		$told{$license} = $part =~ /\n ./;
	}
}
is(sorted(keys %named), sorted(grep { $told{$_} } keys %told),
    'licenses that are named');
done_or('perl cmd/test/credits_test.t -w');
