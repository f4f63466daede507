#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Runs the commands in testdata/transcripts, and compares their output.
# usage: transcripts_test.t [-w] [BUILD] [FILE...]; -w rewrites what is
# expected.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;
use Transcript;

my @files = @ARGV ? @ARGV : sort glob 'testdata/transcripts/*.txt';
# script(1) runs a command in a terminal, which a chroot may not have.
my $terminal =
    system('script -qec true /dev/null </dev/null >/dev/null 2>&1') == 0;

sub can_run {
	my ($case) = @_;
	return $terminal || $case->{command} !~ /\bscript -/;
}

sub compare {
	my ($case, $said) = @_;
	my ($want, $now) = map { transcript_text($_) } $case, $said;
	ok($want eq $now, "$case->{file}:$case->{line}: $case->{name}") and return;
	# Empty lines above keep the numbers of lines of the file.
	my $above = "\n" x ($case->{line} - 1);
	spew("$tmp/want", $above . $want);
	spew("$tmp/now", $above . $now);
	diag(`diff -u --label $case->{file} --label said $tmp/want $tmp/now`);
}

# Commands write and remove files in a copy of testdata.
my $dir = "$tmp/testdata";
system('cp', '-R', 'testdata', $dir) == 0 or die "$dir: not copied\n";

for my $file (@files) {
	my @parts = transcript($file);
	my @said = map { can_run($_) ? said({%$_, dir => $dir}) : $_ } @parts;
	if ($write) {
		spew($file, transcript_text(@said));
		next;
	}
	for my $i (grep { $parts[$_]{command} ne '' } 0 .. $#parts) {
		SKIP: {
			skip 'no terminal', 1 if !can_run($parts[$i]);
			compare($parts[$i], $said[$i]);
		}
	}
}
exit if $write;
# -w must not take a command for the output of the one above, and drop it.
ok(!eval { transcript('t', "# a\n\n# b\n\$ echo 1\n1\n\$ echo 2\n2\n") },
    'a command without an empty line above is refused');
is($@, "t:6: a command needs an empty line or its name above\n", 'with its line');
done_or('make transcripts');
