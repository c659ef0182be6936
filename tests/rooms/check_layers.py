#!/usr/bin/env python3
"""Includes between the rooms of a folder go one way: each room may include itself and the rooms before it.

Usage: check_layers.py FOLDER ROOM...
"""
import re
import sys
from pathlib import Path

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def included_room(root, rooms, file, quote, name):
    """The room that the include leads to, or None where it leads to none of them."""
    candidates = [root.parent / name] if quote == "<" else [file.parent / name, root / name, root.parent / name]
    for candidate in candidates:
        try:
            parts = candidate.resolve().relative_to(root.resolve()).parts
        except ValueError:
            continue
        if candidate.is_file() and parts[0] in rooms:
            return parts[0]
    return None


def main():
    root, rooms = Path(sys.argv[1]), sys.argv[2:]
    faults, includes = [], 0
    for rank, room in enumerate(rooms):
        files = [file for file in sorted((root / room).rglob("*")) if file.suffix in (".h", ".cpp")]
        if not files:
            faults.append(f"{root / room}: has no sources; name the rooms that {root} has")
        for file in files:
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                found = INCLUDE.match(line)
                to = found and included_room(root, rooms, file, found[1], found[2])
                if not to:
                    continue
                includes += 1
                if rooms.index(to) > rank:
                    faults.append(f"{file}:{number}: {room}/ includes {found[2]}, which is in {to}/; "
                                  f"move what it needs down to {room}/")
    if includes == 0:
        faults.append(f"{root}: no include leads from room to room; the check has seen nothing")
    print("\n".join(faults) or f"{includes} includes go one way")
    return 1 if faults else 0


sys.exit(main())
