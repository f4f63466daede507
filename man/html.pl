#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Writes the manual's pages, the charts and an index of them into a folder, with a link
# to the program as a page for a browser if its file is given.
# usage: html.pl FOLDER [PROJCALC.HTML]
use strict;
use warnings;
use File::Copy;

my ($folder, $program) = @ARGV;
my @pages = qw(projcalc.1 projcalc-scene.5 projcalc-recipes.7 projcalc-numbers.7);

# The pictures of testdata/charts that stand below headings of the pages, each with what
# one sees in it. Those that no file has are left out.
my %pictures = (
	'projcalc.1#SPACES' => ['spaces.svg',
	    'A camera and its view volume in the world, drawn by another camera; ' .
	    'beside it, what the camera sees'],
	'projcalc-scene.5#viewport' => ['part.svg',
	    'Four viewports, each a part of one full picture, at its offset'],
	'projcalc-scene.5#convention' => ['axes.svg',
	    'View space and the camera in it, by convention; below, the axes of ndc ' .
	    'and the dot where pixels begin'],
	'projcalc-scene.5#window' => ['window.svg',
	    'A window of the 2D world, and the device that shows it'],
	'projcalc-numbers.7#Kinds_of_projection' => ['kinds.svg',
	    'A cube: front, isometric, dimetric, trimetric, cavalier; cabinet, one-, ' .
	    'two- and three-point and reverse perspective'],
);

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

sub copied {
	my ($file) = @_;
	my ($name) = $file =~ m|([^/]*)$|;
	copy($file, "$folder/$name") or die "$file: $!\n";
	return $name;
}

sub figure {
	my ($file, $about) = @_;
	my $name = copied($file);
	return qq(<figure><img src="$name" alt="">\n) .
	    "<figcaption>$about</figcaption></figure>\n";
}

# Returns the name of a page as its readers know it.
sub title { return $_[0] =~ s/\.(\d)$/($1)/r }

# Links to the other pages, for the top of each.
sub top {
	my ($here) = @_;
	my @links = map { $_->[0] eq $here ? "<b>$_->[1]</b>" :
	    qq(<a href="$_->[0].html">$_->[1]</a>) } ['index', 'projcalc'],
	    (map { [$_, title($_)] } @pages), $program ? ['projcalc', 'try it'] : ();
	return '<nav class="top">' . join("\n", @links) . "</nav>\n";
}

# References lead to our own pages, or to the pages of other programs at Debian. The
# table of contents, which would come before the first calls, is folded up.
my $ours = join '|', map { quotemeta } @pages;
for my $page (@pages) {
	my $html = `mandoc -T html -O toc,style=style.css,man=%N.%S.html man/$page`;
	die "mandoc fails\n" if $?;
	$html =~ s|<body>|"<body>\n" . top($page)|e;
	$html =~ s|<h1 class="Sh">TABLE OF CONTENTS</h1>\n(<ul.*?^</ul>)|<details class="toc"><summary>Contents</summary>\n$1\n</details>|ms;
	for (grep { s/^\Q$page\E#// } map { $_ } sort keys %pictures) {
		my ($name, $about) = @{$pictures{"$page#$_"}};
		next if !-e "testdata/charts/$name";
		my $figure = figure("testdata/charts/$name", $about);
		$html =~ s|(<h[12] class="S[hs]" id="$_">.*?</h[12]>\n)|$1$figure|s;
	}
	write_file("$page.html", $html =~
	    s|href="(?!(?:$ours)\.)([\w-]+\.\d)\.html"|href="https://manpages.debian.org/$1"|gr);
}

# The index lists the sections of each page, and of all but the first the subsections.
my %what = (
	'projcalc.1' => 'What to type: ten calls, tasks, commands, options, tables, messages.',
	'projcalc-scene.5' => 'The members of a scene: camera, projection, viewport, ' .
	    'convention, steps, window.',
	'projcalc-recipes.7' => 'Cameras of other programs, and what one does with cameras.',
	'projcalc-numbers.7' => 'Formulas, what inspect prints, exactness, limits, clusters.',
);
my $index = '';
for my $page (@pages) {
	my $title = title($page);
	$index .= qq(<section>\n<h2><a href="$page.html">$title</a></h2>\n) .
	    qq(<p>$what{$page}</p>\n<ul>\n);
	my $inner = $page ne 'projcalc.1';
	for (slurp("$folder/$page.html") =~ m|<h[12]\s+class="S[hs]".*?</h[12]>|gs) {
		my ($kind, $id) = /class="(S[hs])"\s+id="([^"]+)"/ or next;
		my $name = s/<[^>]*>//gr =~ s/\s+/ /gr;
		next if $kind eq 'Ss' && !$inner || $name =~ /^(?:NAME|SEE ALSO|FILES)$/;
		$index .= qq(<li class="$kind"><a href="$page.html#$id">$name</a></li>\n);
	}
	$index .= "</ul>\n</section>\n";
}

my $readme = slurp('README.md');
my ($what) = $readme =~ /^((?!#|!|<|```|\n).+?)\n\n/ms;
$what =~ s/`([^`]+)`/<code>$1<\/code>/g;
my ($calls) = slurp("$folder/projcalc.1.html") =~ m|id="TEN_CALLS".*?(<pre.*?</pre>)|s;
my @charts = map { [m|^!\[(.*)\]\((.*)\)$|s] } $readme =~ /^(!\[.*?\]\(.*?\))$/mgs;
my ($first, @others) = map { figure($_->[1], $_->[0]) } @charts;
my $try = $program ? '<p><a class="try" href="' . copied($program) .
    "\">Try it in the browser</a>: nothing is sent.</p>\n" : '';
copied('man/style.css');
write_file('index.html', <<"END");
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>projcalc</title>
<link rel="stylesheet" href="style.css">
</head>
<body class="index">
<h1>projcalc</h1>
<p>$what</p>
$try$first<h2>Ten calls</h2>
$calls
<div class="pages">
$index</div>
<h2>Speed and accuracy</h2>
@others</body>
</html>
END
