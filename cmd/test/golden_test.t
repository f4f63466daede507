#!/usr/bin/perl
# Runs each testdata/golden/NAME/cmd, one line of shell, in testdata with
# projcalc on PATH and the file in as standard input, and compares what it
# says with the files out, err and status. A file that is missing is empty, or
# 0 for status.
# usage: golden_test.t [-w] [BUILD]; -w rewrites out, err and status.
use strict;
use warnings;
use Cwd 'abs_path';
use File::Basename;
use File::Temp 'tempdir';

my $write = @ARGV && $ARGV[0] eq '-w' && shift;
my $top = abs_path(dirname($0) . '/../..');
my $build = abs_path(shift // $ENV{BUILD} // "$top/build");
my $tmp = tempdir(CLEANUP => 1);

$ENV{PATH} = "$build:$ENV{PATH}";
$ENV{LC_ALL} = 'C';
chdir "$top/testdata" or die "$top/testdata: $!\n";

sub slurp {
	my ($name, $default) = @_;
	open my $file, '<:raw', $name or return $default;
	local $/;
	return <$file> // '';
}

sub spew {
	my ($name, $text, $default) = @_;
	unlink $name;
	return if $text eq $default;
	open my $file, '>:raw', $name or die "$name: $!\n";
	print $file $text;
}

# Runs the case and returns what it said, by file name.
sub run {
	my ($case) = @_;
	my $pid = fork // die "fork: $!\n";
	if ($pid == 0) {
		open STDIN, '<', -e "$case/in" ? "$case/in" : '/dev/null';
		open STDOUT, '>', "$tmp/out";
		open STDERR, '>', "$tmp/err";
		$SIG{PIPE} = 'DEFAULT';
		alarm 20;
		exec 'sh', '-c', slurp("$case/cmd", '');
	}
	waitpid $pid, 0;
	my $status = $? & 127 ? 128 + ($? & 127) : $? >> 8;
	return (out => slurp("$tmp/out"), err => slurp("$tmp/err"),
	    status => "$status\n");
}

sub compare {
	my ($case, %said) = @_;
	my $report = '';
	for my $name (qw(out err status)) {
		my $want = slurp("$case/$name", $name eq 'status' ? "0\n" : '');
		next if $want eq $said{$name};
		spew("$tmp/want", $want, '');
		spew("$tmp/said", $said{$name}, '');
		$report .= `diff -aNu --label expected/$name --label $name \\
		    $tmp/want $tmp/said`;
	}
	return $report =~ s/^(?=.)/# /mgr;
}

my @cases = sort glob 'golden/*/';
my $failed = 0;
printf "1..%d\n", scalar @cases;
for my $i (0 .. $#cases) {
	my $case = $cases[$i] =~ s{/$}{}r;
	my %said = run($case);
	if ($write) {
		spew("$case/$_", $said{$_}, '') for qw(out err);
		spew("$case/status", $said{status}, "0\n");
	}
	my $report = compare($case, %said);
	$failed++ if $report ne '';
	printf "%s %d - %s\n", $report eq '' ? 'ok' : 'not ok', $i + 1,
	    basename($case);
	print '# ', slurp("$case/cmd", ''), $report if $report ne '';
}
exit($failed > 0);
