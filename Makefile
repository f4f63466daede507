# SPDX-License-Identifier: MIT
# make builds build/projcalc. make help lists the other targets, whose rules below have
# ## after them. GNU make skips the line of this condition; other makes read it, and
# stop.
ifeq 'GNU:' 'other'
.error projcalc is built by GNU make, which may be called gmake here
endif

# GNU's names of directories hold, and the names in capitals that others use.
PREFIX = /usr/local
prefix = $(PREFIX)
exec_prefix = $(prefix)
BINDIR = $(exec_prefix)/bin
bindir = $(BINDIR)
DATADIR = $(prefix)/share
datarootdir = $(DATADIR)
datadir = $(datarootdir)
MANDIR = $(datarootdir)/man
mandir = $(MANDIR)
BASHDIR = $(datadir)/bash-completion/completions
ZSHDIR = $(datadir)/zsh/site-functions
FISHDIR = $(datadir)/fish/vendor_completions.d
DESTDIR =

# All output goes into this folder.
BUILD = build
# Flags of the environment hold, too.
CFLAGS ?= -O2 -g
CXXFLAGS ?= $(CFLAGS)
LDFLAGS ?=
PKG_CONFIG ?= pkg-config
THREADS = -pthread

# FLAGS are needed in every build, so they are not in CFLAGS, which the command line
# replaces. They make every compiler give the same bytes: no product and sum are fused
# to an fma unless the source calls fma, sums keep their order, and -0 differs from 0.
# -fno-tree-slp-vectorize and -fno-delete-null-pointer-checks avoid two faults of gcc
# 12, for which core/test/compiler_test.c has examples. When gcc makes a vector of two
# doubles, it drops their rounding to float; and it stores the two halves of a span of
# bytes that it then loads as a whole, which stalls. It addresses some loops from a
# literal 0, and takes their accesses for unreachable (PR 110702) unless null pointers
# may be valid. -fdata-sections lets LINK put small variables together, by alignment:
# a call then touches fewer pages of memory.
FLAGS = -ffp-contract=off -fno-fast-math -fno-unsafe-math-optimizations \
	-fno-reciprocal-math -fsigned-zeros -fno-tree-slp-vectorize \
	-fno-delete-null-pointer-checks -fdata-sections $(THREADS) -MMD -MP -Wall \
	-Wextra -Wshadow -Wconversion -Wdouble-promotion -Wvla \
	$(if $(WERROR),-Werror)
C_FLAGS = -std=c11 -D_POSIX_C_SOURCE=200809L -D_FILE_OFFSET_BITS=64 \
	-Wstrict-prototypes $(INCLUDES)
CXX_FLAGS = -std=c++17 -fno-exceptions -fno-rtti $(INCLUDES)

# asked NAME,VALUE makes the variable NAME when a rule first needs it, as `make deps` may
# install what is asked first, and then keeps it.
asked = $(eval $1 := $2)$($1)
# The compilers of Linux look into /usr/local by themselves, those of macOS and BSD not
# into the folders of their packages. dragonbox's folder has the version in its name.
PREFIXES = $(if $(findstring linux,$(MACHINE)),,$(wildcard \
	/usr/local /opt/homebrew /opt/local /usr/pkg))
INCLUDES = $(call asked,INCLUDES,$(addprefix -isystem,$(wildcard \
	$(addsuffix /include,$(PREFIXES)) $(addsuffix /include/dragonbox-*, \
	/usr /usr/local $(PREFIXES)))) $(shell $(PKG_CONFIG) --cflags libcjson 2>/dev/null))
CJSON_LIBS = $(call asked,CJSON_LIBS,$(shell \
	$(PKG_CONFIG) --libs libcjson 2>/dev/null || echo -lcjson))
# Says yes if the C++ library is to take the place of fast_float or dragonbox: it is
# slower, and gives the same bytes. PLAIN_NUMBERS=1 hides both, and with 2 strtod reads.
PLAIN = $(if $(PLAIN_NUMBERS),yes,$(call asked,PLAIN,$(shell \
	printf '\043include <%s>\n' fast_float/fast_float.h dragonbox/dragonbox.h | \
	$(CXX) $(CXX_FLAGS) $(CPPFLAGS) -x c++ -E - >/dev/null 2>&1 || echo yes)))
# clang's check of calls through pointers needs the C++ library, which is not linked.
UNCHECKED = $(if $(findstring clang,$(CXX)),-fno-sanitize=function)
# HARDENING has the flags of Debian's packages; HARDENING= leaves them out. The user's
# flags come later and win. _FORTIFY_SOURCE is not defined without optimization, where
# glibc warns of it; with sanitizers, which find fewer faults in fortified code; and if
# the user's flags define it, as the compiler warns of two definitions.
fortify = $(if $(filter-out -O0,$(filter -O%,$1)),$(if $(findstring \
	_FORTIFY_SOURCE,$1 $(CPPFLAGS))$(findstring -fsanitize,$1),, \
	-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2))
PROTECTOR = -fstack-protector-strong
HARDENING = -fPIE $(PROTECTOR) $(call fortify,$1)
HARDENING_LINK = -pie $(call linkable,-Wl$(comma)-z$(comma)relro) \
	$(call linkable,-Wl$(comma)-z$(comma)now)
hardening_link = $(if $(HARDENING),$(HARDENING_LINK))
# linkable FLAG is FLAG if the linker knows it, which that of macOS does not.
comma = ,
linkable = $(call linkable_as,$1,asked$(subst =,_,$1))
linkable_as = $(if $(findstring undefined,$(origin $2)),$(call asked,$2,$(shell \
	mkdir -p $(BUILD)/has && echo 'int main(void) { return 0; }' | $(CC) $(LDFLAGS) \
	-x c - $1 -o $(BUILD)/has/linked 2>/dev/null && echo $1)),$($2))
# The C compiler links, unless the C++ files use the C++ library.
LINK = $(if $(PLAIN),$(CXX),$(CC)) $(THREADS) \
	$(call linkable,-Wl$(comma)--sort-section=alignment) $(hardening_link) \
	$(addprefix -L,$(wildcard $(addsuffix /lib,$(PREFIXES)))) $(LDFLAGS)
LIBS = $(CJSON_LIBS) -lm
TRUTH_LIBS = -lcmocka -lmpfr -lgmp

# The program consists of all files in the folders of CORE and PROGRAM. The other
# folders test, study and measure the program.
objects = $(addprefix $(BUILD)/,$(addsuffix .o,$(basename \
	$(wildcard $(foreach folder,$1,$(folder)/*.c $(folder)/*.cc)))))
programs = $(basename $(call objects,$1))
CORE = $(call objects,$(addprefix core/,refusal exact projection scene points \
	points/kernel derive))
PROGRAM = $(CORE) $(call objects,cmd $(addprefix cmd/,call draw message json scene \
	table stream number number/vector))
BUT_MAIN = $(filter-out %/main.o,$(PROGRAM))
TRUTH = $(filter-out %_test.o,$(call objects,core/test))
PEERS = $(call objects,cmd/bench/peer)
CORE_TESTS = $(filter %_test,$(call programs,core/test))
CMD_TESTS = $(filter %_test,$(call programs,cmd/test))
STABILITY = $(BUILD)/core/study/stability
TESTS = $(CORE_TESTS) $(CMD_TESTS) $(STABILITY)
BENCHES = $(call programs,core/bench cmd/bench)
FUZZERS = $(call programs,cmd/fuzz)
COMPLETIONS = $(addprefix $(BUILD)/completion/,bash zsh fish)

# One job for each processor, unless the caller gives a number.
JOBS = $(shell nproc 2>/dev/null || echo 2)
PARALLEL = $(MAKE) -s --no-print-directory \
	$(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS))

# Several targets run one after another, as their jobs would write the same files.
ifneq ($(word 2,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif

# If deps is among the targets, as in `make deps demo`, it is made first.
FIRST = $(filter deps,$(MAKECMDGOALS))

all: $(BUILD)/projcalc ## the program, build/projcalc
$(BUILD)/projcalc: $(PROGRAM)
	$(LINK) -o $@ $^ $(LIBS)

# Fails if a compiler or a header is missing, and says what to do then. What CC and CXX
# name is the caller's, and `make deps` installs none of it.
$(BUILD)/has/%: | $(FIRST)
	@mkdir -p $(@D)
	@for tool in $(firstword $(CC)) $(firstword $(CXX)); do \
	    command -v "$$tool" >/dev/null || { echo "there is no $$tool:" \
	    "'make deps' installs or names a compiler, CC and CXX choose one" \
	    >&2; exit 1; }; done
	@echo '#include <$*>' | \
	    $(CXX) $(CXX_FLAGS) $(CPPFLAGS) -x c++ -E - >$@ 2>/dev/null || \
	    { echo "$(CXX) finds no <$*>: 'make deps' installs or names what is missing;" \
	    "CPPFLAGS=-IFOLDER says where it is" >&2; exit 1; }
$(PROGRAM): | $(BUILD)/has/cjson/cJSON.h
$(BUILD)/cmd/number/number.o: FLAGS += $(if \
    $(PLAIN_NUMBERS),-DPLAIN_NUMBERS=$(PLAIN_NUMBERS))
$(TRUTH) $(addsuffix .o,$(TESTS)): | $(addprefix $(BUILD)/has/,cmocka.h mpfr.h)

$(BUILD)/%.o: %.c | $(FIRST)
	@mkdir -p $(@D)
	$(CC) $(C_FLAGS) $(call HARDENING,$(CFLAGS)) $(CFLAGS) $(FLAGS) $(CPPFLAGS) -c -o $@ $<
$(BUILD)/%.o: %.cc | $(FIRST)
	@mkdir -p $(@D)
	$(CXX) $(CXX_FLAGS) $(call HARDENING,$(CXXFLAGS)) $(CXXFLAGS) $(UNCHECKED) $(FLAGS) $(CPPFLAGS) -c -o $@ $<

MACHINE = $(call asked,MACHINE,$(shell $(CC) -dumpmachine 2>/dev/null))
x86 = $(if $(filter x86_64% amd64%,$(MACHINE)),$1)

# With -std=c11, gcc for s390x computes floats as doubles, unless this flag forbids it.
FLAGS += $(if $(filter s390x%,$(MACHINE)),$(if \
	$(findstring clang,$(CC)),,-fexcess-precision=fast))

# The inner loops are compiled with -O3, but not with sanitizers, which take too long
# then. The program chooses between AVX2 and AVX-512 when it starts; every arm64 has NEON.
$(addprefix $(BUILD)/cmd/,table/cut.o table/emit.o table/list.o table/walk.o \
    stream/job.o) \
    $(call objects,core/points/kernel cmd/number/vector): \
    FLAGS += $(if $(findstring -fsanitize,$(CFLAGS)),,-O3)
VECTOR = $(BUILD)/cmd/number/vector
$(BUILD)/core/points/kernel/avx2.o $(VECTOR)/avx2.o: \
    FLAGS += $(call x86,-mavx2 -mfma)
$(BUILD)/core/points/kernel/avx512.o: FLAGS += $(call x86,-mavx512f -mfma)
$(VECTOR)/avx512.o: FLAGS += $(call x86, \
    -mavx512f -mavx512bw -mavx512cd -mavx512dq -mavx512vl -mfma)
# With sanitizers, cmd/table/walk.c would be compiled for 20 s if each of its functions were
# compiled once for each format.
$(BUILD)/cmd/table/walk.o: FLAGS += $(if \
    $(findstring -fsanitize,$(CFLAGS)),-DINLINE=static)
# These files run on threads, on the stacks of cmd/stream/stream.c, so the size of
# their frames is limited. With -flto clang merges a command's functions of several
# files into one frame of up to 96 KB.
FRAME = $(if $(findstring -flto,$(CFLAGS)),131072,32768)
$(addprefix $(BUILD)/core/,exact/ex.o exact/map.o exact/sum.o derive/clip.o \
    derive/frustum.o derive/pick.o derive/quick_cut.o derive/ray.o) \
    $(call objects,core/points core/points/kernel cmd cmd/call cmd/message cmd/json \
    cmd/table cmd/stream cmd/number cmd/number/vector): \
    FLAGS += -Wframe-larger-than=$(FRAME)
# Without -mtune, gcc copies structs of 900 bytes with rep movsq, which is slower than
# memcpy.
$(call objects,$(addprefix core/,exact projection scene points derive)): \
    C_FLAGS += $(call x86,-mtune=skylake)
# core/exact has no buffers of variable length, so the stack protector would find
# nothing there.
$(call objects,core/exact): PROTECTOR =
# The libraries of cmd/bench/peer are compiled for this processor, to be at their best.
$(PEERS): FLAGS += -O3 -march=native -ffp-contract=fast -ftree-slp-vectorize
$(BUILD)/cmd/bench/peer/wide.o: FLAGS += -ffp-contract=off

$(STABILITY): $(call objects,core/study)
$(CORE_TESTS) $(STABILITY): $(BUILD)/%: $(BUILD)/%.o $(TRUTH) $(CORE)
	$(LINK) -o $@ $^ $(TRUTH_LIBS) -lm
$(CMD_TESTS): $(BUILD)/%: $(BUILD)/%.o $(TRUTH) $(BUT_MAIN)
	$(LINK) -o $@ $^ $(TRUTH_LIBS) $(LIBS)

$(BENCHES): $(BUILD)/%: $(BUILD)/%.o $(PEERS) $(TRUTH) $(BUT_MAIN)
	$(CXX) -pthread $(hardening_link) $(LDFLAGS) -o $@ $^ $(TRUTH_LIBS) $(LIBS)

# A fuzzer replaces the functions of message.c, and read and poll, which source.c calls,
# and calls no command. From this archive the linker takes only what a fuzzer calls.
$(BUILD)/program.a: $(filter-out %/message.o $(call objects,cmd cmd/call),$(BUT_MAIN))
	rm -f $@
	$(AR) rcs $@ $^

$(BUILD)/cmd/fuzz/fuzz_stream: LINK += -Wl,--wrap=read,--wrap=poll
$(FUZZERS): $(BUILD)/%: $(BUILD)/%.o $(BUILD)/program.a
	$(LINK) -fsanitize=fuzzer -o $@ $^ $(LIBS)

SCHEMA = $(BUILD)/projcalc.schema.json
$(SCHEMA): $(BUILD)/projcalc man/schema.pl
	perl man/schema.pl $< >$@
$(COMPLETIONS): $(BUILD)/completion/%: $(BUILD)/projcalc man/completion.pl
	@mkdir -p $(@D)
	perl man/completion.pl $< $* >$@

prove: ## each bound that core claims, checked by machine
	@perl core/proof/prove.pl
	@prove -Q core/proof/proof_test.t cmd/test/digits_test.t :: all
demo: | $(FIRST) ## the Utah teapot, seen in a terminal
	@+$(PARALLEL) all
	@$(BUILD)/projcalc draw testdata/demo.json testdata/teapot.obj
views: all ## draw the pictures of README and of the pages of `make html` again
	cat testdata/views/*.json | $(BUILD)/projcalc draw --scenes - \
	    testdata/teapot.obj >testdata/charts/views.svg
	$(DRAW) axes.json axes.obj axes.txt >../charts/axes.svg
	$(DRAW) kinds.json kinds.obj >../charts/kinds.svg
	$(DRAW) part.json room.obj >../charts/part.svg
	$(DRAW) spaces.json spaces.obj spaces.txt >../charts/spaces.svg
	$(DRAW) --lines window.json window.txt >../charts/window.svg
DRAW = cd testdata/pictures && $(abspath $(BUILD))/projcalc draw --names --scenes
html: ## the manual and the charts as pages, beside that of make wasm, build/html
	@mkdir -p $(BUILD)/html
	@perl man/html.pl $(BUILD)/html $(wildcard $(BUILD)/wasm/projcalc.html)

bench: $(BUILD)/projcalc $(BENCHES) ## speed and errors of projcalc and other programs
	@perl cmd/bench/bench.pl $(BUILD)
stability: $(STABILITY) ## scenes where double fails, and the errors there
	@$< table
chart: $(STABILITY) $(BUILD)/projcalc $(BENCHES) ## bench and stability as pictures, and README's figures
	$< data > $<.dat
	gnuplot -e "data='$<.dat'" core/study/stability.gp \
	    > testdata/charts/stability-all.svg
	gnuplot -e "data='$<.dat'; panels='distance, up, zoom, unproject, back, \
	normal depth'" core/study/stability.gp > testdata/charts/stability.svg
	perl cmd/bench/bench.pl $(BUILD) > $(BUILD)/bench.md
	perl cmd/bench/names.pl $(BUILD)/bench
	gnuplot -c cmd/bench/speed.gp $(BUILD)/bench \
	    > testdata/charts/speed.svg
	mv $(BUILD)/bench.md testdata/charts/bench.md
	perl -i cmd/bench/short.pl testdata/charts/bench.md README.md

oracle: $(BUILD)/core/test/oracle_test $(BUILD)/core/test/integers_test ## random scenes, points and integers against MPFR and GMP
	@$< 1000000
	@$(BUILD)/core/test/integers_test 1000
digits: $(BUILD)/cmd/test/texts_test ## compare the digits of vector/ with number_write
	@$< 3000000
programs: $(BUILD)/projcalc $(TESTS) ## the program and its tests
compiled_tests: $(TRUTH) $(addsuffix .o,$(TESTS)) $(call objects,core/study) \
    $(addsuffix .o,$(BENCHES))
# The longest come first, so that the processors end together, and tests that start many
# processes, which some systems start one after another, beside tests that compute.
LONGEST = $(patsubst %,%_test.t,core/proof/proof $(addprefix cmd/test/, \
	transcripts compilers fuzz differential synonyms lint fault lines pieces cameras \
	stack bits))
SCRIPTS = $(LONGEST) $(filter-out $(LONGEST), \
	$(sort $(wildcard cmd/test/*_test.t core/proof/*_test.t)))
# Warnings are errors here, unless the caller has given flags.
own_flags = $(if $(filter-out file,$(foreach flags,CFLAGS CXXFLAGS HARDENING, \
	$(origin $(flags)))),,1)
test: | $(FIRST) ## all tests
	@+$(PARALLEL) $(if $(own_flags),WERROR=1) programs
	@BUILD=$(BUILD) OWN_FLAGS=$(own_flags) perl cmd/test/run_tests.pl $(JOBS) $(SCRIPTS) $(TESTS)

# Use bits and transcripts after a change that is meant to change the output. Read the
# diff before you commit it.
bits: all ## rewrite the digests of what tests compute
	perl cmd/test/bits_test.t -w
transcripts: all ## rewrite what testdata/transcripts expect
	perl cmd/test/transcripts_test.t -w

layers: programs ## check includes, calls, functions and lines
	@perl cmd/test/layers_test.t $(BUILD)

# Only version 14 of clang-format is run, as other versions break lines elsewhere.
# cppcheck does not check unused variables, which compilers find, nor failed allocations
# in tests and benches. It does not know _Noreturn.
lint: ## the manual, the style, the scripts, the C
	mandoc -T lint -W warning man/*.[157]
	! clang-format --version | grep -q 'version 14\.' || \
	    clang-format --dry-run -Werror $(foreach room,core core/* cmd \
	    cmd/* cmd/number/vector, \
	    $(wildcard $(room)/*.[ch] $(room)/*.cc))
	shellcheck .ci/run .debian/build .debian/deps $(wildcard cmd/*/*.sh)
	cppcheck --quiet --error-exitcode=1 --std=c11 --inline-suppr core cmd \
	    --force '-D_Noreturn=__attribute__((noreturn))' \
	    --enable=warning,performance,portability $(addprefix --suppress=, \
	    uninitvar ctuuninitvar nullPointerOutOfMemory nullPointerArithmeticOutOfMemory \
	    normalCheckLevelMaxBranches) \
	    -icore/proof -icore/test -icmd/test -icmd/bench/peer/cglm.c -UCPU_COUNT

# Runs make with the flags $1 in a folder named after the target. Of the perl tests,
# only those run that test the program of that folder.
rebuilt = $(PARALLEL) BUILD=$(BUILD)/$@ CFLAGS='$1' CXXFLAGS='$1' \
	LDFLAGS='$1' \
	SCRIPTS='$(patsubst %,cmd/test/%_test.t,transcripts recorded bits)'
THREAD = -O1 -g -fno-sanitize-recover=all -fsanitize=thread
ADDRESS = -O1 -g -fno-sanitize-recover=all -fsanitize=address,undefined
FUZZ_SECONDS = 60

# Leaks are not reported, as the program does not free memory that it needs to its end.
asan: ## the tests under the address and undefined behaviour sanitizers
	@+ASAN_OPTIONS=detect_leaks=0 $(call rebuilt,$(ADDRESS)) test
tsan: ## streams of points under the thread sanitizer
	@+$(call rebuilt,$(THREAD)) all
	@sh cmd/test/threads.sh $(BUILD)/tsan
coverage: ## which lines of the program the tests run
	@find $(BUILD)/coverage -name '*.gcda' -delete 2>/dev/null || true
	@+$(call rebuilt,-O0 -g --coverage) test
	@gcovr --root . --object-directory $(BUILD)/coverage \
	    --exclude '.*/(test|study|proof)/.*' core cmd $(BUILD)/coverage
fuzzers: $(FUZZERS)
fuzz: ## clang's libFuzzer, FUZZ_SECONDS=60 in all
	@+$(call rebuilt,$(ADDRESS) -g1 -fsanitize=fuzzer-no-link) \
	    CC=clang CXX=clang++ fuzzers
	@perl cmd/fuzz/fuzz.pl $(BUILD)/fuzz $(FUZZ_SECONDS) \
	    $(FUZZERS:$(BUILD)/%=$(BUILD)/fuzz/%)
valgrind: all ## one call of each command under valgrind
	@sh cmd/test/valgrind.sh $(BUILD)
levels: ## compare bits: both compilers, each level of optimization
	@sh cmd/test/levels.sh $(BUILD)/levels
foreign: | $(FIRST) ## compare bits: other processors, emulated, musl, node; try the page
	@sh cmd/test/foreign.sh $(BUILD)/foreign
mutants: ## changes of the program that no test finds: N=400 SEED=1
	@perl cmd/test/mutants.pl $(BUILD) \
	    $(patsubst $(BUILD)/%/,%,$(sort $(dir $(PROGRAM))))
cluster: all ## GNU parallel and Slurm over hosts that are killed midway
	@sh cmd/test/cluster.sh $(BUILD)

# The program as WebAssembly, by Emscripten, with the source of cJSON that `make deps wasm`
# fetches: projcalc.js is a command under node, and projcalc.html has all that it needs.
# Debian's emcc looks for acorn where only Debian's node does.
WASM = $(BUILD)/wasm
wasm: | $(FIRST) ## the program for node and as a page for a browser, build/wasm
	@command -v emcc >/dev/null && [ -f $(BUILD)/foreign/cjson/cJSON.c ] || { \
	    echo "there is no emcc, or no source of cJSON in $(BUILD)/foreign/cjson:" \
	    "'make deps wasm' installs both on Debian" >&2; exit 1; }
	@mkdir -p $(WASM)/include
	@ln -sfn $(abspath $(BUILD)/foreign/cjson) $(WASM)/include/cjson
	@ln -sfn /usr/include/fast_float $(WASM)/include/fast_float
	@+NODE_PATH=$(NODE_PATH):/usr/share/nodejs $(PARALLEL) BUILD=$(WASM) CC=emcc \
	    CXX=em++ CFLAGS=-O2 HARDENING= THREADS= PKG_CONFIG=false PREFIXES= \
	    CPPFLAGS='-I$(WASM)/include -Wno-unsupported-floating-point-opt' \
	    $(addprefix $(WASM)/projcalc.,js html)
EMCC = $(CC) -O2 -s ALLOW_MEMORY_GROWTH=1 -s TOTAL_STACK=2MB -s EXIT_RUNTIME=1 -o $@ \
	$(filter %.o,$^) $(BUILD)/include/cjson/cJSON.c
$(BUILD)/projcalc.js: $(PROGRAM) cmd/web/node.js
	$(EMCC) -s ENVIRONMENT=node -s NODERAWFS=1 -s WASM_ASYNC_COMPILATION=0 \
	    -s NODEJS_CATCH_EXIT=0 --js-library cmd/web/node.js
	{ echo '#!/usr/bin/env node'; cat $@; } >$@.tmp && mv $@.tmp $@ && chmod +x $@
$(BUILD)/web.js: $(PROGRAM)
	$(EMCC) -s ENVIRONMENT=worker -s MODULARIZE=1 -s EXPORT_NAME=projcalc \
	    -s INVOKE_RUN=0 -s EXPORTED_RUNTIME_METHODS=FS,callMain
$(BUILD)/projcalc.html: $(wildcard cmd/web/page*) cmd/web/worker.js .debian/copyright \
    $(BUILD)/web.js
	perl cmd/web/page.pl $(BUILD) >$@
npm: wasm ## a package for npm of the program for node, build/projcalc-VERSION.tgz
	rm -rf $(BUILD)/npm && mkdir $(BUILD)/npm
	cp $(addprefix $(WASM)/projcalc.,js wasm) README.md LICENSE .debian/copyright \
	    $(BUILD)/npm
	sed 's/@VERSION@/$(VERSION)/' cmd/web/package.json >$(BUILD)/npm/package.json
	cd $(BUILD) && npm pack --silent ./npm

# MADE lists the files that are installed, and INSTALLED their places.
MADE = $(BUILD)/projcalc man/projcalc.1 man/projcalc-scene.5 \
	man/projcalc-recipes.7 man/projcalc-numbers.7 \
	$(SCHEMA) .debian/copyright $(COMPLETIONS) $(RECIPES)
INSTALLED = $(bindir)/projcalc $(mandir)/man1/projcalc.1 \
	$(mandir)/man5/projcalc-scene.5 $(mandir)/man7/projcalc-recipes.7 \
	$(mandir)/man7/projcalc-numbers.7 \
	$(datadir)/projcalc/projcalc.schema.json \
	$(datadir)/doc/projcalc/copyright $(BASHDIR)/projcalc \
	$(ZSHDIR)/_projcalc $(FISHDIR)/projcalc.fish \
	$(addprefix $(datadir)/projcalc/,$(notdir $(RECIPES)))
# The programs of projcalc-recipes(7) that are too long for the page.
RECIPES = testdata/lens.awk $(sort $(wildcard testdata/cameras/*.jq))

# The manual names the place of the schema, so install writes that place into the pages.
one_word = $(if $(word 2,$1),$(error no blanks in DESTDIR or prefix, please: $1))
install: $(MADE) ## to prefix=/usr/local, below DESTDIR
	$(call one_word,$(DESTDIR)$(prefix))
	@set -e; set -- $(addprefix $(DESTDIR),$(INSTALLED)); \
	for file in $(MADE); do \
		mode=644; [ $$file != $(BUILD)/projcalc ] || mode=755; \
		install -d $$(dirname $$1); \
		install -m $$mode $$file $$1; \
		shift; \
	done
	for page in man1/projcalc.1 man5/projcalc-scene.5 man7/projcalc-recipes.7; do \
		page=$(DESTDIR)$(mandir)/$$page; \
		sed -i.orig 's|/usr/local/share|$(datadir)|' $$page; \
		rm $$page.orig; \
	done

uninstall: ## remove the installed files
	$(call one_word,$(DESTDIR)$(prefix))
	rm -f $(addprefix $(DESTDIR),$(INSTALLED))
	-rmdir $(addprefix $(DESTDIR)$(datadir)/,projcalc doc/projcalc)

# The date of a release is in the first heading of NEWS.md, behind the version.
VERSION = $(shell sed -n 's/^\#define VERSION "\(.*\)"/\1/p' cmd/*.c)
DATE = $(shell sed -n '/^\#\# /{s/^\#\# $(VERSION), \([-0-9]*\)$$/\1/p;q;}' NEWS.md)
DIST = projcalc-$(VERSION)
# The tarball has the files that git tracks or, if made in an unpacked tarball, all
# files but BUILD. The same files give a tarball of the same bytes.
in_step:
	@test -n '$(DATE)' || { echo 'the first heading of NEWS.md must be' \
	    '$(VERSION), as in cmd/main.c, with a date' >&2; exit 1; }
dist: in_step ## a tarball
	@mkdir -p $(BUILD)
	@if [ -e .git ]; then git ls-files; \
	    else find . -samefile '$(BUILD)' -prune -o -type f -print | \
	    sed 's|^\./||' | LC_ALL=C sort; fi >$(BUILD)/dist.files
	tar -czf $(BUILD)/$(DIST).tar.gz --owner=0 --group=0 \
	    --numeric-owner --mode=u=rwX,go=rX --mtime='$(DATE) UTC' \
	    --transform='s|^|$(DIST)/|' --verbatim-files-from \
	    --files-from=$(BUILD)/dist.files
distcheck: dist ## build, test, install, uninstall and pack from the tarball
	@sh cmd/test/dist.sh $(BUILD) $(DIST)
deb: in_step ## a Debian package, and the manual's examples run from it
	@sh .debian/build $(BUILD) $(VERSION) $(DATE)
release: lint distcheck deb ## lint, distcheck and deb, with sums
	cd $(BUILD) && sha256sum $(DIST).tar.gz projcalc_$(VERSION)_*.deb

clean: ## remove the output
	rm -rf $(BUILD)
deps: ## install the packages that demo, test, foreign or wasm need, with apt-get
	@sh .debian/deps $(BUILD) $(filter-out deps,$(MAKECMDGOALS))
deps-all: ## the packages of all targets, asan to fuzz, bench, chart and wasm
	@sh .debian/deps $(BUILD) deps-all
help: ## this list
	@sed -n 's/^\([a-z0-9-]*\):.* ## /make \1	/p' $(firstword $(MAKEFILE_LIST)) | \
	    expand -t 18

# These and the targets that have ## after their rule are no files.
.PHONY: compiled_tests fuzzers in_step $(shell sed -n 's/^\([a-z0-9-]*\):.* \#\# .*/\1/p' \
	$(firstword $(MAKEFILE_LIST)))
# make keeps the objects of test programs, which are intermediate files.
.SECONDARY:
# A file that a failed command has half written is removed.
.DELETE_ON_ERROR:

-include $(wildcard $(BUILD)/*/*.d $(BUILD)/*/*/*.d $(BUILD)/*/*/*/*.d)
