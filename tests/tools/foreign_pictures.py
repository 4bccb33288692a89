# SPDX-License-Identifier: BSD-3-Clause
# Pictures as other programs write them: foreign_pictures.py FOLDER writes them there, all of the same grey fisheye, and
# prints a line for each: file, factor by which its illuminance at the eye is that of plain.hdr ("-": it is refused).
import struct, sys

folder, side = sys.argv[1], 32
grey = bytes([128, 128, 128, 129])  # (128.5 / 128) for each channel
VIEW = 'VIEW= -vta -vh 180 -vv 180\n'
RGBE = 'FORMAT=32-bit_rle_rgbe\n'


def runs(row):  # new run-length scanline of one value a component
    return bytes([2, 2, side >> 8, side & 255]) + b''.join(bytes([128 + side, v]) for v in row)


def hdr(name, factor, head, pixels=grey * side * side, size=f'-Y {side} +X {side}\n', end='\n'):
    with open(f'{folder}/{name}.hdr', 'wb') as f: f.write((head + end + size).encode('latin1') + pixels)
    print(f'{name}.hdr', factor)


def attribute(name, kind, data):
    return name.encode() + b'\0' + kind.encode() + b'\0' + struct.pack('<i', len(data)) + data


def text(name, value): return attribute(name, 'string', value.encode())


def exr(name, factor, channels, *attributes, window=None, half=False, level=128.5 / 128):
    """An uncompressed scanline file; channels: their names, in the alphabet's order."""
    box = struct.pack('<4i', 0, 0, side - 1, side - 1)
    entry = lambda c: c.encode() + b'\0' + struct.pack('<iiii', 1 if half else 2, 0, 1, 1)
    head = b'\x76\x2f\x31\x01' + struct.pack('<i', 2) + b''.join((
        attribute('channels', 'chlist', b''.join(map(entry, channels)) + b'\0'),
        attribute('compression', 'compression', b'\0'),
        attribute('dataWindow', 'box2i', box), attribute('displayWindow', 'box2i', box),
        attribute('lineOrder', 'lineOrder', b'\0'), attribute('pixelAspectRatio', 'float', struct.pack('<f', 1)),
        attribute('screenWindowCenter', 'v2f', struct.pack('<2f', 0, 0)),
        attribute('screenWindowWidth', 'float', struct.pack('<f', 1)), *attributes)) + b'\0'
    values = {c: 1 if c == 'A' else level[c] if isinstance(level, dict) else level for c in channels}
    line = b''.join(struct.pack('<e' if half else '<f', values[c]) * side for c in channels)
    first = len(head) + 8 * side
    table = b''.join(struct.pack('<Q', first + y * (8 + len(line))) for y in range(side))
    with open(f'{folder}/{name}.exr', 'wb') as f:
        f.write(head + table + b''.join(struct.pack('<2i', y, len(line)) + line for y in range(side)))
    print(f'{name}.exr', factor)


hdr('plain', 1, '#?RADIANCE\n' + VIEW + RGBE)
# RADIANCE: now, with exposures, of an animation, of the first years
hdr('rpict', 1, '#?RADIANCE\nrpict -vta -vh 180 -vv 180 -ps 1 room.oct\nSOFTWARE= RADIANCE 6.1a\n' + VIEW +
    'CAPDATE= 2026:11:25 10:00:00\nGMT= 2026:11:25 09:00:00\n' + RGBE)
hdr('animation', 1, '#?RADIANCE\nrpict -S 1\nFRAME=7\n' + VIEW + RGBE)
hdr('pfilt', .25, '#?RADIANCE\n' + VIEW + 'pfilt -e 4 -1\nEXPOSURE=4.000000e+00\n' + RGBE)
hdr('first', 1, 'rpict -vta -vh 180 -vv 180 room.oct\n' + RGBE)
hdr('first_plain', 1, 'rpict -vta -vh 180 -vv 180 room.oct\n')
hdr('first_view', 1, VIEW)
hdr('no_format', 1, '#?RADIANCE\n' + VIEW)
# Photoshop, ImageMagick, Poly Haven, GIMP
ZEROS = 'PRIMARIES=0 0 0 0 0 0 0 0\n'
hdr('photoshop', 1, '#?RADIANCE\n# Made with Adobe Photoshop\nGAMMA=1\n' + ZEROS + VIEW + RGBE, runs(grey) * side)
hdr('imagemagick', 1, '#?RADIANCE\nSOFTWARE=ImageMagick 7.1\nGAMMA=0.454545\n'
    'PRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329\n' + VIEW + RGBE)
hdr('imagemagick_zeros', .5, '#?RADIANCE\n#a comment\nEXPOSURE=2\nGAMMA=1\n' + ZEROS + VIEW + RGBE)
hdr('gimp', 1, '#?RGBE\nSOFTWARE=gegl 0.4\n' + VIEW + RGBE)
# Blender, stb_image_write, FreeImage, OpenCV, rgbe.c, pfstools, 3ds Max, Photomatix
ONE = 'EXPOSURE=          1.0000000000000\n'
hdr('blender', 1, '#?RADIANCE\n# Created with Blender\n' + RGBE + ONE + VIEW, runs(grey) * side)
hdr('stb', 1, '#?RADIANCE\n# Written by stb_image_write.h\n' + RGBE + ONE + VIEW)
hdr('freeimage', 1, '#?RGBE\n# Made with FreeImage 3.18.0\n' + RGBE + 'GAMMA=1\n' + VIEW)
hdr('opencv', 1, '#?RGBE\n' + RGBE + VIEW)
hdr('rgbe_c', 1, '#?RGBE\nGAMMA=1.000000\nEXPOSURE=1.000000\n' + VIEW + RGBE)
hdr('pfstools', 1, '#?RADIANCE\n# PFStools writer\nSOFTWARE=PFSTools\n' + VIEW + RGBE)
hdr('max', 1, ('#?RADIANCE\nSOFTWARE=3ds Max\n' + VIEW + RGBE).replace('\n', '\r\n'), end='\r\n')
hdr('autopano', 1, '#?AUTOPANO\nEXPOSURE= 1.0\n' + VIEW + RGBE, size=f'-Y  {side}  +X  {side} \n')
# hdrgen, Photosphere, and their keys
hdr('hdrgen', .5, '#?RADIANCE\nhdrgen -a -r cam.rsp *.JPG\nCAPDATE= 2026:01:02 03:04:05\n' + VIEW +
    'EXPOSURE=2.000000e+00\nPRIMARIES= 0.6400 0.3300 0.2900 0.6000 0.1500 0.0600 0.3333 0.3333\n'
    'COLORCORR= 1.000000 1.000000 1.000000\nSTONITS=179\n' + RGBE)
hdr('xyze', 1 / 179, '#?RADIANCE\n' + VIEW + 'FORMAT=32-bit_rle_xyze\n')
hdr('upward', 1, '#?RADIANCE\n' + VIEW + RGBE, size=f'+Y {side} +X {side}\n')
hdr('aspect', 1, '#?RADIANCE\n' + VIEW + 'PIXASPECT=1.000000\n' + RGBE)
hdr('floats', 1, '#?RADIANCE\n' + VIEW + f'NROWS={side}\nNCOLS={side}\nNCOMP=3\nBigEndian=0\nFORMAT=float\n',
    struct.pack('<f', 128.5 / 128) * 3 * side * side, size='')
# what nobody can read, or means nothing
hdr('no_exposure', '-', '#?RADIANCE\n' + VIEW + 'EXPOSURE=0\n' + RGBE)
hdr('half_primaries', '-', '#?RADIANCE\n' + VIEW + 'PRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0 0\n' + RGBE)
hdr('spectral', '-', '#?RADIANCE\n' + VIEW + 'NCOMP=6\nWAVELENGTH_SPLITS=780 588 480 380\nFORMAT=Radiance_spectra\n')
hdr('two_heads', '-', '#?RADIANCE\n\n' + VIEW + RGBE)
with open(f'{folder}/text.hdr', 'w') as f: f.write('Not a picture.\n\nAt all.\n')
print('text.hdr -')

V = text('VIEW', '-vta -vh 180 -vv 180')
primaries = lambda *p: attribute('chromaticities', 'chromaticities', struct.pack('<8f', *p))
rec709, p3 = (.64, .33, .3, .6, .15, .06, .3127, .329), (.68, .32, .265, .69, .15, .06, .3127, .329)
aces = (.7347, .2653, 0, 1, .0001, -.077, .32168, .33767)
green = {'R': 0, 'G': 128.5 / 128, 'B': 0}
exr('blender', 1, 'ABGR', V, text('Scene', 'Scene'), text('Frame', '012'), text('Camera', 'Eye'),
    text('File', 'a.blend'), text('RenderTime', '00:01.20'))
exr('half', 1, 'ABGR', V, half=True, level=1 + 1 / 256)
exr('grey', 1, 'Y', V)
exr('oiio', .7152, 'BGR', V, text('Software', 'OpenImageIO 2.5'), text('oiio:ColorSpace', 'Linear'), level=green)
exr('stated', .7152, 'BGR', V, primaries(*rec709), level=green)
exr('p3', .691739, 'BGR', V, primaries(*p3), level=green)
exr('aces', .728166, 'BGR', V, primaries(*aces),
    attribute('acesImageContainerFlag', 'int', struct.pack('<i', 1)), level=green)
exr('radiance', .670115, 'BGR', V, primaries(.64, .33, .29, .6, .15, .06, .3333, .3333), level=green)
exr('zeros', .7152, 'BGR', V, primaries(*8 * [0]), level=green)
exr('stereo', 1, 'BGR', V, text('view', 'left'))
exr('nuke', 1, 'ABGR', V, text('nuke/node_hash', '1f'), text('FRAME', '3'), text('EXPOSURE', 'auto'),
    text('SEED', 'x'))
exr('nits', 1 / 179, 'BGR', V, attribute('whiteLuminance', 'float', struct.pack('<f', 1)))
exr('one_colour', '-', 'BGR', V, primaries(*4 * (.3, .3)))
exr('depth', '-', 'Z', V)
exr('layers', '-', ['View Layer.Combined.B', 'View Layer.Combined.G', 'View Layer.Combined.R'], V)
