# SPDX-License-Identifier: MIT
# Reads and runs sessions of the shell: testdata/transcripts/*.txt, and the
# examples of the manual pages and README.md. A transcript reads
#
#	# A sentence or two on the cases below.
#
#	# name-of-a-case
#	$ projcalc project scene.json - <<'END'
#	> 0 0 0
#	> 0 0
#	> END
#	320 240 0.8888888888888888
#	! projcalc: -:2: z is missing; 3 numbers are wanted
#	? 1
#
#	# name-of-the-next
#	$ ...
#
# The marks are
#
#	#  a comment, after an empty line; the last one names the case
#	$  a command, which is run in testdata with nothing on standard input
#	>  its next line
#	!  a line of standard error
#	?  the status, if it is not 0
#	%  a line of output with the escapes of printf(1), as in "% 1 1 1\r\n";
#	   without \n at its end the line has no newline
#
# Everything else is output. An empty line is output too, but for the one above
# the next comment or command. A command without this line or a name above is an error.
package Transcript;
use strict;
use warnings;
use Exporter 'import';
use Projcalc;

our @EXPORT = qw(transcript transcript_text examples said input);

my %escape = ("\n" => '\n', "\r" => '\r', "\t" => '\t', '\\' => '\\\\');
my %escaped = reverse %escape;

sub escape {
	my ($text) = @_;
	return $text =~ s{([\\\n\r\t]|[^ -~])}
	    {$escape{$1} // sprintf '\\%03o', ord $1}ger;
}

sub unescape {
	my ($text) = @_;
	return $text =~ s{(\\(?:([0-7]{3})|.))}
	    {defined $2 ? chr oct $2 : $escaped{$1} // $1}ger;
}

# Returns lines of output as a transcript has them. A line is escaped if it begins with
# a mark, ends in blanks, or has bytes other than printable ASCII.
sub shown {
	my ($text, $mark) = @_;
	my ($shown, $above) = ('', '');
	for my $line ($text =~ /[^\n]*\n|[^\n]+/g) {
		my $plain = $line =~ /\A(?:[ -~]*[!-~])?\n\z/ &&
		    $line !~ ($mark ? qr/\A%/ : qr/\A[\$>!?%]/) &&
		    !($above eq "\n" && $line =~ /\A#/);
		$shown .= $mark . ($plain ? $line : '% ' . escape($line) . "\n");
		$above = $line;
	}
	return $shown;
}

# Returns the output that a line of a transcript stands for, without the mark of
# standard error.
sub meant {
	my ($line) = @_;
	return $line =~ /\A% (.*)\n/ ? unescape($1) : $line;
}

# Returns the parts of a transcript: cases, and comments without a case, which have no
# command.
sub transcript {
	my ($file, $text) = @_;
	my ($line, @parts) = (1);
	for my $part (split /(?<=\n)\n(?=# |\$ )/, $text // slurp($file)) {
		$part =~ /\A((?:#.*\n)*)((?:\$ .*\n(?:>(?: .*)?\n)*)?)((?s:.*))\z/
		    && ($2 ne '' || $1 ne '' && $3 eq '') or
		    die "$file:$line: neither a comment nor a command\n";
		my ($comment, $command, $said) = ($1, $2, $3);
		die $file, ':', $line + ("$comment$command$`" =~ tr/\n//),
		    ": a command needs an empty line or its name above\n"
		    if $said =~ /^\$ /m;
		my %part = (file => $file, line => $line, dir => 'testdata',
		    comment => $comment, command => $command =~ s/^[\$>] ?//mgr,
		    name => $comment =~ /([^\n]*)\n\z/ ? $1 =~ s/^# //r : '',
		    status => 0, out => '', err => '');
		for ($said =~ /.*\n/g) {
			if (/\A\? (\d+)/) {
				$part{status} = $1;
			} elsif (s/\A! //) {
				$part{err} .= meant($_);
			} else {
				$part{out} .= meant($_);
			}
		}
		push @parts, \%part;
		$line += 1 + $part =~ tr/\n//;
	}
	return @parts;
}

sub part_text {
	my ($part) = @_;
	return $part->{comment} if $part->{command} eq '';
	my $command = '$ ' . $part->{command} =~ s/\n(?=.)/\n> /sgr;
	return $part->{comment} . $command =~ s/^> $/>/mgr .
	    shown($part->{out}, '') . shown($part->{err}, '! ') .
	    ($part->{status} ? "? $part->{status}\n" : '');
}

sub transcript_text { join "\n", map { part_text($_) } @_ }

# Returns the literal text of a manual page as a reader sees it.
sub displays {
	my ($page) = @_;
	return map { s/^\..*\n//mgr =~ s/\\&//gr =~ s/\\\(aq/'/gr =~
	    s/\\-/-/gr =~ s/\\e/\\/gr }
	    $page =~ /^\.Bd -literal.*\n((?s:.*?))^\.Ed/mg;
}

# Returns the examples of a manual page, which run in testdata, and of README.md,
# which run at the top of the project. A command goes on after a backslash or a bar
# at the end of its line, and within quotes. Its output follows it.
sub examples {
	my ($file) = @_;
	my $text = slurp($file);
	my $page = $file =~ m{^man/};
	my @cases;
	for my $shown ($page ? displays($text) : $text =~ /^```\n(.*?)^```/msg) {
		my (undef, @parts) = split /^\$ /m, "\n$shown";
		for my $part (@parts) {
			my ($command, @rest) = split /^/, $part;
			$command .= shift @rest while @rest &&
			    ($command =~ /[\\|]\n\z/ || $command =~ tr/'// % 2);
			push @cases, {file => $file, out => join('', @rest),
			    dir => $page ? 'testdata' : '.',
			    command => $command};
		}
	}
	return @cases;
}

# Runs the command of a case, and returns the case with its output now.
sub said {
	my ($case) = @_;
	my %said = %$case;
	@said{qw(status out err)} = run($case->{command}, $case->{dir})
	    if $case->{command} ne '';
	return \%said;
}

# Returns the input of a command: its here-document, or the output of its first
# part.
sub input {
	my ($command) = @_;
	return $1 if $command =~ /<<'END'\n(.*)^END$/ms;
	my ($print, undef, $text) = $command =~
	    /^(echo|printf(?: '%s\\n')?) ('?)(.*?)\2 \|/ or return '';
	return $print eq 'printf' ? unescape($text) : "$text\n";
}

1;
