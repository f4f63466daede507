# SPDX-License-Identifier: MIT
# Makes mutants. A mutant is a change of the program's source, as by a tired programmer,
# which a test should find. It is kept as
#
#	{file => 'core/x.c', line => 12, from => "\tlines as they stand\n",
#	    to => "\tand as they are changed\n"}
package Mutant;
use strict;
use warnings;
use Exporter 'import';

our @EXPORT = qw(mutants mutated hunk hunks same_change);

# Returns the text with blanks in place of comments, strings and the preprocessor's
# lines, except for the bodies of macros.
sub code {
	my ($text) = @_;
	my $blank = sub { $_[0] =~ tr/\n/ /cr };
	$text =~ s{(/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+')}
	    {substr($1, 0, 1) eq '/' ? $blank->($1) : $1 =~ tr/\n/_/cr}gse;
	$text =~ s{^(#define \w+(?:\([^)\n]*\))?|#(?!define)(?:[^\n]*\\\n)*[^\n]*)}
	    {$blank->($1)}gme;
	return $text;
}

my %comparison = qw(< <= <= < > >= >= > == != != ==);
my %operator = ('+' => '-', '-' => '+', '*' => '/', '/' => '*', '%' => '*',
    '&&' => '||', '||' => '&&', '&' => '|', '|' => '&', '^' => '|',
    '<<' => '>>', '>>' => '<<', '+=' => '-=', '-=' => '+=', '*=' => '/=',
    '|=' => '&=', '&=' => '|=');
my %step = ('++' => '--', '--' => '++');

# Returns the changes of a literal: an integer plus and minus one; the double and the
# half of other numbers.
sub neighbours {
	my ($n) = @_;
	return map { $_ . $2 } $1 + 1, $1 > 0 ? $1 - 1 : ()
	    if $n =~ /\A(\d{1,15})([uUlL]*)\z/;
	return $1 . sprintf('%x', hex($2) ^ 1) . $3
	    if $n =~ /\A(0x[\da-fA-F]*)([\da-fA-F])([uUlL]*)\z/;
	return map { $1 . ($2 + $_) . $3 } 1, -1
	    if $n =~ /\A(0x[\da-fA-F.]+p)([-+]?\d+)([fF]?)\z/;
	return map { sprintf('%.17g', $1 * $_) . $2 } $1 != 0 ? (2, 0.5) : ()
	    if $n =~ /\A([\d.]+(?:e[-+]?\d+)?)([fF]?)\z/;
	return;
}

# Returns the place of the parenthesis that closes the last one before $at.
sub closing {
	my ($code, $at) = @_;
	for (my $level = 1; ; $at++) {
		my $c = substr $code, $at, 1;
		return if $c eq '';
		$level += ($c eq '(') - ($c eq ')');
		return $at if $level == 0;
	}
}

my $words = qr/(?:if|else|for|while|do|switch|case|default|struct|enum|union|
    static|const|typedef|using|template|namespace|extern|goto)\b/x;
# A declaration: a type, a name, and the character after them.
my $declaration = qr/(?!return\b)\w[\w:<>]*(?:\s+\w+)*\s+\**\w+
    (?:\[[^\]]*\])*\s*(?:[=;,]|\z)/x;

# Returns the changes of a text, each as [kind, offset, length, replacement].
sub changes {
	my ($code) = @_;
	my @found;
	while ($code =~ m{(?<=[\w)\] ] )(<=|>=|==|!=|<|>|[-+*/%&|^]=?|&&|\|\||<<|>>)(?=\s)}g) {
		my $to = $comparison{$1} // $operator{$1} // next;
		push @found, [$comparison{$1} ? 'comparison' : 'operator',
		    $-[1], length $1, $to];
	}
	push @found, ['operator', $-[1], 2, $step{$1}]
	    while $code =~ /(\+\+|--)/g;
	while ($code =~ /(?<![\w.])((?:0x[\da-fA-F.]+(?:p[-+]?\d+)?|
	    \d*\.?\d+\.?(?:e[-+]?\d+)?)[uUlLfF]*)(?![\w.])/gx) {
		my ($at, $n) = ($-[1], $1);
		push @found, ['constant', $at, length $n, $_]
		    for neighbours($n);
	}
	while ($code =~ /\b(?:if|while) (?:constexpr )?\(/g) {
		my $at = $+[0];
		my $end = closing($code, $at) // next;
		push @found, ['condition', $at, $end - $at,
		    '!(' . substr($code, $at, $end - $at) . ')'];
	}
	while ($code =~ /(?<=[;{})e:])[\t ]*\n\s*\n*\t+(?=([^;{}]+;))/g) {
		my ($at, $statement) = ($+[0], $1);
		next if $statement =~ /\A$words|\A$declaration/ ||
		    $statement =~ tr/(// != $statement =~ tr/)//;
		# a function must end with its return
		next if $statement =~ /\Areturn\b./ &&
		    substr($code, 0, $at) !~ /\)\s*\z/;
		push @found, ['statement', $at, length $statement, ';'];
	}
	return @found;
}

# Returns all mutants of a file, by their kind.
sub mutants {
	my ($file, $text) = @_;
	my %mutants;
	for my $change (changes(code($text))) {
		my ($kind, $at, $length, $to) = @$change;
		$to = '!(' . substr($text, $at, $length) . ')'
		    if $kind eq 'condition';
		my $start = 1 + rindex $text, "\n", $at - 1;
		my $end = 1 + index $text, "\n", $at + $length;
		my $from = substr $text, $start, $end - $start;
		my $instead = $from;
		substr $instead, $at - $start, $length, $to;
		push @{$mutants{$kind}}, {file => $file, from => $from,
		    to => $instead, at => $start,
		    line => 1 + (substr($text, 0, $start) =~ tr/\n//)};
	}
	return \%mutants;
}

sub trimmed { $_[0] =~ s/^\s+|\s+$//gmr }

# Returns the text with the change of a mutant. If the text has the mutant's lines at
# several places, changes those nearest to its line number; if nowhere, returns undef.
sub mutated {
	my ($text, $mutant) = @_;
	my $pattern = join '\n\s*', map { quotemeta }
	    split /\n/, trimmed($mutant->{from});
	my ($best, $at, $length);
	while ($text =~ /^[ \t]*$pattern[ \t]*\n/gm) {
		my ($from, $to) = ($-[0], $+[0]);
		my $line = 1 + (substr($text, 0, $from) =~ tr/\n//);
		my $off = abs($line - ($mutant->{line} || 0));
		($best, $at, $length) = ($off, $from, $to - $from)
		    if !defined $best || $off < $best;
	}
	return if !defined $at;
	substr $text, $at, $length, $mutant->{to};
	return $text;
}

# Returns a mutant as text, for messages and files: FILE:LINE, the old lines with -
# before them, the new ones with +.
sub hunk {
	my ($mutant) = @_;
	my $lines = sub { $_[1] =~ s/^[ \t]*/$_[0]\t/gmr };
	my $where = join ':', grep { defined } @$mutant{qw(file line)};
	return "$where\n" .
	    $lines->('-', $mutant->{from}) . $lines->('+', $mutant->{to});
}

# Returns the mutants of a file of hunks. The number of a line may be absent. Lines that
# begin with # give the reason for the hunks below them, up to an empty line.
sub hunks {
	my ($text) = @_;
	my @found;
	for my $part (split /\n{2,}/, $text) {
		my $reason = join ' ', $part =~ /^# ?(.*)/mg;
		while ($part =~ /^([\w.\/]+)(?::(\d+))?\n((?:-.*\n?)+)((?:\+.*\n?)+)/mg) {
			my ($file, $line, $from, $to) = ($1, $2, $3, $4);
			push @found, {file => $file, line => $line,
			    from => $from =~ s/^-//mgr =~ s/\n?\z/\n/r,
			    to => $to =~ s/^\+//mgr =~ s/\n?\z/\n/r,
			    reason => $reason};
		}
	}
	return @found;
}

# Returns whether two mutants change the text of a file in the same way, except for
# blanks. A mutant may quote lines around its change, if the text has it at several
# places.
sub same_change {
	my ($text, @two) = @_;
	my ($a, $b) = map { trimmed(mutated($text, $_) // '') } @two;
	return $two[0]{file} eq $two[1]{file} && $a eq $b;
}

1;
