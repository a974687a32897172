# SPDX-License-Identifier: BSD-3-Clause
# What ./test --long adds. Sourced by ./test after the release build, with $root set.

results=()   # rows of the table
failures=0
rooms="kinematics planning optimisation playback workflows cli examples python tests"
logs=$root/build/long-tests

# step NAME COMMAND...: runs it to the terminal and a log, and notes how it went and its last telling line.
step() {
  local name=$1 log=$logs/${1// /-}.log start=$SECONDS outcome=passed
  shift
  say "== $name"
  if ! "$@" 2>&1 | tee "$log"; then
    outcome="**failed**"
    failures=$((failures + 1))
  fi
  local detail
  detail=$(grep -E 'tests passed|No tests were found|files are clean|findings in|inputs over' "$log" | tail -n 1 || true)
  results+=("| $name | $outcome | ${detail:-see the output} | $((SECONDS - start)) |")
}

ctest_in() {
  local preset=$1
  shift
  ctest --test-dir "$root/build/$preset" -j2 --output-on-failure --no-tests=error "$@"
}

# in_two_shards PROGRAM: a program of tests, its two halves at a time, each in one process, so that what its tests share,
# such as a plan, is made once.
in_two_shards() {
  local shard halves=() failed=0
  for shard in 0 1; do
    (cd "$(dirname "$1")" && GTEST_TOTAL_SHARDS=2 GTEST_SHARD_INDEX=$shard "$1" --gtest_brief=1) &
    halves+=($!)
  done
  for shard in "${halves[@]}"; do wait "$shard" || failed=1; done
  return $failed
}

# All but the long ones; single tests where arguments of ctest say which.
sanitized_tests() {
  local program failed=0 log=$logs/sanitized-programs.log
  export ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1
  configure sanitize
  build sanitize
  if [ $# -gt 0 ]; then
    ctest_in sanitize -LE '^long$' "$@"
    return
  fi
  : >"$log"
  for program in "$root"/build/sanitize/tests/*_tests; do
    [[ $program != *_long_tests ]] || continue
    in_two_shards "$program" 2>&1 | tee -a "$log" || failed=1
  done
  ctest_in sanitize -LE "^(long|${rooms// /|}|golden|architecture)$" 2>&1 | tee -a "$log" || failed=1
  echo "$(grep -oE '\[  PASSED  \] [0-9]+' "$log" | awk '{ sum += $4 } END { print sum + 0 }') tests passed in programs as a whole"
  return $failed
}

# Those programs that have threads, under the thread sanitizer.
threaded_tests() {
  configure threads -DGAITWRIGHT_TESTS=ON
  build threads playback_tests workflows_tests examples_tests
  TSAN_OPTIONS="halt_on_error=1 suppressions=$root/cmake/others_threads.txt" ctest_in threads -LE '^long$' \
    -R 'Trials|Sweep|Tune|Live|Session|Server|Jobs|Journal|SharedWork|Ranks|HardwareAdapter'
}

# fuzz_reader ROOM NAME INPUTS: a reader under libFuzzer, from what its corpus and the source tree have. What it finds is
# left in build/sanitize/found as NAME-crash-..., NAME-timeout-... and so on.
fuzz_reader() {
  local bin=$root/build/sanitize/tests corpus=$root/build/sanitize/corpus/$2 found=$root/build/sanitize/found
  mkdir -p "$corpus" "$found"
  "$bin/fuzz_$1" "$2" --write "$corpus" || return
  "$bin/libfuzzer_$1" "--reader=$2" "$corpus" "-runs=$3" -seed=1 -max_len=65536 -timeout=20 -rss_limit_mb=4096 \
    -print_final_stats=1 "-artifact_prefix=$found/$2-"
}

# Every reader for as many inputs, a million and more in all.
fuzzed_readers() {
  local room name rest readers=() each failed=0 libs=() fuzzed="kinematics planning playback workflows cli"
  configure sanitize
  for room in $fuzzed; do
    [ ! -e "$root/tests/fuzz/${room}_readers.cc" ] || libs+=("fuzz_$room" "libfuzzer_$room")
  done
  build sanitize "${libs[@]}"
  for room in $fuzzed; do
    [ -x "$root/build/sanitize/tests/fuzz_$room" ] || continue
    while read -r name rest; do readers+=("$room $name"); done < <("$root/build/sanitize/tests/fuzz_$room" --list)
  done
  each=$(((1000000 + ${#readers[@]} - 1) / ${#readers[@]}))
  for name in "${readers[@]}"; do
    # shellcheck disable=SC2086
    fuzz_reader $name "$each" || failed=$((failed + 1))
  done
  echo "$((each * ${#readers[@]})) inputs over ${#readers[@]} readers, $failed readers with defects"
  [ "$failed" = 0 ]
}

# "KEY FILE" of every .cc file of the tree; KEY changes with the file, with all that it includes, with .clang-tidy, the tool
# and the compiler's flags.
# What a file includes is what the release build, which has just run, noted.
tidy_keys() {
  local deps=$logs/tidy-includes.txt common file hashes
  common=$( (cat "$root/.clang-tidy" && grep -E '^CMAKE_(BUILD_TYPE|CXX_COMPILER|CXX_FLAGS.*):' "$root/build/release/CMakeCache.txt" &&
    clang-tidy --version) | sha256sum)
  cd "$root/build/release"
  ninja -t deps | sed -E 's/^ +//' >"$deps"
  grep -vE '^$|#deps' "$deps" | sort -u | xargs -d '\n' sha256sum 2>/dev/null |
    awk 'NR == FNR { sum[$2] = $1; next }
         /#deps/ { file = ""; next }
         file == "" { file = $1; all[file] = sum[file] }
         { all[file] = all[file] sum[$1] }
         END { for (file in all) if (sum[file] && file ~ /^\.\.\/\.\..*\.cc$/) print substr(file, 7), all[file] }' - "$deps" |
    sort | while read -r file hashes; do
    echo "$(echo "$common $hashes" | sha256sum | cut -c -64) $file"
  done
}

# tidy_file KEY FILE: one file through clang-tidy, unless it was found clean as it is.
tidy_file() {
  local found
  [ ! -e "$clean/$1" ] || return 0
  if found=$(clang-tidy -p build/release --quiet --extra-arg=-Wno-unknown-warning-option "$2" 2>&1); then
    touch "$clean/$1"
  else
    grep -E '(warning|error): ' <<<"$found" || echo "$2: error: clang-tidy failed"
  fi
}

# Every .cc file of the tree through clang-tidy, two at a time; those found clean before are not looked at again.
tidy() {
  local keys=$logs/tidy-keys.txt findings=$logs/tidy-findings.txt all
  export clean=$logs/clean
  export -f tidy_file
  mkdir -p "$clean"
  (tidy_keys) >"$keys"
  all=$(cd "$root" && find $rooms -name '*.cc' -not -path 'tests/consumer/*' | sort)
  if ! diff <(echo "$all") <(cut -d ' ' -f 2 "$keys"); then
    echo "findings in the list of files: these are not built, or built and not of the tree"
    return 1
  fi
  (cd "$root" && xargs -P 2 -n 2 bash -c 'tidy_file "$@"' tidy_file <"$keys") | sort -u | tee "$findings"
  if [ -s "$findings" ]; then
    echo "$(wc -l <"$findings") findings in $(wc -l <"$keys") files"
    return 1
  fi
  echo "$(wc -l <"$keys") files are clean"
}

write_results() {
  local commit
  commit=$(git -C "$root" describe --always --dirty 2>/dev/null || echo unknown)
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
  mkdir -p "$logs"
  step "clang-tidy" tidy
  step "tests with sanitizers" sanitized_tests "$@"
  step "threads" threaded_tests
  step "fuzzing" fuzzed_readers
  step "long tests" ctest_in release -L '^long$' "$@"
  step "tests" ctest_in release -LE '^long$' "$@"
  write_results
  printf '%s\n' "${results[@]}"
  say "Kept in docs/long-test-results.md"
  grep -h -A 3 'tests passed' "$logs/tests.log" || true
  [ "$failures" = 0 ]
}
