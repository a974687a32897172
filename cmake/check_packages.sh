#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_packages.sh BUILD: fails if the program in the folder BUILD includes or links a file of a Debian package that
# ./run would not install. Such a program builds here only because something else, such as the tests, needs that
# package.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/cmake/setup.sh"
optional_packages="libopenmpi-dev"   # taken where they are there

if ! command -v dpkg-query >/dev/null || [ ! -e "$1/build.ninja" ]; then
  echo "packages check skipped: it needs dpkg and a build by Ninja"
  exit 0
fi

# The packages that ./run installs and all their dependencies, one per line.
brought() {
  dpkg-query -W -f='${Package}\t${Provides}\t${Pre-Depends}, ${Depends}\n' | awk -F '\t' -v asked="$program_packages" '
    function names(list) { gsub(/\([^)]*\)|:[a-z0-9]+|[,|]/, " ", list); return list }
    {
      needs[$1] = names($3)
      count = split(names($2), other, " ")
      for (i = 1; i <= count; ++i) providers[other[i]] = providers[other[i]] " " $1
    }
    END {
      last = split(asked, queue, " ")
      for (first = 1; first <= last; ++first) {
        if (queue[first] in seen) continue
        seen[queue[first]]
        print queue[first]
        count = split(needs[queue[first]] providers[queue[first]], more, " ")
        for (i = 1; i <= count; ++i) queue[++last] = more[i]
      }
    }'
}

# Files outside the tree that the program is built from: headers, libraries, and files that are linked by their path.
used() {
  {
    ninja -C "$1" -t deps | awk '/#deps/ { ours = !/^(tests|python)\// } ours && /^ +\// { print $1 }'
    ninja -C "$1" -t commands gaitwright | tail -n 1 | grep -oE '(^| )/[^ ]+\.(a|so)[.0-9]*( |$)'
  } | tr -d ' ' | grep '^/usr/' | sort -u
}

expected=$(brought)
files=$(used "$1")
if [ -z "$expected" ] || [ -z "$files" ]; then
  echo "No files were found that $1 is built from"
  exit 1
fi
# dpkg does not know files of /usr/local and links of update-alternatives: these are ignored, and so are the headers of
# the compiler itself, whichever it is.
owners=$(xargs dpkg-query -S <<<"$files" 2>/dev/null || true)
others=$(awk -v fine="$expected $optional_packages" '
  BEGIN { split(fine, names); for (i in names) allowed[names[i]] }
  { package = $1; sub(/:.*/, "", package) }
  package !~ /^lib(clang|gcc|stdc\+\+)/ && !(package in allowed) { print package ": " $NF }' <<<"$owners")
if [ -n "$others" ]; then
  echo "The program uses files of packages that ./run does not install (program_packages in cmake/setup.sh):"
  echo "$others"
  exit 1
fi
echo "All files that the program uses are from packages that ./run installs"
