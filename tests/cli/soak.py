"""A long evening at the window: 1,000 frames with reloads of everything that reloads, meant for a build with
sanitizers. Not run by CTest.

Usage: soak.py PROGRAM [FRAMES]      e.g. cmake --preset sanitize && cmake --build --preset sanitize --target
                                     ribalta && python3 tests/cli/soak.py build/sanitize/bin/ribalta
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

# What graphics drivers and font libraries keep for themselves to the end of the process.
SUPPRESSIONS = "".join(f"leak:{library}\n" for library in
                       ["_dri.so", "libLLVM", "libgallium", "libGLX", "libEGL", "libX11", "libxcb", "libglfw",
                        "libdbus", "libepoxy", "libtbb", "libOpenImageIO"])


def main(program, frames="1000"):
    os.environ["RIBALTA"] = str(pathlib.Path(program).resolve())
    from command import SCENES, make_moving_floor, make_png  # they read the variable
    from desktop import Desktop, wait_until

    folder = pathlib.Path(tempfile.mkdtemp(prefix="ribalta-soak-"))
    scene = make_moving_floor()
    (folder / "floor.gltf").write_text(json.dumps(scene))
    (folder / "gobo.png").write_bytes((SCENES / "gobo_star.png").read_bytes())
    look = {"ribalta_look": 1, "lamps": [{"name": scene["nodes"][1]["name"], "light_map": {"file": "gobo.png"}}]}
    (folder / "floor.look.json").write_text(json.dumps(look))
    (folder / "suppressions").write_text(SUPPRESSIONS)
    # What a library keeps can be told by the library's name while it is loaded alone; drivers are
    # unloaded before the end.
    subprocess.run(["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", folder / "keep_loaded.so"], check=True,
                   input=b"int dlclose(void *library) { (void)library; return 0; }")
    desktop = Desktop()
    with open(folder / "log.txt", "w+", encoding="utf-8") as log:
        process = subprocess.Popen(
            [os.environ["RIBALTA"], "view", "floor.gltf", "--look", "floor.look.json", "--size", "480x270",
             "--stats", "stats.json", "--shaders", str(pathlib.Path(__file__).resolve().parents[2] / "shaders")],
            cwd=folder, stderr=log,
            env={**os.environ, "DISPLAY": desktop.display, "XDG_CACHE_HOME": str(folder / "cache"),
                 "LD_PRELOAD": str(folder / "keep_loaded.so"), "ASAN_OPTIONS": "verify_asan_link_order=0",
                 "LSAN_OPTIONS": f"suppressions={folder / 'suppressions'}:print_suppressions=0"})
        window = desktop.find_window(process)
        said = (folder / "log.txt").read_text
        wait_until("the scene", lambda: "opened" in said())
        desktop.do("mousemove", "--window", window, 100, 200)
        desktop.do("key", "space")  # the animation plays: each frame another picture
        reloads = 0
        end = time.monotonic() + float(frames) * 0.5
        drawn = 0
        while time.monotonic() < end and process.poll() is None and drawn < int(frames):
            (folder / "floor.gltf").write_text(json.dumps(scene))
            (folder / "gobo.png").write_bytes(make_png(64 + reloads, 64))
            (folder / "floor.look.json").write_text(json.dumps({**look, "ambient_lux": reloads}))
            reloads += 1
            wait_until("a reload", lambda: said().count("reloaded floor.gltf") >= reloads)
            desktop.do("key", ["i", "b", "m", "F12", "l", "p"][reloads % 6])
            time.sleep(2)
            # Frames are told at the end alone; so many a second are played at least.
            drawn += 20
        desktop.do("key", "space", "Escape")
        process.wait(timeout=300)
    desktop.close()
    stats = json.loads((folder / "stats.json").read_text())
    print(f"{stats['frames_shown']} frames shown, {stats['pictures_drawn']} pictures drawn, "
          f"{stats['scenes_loaded']} scenes loaded, {stats['gl_errors']} OpenGL errors, exit status "
          f"{process.returncode}")
    lines = said().splitlines()
    errors = [i for i, line in enumerate(lines) if "ERROR" in line or "runtime error" in line]
    print("\n".join(lines[errors[0]:][:100]) if errors else "no complaint of the sanitizers")
    shutil.rmtree(folder)
    return 1 if errors or process.returncode != 0 or stats["gl_errors"] != 0 else 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        print(__doc__)
        sys.exit(2)
    sys.exit(main(*sys.argv[1:]))
