#!/usr/bin/env python3
"""Measures how long each pass of a frame takes, and prints a table or JSON. Judges nothing.

A cold frame is the first one of a process: it compiles the shaders and draws every shadow map. Kept
frames are the ones after it, of the same scene and view; their median is the process's own, which
counts the cold frame as one among them. Times are in milliseconds, medians over the processes. cpu is
until the next pass begins, gpu what OpenGL's timer queries say: read gpu to compare passes, as the
cpu waits for a pass wherever it first needs what was drawn.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default=ROOT / "build/release/bin/ribalta",
                        help="default: %(default)s")
    parser.add_argument("--scene", default=ROOT / "samples/scenes/stage.glb",
                        help="default: %(default)s")
    parser.add_argument("--size", default="640x360", help="pixels (default: %(default)s)")
    parser.add_argument("--cold", type=int, default=5, metavar="N",
                        help="processes, each with one cold frame (default: %(default)s)")
    parser.add_argument("--kept", type=int, default=20, metavar="N",
                        help="kept frames in each process (default: %(default)s)")
    parser.add_argument("--json", metavar="FILE", help="write the figures there as well")
    parser.add_argument("options", nargs="*", metavar="-- OPTION",
                        help="further options of ribalta render, e.g. -- --camera side_stage")
    arguments = parser.parse_args()
    if arguments.cold < 1 or arguments.kept < 1:
        parser.error("--cold and --kept want 1 or more")
    return arguments


def draw(arguments, frames):
    """The statistics of one process that draws so many frames."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "stats.json"
        command = [arguments.program, "render", arguments.scene, "--size", arguments.size,
                   "--repeat", str(frames), "--stats", file, *arguments.options]
        finished = subprocess.run([str(word) for word in command], check=False)
        if finished.returncode != 0:
            sys.exit(finished.returncode)
        return json.loads(file.read_text())


def medians(runs):
    """frame_ms and passes of several statistics, in the order in which the passes are drawn."""
    times = {}
    for run in runs:
        for each in run["passes"]:
            times.setdefault(each["name"], []).append((each["cpu_ms"], each["gpu_ms"]))
    return {
        "frame_ms": statistics.median(run["frame_ms"] for run in runs),
        "passes": [{"name": name, "cpu_ms": statistics.median(cpu for cpu, _ in values),
                    "gpu_ms": statistics.median(gpu for _, gpu in values)}
                   for name, values in times.items()],
    }


def measure(arguments):
    runs = [draw(arguments, 1 + arguments.kept) for _ in range(arguments.cold)]
    first = [{"frame_ms": run["first_frame_ms"], "passes": run["first_frame_passes"]}
             for run in runs]
    kept = medians(runs)
    if "--redraw" not in arguments.options:
        # That pass is the cold frame's, whose shadow maps the others keep.
        kept["passes"] = [each for each in kept["passes"] if each["name"] != "shadow_map"]
    return {
        "renderer": runs[0]["renderer"],
        "scene": str(arguments.scene),
        "size": arguments.size,
        "options": arguments.options,
        "cores": os.cpu_count(),
        "plan": runs[0]["plan"],
        "cold_frames": arguments.cold,
        "kept_frames": arguments.cold * arguments.kept,
        "cold": medians(first),
        "kept": kept,
    }


def table(figures):
    cold = {each["name"]: each for each in figures["cold"]["passes"]}
    kept = {each["name"]: each for each in figures["kept"]["passes"]}
    lines = [
        f"{pathlib.Path(figures['scene']).name} at {figures['size']} "
        f"{' '.join(figures['options'])}".rstrip(),
        f"{figures['renderer']}, {figures['cores']} cores",
        f"plan: {figures['plan']}",
        "",
        f"{'median ms':<14}{'cold cpu':>10}{'cold gpu':>10}{'kept cpu':>10}{'kept gpu':>10}",
    ]
    for name in cold:
        line = f"  {name:<12}{cold[name]['cpu_ms']:10.2f}{cold[name]['gpu_ms']:10.2f}"
        if name in kept:
            line += f"{kept[name]['cpu_ms']:10.2f}{kept[name]['gpu_ms']:10.2f}"
        lines.append(line)
    lines.append(f"  {'frame':<12}{figures['cold']['frame_ms']:10.2f}{'':10}"
                 f"{figures['kept']['frame_ms']:10.2f}")
    lines.append(f"over {figures['cold_frames']} cold and {figures['kept_frames']} kept frames")
    return "\n".join(lines)


def main():
    arguments = parse_arguments()
    figures = measure(arguments)
    print(table(figures))
    if arguments.json:
        pathlib.Path(arguments.json).write_text(json.dumps(figures, indent=2) + "\n")


if __name__ == "__main__":
    main()
