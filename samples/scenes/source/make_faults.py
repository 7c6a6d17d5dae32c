"""Four small scenes, one for each known fault of beams made of planes through the whole view (Pessoa
2007). Usage: python3 make_faults.py ../faults"""

import pathlib
import sys

from write_gltf import GltfScene, Shape

folder = pathlib.Path(sys.argv[1])
folder.mkdir(exist_ok=True)


def add_wall(scene):
    """Dark, and far enough back for the planes to go through all of the beams."""
    black = scene.material("wall", (0.0, 0.0, 0.0))
    scene.shape("wall", Shape().quad([0, 2, -4], [14, 0, 0], [0, 10, 0]), black)


def stripes():
    """A wide, even beam on a floor that is seen at a slant: the planes end on it line by line."""
    scene = GltfScene("make_faults.py")
    grey = scene.material("floor", (0.0, 0.0, 0.0))
    scene.shape("floor", Shape().quad([0, 0, 0], [12, 0, 0], [0, 0, -12]), grey)
    scene.spot("spot", [0.0, 9.0, -1.0], [0.0, 0.0, -1.5], 20000.0, 40.0, 39.0)
    scene.camera("slanted", [0.0, 2.0, 9.0], [0.0, 0.0, -1.0], 40.0)
    return scene


def aliasing():
    """A light map of 36 fine wedges, seen from the side and from within its light."""
    scene = GltfScene("make_faults.py")
    siemens = pathlib.Path(__file__).resolve().parents[1] / "gobo_siemens.png"
    add_wall(scene)
    texture = scene.image("gobo_siemens", siemens.read_bytes())
    scene.spot(
        "spot", [-4.0, 3.0, 0.0], [4.0, 1.0, 0.0], 20000.0, 18.0, 17.0, light_map={"texture": texture}
    )
    scene.camera("side", [0.0, 2.0, 9.0], [0.0, 2.0, 0.0], 40.0)
    return scene


def quantisation():
    """One soft beam across an empty view: many close planes, each of which adds little."""
    scene = GltfScene("make_faults.py")
    add_wall(scene)
    scene.spot("spot", [-5.0, 2.0, 0.0], [5.0, 1.0, 0.0], 20000.0, 16.0, 0.0)
    scene.camera("side", [0.0, 1.5, 8.0], [0.0, 1.5, 0.0], 40.0)
    return scene


def streaks():
    """Thin beams that run all but along the planes: each lies now on one plane, now between two."""
    scene = GltfScene("make_faults.py")
    add_wall(scene)
    for i in range(5):
        y = 0.6 * (i - 2)
        scene.spot(f"spot_{i}", [-3.0, y, 0.11 * i], [3.0, y, 0.11 * i - 0.5], 20000.0, 1.0)
    scene.camera("front", [0.0, 0.0, 8.0], [0.0, 0.0, 0.0], 40.0)
    return scene


for make in (stripes, aliasing, quantisation, streaks):
    make().save(folder / f"{make.__name__}.glb")
