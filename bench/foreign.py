# SPDX-License-Identifier: BSD-3-Clause
"""Rooms made by other programs' own calls and writers, for bench/foreign.sh: foreign.py FOLDER
Two of Honeybee (honeybee-radiance) and one of frads; each folder below FOLDER has a room.rad with its materials.
"""
import importlib.util
import pathlib
import re
import sys
import types

from honeybee.model import Model
from honeybee.room import Room
from honeybee_radiance.lib import modifiers

# frads without EnergyPlus, which its package would load: the one file that makes rooms
package = types.ModuleType("frads")
package.__path__ = importlib.util.find_spec("frads").submodule_search_locations
sys.modules["frads"] = package
from frads.room import create_south_facing_room  # noqa: E402


def write(name, text):
    folder = pathlib.Path(sys.argv[1]) / name
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "room.rad").write_text(text + "\n")


def honeybee(name, room):
    model = Model(name, [room])
    text = model.to.rad(model)
    surfaces = text if isinstance(text, str) else "\n\n".join(text)
    defaults = {m.identifier: m for m in vars(modifiers).values() if hasattr(m, "to_radiance")}
    used = sorted(set(re.findall(r"^(\S+) polygon", surfaces, re.MULTILINE)))
    write(name, "\n\n".join([defaults[m].to_radiance() for m in used] + [surfaces]))


tiny = Room.from_box("Tiny_House", 5, 10, 3)
tiny[1].apertures_by_ratio(0.3)  # north
tiny[3].apertures_by_ratio(0.4)  # south
tiny[3].apertures[0].overhang(0.5, indoor=False)
tiny[3].apertures[0].overhang(0.5, indoor=True)
honeybee("tiny_house", tiny)

louvers = Room.from_box("Office", 5, 8, 3)
louvers[3].apertures_by_width_height_rectangle(1.8, 1.2, 0.9, 2)
for aperture in louvers[3].apertures:
    aperture.louvers_by_count(8, 0.1, 0, 20)
honeybee("louvers", louvers)

windows = [[0.5, 0.8, 2.6, 1.8], [3.9, 0.8, 2.6, 1.8]]  # left, sill, width, height
south = create_south_facing_room(7, 5, 3.6, 3, swall_thickness=0.3, wpd=windows)
primitives = south.materials + south.primitives() + south.window_primitives()
write("south_room", "\n".join(p.bytes.decode() for p in primitives))
