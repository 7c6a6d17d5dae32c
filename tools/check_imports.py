#!/usr/bin/env python3
"""Fails where a file includes what its module must not know.

Usage: check_imports.py [ROOT]      checks the source tree, ROOT or the one this file lies in
       check_imports.py --self-test checks the check, on a tree with one fault of each kind

It reads #include lines only; what CMake links is not its business.
"""

import pathlib
import re
import sys
import tempfile

# Which modules of src/ a module may include, itself aside. Not transitive: all are named.
MAY_INCLUDE = {
    "base": set(),
    "image": {"base"},
    "scene": {"base", "image", "optics"},
    "gltf": {"base", "image", "scene"},
    "optics": {"base"},
    "sky": {"base", "scene", "optics"},
    "reference": {"base", "image", "scene", "optics", "sky"},
    "gl": {"base", "image"},
    "render": {"base", "image", "scene", "optics", "sky", "gl"},
    "measure": {"base", "image", "scene", "optics", "sky", "reference", "gl", "render"},
    "look": {"base", "image", "scene", "sky", "render"},
    "viewer": {"base", "image", "scene", "optics", "sky", "gltf", "gl", "render", "measure", "look"},
}
# Shader mathematics and structs, compiled as C++ too.
SHADER_FOLDERS = {"lib", "shared"}
MAY_INCLUDE_SHADERS = {"optics", "sky", "reference", "render"}
# Libraries that one folder keeps to itself; tests may write what it reads, and benchmarks do without it.
LIBRARIES = {
    "OpenImageIO/": "src/image/codec/",
    "webp/": "src/image/codec/",
    "tiny_gltf.h": ("src/gltf/", "tests/bench/load/"),
    "draco/": ("src/gltf/", "tests/unit/gltf/", "tests/bench/load/"),
    "meshoptimizer.h": ("src/gltf/", "tests/unit/gltf/", "tests/bench/load/"),
    "embree3/": "src/reference/cast_rays.",
    "GLFW/": "src/viewer/",
    "imgui": "src/viewer/",
    "EGL/": "src/gl/",
    "epoxy/egl.h": "src/gl/",
}
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
SOURCES = {".h", ".cpp"}


def passes_of_tree(root):
    """The passes: what has a shader of its own name. Other files beside them are shared parts."""
    shaders = (root / "shaders/passes").glob("*")
    return {file.stem for file in shaders if file.suffix in {".vert", ".frag", ".comp"}}


def faults_of_include(path, module, name, passes):
    """What is wrong with `path` (relative to the root) including `name`."""
    text = path.as_posix()
    for library, owners in LIBRARIES.items():
        if name.startswith(library) and not text.startswith(owners):
            folder = owners if isinstance(owners, str) else owners[0]
            yield f"{library.rstrip('/')} belongs to {folder} alone"
    if module is None:  # tests, samples and the command may use every module
        return
    target = name.split("/")[0]
    if target in SHADER_FOLDERS:
        if module not in MAY_INCLUDE_SHADERS:
            yield f"{module} must not include shaders"
    elif target in MAY_INCLUDE:
        if target != module and target not in MAY_INCLUDE[module]:
            allowed = ", ".join(sorted(MAY_INCLUDE[module])) or "nothing"
            yield f"{module} must not know {target} (it may know {allowed})"
    elif target in {"tests", "tools", "samples", "support"}:
        yield f"a library must not know {target}"
    included = pathlib.PurePosixPath(name)
    if text.startswith("src/render/passes/") and name.startswith("render/passes/"):
        if included.stem in passes and included.stem != path.stem:
            yield "a pass must not know another pass"


def faults_of_tree(root):
    """(place, fault) of every bad include under `root`, and the number of files read."""
    faults = []
    count = 0
    passes = passes_of_tree(root)
    for folder in ("src", "tests", "tools", "samples", "shaders"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in SOURCES:
                continue
            count += 1
            path = file.relative_to(root)
            module = path.parts[1] if path.parts[0] == "src" else None
            if module is not None and module not in MAY_INCLUDE:
                faults.append((f"{path}", f"module {module} is not in MAY_INCLUDE"))
                continue
            lines = file.read_text(encoding="utf-8").splitlines()
            for number, line in enumerate(lines, start=1):
                match = INCLUDE.match(line)
                if match:
                    for fault in faults_of_include(path, module, match.group(2), passes):
                        faults.append((f"{path}:{number}", f"{match.group(2)}: {fault}"))
    return faults, count


GOOD = {
    "src/render/passes/forward.cpp": '#include "render/passes/forward.h"\n#include <vector>\n',
    "src/render/passes/forward.h": '#include "render/passes/part.h"\n#include "gl/texture.h"\n',
    "src/render/passes/part.h": '#include "shared/beams.h"\n',
    "shaders/passes/forward.frag": "",
    "src/image/codec/decode.cpp": "#include <OpenImageIO/imageio.h>\n",
    "src/gltf/load.cpp": '#include <tiny_gltf.h>\n#include "scene/scene.h"\n',
    "tests/unit/a_test.cpp": '#include "gltf/load_gltf.h"\n#include "gl/texture.h"\n',
}
BAD = [
    ("src/gltf/a.cpp", '#include "gl/texture.h"'),
    ("src/gl/a.h", '#include "scene/scene.h"'),
    ("src/reference/a.cpp", '#  include "gl/texture.h"'),
    ("src/base/a.h", '#include "image/image.h"'),
    ("src/image/a.cpp", "#include <OpenImageIO/imageio.h>"),
    ("src/scene/a.h", '#include <gltf/load_gltf.h>'),
    ("src/scene/b.h", '#include "lib/brdf.glsl"'),
    ("src/render/a.cpp", '#include "tiny_gltf.h"'),
    ("src/render/b.cpp", '#include "measure/sweep.h"'),
    ("src/render/passes/tonemap.cpp", '#include "render/passes/forward.h"'),
    ("src/optics/a.h", '#include "support/make_png.h"'),
    ("src/sky/a.cpp", '#include "reference/integrate_sky.h"'),
    ("src/reference/b.cpp", "#include <embree3/rtcore.h>"),
    ("src/helpers/a.h", ""),
    ("tests/unit/b_test.cpp", "#include <draco/compression/decode.h>"),
]


def self_test():
    """Every bad file is reported, by its name, and no good one is."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in list(GOOD.items()) + [(n, t + "\n") for n, t in BAD]:
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        faults, count = faults_of_tree(root)
    found = {place.split(":")[0] for place, _ in faults}
    expected = {name for name, _ in BAD}
    for name in sorted(expected - found):
        print(f"self-test: the fault in {name} was not found")
    for name in sorted(found - expected):
        print(f"self-test: {name} is good and was reported")
    print(f"self-test: {len(found & expected)} of {len(expected)} faults found in {count} files")
    return found == expected


def main(arguments):
    if arguments == ["--self-test"]:
        return 0 if self_test() else 1
    root = pathlib.Path(arguments[0] if arguments else __file__).resolve()
    root = root if arguments else root.parent.parent
    faults, count = faults_of_tree(root)
    for place, fault in faults:
        print(f"{place}: {fault}")
    print(f"{count} files, {len(faults)} bad includes")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
