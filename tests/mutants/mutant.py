"""Single faults as data: a file and a text in it, its replacement, and what that breaks."""

import json
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent


class BadMutant(Exception):
    """A mutant that cannot test the tests: its text is gone, or it does not build."""


@dataclass(frozen=True)
class Mutant:
    id: str
    file: str  # relative to the root
    find: str
    replace: str
    breaks: str  # the visible effect
    index: int | None = None  # which of several occurrences, from 0; absent: there must be exactly one
    equivalent: str | None = None  # the proof that no test can detect it

    def applied(self, text: str) -> str:
        """`text` with the fault."""
        count = text.count(self.find)
        wanted = 1 if self.index is None else self.index + 1
        if count < wanted or (self.index is None and count > 1):
            raise BadMutant(f"{self.id}: {self.file} holds {self.find!r} {count} times, not "
                            f"{'once' if self.index is None else f'{wanted} times or more'}; bring it up to date")
        if self.find == self.replace:
            raise BadMutant(f"{self.id}: replaces {self.find!r} by itself")
        start = -1
        for _ in range(wanted):
            start = text.index(self.find, start + 1)
        return text[:start] + self.replace + text[start + len(self.find):]


def load_file(data: Path) -> list[Mutant]:
    try:
        return [Mutant(**entry) for entry in json.loads(data.read_text())]
    except (json.JSONDecodeError, TypeError) as error:
        raise BadMutant(f"{data}: {error}") from error


def load(language: str) -> list[Mutant]:
    """Every mutant of `language` ("hlsl" or "cpp"), in the order of files and lines."""
    mutants = [mutant for data in sorted((HERE / language).glob("*.json")) for mutant in load_file(data)]
    ids = [mutant.id for mutant in mutants]
    for repeated in sorted({name for name in ids if ids.count(name) > 1}):
        raise BadMutant(f"{repeated}: two mutants have this id")
    return mutants


def stale(mutants: list[Mutant]) -> list[str]:
    """One sentence for each mutant that no longer applies."""
    reasons = []
    for mutant in mutants:
        try:
            mutant.applied((ROOT / mutant.file).read_text())
        except FileNotFoundError:
            reasons.append(f"{mutant.id}: there is no {mutant.file}; tests/mutants/run move finds where it went")
        except BadMutant as bad:
            reasons.append(str(bad))
    return reasons


def check(mutants: list[Mutant]) -> None:
    """Raises BadMutant, which names all mutants whose text is missing from its file."""
    if reasons := stale(mutants):
        raise BadMutant("\n".join([f"{len(reasons)} of {len(mutants)} mutants do not apply:", *reasons]))


def report(language: str, killed: dict[str, str], survivors: list[Mutant], equivalents: list[Mutant]) -> int:
    """Prints the score; the exit status."""
    for mutant in survivors:
        print(f"SURVIVED {mutant.id}: {mutant.breaks} ({mutant.file}: {mutant.find!r} -> {mutant.replace!r})")
    ran = len(killed) + len(survivors)
    print(f"{language}: {len(killed)} of {ran} mutants killed, {len(survivors)} survived, "
          f"{len(equivalents)} proven equivalent and not run")
    return 1 if survivors else 0
