#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Runs each fuzzer for a few seconds; `make fuzz` runs them longer, and also with the
# undefined behaviour sanitizer, with which they take twice as long to compile.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

if (system('echo "int LLVMFuzzerTestOneInput(void) { return 0; }" | ' .
    'clang -fsanitize=fuzzer,address -x c -o /dev/null - 2>/dev/null') != 0) {
	plan skip_all => 'no clang with libFuzzer';
}
my $said = join ' ', "make -s BUILD='$build/quick' fuzz FUZZ_SECONDS=4",
    "ADDRESS='-O1 -fno-sanitize-recover=all -fsanitize=address' 2>&1";
$said = `$said`;
is($?, 0, 'make fuzz') ? note($said) : diag($said);
done_testing();
