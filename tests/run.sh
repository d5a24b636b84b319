#!/usr/bin/env bash
# The one command that says whether gonio is well: installs what is missing, builds, tests, tests again under the
# sanitizers, and checks the form of the sources. Ends with "N passed, N failed" and fails if anything did.
#
#   tests/run.sh                     everything
#   tests/run.sh release format      only these steps; allowed: install release asan tsan format tidy
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 2

all_steps=(install release asan tsan format tidy)
steps=("$@")
[ ${#steps[@]} -gt 0 ] || steps=("${all_steps[@]}")
for step in "${steps[@]}"; do
  case " ${all_steps[*]} " in
    *" $step "*) ;;
    *) echo "run.sh: unknown step '$step'; allowed: ${all_steps[*]}" >&2; exit 2 ;;
  esac
done

passed=0 failed=0 skipped=0
failures=()

say() { printf '\n== %s (%d s)\n' "$*" "$SECONDS"; }

# count NAME STATUS: a step that is one check.
count() {
  if [ "$2" -eq 0 ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    failures+=("$1")
  fi
}

# build PRESET TARGET...: configures and builds. Only a failure counts: a build that works is not a test.
build() {
  local preset=$1
  shift
  say "$preset: configure and build"
  cmake --preset "$preset" -DGONIO_BUILD_TESTS=ON >"build/$preset-configure.log" 2>&1 || {
    cat "build/$preset-configure.log"
    count "$preset: configure" 1
    return 1
  }
  cmake --build --preset "$preset" --target "$@" || {
    count "$preset: build" 1
    return 1
  }
}

# attribute NAME FILE: a number of the JUnit report that CTest writes.
attribute() { sed -n "s/^[[:space:]]*$1=\"\([0-9]*\)\".*/\1/p" "$2" | head -n 1; }

# run_tests PRESET CTEST-ARGUMENT...: runs CTest and adds up its cases.
run_tests() {
  local preset=$1 report=$PWD/build/$1-tests.xml status=0
  shift
  say "$preset: test"
  rm -f "$report"
  ctest --preset "$preset" --parallel "$(nproc)" --output-junit "$report" "$@" >"build/$preset-tests.log" 2>&1 ||
    status=$?
  grep -v -E '^ *(Start +[0-9]+:|[0-9]+/[0-9]+ Test +#.* Passed )' "build/$preset-tests.log"
  local tests bad skips
  tests=$(attribute tests "$report") bad=$(attribute failures "$report") skips=$(attribute skipped "$report")
  if [ "${tests:-0}" -eq 0 ]; then
    count "$preset: no test ran" 1
    return
  fi
  passed=$((passed + tests - bad - skips)) failed=$((failed + bad)) skipped=$((skipped + skips))
  [ "$bad" -eq 0 ] || failures+=("$preset: $bad of $tests tests")
  # CTest can fail without a failed case (a report that it could not write, a test that vanished).
  [ "$status" -eq 0 ] || [ "$bad" -gt 0 ] || count "$preset: ctest ended with $status" 1
}

# Cases that take long under a sanitizer and say nothing of memory or threads that others do not.
left_out=(
  '/Planted\.|\.HoldsAgainstTheOracle|\.GainsNoEnergy|\.SaysWhatItLoses'  # sums of millions of values
  '^AssessPlanted\.|/AssessModel\.Passes'                   # assessments, of which there are enough at the ends of ranges
  '^Certificate\.(Intervals|HoldsOnFresh|BoundsHold)'       # how often of a hundred
  '^MeasuredMaterials\.Are|^PublishedParameters\.'          # fits and errors of millions of cells
  '^Choice\.(Larger|Rounds|TheFront|Takes|Sees|IsTheSame)'  # selections; the cases that stay make such ones too
)

# The folders whose tests have memory and threads to get wrong; each has a target that builds its programs.
sanitize() {
  local preset=$1
  shift
  build "$preset" "${@/#/tests_}" || return
  run_tests "$preset" --label-regex "^($(IFS='|'; echo "$*"))\$" --exclude-regex "$(IFS='|'; echo "${left_out[*]}")"
}

run_step() {
  case $1 in
    install) say "install"; docker/install.sh; count "docker/install.sh" $? ;;
    release) build release all && run_tests release ;;
    asan)
      export ASAN_OPTIONS=detect_stack_use_after_return=1 UBSAN_OPTIONS=print_stacktrace=1
      export LSAN_OPTIONS=suppressions=$PWD/tests/lsan_suppressions.txt:print_suppressions=0
      sanitize asan base numeric models measured engine timing assess chart fit select wire server client cli ;;
    tsan)
      # Debian's gRPC is not built for this sanitizer, which therefore sees none of the atomics by which it hands something from
      # one thread to another. What gRPC guarantees is stated where it matters (base/happens_before.h), and its headers' part of
      # the server's calls is not instrumented (server/CMakeLists.txt). What remains is the C library, called from gRPC's
      # libraries: the server's and the client's tests leave what memcpy, free and their like touch unchecked, from our code
      # too, for the sanitizer cannot tell the two apart. Nor do they report threads that nobody joined: gRPC ends on threads of
      # its own, in the middle of which a program may leave; of our threads none can, for a std::thread ends the program if
      # it is neither joined nor detached. No other report is suppressed.
      export TSAN_OPTIONS=second_deadlock_stack=1
      sanitize tsan engine wire
      # A fit, like a selection and a chart, keeps to the thread that calls it; several run at once.
      build tsan tests_fit && run_tests tsan --tests-regex '^FitRun\.IsTheSameOnEveryThread'
      TSAN_OPTIONS+=:ignore_noninstrumented_modules=1:report_thread_leaks=0
      sanitize tsan server client ;;
    format) say "clang-format"; tests/style/format.sh; count "clang-format" $? ;;
    tidy) say "clang-tidy"; tests/style/tidy.py build/release; count "clang-tidy" $? ;;
  esac
}

mkdir -p build
for step in "${steps[@]}"; do run_step "$step"; done

printf '\n'
[ $failed -eq 0 ] || printf 'failed: %s\n' "${failures[@]}"
echo "took $SECONDS s"
line="$passed passed, $failed failed"
[ $skipped -eq 0 ] || line+=", $skipped skipped"
echo "$line"
[ $failed -eq 0 ]
