#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks csv and JSON against other readers of them, on random files: Python's csv and
# json, and jq. The scene adds 100, 200 and 300 to a point, so that it is known what each
# field of the output has to be: the same as that of the input, but for the coordinates.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

my $lacks = missing('python3', 'jq');
plan skip_all => "no $lacks" if $lacks;

my $call = q(projcalc project -q --to world '{"world":[{"translate":[100,200,300]}]}');

# Adds to the coordinates of each row, in the columns that the arguments after the
# separator name, and prints all fields of each row without blanks around them.
my $csv = <<'END';
import csv, json, sys
add = dict(zip(map(int, sys.argv[2:]), (100, 200, 300)))
for row in csv.reader(sys.stdin, delimiter=sys.argv[1], skipinitialspace=True):
    row = [field.strip(' ') for field in row]
    try:
        for i, n in add.items():
            row[i] = repr(float(row[i]) + n).replace('.0', '')
    except ValueError:
        pass
    print(json.dumps(row))
END

# Prints each line that is an object with x, y and z, with 100, 200 and 300 added, and
# null for each other line. JSON is read strictly, and numbers exactly.
my $json = <<'END';
import json, sys
from fractions import Fraction
class Number(str): pass
def constant(word): raise ValueError
def members(pairs):
    if sum(name in ('x', 'y', 'z') for name, _ in pairs) > 3: raise ValueError
    return dict(pairs)
def outermost(line):
    o = json.loads(line.decode(), object_pairs_hook=list, parse_constant=constant,
        parse_int=Number, parse_float=Number)
    names = [name for name, _ in o] if o and all(
        isinstance(m, tuple) for m in o) else []
    return dict(o) if all(names.count(c) == 1 for c in 'xyz') else None
def added(line, add):
    try:
        o = outermost(line)
        for c, n in zip('xyz', (100, 200, 300)):
            if not isinstance(o[c], Number) or abs(float(o[c])) > 1e150: return None
            o[c] = float(Fraction(float(o[c])) + (n if add else 0))
        return o
    except (ValueError, TypeError, RecursionError):
        return None
for line in sys.stdin.buffer.read().split(b'\n'):
    print(json.dumps(added(line, sys.argv[1] == 'add')))
END

# Returns the output of a shell command in $tmp; it has to succeed.
sub output {
	my ($command, $allowed) = @_;
	my ($status, $out, $err) = run($command, $tmp);
	$status <= ($allowed // 0) or diag("$command: $status\n$err");
	return $out;
}

# Names the first line that differs.
sub same_lines {
	my ($said, $wanted, $name, $file) = @_;
	return if ok($said eq $wanted, $name);
	my @said = split /\n/, $said;
	my @wanted = split /\n/, $wanted;
	my @line = split /\n/, slurp("$tmp/$file");
	my $i = 0;
	$i++ while $i < @said && $i < @wanted && $said[$i] eq $wanted[$i];
	diag('line ', $i + 1, ': ', $line[$i] // '', "\nsaid ", $said[$i] // '',
	    "\nand not ", $wanted[$i] // '');
}

sub number { below(2001) - 1000 }
sub blanks { pick(('') x 8, ' ', '  ') }

my @texts = ('', 'a', 'two words', "it's", '5" pipe', 'a#', "\xc3\xa9", '1e5', 'x=1', "\t");

# Returns a field of csv that is no coordinate.
sub csv_field {
	my ($separator) = @_;
	return pick(grep { $_ ne $separator } @texts) if below(2);
	return '"' . join('', map { s/"/""/gr } map { pick(@texts, $separator, '"') }
	    1 .. below(4)) . '"' .
	    pick(('') x 6, 'b', 'b"');
}

# Writes a file of csv, and returns the columns of x, y and z.
sub csv_file {
	my ($separator, $header) = @_;
	my $fields = 3 + below(4);
	my @at = $header ? (sort { $a->[0] <=> $b->[0] } map { [below(1e6), $_] }
	    0 .. $fields - 1)[0 .. 2] : map { [0, $_] } 0 .. 2;
	my @column = map { $_->[1] } @at;
	my %is_coordinate = map { $column[$_] => $_ } 0 .. 2;
	my $end = pick("\n", "\r\n");
	my $text = $header ? join($separator, map {
	    my $i = $is_coordinate{$_};
	    blanks() . (defined $i ? pick(qw(x y z)[$i], '"' . qw(X Y Z)[$i] . '"') :
	    pick("n$_", "\"n$separator$_\"")) . blanks() } 0 .. $fields - 1) . $end : '';
	for (1 .. 300) {
		$text .= join($separator, map { blanks() . (exists $is_coordinate{$_} ?
		    pick(number(), number(), '"' . number() . '"') :
		    csv_field($separator)) . blanks() } 0 .. $fields - 1) . $end;
	}
	spew("$tmp/points", $text);
	return @column;
}

for my $run (1 .. 8) {
	my $separator = pick(',', ',', ';', "\t");
	my $header = $run % 2;
	my @column = csv_file($separator, $header);
	my $option = $separator eq ',' ? '-i csv' : $separator eq ';' ?
	    "--separator ';'" : '-i tsv';
	my $reader = "python3 -c '" . ($csv =~ s/'/'\\''/gr) . "' '$separator'";
	output("$call $option points >out");
	same_lines(output("$reader <out"), output("$reader @column <points"),
	    "csv $run: python's csv", 'points');
}

my $line_end = ''; # or what may stand between the parts of a list
sub space { pick(('') x 5, ' ', "\t", $line_end) }

my @strings = ('', 'a', '\\"', '\\\\', '}', ']', '[{', ',', ':', '\\u00e9', "\xc3\xa9",
    '\\ud83d\\ude00', '\\n', '#');
sub string { join '', '"', map({ pick(@strings) } 1 .. below(4)), '"' }

# Returns any value of JSON.
sub value {
	my ($level) = @_;
	my $kind = below($level > 0 ? 7 : 5);
	return string() if $kind < 2;
	return pick('true', 'false', 'null', '0', '-1.5', '2e3', '1.25E-2') if $kind < 5;
	my @values = map { space() . value($level - 1) . space() } 1 .. below(4);
	return '[' . join(',', @values) . ']' if $kind == 5;
	my $n = 0;
	return '{' . join(',', map { space() . '"m' . $n++ . '":' . $_ } @values) . '}';
}

# Returns an object with x, y and z, in any order, between other members.
sub object {
	my @members = map { my $c = $_;
	    [below(1e6), pick("\"$c\"", "\"$c\"", sprintf '"\\u%04x"', ord $c) .
	    space() . ':' . space() . pick(number(), number() . '.5', number() . 'e2')]
	    } qw(x y z);
	push @members, map { [below(1e6), "\"m$_\":" . value(3)] } 1 .. below(4);
	my @sorted = map { $_->[1] } sort { $a->[0] <=> $b->[0] } @members;
	return '{' . join(',', map { space() . $_ . space() } @sorted) . '}';
}

for my $run (1 .. 4) {
	spew("$tmp/points", join '', map { object() . "\n" } 1 .. 200);
	$line_end = pick("\n", "\r\n", " \n\n\t");
	spew("$tmp/list", '[' . space() .
	    join(space() . ',' . $line_end, map { object() } 1 .. 200) . $line_end . ']');
	$line_end = '';
	spew("$tmp/pretty", output('jq -s . points'));
	my $add = '.x += 100 | .y += 200 | .z += 300';
	my $wanted = output("jq -cS '$add' points");
	for my $file (qw(points pretty list)) {
		$wanted = output("jq -cS '.[] | $add' list") if $file eq 'list';
		output("$call -i json $file >out");
		same_lines(output('jq -cS . out'), $wanted, "JSON $run: jq, $file", $file);
	}
}

# Lines with bytes that are wrong, left out or moved: both readers accept the same.
my @bytes = (split(//, '{}[]",:\\ -+.e019ntx'), "\t", "\x01", "\xe9", "\x7f", "\xc3");
for my $run (1 .. 4) {
	my $text = object() . "\n"; # a control character in the first line ends a run
	for (1 .. 500) {
		my $line = object();
		my ($at, $byte) = (below(length $line), pick(@bytes));
		substr $line, $at, below(3), pick($byte, $byte, '');
		$text .= "$line\n";
	}
	spew("$tmp/points", $text);
	my $reader = "python3 -c '" . ($json =~ s/'/'\\''/gr) . "'";
	output("$call -i json --keep-going points >out 2>said", 1);
	same_lines(output("$reader same <out"), output("$reader add <points"),
	    "JSON $run: python's json", 'points');
}
done_testing();
