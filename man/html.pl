#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Writes the manual's pages, the charts and an index of them into a folder.
# usage: html.pl FOLDER
use strict;
use warnings;
use File::Copy;

my ($folder) = @ARGV;
my @pages = qw(projcalc.1 projcalc-scene.5 projcalc-recipes.7
    projcalc-numbers.7);

sub slurp {
	my ($file) = @_;
	open my $f, '<', $file or die "$file: $!\n";
	local $/;
	return scalar <$f>;
}

sub write_file {
	my ($name, $text) = @_;
	open my $f, '>', "$folder/$name" or die "$folder/$name: $!\n";
	print $f $text;
	close $f or die "$folder/$name: $!\n";
}

# References lead to our own pages, or to the pages of other programs at Debian.
my $ours = join '|', map { quotemeta } @pages;
for my $page (@pages) {
	my $html = `mandoc -T html -O toc,style=style.css,man=%N.%S.html man/$page`;
	die "mandoc fails\n" if $?;
	$html =~ s|<body>|<body>\n<p><a href="index.html">projcalc</a></p>|;
	write_file("$page.html", $html =~
	    s|href="(?!(?:$ours)\.)([\w-]+\.\d)\.html"|href="https://manpages.debian.org/$1"|gr);
}

# The index lists the sections of each page, and below them its examples and
# recipes.
my $index = '';
for my $page (@pages) {
	my ($title) = slurp("man/$page") =~ /^\.Nd (.*)/m;
	$index .= qq(<h2><a href="$page.html">$page</a></h2>\n<p>$title</p>\n);
	my $recipes;
	for (slurp("$folder/$page.html") =~ m|<h[12]\s+class="S[hs]".*?</h[12]>|gs) {
		my ($kind, $id) = /class="(S[hs])"\s+id="([^"]+)"/ or next;
		my $name = s/<[^>]*>//gr =~ s/\s+/ /gr;
		$recipes = $name =~ /CAMERAS|PICTURES|EXAMPLES/ if $kind eq 'Sh';
		next if $kind eq 'Ss' && !$recipes;
		$index .= qq(<p class="$kind"><a href="$page.html#$id">$name</a></p>\n);
	}
}

my ($what) = slurp('README.md') =~ /^# projcalc\n\n(.*?)\n\n/s;
$what =~ s/`([^`]+)`/<code>$1<\/code>/g;
my $charts = '';
for (slurp('README.md') =~ /^(!\[.*?\]\(.*?\))$/mgs) {
	my ($about, $file, $name) = m|^!\[(.*)\]\((.*/(.*))\)$|s;
	copy($file, "$folder/$name") or die "$file: $!\n";
	$charts .= qq(<figure><img src="$name" alt="">\n) .
	    "<figcaption>$about</figcaption></figure>\n";
}
copy('man/style.css', "$folder/style.css") or die "style.css: $!\n";
write_file('index.html', <<"END");
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>projcalc</title>
<link rel="stylesheet" href="style.css">
</head>
<body>
<h1>projcalc</h1>
<p>$what</p>
$index$charts</body>
</html>
END
