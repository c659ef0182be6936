"""Updates the mutants' files after a file was renamed or a passage was moved to another file."""

import dataclasses
import json
import subprocess
from pathlib import Path

from mutant import HERE, ROOT, BadMutant, Mutant, load_file, stale

SOURCES = {"cpp": (".cpp", ".h"), "hlsl": (".fx", ".fxh")}


def git(*arguments: str) -> list[str]:
    return subprocess.run(["git", *arguments], cwd=ROOT, check=True, capture_output=True, text=True).stdout.splitlines()


def renames() -> dict[str, str]:
    """Old and new names from git's history; the latest rename of a name wins."""
    found: dict[str, str] = {}
    for line in git("log", "--format=", "--name-status", "--diff-filter=R", "--find-renames=40%", "HEAD"):
        _, old, new = line.split("\t")
        found.setdefault(old, new)
    for line in git("diff", "--name-status", "--diff-filter=R", "--find-renames=40%", "HEAD"):
        _, old, new = line.split("\t")
        found[old] = new
    return found


def followed(name: str, renamed: dict[str, str]) -> str:
    """The file's present name, after any number of renames."""
    seen = {name}
    while not (ROOT / name).is_file() and name in renamed and renamed[name] not in seen:
        name = renamed[name]
        seen.add(name)
    return name


def moved(mutant: Mutant, renamed: dict[str, str], sources: list[str]) -> Mutant | None:
    """The mutant with its text's present file, or None if that is not certain."""
    if not stale([mutant]):
        return mutant
    there = dataclasses.replace(mutant, file=followed(mutant.file, renamed))
    if not stale([there]):
        return there
    # Not in the renamed file: exactly one other file must hold the passage, as often as the pin says.
    holders = [name for name in sources if mutant.find in (ROOT / name).read_text()]
    if len(holders) == 1:
        there = dataclasses.replace(mutant, file=holders[0])
        if not stale([there]):
            return there
    return None


def move(old: str | None, new: str | None) -> int:
    """Rewrites the data files. With `old` and `new`, pins of that file only; the number of pins rewritten.

    Raises BadMutant for pins without a match, after it has written the others."""
    renamed = {old: new} if old and new else renames()
    tracked = git("ls-files", "--cached", "--others", "--exclude-standard")
    count, lost = 0, []
    for language, endings in SOURCES.items():
        sources = [name for name in tracked if name.endswith(endings) and not name.startswith("tests/")
                   and (ROOT / name).is_file()]
        for data in sorted((HERE / language).glob("*.json")):
            entries = json.loads(data.read_text())
            for entry, mutant in zip(entries, load_file(data), strict=True):
                if old and mutant.file != old:
                    continue
                there = moved(mutant, renamed, sources)
                if there is None:
                    lost.append(mutant)
                elif there.file != mutant.file:
                    print(f"{mutant.id}: {mutant.file} -> {there.file}")
                    entry["file"] = there.file
                    count += 1
            write(data, entries)
    if lost:
        raise BadMutant("\n".join([f"{count} pins moved; {len(lost)} fit no place, because their text was rewritten; "
                                   "write the new text into their data file:",
                                   *(f"{one.id}: {one.file}: {one.find!r}" for one in lost)]))
    return count


def write(data: Path, entries: list[dict]) -> None:
    text = json.dumps(entries, indent=2, ensure_ascii=False) + "\n"
    if text != data.read_text():
        data.write_text(text)
