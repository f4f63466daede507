# SPDX-License-Identifier: MIT
# Replaces the text between <!-- speed --> and <!-- --> in FILE by the text between
# these marks in PAGE.
# usage: perl -i short.pl PAGE FILE
use strict;
use warnings;

my $block = qr/^<!-- speed -->\n.*?^<!-- -->\n/ms;
my $page = shift;
local $/;
open my $in, '<', $page or die "$page: $!\n";
my ($new) = <$in> =~ /($block)/ or die "$page: no figures\n";
print <> =~ s/$block/$new/r;
