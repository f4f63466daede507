#!/usr/bin/perl
# The examples of the manual page, run in testdata, and of README.md, run at the
# top: what follows a line "$ command", to the next or to the end of the
# example, is what the command prints.
use strict;
use warnings;
use Cwd 'abs_path';
use File::Basename;

my $top = abs_path(dirname($0) . '/..');
$ENV{PATH} = "$top/build:$ENV{PATH}";
$ENV{LC_ALL} = 'C';
# An example that calls make calls it as a reader would.
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES)};

sub lines {
	open my $file, '<', "$top/$_[0]" or die "$_[0]: $!\n";
	return <$file>;
}

# The literal displays of the manual's EXAMPLES, as a reader sees them.
sub manual {
	my ($in, @examples) = (0);
	my @lines = lines('man/projcalc.1');
	shift @lines while @lines && $lines[0] !~ /^\.Sh EXAMPLES/;
	for my $line (@lines) {
		last if $line =~ /^\.Sh/ && $line !~ /EXAMPLES/;
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

# A command goes on after a backslash at the end of its line and within quotes.
sub commands {
	my ($dir, @examples) = @_;
	my @commands;
	for my $example (@examples) {
		my (undef, @parts) = split /^\$ /m, "\n$example";
		for my $part (@parts) {
			my ($command, @rest) = split /^/, $part;
			$command .= shift @rest while @rest &&
			    ($command =~ /\\\n\z/ || $command =~ tr/'// % 2);
			push @commands, [$dir, $command, join '', @rest];
		}
	}
	return @commands;
}

my @commands = (commands("$top/testdata", manual()), commands($top, readme()));
my $failed = 0;
printf "1..%d\n", scalar @commands;
for my $i (0 .. $#commands) {
	my ($dir, $command, $want) = @{$commands[$i]};
	chdir $dir or die "$dir: $!\n";
	my $said = `{ $command} 2>&1 </dev/null`;
	my $ok = $said eq $want;
	printf "%s %d - %s\n", $ok ? 'ok' : 'not ok', $i + 1,
	    $command =~ s/#/\\#/gr =~ s/\n/ /gr;
	next if $ok;
	$failed++;
	print map { s/^/# /mgr } "expected:\n$want", "said:\n$said";
}
exit($failed > 0);
