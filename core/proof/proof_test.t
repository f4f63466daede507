#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Runs the proofs that need only a C++ compiler: the headers in the arithmetic of toy.h,
# of which nearly all operands are tried, and the count of their errors. Then checks
# that both refuse headers with a fault; in toy arithmetic every fourth fault, as each is
# compiled, or all for `make prove`.
# usage: proof_test.t [all]
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use File::Path qw(make_path remove_tree);
use Test::More;
use Proof;

my $core = "$here/..";

if (system("command -v @{[$ENV{CXX} // 'g++']} >/dev/null") != 0) {
	plan skip_all => 'no C++ compiler';
}

sub holds {
	my ($name, $well, $said) = @_;
	ok($well, $name) or diag($said);
	note($said) if $well;
}

for my $case ([6], [16], [53], [7, '-DFUSED'], [24, '-DFUSED'], [53, '-DFUSED']) {
	my ($digits, @way) = @$case;
	holds("the exact kernel in $digits digits @way",
	    outcome(compiled('toy_exact.cc', $core, "-DP=$digits", @way)));
}

# The faults: the file, what is changed there, and what finds it. That is a program in
# toy arithmetic, with its number of digits, or a claim that the count exceeds.
my $exact = 'points/kernel/exact.h';
my $doubled = 'points/kernel/doubled.h';
my @toy = ('toy_exact.cc', '-DP=53');
my @ties = ('toy_exact.cc', '-DP=6');
my @mutations = (
	[$exact, 'a term that is forgotten',
	    'lo = MADD(cut[k], ALL(c->rest[k]), lo)', 'lo = lo',
	    @toy],
	[$exact, 'an element\'s low part that is forgotten',
	    'c->rest[i] += m->lo[i][j]', 'c->rest[i] += 0', @toy],
	[$exact, 'an origin whose rest is forgotten',
	    'c->rest[3] = old - shift', 'c->rest[3] = old', @toy],
	[$exact, 'columns that underflow',
	    '(largest > 1 / MODERATE && largest', '(largest', @toy],
	[$exact, 'elements that underflow to 0',
	    'TINY 0x1p-1022', 'TINY 0', @toy],
	[$exact, 'the low part of w left out of a quotient',
	    'MADD(q, -w.lo, n.lo)', 'n.lo', @toy],
	[$exact, 'a wrong sign in a quotient',
	    'FMA(q, -w.hi, n.hi)', 'FMA(q, w.hi, n.hi)', @toy],
	[$exact, 'a w that may be 0',
	    'MIN(w_sum - bound, sure)', 'MIN(w_sum, sure)', @toy],
	[$exact, 'columns held for exact whose elements are not',
	    '&& !m->hi_is_exact[i][j]', '&& false', @toy],
	[$exact, 'columns held for exact whose sums are not',
	    ' + ABS(s.lo)', '', @ties],
	[$exact, 'columns held for exact whose products are not',
	    'ABS(FMA(a, ALL(b), -p))', 'ALL(0)', @ties],
	[$exact, 'points without an image that are not told',
	    'if (ALL_POSITIVE(sure))
		return', 'if (!ALL_POSITIVE(-r))
		return', @toy],
	[$exact, 'a bound that leaves w out',
	    'MADD(ABS(q), w_bound, bound);', 'bound;', @toy],
	[$exact, 'a length whose squares are rounded',
	    'low = low + FMA(a[k].hi, a[k].hi, -square[k])', 'low = low', @toy],
	[$doubled, 'an element\'s low part that is forgotten',
	    'lo = MADD(a, ALL(m->lo[k][j]), lo)', 'lo = lo', @toy],
	[$doubled, 'a difference\'s low part that is forgotten',
	    'lo = MADD(p->d[k].lo, element, lo)', 'lo = lo', @toy],
	[$doubled, 'a w that may be 0',
	    'MIN(w_sum - w_bound, sure)', 'MIN(w_sum, sure)', @toy],
	[$doubled, 'elements that underflow',
	    'fmax(fabs(m->hi[i][j]), 1 / MODERATE)', 'fabs(m->hi[i][j])', @toy],
	[$doubled, 'differences that underflow',
	    'MAX(size, ALL(1 / MODERATE))', 'size', @toy],
);
# Groups of faults. Those of a group are made in one copy of the headers, and the count
# finds each.
my @counted = (
	[$exact, 'an origin that is subtracted too near',
	    'POINT_CUT - 3', '1', 'column, of 2^-79 B'],
	['points/kernel/approx.h', 'one rounding more',
	    'R_FMA((REAL)m->b, r, (REAL)m->a)', '(REAL)m->b * r + (REAL)m->a',
	    'approx depth, of b/w: APPROX_BOUND'],
	[$exact, 'a length without its low part', '(rest * ALL(0.5))',
	    '(rest * ALL(0))', 'length'],
);
my @bounds = (
	[$exact, 'an origin that is cut too far off',
	    'POINT_CUT - 3', 'POINT_CUT + 3', 'column, of 2^-79 B'],
	[$exact, 'a bound of an eighth', 'COLUMN_BOUND 0x1p-72',
	    'COLUMN_BOUND 0x1p-75', 'quotient: share of its error'],
	[$doubled, 'a bound of a half', 'DOUBLED_BOUND 0x1p-98',
	    'DOUBLED_BOUND 0x1p-99', 'doubled: share of its error'],
	['points/kernel/kernel.h', 'a bound of approximations that is too small',
	    'APPROX_BOUND 10', 'APPROX_BOUND 8',
	    'approx depth, of b/w: APPROX_BOUND'],
	['points/kernel/kernel.h', 'a bound of estimates that is too small',
	    'ESTIMATE_BOUND 0x1p-50', 'ESTIMATE_BOUND 0x1p-51',
	    'estimate: ESTIMATE_BOUND'],
);

my @loose = (
	[$exact, 'a bound of columns that is too large', 'COLUMN_BOUND 0x1p-72',
	    'COLUMN_BOUND 0x1p-71', 'share of its error'],
	[$doubled, 'a bound of doubled columns that is too large',
	    'DOUBLED_BOUND 0x1p-98', 'DOUBLED_BOUND 0x1p-97',
	    'doubled: share of its error'],
	['points/kernel/kernel.h', 'a bound of approximations that is too large', 'APPROX_BOUND 10',
	    'APPROX_BOUND 20', 'APPROX_BOUND'],
	['points/kernel/kernel.h', 'a bound of estimates that is too large',
	    'ESTIMATE_BOUND 0x1p-50', 'ESTIMATE_BOUND 0x1p-49',
	    'ESTIMATE_BOUND'],
);

# Makes a copy of core's headers with these changes.
sub mutant {
	my $copy = "$tmp/mutant";
	remove_tree($copy);
	make_path("$copy/exact", "$copy/points/kernel");
	for my $header (qw(exact/dd.h exact/ex.h exact/ex.c exact/wide.h exact/sum.h
	    exact/sum.c exact/trig.h exact/trig.c points/kernel/exact.h
	    points/kernel/doubled.h points/kernel/approx.h points/kernel/kernel.h)) {
		spew("$copy/$header", slurp("$core/$header"));
	}
	for my $m (@_) {
		my ($file, $name, $from, $to) = @$m;
		my $text = slurp("$copy/$file");
		my $at = index $text, $from;
		ok($at >= 0, "$file has what is to be changed: $name") or next;
		substr $text, $at, length $from, $to;
		spew("$copy/$file", $text);
	}
	return $copy;
}

for my $i (0 .. $#mutations) {
	my (undef, $name, undef, undef, $source, @flags) = @{$mutations[$i]};
	my $copy = mutant($mutations[$i]);
	next if $i % 4 != 0 && !@ARGV;
	my ($well, $said) = outcome(compiled($source, $copy, @flags));
	ok(!$well && $said =~ /^not ok/m, "$name is refused") or diag($said);
}
for my $group (\@counted, \@bounds, \@loose) {
	my (undef, $said) = count_errors(mutant(@$group));
	for my $m (@$group) {
		my (undef, $name, undef, undef, $claim) = @$m;
		like($said, qr/^\Q$claim\E .*REFUSED$/m, "$name is refused");
	}
}

my @modelled = (
	['exact/ex.c', 'a root that is a word too short', 'int shift = 128 * count',
	    'int shift = 128 * --count', 'quotients and roots: EX_ERROR'],
	['exact/ex.c', 'a quotient that is a word too short', 'int n = b->n + count;',
	    'int n = b->n + --count;', 'quotients and roots: EX_ERROR'],
	['exact/trig.c', 'a chord that is doubled once too often', 'i < halvings',
	    'i <= halvings', 'sine and cosine: 2^-315'],
	['exact/trig.c', 'a series that is two terms too short', 'int k = CHORD_POWER',
	    'int k = CHORD_POWER - 4', 'sine and cosine: 2^-315'],
);
for my $m (@modelled) {
	my (undef, $name, undef, undef, $claim) = @$m;
	my $said = `perl $here/prove.pl @{[mutant($m)]} 2>&1`;
	like($said, qr/^\Q$claim\E .*REFUSED$/m, "$name is refused");
}

# Runs all of `make prove`, as far as its tools are installed. It counts the errors.
my $said = `perl $here/prove.pl 2>&1`;
holds('make prove', $? == 0, $said);
is(() = $said =~ /^doubled: share of its error .*proved$/mg, 2, 'errors counted, both ways');

# dd.h refuses flags by which the compiler may reorder its operations.
for my $flag (qw(-ffast-math -Ofast)) {
	my $said = `echo '#include "$core/exact/dd.h"' | gcc $flag -x c -c -o /dev/null - 2>&1`;
	like($said, qr/#error compile without -ffast-math/, "$flag is refused");
}

done_testing();
