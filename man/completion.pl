#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Prints the completions of projcalc for a shell, made from `projcalc help --json`.
# usage: completion.pl PROJCALC bash|zsh|fish
use strict;
use warnings;
use JSON::PP;

my ($program, $shell) = @ARGV;
open my $said, '-|', $program, 'help', '--json' or die "$program: $!\n";
my $all = decode_json(join '', <$said>);
my @commands = map { $_->{name} } @{$all->{commands}};
my %about = map { $_->{name} => $_->{about} } @{$all->{commands}};
my @topics = (@commands, map { $_->{name} } grep { !$_->{in} }
    @{$all->{members}});
my (@options, %option);

for (@{$all->{options}}) {
	push @options, $_->{name};
	$_->{argument} //= '';
	$_->{words} = join ' ', @{$_->{words}};
	$option{$_->{name}} = $_;
}

sub options_of {
	my ($command) = @_;
	return grep {
		grep { $_ eq $command } @{$_->{commands}}
	} map { $option{$_} } @options;
}

# Returns the text in single quotes of the shell.
sub quote {
	my ($text) = @_;
	return "'" . $text =~ s/'/'\\''/gr . "'";
}

sub names {
	my ($o, $between) = @_;
	return join $between, $o->{letter} ? "-$o->{letter}" : (),
	    "--$o->{name}";
}

sub bash {
	my $options = join ' ', map { names($_, ' ') } options_of('help');
	my %cases;
	for my $o (grep { $_->{argument} ne '' } map { $option{$_} } @options) {
		push @{$cases{$o->{words}}}, names($o, ' | ');
	}
	print <<"	END" =~ s/^\t//mgr;
	# projcalc(1) in bash
	_projcalc()
	{
		local cur=\${COMP_WORDS[COMP_CWORD]}
		local prev=\${COMP_WORDS[COMP_CWORD-1]} words

		COMPREPLY=()
		# bash splits --to=device into three words
		if [ "\$cur" = = ]; then
			cur=
		elif [ "\$prev" = = ]; then
			prev=\${COMP_WORDS[COMP_CWORD-2]}
		fi
		if [ "\$COMP_CWORD" -eq 1 ]; then
			words='@commands --help --version'
		else
			case \$prev in
			help) words='@topics $options' ;;
	END
	for my $words (sort keys %cases) {
		my $names = join ' | ', @{$cases{$words}};
		my $then = $words eq '' ? 'compopt +o default; return' :
		    "words='$words'";
		print "\t\t$names) $then ;;\n";
	}
	print "\t\t*) case \${COMP_WORDS[1]} in\n";
	my %alike;
	for my $command (@commands) {
		push @{$alike{join ' ', map { names($_, ' ') }
		    options_of($command)}}, $command;
	}
	for my $words (sort keys %alike) {
		my $names = join ' | ', @{$alike{$words}};
		print "\t\t\t$names) words='$words' ;;\n";
	}
	print <<"	END" =~ s/^\t//mgr;
				esac
				# complete files, unless an option begins
				[ "\${cur#-}" = "\$cur" ] && words= ;;
			esac
		fi
		while read -r cur; do
			COMPREPLY+=("\$cur")
		done < <(compgen -W "\$words" -- "\$cur")
	}
	complete -o default -F _projcalc projcalc
	END
}

sub zsh {
	print "#compdef projcalc\n",
	    "local curcontext=\$curcontext state line\n",
	    "local -a commands=(\n";
	print "\t", quote("$_:$about{$_}"), "\n" for @commands;
	print <<"	END" =~ s/^\t//mgr;
	)
	_arguments -C '1:command:->command' '*::operand:->operand'
	if [[ \$state = command ]]; then
		_describe command commands
		return
	fi
	case \$words[1] in
	END
	for my $command (@commands) {
		print "$command) _arguments \\\n";
		for my $o (options_of($command)) {
			my $about = quote("[$o->{about}]" .
			    ($o->{argument} eq '' ? '' :
			    ":$o->{argument}:($o->{words})"));
			my $long = "--$o->{name}" .
			    ($o->{argument} eq '' ? '' : '=');
			print "\t", $o->{letter} ? "'(" . names($o, ' ') .
			    ")'{-$o->{letter},$long}" : $long, $about,
			    " \\\n";
		}
		print $command eq 'help' ? "\t'1:topic:(@topics)' ;;\n" :
		    "\t'1:PARAMS:_files' '*:POINTS:_files' ;;\n";
	}
	print "esac\n";
}

sub fish {
	print "# projcalc(1) in fish\n";
	print "complete -c projcalc -f -n __fish_use_subcommand -a $_ -d ",
	    quote($about{$_}), "\n" for @commands;
	print "complete -c projcalc -f -n '__fish_seen_subcommand_from help' ",
	    "-a '@topics'\n";
	for my $o (map { $option{$_} } @options) {
		print 'complete -c projcalc -n ',
		    "'__fish_seen_subcommand_from @{$o->{commands}}'",
		    $o->{letter} ? " -s $o->{letter}" : '', " -l $o->{name}",
		    $o->{argument} ne '' ? ' -x' : '',
		    $o->{words} ne '' ? " -a '$o->{words}'" : '',
		    ' -d ', quote($o->{about}), "\n";
	}
}

my %print = (bash => \&bash, zsh => \&zsh, fish => \&fish);

($print{$shell // ''} or die "usage: completion.pl PROJCALC bash|zsh|fish\n")
    ->();
