# SPDX-License-Identifier: MIT
# What `make prove` and its test share: the claims in core's headers, which are macros
# or numbers in comments, and programs that are compiled with these headers.
package Proof;
use strict;
use warnings;
use Cwd 'abs_path';
use Exporter 'import';
use File::Basename;
use File::Temp 'tempdir';

our $here = abs_path(dirname(__FILE__));
our $tmp = tempdir(CLEANUP => 1);
our @EXPORT = qw($here $tmp slurp spew macro claimed claims compiled compiled_c outcome
    count_errors);

sub slurp {
	open my $file, '<', $_[0] or die "$_[0]: $!\n";
	local $/;
	return <$file> // '';
}

sub spew {
	my ($name, $text) = @_;
	open my $file, '>', $name or die "$name: $!\n";
	print $file $text;
	close $file or die "$name: $!\n";
}

sub macro {
	my ($file, $name) = @_;
	slurp($file) =~ /^#define $name (\S+)/m or
	    die "$file claims no $name\n";
	return $1;
}

# Returns the number of u^2 that the comment above a function claims.
sub claimed {
	my ($file, $function) = @_;
	slurp($file) =~ m{/\*((?:(?!/\*).)*?)\*/\nstatic inline \w+ $function\(}s
	    or die "$file has no comment on $function\n";
	return $1 =~ /(\d+(?:\.\d+)?) u\^2/ ? $1 :
	    die "$file claims nothing of $function\n";
}

# Returns the number in a file's comments that a pattern finds.
sub told {
	my ($file, $what, $pattern) = @_;
	my $text = slurp($file) =~ s/\n \* ?/ /gr;
	$text =~ $pattern or die "$file claims nothing of $what\n";
	return $1;
}

sub claims {
	my ($core) = @_;
	my ($exact, $doubled) = map { "$core/points/kernel/$_.h" }
	    qw(exact doubled);
	my %claim = (EX_ROUND_BOUND => macro("$core/exact/ex.h", 'EX_ROUND_BOUND'),
	    COLUMN_UNITS => told($exact, 'columns', qr/together (\d+(?:\.\d+)?) u/),
	    COLUMN_LOW => told($exact, 'low parts', qr{above (\d+(?:\.\d+)?) times 2\^-26 B}),
	    QUOTIENT_LOW => told($exact, 'quotients of low parts', qr/(\d+) u times the low parts/),
	    QUOTIENT_BOUND => claimed($exact, 'quotient'),
	    LENGTH_BOUND => claimed($exact, 'length_of'),
	    DOUBLED_UNITS => told($doubled, 'columns', qr/together at most (\d+(?:\.\d+)?) u\^2/),
	    DOUBLED_LOW => told($doubled, 'low parts', qr/lo, at most (\d+) u S/),
	    LENGTH_LOW => told($exact, 'lengths', qr/length, which is at most (\d+) u/));
	return map { "-D$_=$claim{$_}" } sort keys %claim;
}

my $programs = 0;

# Returns a program compiled from a source and the headers in $core, or undef if the
# compiler fails.
sub compiled {
	my ($source, $core, @flags) = @_;
	my $program = "$tmp/program" . ++$programs;
	my @command = (($ENV{CXX} // 'g++'), qw(-O1 -w -std=gnu++17
	    -ffp-contract=off), claims($core), @flags, "-I$core", "-I$tmp",
	    '-o', $program, "$here/$source");
	return system(@command) == 0 ? $program : undef;
}

# Returns a C program compiled from a source and the numbers of core/exact in $core.
sub compiled_c {
	my ($source, $core) = @_;
	my $program = "$tmp/program" . ++$programs;
	my @command = (($ENV{CC} // 'gcc'), qw(-O1 -w -std=c11 -ffp-contract=off),
	    "-I$core", '-o', $program, "$here/$source",
	    (map { "$core/exact/$_.c" } qw(ex sum trig)), '-lm');
	return system(@command) == 0 ? $program : undef;
}

# Runs a program. Returns whether it succeeds, and its output.
sub outcome {
	my ($program) = @_;
	return (0, "it could not be compiled\n") if !defined $program;
	my $said = `$program 2>&1`;
	return ($? == 0, $said);
}

# Returns a text about claims of at least twice the error that is found in any row. A
# bound that is too large by mistake would not fail in any other way.
sub loose {
	my ($said) = @_;
	my (%most, $text);
	while ($said =~ /^(\S.{35}) +(\S+) +(\S+) +(?!2\^ ).* proved$/mg) {
		my ($row, $claimed, $found) = ($1, $2, $3);
		my ($claim) = $row =~ /(\w+_BOUND|(?:doubled: )?share of its error)/ ? $1 :
		    $row =~ s/ +\z//r;
		my $share = $found / $claimed;
		$most{$claim} = $share if $share > ($most{$claim} // 0);
	}
	return join '', map { sprintf "%-36s %.2g of it is found: REFUSED\n",
	    $_, $most{$_} } grep { $most{$_} <= 0.5 } sort keys %most;
}

# Runs count.cc with rounded and with fused products; to optimize it would take longer
# than it runs. Returns whether it proves the claims, and its output.
sub count_errors {
	my ($core) = @_;
	my ($well, $said) = (1, '');
	for my $way ('', '-DFUSED_MADD') {
		my ($ok, $text) = outcome(compiled('count.cc', $core, '-O0',
		    $way || ()));
		$said .= ($way ? "products fused:\n" : "products rounded:\n") .
		    $text;
		$well &&= $ok;
		last if !$ok;
	}
	my $loose = $well ? loose($said) : '';
	return ($well && $loose eq '', $said . $loose);
}

1;
