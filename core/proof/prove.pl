#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Proves bounds by machine: compares each bound that core claims with the error that is
# counted from core's headers and constants. Coq, if it is installed, checks the
# operations without error.
# usage: prove.pl
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Math::BigFloat;
use Math::BigInt;
use Proof;

my $core = "$here/..";
my ($refused, $skipped) = (0, 0);

# Prints whether an error of 2^$found is at most the claim 2^$claimed. A claim of four
# times the error is refused, too.
sub verdict {
	my ($claim, $claimed, $found) = @_;
	my $proved = $found <= $claimed && $claimed - $found < 2;
	$refused++ if !$proved;
	printf "%-36s %8.6g %8.6g %-6s 2^%-6.3g  %s\n", $claim, $claimed,
	    $found, '2^', $claimed - $found, $proved ? 'proved' : 'REFUSED';
}

# Runs Coq on the theorems about two_sum, fast_two_sum and two_prod.
sub transformations {
	spew("$tmp/exact.v", slurp("$here/exact.v"));
	my $said = `cd $tmp && coqc exact.v 2>&1`;
	my $missing = $? == -1 || $? >> 8 == 127 ||
	    $said =~ /Cannot find.*Flocq/s;
	$skipped++ if $missing;
	$refused++ if $? != 0 && !$missing;
	print "two_sum, fast_two_sum, two_prod are exact: ",
	    $missing ? "SKIPPED, as there is no Coq with Flocq\n" :
	    $? == 0 ? "proved by Coq\n" : "REFUSED\n$said";
}

sub log2 { $_[0]->copy->blog(2, 12)->numify }

# Returns a constant of trig.c, from its words, and half a unit of the last word.
sub constant {
	my ($text, $name) = @_;
	my ($e, $words) = $text =~
	    /struct sum $name = \{\s*.value = \{ 1, \d+, (-?\d+),\s*\{([^}]*)\}/ or die $name;
	my $two = Math::BigFloat->new(2);
	my $sum = Math::BigFloat->new(0);
	my $half = $two**(64 * $e - 1);
	for my $word ($words =~ /(\w+)/g) {
		my $n = $word =~ /^0x/ ? Math::BigInt->from_hex($word) :
		    Math::BigInt->new($word);
		$sum += Math::BigFloat->new($n) * $two**(64 * $e++);
	}
	return ($sum, $half);
}

# Returns the error of a constant, which must be at most half a unit of its last word.
sub off {
	my ($text, $name, $true) = @_;
	my ($is, $half) = constant($text, $name);
	my $off = abs($is - $true);
	$refused++, print "$name is not the nearest: REFUSED\n"
	    if $off > $half;
	return $off / $true;
}

# Proves TRIG_ERROR, with numbers of 350 digits.
sub trigonometry {
	my $text = slurp("$core/exact/trig.c");
	my ($top) = $text =~ /enum \{ SINE_POWER = (\d+) \}/;
	my ($words) = $text =~ /enum \{ SINE_WORDS = (\d+) \}/;
	Math::BigFloat->accuracy(350);
	my $one = Math::BigFloat->new(1);
	my $two = Math::BigFloat->new(2);
	my $pi = Math::BigFloat->bpi(350);
	my $given = off($text, 'HALF_PI', $pi / 2);
	my $x = $pi / 4;
	# the first term that is left out, of a cosine of at least 0.7
	my $rest = $x**($top + 2) / Math::BigFloat->new($top + 2)->bfac / 0.7;
	# what is cut off below the last word: of x, of x^2, and of each term
	my $cut = $two**(-64 * ($words - 1));
	my $all = $given + 2 * $cut + $rest + $cut * ($top / 2 + 1) / 0.7 +
	    $two**-319;
	my ($bound) = macro("$core/exact/trig.h", 'TRIG_ERROR') =~ /0x1p(-\d+)/;
	verdict('pi / 2', -963, log2($given));
	verdict('what a series leaves out', -317, log2($rest));
	# a cotangent is the quotient of two series
	verdict('cotangent: TRIG_ERROR', $bound,
	    log2(2 * $all + $two**-319));
	Math::BigFloat->accuracy(undef);
}

# Proves EX_ERROR. A quotient is cut off after EX_QUOTIENT_WORDS words, of which the
# first may be 1. A root is rounded there; each step doubles its digits.
sub quotients {
	my ($words) = slurp("$core/exact/ex.h") =~ /enum \{ EX_QUOTIENT_WORDS = (\d+) \}/;
	my ($bound) = macro("$core/exact/ex.h", 'EX_ERROR') =~ /0x1p(-\d+)/;
	verdict('quotients and roots: EX_ERROR', $bound,
	    -64 * ($words - 1));
}

printf "%-36s %8s %8s %-6s %8s\n", qw(claim claimed found unit margin);
transformations();
my ($well, $said) = count_errors($core);
print $said;
$refused++ if !$well;
quotients();
trigonometry();
if ($refused) {
	print "\nNot proved.\n";
	exit 1;
}
my ($share) = sort { $b <=> $a } $said =~ /share of its error +1 +(\S+)/g;
print "\n", 'Where the fast phase of exact is sure of a number, it is the ',
    'double nearest to the',
    "\nexact value: of the error that its test allows for at most ",
    sprintf('%.0f %%', 100 * $share), " can be there.\n",
    $skipped ? "Taken for granted: what Coq would have checked.\n" : '';
