#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_archive.sh OUT: the archive in OUT works from a folder of any name, with its own robots and gaits.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/a folder" "$work/elsewhere"
tar -xzf "$(echo "$1"/gaitwright-*.tar.gz)" -C "$work/a folder" --strip-components 1
program="$work/a folder/bin/gaitwright"

# Without the caller's environment: no HOME, no GAITWRIGHT_ROBOTS, no search paths of libraries.
away() { (cd "$work/elsewhere" && env -i PATH=/usr/bin:/bin LANG=C.UTF-8 "$@"); }
fail() {
  echo "$1"
  exit 1
}

away "$program" --version
[[ $(away "$program" gaits) == *trot* ]] || fail "the archive's program does not list the gait 'trot'"
# A robot that only the archive has shows that its own data are used.
cp -r "$work/a folder/share/gaitwright/robots/a1" "$work/a folder/share/gaitwright/robots/of_the_archive"
[[ $(away "$program" robots) == *of_the_archive* ]] || fail "the archive's program lists the robots of another folder"
away "$program" walk --robot a1 --distance 0.3 --out-dir walk >"$work/walk.txt" || fail "$(cat "$work/walk.txt")"
[ -s "$work/elsewhere/walk/report.html" ] || fail "the walk wrote no report.html"

# All shared libraries but those of glibc and of the compiler are the archive's.
for file in "$program" "$work/a folder"/lib/python3*/*-packages/gaitwright/_core*.so; do
  others=$(away ldd "$file" | grep -vF "$work/a folder/" |
    grep -vE 'linux-vdso|ld-linux|lib(c|m|dl|rt|pthread|resolv|gcc_s|stdc\+\+)\.so' || true)
  [ -z "$others" ] || fail "$file loads libraries of the machine: $others"
done
away env PYTHONPATH="$(echo "$work/a folder"/lib/python3*/*-packages)" /usr/bin/python3 -c \
  'import gaitwright as gw; print(gw.load_robot("of_the_archive"))' || fail "the archive's Python module does not load its robots"

# What a student handed in may use the module too, confined to what it needs.
course="$work/a folder/share/doc/gaitwright/examples/course"
mkdir -p "$work/class/student"
cp "$course/solutions/7-stairs/stairs.py" "$work/class/student/"
sed 's/runs: 4/runs: 1/' "$course/7-stairs/rubric-python.yaml" >"$work/rubric.yaml"
chmod 755 "$work"
away "$program" grade "$work/class" --rubric "$work/rubric.yaml" --seed 1 --out-dir "$work/grades" \
  >"$work/grade.txt" 2>&1 || grep -q "cannot be run safely here" "$work/grade.txt" || fail "$(cat "$work/grade.txt")"
echo "The archive works away from where it was made"
