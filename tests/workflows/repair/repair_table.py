#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Repairs the clips of clips.py and prints a line a clip: verdicts, distance from the clip, CPU time.

    repair_table.py GAITWRIGHT FOLDER [CLIP...] -- FLAGS     FLAGS choose the robot, such as --robot h1
"""
import json
import resource
import subprocess
import sys
from pathlib import Path


def line(program, folder, name, rate, flags):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    clip = next(path for path in (folder / f'{name}.csv', folder / f'{name}.txt') if path.exists())
    ran = subprocess.run([program, 'repair', str(clip), '--rate-hz', str(rate), '--json', '--out',
                          str(folder / f'{name}.json'), *flags], capture_output=True, text=True, check=False)
    cpu_s = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    result = json.loads(ran.stdout)
    if 'error' in result:
        return False, f'{name:18s} refused: {result["error"]["message"]}'
    violations = lambda audit: len(result[audit]['violations']) if result[audit] else 0
    engines = ' '.join(f'{engine} {of["verdict"]} {of["score"]:.0f}' for engine, of in result['engines'].items())
    distance = result['distance']
    passes = result['verdict'] == 'pass'
    text = (f'{name:18s} {result["verdict"]:4s} violations {violations("before"):2d} -> {violations("after"):2d}, {engines}, '
            f'joints {distance["joint_rms_rad"]:.3f} rad RMS, {distance["joint_largest_rad"]:.2f} at most, '
            f'base {1e3 * distance["base_rms_m"]:.0f} mm, {result["duration_s"]:.1f} s in {cpu_s:.1f} s of CPU')
    left_out_s = sum(change['by'] for change in result['changes'] if change['what'] == 'left_out')
    if left_out_s > 0.0:
        text += f', {left_out_s:.1f} s left out'
    return passes, text if passes else f'{text}; {result["reason"]}'


def main():
    split = sys.argv.index('--')
    program, folder, names, flags = sys.argv[1], Path(sys.argv[2]), sys.argv[3:split], sys.argv[split + 1:]
    rates = json.loads((folder / 'rates.json').read_text())
    passed = 0
    for name in names or rates:
        passes, text = line(program, folder, name, rates[name], flags)
        passed += passes
        print(text, flush=True)
    print(f'{passed} of {len(names or rates)} pass')


if __name__ == '__main__':
    main()
