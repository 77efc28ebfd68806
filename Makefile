# SPDX-License-Identifier: LGPL-2.1-or-later
# Everything here may be run again at any time: what is already there is skipped.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help
PYTHON := .venv/bin/python

.PHONY: help setup native readers demo test test-all test-core test-app test-gui matrix users lint format validation bench fuzz mutations web pythons coverage tidy docs examples pictures release release-check release-branch install-check pins translations freecad clean

help: ## List these targets
	@sed -n 's/^\([a-z-]*\):.*## /\1\t/p' $(MAKEFILE_LIST) | expand -t 12

setup: ## Install missing Debian packages, make the Python environment in .venv
	@tools/install-debian-packages.sh
	@tools/make-python-environment.sh

native: setup ## Build the native solver
	@cmake -S BalloonWorkbench/native -B build/native -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
	@cmake --build build/native -- --quiet

demo: native ## Design a balloon from an example picture
	@$(PYTHON) -m BalloonWorkbench design resources/examples/pictures/fish.png --width 300mm --out out/demo
	@echo "The files are in $(CURDIR)/out/demo:" && ls -lh out/demo | tail -n +2

readers: setup
	@tools/install-debian-packages.sh debian-packages-readers.txt
	@tools/install-gltf-validator.sh

test: native readers ## Check the code, run the tests that are not slow; logs go to build/logs
	@QUICK=yes tools/test.sh lint core app gui

test-all: native readers ## Check the code, run every test
	@tools/test.sh lint core app gui

# One part of the tests. BALLOON_TESTS replaces its folder by other arguments of pytest:
# BALLOON_TESTS="tests/gui/test_window_starts.py -x" make test-gui
test-core test-app test-gui: test-%: native readers
	@tools/test.sh $*

matrix: native ## Run the tests with FreeCAD 1.0 and 1.1 (Python 3.13, 3.14), in roots of their Debian; as root
	@tools/matrix.sh app gui engine

# Pictures of each step: build/users. A part of it: SCREENS=1366x768 THEMES=dark SUITES=forky make users
users: native ## Play six scenes with real mouse and keys: two screens, two themes, each FreeCAD; as root
	@tools/test.sh users
	@tools/matrix.sh users

lint: setup ## Check style, types and formatting
	@tools/test.sh lint

format: setup ## Format Python and C++, repair what can be repaired
	@.venv/bin/ruff check --fix --exit-zero --quiet .
	@.venv/bin/ruff format .
	@find BalloonWorkbench/native benchmarks tests/native \( -name '*.c' -o -name '*.cpp' -o -name '*.h' \) -print0 | xargs -0r .venv/bin/clang-format -i

validation bench: export PYTHONPATH := $(CURDIR):$(CURDIR)/tests/core:$(CURDIR)/benchmarks

validation: native ## Compare with every reference solution, write docs/validation.md
	@tools/install-debian-packages.sh debian-packages-validation.txt
	@$(PYTHON) benchmarks/validate.py
	@BALLOON_SCRIPTS=all BALLOON_TESTS=tests/app/document/test_example_scripts.py tools/test.sh app

# BENCH gives other sizes: BENCH="--sizes 500 2000 --evolver-sizes 2000 10000" make bench
# or the strokes of the paint window alone: BENCH=--strokes make bench
bench: native ## Time against a yardstick, NumPy and Surface Evolver, write docs/benchmarks.md
	@tools/install-debian-packages.sh debian-packages-bench.txt
	@cmake -S benchmarks -B build/bench/yardstick -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
	@cmake --build build/bench/yardstick -- --quiet
	@$(PYTHON) benchmarks/bench.py $(BENCH)

# Both run FreeCAD's window; look at what they made before you commit it.
examples: native ## Make the example documents in resources/examples anew
	@tools/in-window.sh build/examples tools/make_examples.py

pictures: native ## Make the pictures of the guide anew, in docs/images
	@BALLOON_TESTS="tests/gui/paint/test_paint.py tests/gui/paint/test_paint_fish.py tests/gui/commands/test_examples.py tests/gui/many_panels/test_tutorial_bodies.py" tools/test.sh gui
	@cp build/pictures/tutorial-*.png docs/images
	@$(PYTHON) tools/tutorial_pictures.py
	@tools/in-window.sh build/pages tools/page_pictures.py
	@$(PYTHON) tools/make_figures.py

# Files, outlines, options, kills: as many as it takes a night to try. The last lines put faults into the engine.
fuzz: native readers ## Inflate 2 000 outlines and 300 bags, read 10 000 broken files and 300 meshes, kill writers everywhere, inject 200 faults
	@BALLOON_OUTLINES=2000 BALLOON_FILES=10000 BALLOON_VALUES=1000 BALLOON_KILLS=100000 BALLOON_CUTS=300 \
	    BALLOON_COACHED=300 BALLOON_INTAKES=24 BALLOON_LAYER_SHAPES=40 BALLOON_DRAFTS=25 \
	    BALLOON_TRIANGULATED=1500 BALLOON_BAGS=300 BALLOON_MESHES=300 BALLOON_HUGE_MESHES=12 BALLOON_VARIANTS=21 \
	    BALLOON_WORD_SIZES="3mm 30mm 5m 30m" BALLOON_WORD_SHAPES="star fish heart" \
	    $(PYTHON) -m pytest -q -o faulthandler_timeout=0 --log-cli-level=INFO \
	    tests/core/outline/test_random_outlines.py tests/core/readers/test_broken_files.py tests/core/test_value_limits.py \
	    tests/core/files/test_interrupted_writing.py tests/core/machines/test_export_cuts.py tests/core/machines/test_sweeps.py tests/core/advice/test_coach_shapes.py tests/core/advice/test_coach_study.py \
	    tests/core/pattern/intake/test_intake_places.py tests/core/results/test_layers.py tests/core/design/test_draft.py tests/core/test_words.py tests/core/mesh/test_mesh_delaunay.py \
	    tests/core/bags/test_random_bags.py tests/core/bag_design/test_band_smooth.py \
	    tests/core/targets/test_broken_mesh_files.py tests/core/segmentation/test_divide_steady.py
	@BALLOON_ARRANGE_STORIES=200 BALLOON_TESTS="tests/app/document/test_arrange.py -k story" tools/test.sh app
	@BALLOON_FAULTS=200 BALLOON_TESTS=tests/app/border/test_faults.py tools/test.sh app
	@BALLOON_FAULTS=200 BALLOON_TESTS=tests/gui/test_faults.py tools/test.sh gui
	@BALLOON_LANGUAGES=English,German,French,Spanish,Japanese BALLOON_TESTS=tests/gui/panels/test_small_screen.py tools/test.sh gui

mutations: native ## Break the code in known ways, one after the other: a quick test must notice each
	@$(PYTHON) tools/mutations.py

# Pictures of the pages: build/web
web: native readers ## Open exported pages in a real browser, turn their balloons
	@tools/web.sh

pythons: native readers ## Try the engine with Python 3.10 and 3.12, where they are
	@tools/pythons.sh

coverage: native readers ## Tell which lines of core and app the tests run
	@tools/coverage.sh

tidy: setup ## Look for mistakes in the C++ with clang-tidy
	@tools/install-debian-packages.sh debian-packages-tidy.txt
	@cd BalloonWorkbench/native && failed=0 && for file in film/*.cpp cholesky/src/*.cpp; do \
	    clang-tidy --quiet $$file -- -std=c++17 -Iinclude -I. -isystem /usr/include/eigen3 2>/dev/null || failed=1; \
	    done && exit $$failed

# the Python packages of one list, for the targets that need them
build/%-tools/made-from: tools/requirements-%.txt | setup
	@tools/pip-install.sh $(PYTHON) --upgrade --target build/$*-tools --requirement $<
	@cp $< $@

docs: export PYTHONPATH := $(CURDIR)/build/docs-tools
docs: build/docs-tools/made-from ## Write the user guide and the reference of the engine to build/docs
	@$(PYTHON) tools/option_tables.py
	@$(PYTHON) -m mkdocs build --quiet
	@# pdoc does not see in which module the types of a NamedTuple were named
	@$(PYTHON) -W error::UserWarning -W "ignore:Error parsing type annotation ForwardRef('Floats')" \
	    -m pdoc -o build/docs/api BalloonWorkbench.core

release release-check release-branch install-check: export PYTHONPATH := $(CURDIR)/build/release-tools

release: build/release-tools/made-from ## Compile the solver for five platforms, pack addon and wheels into build/release
	@$(PYTHON) tools/native_libraries.py build/native-libraries
	@$(PYTHON) tools/release.py build/native-libraries build/release

release-check: release ## Run and read what was released: here, in QEMU, in Wine
	@tools/install-debian-packages.sh debian-packages-release.txt
	@$(PYTHON) tools/check_release.py build/native-libraries build/release

# REPOSITORY="FOLDER" commits to the branch release of another repository
release-branch: release ## Commit the release to the branch release, from which FreeCAD's Addon Manager installs
	@$(PYTHON) tools/release_branch.py build/native-libraries $(REPOSITORY)

install-check: release ## Install what is released in each FreeCAD with an empty home, use it, remove it; as root
	@$(PYTHON) tools/install_check.py build/native-libraries build/install-check

# PINS="--upgrade" takes the newest versions of what is not pinned in requirements*.in
pins: export PYTHONPATH := $(CURDIR)/build/pins-tools
pins: build/pins-tools/made-from ## Write versions and sums of all Python packages to the lists requirements*.txt
	@tools/pins.sh $(PINS)

translations: setup ## Collect the texts of the source into resources/translations, compile what is translated
	@tools/install-debian-packages.sh debian-packages-translations.txt
	@$(PYTHON) tools/translations.py
	@lrelease -silent resources/translations/*.ts

freecad: native ## Open FreeCAD with the workbench, in a user folder of its own under build
	@tools/in-freecad.sh build/freecad freecad

clean: ## Remove what was built and written; .venv stays
	rm -rf build out BalloonWorkbench/native/lib
	find . -name __pycache__ -not -path './.venv/*' -prune -exec rm -rf {} +
