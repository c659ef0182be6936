"""check_labels.py CTEST BUILD: fails where a test of the build folder has no label, and names the test."""

import json
import subprocess
import sys

ctest, build = sys.argv[1:]
listed = subprocess.run([ctest, "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True, text=True)
tests = json.loads(listed.stdout)["tests"]
bare = [test["name"] for test in tests if not any(one["name"] == "LABELS" for one in test.get("properties", []))]
if bare or not tests:
    sys.exit(f"{len(bare)} of {len(tests)} tests have no label; name their program in tests/rooms.cmake:\n"
             + "\n".join(bare[:20]))
