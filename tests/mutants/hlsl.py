"""Faults in the shaders: compiled with the manifest loaded at run time, so that no C++ is built."""

import json
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from loop import first_failure
from mutant import HERE, ROOT, BadMutant, Mutant

EFFECTS = ["slices", "raycast", "composite", "shadow_map", "shadow_hierarchy"]
SECONDS = 240  # a test program that takes longer hangs, which counts as detection

# By mutant, the program and the test that killed it last: tried first, because most faults die there at once. Only a
# saving of time: without its entry, or once the test is gone, a mutant meets all tests. `run hlsl --remember` writes it.
KILLERS = HERE / "hlsl_killers.json"

# Then the tests that are likely to detect the fault, then all that draw. Goldens are left out: they detect every
# change, and the question here is whether laws and oracles do.
LAWS = ("permutation", "*OrientationTest*:*LawTest*:*MaskTest*/clip_noise_shadow_cookie_technique*")
# Without the test that computed and drawn rays agree: only the drawn ones get the fault.
RAYS = ("raycast", "FloatForms.*:RaycastLaw.*:*RaycastReferenceTest*:RaycastTorch.*:*RaycastHardView*:RaycastShaders.Frozen*:RaycastShaders.Routed*")
ORACLE = ("permutation", "*TechniqueTest*/clip_noise_shadow_cookie_technique")
LIKELY = {
    "shaders/slices.fx": [LAWS, ORACLE, ("permutation", "*FormatTest*"), ("record", "*")],
    "shaders/shadow.fxh": [LAWS, ORACLE],
    "shaders/composite.fx": [("permutation", "CompositeTest.*"), ("record", "*Composite*")],
    "shaders/raycast.fxh": [RAYS],
    "shaders/integrals.fxh": [RAYS],
    "shaders/precise.fxh": [RAYS],
    "shaders/scattering.fxh": [RAYS],
    "shaders/shadow_hierarchy.fx": [RAYS],
    "shaders/shadow_map.fx": [("permutation", "ShadowMapTest.*"), ("record", "*ShadowMap*")],
}
ALL = [("permutation", "-*GoldenTest*"), ("record", "*"), ("raycast", "-*Room*:*Computed*")]


def with_includes(source: Path) -> list[Path]:
    """The file and all that it includes, directly or not."""
    found = [source]
    for file in found:
        found += [file.parent / name for name in re.findall(r'^#include "(.+)"', file.read_text(), re.MULTILINE)]
    return found


def compile_effects(mutant: Mutant | None, permgen: Path, folder: Path) -> Path:
    """The manifests of the effects that the fault affects, or of all; raises BadMutant if one does not compile."""
    shaders = folder / "shaders"
    shutil.copytree(ROOT / "shaders", shaders)
    if mutant:
        patched = folder / mutant.file
        patched.write_text(mutant.applied(patched.read_text()))
    out = folder / "effects"
    for effect in EFFECTS:
        source = shaders / f"{effect}.fx"
        if mutant and patched not in with_includes(source):
            continue
        done = subprocess.run([permgen, "compile", "--freeze", source, "-o", out], capture_output=True, text=True,
                              timeout=SECONDS)
        if done.returncode != 0:
            raise BadMutant(f"{mutant.id if mutant else 'without a fault'}: does not compile: {done.stderr.strip()}")
    return out


class Runner:
    def __init__(self, build: Path):
        """`build`: where CMake built permgen and the tests."""
        self.permgen = build / "permgen/permgen"
        self.tests = {"permutation": build / "tests/permutations/tyndall_permutation_test",
                      "raycast": build / "tests/raycast/tyndall_raycast_test",
                      "record": build / "tests/runtime/tyndall_record_test"}
        for program in (self.permgen, *self.tests.values()):
            if not program.is_file():
                raise BadMutant(f"there is no {program}; build it first, or give --build")
        self.killers = {id: tuple(test) for id, test in json.loads(KILLERS.read_text()).items()}
        likely = sorted({batch for batches in LIKELY.values() for batch in batches})
        if by := self.failure(None, likely):
            raise BadMutant(f"{by} fails without a fault; fix that first")

    def killer(self, mutant: Mutant) -> str | None:
        known = [self.killers[mutant.id]] if mutant.id in self.killers else []
        return self.failure(mutant, known + LIKELY[mutant.file] + ALL)

    def remember(self) -> None:
        """Writes the tests that killed the mutants of this run beside those known before."""
        lines = [f"  {json.dumps(id)}: {json.dumps(test)}" for id, test in sorted(self.killers.items())]
        KILLERS.write_text("{\n" + ",\n".join(lines) + "\n}\n")

    def failure(self, mutant: Mutant | None, batches: list) -> str | None:
        """The first failing test of the batches, with the fault if one is given."""
        with tempfile.TemporaryDirectory(prefix="tyndall_mutant_") as folder:
            effects = compile_effects(mutant, self.permgen, Path(folder))
            environment = {"TYNDALL_EFFECTS": str(effects), "TYNDALL_REPORT": f"{folder}/report"}
            for program, filter in batches:
                if by := first_failure(self.tests[program], filter, SECONDS, environment):
                    if mutant:
                        self.killers[mutant.id] = (program, by)
                    return by
        return None
