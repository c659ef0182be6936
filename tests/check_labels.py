"""check_labels.py CTEST BUILD: fails where a test of the build folder has no label, and names the test; likewise where a
case of a googletest program belongs to no test, or to several."""

import collections
import json
import subprocess
import sys
from pathlib import Path

FILTER = "--gtest_filter="

ctest, build = sys.argv[1:]
listed = subprocess.run([ctest, "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True, text=True)
tests = json.loads(listed.stdout)["tests"]
bare = [test["name"] for test in tests if not any(one["name"] == "LABELS" for one in test.get("properties", []))]
if bare or not tests:
    sys.exit(f"{len(bare)} of {len(tests)} tests have no label; name their program in tests/rooms.cmake:\n"
             + "\n".join(bare[:20]))

run = collections.defaultdict(collections.Counter)
for command in (test.get("command", []) for test in tests):
    if len(command) > 1 and command[1].startswith(FILTER):
        run[command[0]].update(command[1].removeprefix(FILTER).split(":"))
wrong = [f"{case} of {program} is in {cases[case]} tests"
         for program, cases in run.items()
         for case in {*Path(f"{program}_cases.txt").read_text().split(), *cases}
         if cases[case] != 1]
if wrong:
    sys.exit("each case belongs to one test; see tests/add_cases.cmake:\n" + "\n".join(sorted(wrong)[:20]))
