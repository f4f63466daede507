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
TRUTH_LIBS = -lcmocka -lmpfr -lgmp

# The program is all there is in these folders; the others hold what tests,
# studies, measures and shows it.
objects = $(addprefix $(BUILD)/,$(addsuffix .o,$(basename \
	$(wildcard $(foreach folder,$1,$(folder)/*.c $(folder)/*.cc)))))
programs = $(basename $(call objects,$1))
CORE = $(call objects,core core/kernel)
PROGRAM = $(CORE) $(call objects,cmd cmd/json cmd/scene cmd/points cmd/number)
TRUTH = $(filter-out %_test.o,$(call objects,core/test))
PEERS = $(call objects,cmd/bench/peer)
CORE_TESTS = $(filter %_test,$(call programs,core/test))
CMD_TESTS = $(filter %_test,$(call programs,cmd/test))
STABILITY = $(BUILD)/core/study/stability
TESTS = $(CORE_TESTS) $(CMD_TESTS) $(STABILITY)
BENCHES = $(call programs,core/bench cmd/bench)
FUZZERS = $(call programs,cmd/fuzz)
COMPLETIONS = $(addprefix $(BUILD)/completion/,bash zsh fish)

JOBS = $(shell nproc 2>/dev/null || echo 2)
# As many jobs as there are cores, unless the caller has said how many.
PARALLEL = $(MAKE) --no-print-directory $(if $(findstring j,$(filter-out \
	--%,$(MAKEFLAGS))),,-j$(JOBS))

# In `make deps demo` nothing is built before what it needs is installed.
FIRST = $(filter deps,$(MAKECMDGOALS))

all: $(BUILD)/projcalc

$(BUILD)/projcalc: $(PROGRAM)
	$(LINK) -o $@ $^ $(LIBS)

$(BUILD)/%.o: %.c | $(FIRST)
	@mkdir -p $(@D)
	$(CC) $(C_FLAGS) $(CFLAGS) $(FLAGS) $(CPPFLAGS) -c -o $@ $<

$(BUILD)/%.o: %.cc | $(FIRST)
	@mkdir -p $(@D)
	$(CXX) $(CXX_FLAGS) $(CXXFLAGS) $(FLAGS) $(CPPFLAGS) -c -o $@ $<

# The inner loops, and their copies for each x86-64, of which one is chosen
# when the program runs.
$(BUILD)/core/point.o $(BUILD)/core/points.o $(BUILD)/cmd/points/binary.o \
    $(call objects,core/kernel): FLAGS += -O3
ifneq ($(filter x86_64%,$(shell $(CC) -dumpmachine 2>/dev/null)),)
$(BUILD)/core/kernel/avx2.o: FLAGS += -mavx2 -mfma
$(BUILD)/core/kernel/avx512.o: FLAGS += -mavx512f -mfma
endif
# gcc would store the halves of a span and reload them as one, which stalls.
$(BUILD)/cmd/points/line_read.o: FLAGS += -fno-tree-slp-vectorize
# Others' libraries at their best, for this very processor.
$(PEERS): FLAGS += -O3 -march=native -ffp-contract=fast

$(CORE_TESTS): $(BUILD)/%: $(BUILD)/%.o $(TRUTH) $(CORE)
	$(LINK) -o $@ $^ $(TRUTH_LIBS) -lm

$(CMD_TESTS): $(BUILD)/%: $(BUILD)/%.o $(TRUTH) $(filter-out %/main.o,$(PROGRAM))
	$(LINK) -o $@ $^ $(TRUTH_LIBS) $(LIBS)

$(STABILITY): $(call objects,core/study) $(TRUTH) $(CORE)
	$(LINK) -o $@ $^ $(TRUTH_LIBS) -lm

$(BENCHES): $(BUILD)/%: $(BUILD)/%.o $(PEERS) $(TRUTH) \
    $(filter-out %/main.o,$(PROGRAM))
	$(CXX) -pthread $(LDFLAGS) -o $@ $^ $(TRUTH_LIBS) $(LIBS)

# A fuzzer has functions of talk.c of its own, and stream's reads and waits;
# of an archive only what is called is linked.
$(BUILD)/program.a: $(filter-out %/main.o %/talk.o,$(PROGRAM))
	rm -f $@
	$(AR) rcs $@ $^

$(BUILD)/cmd/fuzz/stream: LINK += -Wl,--wrap=read,--wrap=poll
$(FUZZERS): $(BUILD)/%: $(BUILD)/%.o $(BUILD)/program.a
	$(LINK) -o $@ $^ $(LIBS)

$(COMPLETIONS): $(BUILD)/completion/%: $(BUILD)/projcalc man/completion.pl
	@mkdir -p $(@D)
	perl man/completion.pl $< $* >$@

demo: | $(FIRST)
	@$(PARALLEL) -s all
	@sh cmd/demo/demo.sh $(BUILD)

# The bunny in four views, as an SVG.
views: all
	sh cmd/demo/views.sh $(BUILD) testdata/charts/views.svg

# Measured here and now, beside what others use; what is missing is left out.
bench: $(BUILD)/projcalc $(BENCHES)
	@sh cmd/bench/bench.sh $(BUILD)

# Where double breaks and exact does not.
stability: $(STABILITY)
	@$< table

chart: $(STABILITY) $(BUILD)/projcalc $(BENCHES)
	$< data > $<.dat
	gnuplot -e "data='$<.dat'" core/study/stability.gp \
	    > testdata/charts/stability.svg
	sh cmd/bench/bench.sh $(BUILD) > $(BUILD)/bench.md
	gnuplot -c cmd/bench/bench.gp $(BUILD)/bench testdata/charts
	mv $(BUILD)/bench.md testdata/charts/bench.md

# The program and its tests, for cmd/test/compilers_test.t too.
programs: $(BUILD)/projcalc $(TESTS)

RUN_TESTS = perl cmd/test/run_tests.pl
test: | $(FIRST)
	@$(PARALLEL) -s programs
	@$(RUN_TESTS) $(JOBS) $(TESTS) $(sort $(wildcard cmd/test/*_test.t))

# The instrumented program in the place of the plain one: all tests under
# address and undefined, streams under thread, one of each command under
# valgrind. Memory that the program keeps until it ends is not freed.
SANITIZE = -O1 -g -fno-sanitize-recover=all
SCRIPTED = $(patsubst %,cmd/test/%_test.t,transcripts recorded bits)
asan:
	@$(PARALLEL) -s programs BUILD=$(BUILD)/asan \
	    CFLAGS='$(SANITIZE) -fsanitize=address,undefined' \
	    LDFLAGS='-fsanitize=address,undefined'
	@ASAN_OPTIONS=detect_leaks=0 BUILD=$(BUILD)/asan $(RUN_TESTS) $(JOBS) \
	    $(TESTS:$(BUILD)/%=$(BUILD)/asan/%) $(SCRIPTED)

tsan:
	@$(PARALLEL) -s all BUILD=$(BUILD)/tsan \
	    CFLAGS='$(SANITIZE) -fsanitize=thread' LDFLAGS='-fsanitize=thread'
	@sh cmd/test/threads.sh $(BUILD)/tsan

valgrind: all
	@sh cmd/test/valgrind.sh $(BUILD)

# Which lines of the program the tests run.
coverage:
	@find $(BUILD)/coverage -name '*.gcda' -delete 2>/dev/null || true
	@$(PARALLEL) -s programs BUILD=$(BUILD)/coverage \
	    CFLAGS='-O0 -g --coverage' LDFLAGS='--coverage'
	@BUILD=$(BUILD)/coverage $(RUN_TESTS) 1 \
	    $(TESTS:$(BUILD)/%=$(BUILD)/coverage/%) $(SCRIPTED)
	@gcovr --root . --object-directory $(BUILD)/coverage \
	    --exclude '.*/(test|study)/.*' core cmd $(BUILD)/coverage

# After a change that is meant to change bits; the transcripts say which.
bits: all
	perl cmd/test/bits_test.t -w

# The same bits from both compilers, whatever they are told to optimize.
levels:
	@sh cmd/test/levels.sh $(BUILD)/levels

# The transcripts and the same bits on another processor, emulated.
arm64:
	@sh cmd/test/arm64.sh $(BUILD)/arm64

# GNU parallel and Slurm over hosts made of namespaces, some killed half-way.
cluster: all
	@sh cmd/test/cluster.sh $(BUILD)

# With clang's libFuzzer, FUZZ_SECONDS in all.
FUZZ_SECONDS = 60
FUZZED = -fno-sanitize=function -fno-sanitize-recover=all
fuzzers: $(FUZZERS)
fuzz:
	@$(PARALLEL) -s fuzzers BUILD=$(BUILD)/fuzz CC=clang CXX=clang++ \
	    CFLAGS='-O1 -g -fsanitize=fuzzer-no-link,address,undefined \
	    $(FUZZED)' LDFLAGS='-fsanitize=fuzzer,address,undefined'
	@perl cmd/fuzz/fuzz.pl $(BUILD)/fuzz $(FUZZ_SECONDS) \
	    $(FUZZERS:$(BUILD)/%=$(BUILD)/fuzz/%)

# Rewrites what the transcripts expect; read the diff before you commit it.
transcripts: all
	perl cmd/test/transcripts_test.t -w

# What is uninitialized the compilers know better than cppcheck.
lint:
	mandoc -T lint -W warning man/*.[15]
	clang-format --dry-run -Werror $(foreach room,core core/* cmd cmd/*, \
	    $(wildcard $(room)/*.[ch] $(room)/*.cc))
	shellcheck .ci/run .debian/build .debian/deps $(wildcard cmd/*/*.sh)
	cppcheck --quiet --error-exitcode=1 --std=c11 --inline-suppr \
	    --enable=warning,performance,portability --suppress=uninitvar \
	    core cmd

# Floors, rings, the length of functions.
layers: all
	@perl cmd/test/layers_test.t $(BUILD)

INSTALLED = $(BINDIR)/projcalc $(MANDIR)/man1/projcalc.1 \
	$(MANDIR)/man5/projcalc-scene.5 \
	$(DATADIR)/projcalc/projcalc.schema.json $(BASHDIR)/projcalc \
	$(ZSHDIR)/_projcalc $(FISHDIR)/projcalc.fish
MADE = $(BUILD)/projcalc man/projcalc.1 man/projcalc-scene.5 \
	man/projcalc.schema.json $(COMPLETIONS)

# Each to its place; the manual says where the schema is.
install: $(MADE)
	@set -e; set -- $(addprefix $(DESTDIR),$(INSTALLED)); \
	for file in $(MADE); do \
		mode=644; [ $$file != $(BUILD)/projcalc ] || mode=755; \
		install -d $$(dirname $$1); \
		install -m $$mode $$file $$1; \
		shift; \
	done
	sed -i 's|/usr/local/share|$(DATADIR)|' \
	    $(addprefix $(DESTDIR)$(MANDIR)/,man1/projcalc.1 man5/projcalc-scene.5)

uninstall:
	rm -f $(addprefix $(DESTDIR),$(INSTALLED))
	-rmdir $(DESTDIR)$(DATADIR)/projcalc

VERSION = $(shell sed -n 's/^\#define VERSION "\(.*\)"/\1/p' cmd/*.c)
# That of the release, by the first heading of NEWS.md.
DATE = $(shell sed -n 's/^\#\# $(VERSION), //p' NEWS.md)
DIST = projcalc-$(VERSION)

# The same bytes from the same files, whoever packs them, and when.
dist:
	@test -n '$(DATE)' || \
	    { echo 'NEWS.md has no date for $(VERSION)' >&2; exit 1; }
	@mkdir -p $(BUILD)
	tar -czf $(BUILD)/$(DIST).tar.gz --sort=name --owner=0 --group=0 \
	    --numeric-owner --mode=u+w,go-w --mtime='$(DATE) UTC' \
	    --exclude='*~' --exclude='.*.sw?' --transform='s|^|$(DIST)/|' \
	    .ci .clang-format .debian .github LICENSE Makefile NEWS.md \
	    README.md cmd core man testdata

# The tarball builds, tests, installs, uninstalls and packs itself.
distcheck: dist
	@sh cmd/test/dist.sh $(BUILD) $(DIST)

# A Debian package, with its examples run from it.
deb:
	@sh .debian/build $(BUILD) $(VERSION) $(DATE)

# All that there is to a release but its tag.
release: lint distcheck deb
	cd $(BUILD) && sha256sum $(DIST).tar.gz projcalc_$(VERSION)_*.deb

clean:
	rm -rf $(BUILD)

deps:
	@sh .debian/deps

deps-all:
	@sh .debian/deps all

help:
	@echo 'make             build $(BUILD)/projcalc'
	@echo 'make deps        install what is missing, with apt-get'
	@echo 'make demo        the Stanford bunny, seen in a terminal'
	@echo 'make test        all tests'
	@echo 'make transcripts rewrite what the transcripts expect'
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

.PHONY: all demo views bench stability chart programs test asan tsan valgrind \
	coverage bits levels arm64 cluster fuzzers fuzz transcripts lint layers \
	install uninstall dist distcheck deb release clean deps deps-all help
# Objects of test programs are kept.
.SECONDARY:
# A file that a failed command has half written must not look made.
.DELETE_ON_ERROR:

-include $(wildcard $(BUILD)/*/*.d $(BUILD)/*/*/*.d $(BUILD)/*/*/*/*.d)
