#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that `make mutants` makes the changes that it prints, reports those that no
# test finds, and kills programs that do not end; and that mutants.equal has a reason
# for each change.
use strict;
use warnings;
use File::Path 'make_path';
use FindBin;
use lib $FindBin::Bin;
use Mutant;
use Projcalc;

# Returns all changes of a text, by kind.
sub changed {
	my ($text) = @_;
	my $mutants = mutants('x.c', $text);
	return {map {
		my $kind = $_;
		$kind => [map { mutated($text, $_) } @{$mutants->{$kind}}]
	} keys %$mutants};
}

for my $case (
	["\treturn a < b;\n", {comparison => ["\treturn a <= b;\n"]}],
	["\treturn a == b;\n", {comparison => ["\treturn a != b;\n"]}],
	["\ti = j + k;\n", {operator => ["\ti = j - k;\n"]}],
	["{\n\ti = j && k;\n}\n", {operator => ["{\n\ti = j || k;\n}\n"],
	    statement => ["{\n\t;\n}\n"]}],
	["\tn--;\n", {operator => ["\tn++;\n"]}],
	["\tif (a)\n\t\treturn b;\n\treturn c;\n", {
	    condition => ["\tif (!(a))\n\t\treturn b;\n\treturn c;\n"],
	    statement => ["\tif (a)\n\t\t;\n\treturn c;\n"]}],
	["#define BOUND 0x1p-45\n", {constant => ["#define BOUND 0x1p-44\n",
	    "#define BOUND 0x1p-46\n"]}],
	["int n = 7;\n", {constant => ["int n = 8;\n", "int n = 6;\n"]}],
	["int n = 0x1f;\n", {constant => ["int n = 0x1e;\n"]}],
	["double a = 0.75;\n", {constant => ["double a = 1.5;\n",
	    "double a = 0.375;\n"]}],
	["{\n\tint a = b(c,\n\t    d);\n\tb(c,\n\t    d);\n}\n", {statement =>
	    ["{\n\tint a = b(c,\n\t    d);\n\t;\n}\n"]}],
	["/* a < b && c == 1; */\n#if A > 1\n#include <b-1.h>\n#endif\n" .
	    "char *s = \"a < 1\", c = '<';\n", {}],
) {
	my ($text, $want) = @$case;
	is_deeply(changed($text), $want, $text);
}

# A hunk finds its lines in a text that has changed, and of several places the nearest.
my $text = "\tx = 1;\n\ty = 2;\n\tx = 1;\n";
my ($again) = hunks("# A reason\n# of two lines.\nx.c:3\n-x = 1;\n+x = 2;\n");
is(mutated($text, $again), "\tx = 1;\n\ty = 2;\nx = 2;\n", 'a hunk');
is($again->{reason}, 'A reason of two lines.', 'its reason');
is((hunks(hunk($again)))[0]{line}, 3, 'its line');
my $around = (hunks("x.c\n-\ty = 2;\n-\tx = 1;\n+\ty = 2;\n+\tx = 2;\n"))[0];
ok(same_change($text, $again, $around), 'with what is around it');
my ($first) = hunks("x.c\n-\tx = 1;\n+\tx = 2;\n");
ok(!same_change($text, $first, $around), 'which tells one from another');

for my $known (hunks(slurp('cmd/test/mutants.equal'))) {
	ok($known->{reason} ne '' && -f $known->{file} &&
	    defined mutated(slurp($known->{file}), $known),
	    "a reason, and the code: $known->{file}: $known->{from}");
}

# A program of one file, with a test that finds the mutants of its sum and its loop,
# which does not end in one. It does not find mutants of unused values, or reads past an
# array, which a sanitizer finds.
my $toy = "$tmp/toy";
make_path("$toy/core/test", "$toy/cmd/test", map { "$toy/$_" } qw(man
    testdata .github .debian));
spew("$toy/$_", '') for qw(README.md NEWS.md);
spew("$toy/Makefile", "programs: build/projcalc\nbuild/projcalc: core/x.c\n" .
    "\t\@mkdir -p build\n\t\$(CC) \$(CFLAGS) -o \$\@ core/x.c\n");
spew("$toy/core/x.c", <<'END');
#include <stdio.h>

static int unseen = 5;

int main(void)
{
	int sum = 2 + 1;

	while (sum < 0)
		;
	printf("%d\n", sum);
	fprintf(stderr, "%d\n", unseen);
	return 0;
}
END
spew("$toy/cmd/test/transcripts_test.t", 'my $said = ' .
    '`./build/projcalc 2>/dev/null`; print $said eq "3\n" && $? == 0 ? ' .
    '"ok 1\n" : "not ok 1\n"; exit($said ne "3\n" || $? != 0);');
for my $test (qw(bits recorded examples cameras scenes)) {
	spew("$toy/cmd/test/${test}_test.t", 'print "ok 1\n";');
}
spew("$toy/cmd/test/mutants.equal",
    "# Nobody.\ncore/x.c\n-\tint sum = 2 + 1;\n+\tint sum = 1 + 1;\n");
for my $file (qw(mutants.pl Mutant.pm)) {
	spew("$toy/cmd/test/$file", slurp("cmd/test/$file"));
}
my ($status, $said, $err) = run('QUICK=1 PATIENCE=3 perl ' .
    'cmd/test/mutants.pl build core', $toy);
is("$status $err", '1 ', 'too many lived');
is(join(' ', sort map { $_->{line} } hunks($said)), '12 3 3', 'they are told')
    or diag($said);
like($said, qr/^11 mutants: 7 found, 1 equal for a reason, 3 lived: 72.7 %$/m,
    'the score');
like(slurp("$toy/build/mutants/log"), qr/^\S*transcripts_test.t, .*\n.*:9\n/m,
    'and what found the loop without an end');
is(slurp("$toy/build/mutants/lived"), $said =~ s/\n\d+ mutants.*\n//r,
    'and they are kept');
my @left = grep { (eval { slurp("/proc/$_/cmdline") } // '') =~ /\Q$toy\E/ }
    map { m{(\d+)/cmdline} } glob '/proc/[0-9]*/cmdline';
is("@left", '', 'no mutant outlives its run');
($status, $said) = run('QUICK=1 AGAIN=build/mutants/lived perl ' .
    'cmd/test/mutants.pl build core', $toy);
like($said, qr/^3 mutants: 0 found, 0 equal for a reason, 3 lived/m, 'again');
my $past = '	fprintf(stderr, "%d\n", unseen);';
spew("$toy/past", "core/x.c\n-$past\n+" . $past =~ s/unseen/(&$&)[1]/r . "\n");
($status, $said) = run('AGAIN=past perl cmd/test/mutants.pl build core', $toy);
like($said, qr/^1 mutants: 1 found/m, 'what a sanitizer finds');
done_testing();
