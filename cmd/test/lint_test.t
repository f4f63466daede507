#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks the manual, the style, the scripts and the C code by `make lint`.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

my $lacks = missing(qw(mandoc clang-format shellcheck cppcheck));
plan skip_all => "no $lacks" if $lacks;
my $said = `make -s lint 2>&1`;
is($?, 0, 'make lint') or diag($said);
done_testing();
