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
my $jobs = `getconf _NPROCESSORS_ONLN`;
# script(1) runs a command in a terminal, which a chroot may not have.
my $terminal =
    system('script -qec true /dev/null </dev/null >/dev/null 2>&1') == 0;

sub can_run {
	my ($case) = @_;
	return $terminal || $case->{command} !~ /\bscript -/;
}

# Starts a process for a file, which prints the transcript with the output of now. Each
# process has its own copy of testdata, as commands write and remove files there.
sub start {
	my ($file) = @_;
	my $pid = open(my $from, '-|') // die "fork: $!\n";
	return $from if $pid != 0;
	my $own = "$tmp/$$";
	system('cp', '-R', 'testdata', $own) == 0 or die "$own: not copied\n";
	print transcript_text(map { can_run($_) ? said({%$_, dir => $own}) : $_ }
	    transcript($file));
	exit 0;
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

my @running;
for my $i (0 .. $#files) {
	push @running, start($files[@running])
	    while @running < @files && @running < $i + $jobs;
	my $text = do { local $/; readline $running[$i] };
	close $running[$i] or die "$files[$i]: not done\n";
	spew($files[$i], $text) if $write;
	my @said = transcript($files[$i], $text);
	for my $case (transcript($files[$i])) {
		my $said = shift @said;
		next if $case->{command} eq '';
		SKIP: {
			skip 'no terminal', 1 if !can_run($case);
			compare($case, $said);
		}
	}
}
done_or('make transcripts');
