#!/usr/bin/perl
# What the shells complete is what the program's help lists. bash is asked as
# readline asks it, fish by itself; zsh reads its file for syntax.
use strict;
use warnings;
use Cwd 'abs_path';
use File::Basename;
use File::Temp 'tempdir';

my $top = abs_path(dirname($0) . '/../..');
my $program = abs_path($ENV{BUILD} // "$top/build") . '/projcalc';
my $dir = tempdir(CLEANUP => 1);
my $n = 0;
my $failed = 0;

sub check {
	my ($name, $got, $want) = @_;
	my $ok = $got eq $want;
	printf "%s %d - %s\n", $ok ? 'ok' : 'not ok', ++$n, $name;
	return if $ok;
	$failed++;
	print "# expected: $want\n# got: $got\n";
}

sub skip {
	my ($name, $why) = @_;
	printf "ok %d - %s # SKIP %s\n", ++$n, $name, $why;
}

sub sorted {
	return join ' ', sort @_;
}

for my $shell (qw(bash zsh fish)) {
	system("$^X $top/man/completion.pl $program $shell >$dir/$shell") == 0
	    or die "completion.pl $shell failed\n";
}

# What bash offers after the words of a line, the last of which may be empty.
sub bash {
	my @words = @_;
	open my $out, '-|', 'bash', '-c', '
		compopt() { :; }
		. "$1"
		shift
		COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
		_projcalc
		printf "%s\n" "${COMPREPLY[@]}"', 'bash', "$dir/bash", @words
	    or die "bash: $!\n";
	chomp(my @replies = <$out>);
	return sorted(grep { $_ ne '' } @replies);
}

my $help = `$program help`;
my @commands = $help =~ /^  ([a-z]\w*) /mg;

check('commands', bash('projcalc', ''),
    sorted(@commands, 'help', '--help', '--version'));
check('a command begun', bash('projcalc', 'lo'), 'lookat');
check('help of', bash('projcalc', 'help', 'w2'), 'w2d w2n');
for my $command (@commands) {
	my $options = `$program help $command`;
	my @names = $options =~ /(?:^  |, )(-\w|--[\w-]+)(?=[ ,])/mg;
	push @names, $options =~ /^      (--[\w-]+)/mg;
	check("options of $command", bash('projcalc', $command, '-'),
	    sorted(@names));
}
check('words of an option', bash('projcalc', 'project', '-c', ''),
    'd3d gl vulkan webgpu');
check('a word begun', bash('projcalc', 'project', '--to', 'd'), 'device');
check('after =', bash('projcalc', 'project', '--to', '='),
    'clip device model ndc view world');
check('begun after =', bash('projcalc', 'project', '--to', '=', 'v'), 'view');
check('a number', bash('projcalc', 'project', '-d', ''), '');
check('files are left to bash', bash('projcalc', 'project', 'sc'), '');

for my $shell (qw(zsh fish)) {
	if (system("command -v $shell >/dev/null") != 0) {
		skip("$shell: syntax", "no $shell");
		next;
	}
	check("$shell: syntax", scalar `$shell -n $dir/$shell 2>&1`, "");
}
if (system('command -v fish >/dev/null') != 0) {
	skip('fish: words of an option', 'no fish');
} else {
	my $said = `fish --no-config -c 'source $dir/fish
	    complete -C "projcalc project --to "'`;
	check('fish: words of an option', sorted($said =~ /^(\w+)\t/mg),
	    'clip device model ndc view world');
}
print "1..$n\n";
exit($failed > 0);
