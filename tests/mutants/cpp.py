"""Faults in plan, record and weights: each built into a copy of the tree."""

import os
import shutil
import subprocess
import time
from pathlib import Path

from mutant import ROOT, BadMutant, Mutant, failed_test

PRESET = "build/default"
SECONDS = 900  # a test program that takes longer hangs, which is noticed too

# Programs in the order of what they cost, and the data files whose faults each can notice. Goldens are left out, as
# for the shaders.
PROGRAMS = [
    ("tyndall_states_test", "tests/runtime", ["record"]),
    ("tyndall_plan_test", "tests/runtime", ["plan", "needs", "weights"]),
    ("tyndall_record_calls_test", "tests/runtime", ["record"]),
    ("tyndall_record_test", "tests/runtime", ["record", "plan", "needs", "weights"]),
    ("tyndall_planning_test", "tests/planning", ["needs"]),
    ("tyndall_permutation_test", "tests/permutations", ["record", "plan", "needs", "weights"]),
]


def copy_tree(folder: Path) -> None:
    """Copies what git tracks or would; files that have not changed keep their time, so that a build goes on from there."""
    names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT, check=True,
                           capture_output=True, text=True).stdout
    for name in names.split("\0"):
        source, target = ROOT / name, folder / name
        if not name or not source.is_file():
            continue
        if not target.exists() or source.read_bytes() != target.read_bytes():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)
            shutil.copymode(source, target)


def build(folder: Path, jobs: int, targets: list[str]) -> subprocess.CompletedProcess:
    return subprocess.run(["cmake", "--build", folder / PRESET, "-j", str(jobs), "--target", *targets],
                          capture_output=True, text=True)


def prepare(folder: Path, jobs: int) -> None:
    """The tree without a fault, built and tested: a test that fails anyway says nothing."""
    copy_tree(folder)
    configure = ["cmake", "--preset", "default"]
    if shutil.which("ccache"):
        configure.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    configured = subprocess.run(configure, cwd=folder, capture_output=True, text=True)
    if configured.returncode != 0:
        raise BadMutant(f"the copy in {folder} cannot be configured: {configured.stderr.strip()}")
    done = build(folder, jobs, [name for name, _, _ in PROGRAMS])
    if done.returncode != 0:
        raise BadMutant(f"the copy in {folder} does not build without a fault:\n{done.stdout[-3000:]}")
    by = killer(folder, PROGRAMS)
    if by:
        raise BadMutant(f"{by} fails without a fault; mend that first")


def killer(folder: Path, programs: list) -> str | None:
    """The first test that fails, or None."""
    for name, room, _ in programs:
        command = [folder / PRESET / room / name, "--gtest_filter=-*GoldenTest*", "--gtest_fail_fast",
                   "--gtest_brief=1"]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, env=os.environ)
        except subprocess.TimeoutExpired:
            return f"{name} ran for more than {SECONDS} s"
        if done.returncode != 0:
            return failed_test(done.stdout) or f"{name} ended with {done.returncode}"
    return None


def run(mutants: list[Mutant], rooms: dict[str, str], folder: Path,
        jobs: int) -> tuple[dict[str, str], list[Mutant], list[str]]:
    """What killed each mutant, those that nothing killed, and why some are of no use. `rooms`: by id, the data file it stands in."""
    prepare(folder, jobs)
    killed, survivors, useless = {}, [], []
    for mutant in mutants:
        start = time.monotonic()
        source = folder / mutant.file
        text = source.read_text()
        source.write_text(mutant.applied(text))
        try:
            by = None
            for program in [place for place in PROGRAMS if rooms[mutant.id] in place[2]]:
                done = build(folder, jobs, [program[0]])
                if done.returncode != 0:
                    if "static assertion failed" in done.stdout:
                        by = "a static assertion"
                        break
                    raise BadMutant(f"{mutant.id}: does not compile:\n{done.stdout[-2000:]}")
                by = killer(folder, [program])
                if by:
                    break
        except BadMutant as bad:
            useless.append(str(bad))
            continue
        finally:
            source.write_text(text)
        if by is None:
            survivors.append(mutant)
        else:
            killed[mutant.id] = by
        print(f"{mutant.id}: {'killed by ' + by if by else 'SURVIVED'} ({time.monotonic() - start:.1f} s)", flush=True)
    return killed, survivors, useless
