# SPDX-License-Identifier: BSD-3-Clause
# The scenes of the study: a draw of make_room.py, or one of examples/scenes.  prepare() gives the folder to work in,
# the words of ptrace that name view and scene, and a file with the regions desk, high and low.
import os
from make_room import Room

HERE = os.path.dirname(os.path.abspath(__file__))
EXAMPLES = os.path.join(HERE, '..', '..', 'examples', 'scenes')

# folder, view and files, regions
DESIGNED = {
    'office': ('office', '-vf view.vf materials.rad layout.rad sky_1400.rad', 'office'),
    'blinds': ('office', '-vf view.vf materials.rad layout.rad blinds.rad sky_1100.rad', 'office'),
    'classroom': ('classroom', '-vf back_row.vf materials.rad room.rad furniture.rad ceiling_lights.rad outside.rad'
                  ' sky_afternoon.rad', 'classroom'),
    'gallery': ('gallery', '-vf west.vf materials.rad room.rad objects.rad sky_noon.rad', 'gallery'),
}
REGIONS = {
    'office': 'desk polygon3d 1.1 1.7 .75  2.9 1.7 .75  2.9 2.5 .75  1.1 2.5 .75\n'
              'high polygon3d 2 1.871 .9  1.71 1.871 .9  1.71 1.871 1.24  2 1.871 1.24\n'
              'low polygon3d 2.29 1.871 .9  2 1.871 .9  2 1.871 1.24  2.29 1.871 1.24\n',
    'classroom': 'desk polygon3d 6.2 5.65 .75  7.4 5.65 .75  7.4 6.2 .75  6.2 6.2 .75\n'
                 'high polygon3d 5 .03 .9  2.2 .03 .9  2.2 .03 2.1  5 .03 2.1\n'
                 'low polygon3d 8.2 .03 .9  5.2 .03 .9  5.2 .03 2.1  8.2 .03 2.1\n',
    'gallery': 'desk rect fraction .4 .2 .6 .35\nhigh rect fraction .3 .45 .5 .6\nlow rect fraction .5 .45 .7 .6\n',
}


def prepare(name, out):
    if name.isdigit():
        folder = os.path.join(out, name)
        if not os.path.exists(os.path.join(folder, 'view.vf')):
            Room(int(name)).write(folder, int(name))
        return folder, ['-vf', 'view.vf', 'room.rad', 'sky.rad'], os.path.join(folder, 'regions.txt')
    folder, words, regions = DESIGNED[name]
    os.makedirs(os.path.join(out, name), exist_ok=True)
    place = os.path.join(out, name, 'regions.txt')
    with open(place, 'w') as f:
        f.write(REGIONS[regions])
    return os.path.join(EXAMPLES, folder), words.split(), place


def names(text):
    """'1-3 office' as 1 2 3 office."""
    out = []
    for word in text.split():
        low, dash, high = word.partition('-')
        out += [str(n) for n in range(int(low), int(high) + 1)] if dash else [word]
    return out
