# SPDX-License-Identifier: BSD-3-Clause
# Tests that ./test --long adds. Sourced by ./test after the release build, with $root set.

results=()   # rows of the table
failures=0
page=$root/docs/long-test-results.md
rooms="kinematics planning optimisation playback workflows cli examples python tests"
tested_rooms="kinematics planning optimisation playback workflows cli examples"
logs=$root/build/long-tests

# state_of_tree: the last commit that changed more than the page of results, and a hash of the differences if files differ
# from it.
state_of_tree() {
  local changes
  changes=$(git -C "$root" diff HEAD -- . ':!docs/long-test-results.md' && git -C "$root" ls-files --others --exclude-standard)
  git -C "$root" log -1 --format=%h --abbrev=10 -- . ':!docs/long-test-results.md'
  [ -z "$changes" ] || echo "with changes $(sha256sum <<<"$changes" | cut -c -10)"
}

# results_before: rows of the page of results if it is of this state of the tree.
results_before() {
  [ ! -e "$page" ] || ! grep -qF "at commit $(state_of_tree | paste -sd ' ')," "$page" || grep -E '\| (passed|\*\*failed\*\*) \|' "$page" || true
}

# wanted NAME: whether the part is asked for: its name contains one of the words that were given, or none was given.
wanted() {
  local word
  [ ${#words[@]} -gt 0 ] || return 0
  for word in "${words[@]}"; do [[ $1 != *"$word"* ]] || return 0; done
  return 1
}

# step NAME COMMAND...: runs the command, shows and logs its output, and stores its outcome and last relevant line. A
# part whose row in the page of results says passed at this state of the tree is not run again, so that a stopped call
# can be continued by the next one, in another clone too.
step() {
  local name=$1 log=$logs/${1//[ :]/-}.log start=$SECONDS outcome=passed before
  shift
  before=$(grep -F "| $name |" <<<"$rows_before" || true)
  if [[ $before == *"| passed |"* ]] || ! wanted "$name"; then
    [ -z "$before" ] || results+=("$before")
    return 0
  fi
  say "== $name"
  if ! "$@" 2>&1 | tee "$log"; then
    outcome="**failed**"
    failures=$((failures + 1))
  fi
  local detail
  detail=$(grep -E '^[0-9]+ passed, |tests passed|No tests were found|are clean|findings in|inputs over' "$log" | tail -n 1 || true)
  results+=("| $name | $outcome | ${detail:-see the output} | $((SECONDS - start)) |")
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
    not_run_yet
  } >"$page"
}

# not_run_yet: rows of the page at the start whose parts come later in this call.
not_run_yet() {
  local row name
  while read -r row; do
    name=$(cut -d '|' -f 2 <<<"$row")
    [ -z "$row" ] || grep -qF "|$name|" <(printf '%s\n' "${results[@]}") || echo "$row"
  done <<<"$rows_before"
}

# run_long_tests [WORD...]: all parts, or those whose name contains one of the words.
run_long_tests() {
  local room
  words=("$@")
  rows_before=$(results_before)
  mkdir -p "$logs"
  # first what changes sources most often, after which other parts would have to be run again
  step "clang-tidy" tidy
  step "files alone" alone
  for room in $tested_rooms; do step "sanitizers: $room" sanitized_tests "$room."; done
  step "sanitizers: readers" sanitized_tests fuzz.
  step "threads" threaded_tests
  # URDF, MJCF and meshes, which people bring, with a million inputs
  step "fuzzing: kinematics" fuzzed_readers kinematics 200000
  for room in planning playback workflows cli; do step "fuzzing: $room" fuzzed_readers "$room" 50000; done
  step "long tests" "$root/tests/run_tests.py" --build "$root/build/release" --long
  step "tests" "$root/tests/run_tests.py" --build "$root/build/release"
  write_results
  printf '%s\n' "${results[@]}"
  say "Results are in docs/long-test-results.md"
  [ "$failures" = 0 ]
}
