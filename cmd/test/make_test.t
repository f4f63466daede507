#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# What make says where something is missing, and what make deps would install, on a
# Debian that has nothing yet.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Projcalc;

sub script {
	my ($name, $text) = @_;
	spew("$tmp/bin/$name", "#!/bin/sh\n$text\n");
	chmod 0755, "$tmp/bin/$name";
}

mkdir "$tmp/bin" or die "$tmp/bin: $!\n";
script('dpkg-query', 'exit 1');
script('dpkg', 'exit 0');
script('apt-cache', '[ "$2" != libdragonbox-dev ]');
script('apt-get', "echo \"\$*\" >>$tmp/asked");
script('sudo', 'exec "$@"');

# What is installed for these goals, and what is said.
sub deps {
	my (@goals) = @_;
	unlink "$tmp/asked";
	my ($status, $out) = run("PATH=$tmp/bin:\$PATH " .
	    "sh .debian/deps $tmp/build @goals");
	my ($asked) = slurp("$tmp/asked") =~ /--no-install-recommends install(.*)/;
	return (" $asked ", $out);
}

my @building = qw(g++ make libc6-dev libcjson-dev libfast-float-dev);
my ($asked, $said) = deps('demo');
is(sorted(split ' ', $asked), sorted(@building), 'what building takes');
like($said, qr/^make deps: this release has no package libdragonbox-dev$/m,
    'a package that there is not');
for my $goals ([], ['lint']) {
	($asked) = deps(@$goals);
	like($asked, qr/ \Q$_\E /, "$_ for deps @$goals")
	    for @building, qw(clang libclang-rt-dev libcmocka-dev);
	unlike($asked, qr/qemu|coq/, "and no more for deps @$goals");
}

my ($status, $out, $err) = run("make -n deps demo BUILD=$tmp/none");
like($out, qr{^sh .debian/deps $tmp/none demo$}m, 'make says what is wanted');

($status, $out, $err) = run("make -s BUILD=$tmp/none CXX=nothing " .
    "$tmp/none/cmd/number/number_read.o");
is($status, 2, 'without a compiler and headers');
like($err, qr/^nothing finds no <.*>: 'make deps' installs what is missing$/m,
    'which is said');
SKIP: {
	my $lacks = missing('bmake');
	skip "no $lacks", 1 if $lacks;
	($status, $out, $err) = run('bmake');
	like("$out$err", qr/^bmake: .*line \d+: projcalc is built by GNU make/,
	    'another make');
}
done_testing();
