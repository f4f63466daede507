# SPDX-License-Identifier: MIT
# What the tests share. Using it changes to the top of the project, makes a directory
# $tmp for output, and loads Test::More. usage of a test: x_test.t [-w] [BUILD]
# [FILE...]; BUILD, or else the variable of that name, or else build, is the directory
# of projcalc. -w is for tests that can rewrite what they expect.
package Projcalc;
use strict;
use warnings;
use Cwd 'abs_path';
use Exporter 'import';
use File::Basename;
use File::Spec;
use File::Temp 'tempdir';
use IPC::Open2;
use Test::More;

our $top = abs_path(dirname(__FILE__) . '/../..');
our $write = @ARGV && $ARGV[0] eq '-w' && shift @ARGV;
our $build = abs_path(@ARGV && -d $ARGV[0] ? shift @ARGV :
    $ENV{BUILD} // "$top/build");
our $tmp = tempdir(CLEANUP => 1);
our @EXPORT = (qw($top $write $build $tmp slurp spew missing run sorted
    stack_limit below pick done_or),
    @Test::More::EXPORT);

$ENV{LC_ALL} = 'C';
delete @ENV{qw(NO_COLOR POSIXLY_CORRECT CDPATH)};
# A make that a test starts must not take part in `make test`, but run as if typed.
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES)};
chdir $top or die "$top: $!\n";

sub slurp {
	open my $file, '<:raw', $_[0] or die "$_[0]: $!\n";
	local $/;
	return <$file> // '';
}

sub spew {
	my ($name, $text) = @_;
	open my $file, '>:raw', $name or die "$name: $!\n";
	print $file $text;
	close $file or die "$name: $!\n";
}

# Random numbers by Park and Miller, which are the same in any perl.
my $state = 1;

sub below {
	$state = $state * 48271 % 2147483647;
	return $state % $_[0];
}

sub pick { $_[below(scalar @_)] }

# Returns the first of the commands that is not installed, or undef.
sub missing {
	for my $tool (@_) {
		return $tool if system("command -v $tool >/dev/null") != 0;
	}
	return;
}

# Ends a test. If a case has failed, says how its expected output is rewritten.
sub done_or {
	my ($how) = @_;
	diag("If the change is meant: $how; then read the diff.")
	    unless Test::More->builder->is_passing;
	done_testing();
}

sub sorted { join ' ', sort @_ }

# The shell of run(), and the process and environment that started it.
my ($shell, $commands, $answers, $started) = (0, undef, undef, '');

# The usual limit of the stack, in KB, which other programs need.
chomp(my $usual = `sh -c 'ulimit -S -s'`);

# Returns the limit for projcalc, the stack of threads that do not set their own on some
# systems; or undef for a projcalc that is a script, or has a sanitizer, which needs more.
sub stack_limit {
	my $program = slurp("$build/projcalc");
	return $program =~ /\A\x7fELF/ && $program !~ /__[at]san_init/ ? 512 : undef;
}

# Matches a call of projcalc, or of a builtin that prints: neither changes the shell.
my $call = qr/(?:(?:\w+=\S* )*projcalc|printf|echo) (?:[^;&|()\$`\n]|2>&1)*/;

# Runs a command of the shell, here or in a directory, with the program that is
# tested first on PATH and nothing on standard input. Returns the status (128 and
# the signal, as the shell says it), output and errors. One shell runs the commands, as
# perl is large, and takes longer to fork. It runs what $call matches itself, with the
# limit of the stack, and other commands in a subshell, without.
sub run {
	my ($command, $dir) = @_;
	my ($out, $err) = map { "$tmp/$_$$" } qw(out err);
	my ($where, @words) = map { "'" . s/'/'\\''/gr . "'" }
	    File::Spec->rel2abs($dir // '.'), $command, $out, $err;
	die "$build has no projcalc\n" if !-x "$build/projcalc";
	local $ENV{PATH} = "$build:$ENV{PATH}";
	local $SIG{PIPE} = 'DEFAULT';
	local $SIG{ALRM} = sub { kill 'KILL', -$shell };
	my $now = join "\n", $$, map { $_ . '=' . ($ENV{$_} // '') } sort keys %ENV;
	if ($now ne $started) {
		$shell = open2($answers, $commands, missing('setsid') ?
		    ($^X, '-MPOSIX', '-e', 'POSIX::setsid(); exec "sh"') :
		    ('setsid', 'sh'));
		print $commands 'ulimit -S -s ' . (stack_limit() // $usual) . "\n";
		$started = $now;
	}
	my ($begin, $end) =
	    $command =~ s/'[^']*'//gr =~ /^$call(?:[;|\n] *$call)*\n?$/ ?
	    ('{', '}') : ("(ulimit -S -s $usual;", ')');
	alarm 900;
	printf $commands "%s cd %s && eval %s; %s </dev/null >%s 2>%s; echo \$?\n",
	    $begin, $where, shift @words, $end, @words;
	my $status = readline $answers;
	alarm 0;
	if (!defined $status) { # the command has ended the shell
		waitpid $shell, 0;
		$status = $? & 127 ? 128 + ($? & 127) : $? >> 8;
		$started = '';
	}
	return (int $status, slurp($out), slurp($err));
}

1;
