#!/usr/bin/perl
# The examples of the manual pages, run in testdata, and of README.md, run at
# the top: what follows a line "$ command", to the next or to the end of the
# example, is what the command prints.
# usage: examples_test.t [BIN]; the directory of projcalc, or build
use strict;
use warnings;
use Cwd 'abs_path';
use File::Basename;

my $top = abs_path(dirname($0) . '/../..');
my $bin = abs_path(shift // $ENV{BUILD} // "$top/build");
$ENV{PATH} = "$bin:$ENV{PATH}";
$ENV{LC_ALL} = 'C';
# An example that calls make calls it as a reader would.
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES)};

sub lines {
	open my $file, '<', "$top/$_[0]" or die "$_[0]: $!\n";
	return <$file>;
}

# The literal displays of a manual page, as a reader sees them.
sub manual {
	my ($in, @examples) = (0);
	for my $line (lines($_[0])) {
		$in = 1, push @examples, '' if $line =~ /^\.Bd -literal/;
		$in = 0 if $line =~ /^\.Ed/;
		next if !$in || $line =~ /^\./;
		$line =~ s/\\&//g;
		$line =~ s/\\\(aq/'/g;
		$line =~ s/\\-/-/g;
		$line =~ s/\\e/\\/g;
		$examples[-1] .= $line;
	}
	return @examples;
}

sub readme {
	my ($in, @examples) = (0);
	for my $line (lines('README.md')) {
		if ($line =~ /^```/) {
			$in = !$in;
			push @examples, '' if $in;
		} elsif ($in) {
			$examples[-1] .= $line;
		}
	}
	return @examples;
}

# A command goes on after a backslash or a bar at the end of its line, and
# within quotes.
sub commands {
	my ($dir, @examples) = @_;
	my @commands;
	for my $example (@examples) {
		my (undef, @parts) = split /^\$ /m, "\n$example";
		for my $part (@parts) {
			my ($command, @rest) = split /^/, $part;
			$command .= shift @rest while @rest &&
			    ($command =~ /[\\|]\n\z/ || $command =~ tr/'// % 2);
			push @commands, [$dir, $command, join '', @rest];
		}
	}
	return @commands;
}

# A tool that the command names and that isn't there.
sub lacks {
	my ($command) = @_;
	for my $tool (qw(parallel jq python3 bash)) {
		return $tool if $command =~ /\b$tool\b/ &&
		    system("command -v $tool >/dev/null") != 0;
	}
}

my @commands = ((map { commands("$top/testdata", manual($_)) }
    'man/projcalc.1', 'man/projcalc-scene.5'), commands($top, readme()));
my $failed = 0;
printf "1..%d\n", scalar @commands;
for my $i (0 .. $#commands) {
	my ($dir, $command, $want) = @{$commands[$i]};
	my $name = $command =~ s/#/\\#/gr =~ s/\n/ /gr;
	if (my $tool = lacks($command)) {
		printf "ok %d - %s# SKIP no %s\n", $i + 1, $name, $tool;
		next;
	}
	chdir $dir or die "$dir: $!\n";
	my $said = `{ $command} 2>&1 </dev/null`;
	my $ok = $said eq $want;
	printf "%s %d - %s\n", $ok ? 'ok' : 'not ok', $i + 1, $name;
	next if $ok;
	$failed++;
	print map { s/^/# /mgr } "expected:\n$want", "said:\n$said";
}
exit($failed > 0);
