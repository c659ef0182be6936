"""Faults in plan, record, weights and compute passes: each built into a copy of the tree."""

import shutil
import subprocess
from pathlib import Path

from loop import first_failure
from mutant import ROOT, BadMutant, Mutant

PRESET = "build/default"
SECONDS = 900  # a test program that takes longer hangs, which counts as detection

# Programs in the order of their cost, and the data files whose faults each can detect. Goldens are left out, as for the
# shaders.
PROGRAMS = [
    ("tyndall_states_test", ["record"]),
    ("tyndall_compute_test", ["compute"]),
    ("tyndall_plan_test", ["plan", "needs", "weights"]),
    ("tyndall_record_calls_test", ["record"]),
    ("tyndall_record_test", ["record", "plan", "needs", "weights"]),
    ("tyndall_planning_test", ["needs"]),
    ("tyndall_permutation_test", ["record", "plan", "needs", "weights"]),
]


def copy_tree(folder: Path) -> None:
    """Copies files that git tracks or would track; unchanged files keep their time, so that builds are incremental."""
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


class Runner:
    def __init__(self, rooms: dict[str, str], folder: Path, jobs: int):
        """`rooms`: by mutant's id, the data file it stands in. Builds and tests the tree without a fault: a test that fails anyway detects nothing."""
        self.rooms, self.folder, self.jobs = rooms, folder, jobs
        copy_tree(folder)
        configure = ["cmake", "--preset", "default"]
        if shutil.which("ccache"):
            configure.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
        configured = subprocess.run(configure, cwd=folder, capture_output=True, text=True)
        if configured.returncode != 0:
            raise BadMutant(f"the copy in {folder} cannot be configured: {configured.stderr.strip()}")
        done = build(folder, jobs, [name for name, _ in PROGRAMS])
        if done.returncode != 0:
            raise BadMutant(f"the copy in {folder} does not build without a fault:\n{done.stdout[-3000:]}")
        for name, _ in PROGRAMS:
            if by := self.failure(name):
                raise BadMutant(f"{by} fails without a fault; fix that first")

    def killer(self, mutant: Mutant) -> str | None:
        source = self.folder / mutant.file
        text = source.read_text()
        source.write_text(mutant.applied(text))
        try:
            for name in [name for name, notices in PROGRAMS if self.rooms[mutant.id] in notices]:
                done = build(self.folder, self.jobs, [name])
                if done.returncode != 0:
                    if "static assertion failed" in done.stdout:
                        return "a static assertion"
                    raise BadMutant(f"{mutant.id}: does not compile:\n{done.stdout[-2000:]}")
                if by := self.failure(name):
                    return by
            return None
        finally:
            source.write_text(text)

    def failure(self, name: str) -> str | None:
        """The first failing test of the program, or None. The program may be in any folder below tests/."""
        programs = list((self.folder / PRESET / "tests").glob(f"*/{name}"))
        if len(programs) != 1:
            raise BadMutant(f"{name} is built {len(programs)} times below {self.folder / PRESET}/tests, not once")
        return first_failure(programs[0], "-*GoldenTest*", SECONDS)
