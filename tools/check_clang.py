#!/usr/bin/env python3
"""Compiles everything with clang 14 too, without making code, and lints what is not a test.

Usage: check_clang.py BUILD_FOLDER [FOLDER ...]
       check_clang.py --self-test     checks the check, on files of which some have faults
Reads BUILD_FOLDER/compile_commands.json. Files of src/ and tools/ go through clang-tidy-14, which
reports the compiler's warnings as well; the others through clang++-14 -fsyntax-only. FOLDER, such
as src/image, leaves only files below it. Any warning is a failure.

Most of the time goes into headers, so files that are compiled alike are first looked at together,
as one file that holds them all: headers are then read once. Where that passes, they pass. Files
that are complained of, perhaps because two of them use a name for different things, are looked at
again among themselves, and only what is said of a file alone is a failure.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINTED = ("src/", "tools/")
CHECKED = LINTED + ("tests/", "samples/")
# Options of g++'s own or of code generation, and options that make files.
DROPPED = re.compile(r"^(-c|-M[MDP]*|-O\w*|-g\w*|-f(PIC|PIE|pic|pie))$")
# And headers that g++ has parsed beforehand.
DROPPED_WITH_VALUE = {"-o", "-MF", "-MT", "-MQ", "-include"}
# Keeps all cores busy to the end, and a batch's memory below a gigabyte or two.
LARGEST_BATCH = 24
COMPLAINT = re.compile(r"^(.+?):(\d+):\d+: (?:fatal )?(?:error|warning): ", re.MULTILINE)


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


def run(linted, file, with_options, folder):
    """Checks one file; gives what was said, empty if it is fine."""
    if linted:
        config = f"--config-file={ROOT / '.clang-tidy'}"
        command = ["clang-tidy-14", "--quiet", config, str(file), "--", *with_options]
    else:
        command = ["clang++-14", "-fsyntax-only", "-ferror-limit=0", *with_options, str(file)]
    result = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, stdin=subprocess.DEVNULL
    )
    if result.returncode == 0:
        return ""
    return (result.stdout + result.stderr).strip() or f"exit status {result.returncode}"


def complained_of(said, batch_file, firsts):
    """The files of a batch that complaints name, found by the number of their first line there;
    all of them where a complaint is of something else, such as a header."""
    named = set()
    for path, line in COMPLAINT.findall(said):
        if pathlib.Path(path) != batch_file:
            return set(firsts)
        named.add(max((f for f in firsts if firsts[f] <= int(line)), key=firsts.get))
    return named or set(firsts)


def write_batch(files, batch_file):
    """Writes the files one after the other; gives the number of the first line of each."""
    firsts = {}
    lines = 1
    with open(batch_file, "w", encoding="utf-8") as out:
        for file in files:
            text = pathlib.Path(file).read_text(encoding="utf-8").rstrip("\n") + "\n"
            firsts[file] = lines
            lines += text.count("\n")
            out.write(text)
    return firsts


def pass_together(linted, files, with_options, folder):
    """Looks at files that are compiled alike as one; gives those that passed, few or many."""
    beside = sorted({str(pathlib.Path(file).parent) for file in files})
    of_batch = [*with_options, *(word for name in beside for word in ("-iquote", name))]
    with tempfile.TemporaryDirectory(prefix="ribalta-check-") as temporary:
        batch_file = pathlib.Path(temporary, "batch.cpp")
        # The compiler alone is quick to find what does not go together.
        for linting in (False, True) if linted else (False,):
            said = "not looked at"
            while said and files:
                firsts = write_batch(files, batch_file)
                said = run(linting, batch_file, of_batch, folder)
                if said:
                    apart = complained_of(said, batch_file, firsts)
                    files = [file for file in files if file not in apart]
    return files


def check(linted, files, with_options, folder):
    """Checks files that are compiled alike; gives what was said of those that failed, by file, and
    files still to be checked."""
    if len(files) > 1:
        passed = pass_together(linted, files, with_options, folder)
        if passed:
            return {}, [file for file in files if file not in passed]
    said = {file: run(linted, file, with_options, folder) for file in files}
    return {file: text for file, text in said.items() if text}, []


def batches_of(alike):
    """Files by how they are compiled, cut into batches; those that take longest come first."""
    batches = []
    for (linted, with_options, folder), files in alike.items():
        count = -(-len(files) // LARGEST_BATCH)
        batches += [(linted, sorted(files)[i::count], with_options, folder) for i in range(count)]
    return sorted(batches, key=lambda batch: (not batch[0], -len(batch[1])))


def check_all(alike):
    """What was said of each file that failed."""
    failed = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        while alike:
            batches = batches_of(alike)
            alike = {}
            results = pool.map(lambda batch: check(*batch), batches)
            for (linted, _, with_options, folder), (said, left) in zip(batches, results):
                failed.update(said)
                if left:
                    alike.setdefault((linted, with_options, folder), []).extend(left)
    return failed


def read_database(database, root, below):
    """The files of `root` that are to be checked, by how they are compiled."""
    alike = {}
    seen = set()
    for entry in json.loads(database.read_text(encoding="utf-8")):
        file = pathlib.Path(entry["directory"], entry["file"]).resolve()
        if file in seen or not file.is_relative_to(root):
            continue
        name = file.relative_to(root).as_posix()
        if name.startswith(below):
            seen.add(file)
            key = (name.startswith(LINTED), tuple(options(entry)), entry["directory"])
            alike.setdefault(key, []).append(str(file))
    return alike


# Files of a tree: whether each is to pass, and its text. Two cannot go together, and a macro spoils
# what follows it.
SELF_TEST = {
    "src/a.cpp": (True, "namespace {\nint same() { return 1; }\n}\nint a() { return same(); }\n"),
    "src/b.cpp": (True, "namespace {\nint same() { return 2; }\n}\nint b() { return same(); }\n"),
    "src/c.cpp": (True, "#define n 7\nint c() { return n; }\n"),
    "src/lint.cpp": (False, "int* lint(int n) {\n    if (n > 0);\n    return nullptr;\n}\n"),
    "src/null.cpp": (False, "typedef int Old;\nOld null() { return 0; }\n"),
    "src/unused.cpp": (False, "namespace {\nint unused() { return 1; }\n}\n"),
    "tests/fine.cpp": (True, "typedef int Old;\nOld fine() { return 0; }\n"),
    "tests/missing.cpp": (False, "int missing() { return fine2(); }\n"),
    "tests/shadow.cpp": (False, "int shadow(int i) {\n    { int i = 2; return i; }\n}\n"),
}


def self_test():
    with tempfile.TemporaryDirectory(prefix="ribalta-check-") as temporary:
        root = pathlib.Path(temporary).resolve()
        entries = []
        for name, (_, text) in SELF_TEST.items():
            (root / name).parent.mkdir(exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
            command = f"c++ -Wall -Wshadow -Werror -std=c++20 -o x.o -c {root / name}"
            entries.append({"directory": temporary, "command": command, "file": str(root / name)})
        database = root / "compile_commands.json"
        database.write_text(json.dumps(entries), encoding="utf-8")
        failed = check_all(read_database(database, root, CHECKED))
    found = {str(pathlib.Path(file).relative_to(root)) for file in failed}
    expected = {name for name, (passes, _) in SELF_TEST.items() if not passes}
    for name in sorted(found ^ expected):
        print(f"{name}: {'is fine' if name in found else 'has a fault'}, but the check says not so")
    print(f"{len(SELF_TEST)} files, {len(found ^ expected)} misjudged")
    return 1 if found != expected else 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    if not arguments:
        print(__doc__)
        return 2
    database = pathlib.Path(arguments[0]) / "compile_commands.json"
    alike = read_database(database, ROOT, tuple(arguments[1:]) or CHECKED)
    failed = check_all(alike)
    for file in sorted(failed):
        print(f"{pathlib.Path(file).relative_to(ROOT)}: failed\n{failed[file]}\n")
    print(f"{sum(map(len, alike.values()))} files, {len(failed)} failed")
    return 1 if failed or not alike else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
