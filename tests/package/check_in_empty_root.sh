#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_in_empty_root.sh OUT WHEEL CACHE: in an empty system of this machine's release of Debian, the archive runs, the Debian package
# is installed by apt, runs, and is removed without a trace, and the wheel runs where Python has only NumPy.
# CACHE keeps the empty system and the packages that apt downloaded.
set -euo pipefail
out=$1 wheel=$2 cache=$3
skip() {
  echo "package check skipped: $1"
  exit 0
}
fail() {
  echo "$1"
  exit 1
}

[ "$(id -u)" = 0 ] || skip "only root can make an empty system and run programs in it"
command -v mmdebstrap >/dev/null || skip "mmdebstrap is not installed (Debian: apt-get install mmdebstrap)"
if [ -z "${GAITWRIGHT_OWN_MOUNTS:-}" ]; then
  unshare --mount true 2>/dev/null || skip "this system does not allow mounts of one's own (unshare --mount)"
  exec env GAITWRIGHT_OWN_MOUNTS=1 unshare --mount "$0" "$@"
fi

release=$(. /etc/os-release && echo "$VERSION_CODENAME")
sources=$(apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' | sort -u)
[ -n "$sources" ] || skip "apt has no package lists of Debian; run apt-get update"
mkdir -p "$cache/archives"
if [ ! -e "$cache/$release.tar" ]; then
  mmdebstrap --quiet --variant=minbase "$release" "$cache/new.tar" - <<<"$sources" ||
    skip "mmdebstrap could not make an empty system; the reason stands above"
  mv "$cache/new.tar" "$cache/$release.tar"
fi

root=$cache/root
rm -rf "$root"
mkdir "$root"
trap 'umount "$root/proc" 2>/dev/null; rm -rf --one-file-system "$root"' EXIT
tar -xf "$cache/$release.tar" -C "$root"
mount -t proc proc "$root/proc"
cp /etc/resolv.conf /etc/hosts "$root/etc/"
apt-config dump | grep -iE '^Acquire::.*proxy' >"$root/etc/apt/apt.conf.d/90proxy" || true
cp -l "$cache"/archives/*.deb "$root/var/cache/apt/archives/" 2>/dev/null || true

# inside COMMAND...: runs it in the empty system, in the folder /.
inside() {
  chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} "$@"
}
install_inside() { inside apt-get install -y -qq --no-install-recommends "$@" >"$cache/apt.log" 2>&1 || fail "$(cat "$cache/apt.log")"; }

# walk PROGRAM: walks and looks for the report.
walk() {
  rm -rf "$root/tmp/x"
  inside "$1" walk --robot a1 --distance 0.5 --out-dir /tmp/x >"$cache/walk.log" 2>&1 || fail "$(cat "$cache/walk.log")"
  [ -s "$root/tmp/x/report.html" ] || fail "$1 walk wrote no report.html"
  echo "$1: $(grep -im 1 'verdict\|pass' "$cache/walk.log" || echo walked)"
}

echo "== the archive, with nothing installed"
mkdir "$root/opt/unpacked"
tar -xzf "$(echo "$out"/gaitwright-*.tar.gz)" -C "$root/opt/unpacked" --strip-components 1
walk /opt/unpacked/bin/gaitwright
rm -rf "$root/opt/unpacked"

echo "== the Debian package"
inside apt-get update -qq -o APT::Update::Error-Mode=any >"$cache/apt.log" 2>&1 || skip "apt-get update failed in the empty system; is there a network?"
cp "$out"/gaitwright_*.deb "$root/tmp/gaitwright.deb"
install_inside /tmp/gaitwright.deb
cp -ln "$root"/var/cache/apt/archives/*.deb "$cache/archives/" 2>/dev/null || true
du -sh "$cache/archives" | sed "s|$cache/archives|of packages that it needs|"
walk gaitwright
inside python3 -c "import gaitwright; print('Python:', gaitwright.__version__, gaitwright.load_robot('a1').name)"
inside dpkg -L gaitwright >"$cache/files.txt"
inside apt-get purge -y -qq gaitwright >"$cache/apt.log" 2>&1 || fail "$(cat "$cache/apt.log")"
left=$(while read -r path; do
  [ ! -e "$root$path" ] || [[ -d $root$path && $path != *gaitwright* ]] || echo "$path"
done <"$cache/files.txt")
[ -z "$left" ] || fail "purging the package left: $left"
echo "$(wc -l <"$cache/files.txt") paths: purged"

echo "== the wheel, with NumPy alone"
inside apt-get autoremove --purge -y -qq >"$cache/apt.log" 2>&1
[ ! -e "$root/usr/lib/python3/dist-packages/numpy" ] || fail "autoremove left what the package had brought"
install_inside python3 python3-numpy
cp "$wheel"/gaitwright-*.whl "$root/tmp/"
inside sh -c 'python3 -m zipfile -e /tmp/gaitwright-*.whl /opt/site && cd /opt/site && python3 -c "
import gaitwright as gw
print(\"wheel:\", gw.__version__, gw.play(gw.plan_walk(gw.load_robot(\"a1\"), distance=0.3)).passed)"' | tee "$cache/wheel.log"
grep -q 'True$' "$cache/wheel.log" || fail "the wheel's walk did not pass"
