#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Prints the JSON Schema of a scene, made from `projcalc help --json` and from RULES,
# the rules between members, which override it.
# usage: schema.pl PROJCALC RULES
use strict;
use warnings;
use JSON::PP;

my ($program, $rules) = @ARGV;
open my $said, '-|', $program, 'help', '--json' or die "$program: $!\n";
my $all = decode_json(join '', <$said>);
open my $read, '<', $rules or die "$rules: $!\n";
my $hand = decode_json(join '', <$read>);
delete $hand->{'$comment'}; # it is about the file RULES
my @types = map { @{$_->{words}} } grep { ($_->{in} // '') eq 'projection' &&
    $_->{name} eq 'type' } @{$all->{members}};
# The definition "matrix" is that of a matrix, so the type matrix is called any.
my %def = map { $_ => $_ eq 'matrix' ? 'any' : $_ } @types;

sub ref_to { return {'$ref' => "#/\$defs/$_[0]"} }

sub is_of {
	my ($row, $type) = @_;
	return !$type || !$row->{types} || grep { $_ eq $type } @{$row->{types}};
}

# Returns the schema of a value of a type, or nothing if RULES has it.
sub shape {
	my ($type, $row) = @_;
	my ($count, $one) = $type =~ /^(\d+) (\w+)s$/;
	return {type => 'array', items => shape($one, $row), minItems => 0 + $count,
	    maxItems => 0 + $count} if $count;
	return ref_to($type) if $type =~ /^(?:size|matrix)$/;
	return {type => 'boolean'} if $type eq 'true or false';
	return {enum => $row->{words}} if $type eq join ' or ',
	    join(', ', @{$row->{words}}[0 .. $#{$row->{words}} - 1]) || (),
	    @{$row->{words}} ? $row->{words}[-1] : ();
	return {} unless $type =~ /^(?:number|angle)$/;
	my %range = map { $_ => $row->{$_} } grep { /inimum|aximum/ } keys %$row;
	return ref_to('number') if ($range{maximum} // 1e150) == 1e150 &&
	    !exists $range{exclusiveMaximum};
	return {type => 'number', %range};
}

sub member {
	my ($row) = @_;
	my $unit = $row->{unit} ? ", in $row->{unit}" : '';
	my $before = $row->{before} ?
	    "; default $row->{before}, else $row->{default}" : '';
	return {%{shape($row->{type}, $row)},
	    description => ucfirst "$row->{about}$unit$before",
	    defined $row->{default} ? (default => $row->{default}) : ()};
}

# Returns a schema for a set of ways. An object has all members of one way, but for
# those with ? after them, and no member that only other ways list.
sub one_of {
	my (@ways) = @_;
	my %any = map { $_ => 1 } map { /(\w+)/g } @ways;
	my @one;
	for my $way (@ways) {
		my %has = map { $_ => 1 } $way =~ /(\w+)/g;
		my @must = $way =~ /(\w+)(?![\w?])/g;
		my %never = map { $_ => JSON::PP::false } grep { !$has{$_} }
		    keys %any;
		push @one, {@must ? (required => \@must) : (),
		    %never ? (properties => \%never) : ()};
	}
	return {anyOf => \@one};
}

# Returns the sets of ways of an object: with $fit, the sets for the command fit, which
# finds missing members; without it, the sets that fit replaces.
sub ways {
	my ($in, $type, $fit) = @_;
	my @sets = grep { $_->{in} eq $in && is_of($_, $type) } @{$all->{ways}};
	@sets = grep { $_->{fit} } @sets if !$fit;
	my @rules = map { one_of(@$_) } grep { @$_ } map {
		$fit ? $_->{fit} // $_->{ways} : $_->{ways} } @sets;
	return @rules ? (allOf => \@rules) : ();
}

sub object {
	my ($in, $type) = @_;
	my %properties;
	for my $row (grep { ($_->{in} // '') eq $in && is_of($_, $type) }
	    @{$all->{members}}) {
		$properties{$row->{name}} = $type && $row->{name} eq 'type' ?
		    {const => $type} : member($row);
	}
	return {type => 'object', properties => \%properties,
	    patternProperties => {'^(_|\\$schema$)' => JSON::PP::true},
	    additionalProperties => JSON::PP::false, ways($in, $type, 1)};
}

# Returns a schema in which the type of a projection decides which members it has.
# Without a type the command decides, and no command has the type matrix.
sub by_type {
	my ($suffix) = @_;
	return (if => {required => ['type']},
	    then => {allOf => [map { {
		if => {properties => {type => {const => $_}}},
		then => ref_to($def{$_} . $suffix)} } @types]},
	    else => {anyOf => [map { ref_to($def{$_} . $suffix) }
		grep { $_ ne 'matrix' } @types]});
}

my (%defs, %root);
for my $row (grep { !$_->{in} } @{$all->{members}}) {
	my $name = $row->{name};
	my @own = grep { ($_->{in} // '') eq $name } @{$all->{members}};
	my $def = member($row);
	if ($name eq 'projection') {
		$def = {%$def, type => 'object', by_type(''), properties => {
		    map { $_->{name} => member($_) } grep { $_->{name} eq 'type' }
		    @own}};
		$defs{$def{$_}} = object($name, $_) for @types;
		$defs{"$def{$_}_whole"} = {%{ref_to($def{$_})},
		    ways($name, $_, 0)} for @types;
		$defs{projection_whole} = {by_type('_whole')};
	} elsif (@own && @{$row->{words}}) {
		$def = {%$def, if => {type => 'object'}, then => object($name),
		    else => {enum => $row->{words}}};
	} elsif (@own) {
		$def = {%$def, %{object($name)}};
		$defs{"${name}_whole"} = {ways($name, undef, 0)};
	}
	$defs{$name} = $def;
	$root{$name} = ref_to($name);
}

# Overrides the schema $under, member by member, with $over.
sub lay {
	my ($under, $over) = @_;
	for (keys %$over) {
		my $both = ref $under->{$_} eq 'HASH' && ref $over->{$_} eq 'HASH';
		lay($under->{$_}, $over->{$_}) if $both;
		$under->{$_} = $over->{$_} if !$both;
	}
	return $under;
}

print JSON::PP->new->pretty->canonical->indent_length(1)->encode(lay({
	'$schema' => 'https://json-schema.org/draft/2020-12/schema',
	type => 'object', properties => \%root, '$defs' => \%defs,
	patternProperties => {'^(_|\\$schema$)' => JSON::PP::true},
	additionalProperties => JSON::PP::false}, $hand));
