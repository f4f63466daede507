#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Prints the JSON Schema of a scene, made from `projcalc help --json`: the members, and the
# rules between them. What no row says is written here: the values that have several
# forms, and four rules of values.
# usage: schema.pl PROJCALC
use strict;
use warnings;
use JSON::PP;

open my $said, '-|', $ARGV[0], 'help', '--json' or die "$ARGV[0]: $!\n";
my $all = decode_json(join '', <$said>);
my @types = map { @{$_->{words}} } grep { ($_->{in} // '') eq 'projection' &&
    $_->{name} eq 'type' } @{$all->{members}};
# The definition "matrix" is that of a matrix, so the type matrix is called any.
my %def = map { $_ => $_ eq 'matrix' ? 'any' : $_ } @types;

sub ref_to { return {'$ref' => "#/\$defs/$_[0]"} }

sub is_of {
	my ($row, $type) = @_;
	return !$type || !$row->{types} || grep { $_ eq $type } @{$row->{types}};
}

my ($true, $false) = (JSON::PP::true, JSON::PP::false);
my ($number, $size) = (ref_to('number'), ref_to('size'));

# Returns the schema of a list of $n values.
sub list {
	my ($items, $n) = @_;
	return {type => 'array', items => $items, minItems => $n, maxItems => $n};
}

# Returns the schema of a list of one value for each schema.
sub tuple {
	return {type => 'array', prefixItems => [@_], minItems => 0 + @_,
	    maxItems => 0 + @_};
}

# Returns the schema of $then for values of a type, and of $else for others.
sub either {
	my ($type, $then, $else) = @_;
	return {if => {type => $type}, then => $then, else => $else};
}

# Returns the schema of an object with no other members than these.
sub object_of {
	my (%properties) = @_;
	return {type => 'object', properties => \%properties,
	    patternProperties => {'^(_|\\$schema$)' => $true},
	    additionalProperties => $false};
}

# Returns the schema of a matrix: a list, or the object that -o json prints.
sub matrix {
	my ($list, @rules) = @_;
	return either('object', {%{object_of(matrix => $list,
	    vectors => {enum => ['row', 'column'], default => 'row'})},
	    required => ['matrix'], @rules ? (allOf => \@rules) : ()}, $list);
}

# Returns the rule that a matrix with few rows or columns is for these vectors.
sub only_for {
	my ($vectors, $if) = @_;
	return {if => {properties => {matrix => $if}},
	    then => {properties => {vectors => {const => $vectors}}}};
}

my $zero = {const => 0};
my $factor = {%$number, not => $zero};

# The definitions of values that several members have, or that have several forms.
my %values = (
	number => {type => 'number', minimum => -1e150, maximum => 1e150},
	size => {type => 'number', minimum => 1e-150, maximum => 1e150},
	numbers => {type => 'array', if => {minItems => 5}, then => list($number, 16),
	    else => list(list($number, 4), 4)},
	matrix => matrix(ref_to('numbers')),
	affine_numbers => {anyOf => [list(list($number, 4), 3),
	    list(list($number, 3), 4), ref_to('numbers')]},
	step_numbers => {anyOf => [list(list($number, 3), 3),
	    ref_to('affine_numbers')]},
	affine => matrix(ref_to('affine_numbers'), only_for('column', {maxItems => 3}),
	    only_for('row', {minItems => 4, maxItems => 4, items => {maxItems => 3}})),
	steps => {type => 'array', items => ref_to('step'), maxItems => 64},
	affine_or_steps => {if => {type => 'array', anyOf => [
		{maxItems => 0}, {contains => {type => 'object'}}]},
	    then => ref_to('steps'), else => ref_to('affine')},
	intrinsics => {type => 'array', if => {contains => {type => 'array'}},
	    then => {anyOf => [
		tuple(tuple($size, $number, $number),
		    tuple($zero, $size, $number), {const => [0, 0, 1]}),
		{%{list(list($number, 4), 3)}, not => {prefixItems => [
		    $true, $true, {prefixItems => [($zero) x 3]}]}}]},
	    else => {anyOf => [
		tuple($size, $size, $number, $number),
		tuple($size, $number, $number, $zero, $size, $number,
		    $zero, $zero, {const => 1}),
		{%{list($number, 12)}, not => {anyOf => [
		    {prefixItems => [($true) x 8, ($zero) x 3]},
		    {prefixItems => [$size, $zero, $zero, $true, $size, $zero,
			$true, $true, {const => 1}]}]}}]}},
	coordinate => either('null', $true, $number),
	point => {type => 'array', items => {type => [qw(number string boolean null)]},
	    prefixItems => [(ref_to('coordinate')) x 2], minItems => 2},
);

# The schemas of the types of values that are not one of the definitions above.
my %shapes = (
	'3 rows of 3 numbers' => list(list($number, 3), 3),
	'a word as flu' => {type => 'string',
	    pattern => '^(?=.*[rlRL])(?=.*[udUD])(?=.*[fbFB])[rludfbRLUDFB]{3}$'},
	'matrix or steps' => ref_to('affine_or_steps'),
	'steps' => ref_to('steps'),
	'number or 3 numbers' => either('array', list($factor, 3), $factor),
	'true or false' => {type => 'boolean'},
	'4 numbers, K or P' => ref_to('intrinsics'),
	'size or "infinity"' => either('string', {const => 'infinity'}, $size),
	'fill, uniform or 2 sizes' => either('array', list($size, 2),
	    {enum => ['fill', 'uniform']}),
	'3 numbers, or 2 of a window' => {%{list($number, 3)}, minItems => 2},
	'a point or a list' => {type => 'array',
	    if => {prefixItems => [{type => 'array'}]},
	    then => {items => ref_to('point')}, else => ref_to('point')},
);

# Returns the schema of a value of a type.
sub shape {
	my ($type, $row) = @_;
	my ($count, $one) = $type =~ /^(\d+) (\w+)s$/;
	return list(shape($one, $row), 0 + $count) if $count;
	return $shapes{$type} if $shapes{$type};
	return $size if $type eq 'size';
	return ref_to($row->{in} eq 'projection' ? 'matrix' : 'step_numbers')
	    if $type eq 'matrix';
	return object($row->{name}) if $type eq 'object' && $row->{in};
	return {enum => $row->{words}} if $type eq join ' or ',
	    join(', ', @{$row->{words}}[0 .. $#{$row->{words}} - 1]) || (),
	    @{$row->{words}} ? $row->{words}[-1] : ();
	return {} unless $type =~ /^(?:number|angle)$/;
	my %range = map { $_ => $row->{$_} } grep { /inimum|aximum/ } keys %$row;
	return $number if ($range{maximum} // 1e150) == 1e150 &&
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

# Returns schemas for the rules of an object. `$task` is whole, or fit for the command
# fit, which finds fitted members. Members that a viewport determines are optional
# unless $alone.
sub rules {
	my ($in, $type, $task, $alone) = @_;
	my @rules;
	for my $rule (grep { $_->{in} eq $in && is_of($_, $type) } @{$all->{ways}}) {
		next if $rule->{tasks} && !grep { $_ eq $task } @{$rule->{tasks}};
		my %any = map { $_ => 1 } map { @{$_->{has}}, @{$_->{optional} // []} }
		    @{$rule->{ways}};
		my @ways;
		for my $way (@{$rule->{ways}}) {
			my %free = map { $_ => 1 }
			    $task eq 'fit' ? @{$way->{fitted} // []} : (),
			    $alone ? () : @{$way->{by_viewport} // []};
			my %never = (%any, map { $_ => 0 } @{$way->{has}},
			    @{$way->{optional} // []});
			push @ways, conditions([grep { !$free{$_} } @{$way->{has}}],
			    grep { $never{$_} } keys %never);
		}
		my @one = map { {required => [$_]} } @{$rule->{with} // []};
		my @none = @{$rule->{without} // []};
		push @rules, @one || @none ? {if => {@one ? (anyOf => \@one) : (),
		    %{conditions([], @none)}}, then => {anyOf => \@ways}} :
		    {anyOf => \@ways};
	}
	return @rules;
}

# Returns the schema of an object that has members, and others never.
sub conditions {
	my ($must, @never) = @_;
	return {@$must ? (required => $must) : (),
	    @never ? (properties => {map { $_ => $false } @never}) : ()};
}

sub object {
	my ($in, $type) = @_;
	my %properties;
	for my $row (grep { ($_->{in} // '') eq $in && is_of($_, $type) }
	    @{$all->{members}}) {
		$properties{$row->{name}} = $type && $row->{name} eq 'type' ?
		    {const => $type} : member($row);
	}
	my @rules = rules($in, $type, 'fit');
	return {%{object_of(%properties)}, @rules ? (allOf => \@rules) : ()};
}

# Returns the definitions of the stricter rules for the object $name where the scene lacks
# bounds (_whole), a viewport (_alone), or both (_both).
sub stricter {
	my ($name, $in, $type) = @_;
	my $json = JSON::PP->new->canonical;
	my %known = map { $json->encode($_) => 1 } rules($in, $type, 'fit');
	my %defs;
	for ([whole => 'whole'], [alone => 'fit', 1], [both => 'whole', 1]) {
		my ($suffix, @how) = @$_;
		my @rules = grep { !$known{$json->encode($_)}++ }
		    rules($in, $type, @how);
		$defs{"${name}_$suffix"} = {%{ref_to($name)},
		    @rules ? (allOf => \@rules) : ()};
	}
	return %defs;
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
		%defs = (%defs, $def{$_} => object($name, $_),
		    stricter($def{$_}, $name, $_)) for @types;
		$defs{"projection_$_"} = {by_type("_$_")} for qw(whole alone both);
	} elsif ($name eq 'world') {
		$defs{step} = object($name);
	} elsif (@own && @{$row->{words}}) {
		$def = {%$def, if => {type => 'object'}, then => object($name),
		    else => {enum => $row->{words}}};
	} elsif (@own) {
		$def = {%$def, %{object($name)}};
		%defs = (%defs, stricter($name, $name)) if $name =~ /^(?:camera|window)$/;
	}
	$defs{$name} = $def;
	$root{$name} = ref_to($name);
}

# What no row says of a number or a list.
$_->{contains} = {not => $zero} for
    @{$defs{camera}{properties}}{qw(gaze orientation up)},
    @{$defs{step}{properties}}{qw(quaternion quaternion_wxyz)},
    $defs{step}{properties}{rotate}{properties}{axis},
    $defs{step}{properties}{node}{properties}{rotation};
$defs{volume}{properties}{eye}{prefixItems} = [$true, $true, {not => $zero}];

# Returns the rule that members of a scene that has all of @with, and none of @without,
# follow schemas.
sub where {
	my ($with, $without, %then) = @_;
	return {if => conditions($with, @$without), then => {properties => \%then}};
}

# Returns the schema of a scene whose bounds have points of this length.
sub corners {
	my %length = @_;
	return {properties => {bounds => {properties => {
	    map { $_ => \%length } qw(center min max)}}}};
}

my @rules = (
	where([], ['bounds'], map { $_ => ref_to("${_}_whole") }
	    qw(camera projection window)),
	where(['projection'], [], window => ref_to('window_whole')),
	where([], ['viewport'], projection => ref_to('projection_alone')),
	where([], [qw(bounds viewport)], projection => ref_to('projection_both')),
	# Intrinsics are in units of a viewport that they fill.
	{if => {required => ['projection'],
	    properties => {projection => {required => ['intrinsics']}}},
	    then => {required => ['viewport'], properties => {viewport => {
	    properties => {scale => {const => 'fill'}}}}}},
	# The range of a depth buffer's depth does not change distances.
	{if => {required => ['viewport'], properties => {viewport => {
	    required => ['depth'], properties => {depth => {const => 'distance'}}}}},
	    then => {properties => {viewport => {properties => {
	    min_z => $false, max_z => $false}}}}},
	# A window adapts to a device.
	{if => {required => ['window'], properties => {window => {
	    required => ['adapt'],
	    properties => {adapt => {enum => ['grow', 'shrink']}}}}},
	    then => {required => ['device']}},
	# Bounds are of two dimensions for a window or device, and of three for a projection.
	{if => {properties => {projection => $false},
	    anyOf => [map { {required => [$_]} } qw(window device)]},
	    then => corners(maxItems => 2), else => corners(minItems => 3)},
);

print JSON::PP->new->pretty->canonical->indent_length(1)->encode({
	'$schema' => 'https://json-schema.org/draft/2020-12/schema',
	title => 'projcalc scene',
	description => 'What projcalc(1) reads; projcalc-scene(5) explains it. Angles are ' .
	    'in angle_unit, lengths have no unit. Every object may also have members ' .
	    'whose names begin with _ (notes), and $schema.',
	%{object_of(%root)}, allOf => \@rules, '$defs' => {%values, %defs}});
