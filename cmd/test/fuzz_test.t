#!/usr/bin/perl
# A few seconds of each fuzzer; `make fuzz` goes on for longer.
use strict;
use warnings;
use File::Basename;

chdir dirname($0) . '/../..' or die "$0: $!\n";
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES)};
if (system('echo "int LLVMFuzzerTestOneInput(void) { return 0; }" | ' .
    'clang -fsanitize=fuzzer,address -x c -o /dev/null - 2>/dev/null') != 0) {
	print "1..0 # SKIP no clang with libFuzzer\n";
	exit;
}
my $said = `make -s fuzz FUZZ_SECONDS=8 2>&1`;
my $failed = $?;
print $failed ? 'not ok' : 'ok', " 1 - make fuzz\n";
print $said =~ s/^/# /mgr;
print "1..1\n";
exit($failed != 0);
