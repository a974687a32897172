#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_contents.sh OUT: the Debian package in OUT holds all that users need, in the folders of Debian's policy.
set -euo pipefail
out=$1
root=$(cd "$(dirname "$0")/../.." && pwd)
package=$(echo "$out"/gaitwright_*.deb)
failures=0
fail() {
  echo "$1"
  failures=$((failures + 1))
}

# Owner, permissions and path of each entry.
list=$(dpkg-deb -c "$package")
paths=$(awk '{ print substr($6, 2) }' <<<"$list")
has() { grep -qxE "$1" <<<"$paths" || fail "the package has no $1"; }

has /usr/bin/gaitwright
for room in kinematics plan planning optimisation playback walk study preflight exchange compare render words live cluster sandbox grade formats; do
  has "/usr/lib/libgaitwright_$room\.a"
done
has /usr/lib/cmake/gaitwright/gaitwrightConfig.cmake
has /usr/include/gaitwright/workflows/walk/walk.h
for robot in "$root"/robots/*/; do has "/usr/share/gaitwright/robots/$(basename "$robot")/robot.urdf"; done
has /usr/share/gaitwright/gaits.yaml
has /usr/share/gaitwright/benchmarks/centroidal_problems.json
for module in "$root"/python/gaitwright/*.py; do has "/usr/lib/python3/dist-packages/gaitwright/$(basename "$module")"; done
has '/usr/lib/python3/dist-packages/gaitwright/_core\.cpython-.*\.so'
for text in README.md CHANGELOG.md LICENSE copyright docs/README.md docs/install.md docs/reference/verbs.md; do
  has "/usr/share/doc/gaitwright/$text"
done
has '/usr/share/doc/gaitwright/docs/images/.*\.png'

outside=$(grep -vE '^/(usr(/.*)?)?$' <<<"$paths" || true)
[ -z "$outside" ] || fail "paths outside of /usr: $outside"
versioned=$(grep -E '^/usr/lib/python3\.|__pycache__|_internal\.h$|/_CPack' <<<"$paths" || true)
[ -z "$versioned" ] || fail "these files do not belong into the package: $versioned"
odd=$(awk '$2 != "root/root" || $1 !~ /^([dl]rwx|-rw[x-])r[w-][x-]r-[x-]$/ || $1 ~ /^.....w/' <<<"$list")
[ -z "$odd" ] || fail "owner or permissions of: $odd"

field() { dpkg-deb -f "$package" "$1"; }
holds() { grep -qE "$2" <<<"$(field "$1")" || fail "the field $1 has no '$2': $(field "$1")"; }
holds Package '^gaitwright$'
holds Version "^$(sed -nE 's/^project\(gaitwright VERSION ([0-9.]+).*/\1/p' "$root/CMakeLists.txt")\$"
holds Section '^science$'
holds Maintainer '<.*@.*>'
holds Architecture "^$(dpkg --print-architecture)\$"
for library in libc6 libstdc++6 libbullet libfcl libompl libyaml-cpp libcurl libfmt liburdfdom libminizip liblz4 libzstd libsqlite3 libseccomp; do
  holds Depends "(^|, )${library//+/\\+}[0-9a-z.-]* "
done
holds Depends 'python3 \(>= 3\.[0-9]+\), python3 \(<< 3\.[0-9]+\)'
holds Depends python3-numpy
holds Recommends python3-matplotlib
holds Suggests libeigen3-dev
holds Suggests libceres-dev

# The program finds shared libraries in the system's folders alone.
unpacked=$out/unpacked
rm -rf "$unpacked"
dpkg-deb -x "$package" "$unpacked"
for file in "$unpacked/usr/bin/gaitwright" "$unpacked"/usr/lib/python3/dist-packages/gaitwright/_core*.so; do
  search=$(patchelf --print-rpath "$file")
  [ -z "$search" ] || fail "${file#"$unpacked"} searches for libraries in $search"
done

# Links between the pages lead to pages that the package has.
while IFS=: read -r page link; do
  target=$(dirname "$page")/${link%%#*}
  [ -e "$target" ] || fail "${page#"$unpacked"} links to $link, which the package has not"
done < <(grep -roE --include='*.md' '\]\([^)# ]+' "$unpacked/usr/share/doc/gaitwright" | sed 's/\](//' | grep -v '://')
rm -rf "$unpacked"

[ $failures = 0 ] || exit 1
echo "$(wc -l <<<"$paths") paths are as they should be"
