#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks bounds by machine. Compares each bound that the kernels claim with the error
# that is counted from the code that runs. Compares each bound of core/exact with the
# error of a model, and this with errors that its code has on the operands of values.c.
# Coq, if it is installed, checks the operations without error.
# usage: prove.pl [CORE]: for a copy of the folder core, only what is of core/exact
use strict;
use warnings;
use Cwd 'abs_path';
use FindBin;
use lib $FindBin::Bin;
use Math::BigFloat try => 'GMP';
use List::Util qw(max);
use Math::BigInt try => 'GMP';
use Proof;

my $core = abs_path($ARGV[0] // "$here/..");
my ($refused, $skipped) = (0, 0);

# Prints whether an error of 2^$found, which a model of the code has, is at most the
# claim 2^$claimed. Refuses also a claim of four times the error, and code with a
# measured error above the model's.
sub verdict {
	my ($claim, $claimed, $found, @measured) = @_;
	my $holds = $found <= $claimed && $claimed - $found < 2 &&
	    !grep { $_ > $found } @measured;
	$refused++ if !$holds;
	printf "%-36s %8.6g %8.6g %-6s 2^%-6.3g  %s\n", $claim, $claimed,
	    $found, '2^', $claimed - $found, $holds ? 'modelled' : 'REFUSED';
	printf "%-36s %8s %8.6g %-6s\n", '  measured in the code', '',
	    max(@measured), '2^' if @measured;
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

# Numbers of the measurement are integers times 10^-480.
my $one = Math::BigInt->new(10)->bpow(480);

# Returns n times 2^e.
sub fixed {
	my ($n, $e) = @_;
	my $power = Math::BigInt->new(2)->bpow(abs $e);
	return $e >= 0 ? $n * $power * $one : $n * $one / $power;
}

# Returns a number that C's %a has printed.
sub fixed_of_double {
	my ($whole, $part, $e) = $_[0] =~ /^0x(\d)\.?(\w*)p(.*)/ or die $_[0];
	return fixed(Math::BigInt->from_hex("$whole$part"),
	    $e - 4 * length $part);
}

sub product { ($_[0] * $_[1])->brsft(480, 10) }

# Returns the arc tangent of 1/n.
sub arc_tangent {
	my ($n) = @_;
	my $term = $one / $n;
	my $sum = Math::BigInt->new(0);
	for (my $k = 1; $term != 0; $k += 2) {
		$sum += $term / ($k % 4 == 1 ? $k : -$k);
		$term /= $n * $n;
	}
	return $sum;
}

# Returns the sine (first = 1) or cosine (first = 0) of x, by Taylor's series.
sub series {
	my ($x, $first) = @_;
	my $square = product($x, $x);
	my $term = $first ? $x->copy : $one->copy;
	my $sum = Math::BigInt->new(0);
	for (my $k = $first; $term != 0; $k += 2) {
		$sum += $term;
		$term = -product($term, $square) / (($k + 1) * ($k + 2));
	}
	return $sum;
}

# Returns what an operation of values.c should give.
sub truth {
	my ($what, $of, $by, $pi) = @_;
	my $a = fixed_of_double($of);
	my $b = fixed_of_double($by);
	return $a * $one / $b if $what eq 'quotient';
	return ($a * $one)->bsqrt if $what eq 'root';
	$a = product($a, $pi) / 180 if $b == 0; # in degrees
	my ($sine, $cosine) = map { series($a, $_) } 1, 0;
	return $what eq 'sine' ? $sine : $what eq 'cosine' ? $cosine :
	    $cosine * $one / $sine;
}

# Returns the binary logarithm of a large integer.
sub logarithm {
	my ($n) = @_;
	return log(substr "$n", 0, 15) / log(2) +
	    (length("$n") - length(substr "$n", 0, 15)) * log(10) / log(2);
}

# Runs the code of core/exact on the operands of values.c. Returns, for each operation,
# the binary logarithms of its relative errors.
sub measured {
	my $pi = 16 * arc_tangent(5) - 4 * arc_tangent(239);
	my ($well, $said) = outcome(compiled_c('values.c', $core));
	my %errors;
	for my $line (split /\n/, $said) {
		my ($what, $a, $b, $e, $words) = split ' ', $line;
		my $truth = abs truth($what, $a, $b, $pi);
		my $off = abs(fixed(Math::BigInt->from_hex($words), $e) - $truth);
		push @{$errors{$what}}, logarithm($off + 1) - logarithm($truth);
	}
	die "values.c: $said\n" if !$well || keys %errors != 5;
	return \%errors;
}

# Models TRIG_ERROR, with numbers of 350 digits.
sub trigonometry {
	my ($measured) = @_;
	my $text = slurp("$core/exact/trig.c");
	my %of = $text =~ /\b((?:SHORT|LONG|CHORD|REST)_\w+) = (\d+)/g;
	($of{LONG_WORDS}) =
	    slurp("$core/exact/ex.h") =~ /enum \{ EX_QUOTIENT_WORDS = (\d+) \}/;
	Math::BigFloat->accuracy(350);
	my $one = Math::BigFloat->new(1);
	my $two = Math::BigFloat->new(2);
	my $pi = Math::BigFloat->bpi(350);
	my $given = off($text, 'HALF_PI', $pi / 2);
	my (%left, %chord);
	for my $long ('SHORT', 'LONG') {
		my $y = ($long eq 'LONG' ? 4 * $pi * $pi : 4 * $one) /
		    $two**(2 * $of{"${long}_HALVINGS"});
		# the first term that is left out, of a series near 1
		$left{$long} = 2 * $y**($of{CHORD_POWER} / 2) /
		    Math::BigFloat->new($of{CHORD_POWER} + 2)->bfac;
		# what is cut off below the last word: of y twice, of s, of the
		# quotient and its product with y, and of each doubled chord
		$chord{$long} = $left{$long} + (6 + $of{"${long}_HALVINGS"}) *
		    $two**(-64 * ($of{"${long}_WORDS"} - 1));
	}
	# the cut of the angle; 1.5 of the error of g, halved by a root, and the cut of
	# this root
	my $cut = $given + $two**(-64 * ($of{REST_WORDS} - 1));
	my $all = $cut + 0.75 * $chord{SHORT} + $two**-319;
	my ($bound) = macro("$core/exact/trig.h", 'TRIG_ERROR') =~ /0x1p(-\d+)/;
	verdict('pi / 2', -963, log2($given));
	verdict('what a series leaves out', -328, log2($left{SHORT}));
	verdict('the same near 2 pi', -715, log2($left{LONG}));
	# a relative error of g up to 4, multiplied by 4 twice
	verdict('squares of chords near 2 pi', -692, log2(64 * $chord{LONG}));
	verdict('sine and cosine: 2^-315', -315, log2($all),
	    @{$measured->{sine}}, @{$measured->{cosine}});
	# g from the square of the angle; a cosine is 1 less the half of it
	verdict('1 - cosine: TRIG_ERROR', $bound, log2(2 * $cut + $chord{SHORT}));
	# a cotangent is the quotient of both
	verdict('cotangent: TRIG_ERROR', $bound,
	    log2(2 * $all + $two**-319), @{$measured->{cotangent}});
	Math::BigFloat->accuracy(undef);
}

# Models EX_ERROR. A quotient is cut off after EX_QUOTIENT_WORDS words, of which the
# first may be 1. A root is rounded there; each step doubles its digits.
sub quotients {
	my ($measured) = @_;
	my ($words) = slurp("$core/exact/ex.h") =~ /enum \{ EX_QUOTIENT_WORDS = (\d+) \}/;
	my ($bound) = macro("$core/exact/ex.h", 'EX_ERROR') =~ /0x1p(-\d+)/;
	verdict('quotients and roots: EX_ERROR', $bound,
	    -64 * ($words - 1), @{$measured->{quotient}}, @{$measured->{root}});
}

printf "%-36s %8s %8s %-6s %8s\n", qw(claim claimed found unit margin);
my ($well, $said) = (1, '');
if (!@ARGV) {
	transformations();
	($well, $said) = count_errors($core);
	print $said;
	$refused++ if !$well;
}
my $measured = measured();
quotients($measured);
trigonometry($measured);
if ($refused) {
	print "\nNot proved.\n";
	exit 1;
}
exit 0 if @ARGV;
my ($share) = sort { $b <=> $a } $said =~ /share of its error +1 +(\S+)/g;
print "\n", 'The rows of core/exact are bounds of a model; its code keeps them on chosen',
    "\noperands. What is proved is of the kernels, which are the fast phase.\n", 'Where the fast phase of exact is sure of a number, it is the ',
    'double nearest to the',
    "\nexact value: of the error that its test allows for at most ",
    sprintf('%.0f %%', 100 * $share), " can be there.\n",
    $skipped ? "Taken for granted: what Coq would have checked.\n" : '';
