#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# make_room.py DRAW FOLDER: a room that nobody designed, for the study of intervals: room.rad, sky.rad, view.vf and
# regions.txt (a task area and a contrast pair).  All of it follows from the integer DRAW.
# make_room.py DRAW ...: what these rooms are, a line each.
# Draws below 1000 are for choosing constants, draws from 1000 on for judging them.
import math, os, sys
from rad import CD, Draws, Scene, colour, finish, placed, unmoved, upright


GLOWS = '''skyfunc glow sky_glow
0
0
4 1 1 1.1 0
sky_glow source sky
0
0
4 0 0 1 180
skyfunc glow ground_glow
0
0
4 1 .95 .8 0
ground_glow source ground
0
0
4 0 0 -1 180
'''


class Room:
    def __init__(self, draw):
        d = self.d = Draws(draw)
        self.scene = Scene()
        self.width, self.depth, self.height = d.log(2.6, 9), d.log(3, 12), d.between(2.5, 3.8)
        self.sun = d.one_of(('in view', 3), ('in the room', 4), ('elsewhere', 2), ('overcast', 2), ('night', 1))
        self.seated = d.chance(.6)
        self.walls = ['south'] + (['west'] if d.chance(.3) else []) + (['north'] if d.chance(.12) else [])
        self.surfaces()
        self.blinds = False
        self.panes = [pane for wall in self.walls for pane in self.window_wall(wall)]
        self.eye_and_task()
        self.screen()
        self.lamps_and_things()
        self.sky()

    def surfaces(self):
        d, s, (w, l, h) = self.d, self.scene, (self.width, self.depth, self.height)
        self.floor = finish(d, s, 'floor_finish', .08, .5, .5)
        self.wall = finish(d, s, 'wall_finish', .3, .8, .1)
        self.ceiling = finish(d, s, 'ceiling_finish', .5, .85, 0)
        self.frame = s.material('metal', 'frame', .6, .6, .6, .7, .15)
        self.glass = s.material('glass', 'pane', *[min(1, 1.09 * t) for t in colour(d, .3, .85, .04)])
        s.polygon(self.floor, [(0, 0, 0), (w, 0, 0), (w, l, 0), (0, l, 0)])
        s.polygon(self.ceiling, [(0, 0, h), (0, l, h), (w, l, h), (w, 0, h)])
        s.polygon(self.wall, [(w, 0, 0), (w, 0, h), (w, l, h), (w, l, 0)])
        for name, corners in (('west', [(0, 0, 0), (0, l, 0), (0, l, h), (0, 0, h)]),
                              ('north', [(0, l, 0), (w, l, 0), (w, l, h), (0, l, h)])):
            if name not in self.walls:
                s.polygon(self.wall, corners)

    def window_wall(self, name):
        """A wall with a row of panes, some with blinds; gives the rectangles of glass."""
        d, s = self.d, self.scene
        at, long = {'south': (placed(0, 0, 0), self.width),
                    'north': (placed(self.width, self.depth, math.pi), self.width),
                    'west': (placed(0, self.depth, math.pi / 2), self.depth)}[name]
        count = d.whole(1, max(1, min(5, int(long / 1.2))))
        sill, head = d.one_of((.02, 1), (.5, 2), (.85, 3), (1.5, 1)), self.height - d.between(.1, .7)
        margin, post = d.between(.2, .3) * long / 2 * d.random() + .1, d.between(.05, .6)
        wide = max(.3, (long - 2 * margin - (count - 1) * post) / count)
        margin = (long - count * wide - (count - 1) * post) / 2
        recess = d.between(.05, .35)

        def sheet(material, x0, x1, y, z0, z1):
            if x1 - x0 > 1e-3 and z1 - z0 > 1e-3:
                s.polygon(material, [at(p) for p in ((x0, y, z0), (x0, y, z1), (x1, y, z1), (x1, y, z0))])

        sheet(self.wall, 0, long, 0, 0, sill)
        sheet(self.wall, 0, long, 0, head, self.height)
        edges = [margin + k * (wide + post) for k in range(count)]
        for x0, x1 in zip([0] + [x + wide for x in edges], edges + [long]):
            sheet(self.wall, x0, x1, 0, sill, head)
        blinds = d.chance(.3) and d.between(-50, 60) * math.pi / 180
        if blinds is not False:
            slat = finish(d, s, 'slat_' + name, .4, .75, .4)
            slats = int((head - sill) * d.between(.3, 1) / .06)
        for x in edges:
            sheet(self.glass, x, x + wide, -recess, sill, head)
            for p, q in (((x, sill), (x + wide, sill)), ((x, head), (x + wide, head)), ((x, sill), (x, head)),
                         ((x + wide, sill), (x + wide, head))):
                s.polygon(self.wall, [at((p[0], 0, p[1])), at((q[0], 0, q[1])), at((q[0], -recess, q[1])),
                                      at((p[0], -recess, p[1]))])
            bar = d.between(.02, .04)
            s.box(self.frame, at, (x + wide / 2 - bar, -recess, sill), (x + wide / 2 + bar, -recess + .04, head))
            if blinds is not False:
                self.slats(slat, at, x, x + wide, head, slats, blinds)
        self.blinds |= blinds is not False
        return [(at, x, x + wide, sill, head, -recess) for x in edges]

    def slats(self, material, at, x0, x1, head, count, tilt):
        for k in range(count):
            z, half = head - .03 - .06 * k, .035
            y0, y1 = .04 + half - half * math.cos(tilt), .04 + half + half * math.cos(tilt)
            z0, z1 = z - half * math.sin(tilt), z + half * math.sin(tilt)
            self.scene.polygon(material, [at(p) for p in ((x0, y0, z0), (x1, y0, z0), (x1, y1, z1), (x0, y1, z1))])

    def eye_and_task(self):
        """The eye, where it looks, and what it works on: a desk, or an area of the floor ahead."""
        d, s = self.d, self.scene
        reach = 1.15 if self.seated else 3.1
        while True:
            x, y, turn = d.between(.4, self.width - .4), d.between(.5, self.depth - .4), d.between(-math.pi, math.pi)
            if self.sun == 'in view':
                turn = math.pi + d.between(-.9, .9)
            inside = [placed(x, y, turn)((side, far, 0)) for side in (-.7, .7) for far in (.1, reach)]
            if all(.1 < px < self.width - .1 and .15 < py < self.depth - .1 for px, py, _ in inside):
                break
            reach = max(.9, .995 * reach)
        self.eye, self.turn, self.reach = (x, y, d.between(*((1.1, 1.3) if self.seated else (1.5, 1.75)))), turn, reach
        self.ahead = at = placed(x, y, turn)
        if self.seated:
            top = d.between(.7, .76)
            desk = finish(d, s, 'desk_finish', .1, .7, .4)
            s.box(desk, at, (-.7, .25, top - .03), (.7, .95, top))
            s.box(self.frame, at, (-.69, .9, 0), (-.64, .94, top - .03))
            s.box(self.frame, at, (.64, .9, 0), (.69, .94, top - .03))
            self.task = [(-.6, .3, top), (.6, .3, top), (.6, .7, top), (-.6, .7, top)]
            self.top = top
        else:
            near, side = d.between(.8, .5 * reach + .4), d.between(.15, .6)
            far = min(reach, near + d.between(.3, 1.2))
            self.task = [(-side, near, 0), (side, near, 0), (side, far, 0), (-side, far, 0)]

    def screen(self):
        """A contrast pair: two halves of a screen, or of a board where nobody sits."""
        d, s, at = self.d, self.scene, self.ahead
        if self.seated:
            y, z0, z1, half = .85, self.top + .12, self.top + .12 + d.between(.25, .4), d.between(.22, .34)
            high = s.material('glow', 'shown_high', *([d.log(60, 400) * CD] * 3 + [0]))
            low = s.material('glow', 'shown_low', *([d.log(.3, 8) * CD] * 3 + [0]))
            cover = d.one_of((None, 1), ('glass', 1), ('plastic', 1))
        else:
            y, z0, half = self.reach, d.between(.9, 1.1), d.between(.3, .6)
            z1 = z0 + d.between(.5, .9)
            high, low = finish(d, s, 'board_high', .6, .85, .3), finish(d, s, 'board_low', .04, .3, .5)
            cover = None
        if cover == 'plastic':  # what shines, seen in a matt sheet in front of half of it
            low = s.material('plastic', 'screen_matt', .03, .03, .03, .04, d.between(.05, .2))
        self.pair = [upright(at, -half, 0, y, z0, z1), upright(at, 0, half, y, z0, z1)]
        s.polygon(high, self.pair[0])
        s.polygon(low, self.pair[1])
        if cover == 'glass':
            s.polygon(s.material('glass', 'screen_cover', .95, .95, .95), upright(at, -half, half, y - .01, z0, z1))
        case = s.material('plastic', 'screen_case', .08, .08, .08, .02, .1)
        s.box(case, at, (-half - .02, y + .01, z0 - .02), (half + .02, y + .05, z1 + .02))

    def lamps_and_things(self):
        d, s, (w, l, h) = self.d, self.scene, (self.width, self.depth, self.height)
        kinds = [('panels', 4), ('spots', 3), ('globes', 2)] + ([] if self.sun == 'night' else [('none', 4)])
        self.lamps = d.one_of(*kinds)
        columns, rows = d.whole(1, max(1, int(w / 1.5))), d.whole(1, max(1, int(l / 1.5)))
        sizes = {'panels': d.between(.1, .35), 'spots': d.between(.02, .06), 'globes': d.between(.08, .2)}
        cdm2 = {'panels': d.log(1500, 8000), 'spots': d.log(2e4, 2e5), 'globes': d.log(1500, 9000)}
        if self.lamps != 'none':
            size, bright = sizes[self.lamps], cdm2[self.lamps] * CD
            lamp = s.material('light', 'lamp', bright * 1.05, bright, bright * d.between(.6, .95))
            for k in range(columns * rows):
                x, y, z = w * (k % columns + .5) / columns, l * (k // columns + .5) / rows, h - .01
                if self.lamps == 'globes':
                    s.sphere(lamp, (x, y, h - size - d.between(.1, .5)), size)
                else:
                    s.polygon(lamp, [(x - size, y - size, z), (x - size, y + size, z), (x + size, y + size, z),
                                     (x + size, y - size, z)])
        for k in range(d.whole(0, 3)):
            high, deep, long = d.between(.5, 2), d.between(.3, .5), d.between(.5, 1.5)
            start = d.between(.1, max(.11, l - long - .1))
            s.box(finish(d, s, 'cabinet%d' % k, .1, .8, .5), unmoved, (w - deep - .01, start, .001),
                  (w - .01, start + long, high))
        if d.chance(.4):
            ball = s.material('metal', 'ball', *(colour(d, .5, .9) + [.9, d.one_of((0, 1), (.05, 1), (.15, 1))]))
            radius = d.between(.06, .15)
            stands = self.top if self.seated else 0
            s.sphere(ball, self.ahead((d.one_of((-.55, 1), (.55, 1)), .8, radius + stands)), radius)

    def to_sun(self):
        """Degrees of altitude and west of south of a sun that the eye or a point of the floor sees through glass."""
        d = self.d
        for _ in range(500):
            at, x0, x1, z0, z1, y = self.panes[d.whole(0, len(self.panes) - 1)]
            to = at((d.between(x0, x1), y, d.between(z0, z1)))
            start = self.eye if self.sun == 'in view' else (d.between(0, self.width), d.between(0, self.depth), 0)
            v = [b - a for a, b in zip(start, to)]
            length = math.sqrt(sum(c * c for c in v))
            altitude = math.degrees(math.asin(v[2] / length))
            facing = (v[0] * math.sin(self.turn) + v[1] * math.cos(self.turn)) / length
            if 3 < altitude < 65 and (self.sun != 'in view' or facing > .3):
                return altitude, math.degrees(math.atan2(-v[0], -v[1]))
        return d.between(10, 40), 0

    def sky(self):
        d = self.d
        if self.sun == 'night':
            self.sky_text = ''
            return
        if self.sun in ('in view', 'in the room'):
            altitude, azimuth = self.to_sun()
        else:
            altitude, azimuth = d.between(8, 60), d.between(100, 260)
        kind = '-c' if self.sun == 'overcast' else '+s' if d.chance(.8) else '+i'
        self.sky_text = '!gensky -ang %.3f %.3f %s -g %.2f\n' % (altitude, azimuth, kind, d.between(.1, .4)) + GLOWS
        if self.sun in ('elsewhere', 'overcast') and d.chance(.5):
            brick = finish(d, self.scene, 'opposite', .1, .6, .1)
            self.scene.box(brick, unmoved, (-15, -20, -8), (15, -d.between(8, 16), d.between(2, 9)))

    def __str__(self):
        return '%.1f x %.1f x %.1f m; windows %s, %d panes%s; sun %s; lamps %s; %s' % (
            self.width, self.depth, self.height, ' '.join(self.walls), len(self.panes),
            ', blinds' if self.blinds else '', self.sun, self.lamps, 'seated' if self.seated else 'standing')

    def write(self, folder, draw):
        os.makedirs(folder, exist_ok=True)
        region = lambda points: '  '.join('%.4f %.4f %.4f' % tuple(p) for p in points)
        aim = (math.sin(self.turn), math.cos(self.turn), self.d.between(-.4, .05))
        view = 'rvu -vta -vp %.4f %.4f %.4f -vd %.4f %.4f %.4f -vu 0 0 1 -vh 180 -vv 180\n' % (self.eye + aim)
        regions = ''.join('%s polygon3d %s\n' % r for r in (
            ('desk', region([self.ahead(p) for p in self.task])), ('high', region(self.pair[0])),
            ('low', region(self.pair[1]))))
        files = {'room.rad': '# make_room.py %d: %s\n' % (draw, self) + ''.join(self.scene.lines),
                 'sky.rad': self.sky_text, 'view.vf': view, 'regions.txt': regions}
        for name, text in files.items():
            with open(os.path.join(folder, name), 'w') as out:
                out.write(text)


if __name__ == '__main__':
    if len(sys.argv) == 3 and not sys.argv[2].isdigit():
        Room(int(sys.argv[1])).write(sys.argv[2], int(sys.argv[1]))
    else:
        for arg in sys.argv[1:]:
            print(arg, Room(int(arg)))
