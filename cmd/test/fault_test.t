#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks the program when the system fails: no memory, a full disk, reads and writes
# that are short, interrupted or fail, closed pipes, a reader that waits for its answer,
# input that is huge, cut off or not a file.
use strict;
use warnings;
use FindBin;
use IO::Handle;
use IPC::Open2;
use POSIX ':sys_wait_h';
use Time::HiRes 'sleep';
use lib $FindBin::Bin;
use Projcalc;

my $shim = "$tmp/shim.so";
$ENV{PATH} = "$build:$ENV{PATH}";
chdir 'testdata' or die "testdata: $!\n";
# A shell makes programs in the background ignore SIGINT.
$SIG{INT} = 'DEFAULT';

# A sanitizer has its own allocator, and fails with a limit of memory; code that counts
# coverage allocates, too.
my $plain = system("grep -q '__asan_init\\|__gcov' $build/projcalc") != 0;
my $has_shim = $plain && system("cc -O1 -shared -fPIC -o $shim " .
    "$top/cmd/test/fault_shim.c 2>$tmp/err") == 0;

# Runs a command with a fault in the calls of the command, not of the shell.
sub faulty {
	my ($command, $fault) = @_;
	return run("LD_PRELOAD=$shim FAULT='$fault' $command");
}

sub is_run {
	my ($command, $status, $out, $err, $name) = @_;
	my @said = run($command);
	is("@said[0, 2]", "$status $err", $name // $command);
	is($said[1], $out, 'its output') if defined $out;
}

sub starts { substr($_[0], 0, length $_[1]) eq $_[1] }

# Points for several chunks, in each format.
srand 7;
my $lines = join '', map {
	join(' ', map { 1e-4 * int rand 4e4 } 1 .. 3) . "\n"
} 1 .. 20000;
my $few = join '', (split /^/, $lines)[0 .. 1999];
spew("$tmp/points", $lines);
spew("$tmp/points.csv", "x,y,z\n" . $lines =~ tr/ /,/r);
spew("$tmp/few", $few);
spew("$tmp/few.csv", "x,y,z\n" . $few =~ tr/ /,/r);
spew("$tmp/few.json", $few =~ tr/ /,/r =~ s/^(.*)$/[$1]/mgr);
spew("$tmp/few.f64", pack 'd<*', split ' ', $few);
spew("$tmp/points.f64", pack 'd<*', split ' ', $lines);
spew("$tmp/piece", join '', (split /^/, $few)[0 .. 299]); # pick sorts what one piece has
spew("$tmp/bad", "$few# no point\n1 2\n$few");
spew("$tmp/scenes", slurp('scene.json') x 3);
my $project = 'projcalc project scene.json';

my @commands = (
	'projcalc lookat scene.json', 'projcalc help',
	'projcalc persp -c d3d -o json \'{"type":"persp","fovy":60,"aspect":1,' .
	    '"near":1,"far":10}\'',
	'projcalc project points.json', "$project -j1 $tmp/few", "$project -j2 $tmp/points",
	"$project -j2 -i csv -o json --flags $tmp/points.csv",
	"projcalc pick --at 320,240 --radius 1e5 scene.json $tmp/piece",
	'projcalc inspect scene.json', 'projcalc help --json', 'projcalc help camera',
	"projcalc lookat --scenes $tmp/scenes",
	"$project -j2 --scenes --keep-going -o json $tmp/scenes $tmp/few" =~
	    s/ scene.json//r,
	"projcalc trace -j2 scene.json $tmp/few",
);

# Runs a command again and again: first its first call fails, then its second, until the
# command makes no more calls.
sub every {
	my ($call, $errno, $command, $check) = @_;
	my ($status, $whole) = run($command);
	my ($bad, $n) = ('', 0);
	while ($bad eq '') {
		my @said = faulty($command, "$call " . ++$n . " $errno");
		last if $said[0] == $status && $said[1] eq $whole &&
		    $said[2] eq '';
		$bad = "$n: @said[0, 2]" if !$check->($whole, @said);
	}
	$bad = 'none' if $n == 1 && $call =~ /write|close/;
	is($bad, '', "$call: $command");
}

# Checks for exit status 3, one line of error, and the beginning of the right output.
sub system_failed {
	my ($reason) = @_;
	return sub {
		my ($whole, $status, $out, $err) = @_;
		return $status == 3 && starts($whole, $out) &&
		    $err =~ /\Aprojcalc: (?:scene \d, line \d+: )?$reason\n\z/;
	};
}

# Checks --progress with a clock that advances by $clock milliseconds for each file of
# 1000 lines. The first report is due after half a second, others every fifth of a
# second.
sub told {
	my ($clock, $terminal, $args) = @_;
	my $file = "$tmp/thousand";
	spew($file, "0 0 0\n" x 1000);
	my @said = faulty("$project -j1 $args $file $file $file - $file " .
	    "$file $file <$file", "clock $clock $terminal");
	return $said[2] =~ s/\r\e\[K/</gr;
}

sub line_at {
	my ($thousands, $seconds) = @_;
	return sprintf 'projcalc: %d lines, %.3g a second, 100 %%',
	    1000 * $thousands, 1000 * $thousands / $seconds;
}

sub progress {
	my @seen = map { line_at($_, $_ * 0.25) } 3 .. 7;
	my $end = line_at(7, 2);
	is(told(150, 0, '--progress'), join("\n", line_at(4, 0.6),
	    line_at(6, 0.9), line_at(7, 1.2), ''), 'progress, as lines');
	is(told(250, 0, '--progress'), join("\n", @seen, $end, ''),
	    'progress, not before half a second');
	is(told(250, 0, ''), '', 'progress nobody asked for');
	is(told(250, 1, ''), join('', map { "<$_" } @seen, ''),
	    'progress in a terminal, which is cleared in the end');
	is(told(250, 1, '--progress'), join('', map { "<$_" } @seen, "$end\n"),
	    'progress in a terminal, which stays');
	is(told(250, 2, ''), '', 'no progress where output is in the terminal');
	is(told(250, 2, '--progress'),
	    join('', map { "<$_" } @seen, "$end\n"), 'but where it is wanted');
	my $bad = (faulty("$project -j1 --color never --keep-going $tmp/thousand " .
	    "$tmp/thousand $tmp/thousand $tmp/bad", 'clock 250 1'))[2];
	like($bad, qr/\d+ %\r\e\[Kprojcalc: [^\r\n]*:2002:4: [^\r\n]*\n\r\e/,
	    'a complaint takes the place of progress');
	is((faulty("$project -j1 --progress -", 'clock 250 0'))[2],
	    "projcalc: 0 lines, 0 a second\n", 'a device has no share');
	shares();
}

# Checks the shares that --progress prints, which begin again with each file.
sub shares {
	my $n = 60000;
	spew("$tmp/lines", "0 0 0\n" x $n);
	my $said = (faulty("$project -j1 --progress $tmp/lines $tmp/lines",
	    'clock 600 0'))[2];
	my @told = $said =~ /: (\d+) lines/g;
	my @shares = map { sprintf '%.0f', 100 * ($_ % $n || $n) / $n } @told;
	is(join(' ', $said =~ /, (\d+) %/g), "@shares", 'shares');
	cmp_ok(@told, '>', 5, 'some of them of parts');
}

SKIP: {
	skip 'nothing can be preloaded', 1 if !$has_shim;
	for my $command (@commands) {
		every('malloc', 12, $command, system_failed('out of memory'));
		every('write', 28, $command,
		    system_failed('standard output: No space left on device'));
		every('close', 5, $command,
		    system_failed('standard output: Input/output error'));
		every('read', 5, $command,
		    system_failed('[^ ]*: Input/output error'));
		every('open', 24, $command, sub {
			my ($whole, $status, $out, $err) = @_;
			return $status == 2 &&
			    $err =~ /\Aprojcalc: .*: Too many open files\n\z/;
		});
	}
	# 1000 bytes end within a point and within a line
	every('torn', 5, "$project -j1 $_",
	    system_failed('[^ ]*: Input/output error'))
	    for "$tmp/points", "-i f64 $tmp/points.f64",
	    "--keep-going -i f64 $tmp/points.f64";
	my ($status, $whole) = run("$project -j2 $tmp/points");
	my @alone = faulty("$project -j2 $tmp/points", 'thread 1 11');
	is_deeply(\@alone, [0, $whole, ''], 'without the second thread');
	my @asked = faulty("$project -j2 $tmp/points", 'stack 1000000');
	is_deeply(\@asked, [0, $whole, ''], 'threads ask for a stack of 1 MB');
	for my $j (1, 2) {
		for my $args ("$tmp/few", "$tmp/points", "-i csv $tmp/few.csv",
		    "-i json --flags $tmp/few.json", "-i f64 $tmp/few.f64",
		    "--keep-going $tmp/bad", "$tmp/bad") {
			my @whole = run("$project -j$j $args");
			my @said = faulty("$project -j$j $args", 'short');
			is_deeply(\@said, \@whole, "short calls: -j$j $args");
		}
	}
	for my $n (1 .. 4) {
		spew("$tmp/cut", $lines);
		my ($status, $out) = faulty("$project -j2 $tmp/cut",
		    "cut $n $tmp/cut");
		ok(($status == 0 || $status == 1) && starts($whole,
		    $out =~ s/[^\n]*\n?\z//r), "a file that is cut, $n");
	}
	progress();
}

# A full disk, and closed standard streams.
for my $command (@commands) {
	my ($status, $out, $err) = run("$command >/dev/full");
	is("$status $err", "3 projcalc: standard output: No space left on " .
	    "device\n", "full: $command");
	($status, $out, $err) = run("$command >&-");
	is("$status $err", "3 projcalc: standard output: Bad file " .
	    "descriptor\n", "closed: $command");
}
is_run("$project - <&-", 2, '', "projcalc: -: Bad file descriptor\n");
is_run("$project $tmp/bad 2>&-", 1, undef, '');
is_run("projcalc lookat . ", 2, '', "projcalc: .: is a directory\n");
is_run("$project $tmp/few .", 2, '', "projcalc: .: is a directory\n");
is_run("$project - <.", 2, '', "projcalc: -: is a directory\n");
is_run("$project $tmp/none", 2, '',
    "projcalc: $tmp/none: No such file or directory; " .
    "POINTS are a file, - or '[1.5,2,3]'\n");
my (undef, $image) = run("$project $tmp/few");
is_run("mkfifo $tmp/fifo; cat $tmp/few >$tmp/fifo & $project $tmp/fifo; wait",
    0, $image, '', 'a FIFO');

for my $j (1, 2) {
	is_run("yes 0 0 0 | { $project -j$j -; echo \$? >&2; } | head -n 1",
	    0, "320 240 0.8888888888888888\n", "141\n", "SIGPIPE -j$j");
}

# Checks that each line is answered before the next is sent.
sub answers {
	my ($args, $ask, $answer) = @_;
	my $pid = open2(my $from, my $to, "exec $project $args 2>/dev/null");
	binmode $_ for $from, $to;
	my $said = '';
	local $SIG{ALRM} = sub { kill 'KILL', $pid };
	alarm 10;
	for (1 .. 3) {
		syswrite $to, $ask;
		my $got = '';
		while (length $got < length $answer) {
			sysread($from, $got, length($answer) - length $got,
			    length $got) or last;
		}
		$said .= $got;
	}
	close $to;
	waitpid $pid, 0;
	alarm 0;
	is($said, $answer x 3, "an answer at once: $args");
}

for my $j (1, 2) {
	my $y = '240 0.8888888888888888';
	answers("-j$j -", "0 0 0\n", "320 $y\n");
	answers("-j$j -i csv -", "0,0,0\n", "320,$y\n" =~ tr/ /,/r);
	answers("-j$j -i json -", "[0,0,0]\n", "[320,$y]\n" =~ tr/ /,/r);
	answers("-j$j -i f64 -o text -", pack('d<3', 0, 0, 0), "320 $y\n");
	answers("-j$j --flags --keep-going -", "0 0\n", "nan nan nan nan\n");
}

# A writer stalls in the middle of a line, and a signal arrives meanwhile.
for my $j (1, 2) {
	my $pid = open2(my $from, my $to, "exec $project -j$j -");
	alarm 10;
	for my $part ("0 0", " 0\n1", " 1 1\n0 ") {
		syswrite $to, $part;
		sleep 0.05;
	}
	kill 'STOP', $pid;
	kill 'CONT', $pid;
	my $said = '';
	while ($said =~ tr/\n// < 2) {
		sysread($from, $said, 4096, length $said) or last;
	}
	kill 'INT', $pid;
	waitpid $pid, 0;
	alarm 0;
	is(($? & 127) . " $said", "2 320 240 0.8888888888888888\n" .
	    "389.2820323027551 170.71796769724492 0.9259259259259259\n",
	    "a writer that stalls, SIGINT: -j$j");
}

# The reader of the output stops for a while.
my (undef, $whole) = run("$project $tmp/points");
for my $j (1, 2) {
	my $pid = open2(my $from, my $to,
	    "cat $tmp/points $tmp/points $tmp/points | $project -j$j -");
	close $to;
	sleep 0.3;
	local $/;
	is(<$from>, $whole x 3, "a reader that stops for a while: -j$j");
	waitpid $pid, 0;
}

# Pipes in the mode O_NONBLOCK, set by another process, which hold less than the output.
use constant F_SETPIPE_SZ => 1031;
my $help = (run('projcalc help --json'))[1];
for (["$project -j1 -", $whole], ["$project -j2 -", $whole],
    ['projcalc help --json', $help]) {
	my ($command, $want) = @$_;
	pipe my $in, my $to;
	pipe my $from, my $out;
	$_->blocking(0) for $in, $out;
	fcntl $out, F_SETPIPE_SZ, 4096;
	my $pid = fork // die "fork: $!\n";
	if ($pid == 0) {
		open STDIN, '<&', $in;
		open STDOUT, '>&', $out;
		close $_ for $to, $from, $in, $out;
		exec split ' ', $command;
	}
	close $_ for $in, $out;
	if (fork == 0) {
		close $from;
		local $SIG{PIPE} = 'IGNORE';
		sleep 0.1;
		print $to $lines;
		close $to;
		POSIX::_exit(0);
	}
	close $to;
	sleep 0.3;
	local $/;
	is(<$from>, $want, "pipes that do not wait: $command");
	waitpid $pid, 0;
	is($?, 0, 'its status');
}

# A file name of 4000 characters is shown whole, also at the end of a message.
my $long = "$tmp/" . './' x 1900 . 'points.csv';
spew($long, "0,0,-9\n");
is((run("projcalc project -i csv scene.json $long >/dev/null"))[2],
    "projcalc: 1 point is behind the camera and has no image: $long:1\n", 'a long name');

# Returns the peak of a command's resident memory in kilobytes, read while the command
# runs, for which its input is long enough. Returns 1e9 if its exit status is not $end.
sub peak {
	my ($command, $end) = (@_, 0);
	my ($peak, $pid) = (0, fork // die "fork: $!\n");
	if ($pid == 0) {
		open $_, '>', '/dev/null' for *STDOUT, *STDERR;
		exec split ' ', $command;
	}
	while (waitpid($pid, WNOHANG) == 0) {
		if (open my $status, '<', "/proc/$pid/status") {
			/^VmHWM:\s+(\d+)/ and $peak = $1 for <$status>;
		}
		sleep 0.002;
	}
	return $? == $end << 8 ? $peak : 1e9;
}

sub sparse {
	my ($name, $size) = @_;
	spew($name, '');
	truncate $name, $size or die "$name: $!\n";
}

SKIP: {
	skip 'a sanitizer needs memory', 1 if !$plain;
	my $limit = 'ulimit -v 600000;';
	my $long = qr/:1: a line of more than 64 MiB\n\z/;
	my ($status, $out, $err) = run("$limit perl -e 'print q(0) x 1e5 " .
	    "for 1 .. 1000' | $project -j2 -");
	ok($status == 1 && $out eq '' && $err =~ $long,
	    'a line of 100 MB from a pipe');
	sparse("$tmp/zeros", 1 << 30);
	($status, $out, $err) = run("$limit $project -j2 $tmp/zeros");
	ok($status == 1 && $out eq '' && $err =~ $long,
	    'a line of 1 GB of zeros');
	for my $n (1 << 26, (1 << 26) + 1) {
		spew("$tmp/line", "0 0 0\n" x 30000 . "0 0 0 " .
		    'a' x ($n - 7) . "\n");
		my @want = $n == 1 << 26 ? (0, '') : (1,
		    "projcalc: -:30001: a line of more than 64 MiB\n");
		for my $from ("<$tmp/line", "<$tmp/line cat |") {
			my ($input, $pipe) = $from =~ /cat/ ? ($from, '') :
			    ('', $from);
			($status, $out, $err) = run("$limit $input $project " .
			    "-j2 - $pipe >/dev/null");
			is_deeply([$status, $err], \@want,
			    "a line of $n bytes: $from");
		}
	}
	# the results before an error cannot be written, either
	spew("$tmp/line", "0 0 0\n0 0 0 " . 'a' x (1 << 26));
	is_run("timeout 60 $project --scenes $tmp/line >/dev/full", 3, '',
	    "projcalc: standard output: No space left on device\n");
	# a line has at most 2^26 bytes, and a missing newline counts
	for my $n ((1 << 26) - 1, 1 << 26) {
		spew("$tmp/line", "0 0 0\n" x 30000 . "0 0 0 " . 'a' x ($n - 6));
		my $want = $n < 1 << 26 ? '0 ' :
		    "1 projcalc: -:30001: a line of more than 64 MiB\n";
		my @said = run("$limit $project -j2 --scenes - <$tmp/line >/dev/null");
		$said[2] =~ s/scene 1, line 1: //;
		is("@said[0, 2]", $want, "an open line of $n bytes");
	}
	run("(printf '0 0 0 '; perl -e 'print q(a ) x 3e7'; echo) >$tmp/60M");
	($status, $out, $err) = run("$limit $project -j2 $tmp/60M | wc -c");
	is("$status $out$err", "0 60000028\n", 'a line of 60 MB is carried');
	spew("$tmp/3M", "0 1 2\n" x 3000000);
	my $peak = peak("$project -j2 $tmp/3M");
	cmp_ok($peak, '<', 20000, '3 million lines in 20 MB');
	spew("$tmp/3M", "0\n" x 3000000);
	$peak = peak("$project -j2 --keep-going $tmp/3M", 1);
	cmp_ok($peak, '<', 20000, '3 million bad lines in 20 MB');
	for my $n (1 << 28, (1 << 28) + 1) {
		sparse("$tmp/zeros", $n);
		my $why = $n > 1 << 28 ? qr/ longer than 256 MiB; / :
		    qr/ holds points; /; # as numbers are, zeros
		like((run("projcalc lookat $tmp/zeros"))[2],
		    qr/\Aprojcalc: $tmp\/zeros:?$why/, "a document of $n bytes");
	}
	my $points = join ",\n", map { "[$_, 0.125, -7.5e-1, \"a\"]" }
	    1 .. 400000;
	spew("$tmp/document", "{\"points\": [$points]}");
	my $size = int((-s "$tmp/document") / 1024);
	$peak = peak("projcalc project -j2 $tmp/document");
	cmp_ok($peak, '<', $size + 20000,
	    "a document of $size kilobytes of points in 20 MB more");
	sparse("$tmp/zeros", 240000000);
	$peak = peak("$project -j2 -i f64 $tmp/zeros");
	cmp_ok($peak, '<', 20000, '10 million binary points in 20 MB');
	# more bytes than 32 bits count, in whole points
	($status, $out, $err) = run("head -c 4294967304 /dev/zero | " .
	    "(ulimit -v 200000; $project -j2 -i f64 -) >/dev/null");
	is("$status $err", '0 ', '4 GB from a pipe, in 200 MB');
}
done_testing();
