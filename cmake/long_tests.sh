# SPDX-License-Identifier: BSD-3-Clause
# Tests that ./test --long adds. Sourced by ./test after the release build, with $root set.

results=()   # rows of the table
failures=0
rooms="kinematics planning optimisation playback workflows cli examples python tests"
tested_rooms="kinematics planning optimisation playback workflows cli examples"
logs=$root/build/long-tests

# state_of_tree: the commit, and a hash of the differences if files differ from it, except for the page of results.
state_of_tree() {
  local changes
  changes=$(git -C "$root" diff HEAD -- . ':!docs/long-test-results.md' && git -C "$root" ls-files --others --exclude-standard)
  git -C "$root" rev-parse --short=10 HEAD
  [ -z "$changes" ] || echo "with changes $(sha256sum <<<"$changes" | cut -c -10)"
}

# step NAME COMMAND...: runs the command, shows and logs its output, and stores its outcome and last relevant line. A
# part that has passed at this state of the tree is not run again, so that a stopped call can be continued by the next
# one.
step() {
  local name=$1 log=$logs/${1//[ :]/-}.log start=$SECONDS outcome=passed
  local kept=$logs/passed/$(state_of_tree | sha256sum | cut -c -16)-${1//[ :]/-}
  shift
  if [ -e "$kept" ]; then
    say "== $name: passed before"
    results+=("$(cat "$kept")")
    return
  fi
  say "== $name"
  if ! "$@" 2>&1 | tee "$log"; then
    outcome="**failed**"
    failures=$((failures + 1))
  fi
  local detail row
  detail=$(grep -E '^[0-9]+ passed, |tests passed|No tests were found|are clean|findings in|inputs over' "$log" | tail -n 1 || true)
  row="| $name | $outcome | ${detail:-see the output} | $((SECONDS - start)) |"
  results+=("$row")
  mkdir -p "$logs/passed"
  [ "$outcome" != passed ] || echo "$row" >"$kept"
  write_results
}

# sanitized_tests PATTERN: the tests of the build with sanitizers whose name matches, except the long ones. For tests of
# more than 2 s without sanitizers, shorter tests run the same code.
sanitized_tests() {
  export GAITWRIGHT_TESTS_AT_MOST=2
  export ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1
  configure sanitize
  build sanitize
  "$root/tests/run_tests.py" --build "$root/build/sanitize" "$@"
}

# Only programs with threads, under the thread sanitizer.
threaded_tests() {
  configure threads -DGAITWRIGHT_TESTS=ON
  build threads playback_tests workflows_tests examples_tests
  TSAN_OPTIONS="halt_on_error=1 suppressions=$root/cmake/others_threads.txt" "$root/tests/run_tests.py" \
    --build "$root/build/threads" Trials Sweep Tune Live Session Server Jobs Journal SharedWork Ranks HardwareAdapter
}

# fuzz_reader ROOM NAME INPUTS: a reader under libFuzzer, starting from its inputs in the source tree, so that a run does
# not depend on those before. Inputs that cause defects are saved in build/sanitize/found as NAME-crash-...,
# NAME-timeout-... and so on.
fuzz_reader() {
  local bin=$root/build/sanitize/tests corpus=$root/build/sanitize/corpus/$2 found=$root/build/sanitize/found
  rm -rf "$corpus"
  mkdir -p "$corpus" "$found"
  "$bin/fuzz_$1" "$2" --write "$corpus" &&
    "$bin/libfuzzer_$1" "--reader=$2" "$corpus" "-runs=$3" -seed=1 -max_len=65536 -timeout=60 -rss_limit_mb=4096 \
      -print_final_stats=1 "-artifact_prefix=$found/$2-" >"$logs/fuzzing-$1-$2.log" 2>&1 &&
    echo "$2: passed, $3 inputs" || echo "$2: failed, see $logs/fuzzing-$1-$2.log"
}

# fuzzed_readers ROOM INPUTS: every reader of the room with that number of inputs, as many at once as there are cores.
fuzzed_readers() {
  local readers
  configure sanitize
  build sanitize "fuzz_$1" "libfuzzer_$1"
  readers=$("$root/build/sanitize/tests/fuzz_$1" --list | cut -d ' ' -f 1)
  export root logs
  export -f fuzz_reader
  xargs -P "$(nproc)" -I {} bash -c "fuzz_reader $1 {} $2" <<<"$readers" | tee "$logs/fuzzing-$1-readers.log"
  echo "$(($2 * $(wc -w <<<"$readers"))) inputs over $(wc -w <<<"$readers") readers," \
    "$(grep -c ': failed' "$logs/fuzzing-$1-readers.log") readers with defects"
  ! grep -q ': failed' "$logs/fuzzing-$1-readers.log"
}

# Every .cc file of the tree that has changed since its last clean result.
tidy() {
  "$root/cmake/tidy.py" $rooms
}

# Every .cc file compiled without the others of its folder.
alone() {
  configure editor
  "$root/cmake/tidy.py" --alone $rooms
}

write_results() {
  local commit
  commit=$(state_of_tree | paste -sd ' ')
  {
    echo "# Results of the long tests"
    echo
    echo "Written by \`./test --long\` at commit $commit, $(date -u +%Y-%m-%d), with $(c++ --version | head -n 1)."
    echo
    echo "| part | outcome | detail | seconds |"
    echo "|---|---|---|---|"
    printf '%s\n' "${results[@]}"
  } >"$root/docs/long-test-results.md"
}

run_long_tests() {
  local room
  mkdir -p "$logs"
  for room in $tested_rooms; do step "sanitizers: $room" sanitized_tests "$room."; done
  step "sanitizers: readers" sanitized_tests fuzz.
  step "threads" threaded_tests
  # URDF, MJCF and meshes, which people bring, with a million inputs
  step "fuzzing: kinematics" fuzzed_readers kinematics 200000
  for room in planning playback workflows cli; do step "fuzzing: $room" fuzzed_readers "$room" 50000; done
  step "clang-tidy" tidy
  step "files alone" alone
  step "long tests" "$root/tests/run_tests.py" --build "$root/build/release" --long
  step "tests" "$root/tests/run_tests.py" --build "$root/build/release"
  write_results
  printf '%s\n' "${results[@]}"
  say "Results are in docs/long-test-results.md"
  [ "$failures" = 0 ]
}
