# Sessions in a shell as files: testdata/transcripts/*.txt, the manual pages
# and README.md. A transcript reads
#
#	# What comes next, in a sentence or two.
#
#	# name-of-the-case
#	$ printf '1 1 1\n' | projcalc project scene.json - '[0,0]'
#	what is printed
#	! what standard error says
#	? 1
#
# "$ " begins a command, "> " goes on with it; "? " is its status if that is
# not 0. A case begins after an empty line, with lines of comment or at once
# with its command. Any other line is output: also one that begins with "#", and
# an empty one, unless another case begins behind it. What can't stand so begins
# with "% " and has the escapes of printf(1): "% 1 1 1\r\n"; without the \n it
# is a line that doesn't end. Standard input is empty.
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

# Lines as they are, but for those that would be taken for something else.
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

sub meant {
	my ($line) = @_;
	return $line =~ /\A% (.*)\n/ ? unescape($1) : $line;
}

# The parts of a transcript: cases, and comments that stand alone, which have
# no command.
sub transcript {
	my ($file, $text) = @_;
	my ($line, @parts) = (1);
	for my $part (split /(?<=\n)\n(?=# |\$ )/, $text // slurp($file)) {
		$part =~ /\A((?:#.*\n)*)((?:\$ .*\n(?:>(?: .*)?\n)*)?)((?s:.*))\z/
		    && ($2 ne '' || $1 ne '' && $3 eq '') or
		    die "$file:$line: neither a comment nor a command\n";
		my ($comment, $command, $said) = ($1, $2, $3);
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

# What a manual page shows literally, as a reader sees it.
sub displays {
	my ($page) = @_;
	return map { s/^\..*\n//mgr =~ s/\\&//gr =~ s/\\\(aq/'/gr =~
	    s/\\-/-/gr =~ s/\\e/\\/gr }
	    $page =~ /^\.Bd -literal.*\n((?s:.*?))^\.Ed/mg;
}

# The examples of a manual page, which are run in testdata, and of README.md,
# at the top. A command goes on after a backslash or a bar at the end of its
# line, and within quotes. What follows it is what it prints.
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

# The case with what its command says now.
sub said {
	my ($case) = @_;
	my %said = %$case;
	@said{qw(status out err)} = run($case->{command}, $case->{dir})
	    if $case->{command} ne '';
	return \%said;
}

# What a command is given to read: its here-document, or what is printed first.
sub input {
	my ($command) = @_;
	return $1 if $command =~ /<<'END'\n(.*)^END$/ms;
	my ($print, undef, $text) = $command =~
	    /^(echo|printf(?: '%s\\n')?) ('?)(.*?)\2 \|/ or return '';
	return $print eq 'printf' ? unescape($text) : "$text\n";
}

1;
