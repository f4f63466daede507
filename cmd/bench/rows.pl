# SPDX-License-Identifier: MIT
# Replaces the rows of a table by those of the page PAGE that begin alike.
# usage: perl -i rows.pl PAGE FILE
use strict;
use warnings;

my $page = shift;
my $first = qr/^(\| [^ |].*? \|)/;
open my $in, '<', $page or die "$page: $!\n";
my %row = map { /$first/ ? ($1 => $_) : () } <$in>;
while (<>) {
	print /$first/ ? $row{$1} // $_ : $_;
}
