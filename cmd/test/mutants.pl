#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Changes the program's source at random places, one change at a time and in a copy,
# and lists the mutants that no test finds. A mutant that compiles to the same bytes
# does not count, nor does one that cannot be built. A mutant that
# cmd/test/mutants.equal explains counts as found, and so does one that a sanitizer
# finds.
# usage: mutants.pl BUILD FOLDER..., at the top of the project
#   N=400        how many
#   SEED=1       which
#   AGAIN=FILE   those that stand in FILE, such as BUILD/mutants/lived
#   QUICK=1      by the tests that find nearly all alone
#   PATIENCE=20  so many seconds, and ten times what the tests take otherwise, are
#                given to each
use strict;
use warnings;
use Cwd 'abs_path';
use File::Path qw(make_path remove_tree);
use FindBin;
use List::Util 'max';
use Time::HiRes 'time';
use lib $FindBin::Bin;
use Mutant;

my ($build, @folders) = @ARGV;
my ($n, $seed, $again, $patience) = map { $_ || '' }
    @ENV{qw(N SEED AGAIN PATIENCE)};
our $quick = $ENV{QUICK};
my $equal = "$FindBin::Bin/mutants.equal";
my @equal = hunks(slurp($equal));
make_path("$build/mutants");
my $room = abs_path("$build/mutants");
my ($tree, $tmp) = map { "$room/$_" } qw(tree tmp);
srand($seed || 1);

# A make that is started here must not take part in `make mutants`, and SEED chooses
# mutants, not the tests' samples.
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES SEED)};

sub slurp {
	open my $file, '<:raw', $_[0] or die "$_[0]: $!\n";
	local $/;
	return <$file> // '';
}

sub spew {
	my ($name, $text) = @_;
	open my $file, '>:raw', $name or die "$name: $!\n";
	print $file $text;
	close $file or die "$name: $!\n";
}

# The flags of mutants. By these, a mutant does not build if it reads an unset variable
# or returns no value.
my $checks = '-fsanitize=address,undefined';
my %flags = (plain => "CFLAGS='-O1 -g0 -Werror=uninitialized " .
	"-Werror=return-type' LDFLAGS=-s",
    sanitized => "CFLAGS='-O1 -g0 -fno-sanitize-recover=all $checks' " .
	"LDFLAGS=$checks");
our $flags = 'plain';

# The copy of the project from which mutants are made.
sub whole { "$room/$flags" }

# Starts a command with the limits of a mutant: seconds by the clock and of CPU time,
# files, and memory, except with a sanitizer, which reserves more than there is. timeout
# kills the command's process group, even if this program has ended.
my $running;

sub start {
	my ($dir, $seconds, $command) = @_;
	my $limits = sprintf 'ulimit -t %d && ulimit -f 4000000 && ' .
	    'ulimit -c 0 && ', 1 + $seconds / 2;
	$limits .= 'ulimit -v 4000000 && ' if $flags eq 'plain';
	$running = open(my $from, '-|') // die "fork: $!\n";
	return $from if $running != 0;
	setpgrp;
	chdir $dir or die "$dir: $!\n";
	@ENV{qw(TMPDIR CMOCKA_MESSAGE_OUTPUT BUILD ASAN_OPTIONS)} =
	    ($tmp, 'TAP', "$dir/build", 'detect_leaks=0');
	open STDIN, '<', '/dev/null';
	open STDERR, '>', "$room/errors";
	exec 'timeout', '-s', 'KILL', $seconds, 'sh', '-c', "$limits$command";
}

# Kills what is left of the process group.
sub finish {
	return if !$running;
	kill 'KILL', -$running;
	waitpid $running, 0;
	$running = 0;
	remove_tree($tmp, {keep_root => 1});
}

$SIG{$_} = sub { finish(); exit 1 } for qw(INT TERM HUP);
END { finish() }

# Returns whether a command succeeds; it ends at the first test that fails.
sub succeeds {
	my $from = start(@_);
	while (my $line = readline $from) {
		next if $line !~ /^not ok/ || $line =~ /# TODO/;
		finish();
		return 0;
	}
	close $from;
	my $well = $? == 0;
	finish();
	return $well;
}

sub make { "make -s $flags{$flags} BUILD=build $_[0]" }

sub is_built {
	my ($dir, $target) = @_;
	return succeeds($dir, 600, make("build/$target"));
}

# The tests, in an order in which those come first that find most mutants in the least
# time. The tests of core do not depend on cmd; the proofs depend only on the headers of
# core, and on the series of core/exact/trig.c.
my @first = qw(transcripts bits);
my @values = qw(recorded examples cameras scenes);
my @talk = qw(completion schema manual digits pieces lines fault);

sub tests_of {
	my ($file) = @_;
	my ($folder, $name) = $file =~ m{^(core|cmd).*?(\w+)\.\w+$};
	my @units = map { s/\.c$//r } glob "$folder/test/*_test.c";
	my ($own) = grep { /\/${name}_test$/ } @units;
	my @proofs = $file =~ m{^core/(?:.*\.h|exact/(?:ex|sum|trig)\.c)$} ?
	    map { "core/proof/$_" } qw(prove.pl proof_test.t) : ();
	# kernels that decide nothing change no output, only the time
	my @sure = $file =~ m{^core/points/} ? "core/test/sure_test" : ();
	my @talk_too = $folder eq 'cmd' ? @talk : ();
	my ($first, $others) = map { [map { "cmd/test/${_}_test.t" } @$_] }
	    \@first, [@values, @talk_too];
	my %seen;
	return ($own // (), @sure, @$first) if $quick;
	return grep { !$seen{$_}++ } $own // (), @sure, @$first, $proofs[0] // (),
	    @units, @$others, @proofs;
}

sub passes {
	my ($dir, $test, $seconds) = @_;
	return succeeds($dir, $seconds, "perl $test") if $test =~ /\.(?:t|pl)$/;
	return is_built($dir, $test) &&
	    succeeds($dir, $seconds, "build/$test");
}

# The seconds that a test may take: a multiple of its time with the unchanged program,
# as the machine may be busy. The unchanged program must pass.
my %limit;

sub limit {
	my ($test) = @_;
	return $limit{"$flags $test"} //= do {
		my $start = time;
		passes(whole(), $test, 600) or
		    die "$test fails before anything is changed\n";
		unlink whole() . "/build/$test";
		($patience || 20) + 10 * (time - $start);
	};
}

sub prepare {
	my $whole = whole();
	make_path($whole, $tmp);
	system('cp', '-a', qw(core cmd man testdata Makefile README.md NEWS.md
	    .github .debian), "$whole/") == 0 or die "no copy\n";
	succeeds($whole, 3600, make('programs')) or
	    die "can't be built: see $room/errors\n";
	# a mutant's test is linked when it is needed
	unlink map { "$whole/build/$_" } map { s/\.c$//r }
	    glob 'c*/test/*_test.c';
}

# Makes a mutant in a copy of the project. Returns whether it builds.
sub mutate {
	my ($mutant) = @_;
	my $file = $mutant->{file};
	prepare() if !-d whole();
	my $text = mutated(slurp(whole() . "/$file"), $mutant) //
	    die "$file has no longer\n$mutant->{from}";
	remove_tree($tree);
	system('cp', '-a', whole(), $tree) == 0 or die "no copy\n";
	spew("$tree/$file", $text);
	return is_built($tree, 'projcalc');
}

sub same_bytes {
	return slurp(whole() . '/build/projcalc') eq
	    slurp("$tree/build/projcalc");
}

# Returns the first test that fails, or undef.
sub finder {
	my ($mutant) = @_;
	for my $test (tests_of($mutant->{file})) {
		my $limit = limit($test);
		return $test if !passes($tree, $test, $limit);
	}
	return;
}

# The result for a mutant is the test that found it or, if none did, one of these.
my ($unbuilt, $same, $lived) = ('unbuilt', 'the same bytes', 'lived');

sub fate {
	my ($mutant) = @_;
	return $unbuilt if !mutate($mutant);
	return $same if same_bytes();
	my $test = finder($mutant);
	return $test // $lived if defined $test || $quick;
	# reads past an array may change no output, but a sanitizer finds them
	local ($flags, $quick) = ('sanitized', 1);
	$test = mutate($mutant) && finder($mutant);
	return $test ? "$test, sanitized" : $lived;
}

sub shuffled {
	my @all = @_;
	for my $i (reverse 1 .. $#all) {
		my $j = int rand($i + 1);
		@all[$i, $j] = @all[$j, $i];
	}
	return @all;
}

# Chooses random mutants, as many of each kind.
sub chosen {
	my %all;
	for my $file (sort map { glob "$_/*.c $_/*.h $_/*.cc" } @folders) {
		my $of = mutants($file, slurp($file));
		push @{$all{$_}}, @{$of->{$_}} for keys %$of;
	}
	my @kinds = map { [shuffled(@{$all{$_}})] } sort keys %all;
	my @chosen;
	for my $i (0 .. max(map { $#$_ } @kinds)) {
		push @chosen, grep { defined } map { $_->[$i] } @kinds;
	}
	return @chosen;
}

my %count = (found => 0, equal => 0, lived => 0);
my @lived;

sub try {
	my ($mutant) = @_;
	my $text = slurp(whole() . "/$mutant->{file}");
	my ($known) = grep { same_change($text, $_, $mutant) } @equal;
	my $start = time;
	my $fate = $known && !$again ? 'equal' : fate($mutant);
	open my $log, '>>', "$room/log" or die "$room/log: $!\n";
	printf $log "%s, %.0f s\n%s\n", $fate, time - $start, hunk($mutant);
	return if $fate eq $unbuilt || $fate eq $same;
	$fate = 'found' if !exists $count{$fate};
	$count{$fate}++;
	return if $fate ne $lived;
	print hunk($mutant), "\n";
	push @lived, $mutant;
	spew("$room/lived", join "\n", map { hunk($_) } @lived);
}

sub tried { $count{found} + $count{equal} + $count{lived} }

$| = 1;
my $list = $again && slurp($again);
unlink map { "$room/$_" } qw(log lived);
my @trees = ($tree, $tmp, map { "$room/$_" } keys %flags);
remove_tree(@trees);
prepare();
my @mutants = $again ? hunks($list) : chosen();
$n = $again ? @mutants : $n || 400;
for my $mutant (@mutants) {
	try($mutant);
	last if tried() >= $n;
}
printf "%d mutants: %d found, %d equal for a reason, %d lived: %.1f %%\n",
    tried(), @count{qw(found equal lived)},
    100 * ($count{found} + $count{equal}) / (tried() || 1);
for my $old (grep { !defined mutated(slurp($_->{file}), $_) } @equal) {
	print "$equal: $old->{file} has no longer\n$old->{from}";
}
remove_tree(@trees);
exit($count{lived} * 50 > tried());
