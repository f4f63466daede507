#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Writes the page: its text with the program, Emscripten's glue and the scripts in it.
# usage: page.pl DIRECTORY, which has web.wasm and web.js
use strict;
use warnings;
use Compress::Zlib;
use FindBin;
use MIME::Base64;

my ($wasm, $glue, $page, $worker, $html, $notice) = map { local (@ARGV, $/) = $_; <> }
    map({ "$ARGV[0]/web.$_" } qw(wasm js)), map { "$FindBin::Bin/$_" }
    qw(page.js worker.js page.html ../../.debian/copyright);
my %part = (WASM => encode_base64(Compress::Zlib::memGzip($wasm), ''), GLUE => $glue,
    WORKER => $worker, PAGE => $page, COPYRIGHT => $notice);
print $html =~ s/@(\w+)@/$part{$1}/gr;
