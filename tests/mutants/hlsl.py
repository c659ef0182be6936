"""Faults in the shaders: compiled with the manifest loaded at run time, so that no C++ is built."""

import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from mutant import ROOT, BadMutant, Mutant, failed_test

EFFECTS = ["slices", "composite", "shadow_map"]
SECONDS = 240  # a test program that takes longer hangs, which is noticed too

# What is asked first: tests that are likely to notice. Then everything that draws. Goldens are left out: they
# notice every change, and what is asked here is whether laws and oracles do.
LAWS = ("permutation", "*OrientationTest*:*LawTest*:*MaskTest*/clip_noise_shadow_cookie_technique*")
ORACLE = ("permutation", "*TechniqueTest*/clip_noise_shadow_cookie_technique")
LIKELY = {
    "shaders/slices.fx": [LAWS, ORACLE, ("permutation", "*FormatTest*"), ("record", "*")],
    "shaders/shadow.fxh": [LAWS, ORACLE],
    "shaders/composite.fx": [("permutation", "CompositeTest.*"), ("record", "*Composite*")],
    "shaders/shadow_map.fx": [("permutation", "ShadowMapTest.*"), ("record", "*ShadowMap*")],
}
ALL = [("permutation", "-*GoldenTest*"), ("record", "*")]


def compile_effects(mutant: Mutant | None, permgen: Path, folder: Path) -> Path:
    """The manifests of the effects that the fault reaches, or of all; raises BadMutant where one does not compile."""
    shaders = folder / "shaders"
    shutil.copytree(ROOT / "shaders", shaders)
    if mutant:
        patched = folder / mutant.file
        patched.write_text(mutant.applied(patched.read_text()))
    out = folder / "effects"
    for effect in EFFECTS:
        source = shaders / f"{effect}.fx"
        if mutant and source != patched and patched.name not in source.read_text():
            continue
        done = subprocess.run([permgen, "compile", "--freeze", source, "-o", out], capture_output=True, text=True,
                              timeout=SECONDS)
        if done.returncode != 0:
            raise BadMutant(f"{mutant.id if mutant else 'without a fault'}: does not compile: {done.stderr.strip()}")
    return out


def killer(mutant: Mutant | None, batches: list, permgen: Path, tests: dict[str, Path]) -> str | None:
    """The first test of the batches that fails with the fault in, or None."""
    with tempfile.TemporaryDirectory(prefix="tyndall_mutant_") as folder:
        effects = compile_effects(mutant, permgen, Path(folder))
        environment = os.environ | {"TYNDALL_EFFECTS": str(effects), "TYNDALL_REPORT": f"{folder}/report"}
        for program, filter in batches:
            command = [tests[program], f"--gtest_filter={filter}", "--gtest_fail_fast", "--gtest_brief=1"]
            try:
                done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=SECONDS)
            except subprocess.TimeoutExpired:
                return f"{program} ran for more than {SECONDS} s"
            if done.returncode != 0:
                return failed_test(done.stdout) or f"{program} ended with {done.returncode}"
    return None


def run(mutants: list[Mutant], build: Path) -> tuple[dict[str, str], list[Mutant], list[str]]:
    """What killed each mutant, those that nothing killed, and why some are of no use. `build`: where CMake built permgen and the tests."""
    permgen = build / "permgen/permgen"
    tests = {"permutation": build / "tests/permutations/tyndall_permutation_test",
             "record": build / "tests/runtime/tyndall_record_test"}
    for program in (permgen, *tests.values()):
        if not program.is_file():
            raise BadMutant(f"there is no {program}; build it first, or give --build")
    likely = sorted({batch for batches in LIKELY.values() for batch in batches})
    if by := killer(None, likely, permgen, tests):
        raise BadMutant(f"{by} fails without a fault; mend that first")
    killed, survivors, useless = {}, [], []
    for mutant in mutants:
        start = time.monotonic()
        try:
            by = killer(mutant, LIKELY[mutant.file] + ALL, permgen, tests)
        except BadMutant as bad:
            useless.append(str(bad))
            continue
        if by is None:
            survivors.append(mutant)
        else:
            killed[mutant.id] = by
        print(f"{mutant.id}: {'killed by ' + by if by else 'SURVIVED'} ({time.monotonic() - start:.1f} s)", flush=True)
    return killed, survivors, useless
