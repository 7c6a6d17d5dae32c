#!/usr/bin/python3
"""Draws many models small, side by side on one picture, each beside its reference picture where it
has one: what is drawn wrong is seen at a glance. Needs Debian's
python3-openimageio and fonts-dejavu-core.

    tools/contact_sheet.py build/release/bin/ribalta FOLDER... -o sheet.png

A model's reference picture has its name, ends in .png, .jpg or .webp, and lies beside it or below one
of the folders of --references. A model that is refused is a red square; one whose drawing fails, takes
longer than --seconds, makes OpenGL complain or holds pixels that are no numbers is a yellow one, and
makes the exit code 1.
"""

import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile

import OpenImageIO as oiio

BAD_INPUT = 3
PICTURES = (".png", ".jpg", ".webp")
REFUSED, FAILED = (0.5, 0, 0), (0.8, 0.8, 0)


def find_models(paths):
    models = []
    for path in map(pathlib.Path, paths):
        if path.is_dir():
            models += sorted(each for each in path.rglob("*")
                             if each.suffix.lower() in (".gltf", ".glb") and each.is_file())
        else:
            models.append(path)
    return models


def find_references(folders):
    return {each.stem: each for folder in folders for each in pathlib.Path(folder).rglob("*")
            if each.suffix.lower() in PICTURES}


class Drawer:
    """Draws one model after the other into a folder, with options for `ribalta render`."""

    def __init__(self, program, render, size, seconds, folder):
        self.command = [program, "render", "--size", f"{size}x{size}", *render]
        self.size, self.seconds, self.folder = size, seconds, folder

    def draw(self, number, model):
        """Returns the picture or the colour that stands for it, and what went wrong."""
        target = self.folder / f"{number}.png"
        exact = self.folder / f"{number}.exr"
        try:
            result = subprocess.run([*self.command, str(model), "-o", str(target), "-o", str(exact)],
                                    timeout=self.seconds, text=True, errors="replace",
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        except subprocess.TimeoutExpired:
            return FAILED, f"takes over {self.seconds} s"
        if result.returncode == BAD_INPUT:
            return REFUSED, ""
        if result.returncode != 0:
            last = (result.stderr.splitlines() or [""])[-1]
            return FAILED, f"exit code {result.returncode}: {last}"
        complaints = [line for line in result.stderr.splitlines() if "OpenGL error" in line]
        if complaints:
            return FAILED, complaints[0]
        stats = oiio.ImageBufAlgo.computePixelStats(oiio.ImageBuf(str(exact)))
        exact.unlink()
        if sum(stats.nancount) + sum(stats.infcount) > 0:
            return FAILED, "has pixels that are no numbers"
        return target, ""


class Sheet:
    """Squares with names below them, from left to right and then down."""

    LINES, LINE = 2, 11

    def __init__(self, size, columns, count):
        self.size, self.columns, self.next = size, columns, 0
        self.height = size + self.LINES * self.LINE + 6
        rows = -(-count // columns)
        self.picture = oiio.ImageBuf(oiio.ImageSpec(columns * (size + 4), rows * self.height, 3,
                                                    oiio.UINT8))

    def add(self, content, text):
        x = self.next % self.columns * (self.size + 4)
        y = self.next // self.columns * self.height
        self.next += 1
        if isinstance(content, tuple):
            oiio.ImageBufAlgo.fill(self.picture, content,
                                   oiio.ROI(x, x + self.size, y, y + self.size))
        else:
            whole = oiio.ImageBufAlgo.channels(oiio.ImageBuf(str(content)), (0, 1, 2))
            fitted = oiio.ImageBufAlgo.fit(whole, "", 0, False,
                                           oiio.ROI(0, self.size, 0, self.size, 0, 1, 0, 3))
            oiio.ImageBufAlgo.paste(self.picture, x, y, 0, 0, fitted)
        letters = self.size // 6
        lines = [text[i:i + letters] for i in range(0, len(text), letters)][-self.LINES:]
        for i, line in enumerate(lines):
            oiio.ImageBufAlgo.render_text(self.picture, x, y + self.size + (i + 1) * self.LINE,
                                          line, 10, "DejaVuSans", (1, 1, 1))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="ribalta")
    parser.add_argument("paths", nargs="+", help="models, or folders of them")
    parser.add_argument("-o", "--output", required=True, help="the sheet")
    parser.add_argument("--references", action="append", default=[], metavar="FOLDER")
    parser.add_argument("--size", type=int, default=128, help="pixels a side (default: 128)")
    parser.add_argument("--columns", type=int, default=12, help="pictures in a row (default: 12)")
    parser.add_argument("--seconds", type=int, default=120, help="longest for a model")
    parser.add_argument("--render", action="append", default=[], metavar="OPTION",
                        help="option for `ribalta render`, such as --render=--ambient=2000")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()

    models = find_models(arguments.paths)
    if not models:
        sys.exit("contact_sheet: no models there")
    root = pathlib.Path(os.path.commonpath([model.resolve().parent for model in models]))
    references = find_references(arguments.references)
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        drawer = Drawer(arguments.program, arguments.render, arguments.size, arguments.seconds,
                        folder)
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            drawn = list(pool.map(lambda each: drawer.draw(*each), enumerate(models)))
        cells = []
        for model, (content, wrong) in zip(models, drawn):
            name = str(model.resolve().relative_to(root))
            if wrong:
                failures += 1
                print(f"{name}: {wrong}")
            cells.append((content, name))
            beside = [model.with_suffix(end) for end in PICTURES]
            reference = next((each for each in beside if each.is_file()),
                             references.get(model.stem))
            if reference:
                cells.append((reference, "reference"))
        sheet = Sheet(arguments.size, arguments.columns, len(cells))
        for cell in cells:
            sheet.add(*cell)
        if not sheet.picture.write(arguments.output):
            sys.exit(f"contact_sheet: {sheet.picture.geterror()}")
    print(f"{len(models)} models, {failures} failed; {arguments.output}")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
