#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that the pages of `make html` have no dead link: each leads to one of the
# files, and to a name in it if the link has a #, or to Debian's manual pages.
use strict;
use warnings;
use File::Temp;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

plan(skip_all => 'no mandoc') if missing('mandoc');
my $folder = File::Temp->newdir;
is(system($^X, 'man/html.pl', $folder), 0, 'html.pl');
my %names;
for my $page (glob "$folder/*.html") {
	my ($file) = $page =~ m|([^/]*)$|;
	$names{$file} = {map { $_ => 1 } slurp($page) =~ /\bid="([^"]+)"/g};
}
is(scalar keys %names, 5, 'four pages and the index');
for my $file (sort keys %names) {
	for my $link (slurp("$folder/$file") =~ /\b(?:href|src)="([^"]+)"/g) {
		next if $link =~ m|^https://manpages\.debian\.org/\w+\.\d$|;
		my ($to, $name) = $link =~ /^([^#]*)#?(.*)/;
		$to = $file if $to eq '';
		ok(-e "$folder/$to" && ($name eq '' || $names{$to}{$name}),
		    "$file: $link");
	}
}
done_testing();
