#!/usr/bin/perl
# Recorded truth: what the program prints is the double nearest to digits that
# were worked out without it, and come from elsewhere.
use strict;
use warnings;
use Cwd 'abs_path';
use File::Basename;
use JSON::PP;
use POSIX 'strtod';

my $top = abs_path(dirname($0) . '/../..');
$ENV{PATH} = abs_path($ENV{BUILD} // "$top/build") . ":$ENV{PATH}";
chdir "$top/testdata" or die "$top/testdata: $!\n";

sub slurp {
	open my $file, '<', $_[0] or die "$_[0]: $!\n";
	local $/;
	return <$file>;
}

# A case of others.json as a document and the arguments that print its matrix.
my %projection = (persp => 'persp', frustum => 'persp', ortho => 'ortho');
my %members = (fovy_deg => 'fovy', fovx_deg => 'fovx', l => 'left',
    r => 'right', b => 'bottom', t => 'top', near => 'near', far => 'far',
    width => 'width', height => 'height');

sub viewport {
	my ($aspect) = @_;
	# A quotient that has no double is given as the viewport's.
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

# By the bits; -0 is never printed and differs.
sub same {
	my ($said, $true) = @_;
	my ($a, $left) = strtod($said);
	my ($b) = strtod($true);
	return $left == 0 && pack('d', $a) eq pack('d', $b);
}

# Within what the other project's test allows.
sub near {
	my ($case, $i, $said) = @_;
	return 1 if !$case->{expected};
	my $expected = $case->{expected}[$i];
	my $size = abs $expected > 1 ? abs $expected : 1;
	return abs($said - $expected) <= $case->{tol} * $size;
}

my @cases = (others(), sources());
my $failed = 0;
printf "1..%d\n", scalar @cases;
for my $i (0 .. $#cases) {
	my $case = $cases[$i];
	my @true = @{$case->{true}};
	my $text = `$case->{command} 2>&1`;
	my @said = grep { $_ ne '' } split /[\s,\[\]]+/, $text;
	my $ok = $? == 0 && @said == @true && !grep {
		!same($said[$_], $true[$_]) || !near($case, $_, $said[$_])
	} 0 .. $#true;
	printf "%s %d - %s\n", $ok ? 'ok' : 'not ok', $i + 1, $case->{name};
	next if $ok;
	$failed++;
	print "# $case->{command}\n# true: @true\n", $text =~ s/^/# /mgr;
}
exit($failed > 0);
