#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that a file, a pipe and a text in memory give the same bytes and messages,
# wherever the input is cut into pieces.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use IO::Handle;
use IPC::Open2;
use Projcalc;

$ENV{PATH} = "$build:$ENV{PATH}";
chdir 'testdata' or die "testdata: $!\n";
my $project = 'projcalc project --keep-going';

# The size of the first pieces that source.c reads.
my $room = 1 << 15;

# Compares the output for a pipe, a file and a text in memory, with one thread and with
# several.
sub same {
	my ($args, $name, @jobs) = @_;
	my @want = run("cat $tmp/in | $project $args -j1 scene.json -");
	my $bad = '';
	for my $j (@jobs) {
		for my $way ("$project $args -j$j scene.json - <$tmp/in",
		    "cat $tmp/in | $project $args -j$j scene.json -",
		    "cat $tmp/in | $project $args -j$j --scenes scene.json -") {
			my @got = run($way);
			$got[2] =~ s/scene 1, line 1: //g;
			$bad = $way if "@got" ne "@want";
		}
	}
	is($bad, '', $name);
	return @want;
}

# Returns a line of n bytes with its newline, and with a number after the point.
sub line_of {
	my ($n, $i) = @_;
	my $line = "0 0 $i ";
	return $line . 'a' x ($n - 1 - length $line) . "\n";
}

# Lines that end just before, at and just after the end of a read.
srand 5;
for my $at ($room - 1 .. $room + 1, 2 * $room - 1 .. 2 * $room + 1) {
	my $text = '';
	for (my $i = 0; ; $i++) {
		my $n = 12 + int rand 60;
		my $left = $at - length $text;
		$text .= line_of($left < 100 ? $left : $n, $i);
		last if $left < 100;
	}
	spew("$tmp/in", $text . "0 0 bad\n" . ("0 0 1\n" x 30000) . '1 1 1');
	my @said = same('', "a line ends at byte $at", 2, 3);
	my $n = 1 + ($text =~ tr/\n//);
	like($said[2], qr/\Aprojcalc: -:$n:5: z is 'bad'/, 'the line number');
	spew("$tmp/in", $text);
	same('', "and nothing is after it", 2);
}

# Several lines that are longer than a piece.
for my $n ($room - 2 .. $room + 2, 2 * $room, 5 * $room + 77) {
	spew("$tmp/in", line_of(9, 1) . line_of($n, 2) . line_of(30, 3) .
	    line_of($n, 4) . "5 6\n" . line_of(70, 5) x 4000);
	same('', "lines of $n bytes", 1, 2, 4);
	spew("$tmp/in", line_of($n, 1) =~ tr/\n//dr);
	same('', "a line of $n bytes alone, without its newline", 2);
}

# Each format, with inputs of random sizes.
my @points = map { [map { 1e-4 * int rand 4e4 } 1 .. 3] } 1 .. 40000;
for my $n (map { 9000 + int rand 31000 } 1 .. 4) {
	my @some = @points[0 .. $n];
	my $text = join '', map { join(' ', @$_) . "\n" } @some;
	my $csv = $text =~ tr/ /,/r;
	spew("$tmp/in", $text);
	same('', "$n lines of text", 1, 2, 16, 64);
	same('--visible --flags', 'some of them', 3);
	spew("$tmp/in", "# a comment\n\nid,x,y,z\n" . $csv =~ s/^/1,/mgr);
	same('-i csv --columns x,y,z', "$n lines of csv", 1, 2, 5);
	spew("$tmp/in", ("# comments\n" x 30000) . "x,y,z\n$csv");
	same('-i csv', 'a header that is late', 2);
	spew("$tmp/in", $csv =~ s/^(.*)$/[$1,"a"]/mgr);
	same('-i json', "$n lines of JSON", 1, 2, 5);
	my $f64 = pack 'd<*', map { @$_ } @some;
	spew("$tmp/in", $f64 . 'rest');
	same('-i f64', "$n binary points and 4 bytes", 1, 2, 5);
	same('-i f64 -o text', 'as text', 2);
	spew("$tmp/in", pack 'f<*', map { @$_ } @some);
	same('-i f32', "$n points of floats", 1, 2, 5);
}

# Writes the parts of a text to a pipe, each when the program has read those before.
# Returns status, output and messages.
sub dripped {
	my ($args, @parts) = @_;
	open my $to, '|-', "exec projcalc project --keep-going $args scene.json - " .
	    ">$tmp/out 2>$tmp/said" or die;
	$to->autoflush;
	local $SIG{PIPE} = 'IGNORE'; # the program may stop before the last part
	for my $i (0 .. $#parts) {
		select undef, undef, undef, 0.004 if $i > 0;
		syswrite $to, $parts[$i];
	}
	close $to;
	return ($? >> 8, slurp("$tmp/out"), slurp("$tmp/said"));
}

# What an earlier piece has left behind a last line without newline is not read.
my ($commas, $blanks) = (',' x 90, ' ' x 40);
my ($first, $last) = (qq({"x":0,"y":1,"z":0,"n":"$commas"}), qq({"x":0,"y":1,"z":0$blanks}));
my @ended = run("{ echo '$first'; sleep 0.1; printf '$last'; } | " .
    "timeout 20 $project -i json --append --to world {} -");
my $added = ',"world_x":0,"world_y":1,"world_z":0';
is($ended[1], join("\n", map { s/(?= *}$)/$added/r } $first, $last),
    '--append ends at the last line');

# What is printed does not depend on how input arrives: each text whole, cut into two at
# each byte or before each line, and a line at a time.
my $npy = "\x93NUMPY\1\0v\0{'descr': '<f8'}\n";
my $at_once = "\x93NUMPY\1\0\n\0{'descr': '<f8'}\n";
for (['-i csv', "x,y,z\n1,2,3,4\n"], ['-i csv', "# a\nx,y,z\n\n1,2,3\n"],
    ['-i csv', "#x,y\n# a\n1,2,3\n4,5\n"], ['-i csv', "# a,b,c\n1,2,3\n"],
    ['-i csv', "id,x,y,z\n7,1,2,3\n"], ['', "# id x y z\n7 1 2 3\n"],
    ['', "\n# a\n"], ['', "1 2 3\n# a\0\n4 5 6\0\n7 8 9\n"],
    ['-i json', "# a\n\n[1,2,3]\n{}\n"], ['', $npy], ['', $at_once],
    ['', "\x93NUM\n1 2 3\n"], ['', "PK\n1 2 3\n"],
    ['-i csv', "\xef\xbb\xbfx,y,z\n1,2,3\n"], ['', "OFF\n1 2 3\n"],
    ['', "\xef\xbb\xbf# a\n\nx y z n\n1 2 3 a\n1 2 3\n"], ['', "x,y,z\n1,2,3\n4,5,6,\n"],
    ['', "1\t2\t3\n"], ['', "{\"X\":1,\"Y\":2,\"Z\":3}\n"], ['', "# a\n[[1,2,3], [4,5,6]]\n"],
    ['', "[\n {\"x\":1,\n  \"y\":2,\"z\":\"\\\"]\"},\r\n [1,2,\n3],5\n]\n"],
    ['', "[[1,2,3],\n[4,5,6]x\n"], ['', "[[1,2,3],[4,5\n"],
    ['', "\xef\xbb\xbf# a\n[[1,2,3],\n{\"x\":1,\n\"y\":2}]\n"], ['-i obj', "v 1 2 3\nf 1 2 3\n"],
    ['-o csv', "1 2 3\n"]) {
	my ($args, $text) = @$_;
	my @want = dripped($args, $text);
	my $bad = '';
	my @lines = $text =~ /.*\n/g;
	my @cuts = map { [substr($text, 0, $_), substr($text, $_)] }
	    1 .. length($text) - 1;
	for my $parts (@cuts, \@lines) {
		my @got = dripped($args, @$parts);
		$bad .= ' ' . length $parts->[0] if "@got" ne "@want";
	}
	is($bad, '', "$args: arrives in parts: " . substr $lines[0], 0, -1);
}

# 100,000 bytes of comments, which wait for a format that is not known.
my $comments = "# a comment\n" x 9000;
is((dripped('', $comments, "1 2 x\n"))[1], "${comments}nan nan nan\n",
    'comments above a bad row');
is((dripped('', $comments, "[1,2,3]\n"))[1], (dripped('', "[1,2,3]\n"))[1],
    'comments above JSON');

# A complete line is answered before the next one arrives, a header and an element, too.
for (['', "x,y,z\n", "x,y,z\n", '0,0,%d', '320,240,'],
    ['-i csv', "# a\n", "# a\n", '0,0,%d', '320,240,'],
    ['', "# a\nx y z\n", "# a\nx y z\n", '0 0 %d', '320 240 '],
    ['', "[\n[0,0,0]\n", "[320,240,0.8888888888888888]\n", ',[0,0,%d]', '[320,240,'],
    ['-o csv', '', "x,y,z\n", '0 0 %d', '320,240,']) {
	my ($args, $sent, $wanted, $row, $answer) = @$_;
	my $pid = open2(my $from, my $to, "projcalc project $args scene.json - 2>/dev/null");
	my $bits = '';
	vec($bits, fileno $from, 1) = 1;
	syswrite $to, $sent;
	if ($sent ne '') {
		is(select(my $is = $bits, undef, undef, 20), 1, 'what is complete');
		sysread $from, my $line, 1000;
		is($line, $wanted, 'is answered at once');
	}
	for my $i (1 .. 3) {
		syswrite $to, sprintf "$row\n", $i;
		is(select(my $is = $bits, undef, undef, 20), 1, "row $i");
		sysread $from, my $line, 1000;
		$line =~ s/\A\Q$wanted\E// if $i == 1; # a header, read alone or not
		sysread $from, $line, 1000 if $line eq '';
		like($line, qr/\A\Q$answer\E/, 'is answered at once');
	}
	close $to;
	waitpid $pid, 0;
}

# Runs of --lines, of which some are longer than a piece, with what ends them.
for my $ends (20, 2000, 50000) {
	my $text = join '', map { my $end = int rand $ends;
		($end == 0 ? "\n" : $end == 1 ? "nan 0 0\n" : $end == 2 ? "bad\n" : '') .
		sprintf("%g %g %g\n", map { 1e-3 * int rand 1e4 - 5e3 } 1 .. 3) }
	    1 .. 20000;
	spew("$tmp/in", $text);
	my @said = same('--lines -q', "runs, one in $ends lines ends", 2, 16);
	ok(length $said[1] > 10000, 'have parts');
}

# A run is kept until it ends, and then answered before the next one arrives.
{
	my $pid = open2(my $from, my $to, 'projcalc project --lines scene.json -');
	my $bits = '';
	vec($bits, fileno $from, 1) = 1;
	for my $run (1 .. 3) {
		syswrite $to, "0 0 0\n1 0 $run\n";
		is(select(my $is = $bits, undef, undef, 0.2), 0, "run $run is kept");
		syswrite $to, "\n";
		is(select($is = $bits, undef, undef, 20), 1, 'until a blank line');
		sysread $from, my $lines, 1000;
		like($lines, $run == 1 ? qr/\A320 .*\n\d.*\n\z/ :
		    qr/\A\n320 .*\n\d.*\n\z/, 'is answered whole');
	}
	close $to;
	waitpid $pid, 0;
}

# The offset of a file before and after it is read.
my $lines = join '', map { line_of(20 + $_ % 50, $_) } 1 .. 9000;
spew("$tmp/in", "0 0 first\n$lines");
my $offset = '{ read line; projcalc project -j2 scene.json - | tail -n 1; ' .
    'cat; }';
my @said = run("$offset <$tmp/in");
my @want = run("tail -n +2 $tmp/in | projcalc project scene.json - |" .
    'tail -n 1');
is("@said", "@want", 'a file from the second line on, left at its end');

# A file that changes while the threads wait for a reader of the output, long before the
# file's end. Lines that are added are read, and lines that are cut off are not.
my $long = join '', map { "0 0 $_\n" } 1 .. 400000;
my $start = substr $long, 0, 4000000;
for (['grows', "$long-1 -1 -1\n", sub {
	open my $to, '>>', "$tmp/in" or die;
	print $to "-1 -1 -1\n";
	close $to;
}], ['shrinks', $start, sub { truncate "$tmp/in", length $start }]) {
	my ($name, $left, $change) = @$_;
	spew("$tmp/in", $left);
	my ($status, $want) = run("projcalc project -j1 scene.json $tmp/in");
	for my $j (1, 2, 4) {
		spew("$tmp/in", $long);
		open my $from, '-|', "exec projcalc project -j$j scene.json " .
		    "$tmp/in" or die;
		sysread $from, my $first, 1;
		select undef, undef, undef, 0.1;
		$change->();
		local $/;
		ok($first . <$from> eq $want, "a file that $name, -j$j");
	}
}

# At most one thread for each processor is started, whatever -j says. Here all of them
# wait for a reader of the output.
sub threads_of {
	my ($pid) = @_;
	open my $status, '<', "/proc/$pid/status" or die;
	return join('', <$status>) =~ /^Threads:\s*(\d+)/m ? $1 : 0;
}

sub started_max {
	my ($wanted, @on) = @_;
	my $pid = open my $from, '-|', @on, 'projcalc', 'project', '-j64',
	    'scene.json', "$tmp/in" or die;
	sysread $from, my $all, 1 << 16 for 1 .. 10; # some of the output of the first piece
	my $left = 200;
	while (threads_of($pid) < $wanted && $left-- > 0) {
		select undef, undef, undef, 0.01;
	}
	select undef, undef, undef, 0.05; # time in which more threads might start
	my $threads = threads_of($pid);
	kill 'TERM', $pid;
	close $from;
	return $threads;
}

SKIP: {
	open my $status, '<', "/proc/$$/status" or skip 'no /proc', 1;
	my $allowed = join '', <$status>;
	my ($cpus) = $allowed =~ /^Cpus_allowed:\s*(\S+)/m;
	my $n = grep { $_ } map { split //, sprintf '%b', hex } split /,/, $cpus;
	spew("$tmp/in", "0 0 1\n" x 1000000);
	is(started_max($n), $n, 'threads of -j64');
	skip 'no taskset', 2 if missing('taskset');
	my ($first) = $allowed =~ /^Cpus_allowed_list:\s*(\d+)/m;
	is(started_max(1, 'taskset', '-c', $first), 1,
	    'threads of -j64 where one processor is allowed');
	is((run("taskset -c $first projcalc project -j64 scene.json $tmp/in " .
	    "$tmp/in | wc -l"))[1], "2000000\n", 'which do all, of two files');
}
# Ten bad lines are told, and whatever ends the input, however many were bad before it.
for my $bad (9 .. 12) {
	my $last = $bad + 3;
	spew("$tmp/in", "0 0 1\n" . "0 0 bad\n" x $bad . "0 0 2\n\0\n0 0 3\n");
	my @said = same('', "binary input after $bad bad lines", 2);
	like($said[2], qr/^projcalc: -:$last:1: is binary.*\n\z/m, 'which is told');
	is($said[2] =~ tr/\n//, ($bad > 10 ? 10 : $bad) + 1, 'and ten bad lines');
}

# --progress counts from the offset at which reading begins, not from byte 0.
spew("$tmp/in", "0 0 0\n" x 100000);
like((run("(dd bs=300000 count=1 >$tmp/first 2>$tmp/told; projcalc project " .
    "--progress scene.json - ) <$tmp/in"))[2], qr/ 50000 lines, .*, 100 %\n\z/,
    'the share of a file that is read from its middle');
done_testing();
