#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks random calls: with the loops of this processor and without, on one thread and
# on several, and from a file and a pipe that is cut anywhere, they give the same. The
# calls are others each day; SEED=N draws those of a day again.
# usage: differential_test.t [BUILD]
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

my $seconds = 12; # of the processor
my $seed = $ENV{SEED} // int(time / 86400);
my $said = `$^X cmd/test/differential.pl $build/projcalc $seconds $seed 2>&1`;
my $status = $?;
my ($passed) = $said =~ /^seed \d+: (\d+) passed, /m;
ok($status == 0 && $passed, "random calls in several ways, SEED=$seed")
    or diag($said);
cmp_ok($passed // 0, '>=', 50, 'of which there are enough');
done_testing();
