# What `make prove` and its test share: the claims that stand in core's headers
# as macros or, of a function, in the comment above it, and programs that compile
# those headers.
package Proof;
use strict;
use warnings;
use Cwd 'abs_path';
use Exporter 'import';
use File::Basename;
use File::Temp 'tempdir';

our $here = abs_path(dirname(__FILE__));
our $tmp = tempdir(CLEANUP => 1);
our @EXPORT = qw($here $tmp slurp spew macro claimed claims compiled outcome
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

# Of "... 9 u^2 ..." above a function.
sub claimed {
	my ($file, $function) = @_;
	slurp($file) =~ m{/\*((?:(?!/\*).)*?)\*/\nstatic inline \w+ $function\(}s
	    or die "$file has no comment on $function\n";
	return $1 =~ /(\d+(?:\.\d+)?) u\^2/ ? $1 :
	    die "$file claims nothing of $function\n";
}

sub claims {
	my ($core) = @_;
	my %claim = (EX_BOUND => macro("$core/exact.h", 'EX_BOUND'),
	    RAY_BOUND => macro("$core/ray.c", 'RAY_BOUND'),
	    QUOTIENT_BOUND => claimed("$core/kernel/exact.h", 'quotient'));
	my $ray = slurp("$core/ray.c") =~ s/\n \*//gr;
	@claim{qw(RAY_SUMS RAY_DIRECTION RAY_LENGTH)} = $ray =~
	    /N and D by ([\d.]+), the direction by ([\d.]+)\..* by ([\d.]+) of its own\. All/
	    or die "ray.c claims nothing of its sums\n";
	$claim{uc $_} = claimed("$core/dd.h", $_) for qw(dd_add dd_mul dd_div);
	return map { "-D$_=$claim{$_}" } sort keys %claim;
}

my $programs = 0;

# A program from one source and the headers in core; undef where they don't go
# together.
sub compiled {
	my ($source, $core, @flags) = @_;
	my $program = "$tmp/program" . ++$programs;
	my @command = (($ENV{CXX} // 'g++'), qw(-O1 -w -std=gnu++17
	    -ffp-contract=off), claims($core), @flags, "-I$core", "-I$tmp",
	    '-o', $program, "$here/$source");
	return system(@command) == 0 ? $program : undef;
}

# Whether it ran well, and what it said.
sub outcome {
	my ($program) = @_;
	return (0, "it could not be compiled\n") if !defined $program;
	my $said = `$program 2>&1`;
	return ($? == 0, $said);
}

# What ray.c does in double-double: its sums, its quotients, and a ray of both.
sub cut_ray {
	my ($core) = @_;
	my @part = slurp("$core/ray.c") =~
	    m{(struct\ dd_sum\ \{.*?)(static\ struct\ dd_sum\ length_of.*?)
	    (static\ bool\ ray_quick.*?)static\ double\ over}sx
	    or die "ray.c has other functions than these\n";
	spew("$tmp/$_", shift @part)
	    for qw(ray_sums.h ray_quotients.h ray_quick.h);
}

# Both ways in which products and sums are done.
sub count_errors {
	my ($core) = @_;
	my ($well, $said) = (1, '');
	cut_ray($core);
	for my $way ('', '-DFUSED_MADD') {
		my ($ok, $text) = outcome(compiled('count.cc', $core,
		    $way || ()));
		$said .= ($way ? "products fused:\n" : "products rounded:\n") .
		    $text;
		$well &&= $ok;
		last if !$ok;
	}
	return ($well, $said);
}

1;
