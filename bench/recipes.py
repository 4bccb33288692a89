# SPDX-License-Identifier: BSD-3-Clause
"""recipes.py FOLDER [RUNS [WEA]]: Ladybug Tools' recipes by RADIANCE and by the folder that luxpipe-radiance makes.

Needs lbt-recipes and pyradiance beside this Python, and luxpipe or LUXPIPE_BIN.  A room of 4 x 6 m with a window to the
south: point-in-time-view (rpict), HB Glare Postprocess's calls (evalglare on each picture), and the recipes of grids,
which call rtrace.  Prints a line a run: recipe, by what, numbers, processor and wall seconds.
The numbers' noise is what differs between RUNS (2) of other seeds; RADIANCE's -ad stands for a seed.  The recipe
renders 1600 x 1600 pixels and averages them to 800 x 800.
"""

import os
import resource
import subprocess
import sys
import time
from pathlib import Path

import pyradiance
from honeybee.model import Model
from honeybee.room import Room
from honeybee_radiance.config import folders
from honeybee_radiance.sensorgrid import SensorGrid
from honeybee_radiance.view import View
from lbt_recipes.recipe import Recipe, RecipeSettings

OUT = Path(sys.argv[1]).absolute()
RUNS = int((sys.argv[2:] or ["2"])[0])
WEA = (sys.argv[3:] or [None])[0]  # of leed-daylight-option-two
SKY = "cie 21 Dec 12:00 -lat 42.36 -lon -71.06 -tz -5 -type 0"
TOP = Path(__file__).resolve().parents[1]


def room():
    """Return the room as a model with one view, a fisheye at the back that looks at the window, and one grid."""
    box = Room.from_box("Room", 4, 6, 3)
    box[3].apertures_by_ratio(0.4)  # south
    model = Model("room", [box])
    eye = View("desk", (2, 3.5, 1.2), (0, -1, 0), (0, 0, 1), "a", 180, 180)
    eye.room_identifier = "Room"
    model.properties.radiance.add_view(eye)
    grid = SensorGrid.from_mesh3d("floor", box.generate_grid(0.5, offset=0.8))
    grid.room_identifier = "Room"
    model.properties.radiance.add_sensor_grid(grid)
    return model


def timed(call):
    """Return what a call gives, and processor and wall seconds of all programs that it ran."""
    def used():
        r = resource.getrusage(resource.RUSAGE_CHILDREN)
        return r.ru_utime + r.ru_stime
    cpu, wall = used(), time.monotonic()
    result = call()
    return result, used() - cpu, time.monotonic() - wall


def recipe(name, radiance, folder, sky=SKY, **values):
    """Run a recipe with the programs of radiance/bin; return the folder of its results."""
    folders.radiance_path = str(radiance)
    run = Recipe(name)
    run.input_value_by_name("model", room())
    if sky:
        run.input_value_by_name("sky", sky)
    for key, value in values.items():
        run.input_value_by_name(key.replace("_", "-"), value)
    queenbee = Path(sys.executable).parent / "queenbee"
    run.run(RecipeSettings(str(folder), 2), queenbee_path=str(queenbee), silent=True)
    return next(folder.glob("*/results"))


def glare(radiance, picture, task):
    """Return evalglare's numbers as the component HB Glare Postprocess (1.38) asks for them; task: with a task area."""
    check = picture.with_name(picture.stem + "_check.HDR")
    where = ["-T", "400", "300", "0.5235987755982988"] if task else []
    words = ["-c", check, "-vta", "-vv", "180", "-vh", "180", *where, picture]
    done = subprocess.run([radiance / "bin" / "evalglare", *words], stdout=subprocess.PIPE, check=True, text=True)
    assert check.stat().st_size > 1000
    return [float(word) for word in done.stdout.split(":")[-1].strip().split(" ")]


def say(name, by, numbers, cpu, wall):
    print(name, by, numbers, f"{cpu:.1f}", f"{wall:.1f}", sep="\t", flush=True)


def main():
    theirs = Path(pyradiance.BINPATH).parent
    ours = OUT / "luxpipe"
    make = "import sys; from luxpipe._radiance_bin import main; main()"
    subprocess.run([sys.executable, "-c", make, str(ours), "-radiance", str(theirs / "bin")], check=True,
                   stdout=subprocess.DEVNULL, env={"PYTHONPATH": str(TOP / "python"), **os.environ})
    print("recipe", "by", "numbers", "cpu_s", "wall_s", sep="\t")
    for run in range(RUNS):
        for by, radiance in (("RADIANCE", theirs), ("luxpipe", ours)):
            os.environ["LUXPIPE_OPTIONS"] = f"-seed {run + 1}"
            results, *took = timed(lambda: recipe("point-in-time-view", radiance, OUT / f"view{run}{by}",
                                                  radiance_parameters=f"-ab 4 -ad {2048 + run}"))
            picture = next(results.rglob("*.HDR"))
            ev = subprocess.run([theirs / "bin" / "evalglare", "-V", picture], stdout=subprocess.PIPE, text=True).stdout
            say("point-in-time-view", by, f"Ev {float(ev):.1f}", *took)
            for eye, tool in (("RADIANCE", theirs), ("luxpipe", ours)):
                for task in (False, True):
                    numbers, *took = timed(lambda: glare(tool, picture, task))
                    say(f"HB Glare Postprocess of {by}'s{' with a task' if task else ''}", eye,
                        " ".join(f"{x:.4f}" for x in numbers), *took)
    os.environ.pop("LUXPIPE_OPTIONS", None)
    grids = {"point-in-time-grid": {}, "daylight-factor": {"sky": None}, "sky-view": {"sky": None}}
    if WEA:
        grids["leed-daylight-option-two"] = {"sky": None, "wea": WEA}
    for name, values in grids.items():
        for by, radiance in (("RADIANCE", theirs), ("luxpipe", ours)):
            results, *took = timed(lambda: recipe(name, radiance, OUT / f"{name}{by}", **values))
            lux = sorted(results.parent.glob("visualization/illuminance*/*.res"))  # of leed; its results are verdicts
            for file in lux or sorted(results.rglob("*.res")):
                found = [float(line) for line in file.read_text().split()]
                numbers = f"{len(found)} points, mean {sum(found) / len(found):.5g}, min {min(found):.5g}"
                say(f"{name} {file.parent.name}", by, numbers, *took)


if __name__ == "__main__":
    main()
