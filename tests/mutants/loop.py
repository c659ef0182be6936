"""Shared by both kinds of mutants: running a test program, and the loop over mutants."""

import os
import re
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

from mutant import BadMutant, Mutant


def first_failure(program: Path, filter: str, seconds: int, environment: dict[str, str] | None = None) -> str | None:
    """The first failing test of a googletest program, or None. A program that hangs fails, too."""
    command = [program, f"--gtest_filter={filter}", "--gtest_fail_fast", "--gtest_brief=1"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=seconds,
                              env=os.environ | (environment or {}))
    except subprocess.TimeoutExpired:
        return f"{program.name} ran for more than {seconds} s"
    if done.returncode == 0:
        return None
    found = re.search(r"^\[  FAILED  \] ([\w./]+)", done.stdout, re.MULTILINE)
    return found[1] if found else f"{program.name} ended with {done.returncode}"


def run(mutants: list[Mutant],
        killer: Callable[[Mutant], str | None]) -> tuple[dict[str, str], list[Mutant], list[str]]:
    """The test that killed each mutant, the survivors, and the reasons why some mutants are invalid.

    `killer` names the first test that fails with the fault, or None; it raises BadMutant if the fault does not build."""
    killed, survivors, useless = {}, [], []
    for mutant in mutants:
        start = time.monotonic()
        try:
            by = killer(mutant)
        except BadMutant as bad:
            useless.append(str(bad))
            continue
        if by is None:
            survivors.append(mutant)
        else:
            killed[mutant.id] = by
        print(f"{mutant.id}: {'killed by ' + by if by else 'SURVIVED'} ({time.monotonic() - start:.1f} s)", flush=True)
    return killed, survivors, useless
