#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that the program prints the doubles nearest to recorded digits, which
# were computed without it, and the results of other projects' tests.
use strict;
use warnings;
use FindBin;
use JSON::PP;
use POSIX 'strtod';
use lib $FindBin::Bin;
use Projcalc;

chdir 'testdata' or die "testdata: $!\n";

# Returns a case of others.json as a document, and the arguments that print its
# matrix.
my %projection = (persp => 'persp', frustum => 'persp', ortho => 'ortho');
my %members = (fovy_deg => 'fovy', fovx_deg => 'fovx', l => 'left',
    r => 'right', b => 'bottom', t => 'top', near => 'near', far => 'far',
    width => 'width', height => 'height');

sub viewport {
	my ($aspect) = @_;
	# A quotient that is no double becomes the size of a viewport.
	my ($width, $height) = split m{/}, $aspect;
	return {width => 0 + $width, height => 0 + ($height // 1)};
}

sub document {
	my ($op, %in) = @_;
	my %convention = (
		handedness => $in{hand} && $in{hand} eq 'rh' ? 'right' : 'left',
		depth => $in{depth} && $in{depth} eq 'no' ?
		    'minus_one_to_one' : 'zero_to_one',
		vectors => 'column',
	);
	my %scene = (convention => \%convention);
	if ($op =~ /lookat/) {
		$scene{camera} = {map { $_ => $in{$_} } qw(eye at up)};
	} elsif ($op eq 'viewport') {
		$scene{viewport} = {x => $in{x}, y => $in{y}, width => $in{w},
		    height => $in{h}, min_z => $in{minz}, max_z => $in{maxz}};
	} else {
		my %p = map { $members{$_} => $in{$_} }
		    grep { $members{$_} } keys %in;
		$p{far} = 'infinity' if $p{far} eq 'inf';
		$scene{projection} = {%p, type => $projection{$op}};
		$scene{viewport} = viewport($in{aspect}) if $in{aspect};
	}
	return \%scene;
}

my %arguments = (
	lookat => 'lookat', persp => 'persp', frustum => 'persp',
	ortho => 'ortho',
	'lookat-inverse' => 'project -m --from view --to world',
	viewport => 'project -m --from ndc --to device',
);

sub others {
	my @cases;
	for my $case (@{decode_json(slurp('recorded/others.json'))->{cases}}) {
		my $scene = JSON::PP->new->canonical->encode(
		    document($case->{op}, %{$case->{input}}));
		push @cases, {
			name => "$case->{source}: $case->{id}",
			command => "projcalc $arguments{$case->{op}} '$scene'",
			true => $case->{true},
			expected => [map { @$_ } @{$case->{expected}}],
			tol => $case->{tol},
		};
	}
	return @cases;
}

sub sources {
	my @cases;
	for (grep { !/^#/ } split /\n/, slurp('recorded/sources.tsv')) {
		my ($source, $what, $command, $digits) = split /\t/;
		push @cases, {name => "$source: $what", command => $command,
		    true => [split ' ', $digits]};
	}
	return @cases;
}

# Compares the bits of two numbers. -0 counts as wrong, as the program never
# prints it.
sub same {
	my ($said, $true) = @_;
	my ($a, $left) = strtod($said);
	my ($b) = strtod($true);
	return $left == 0 && pack('d', $a) eq pack('d', $b);
}

# Compares numbers within the tolerance of the other project's test.
sub near {
	my ($case, $i, $said) = @_;
	return 1 if !$case->{expected};
	my $expected = $case->{expected}[$i];
	my $size = abs $expected > 1 ? abs $expected : 1;
	return abs($said - $expected) <= $case->{tol} * $size;
}

for my $case (others(), sources()) {
	my @true = @{$case->{true}};
	my ($status, $out, $err) = run($case->{command});
	my @said = grep { $_ ne '' } split /[\s,\[\]]+/, $out;
	my $ok = $status == 0 && @said == @true && !grep {
		!same($said[$_], $true[$_]) || !near($case, $_, $said[$_])
	} 0 .. $#true;
	ok($ok, $case->{name}) or
	    diag("$case->{command}\ntrue: @true\nsaid:\n$out$err");
}
done_testing();
