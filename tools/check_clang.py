#!/usr/bin/env python3
"""Compiles everything with clang 14 too, without making code, and lints what is not a test.

Usage: check_clang.py BUILD_FOLDER [FOLDER ...]
Reads BUILD_FOLDER/compile_commands.json. Files of src/ and tools/ go through clang-tidy-14, which
reports the compiler's warnings as well; the others through clang++-14 -fsyntax-only. FOLDER, such
as src/image, leaves only files below it. Any warning is a failure.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINTED = ("src/", "tools/")
CHECKED = LINTED + ("tests/", "samples/")
# Options of g++'s own or of code generation, and options that make files.
DROPPED = re.compile(r"^(-c|-M[MDP]*|-O\w*|-g\w*)$")
DROPPED_WITH_VALUE = {"-o", "-MF", "-MT", "-MQ"}


def options(entry):
    """The options of a compile command: no compiler, no source, no outputs."""
    words = entry.get("arguments") or shlex.split(entry["command"])
    # Before the first option stand the compiler and perhaps a launcher such as ccache.
    start = next(i for i, word in enumerate(words) if word.startswith("-"))
    kept = []
    remaining = iter(words[start:])
    for word in remaining:
        if word in DROPPED_WITH_VALUE:
            next(remaining)
        elif word != entry["file"] and not DROPPED.match(word):
            kept.append(word)
    return kept


def check(name, entry):
    """Runs the check of one file; gives its name, whether it passed, and what was said."""
    if name.startswith(LINTED):
        command = ["clang-tidy-14", "--quiet", entry["file"], "--", *options(entry)]
    else:
        command = ["clang++-14", "-fsyntax-only", *options(entry), entry["file"]]
    result = subprocess.run(
        command, cwd=entry["directory"], capture_output=True, text=True, stdin=subprocess.DEVNULL
    )
    said = result.stdout
    if result.returncode != 0:
        said += result.stderr
    return name, result.returncode == 0, said.strip()


def main(arguments):
    if not arguments:
        print(__doc__)
        return 2
    database = pathlib.Path(arguments[0]) / "compile_commands.json"
    work = {}
    for entry in json.loads(database.read_text(encoding="utf-8")):
        file = pathlib.Path(entry["directory"], entry["file"]).resolve()
        if file.is_relative_to(ROOT):
            name = file.relative_to(ROOT).as_posix()
            if name.startswith(tuple(arguments[1:]) or CHECKED):
                work[name] = entry
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, passed, said in pool.map(lambda item: check(*item), sorted(work.items())):
            if not passed:
                failed += 1
                print(f"{name}: failed\n{said}\n")
    print(f"{len(work)} files, {failed} failed")
    return 1 if failed or not work else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
