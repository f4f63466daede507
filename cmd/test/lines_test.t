#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks lines of every kind, right and wrong: the loops of each processor give the same
# output and messages as the scalar code, with the digests of testdata/lines.sha256.
# usage: lines_test.t [-w] [BUILD]; -w rewrites the digests with what the scalar
# code makes of the lines.
use strict;
use warnings;
use Digest::SHA 'sha256_hex';
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

my $digests = 'testdata/lines.sha256';
my $lines = 15000;

sub digits { join '', map { below(10) } 1 .. $_[0] }

# Makes numbers: integers, with decimals, as printf writes doubles, and at the limits of
# the vector loops: 16 to 19 digits, 22 decimals, 32 characters.
my @usual = (
	sub { sprintf '%.6f', (below(4000001) - 2000000) / 1000000 },
	sub { sprintf '%.3f', (below(2000001) - 1000000) / 999 },
	sub { below(2000) - 1000 },
	sub { sprintf '%.17g', (below(2000001) - 1000000) / 999983 },
	sub { sprintf '%.15f', below(1000000) / 7 },
	sub { pick('', '-') . digits(1 + below(6)) . '.' . digits(1 + below(24)) },
	sub { pick('', '-') . digits(14 + below(8)) },
	sub { (9007199254740993 + 2 * below(1000000)) . pick('', '.0', '.5') },
	sub { '0.' . '0' x below(24) . digits(1 + below(8)) },
	sub { pick('-0', '0', '-0.0', '0.000', '007.5', '-00') },
);

# Texts that are numbers in some formats only, or in none.
my @odd = (qw(+1.5 .5 5. -.5 -5. 1e5 -2.5E-7 1e+3 1e400 1e-400 1e151 nan NaN -nan
    inf -Infinity null true 0x10 1..2 1.2.3 --1 - . -. +-1 1-2 1e 1e+ 1.5e-x x 1/2
    12:30 "1.5" "1 1" 1"2 "), '', ' ', "1\xe9", "\xef\xbb\xbf1", "1\x1b",
    '[1', '{"x":1}', '[1]', '#1', '9' x 33, '0.' . '1' x 31, '1' . '0' x 150,
    '1' x 400, '-' . '1' x 31, '-' . '1' x 32);

sub number { (below(60) ? pick(@usual)->() : pick(@odd)) }

# Returns three numbers and up to `more` others.
sub with_separators {
	my ($more, $usual, @rare) = @_;
	my $s = number();
	$s .= (below(25) ? $usual : pick(@rare)) . number() for 1 .. 2 + below($more + 1);
	return $s;
}

my @ends = ('', '', "\r", ' ', "\t ", "\r\r");
my @words = ('a', 'label', 'two words', "\xc3\xa9", '', '#', "it's", '5" pipe',
    'x' x 70);

sub text_line {
	my $s = with_separators(2, pick(' ', ' ', ' ', "\t", '  '), ',', ' , ', "\x0b",
	    "\f", "\r", ';', ' ' x 70);
	$s .= pick(' ', ',', ' ,', '  ') . pick(@words) if below(3) == 0;
	return pick(('') x 20, ' ', "\t", ',') . $s;
}

# Returns a row below a header of four names.
sub row_of_text {
	return with_separators(0, pick(' ', ' ', ' ', "\t", '  '), ',', "\r", ' ' x 70) .
	    (below(20) ? pick(' ', '  ') . pick(grep { !/ / } @words) : pick('', ' a b')) .
	    pick(('') x 9, ' ');
}

# Returns a row that mostly has four fields, as the header has.
sub csv_line {
	my $s = with_separators(below(20) ? 0 : 2, pick(',', ',', ',', ', '), ' , ', ',,',
	    "\t,", ' ', ';');
	$s = '"' . pick('a', 'a,b', 'a""b', '1,2', "a") . '",' . $s
	    if below(20) == 0;
	$s .= ',' . pick(@words, '"a,b"', '"a""b"', '"open', ' "a" ') if below(20);
	$s .= ',' . pick('', '', ' ', 'a') if below(20) == 0;
	return $s;
}

sub json_line {
	my $s = with_separators(2, pick(',', ',', ',', ', '), ' , ', ',,', "\t,",
	    ' ', ',]', ",\x0b", "\f,");
	$s = pick('"a"', '"a,[b]"', 'null', '[1]') . ",$s" if below(20) == 0;
	$s .= ',' . pick('"a"', '"two words"', '"a,b]"', '"\"q\""', '"\u00e9"',
	    '"\\\\"', "\"\xc3\xa9\"", '{"a":[1,2]}', '[1,[2]]', 'true', '"open',
	    "\"\t\"", 'word', '', '17', '1.5e3', '01', '"\\x"') if below(3) == 0;
	return "[$s]" if below(30);
	return pick(" [$s]", "[ $s ]", "[$s", "$s]", "[[$s]]", "{$s}", "[$s] x",
	    "[$s]]", "[$s],", '[]', '[');
}

# Returns an object, mostly with members as other programs write them.
sub object_line {
	my @names = (qw(x y z), below(8) ? () : pick(qw(x w flags)));
	my @members = map { qq("$_":) . number() } @names;
	push @members, map { qq("$_":) . pick('"a"',
	    '"a,{b}"', 'null', 'true', 'falsy', '17', '1.5e3', '01', '[1,{"x":2}]',
	    '{"x":1}', "\"\xc3\xa9\"", '"\"q\\"', '"open') }
	    grep { below(2) } qw(id name), '', "a\\u0062", '\u0078';
	@members = sort @members if below(3) == 0;
	my $s = join pick((',') x 9, ', ', ' , '), @members;
	$s =~ s/:/ : /g if below(20) == 0;
	return "{$s}" if below(30);
	return pick(" {$s}", "{ $s }", "{$s", "$s}", "{{$s}}", "[$s]", "{$s} x",
	    "{$s,}", '{}', '{', '{"x":1,"x"}', json_line());
}

# Returns lines, with comments, blank lines, and some that are longer than a loop reads
# at once. The last line has no newline.
sub text_of {
	my ($line) = @_;
	my $s = $line->();
	for (2 .. $lines) {
		$s .= pick(@ends) if below(30) == 0;
		$s .= "\n";
		$s .= below(50) ? $line->() : pick('', ' ', "\r", '# 1 2 3',
		    '  #1,2,3,4', "\t\r");
		$s .= ' ' x (16000 + below(800)) if below(4500) == 0;
		$s .= ',' . '"x",' x 12000 . '1' if below($lines) == 0;
	}
	return $s;
}

# Returns an element of a list, of one line or several.
sub element {
	my @n = map { below(60) ? pick(@usual)->() =~ s/^(-?)0+(?=\d)/$1/r : 'null' } 1 .. 3;
	my $gap = pick('', '', '', ' ', "\n  ", " \r\n\t", "\n\n");
	my $more = pick('', '', ',"a"', ',"]\\"[,"', ',{"b":[1,2]}', ",[\n[]]");
	return "[$gap" . join(",$gap", @n) . "$gap$more]" if below(2);
	return '{' . join(",$gap", '"n":"\\u00e9\\\\"', map { "\"$_\"$gap:" . shift @n }
	    qw(x y z)) . "$gap}" if below(50);
	return pick('5', '"a]"', 'null', '[]', '{}', '[1,2]');
}

# Returns a list with line ends between most of its elements.
sub list_of {
	my $s = "[\n";
	$s .= element() . pick(",\n", ",\n", ",\n ", ',', " , \r\n", "\n,") for 2 .. $lines;
	return $s . element() . "\n]\n";
}

my $scene = '{"convention":"d3d","camera":{"eye":[1,2,-5],"at":[0.1,0.2,0.3]},' .
    '"projection":{"type":"persp","fovy":60,"near":1,"far":10},' .
    '"viewport":{"width":640,"height":480}}';
my $window = '{"center":[0,0],"width":3,"height":2}';
my %line = (text => \&text_line, csv => \&csv_line, json => \&json_line,
    tsv => sub { csv_line() =~ tr/,\t/\t,/r },
    "csv --separator ';'" => sub { csv_line() =~ tr/,;/;,/r },
    'json --columns x,y,z' => \&object_line, objects => \&object_line,
    'text --header' => \&row_of_text, list => \&list_of);

# Returns the output, messages and status of the program for lines of a format.
sub outcome {
	my ($format, $cpu, @options) = @_;
	$format =~ s/objects|list/json/;
	my ($command, $parameters) = @options && $options[0] eq 'w2n' ?
	    (shift @options, $window) : ('project', $scene);
	my ($status, @said) = run("PROJCALC_CPU=$cpu projcalc $command -i $format " .
	    "@options '$parameters' lines", $tmp);
	return join '|', $status, map { sha256_hex($_) } @said;
}

sub options_of {
	my ($format) = @_;
	my @k = '--keep-going';
	return [@k], [], ['-j', 3, @k], ['-H', '--flags', @k], ['-o', 'csv', @k]
	    if $format =~ /columns/;
	return [@k], [], ['w2n', @k], ['--from', 'clip', @k], ['--flags', @k],
	    ['-o', 'csv', @k], ['-o', 'tsv', @k], ['-o', 'json', @k]
	    if $format !~ /^(text|csv|json)$/;
	my @all = ([@k], [], ['-j', 1, @k], ['-j', 3, @k], ['w2n', @k],
	    ['--from', 'clip', @k], ['-H', @k], ['--flags', @k],
	    ['--visible', @k], ['-d', 3, @k], ['-o', 'f64', @k],
	    ['--columns', '2,3,4', @k],
	    ['--columns', '4,1,2', @k], ['--columns', '1,3,2', '--flags', @k]);
	push @all, map { ['-o', $_, @k], ['-o', $_, '--flags', @k],
	    ['-o', $_, '--columns', '3,2,1', @k] } qw(text csv json);
	push @all, ['--ray', @k];
	push @all, ['--columns', 'z,x,y', @k] if $format eq 'csv';
	return @all;
}

# The copies of the loops that this processor can run, other than the scalar code.
my @copies = grep {
	local $ENV{PROJCALC_CPU} = $_;
	system("$build/projcalc w2n '$window' '[]' 2>$tmp/err") == 0;
} qw(avx512 avx2 neon);
my %want = $write ? () :
    reverse slurp($digests) =~ /^(\S+)  (.*)/mg;
my $new = '';
for my $format (sort keys %line) {
	my $head = $format =~ /[ct]sv/ ? "# a comment\nx,y,z,label\n" :
	    $format =~ /header/ ? "x y z label\n" :
	    $format =~ /text/ ? "1 2 3\n" : '';
	$head =~ tr/,/\t/ if $format eq 'tsv';
	$head =~ tr/,/;/ if $format =~ /;/;
	my $text = $format eq 'list' ? list_of() : text_of($line{$format});
	spew("$tmp/lines", "$head$text");
	for my $options (options_of($format)) {
		my $name = "$format @$options";
		my $scalar = outcome($format, 'baseline', @$options);
		my $digest = sha256_hex($scalar);
		$new .= "$digest  $name\n";
		next if $write;
		is($digest, $want{$name}, "$name, baseline");
		is(outcome($format, $_, @$options), $scalar, "$name, $_")
		    for @copies;
	}
}
if ($write) {
	spew($digests, $new);
	exit;
}
done_or('perl cmd/test/lines_test.t -w');
