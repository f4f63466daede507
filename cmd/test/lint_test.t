#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# The manual, the style, the scripts and the C, as make lint checks them.
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
