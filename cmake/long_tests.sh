# SPDX-License-Identifier: BSD-3-Clause
# What ./test --long adds. Sourced by ./test after the release build, with $root set.

results=()   # rows of the table
failures=0
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
  detail=$(grep -E 'tests passed|No tests were found|files are clean|findings in' "$log" | tail -n 1 || true)
  results+=("| $name | $outcome | ${detail:-see the output} | $((SECONDS - start)) |")
}

ctest_in() {
  local preset=$1
  shift
  ctest --test-dir "$root/build/$preset" -j2 --output-on-failure --no-tests=error "$@"
}

sanitized_tests() {
  configure sanitize -DGAITWRIGHT_TESTS=ON
  build sanitize
  ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1 ctest_in sanitize -LE '^long$' "$@"
}

# Every .cc file of the tree through clang-tidy, two at a time.
tidy() {
  local files findings=$logs/tidy-findings.txt count
  files=$(cd "$root" && find kinematics planning optimisation playback workflows cli examples tests -name '*.cc' \
    -not -path 'tests/consumer/*' 2>/dev/null | sort)
  count=$(echo "$files" | wc -l)
  (cd "$root" && echo "$files" | xargs -P 2 -n 1 clang-tidy -p build/release --quiet) >"$findings" 2>"$logs/tidy-noise.txt" || true
  if grep -qE '(warning|error): ' "$findings" "$logs/tidy-noise.txt"; then
    grep -hE '(warning|error): ' "$findings" "$logs/tidy-noise.txt" | sort -u
    echo "$(grep -hE '(warning|error): ' "$findings" "$logs/tidy-noise.txt" | sort -u | wc -l) findings in $count files"
    return 1
  fi
  echo "$count files are clean"
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
  step "long tests" ctest_in release -L '^long$' "$@"
  step "tests" ctest_in release -LE '^long$' "$@"
  write_results
  printf '%s\n' "${results[@]}"
  say "Kept in docs/long-test-results.md"
  grep -h -A 3 'tests passed' "$logs/tests.log" || true
  [ "$failures" = 0 ]
}
