#!/usr/bin/perl
# SPDX-License-Identifier: MIT
# Checks what make says if something is missing, what `make deps` would install on a
# fresh Debian, and with whose rights, and what `make dist` packs.
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

sub told {
	my ($command) = @_;
	chomp(my $said = `($command)`);
	return $said;
}

mkdir "$tmp/bin" or die "$tmp/bin: $!\n";
script('dpkg-query', 'exit 1');
script('dpkg', '[ "$1" != --print-architecture ] || echo amd64');
script('apt-cache', '[ "$2" != libdragonbox-dev ]');
script('apt-get', "echo \"\$*\" >>$tmp/asked");
script('sudo', 'exec "$@"');

# Returns the packages that these targets install, and the messages.
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

# Without root: the missing packages and, without sudo, the command that root must run.
# A library of another architecture does not count as installed.
script('dpkg-query', '
	case $4 in
	jq | libmpfr-dev:arm64) echo "amd64 install ok installed" ;;
	libgmp-dev) echo "amd64 deinstall ok config-files" ;;
	libmpfr-dev) echo "arm64 install ok installed" ;;
	perl) echo "all install ok installed" ;;
	*) exit 1 ;;
	esac');
script('id', 'echo 1000');
my $asked_before = slurp("$tmp/asked");
unlink "$tmp/bin/sudo";
symlink told("command -v $_"), "$tmp/bin/$_" for qw(grep env);
my $sh = told('command -v sh');
my ($status, $out, $err) = run("PATH=$tmp/bin $sh .debian/deps $tmp/build");
is($status, 1, 'neither root nor sudo');
like($out, qr/\Amake deps: missing: g\+\+ [^\n]*\n\z/, 'what is missing comes first');
like($err, qr/\Amake deps: .* root is to run\napt-get update && apt-get install/,
    'what root is to run comes last');
for my $said ($out, $err) {
	unlike($said, qr/ (?:jq|perl)\b/, 'what is installed is not asked for');
	like($said, qr/ \Q$_\E\b/, "$_ is") for qw(libmpfr-dev libgmp-dev);
}
unlike($err, qr/libdragonbox/, 'nor what apt does not know');
is(slurp("$tmp/asked"), $asked_before, 'apt-get is not called');
($status, $out, $err) = run("PATH=$tmp/bin $sh .debian/deps $tmp/build foreign");
like($out, qr/dpkg's architectures .* arm64/, 'what dpkg would get');
like($err, qr/^dpkg --add-architecture arm64 && apt-get update && /m,
    'root adds it');
like($err, qr/ libgmp-dev:arm64\b/, 'for this');
unlike($err, qr/ libmpfr-dev/, 'what is there of arm64 is not asked for');

($status, $out, $err) = run("make -n deps demo BUILD=$tmp/none");
like($out, qr{^sh .debian/deps $tmp/none demo$}m, 'make says what is wanted');

for my $compiler (qw(CC CXX)) {
	($status, $out, $err) = run("make -s BUILD=$tmp/none $compiler=nothing");
	is($status, 2, "without $compiler");
	like($err, qr/\Athere is no nothing: .* CC and CXX choose one$/m, 'which is said');
}
($status, $out, $err) = run("make -s BUILD=$tmp/none CXX=false");
is($status, 2, 'without a header');
like($err, qr/\Afalse finds no <.*>: 'make deps' .* CPPFLAGS=-IFOLDER says where/,
    'which is said');

# Without apt-get deps names the projects that are missing, if there are any.
unlink "$tmp/bin/$_" for qw(apt-get dpkg-query dpkg apt-cache);
script('perl', '');
for my $goal (qw(demo test)) {
	my $deps = "CC=compiler CXX=compiler PATH=$tmp/bin $sh .debian/deps $tmp/build $goal";
	script('compiler', '');
	($status, $out) = run($deps);
	is("$status$out", "0make deps: nothing is missing\n", "deps $goal, with headers");
	script('compiler', 'exit 1');
	($status, $out) = run($deps);
	is($status, 1, "deps $goal, without headers");
	like($out, qr/^make deps: there is no apt-get here; please install cJSON/m,
	    'which are named');
	unlike($out, qr/lib|-dev/, "and not by Debian's names");
}

# A linker's own flags are given only to a linker that knows them.
for my $flag ('--sort-section=alignment', '-z,relro', '-z,now') {
	script('linking', "case \$* in *-Wl,$flag*) exit 1 ;; esac");
	($status, $out) = run("make -n BUILD=$tmp/none CC=$tmp/bin/linking");
	my ($link) = $out =~ /^(\S+ .*) -o \S*projcalc /m;
	unlike($link, qr/\Q$flag\E/, "not $flag");
	is(() = $link =~ /-Wl,/g, 2, 'but the others');
}
($status, $out) = run("make -n BUILD=$tmp/none PLAIN_NUMBERS=1 CXX=c++");
like($out, qr/^c\+\+ .* -o \S*projcalc /m, 'the C++ library is linked if it is used');

mkdir "$tmp/foreign" or die;
mkdir "$tmp/foreign/cjson" or die;
spew("$tmp/foreign/cjson/cJSON.c", '');
($status, $out, $err) = run("sh cmd/test/foreign.sh $tmp/foreign nowhere");
is($status, 1, 'foreign.sh without a compiler has tested nothing');
like($err, qr/^foreign: nothing was tested/m, 'which is said');

# Checks that the tarball has the files that git tracks, and that the unpacked tarball
# packs the same tarball.
sub packed {
	my ($dir) = @_;
	my ($status, $out, $err) = run('make -s dist', $dir);
	is("$status$err", '0', "make dist in $dir");
	my ($tarball) = glob "$dir/build/*.tar.gz";
	return ($tarball, sorted(split /\n/, told("tar -tzf $tarball")));
}
SKIP: {
	my $lacks = missing('git');
	skip "no $lacks", 6 if $lacks;
	mkdir $_ or die "$_: $!\n" for "$tmp/tree", "$tmp/tree/cmd";
	spew("$tmp/tree/Makefile", slurp('Makefile'));
	spew("$tmp/tree/cmd/main.c", "#define VERSION \"1.2.3\"\n");
	spew("$tmp/tree/NEWS.md", "## 1.2.3, 2026-01-02\n");
	spew("$tmp/tree/.gitignore", "build/\n");
	is((run('git init -q . && git add .', "$tmp/tree"))[0], 0, 'git');
	spew("$tmp/tree/notes", "mine\n");
	my ($tarball, $files) = packed("$tmp/tree");
	is($files, sorted(map { "projcalc-1.2.3/$_" }
	    qw(.gitignore Makefile NEWS.md cmd/main.c)), 'what git tracks');
	is((run("tar -xzf $tarball -C $tmp"))[0], 0, 'unpacked');
	my ($again) = packed("$tmp/projcalc-1.2.3");
	ok(slurp($again) eq slurp($tarball), 'the same from the tarball');
}
SKIP: {
	my $lacks = missing('bmake');
	skip "no $lacks", 1 if $lacks;
	($status, $out, $err) = run('bmake');
	like("$out$err", qr/^bmake: .*line \d+: projcalc is built by GNU make/,
	    'another make');
}
done_testing();
