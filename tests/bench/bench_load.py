#!/usr/bin/env python3
"""Times loading of large files against other loaders, and prints a table or JSON. Judges nothing.

The files are made here: 2 million triangles, 64 PNGs and 64 JPEGs of 1024 x 1024, 100,000 nodes, a
million triangles in Draco and as many in meshopt. Each loader runs on each as a process of its own, in
turn, so that whatever else the machine does hits all alike; figures are medians. `cpu` is user and
system time, `wall` what a person waits, `peak` the most memory it had (all in one process, its
libraries among it); `2nd start` is ribalta with what its first start kept. The peak is also told as
what it is over that of a file without anything, against what `ribalta render` uploads of the file
and the file itself. Peers: stock tinygltf with stb and Draco, from Debian's packages, and fastgltf
with stb, Draco and meshopt, where --fastgltf names its checkout (simdjson is the system's).

Wants g++, libtinygltf-dev, libstb-dev, libpng-dev, libjpeg-dev, libdraco-dev, libmeshoptimizer-dev,
and libsimdjson-dev for fastgltf.
"""

import argparse
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = pathlib.Path(__file__).resolve().parent / "load"
FILES = ("geometry", "png", "jpeg", "nodes", "draco", "meshopt")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/bin/ribalta",
                        help="default: %(default)s")
    parser.add_argument("--other", action="append", default=[], metavar="PROGRAM",
                        help="another build of ribalta to time beside it")
    parser.add_argument("--fastgltf", type=pathlib.Path, metavar="FOLDER",
                        help="a checkout of fastgltf; without it, it is left out")
    parser.add_argument("--runs", type=int, default=11, metavar="N",
                        help="processes of each loader on each file (default: %(default)s)")
    parser.add_argument("--scale", type=float, default=1.0,
                        help="of the files; 0.01 makes small ones (default: %(default)s)")
    parser.add_argument("--only", action="append", choices=FILES, help="this file alone")
    parser.add_argument("--scene", action="append", default=[], type=pathlib.Path, metavar="FILE",
                        help="a .glb of yours, too; what a peer cannot read is left out")
    parser.add_argument("--options", default="", metavar="WORDS",
                        help="further options of ribalta inspect")
    parser.add_argument("--json", metavar="FILE", help="write the figures there as well")
    return parser.parse_args()


def compile_program(name, folder, words, libraries):
    program = folder / name
    source = SOURCES / f"{name}.cpp"
    command = ["g++", "-std=c++17", "-O2", "-w", *words, str(source), "-o", str(program),
               *libraries]
    if subprocess.run(command, check=False).returncode != 0:
        sys.exit(f"bench_load: {source} does not compile; see --help for the packages it wants")
    return program


def make_peers(arguments, folder):
    """The loaders, by name: the words that start each."""
    program = [str(arguments.program), "inspect", *arguments.options.split()]
    loaders = {"ribalta": [*program, "--no-cache"], "2nd start": program}
    for number, other in enumerate(arguments.other):
        loaders[f"other {number + 1}"] = [other, "inspect", *arguments.options.split()]
    tinygltf = compile_program("tinygltf_peer", folder, ["-I/usr/include/stb"], ["-ldraco"])
    loaders["tinygltf"] = [str(tinygltf)]
    if arguments.fastgltf is None:
        print("fastgltf is left out: give --fastgltf FOLDER", file=sys.stderr)
        return loaders
    parts = [str(arguments.fastgltf / "src" / f"{name}.cpp")
             for name in ("fastgltf", "base64", "io")]
    fastgltf = compile_program(
        "fastgltf_peer", folder, [f"-I{arguments.fastgltf / 'include'}", *parts],
        ["-ldraco", "-lmeshoptimizer", "-lsimdjson"])
    loaders["fastgltf"] = [str(fastgltf)]
    return loaders


def run_once(words, caches):
    """Wall and processor seconds, and the peak in bytes; none where it fails."""
    start = time.monotonic()
    child = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                             env={**os.environ, "XDG_CACHE_HOME": str(caches)})
    output = child.stdout.read()
    _, status, usage = os.wait4(child.pid, 0)
    wall = time.monotonic() - start
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        return None
    return {"wall": wall, "cpu": usage.ru_utime + usage.ru_stime, "peak": usage.ru_maxrss * 1024,
            "output": output.decode(errors="replace")}


def uploaded_bytes(program, path, caches):
    """Of geometry, materials and pictures; 0 where it cannot be drawn here."""
    stats = caches.parent / "stats.json"
    if run_once([program, "render", str(path), "--size", "16x16", "--stats", str(stats)],
                caches) is None:
        return 0
    return json.loads(stats.read_text())["uploaded_bytes"]


def measure_file(loaders, path, runs, caches):
    """The medians of every loader, by its name."""
    times = {name: [] for name in loaders}
    run_once([*loaders["2nd start"], str(path)], caches)
    for _ in range(runs):
        for name, words in list(loaders.items()):
            if times[name] is None:
                continue
            once = run_once([*words, str(path)], caches)
            if once is None:
                times[name] = None
            else:
                times[name].append(once)
    figures = {}
    for name, each in times.items():
        figures[name] = each and {key: statistics.median(once[key] for once in each)
                                  for key in ("wall", "cpu", "peak")}
    figures["uploaded"] = uploaded_bytes(loaders["ribalta"][0], path, caches)
    figures["file"] = path.stat().st_size
    return figures


def print_table(name, figures, loaders, empty_peak):
    megabytes = 1e-6 * figures["file"]
    print(f"\n{name}: {megabytes:.1f} MB, {1e-6 * figures['uploaded']:.1f} MB uploaded")
    print(f"  {'median':<12}{'wall ms':>10}{'cpu ms':>10}{'peak MB':>10}   wall, cpu of others")
    ours = figures["ribalta"]
    for loader in loaders:
        one = figures[loader]
        if one is None:
            print(f"  {loader:<12}{'cannot read it':>24}")
            continue
        line = (f"  {loader:<12}{1e3 * one['wall']:10.1f}{1e3 * one['cpu']:10.1f}"
                f"{1e-6 * one['peak']:10.1f}")
        if loader != "ribalta" and ours:
            line += f"   {one['wall'] / ours['wall']:.2f} x, {one['cpu'] / ours['cpu']:.2f} x"
        elif figures["uploaded"] > 0:
            line += (f"   (peak - {1e-6 * empty_peak:.1f}) / (uploaded + file): "
                     f"{(one['peak'] - empty_peak) / (figures['uploaded'] + figures['file']):.2f}")
        print(line)


def main():
    arguments = parse_arguments()
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    result = {"runs": arguments.runs, "scale": arguments.scale, "cores": os.cpu_count()}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        loaders = make_peers(arguments, folder)
        maker = compile_program("make_load_files", folder, [],
                                ["-lpng", "-ljpeg", "-ldraco", "-lmeshoptimizer"])
        subprocess.run([str(maker), str(folder), str(arguments.scale)], check=True)
        paths = [folder / f"{file}.glb" for file in FILES
                 if not arguments.only or file in arguments.only] + arguments.scene
        empty = folder / "empty.gltf"
        empty.write_text('{"asset": {"version": "2.0"}}')
        result["empty"] = run_once([*loaders["ribalta"], str(empty)], folder / "caches")
        for path in paths:
            figures = measure_file(loaders, path, arguments.runs, folder / "caches")
            result[path.stem] = figures
            print_table(path.stem, figures, loaders, result["empty"]["peak"])
            sys.stdout.flush()
    print(f"\nmedians of {arguments.runs} processes each, taken in turn, {os.cpu_count()} cores")
    if arguments.json:
        pathlib.Path(arguments.json).write_text(json.dumps(result, indent=2) + "\n")


if __name__ == "__main__":
    main()
