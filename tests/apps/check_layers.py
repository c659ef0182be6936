#!/usr/bin/env python3
"""Includes inside apps/tyndall go one way: scene/ <- frame/ <- command/. This fails on any other include.

Usage: check_layers.py APPS_TYNDALL_FOLDER
"""
import re
import sys
from pathlib import Path

LAYERS = ["scene", "frame", "command"]  # each may include itself and those before it
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def included_layer(root, file, quote, name):
    """The layer of the included file, or None if it is outside the program."""
    candidates = [root.parent / name] if quote == "<" else [file.parent / name, root.parent / name]
    for candidate in candidates:
        try:
            parts = candidate.resolve().relative_to(root.resolve()).parts
        except ValueError:
            continue
        if candidate.is_file() and parts[0] in LAYERS:
            return parts[0]
    return None


def main():
    root = Path(sys.argv[1])
    faults, files = [], 0
    for rank, layer in enumerate(LAYERS):
        for file in sorted((root / layer).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            files += 1
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                found = INCLUDE.match(line)
                to = found and included_layer(root, file, found[1], found[2])
                if to and LAYERS.index(to) > rank:
                    faults.append(f"{file}:{number}: {layer}/ includes {found[2]}, which is in {to}/; "
                                  f"move what it needs down to {layer}/")
    if files == 0:
        faults.append(f"{root}: has no sources in {', '.join(LAYERS)}; give the folder apps/tyndall")
    print("\n".join(faults) or f"{files} files include in one direction")
    return 1 if faults else 0


sys.exit(main())
