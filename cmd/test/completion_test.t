#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks that shells complete what the program's help lists. bash is asked as by
# readline, fish by its command complete; zsh only checks the syntax of its file.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

my $program = "$build/projcalc";

for my $shell (qw(bash zsh fish)) {
	system("$^X man/completion.pl $program $shell >$tmp/$shell") == 0
	    or die "completion.pl $shell failed\n";
}

# Returns the words that bash offers after those of a line, the last of which may be
# empty.
sub bash {
	my @words = @_;
	open my $out, '-|', 'bash', '-c', '
		compopt() { :; }
		. "$1"
		shift
		COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
		_projcalc
		printf "%s\n" "${COMPREPLY[@]}"', 'bash', "$tmp/bash", @words
	    or die "bash: $!\n";
	chomp(my @replies = <$out>);
	return sorted(grep { $_ ne '' } @replies);
}

my $help = `$program help`;
my @commands = $help =~ /^  ([a-z]\w*) /mg;

is(bash('projcalc', ''), sorted(@commands, '--help', '--version'),
    'commands');
is(bash('projcalc', 'lo'), 'lookat', 'a command begun');
is(bash('projcalc', 'help', 'w'), 'w2d w2n window world', 'help of');
for my $command (@commands) {
	my $options = `$program help $command`;
	my @names = $options =~ /(?:^  |, )(-\w|--[\w-]+)(?=[ ,])/mg;
	push @names, $options =~ /^      (--[\w-]+)/mg;
	is(bash('projcalc', $command, '-'), sorted(@names),
	    "options of $command");
}
is(bash('projcalc', 'project', '-c', ''), 'd3d gl opencv vulkan webgpu',
    'words of an option');
is(bash('projcalc', 'project', '--to', 'd'), 'device', 'a word begun');
is(bash('projcalc', 'project', '--to', '='),
    'clip device model ndc view world', 'after =');
is(bash('projcalc', 'project', '--to', '=', 'v'), 'view', 'begun after =');
is(bash('projcalc', 'project', '-d', ''), '', 'a number');
is(bash('projcalc', 'project', 'sc'), '', 'files are left to bash');

for my $shell (qw(zsh fish)) {
	SKIP: {
		skip "no $shell", 1 if missing($shell);
		is(`$shell -n $tmp/$shell 2>&1`, '', "$shell: syntax");
	}
}
SKIP: {
	skip 'no fish', 1 if missing('fish');
	my $said = `fish --no-config -c 'source $tmp/fish
	    complete -C "projcalc project --to "'`;
	is(sorted($said =~ /^(\w+)\t/mg), 'clip device model ndc view world',
	    'fish: words of an option');
}
done_testing();
