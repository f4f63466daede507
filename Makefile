# make builds build/projcalc; make help lists the rest. GNU make.

PREFIX = /usr/local
BINDIR = $(PREFIX)/bin
DATADIR = $(PREFIX)/share
MANDIR = $(DATADIR)/man
BASHDIR = $(DATADIR)/bash-completion/completions
ZSHDIR = $(DATADIR)/zsh/site-functions
FISHDIR = $(DATADIR)/fish/vendor_completions.d
DESTDIR =

# Everything that is made goes here.
BUILD = build

CFLAGS = -O2 -g
CXXFLAGS = $(CFLAGS)
LDFLAGS =

# The same bytes from every compiler: no fused multiply-add that isn't written.
FLAGS = -ffp-contract=off -pthread -MMD -MP -Wall -Wextra -Wshadow \
	-Wconversion -Wdouble-promotion -Wvla $(if $(WERROR),-Werror)
C_FLAGS = -std=c11 -D_POSIX_C_SOURCE=200809L -Wstrict-prototypes
# Debian keeps dragonbox in a directory that is named after its version.
CXX_FLAGS = -std=c++17 -fno-exceptions -fno-rtti \
	$(addprefix -isystem,$(wildcard /usr/include/dragonbox-*))
# The C++ uses headers alone: the C compiler links.
LINK = $(CC) -pthread $(LDFLAGS)
LIBS = -lcjson -lm

# What only tests link.
TRUTHS = $(wildcard core/truth*.c core/real.c core/sample.c)
STABILITY = core/stability.c core/ways.c core/regimes.c core/naive.c
SOURCES = $(filter-out %_test.c %_bench.c %_bench.cc %_fuzz.c %_shim.c $(TRUTHS) \
	$(STABILITY),\
	$(wildcard core/*.c cmd/*.c cmd/*.cc))
OBJECTS = $(addprefix $(BUILD)/,$(addsuffix .o,$(basename $(SOURCES))))
CORE = $(filter $(BUILD)/core/%,$(OBJECTS))
# Others' programs beside ours in the benchmarks.
PEERS = $(addprefix $(BUILD)/,$(addsuffix .o,$(basename \
	$(wildcard cmd/peer_*_bench.c cmd/peer_*_bench.cc))))
BENCHES = $(BUILD)/core/points_bench $(BUILD)/cmd/peers_bench
TRUTH = $(patsubst %.c,$(BUILD)/%.o,$(TRUTHS))
CORE_TESTS = $(patsubst %.c,$(BUILD)/%,$(wildcard core/*_test.c))
CMD_TESTS = $(patsubst %.c,$(BUILD)/%,$(wildcard cmd/*_test.c))
TESTS = $(CORE_TESTS) $(CMD_TESTS) $(BUILD)/core/stability

JOBS = $(shell nproc 2>/dev/null || echo 2)
# As many jobs as there are cores, unless the caller has said how many.
PARALLEL = $(MAKE) --no-print-directory $(if $(findstring j,$(filter-out \
	--%,$(MAKEFLAGS))),,-j$(JOBS))

# In `make deps demo` nothing is built before what it needs is installed.
FIRST = $(filter deps,$(MAKECMDGOALS))

all: $(BUILD)/projcalc

$(BUILD)/projcalc: $(OBJECTS)
	$(LINK) -o $@ $^ $(LIBS)

$(BUILD)/%.o: %.c | $(FIRST)
	@mkdir -p $(@D)
	$(CC) $(C_FLAGS) $(CFLAGS) $(TARGET) $(FLAGS) $(CPPFLAGS) -c -o $@ $<

$(BUILD)/%.o: %.cc | $(FIRST)
	@mkdir -p $(@D)
	$(CXX) $(CXX_FLAGS) $(CXXFLAGS) $(FLAGS) $(CPPFLAGS) -c -o $@ $<

# The copies of the inner loops for each x86-64, chosen when the program runs.
ifneq ($(filter x86_64%,$(shell $(CC) -dumpmachine 2>/dev/null)),)
$(BUILD)/core/kernels_avx2.o: TARGET = -mavx2 -mfma
$(BUILD)/core/kernels_avx512.o: TARGET = -mavx512f -mfma
endif
# gcc would store the halves of a span and reload them as one, which stalls.
$(BUILD)/cmd/record_read.o: TARGET = -fno-tree-slp-vectorize
$(filter %/binary.o %/points.o %/carry.o $(BUILD)/core/kernels_%,$(OBJECTS)): TARGET += -O3

$(CORE_TESTS): $(BUILD)/%: $(BUILD)/%.o $(CORE) $(TRUTH)
	$(LINK) -o $@ $^ -lcmocka -lmpfr -lgmp -lm

$(CMD_TESTS): $(BUILD)/%: $(BUILD)/%.o $(OBJECTS) $(TRUTH)
	$(LINK) -o $@ $(filter-out %/cmd/main.o,$^) -lcmocka -lmpfr -lgmp \
	    $(LIBS)

$(BUILD)/core/stability: $(patsubst %.c,$(BUILD)/%.o,$(STABILITY)) $(CORE) \
    $(TRUTH)
	$(LINK) -o $@ $^ -lmpfr -lgmp -lm

# Others' libraries at their best, for this very processor.
$(PEERS): FLAGS += -O3 -march=native -ffp-contract=fast

$(BUILD)/core/points_bench: %: %.o $(BUILD)/core/sample.o $(CORE)
	$(LINK) -o $@ $^ -lm

$(BUILD)/cmd/peers_bench: %: %.o $(PEERS) $(CORE) $(TRUTH)
	$(CXX) -pthread $(LDFLAGS) -o $@ $^ -lmpfr -lgmp -lm

# Measured here and now, beside what others use; what is missing is left out.
bench: $(BUILD)/projcalc $(BENCHES)
	@sh cmd/bench.sh $(BUILD)

# Where double breaks and exact does not.
stability: $(BUILD)/core/stability
	@$< table

chart: $(BUILD)/core/stability $(BUILD)/projcalc $(BENCHES)
	$< data > $(BUILD)/core/stability.dat
	gnuplot -e "data='$(BUILD)/core/stability.dat'" core/stability.gp \
	    > testdata/charts/stability.svg
	sh cmd/bench.sh $(BUILD) > $(BUILD)/bench.md
	gnuplot -c cmd/bench.gp $(BUILD)/bench testdata/charts
	mv $(BUILD)/bench.md testdata/charts/bench.md

# The program and its tests, for cmd/compilers_test.t too.
programs: $(BUILD)/projcalc $(TESTS)

demo: | $(FIRST)
	@$(PARALLEL) -s all
	@sh cmd/demo.sh $(BUILD)

# The bunny in four views, as an SVG.
views: all
	sh cmd/views.sh $(BUILD) testdata/charts/views.svg

test: | $(FIRST)
	@$(PARALLEL) -s programs
	@perl cmd/run_tests.pl $(JOBS) $(TESTS) $(sort $(wildcard cmd/*_test.t))

# The instrumented program in the places of the plain one: all tests under
# address and undefined, streams under thread, one of each command under
# valgrind. What the program holds to its end is no leak.
SANITIZE = -O1 -g -fno-sanitize-recover=all
SCRIPTED = cmd/golden_test.t cmd/recorded_test.t cmd/bits_test.t
asan:
	@$(PARALLEL) -s programs BUILD=$(BUILD)/asan \
	    CFLAGS='$(SANITIZE) -fsanitize=address,undefined' \
	    LDFLAGS='-fsanitize=address,undefined'
	@ASAN_OPTIONS=detect_leaks=0 BUILD=$(BUILD)/asan \
	    perl cmd/run_tests.pl $(JOBS) \
	    $(TESTS:$(BUILD)/%=$(BUILD)/asan/%) $(SCRIPTED)

tsan:
	@$(PARALLEL) -s all BUILD=$(BUILD)/tsan \
	    CFLAGS='$(SANITIZE) -fsanitize=thread' LDFLAGS='-fsanitize=thread'
	@sh cmd/threads.sh $(BUILD)/tsan

valgrind: all
	@sh cmd/valgrind.sh $(BUILD)

# Which lines of core and cmd the tests run.
coverage:
	@rm -f $(BUILD)/coverage/*/*.gcda
	@$(PARALLEL) -s programs BUILD=$(BUILD)/coverage \
	    CFLAGS='-O0 -g --coverage' LDFLAGS='--coverage'
	@BUILD=$(BUILD)/coverage perl cmd/run_tests.pl 1 \
	    $(TESTS:$(BUILD)/%=$(BUILD)/coverage/%) $(SCRIPTED)
	@gcovr --root . --object-directory $(BUILD)/coverage \
	    --exclude '.*_(test|fuzz|bench|shim)\..*' $(addprefix --exclude ,\
	    $(TRUTHS) $(STABILITY)) core cmd $(BUILD)/coverage

# After a change that is meant to change bits; the golden cases say which.
bits: all
	perl cmd/bits_test.t -w

# The same bits from both compilers, whatever they are told to optimize.
levels:
	@for how in gcc,g++,1 gcc,g++,2 gcc,g++,3 \
	    clang,clang++,1 clang,clang++,2 clang,clang++,3; do \
		IFS=,; set -- $$how; unset IFS; \
		echo "$$1 -O$$3"; \
		$(PARALLEL) -s all BUILD=$(BUILD)/levels/$$1-$$3 CC=$$1 \
		    CXX=$$2 CFLAGS="-O$$3 -g" && \
		perl cmd/bits_test.t $(BUILD)/levels/$$1-$$3 >$(BUILD)/levels/said || \
		    { grep -v '^ok' $(BUILD)/levels/said; exit 1; }; \
	done

# The golden cases and the same bits on another processor, emulated.
arm64:
	@sh cmd/arm64.sh $(BUILD)/arm64

# GNU parallel and Slurm over hosts made of namespaces, some killed half-way.
cluster: all
	@sh cmd/cluster.sh $(BUILD)

# With clang's libFuzzer, FUZZ_SECONDS in all; a fuzzer has a talk.c of its own,
# and of an archive only what is called is linked.
FUZZ_SECONDS = 60
FUZZERS = $(patsubst %.c,$(BUILD)/%,$(wildcard cmd/*_fuzz.c))
$(BUILD)/parts.a: $(filter-out %/main.o %/talk.o,$(OBJECTS))
	rm -f $@
	$(AR) rcs $@ $^

$(FUZZERS): $(BUILD)/%: $(BUILD)/%.o $(BUILD)/parts.a
	$(LINK) $(WRAP) -o $@ $^ $(LIBS)

$(BUILD)/cmd/stream_fuzz: WRAP = -Wl,--wrap=read,--wrap=poll
fuzzers: $(FUZZERS)

FUZZED = -fno-sanitize=function -fno-sanitize-recover=all
fuzz:
	@$(PARALLEL) -s fuzzers BUILD=$(BUILD)/fuzz CC=clang CXX=clang++ \
	    CFLAGS='-O1 -g -fsanitize=fuzzer-no-link,address,undefined \
	    $(FUZZED)' LDFLAGS='-fsanitize=fuzzer,address,undefined'
	@perl cmd/fuzz.pl $(BUILD)/fuzz $(FUZZ_SECONDS) \
	    $(FUZZERS:$(BUILD)/%=$(BUILD)/fuzz/%)

# Rewrites what the golden cases expect; read the diff before you commit it.
golden: all
	perl cmd/golden_test.t -w

# What is uninitialized the compilers know better than cppcheck.
lint:
	mandoc -T lint -W warning man/*.[15]
	clang-format --dry-run -Werror $(wildcard core/*.[ch] cmd/*.[ch] cmd/*.cc)
	shellcheck .ci/run .debian/build $(wildcard cmd/*.sh)
	cppcheck --quiet --error-exitcode=1 --std=c11 --inline-suppr \
	    --enable=warning,performance,portability --suppress=uninitvar \
	    core cmd

# Floors, rings, the length of functions and files.
layers:
	@perl cmd/layers_test.t

# What the program is made of, for cmd/layers_test.t.
sources:
	@echo $(SOURCES)

$(BUILD)/completion/%: $(BUILD)/projcalc cmd/completion.pl
	@mkdir -p $(@D)
	perl cmd/completion.pl $< $* >$@

INSTALLED = $(BINDIR)/projcalc $(MANDIR)/man1/projcalc.1 \
	$(MANDIR)/man5/projcalc-scene.5 \
	$(DATADIR)/projcalc/projcalc.schema.json $(BASHDIR)/projcalc \
	$(ZSHDIR)/_projcalc $(FISHDIR)/projcalc.fish

install: all $(addprefix $(BUILD)/completion/,bash zsh fish)
	install -d $(addprefix $(DESTDIR),$(dir $(INSTALLED)))
	install -m 755 $(BUILD)/projcalc $(DESTDIR)$(BINDIR)
	install -m 644 man/projcalc.1 $(DESTDIR)$(MANDIR)/man1
	install -m 644 man/projcalc-scene.5 $(DESTDIR)$(MANDIR)/man5
	sed -i 's|/usr/local/share|$(DATADIR)|' $(addprefix \
	    $(DESTDIR)$(MANDIR)/,man1/projcalc.1 man5/projcalc-scene.5)
	install -m 644 man/projcalc.schema.json $(DESTDIR)$(DATADIR)/projcalc
	install -m 644 $(BUILD)/completion/bash $(DESTDIR)$(BASHDIR)/projcalc
	install -m 644 $(BUILD)/completion/zsh $(DESTDIR)$(ZSHDIR)/_projcalc
	install -m 644 $(BUILD)/completion/fish \
	    $(DESTDIR)$(FISHDIR)/projcalc.fish

uninstall:
	rm -f $(addprefix $(DESTDIR),$(INSTALLED))
	-rmdir $(DESTDIR)$(DATADIR)/projcalc

VERSION = $(shell sed -n 's/^\#define VERSION "\(.*\)"/\1/p' cmd/*.c)
# That of the release, by the first heading of NEWS.md.
DATE = $(shell sed -n 's/^\#\# $(VERSION), //p' NEWS.md)
DIST = projcalc-$(VERSION)
DIST_FILES = .ci .clang-format .debian .github LICENSE Makefile NEWS.md \
	README.md cmd core man testdata

# The same bytes from the same files, whoever packs them, and when.
dist:
	@test -n '$(DATE)' || \
	    { echo 'NEWS.md has no date for $(VERSION)' >&2; exit 1; }
	@mkdir -p $(BUILD)
	tar -czf $(BUILD)/$(DIST).tar.gz --sort=name --owner=0 --group=0 \
	    --numeric-owner --mode=u+w,go-w --mtime='$(DATE) UTC' \
	    --exclude='*~' --exclude='.*.sw?' --transform='s|^|$(DIST)/|' \
	    $(DIST_FILES)

# The tarball builds, tests, installs, uninstalls and packs itself.
CHECK = $(abspath $(BUILD))/distcheck
distcheck: dist
	rm -rf $(CHECK)
	mkdir -p $(CHECK)
	tar -xzf $(BUILD)/$(DIST).tar.gz -C $(CHECK)
	$(MAKE) -C $(CHECK)/$(DIST) BUILD=build test
	$(MAKE) -C $(CHECK)/$(DIST) BUILD=build DESTDIR=$(CHECK)/root install
	cd $(CHECK)/$(DIST) && \
	    perl cmd/examples_test.t $(CHECK)/root$(BINDIR) >../examples || \
	    { grep -v '^ok' ../examples; exit 1; }
	$(MAKE) -C $(CHECK)/$(DIST) BUILD=build DESTDIR=$(CHECK)/root uninstall
	test -z "$$(find $(CHECK)/root -type f)"
	$(MAKE) -C $(CHECK)/$(DIST) BUILD=build dist
	cmp $(BUILD)/$(DIST).tar.gz $(CHECK)/$(DIST)/build/$(DIST).tar.gz
	rm -rf $(CHECK)

# A Debian package, with its examples run from it.
deb:
	@sh .debian/build $(BUILD) $(VERSION) $(DATE)

# All that there is to a release but its tag.
release: lint distcheck deb
	cd $(BUILD) && sha256sum $(DIST).tar.gz projcalc_$(VERSION)_*.deb

clean:
	rm -rf $(BUILD)

# Debian packages: what the program is made of, what its tests want beside it,
# what `make lint` runs.
DEPS = g++ make libc6-dev libcjson-dev libfast-float-dev libdragonbox-dev \
	clang jq libcmocka-dev libgmp-dev libmpfr-dev mandoc perl \
	clang-format cppcheck shellcheck gnuplot-nox libclang-rt-14-dev \
	python3-jsonschema parallel dpkg-dev
# What valgrind, coverage, arm64, cluster (servers among it) and bench want.
MORE_DEPS = valgrind gcovr gcc-aarch64-linux-gnu g++-aarch64-linux-gnu \
	qemu-user-static libcjson-dev:arm64 iproute2 openssh-client \
	openssh-server rsync munge slurm-client slurmctld slurmd \
	libglm-dev libcglm-dev libeigen3-dev mawk proj-bin python3-numpy

# Installs the packages that are missing, and only then touches the network.
deps:
	@if ! command -v dpkg-query >/dev/null; then \
		echo 'make deps: this is not Debian; what is needed, by its' \
		    'Debian names: $(DEPS)'; \
		exit; \
	fi; \
	missing=; \
	for package in $(DEPS); do \
		dpkg-query -W -f '$${Status}' "$$package" 2>/dev/null | \
		    grep -q ' installed$$' || missing="$$missing $$package"; \
	done; \
	if [ -z "$$missing" ]; then \
		echo 'make deps: nothing is missing'; \
		exit; \
	fi; \
	echo "make deps: apt-get installs$$missing"; \
	sudo=; \
	[ "$$(id -u)" = 0 ] || sudo=sudo; \
	$$sudo apt-get -qq update && \
	$$sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq -y \
	    --no-install-recommends install $$missing

deps-all:
	@sudo=; \
	[ "$$(id -u)" = 0 ] || sudo=sudo; \
	$$sudo dpkg --add-architecture arm64
	@$(MAKE) -s deps DEPS='$(DEPS) $(MORE_DEPS)'

help:
	@echo 'make             build $(BUILD)/projcalc'
	@echo 'make deps        install what is missing, with apt-get'
	@echo 'make demo        the Stanford bunny, seen in a terminal'
	@echo 'make test        all tests'
	@echo 'make golden      rewrite the golden cases'
	@echo 'make lint        the manual page, the style, the scripts, the C'
	@echo 'make layers      floors of the house, lengths of its functions'
	@echo 'make asan        all tests under sanitizers; tsan, valgrind, coverage,'
	@echo '                 levels, arm64, fuzz (FUZZ_SECONDS=60), cluster: see the'
	@echo '                 Makefile; make deps-all installs what they want'
	@echo 'make bench       measure, beside what others use; make chart draws it'
	@echo 'make install     to PREFIX=$(PREFIX), below DESTDIR'
	@echo 'make uninstall'
	@echo 'make dist        a tarball; make distcheck tests it'
	@echo 'make deb         a Debian package'
	@echo 'make release     lint, distcheck, deb'
	@echo 'make clean'

.PHONY: bits asan tsan valgrind coverage levels arm64 cluster fuzz fuzzers \
	stability bench chart views all programs demo test golden lint \
	install uninstall layers sources dist distcheck deb release clean deps \
	deps-all help
# Objects of test programs are kept.
.SECONDARY:
# A file that a failed command has half written must not look made.
.DELETE_ON_ERROR:

-include $(wildcard $(BUILD)/*/*.d)
