#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Proves that the digits of cmd/number/vector are right: computes its table and
# constants anew in exact arithmetic, adds up the errors of its operations for each
# binary exponent, and compares the sums with the bounds in its comments. Then checks
# that changed constants are refused.
# usage: digits_test.t, at the top of the project
use strict;
use warnings;
use FindBin;
use Math::BigInt;
use Math::BigRat;
use POSIX qw(floor frexp);
use Test::More;

my $vector = "$FindBin::Bin/../number/vector";

sub slurp {
	open my $file, '<', $_[0] or die "$_[0]: $!\n";
	local $/;
	return <$file>;
}

sub rat { Math::BigRat->new(@_) }

# Returns b^e exactly.
my %powers;

sub power {
	my ($b, $e) = @_;
	return $powers{"$b $e"} //= do {
		my $n = rat(Math::BigInt->new($b)->bpow(abs $e));
		$e < 0 ? 1 / $n : $n;
	};
}

sub two_to { power(2, @_) }

sub ten_to { power(10, @_) }

# Returns the exact value of a double, and the place of its last bit.
sub exactly {
	my $bits = unpack 'Q', pack 'd', $_[0];
	my $e = $bits >> 52 & 0x7ff;
	die "$_[0] is no normal double" if $_[0] != 0 && ($e == 0 || $e == 0x7ff);
	return (rat(0), 0) if $_[0] == 0;
	my $m = $bits & (1 << 52) - 1 | 1 << 52;
	my $v = rat(Math::BigInt->new("$m")) * two_to($e - 1075);
	return ($bits >> 63 ? -$v : $v, $e - 1075);
}

# Returns half a unit in the last place of doubles that are at most this large.
sub half_unit {
	my ($most) = @_;
	my ($m, $e) = frexp($most);
	return 2 ** ($e - 54);
}

# Returns the value of a constant of C, which is decimal or like 0x1p-44.
sub constant {
	my ($text) = @_;
	return $text =~ /^0x1p([-+]?\d+)$/ ? 2 ** $1 : $text + 0;
}

# Returns the constants of the headers.
sub claims {
	my ($text) = @_;
	my %says = (
		least => qr/POWER_MIN = (-?\d+)/, most => qr/POWER_MAX = (-?\d+)/,
		power_error => qr/define POWER_ERROR (\S+)/,
		margin => qr/define WRITE_MARGIN (\S+)/,
		low => qr/1e21\)\) &\s+~LESS\(a, ALL\((\w+-\d+)\)\)/,
		high_float => qr/LESS\(a, ALL\(single \? (\w+) :/,
		high => qr/LESS\(a, ALL\(single \? \w+ : (\w+)\)/,
		exact_float => qr/exact = LESS\(a, ALL\(single \? (\w+) :/,
		exact => qr/exact = LESS\(a, ALL\(single \? \w+ : (\w+)\)/,
		exact_low => qr/exact = LESS\(a.*?~LESS\(a, ALL\((\w+-\d+)\)\)/s,
		log => qr/FLOOR\(q \* ALL\(([\d.]+)\)\)/,
		exact_from => qr{exact = LESS\(ALL\(([-\d.]+)\), scale\)},
		half_float => qr/top \* ALL\(single \? (\S+) :/,
		half => qr/top \* ALL\(single \? \S+ : (\S+)\)/,
		place_float => qr/log2_of_power\(top, single \? (\d+) :/,
		place => qr/log2_of_power\(top, single \? \d+ : (\d+)\)/,
		fours => qr/MUL32\(x, (\d+)\) >> 40/,
		twos => qr/HIGH16\(x, (\d+)\) >> 3/,
		ones => qr/HIGH16\(x, (\d+)\) >> 8/,
		least_unit => qr/q \+ scale >= (-\d+)/,
		eight => qr/FLOOR\(whole \* ALL\((\S+)\)\)/,
	);
	for (values %says) {
		$text =~ $_ or die "nothing like $_ in $vector\n";
		$_ = constant($1);
	}
	my ($table) = $text =~ /powers\[POWERS\]\[2\] = \{(.*?)\};/s;
	$says{powers} = [map { [split /, /] } $table =~ /\{ (.*?) \}/g];
	return \%says;
}

my @refused;

sub check {
	my ($name, $well) = @_;
	push @refused, $name unless $well;
}

# Returns hi + lo of each power, and the relative error of the sum.
sub check_table {
	my ($c) = @_;
	my $k = $c->{least};
	check('the table has every power',
	    @{$c->{powers}} == $c->{most} - $c->{least} + 1);
	for my $pair (@{$c->{powers}}) {
		my ($hi, $lo) = @$pair;
		my $power = ten_to($k);
		my ($high, $place) = exactly($hi);
		my ($low) = exactly($lo);
		my $rest = $power - $high;
		check("10^$k: hi is the nearest double",
		    abs($rest) <= two_to($place - 1));
		check("10^$k is hi", $k < 0 || $lo == 0 && $rest == 0);
		check("10^$k: POWER_ERROR", abs($rest - $low) <=
		    rat((exactly($c->{power_error}))[0]) * $power);
		$k++;
	}
}

# Checks that 2^q, the last place of a double, is less than 10^-scale, by a factor of at
# most ten.
sub check_scale {
	my ($c, $q, $scale) = @_;
	check("scale for 2^$q", two_to($q) < ten_to(-$scale) &&
	    two_to($q) >= ten_to(-$scale - 1));
	check("2^$q stays in the table",
	    $scale >= $c->{least} && $scale <= $c->{most});
}

# Checks the exponents for which nothing is rounded: x is a multiple of 2^unit, and the
# ends of the interval that reads back as x are multiples of 2^unit / 4; 10 x is a
# multiple of twice 2^unit, and 10 is below 2^4.
sub check_exact {
	my ($q, $scale) = @_;
	my $unit = $q + $scale;
	check("2^$q: no whole number at an end", $unit < 0);
	check("2^$q: the power is a double", power(5, $scale) < two_to(53));
	check("2^$q: differences are exact", 0 - ($unit - 2) <= 53);
	check("2^$q: tenths are exact", 4 - ($unit + 1) <= 53);
	return $unit;
}

# Returns the sum of errors: the least distance at which two sides compare with
# certainty. The sum of a few terms is computed in doubles, which is accurate enough.
sub needed {
	my ($c, $q, $scale, $digits) = @_;
	my $pair = $c->{powers}[$scale - $c->{least}] or return 1;
	my ($hi, $lo) = @$pair;
	my $most = 2 ** ($digits + $q);
	my $e = half_unit($most * $hi) + $most * abs($lo);
	my $of_power = $scale < 0 ? $c->{power_error} * $most * $hi : 0;
	my $of_e = $scale < 0 ? half_unit($e) : 0;
	my $rest = $of_power + $of_e + half_unit(1 + $e) + half_unit(1);
	my $up = 0.5 * 2 ** -53;
	my $ends = $rest + half_unit(1) + $up + half_unit(1);
	my $tenths = 10 * $rest + half_unit(10);
	return (1 + 2 ** -40) * ($tenths > $ends ? $tenths : $ends);
}

sub check_search {
	my ($c, $single) = @_;
	my $digits = $single ? 24 : 53;
	my ($place, $half, $high, $exact) =
	    map { $c->{$single ? "${_}_float" : $_} } qw(place half high exact);
	my $q = floor(log($c->{low}) / log(2)) - $place;
	my $top = floor(log($high) / log(2)) - $place;
	$top-- if 2 ** ($top + $place) >= $high;
	my $worst = 0;
	check('the least exact number', $c->{exact_low} >= $c->{low});
	check('the last place', $place == $digits - 1 &&
	    $half == 2 ** -$digits);
	for (; $q <= $top; $q++) {
		my $scale = -1 - floor($q * $c->{log});
		check_scale($c, $q, $scale);
		check("2^$q is not exact", $c->{exact_from} < $scale)
		    if 2 ** ($q + $place) < $exact;
		if ($c->{exact_from} < $scale) {
			my $unit = check_exact($q, $scale);
			$c->{unit} = $unit if $unit < ($c->{unit} // 0);
			next;
		}
		my $margin = needed($c, $q, $scale, $digits);
		$worst = $margin if $margin > $worst;
	}
	check('write_shortest.h has the least unit', $c->{unit} == $c->{least_unit});
	check('WRITE_MARGIN', $c->{margin} >= $worst);
	return $worst;
}

# Checks a division by multiplication. The quotient never decreases, so the ends of each
# range with one quotient suffice.
sub check_quotient {
	my ($name, $most, $by, $factor, $shift) = @_;
	my $well = 1;
	for (my $x = $by; $x <= $most; $x += $by) {
		$well &&= $x * $factor >> $shift == $x / $by &&
		    ($x - 1) * $factor >> $shift == $x / $by - 1;
	}
	check($name, $well);
}

# Checks the division of integers below 10^16 by 10^8. An integer that ends in 99999999
# comes nearest to a quotient that is too large: its exact quotient is below the next
# integer by 10^-8, and the double 1e-8 is a little too large.
sub check_eight {
	my ($c) = @_;
	my ($factor) = exactly($c->{eight});
	my $over = ten_to(16) * ($factor - ten_to(-8));
	check('1e-8 is not too small', $factor >= ten_to(-8));
	check('1e-8 is not too large',
	    ten_to(-8) - $over > half_unit(1e8 + 1));
}

# Checks the reader, whose integer is a double and what three roundings have lost. A correction c has two roundings, and each end has one; a
# number must be farther from an end than their sum.
sub check_reader {
	my ($text) = @_;
	my ($most) = $text =~ /low > (\d+)\)/;
	my ($place) = $text =~ /first \* ALL\(1e(\d+)\);/;
	my ($off) = $text =~ /off = c \* ALL\(0x1p-(\d+)\);/;
	check('the integer is below 2^74', $place == 16 &&
	    ($most + 1) * ten_to($place) < two_to(74));
	check('the ends are farther than the error',
	    2 ** -$off >= (2 + 1.02) * 2 ** -53);
}

# Checks everything; returns the largest error.
sub prove {
	my ($text) = @_;
	my $c = claims($text);
	@refused = ();
	check_table($c);
	my @worst = map { check_search($c, $_) } 0, 1;
	check_quotient('four digits', 10 ** 8, 10 ** 4, $c->{fours}, 40);
	check_quotient('two digits', 10 ** 4, 100, $c->{twos}, 19);
	check_quotient('one digit', 100, 10, $c->{ones}, 16);
	check_eight($c);
	check_reader($text);
	return $worst[0] > $worst[1] ? $worst[0] : $worst[1];
}

my $headers = join '', map { slurp("$vector/$_") }
    qw(powers.h write_find.h write_shortest.h write_body.h
    read_body.h);
my $worst = prove($headers);
is_deeply(\@refused, [], 'the table, the constants and the margin');
my $units = $worst * 2 ** 53;
note(sprintf 'the largest error is %.2f 2^-53', $units);
cmp_ok($units, '<=', 58, 'no more than write_shortest.h counts');

for my $m (
	['WRITE_MARGIN 0x1p-44', 'WRITE_MARGIN 0x1p-48', 'WRITE_MARGIN'],
	['-2.0816681711721684e-19', '-2.0816681711721e-19', '10^-2: POWER_ERROR'],
	['{ 1e5, 0 }', '{ 100001, 0 }', '10^5 is hi'],
	['0.30102999566398120', '0.30', 'scale for 2^'],
	['exact = LESS(ALL(-0.5)', 'exact = LESS(ALL(-1.5)',
	    'no whole number at an end'],
	["0x1p-17));\n\tV top", "0x1p-18));\n\tV top",
	    '2^-70 stays in the table'],
	['0x1p60', '0x1p61', '2^37 stays in the table'],
	['0x1p23 : 0x1p52', '0x1p23 : 0x1p53', '2^0 is not exact'],
	['0x1p23 : 0x1p52', '0x1p24 : 0x1p52', '2^0 is not exact'],
	["0x1p-17));\n\n\tif", "0x1p-18));\n\n\tif", 'the least exact number'],
	['109951163', '109951162', 'four digits'],
	['5243', '5242', 'two digits'],
	['6554', '6553', 'one digit'],
	['low > 999999', 'low > 9999999', 'below 2^74'],
	['c * ALL(0x1p-50', 'c * ALL(0x1p-52', 'farther than the error'],
	['ALL(1e-8)', 'ALL(9.999999999999999e-9)', '1e-8 is not too'],
) {
	my ($from, $to, $refused) = @$m;
	my $text = $headers;
	ok($text =~ s/\Q$from\E/$to/, 'what is changed: ' . $from =~ s/\s+/ /gr);
	prove($text);
	ok((grep { /\Q$refused\E/ } @refused), $to =~ s/\s+/ /gr . ' is refused')
	    or diag(join "\n", @refused);
}
done_testing();
