#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Writes the page: its text with the program, Emscripten's glue, the scripts and the
# examples of pictures in it.
# usage: page.pl DIRECTORY, which has web.wasm and web.js
use strict;
use warnings;
use Compress::Zlib;
use File::Spec;
use FindBin;
use JSON::PP;
use MIME::Base64;

my $built = File::Spec->rel2abs($ARGV[0]);
chdir "$FindBin::Bin/../.." or die "$FindBin::Bin: $!\n";

sub slurp {
	local (@ARGV, $/) = @_;
	return scalar <>;
}

sub zipped { encode_base64(Compress::Zlib::memGzip($_[0]), '') }

# The words of a call that draws, and the files with its scene and its points.
my @pictures = map { {name => $_->[0], call => $_->[1],
    scene => slurp("testdata/$_->[2]"), points => slurp("testdata/$_->[3]")} }
    ['the Utah teapot', 'draw -i obj', 'demo.json', 'teapot.obj'],
    ['a room from inside', 'draw -i obj', 'pictures/room.json', 'pictures/room.obj'],
    ['two cameras: a view volume, and what it shows', 'draw -i obj --scenes',
	'pictures/spaces.json', 'pictures/spaces.obj'],
    ['kinds of projection', 'draw -i obj --scenes', 'pictures/kinds.json',
	'pictures/kinds.obj'],
    ['a 2D window', 'draw --lines --scenes', 'pictures/window.json',
	'pictures/window.txt'];

my %part = (WASM => zipped(slurp("$built/web.wasm")), GLUE => slurp("$built/web.js"),
    PICTURES => zipped(encode_json(\@pictures)), WORKER => slurp('cmd/web/worker.js'),
    PAGE => slurp('cmd/web/page.js'), COPYRIGHT => slurp('.debian/copyright'));
print slurp('cmd/web/page.html') =~ s/@(\w+)@/$part{$1}/gr;
