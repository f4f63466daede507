#!/usr/bin/perl
# The manual, the style, the scripts and the C, as make lint checks them.
use strict;
use warnings;
use File::Basename;

chdir dirname($0) . '/../..' or die "$0: $!\n";
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES)};
for my $tool (qw(mandoc clang-format shellcheck cppcheck)) {
	if (system("command -v $tool >/dev/null") != 0) {
		print "1..0 # SKIP $tool is missing\n";
		exit;
	}
}
my $said = `make -s lint 2>&1`;
my $failed = $?;
print $failed ? 'not ok' : 'ok', " 1 - make lint\n";
print map { "# $_\n" } split /\n/, $said if $failed;
print "1..1\n";
exit($failed != 0);
